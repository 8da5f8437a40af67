//! The chapter's scenes.

mod cornell;
mod files;
mod outdoors;

use common::chapter::{Failure, SceneName, unknown_scene};
use triangles::scene::is_file;

use crate::furnace;
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
    SceneName { name: "FILE.obj", about: "a mesh of your own, with its MTL materials" },
];

/// The scene called `name`, or that of an OBJ file; the furnaces' walls have this `albedo`.
///
/// # Errors
/// A name that is none of [`SCENES`] (exit code 2), or a file that can't be read, is no mesh, or has
/// materials that can't be (exit code 1).
pub fn named(name: &str, albedo: f32) -> Result<Model<Smooth>, Failure> {
    Ok(match name {
        "cornell" => cornell::matte(),
        "cornell-glass" => cornell::with_glass(),
        "dark" => cornell::dark(),
        "furnace" => furnace::cube(albedo),
        "furnace-ball" => furnace::ball(albedo),
        "bunny" => outdoors::bunny()?,
        "empty" => Model { parts: Vec::new(), ..cornell::dark() },
        name if is_file(name) => return files::read(name),
        name => return Err(unknown_scene(name, SCENES)),
    })
}

#[cfg(test)]
mod tests {
    use common::chapter::Failure;

    use super::{SCENES, named};
    use crate::part::Form;
    use crate::stage::Stage;

    #[test]
    fn every_scene_that_is_listed_can_be_built() {
        for scene in SCENES.iter().filter(|scene| scene.name != "FILE.obj") {
            let found = named(scene.name, 0.5).expect(scene.name);
            assert!(found.warnings.is_empty() && Stage::new(&found).is_ok());
        }
    }

    #[test]
    fn the_bunny_stands_on_its_floor() {
        let model = named("bunny", 0.5).expect("it is built in");
        let [bunny, floor] = &model.parts[..] else { panic!("two things") };
        let low = |form: &Form| {
            let Form::Triangles(triangles) = form else { panic!("triangles") };
            triangles.iter().flatten().map(|corner| corner.y).fold(f32::MAX, f32::min)
        };
        assert_eq!(low(&bunny.form), low(&floor.form));
    }

    #[test]
    fn wrong_names_are_wrong_command_lines() {
        for name in ["", "nothing", "cornell "] {
            assert!(matches!(named(name, 0.5), Err(Failure::Usage(_))), "{name}");
        }
        assert!(matches!(named("missing.obj", 0.5), Err(Failure::Work(_))));
    }
}
