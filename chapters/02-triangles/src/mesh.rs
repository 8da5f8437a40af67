//! A mesh: triangles that share their vertices.

use common::tally::{Counts, Tally};
use glam::{Vec2, Vec3};
use ray_casting::ray::Ray;
use ray_casting::rounding::Placed;
use ray_casting::shape::{Hit, Shape};

use crate::brute::{Found, TRIANGLE_TESTS, nearest};
use crate::intersect::TriangleTest;
use crate::surface;
use crate::watertight::ShearedRay;

// ANCHOR: mesh
/// Vertices, and the triangles between them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The vertices' places.
    pub positions: Vec<Vec3>,
    /// The vertices' normals, of length 1; empty when the mesh is flat-shaded.
    pub normals: Vec<Vec3>,
    /// The vertices' texture coordinates; empty when there are none.
    pub uvs: Vec<Vec2>,
    /// Three vertices a triangle, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}
// ANCHOR_END: mesh

/// The smallest box around some points, its sides along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// The corner with the least coordinates.
    pub low: Vec3,
    /// The corner with the greatest.
    pub high: Vec3,
}

impl Mesh {
    /// The corners of triangle `index`.
    #[inline]
    pub fn corners(&self, index: usize) -> [Vec3; 3] {
        let [a, b, c] = self.triangles[index];
        [self.positions[a as usize], self.positions[b as usize], self.positions[c as usize]]
    }

    /// The corners of all triangles, in their order: more memory than the indices, but no jumping
    /// about in it.
    pub fn all_corners(&self) -> Vec<[Vec3; 3]> {
        (0..self.triangles.len()).map(|index| self.corners(index)).collect()
    }

    /// Where the triangles' corners lie. None for a mesh without triangles.
    pub fn extent(&self) -> Option<Extent> {
        let mut corners = self.triangles.iter().flatten().map(|&at| self.positions[at as usize]);
        let first = corners.next()?;
        Some(corners.fold(Extent { low: first, high: first }, |extent, corner| Extent {
            low: extent.low.min(corner),
            high: extent.high.max(corner),
        }))
    }

    /// The whole answer to a hit: the point and normal are interpolated between the corners.
    pub fn complete(&self, found: Found) -> Hit {
        let Found { hit, index } = found;
        let (corners, weights) = (self.corners(index), hit.barycentric);
        let geometric = surface::own_normal(self, index);
        let Placed { point, error } = surface::place(corners, weights);
        Hit {
            t: hit.t,
            point,
            error,
            geometric,
            normal: surface::shading_normal(self, index, weights, geometric),
            uv: self.uv(index, weights),
        }
    }

    /// The first triangle in the list, not along the ray, that is hit at `0 < t < t_max`.
    fn first_hit(&self, ray: &Ray, t_max: f32) -> Option<usize> {
        let ray = ShearedRay::prepare(ray)?;
        (0..self.triangles.len()).find(|&index| ray.hit(&self.corners(index), t_max).is_some())
    }

    /// The texture coordinates at a point of triangle `index`; without any, the weights of the
    /// second and third corner.
    fn uv(&self, index: usize, barycentric: Vec3) -> Vec2 {
        if self.uvs.is_empty() {
            return Vec2::new(barycentric.y, barycentric.z);
        }
        let [a, b, c] = self.triangles[index].map(|vertex| self.uvs[vertex as usize]);
        barycentric.x * a + barycentric.y * b + barycentric.z * c
    }
}

impl Shape for Mesh {
    /// The first hit among all triangles, each of which is asked.
    fn hit(&self, ray: &Ray, t_max: f32) -> Option<Hit> {
        let corners = (0..self.triangles.len()).map(|index| self.corners(index));
        nearest::<ShearedRay>(corners, ray, t_max).map(|found| self.complete(found))
    }

    fn hit_counted(&self, ray: &Ray, t_max: f32, counts: &mut Counts) -> Option<Hit> {
        counts.count(TRIANGLE_TESTS, self.triangles.len() as u64);
        self.hit(ray, t_max)
    }

    /// Whether any triangle is hit; those after it are not asked.
    fn is_hit(&self, ray: &Ray, t_max: f32) -> bool {
        self.first_hit(ray, t_max).is_some()
    }

    fn is_hit_counted(&self, ray: &Ray, t_max: f32, counts: &mut Counts) -> bool {
        let first = self.first_hit(ray, t_max);
        let asked = first.map_or(self.triangles.len(), |index| index + 1);
        counts.count(TRIANGLE_TESTS, asked as u64);
        first.is_some()
    }
}

#[cfg(test)]
mod tests {
    use common::tally::Counts;
    use glam::{Vec2, Vec3};
    use ray_casting::ray::Ray;
    use ray_casting::shape::Shape;

    use super::{Extent, Mesh};
    use crate::brute::TRIANGLE_TESTS;

    /// A slanted triangle over a large flat one.
    fn roof() -> Mesh {
        let positions = [(-4, -6, 0), (8, -6, 0), (0, 12, 0), (-1, -2, 1), (2, -2, 1), (0, 4, 3)];
        let positions = positions.map(|(x, y, z)| Vec3::new(x as f32, y as f32, z as f32));
        let triangles = vec![[0, 1, 2], [3, 4, 5]];
        Mesh { positions: positions.to_vec(), triangles, ..Mesh::default() }
    }

    #[test]
    fn the_nearest_triangle_is_found_and_all_are_counted() {
        let mut counts = Counts::default();
        let ray = Ray { origin: Vec3::new(0.5, 0.0, 9.0), direction: Vec3::NEG_Z };
        let hit = roof().hit_counted(&ray, f32::INFINITY, &mut counts).expect("the roof is hit");
        // A third of the way up the slope: z is 1 + 2/3.
        assert!((hit.point - Vec3::new(0.5, 0.0, 1.0 + 2.0 / 3.0)).length() < 1e-6);
        assert!((hit.normal - Vec3::new(0.0, -1.0, 3.0).normalize()).length() < 1e-6);
        assert_eq!(counts.of(TRIANGLE_TESTS), 2);
        assert!(roof().hit(&ray, hit.t).is_none());
    }

    #[test]
    fn texture_coordinates_are_interpolated() {
        let mut mesh = roof();
        mesh.uvs =
            [(0.0, 0.0), (1.0, 0.0), (0.5, 1.0)].repeat(2).into_iter().map(Vec2::from).collect();
        let ray = Ray { origin: Vec3::new(0.5, 0.0, 9.0), direction: Vec3::NEG_Z };
        let hit = mesh.hit(&ray, f32::INFINITY).expect("the roof is hit");
        assert!((hit.uv.y - 1.0 / 3.0).abs() < 1e-6, "{hit:?}");
    }

    #[test]
    fn the_extent_is_that_of_the_triangles() {
        let mut mesh = roof();
        mesh.positions.push(Vec3::splat(100.0));
        let expected = Extent { low: Vec3::new(-4.0, -6.0, 0.0), high: Vec3::new(8.0, 12.0, 3.0) };
        assert_eq!(mesh.extent(), Some(expected));
        assert_eq!(Mesh::default().extent(), None);
    }
}
