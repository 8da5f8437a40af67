//! The surface at a hit: its point, the triangle's own normal and the smooth one.

use glam::{DVec3, Vec3};
use ray_casting::rounding::{Placed, gamma};

use crate::mesh::Mesh;

// ANCHOR: between
/// The mean of three corner values, with barycentric weights.
///
/// For the corners' places it is the point of the hit. Its error does not grow with the ray's
/// length, as that of `origin + t * direction` does (hard case RC-10 is the sphere's version).
#[inline(always)]
pub fn between([a, b, c]: [Vec3; 3], barycentric: Vec3) -> Vec3 {
    barycentric.x * a + barycentric.y * b + barycentric.z * c
}
// ANCHOR_END: between

// ANCHOR: place
/// The point of a hit, and how far from the triangle it may be.
///
/// A weight is rounded once, its product once, and their sum twice: four roundings of each corner's
/// part. Whoever asks the triangle again from beside the point rounds each corner's distance, the
/// shear and their difference, which moves a corner along an axis by two roundings of its distance
/// along that axis and along the ray's longest; between moved corners the triangle moves no
/// farther than they.
#[inline(always)]
pub fn place(corners: [Vec3; 3], barycentric: Vec3) -> Placed {
    let point = between(corners, barycentric);
    let [a, b, c] = corners;
    let distance = (a - point).abs().max((b - point).abs()).max((c - point).abs());
    let sheared = distance + Vec3::splat(distance.max_element());
    let size = between([a.abs(), b.abs(), c.abs()], barycentric);
    let error = const { gamma(5) } * size + const { gamma(3) } * sheared;
    Placed { point, error }
}
// ANCHOR_END: place

// ANCHOR: geometric
/// The triangle's own normal, of length 1, on the side from which its corners run
/// counter-clockwise; None when it has no area.
///
/// In `f64`, because the cross product of two nearly parallel edges cancels (hard case TR-11) and
/// the squares in its length vanish when they are short (TR-09).
pub fn geometric_normal(corners: &[Vec3; 3]) -> Option<Vec3> {
    area_vector(corners).try_normalize().map(|normal| normal.as_vec3())
}

/// The vector along the normal whose length is twice the triangle's area.
pub fn area_vector(corners: &[Vec3; 3]) -> DVec3 {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    (b - a).cross(c - a)
}
// ANCHOR_END: geometric

// ANCHOR: smooth
/// The mean of the corners' normals, of length 1; the triangle's own where that one vanishes.
pub fn smooth_normal(normals: [Vec3; 3], barycentric: Vec3, geometric: Vec3) -> Vec3 {
    let mean = between(normals, barycentric);
    // Opposite normals leave rounding errors whose direction means nothing.
    if mean.length_squared() > 1e-8 { mean.normalize() } else { geometric }
}
// ANCHOR_END: smooth

// ANCHOR: normal
/// The normal at a point of triangle `index`. With `SMOOTH` false, or when the mesh has no normals,
/// it is the triangle's own.
pub fn normal<const SMOOTH: bool>(mesh: &Mesh, index: usize, barycentric: Vec3) -> Vec3 {
    let geometric = own_normal(mesh, index);
    if SMOOTH { shading_normal(mesh, index, barycentric, geometric) } else { geometric }
}

/// The normal of triangle `index` itself.
pub fn own_normal(mesh: &Mesh, index: usize) -> Vec3 {
    // A triangle that was hit has an area.
    geometric_normal(&mesh.corners(index)).unwrap_or(Vec3::Z)
}

/// The mean of the corners' normals; the triangle's own, `geometric`, when the mesh has none.
pub fn shading_normal(mesh: &Mesh, index: usize, barycentric: Vec3, geometric: Vec3) -> Vec3 {
    if mesh.normals.is_empty() {
        return geometric;
    }
    let normals = mesh.triangles[index].map(|vertex| mesh.normals[vertex as usize]);
    smooth_normal(normals, barycentric, geometric)
}
// ANCHOR_END: normal

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::Vec3;
    use ray_casting::rounding::Placed;

    use super::{area_vector, between, geometric_normal, place, smooth_normal};

    #[test]
    fn the_normal_of_a_lopsided_triangle() {
        // Edges (2, 0, 0) and (0, 3, 4): their cross product is (0, -8, 6).
        let corners = [Vec3::ONE, Vec3::new(3.0, 1.0, 1.0), Vec3::new(1.0, 4.0, 5.0)];
        assert_eq!(geometric_normal(&corners), Some(Vec3::new(0.0, -0.8, 0.6)));
        assert_eq!(geometric_normal(&[Vec3::ONE, Vec3::ONE, Vec3::X]), None);
        assert!(geometric_normal(&corners.map(|it| 1e-38 * it)).is_some());
        assert!(geometric_normal(&corners.map(|it| 1e37 * it)).is_some());
    }

    #[test]
    fn opposite_normals_leave_the_triangles_own() {
        let halves = Vec3::new(0.5, 0.5, 0.0);
        let up = Vec3::new(0.0, 0.6, 0.8);
        assert_eq!(smooth_normal([up, -up, Vec3::X], halves, Vec3::Z), Vec3::Z);
        let mean = smooth_normal([up, up, Vec3::X], halves, Vec3::Z);
        assert!((mean - up).length() < 1e-6);
    }

    #[test]
    fn weights_belong_to_their_corners() {
        let corners = [Vec3::X, 10.0 * Vec3::Y, 100.0 * Vec3::Z];
        assert_eq!(between(corners, Vec3::new(0.5, 0.25, 0.25)), Vec3::new(0.5, 2.5, 25.0));
    }

    /// The distance of the point from the triangle's plane, to `f64`, and from where it is asked
    /// again: hard cases SH-01 and SH-06 of chapter 5 ask.
    #[test]
    fn the_error_covers_the_point() {
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(32, trial);
            let mut decade = |low, high| common::math::pow(10.0, stream.between(low, high));
            let (away, size) = (decade(-4.0, 6.0), decade(-4.0, 4.0));
            let mut vector = || {
                let mut component = || stream.between(-1.0, 1.0);
                Vec3::new(component(), component(), component())
            };
            let center = away * vector();
            let corners = [(); 3].map(|()| center + size * vector());
            let weights = vector().abs();
            let weights = weights / weights.element_sum();
            let Some(normal) = area_vector(&corners).try_normalize() else { continue };
            let Placed { point, error } = place(corners, weights);
            let height = (point.as_dvec3() - corners[0].as_dvec3()).dot(normal).abs();
            assert!(height <= normal.abs().dot(error.as_dvec3()), "{trial}: {height} {error}");
        }
    }
}
