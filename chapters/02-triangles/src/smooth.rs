//! Smooth normals: one for each vertex, from the triangles around it.

use glam::{DVec3, Vec3};

use crate::area::has_area;
use crate::surface::{area_vector, geometric_normal};

// ANCHOR: vertex_normals
/// The vertices' normals, each of length 1: the mean of the normals of the triangles around it,
/// weighted by their areas (Gouraud, "Continuous Shading of Curved Surfaces", 1971).
///
/// A triangle without area has no say. Where nothing is left, because a vertex has no other
/// triangles or because they cancel, it gets the normal of the first of them, or else +y.
pub fn vertex_normals(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut sums = vec![DVec3::ZERO; positions.len()];
    let mut firsts = vec![None; positions.len()];
    for (number, triangle) in triangles.iter().enumerate() {
        let corners = corners_of(positions, triangle);
        if !has_area(&corners) {
            continue;
        }
        // The cross product is as long as twice the area: added as it is, it weighs itself.
        let area_vector = area_vector(&corners);
        for &vertex in triangle {
            sums[vertex as usize] += area_vector;
            firsts[vertex as usize].get_or_insert(number as u32);
        }
    }
    let first = |number: Option<u32>| {
        geometric_normal(&corners_of(positions, &triangles[number? as usize]))
    };
    let unit = |sum: DVec3| sum.try_normalize().map(|normal| normal.as_vec3());
    let pairs = sums.into_iter().zip(firsts);
    pairs.map(|(sum, number)| unit(sum).or_else(|| first(number)).unwrap_or(Vec3::Y)).collect()
}
// ANCHOR_END: vertex_normals

fn corners_of(positions: &[Vec3], triangle: &[u32; 3]) -> [Vec3; 3] {
    triangle.map(|vertex| positions[vertex as usize])
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::vertex_normals;

    #[test]
    fn the_larger_triangle_weighs_more() {
        // Areas 1 (normal +z) and 3 (normal +x) meet at the first two vertices.
        let positions = [Vec3::ZERO, 2.0 * Vec3::Y, -Vec3::X, 3.0 * Vec3::NEG_Z];
        let normals = vertex_normals(&positions, &[[0, 1, 2], [0, 3, 1]]);
        let expected = Vec3::new(3.0, 0.0, 1.0).normalize();
        assert!((normals[0] - expected).length() < 1e-6, "{normals:?}");
        assert_eq!((normals[2], normals[3]), (Vec3::Z, Vec3::X));
    }

    #[test]
    fn what_has_no_normal_gets_one_of_length_one() {
        let positions = [Vec3::ZERO, 2.0 * Vec3::X, 3.0 * Vec3::Y, Vec3::ONE];
        // The same face from both sides, and a vertex that has only a face without area.
        let normals = vertex_normals(&positions, &[[0, 1, 2], [0, 2, 1], [3, 3, 0]]);
        assert_eq!(normals, [Vec3::Z, Vec3::Z, Vec3::Z, Vec3::Y]);
    }

    #[test]
    fn size_makes_no_difference() {
        let positions = [Vec3::ZERO, 2.0 * Vec3::X, 3.0 * Vec3::Y, Vec3::new(1.0, 1.0, 4.0)];
        let triangles = [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]];
        let plain = vertex_normals(&positions, &triangles);
        for power in [-100, -60, 60, 100] {
            let factor = f32::from_bits(((127 + power) as u32) << 23);
            assert_eq!(vertex_normals(&positions.map(|it| factor * it), &triangles), plain);
        }
    }
}
