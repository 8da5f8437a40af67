//! One good answer to each exercise.

use std::f32::consts::{PI, TAU};

use glam::{Vec2, Vec3};

use crate::cases::{Facet, Pair, Turn};

pub(super) fn density(&Facet { alpha, normal }: &Facet) -> f32 {
    let square = alpha * alpha;
    let spread = normal.x * normal.x + normal.y * normal.y + square * normal.z * normal.z;
    square / (PI * spread * spread)
}

/// √(z² + α² (x² + y²)).
pub(super) fn stretch(alpha: f32, direction: Vec3) -> f32 {
    Vec3::new(alpha * direction.x, alpha * direction.y, direction.z).length()
}

pub(super) fn seen_and_lit(&Pair { alpha, outgoing, incoming }: &Pair) -> f32 {
    let (z, other) = (outgoing.z, incoming.z);
    2.0 * z * other / (stretch(alpha, outgoing) * other + stretch(alpha, incoming) * z)
}

pub(super) fn visible_normal(alpha: f32, outgoing: Vec3, u: Vec2) -> Vec3 {
    let scale = Vec3::new(alpha, alpha, 1.0);
    let view = (outgoing * scale).normalize();
    let below = u.x * (1.0 + view.z);
    ((on_ball(below, u.y) + view) * scale).normalize()
}

/// The point of the unit ball at the height 1 - below.
pub(super) fn on_ball(below: f32, turn: f32) -> Vec3 {
    let radius = (below * (2.0 - below)).max(0.0).sqrt();
    let (x, y) = (common::math::cos(TAU * turn), common::math::sin(TAU * turn));
    Vec3::new(radius * x, radius * y, 1.0 - below)
}

/// Uniform directions have the density 1 / 2π, and z z' G₂ D / (4 z z') is z' / 2π (z + z').
pub(super) fn sent_back(cosine: f32, u: Vec2) -> f32 {
    u.x / (cosine + u.x)
}

pub(super) fn reflected_density(&Turn { outgoing, normal, density }: &Turn) -> f32 {
    density / (4.0 * outgoing.dot(normal))
}
