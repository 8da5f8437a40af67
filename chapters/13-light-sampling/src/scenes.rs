//! The chapter's scenes: chapter 12's, and other lamps in the same box.

use common::chapter::{Failure, SceneName, unknown_scene};
use common::film::Color;
use glam::Vec3;
use path_tracing::model::Model;
use path_tracing::part::{Form, Part};
use path_tracing::scenes::{self, SHORT, TALL, WHITE, block, box_view, enclosure};
use path_tracing::smooth::Smooth;

/// The scenes this chapter adds.
pub const OWN: [SceneName; 2] = [
    SceneName { name: "sphere-light", about: "the box lit by a ball that hangs in it" },
    SceneName { name: "many-lights", about: "the box lit by 64 small lamps of unequal power" },
];

/// The scenes this chapter has.
pub const SCENES: &[SceneName] = &{
    let [sphere, many] = OWN;
    let [cornell, glass, bunny, furnace, ball, dark, empty] = {
        let mut all = [sphere; 7];
        let mut index = 0;
        while index < 7 {
            all[index] = scenes::SCENES[index];
            index += 1;
        }
        all
    };
    [cornell, glass, sphere, many, bunny, furnace, ball, dark, empty]
};

/// The scene called `name`; the furnaces' walls have this `albedo`.
///
/// # Errors
/// As for chapter 12's.
pub fn named(name: &str, albedo: f32) -> Result<Model<Smooth>, Failure> {
    match name {
        "sphere-light" => Ok(lit_by(vec![ball()])),
        "many-lights" => Ok(lit_by(squares())),
        name if scenes::SCENES.iter().any(|scene| scene.name == name) => {
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
    Model { parts, sky: Color::ZERO, view: box_view() }
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
