//! The chapter's scenes: Veach's plates, and those of chapters 12, 13 and 15.

use common::chapter::{Failure, SceneName, unknown_scene};
use light_sampling::scenes as lamps;
use microfacets::finish::Finish;
use microfacets::scenes as metals;
use path_tracing::model::Model;

use crate::plates::Plates;

/// The scene this chapter adds.
pub const OWN: [SceneName; 1] =
    [SceneName { name: "plates", about: "four plates, from rough to polished, under four lamps" }];

/// The scenes this chapter has.
pub const SCENES: &[SceneName] = &{
    let mut all = [OWN[0]; OWN.len() + metals::OWN.len() + lamps::SCENES.len()];
    let mut index = 1;
    while index < all.len() {
        let rest = index - OWN.len();
        let metal = rest < metals::OWN.len();
        all[index] =
            if metal { metals::OWN[rest] } else { lamps::SCENES[rest - metals::OWN.len()] };
        index += 1;
    }
    all
};

/// The scene called `name`, or that of a file; the furnaces' walls have this `albedo`.
///
/// # Errors
/// As for chapter 13's.
pub fn named(name: &str, albedo: f32) -> Result<Model<Finish>, Failure> {
    let is_one_of = |scenes: &[SceneName]| scenes.iter().any(|scene| scene.name == name);
    match name {
        "plates" => Ok(Plates::VEACH.model()),
        name if is_one_of(&metals::OWN) => metals::named(name, albedo),
        name if is_one_of(lamps::SCENES) || triangles::scene::is_file(name) => {
            Ok(lamps::named(name, albedo)?.map(Finish::from))
        }
        name => Err(unknown_scene(name, SCENES)),
    }
}

#[cfg(test)]
mod tests {
    use path_tracing::stage::Stage;

    use super::{SCENES, named};

    #[test]
    fn every_scene_that_is_listed_can_be_built() {
        for scene in SCENES.iter().filter(|scene| scene.name != "FILE.obj") {
            let model =
                named(scene.name, 0.5).unwrap_or_else(|error| panic!("{}: {error:?}", scene.name));
            assert!(Stage::new(&model).is_ok(), "{}", scene.name);
        }
        assert!(named("no-such-scene", 0.5).is_err());
    }

    #[test]
    fn no_scene_has_two_entries() {
        for (index, scene) in SCENES.iter().enumerate() {
            assert!(SCENES[..index].iter().all(|other| other.name != scene.name), "{}", scene.name);
        }
    }
}
