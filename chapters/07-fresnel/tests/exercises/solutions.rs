//! One good answer to each exercise.

use common::film::Color;
use glam::Vec3;

use crate::cases::{Bend, Seen, Surface};

pub(super) fn far_cosine(&Surface { near, far, cosine }: &Surface) -> Option<f32> {
    let ratio = near / far;
    let square = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    (square >= 0.0).then(|| square.sqrt())
}

pub(super) fn refract(&Bend { incoming, outward, index }: &Bend) -> Option<Vec3> {
    let entering = incoming.dot(outward) < 0.0;
    let (normal, ratio) = if entering { (outward, 1.0 / index) } else { (-outward, index) };
    let cosine = -incoming.dot(normal);
    let square = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    (square >= 0.0).then(|| ratio * incoming + (ratio * cosine - square.sqrt()) * normal)
}

pub(super) fn reflectance(surface: &Surface) -> f32 {
    let &Surface { near, far, cosine } = surface;
    let Some(beyond) = far_cosine(surface) else { return 1.0 };
    let perpendicular = (near * cosine - far * beyond) / (near * cosine + far * beyond);
    let parallel = (far * cosine - near * beyond) / (far * cosine + near * beyond);
    (perpendicular * perpendicular + parallel * parallel) / 2.0
}

pub(super) fn schlick(surface: &Surface) -> f32 {
    let Surface { near, far, cosine } = surface;
    let Some(beyond) = far_cosine(surface) else { return 1.0 };
    let straight = ((near - far) / (near + far)) * ((near - far) / (near + far));
    let x = 1.0 - cosine.min(beyond);
    straight + (1.0 - straight) * x * x * x * x * x
}

pub(super) fn one_of_two(part: f32, mirrored: f32, refracted: f32, chance: f32) -> f32 {
    if chance < part { mirrored } else { refracted }
}

pub(super) fn seen(&Seen { surface, mirrored, refracted }: &Seen) -> Color {
    let reflected = reflectance(&surface);
    let ratio = surface.near / surface.far;
    reflected * mirrored + (1.0 - reflected) * ratio * ratio * refracted
}
