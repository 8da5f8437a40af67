//! The chapter's scenes.

mod cornell;
mod furnace;
mod outdoors;

use common::chapter::{Failure, SceneName, unknown_scene};

use crate::model::Model;
use crate::smooth::Smooth;

pub use cornell::{
    Block, CEILING_LIGHT, GREEN, RED, SHORT, TALL, WHITE, block, box_view, enclosure, light,
};

/// The scenes this chapter has.
pub const SCENES: &[SceneName] = &[
    SceneName { name: "cornell", about: "the report's figure 5.6: the Cornell box, all matte" },
    SceneName { name: "cornell-glass", about: "the same with a mirror and a ball of glass" },
    SceneName { name: "bunny", about: "the bunny under a bright sky" },
    SceneName { name: "furnace", about: "inside a box that glows: every pixel must be the same" },
    SceneName { name: "furnace-ball", about: "the same inside a ball" },
    SceneName { name: "dark", about: "the Cornell box with its light off" },
    SceneName { name: "empty", about: "nothing at all" },
];

/// The scene called `name`; the furnaces' walls have this `albedo`.
///
/// # Errors
/// A name that is none of [`SCENES`] (exit code 2), or a mesh that can't be read (exit code 1).
pub fn named(name: &str, albedo: f32) -> Result<Model<Smooth>, Failure> {
    match name {
        "cornell" => Ok(cornell::matte()),
        "cornell-glass" => Ok(cornell::with_glass()),
        "dark" => Ok(cornell::dark()),
        "furnace" => Ok(furnace::cube(albedo)),
        "furnace-ball" => Ok(furnace::ball(albedo)),
        "bunny" => outdoors::bunny(),
        "empty" => Ok(Model { parts: Vec::new(), ..cornell::dark() }),
        name => Err(unknown_scene(name, SCENES)),
    }
}
