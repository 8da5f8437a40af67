//! Rows of balls, each smoother than the one before.

use common::film::Color;
use fresnel::conductor::Metal;
use fresnel::index::Index;
use glam::Vec3;
use path_tracing::model::Model;
use path_tracing::part::{Form, Part};
use path_tracing::smooth::Smooth;
use ray_casting::camera::View;

use crate::conductor::PERFECT;
use crate::finish::Finish;
use crate::rough::Rough;

/// From left to right.
const FALLING: [f32; 6] = [0.8, 0.5, 0.3, 0.15, 0.05, 0.0];

/// Three rows on a checkered floor: gold, copper and glass.
pub(super) fn polish() -> Model<Finish> {
    let mut parts = floor();
    parts.extend(row(-3.0, 1.0, |alpha| Rough::metal(Metal::GOLD, alpha)));
    parts.extend(row(-0.6, 0.8, |alpha| Rough::metal(Metal::COPPER, alpha)));
    parts.extend(row(1.4, 0.6, |alpha| Rough::glass(Index::GLASS, alpha)));
    let eye = Vec3::new(0.0, 4.6, 9.0);
    let view = View { eye, target: Vec3::new(0.0, 0.4, -1.2), up: Vec3::Y, vertical_fov: 39.0 };
    Model::new(parts, Color::new(0.9, 0.87, 0.82), view)
}

/// Balls of this radius at the depth `z`, of the material that each roughness gives.
fn row(z: f32, radius: f32, material: fn(f32) -> Rough) -> impl Iterator<Item = Part<Finish>> {
    FALLING.iter().enumerate().map(move |(index, &alpha)| {
        let x = 2.15 * radius * (index as f32 - 2.5);
        let ball = Form::ball(Vec3::new(x, radius, z), radius);
        Part::dark(ball, material(alpha).into())
    })
}

/// Squares of two greys.
fn floor() -> Vec<Part<Finish>> {
    let mut squares = [Vec::new(), Vec::new()];
    for (x, z) in (-12..12).flat_map(|x| (-14..10).map(move |z| (x, z))) {
        let at = |dx: i32, dz: i32| Vec3::new((x + dx) as f32, 0.0, (z + dz) as f32);
        let [a, b, c, d] = [at(0, 0), at(0, 1), at(1, 1), at(1, 0)];
        let of_color: &mut Vec<_> = &mut squares[((x + z) & 1) as usize];
        of_color.extend([[a, b, c], [a, c, d]]);
    }
    let [dark, pale] = squares.map(Form::Triangles);
    let [dark_grey, pale_grey] = [Smooth::matte(0.08, 0.09, 0.12), Smooth::matte(0.6, 0.55, 0.5)];
    vec![Part::dark(dark, dark_grey.into()), Part::dark(pale, pale_grey.into())]
}

/// Balls whose facets reflect all light, where the same radiance comes from everywhere, in two rows of
/// three. What is darker has lost light.
pub(super) fn lost_light() -> Model<Finish> {
    let ball = |index: usize| {
        let alpha = 1.0 - index as f32 / 5.0;
        let (column, row) = (index % 3, index / 3);
        let center = Vec3::new(2.6 * (column as f32 - 1.0), 1.3 - 2.6 * row as f32, 0.0);
        Part::dark(Form::ball(center, 1.0), Rough::metal(PERFECT, alpha).into())
    };
    // From so far that all of them are seen from the front.
    let eye = Vec3::new(0.0, 0.0, 80.0);
    let view = View { eye, target: Vec3::ZERO, up: Vec3::Y, vertical_fov: 3.6 };
    Model::new((0..6).map(ball).collect(), Color::ONE, view)
}
