//! The chapter's scenes: its own, and those of chapters 12 and 13.

mod balls;
mod cornell;

use common::chapter::{Failure, SceneName, unknown_scene};
use light_sampling::scenes;
use path_tracing::model::Model;
use triangles::scene::is_file;

use crate::finish::Finish;

/// The scenes this chapter adds.
pub const OWN: [SceneName; 3] = [
    SceneName { name: "polish", about: "balls of gold, copper and glass, from rough to polished" },
    SceneName { name: "rough-metals", about: "the Cornell box with rough gold and rough copper" },
    SceneName { name: "lost-light", about: "balls that reflect everything, under a white sky" },
];

/// The scenes this chapter has.
pub const SCENES: &[SceneName] = &{
    let mut all = [OWN[0]; OWN.len() + scenes::SCENES.len()];
    let mut index = 1;
    while index < all.len() {
        let own = index < OWN.len();
        all[index] = if own { OWN[index] } else { scenes::SCENES[index - OWN.len()] };
        index += 1;
    }
    all
};

/// The scene called `name`, or that of a file; the furnaces' walls have this `albedo`.
///
/// # Errors
/// As for chapter 13's.
pub fn named(name: &str, albedo: f32) -> Result<Model<Finish>, Failure> {
    match name {
        "polish" => Ok(balls::polish()),
        "rough-metals" => Ok(cornell::rough_metals()),
        "lost-light" => Ok(balls::lost_light()),
        name if is_file(name) || scenes::SCENES.iter().any(|scene| scene.name == name) => {
            Ok(scenes::named(name, albedo)?.map(Finish::from))
        }
        name => Err(unknown_scene(name, SCENES)),
    }
}
