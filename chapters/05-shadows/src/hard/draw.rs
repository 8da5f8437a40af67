//! What the hard cases draw their inputs from.

use common::sampler::Stream;
use glam::{DVec3, Vec3};
use triangles::mesh::Mesh;

/// A vector in the cube from -`side` to `side`.
pub(crate) fn in_cube(stream: &mut Stream, side: f32) -> Vec3 {
    let x = stream.between(-side, side);
    let y = stream.between(-side, side);
    let z = stream.between(-side, side);
    Vec3::new(x, y, z)
}

/// A direction of length 1, to `f64`; not quite uniform, which no case needs.
pub(crate) fn direction(stream: &mut Stream) -> DVec3 {
    let vector = in_cube(stream, 1.0).as_dvec3();
    if vector.length() > 0.1 { vector.normalize() } else { direction(stream) }
}

/// A direction at right angles to another, both of length 1.
pub(super) fn across(stream: &mut Stream, axis: DVec3) -> DVec3 {
    let other = direction(stream);
    let across = other - other.dot(axis) * axis;
    if across.length() > 0.1 { across.normalize() } else { self::across(stream, axis) }
}

/// 10 to a power between `low` and `high`.
pub(super) fn decade(stream: &mut Stream, low: f32, high: f32) -> f32 {
    common::math::pow(10.0, stream.between(low, high))
}

/// Three weights above 0 that sum to 1.
pub(super) fn weights(stream: &mut Stream) -> Vec3 {
    let drawn = Vec3::from([(); 3].map(|()| stream.between(0.01, 1.0)));
    drawn / drawn.element_sum()
}

/// A direction that leaves a surface with this normal, to one side or the other, at an angle whose
/// cosine is from 10⁻⁴ to 1.
pub(super) fn leaving(stream: &mut Stream, normal: Vec3) -> Vec3 {
    let normal = normal.as_dvec3();
    let cosine = f64::from(decade(stream, -4.0, 0.0));
    let side = if stream.bits().is_multiple_of(2) { normal } else { -normal };
    (cosine * side + (1.0 - cosine * cosine).sqrt() * across(stream, normal)).as_vec3()
}

/// The distance from the largest coordinate to the next `f32`.
pub(super) fn ulp(size: f32) -> f64 {
    f64::from(size.next_up()) - f64::from(size)
}

/// A mesh of one triangle.
pub(super) fn triangle(corners: [Vec3; 3]) -> Mesh {
    Mesh { positions: corners.to_vec(), triangles: vec![[0, 1, 2]], ..Mesh::default() }
}

/// 2 to the power `exponent`, from -126 to 127.
pub(super) fn power_of_two(exponent: i32) -> f32 {
    f32::from_bits(((127 + exponent) as u32) << 23)
}

/// A whole number from `low` to `high`.
pub(super) fn whole(stream: &mut Stream, low: i32, high: i32) -> i32 {
    low + (stream.bits() % (high - low + 1) as u32) as i32
}
