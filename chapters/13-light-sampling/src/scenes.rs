//! The chapter's scenes: chapter 12's, and other lamps in the same box.

use common::chapter::{Failure, SceneName, unknown_scene};
use common::film::Color;
use glam::Vec3;
use path_tracing::model::Model;
use path_tracing::part::{Form, Part};
use path_tracing::scenes::{self, SHORT, TALL, WHITE, block, box_view, enclosure};
use path_tracing::smooth::Smooth;
use triangles::scene::is_file;

/// The scenes this chapter adds.
pub const OWN: [SceneName; 2] = [
    SceneName { name: "sphere-light", about: "the box lit by a ball that hangs in it" },
    SceneName { name: "many-lights", about: "the box lit by 64 small lamps of unequal power" },
];

/// The scenes this chapter has: its own, and all of chapter 12's.
pub const SCENES: &[SceneName] = &[
    SceneName { name: "cornell", about: "the report's figure 5.6: the Cornell box, all matte" },
    SceneName { name: "cornell-glass", about: "the same with a mirror and a ball of glass" },
    OWN[0],
    OWN[1],
    SceneName { name: "bunny", about: "the bunny under a bright sky" },
    SceneName { name: "furnace", about: "inside a box that glows: every pixel must be the same" },
    SceneName { name: "furnace-ball", about: "the same inside a ball" },
    SceneName { name: "dark", about: "the Cornell box with its light off" },
    SceneName { name: "empty", about: "nothing at all" },
    SceneName { name: "FILE.obj", about: "a mesh of your own, with its MTL materials" },
];

/// The scene called `name`, or that of a file; the furnaces' walls have this `albedo`.
///
/// # Errors
/// As for chapter 12's.
pub fn named(name: &str, albedo: f32) -> Result<Model<Smooth>, Failure> {
    match name {
        "sphere-light" => Ok(lit_by(vec![ball()])),
        "many-lights" => Ok(lit_by(squares())),
        name if is_file(name) || SCENES.iter().any(|scene| scene.name == name) => {
            scenes::named(name, albedo)
        }
        name => Err(unknown_scene(name, SCENES)),
    }
}

/// The box with both blocks and these lamps.
fn lit_by(lamps: Vec<Part<Smooth>>) -> Model<Smooth> {
    let mut parts = enclosure();
    parts.extend([block(&SHORT, WHITE), block(&TALL, WHITE)]);
    parts.extend(lamps);
    Model::new(parts, Color::ZERO, box_view())
}

fn ball() -> Part<Smooth> {
    let form = Form::ball(Vec3::new(278.0, 420.0, 280.0), 60.0);
    Part::glowing(form, Smooth::BLACK, Color::splat(10.0))
}

/// Sixty-four squares below the ceiling, one to seven times as bright, in three tints.
fn squares() -> Vec<Part<Smooth>> {
    const TINTS: [Color; 3] =
        [Color::new(1.0, 0.9, 0.7), Color::new(0.8, 0.9, 1.0), Color::new(1.0, 1.0, 1.0)];
    let square = |i: usize, j: usize| {
        let (x, z) = (33.0 + 70.0 * i as f32, 35.0 + 70.0 * j as f32);
        let corners = [[6.0, -6.0], [6.0, 6.0], [-6.0, 6.0], [-6.0, -6.0]];
        let form = Form::quad(corners.map(|[dx, dz]| Vec3::new(x + dx, 548.7, z + dz)));
        let strength = 40.0 * (1 + (3 * i + 5 * j) % 7) as f32;
        Part::glowing(form, Smooth::BLACK, strength * TINTS[(i + j) % 3])
    };
    (0..64).map(|index| square(index / 8, index % 8)).collect()
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use glam::Vec3;
    use path_tracing::part::Form;
    use path_tracing::scenes;
    use path_tracing::stage::Stage;
    use triangles::surface::geometric_normal;

    use super::{OWN, SCENES, named, squares};

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
    fn chapter_twelve_s_scenes_are_here_in_its_words() {
        for scene in scenes::SCENES {
            let here = SCENES.iter().find(|own| own.name == scene.name);
            assert!(here.is_some(), "{}", scene.name);
        }
        assert!(OWN.iter().all(|own| SCENES.iter().any(|scene| scene.name == own.name)));
    }

    #[test]
    fn sixty_four_lamps_shine_down_one_to_seven_times_as_bright() {
        let lamps = squares();
        assert_eq!(lamps.len(), 64);
        let brightest = |lamp: &path_tracing::part::Part<_>| lamp.emission.radiance.max_element();
        let strengths: Vec<f32> = lamps.iter().map(brightest).collect();
        assert!(strengths.iter().all(|strength| (40.0..=280.0).contains(strength)));
        assert_eq!(lamps[0].emission.radiance, Color::new(40.0, 36.0, 28.0));
        for lamp in &lamps {
            let Form::Triangles(triangles) = &lamp.form else { panic!("a square") };
            assert!(triangles.iter().all(|it| geometric_normal(it) == Some(Vec3::NEG_Y)));
        }
    }
}
