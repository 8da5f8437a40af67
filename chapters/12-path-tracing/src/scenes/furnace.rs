//! Closed rooms whose walls all glow: what is seen of them is known exactly.
//!
//! Each wall emits the radiance 1 and reflects a part a of what comes. What comes is what the other
//! walls send, so L = 1 + a L: the radiance is 1 / (1 - a) everywhere and in every direction.

use common::film::Color;
use glam::{Vec3, Vec3Swizzles};
use ray_casting::camera::View;

use crate::lambert::Lambert;
use crate::model::Model;
use crate::part::{Emission, Form, Part};
use crate::smooth::Smooth;

/// A cube from -1 to 1.
pub(super) fn cube(albedo: f32) -> Model<Smooth> {
    let mut triangles = Vec::new();
    let mut wall = |[a, b, c, d]: [Vec3; 4]| triangles.extend([[a, b, c], [a, c, d]]);
    for side in [-1.0, 1.0] {
        for turn in [|v: Vec3| v, |v: Vec3| v.yzx(), |v: Vec3| v.zxy()] {
            let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
            wall(corners.map(|[x, y]| turn(Vec3::new(x, y, side))));
        }
    }
    furnace(Form::Triangles(triangles), albedo)
}

/// A ball of radius 1.
pub(super) fn ball(albedo: f32) -> Model<Smooth> {
    furnace(Form::ball(Vec3::ZERO, 1.0), albedo)
}

fn furnace(form: Form, albedo: f32) -> Model<Smooth> {
    let material = Smooth::Lambert(Lambert { reflectance: Color::splat(albedo) });
    let emission = Emission { radiance: Color::ONE, both_sides: true };
    // Off the middle, so that no two ways to a wall are alike.
    let eye = Vec3::new(0.1, -0.2, 0.3);
    let view = View { eye, target: eye - Vec3::Z, up: Vec3::Y, vertical_fov: 60.0 };
    Model { parts: vec![Part { form, material, emission }], sky: Color::ZERO, view }
}
