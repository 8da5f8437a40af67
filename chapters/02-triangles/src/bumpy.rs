//! A bumpy closed sphere with as many triangles as you like, for work on scaling.
//!
//! Its vertices lie on rings around the y axis, from pole to pole, a ring with more of them the
//! wider it is. Between a ring of m and a ring of n vertices lie m + n triangles, so all in all
//! there are twice as many triangles as ring vertices.

use common::math;
use glam::Vec3;

use crate::mesh::Mesh;
use crate::smooth::vertex_normals;

/// The fewest triangles: two pyramids, base to base.
pub const FEWEST: u32 = 6;
/// The most triangles. They take about 1 GB with all that is kept of them.
pub const MOST: u32 = 10_000_000;

/// The sphere with `triangles` triangles, from [`FEWEST`] to [`MOST`]; with one more if that
/// number is odd.
///
/// No closed mesh has an odd number: each triangle has 3 edges and each edge 2 triangles.
pub fn sphere(triangles: u32) -> Mesh {
    let rings = rings(triangles.clamp(FEWEST, MOST).div_ceil(2));
    let mut mesh = Mesh { positions: vec![place(Vec3::Y)], ..Mesh::default() };
    for (index, &count) in rings.iter().enumerate() {
        let polar = std::f32::consts::PI * (index + 1) as f32 / (rings.len() + 1) as f32;
        mesh.positions.extend((0..count).map(|step| on_ring(polar, step, count)));
    }
    mesh.positions.push(place(-Vec3::Y));
    stitch(&mut mesh, &rings);
    mesh.normals = vertex_normals(&mesh.positions, &mesh.triangles);
    mesh
}

/// How many vertices each ring has, `total` together and at least 3 each, in proportion to the
/// sine of its angle from the pole.
fn rings(total: u32) -> Vec<u32> {
    // Equilateral triangles of side s on the unit sphere: 2 total · s² √3/4 = 4π, rows s √3/2 high.
    let side = (8.0 * std::f32::consts::PI / (3.0_f32.sqrt() * total as f32)).sqrt();
    let rows = (std::f32::consts::PI / (side * 3.0_f32.sqrt() / 2.0)).round() as u32;
    let count = rows.saturating_sub(1).clamp(1, total / 3);
    let sine = |ring: u32| math::sin(std::f32::consts::PI * (ring + 1) as f32 / (count + 1) as f32);
    let whole: f64 = (0..count).map(|ring| f64::from(sine(ring))).sum();
    let shared = f64::from(total - 3 * count);
    let mut so_far = 0.0;
    let mut given = 0;
    let share = |ring| {
        so_far += f64::from(sine(ring));
        let up_to_here = (shared * so_far / whole).round() as u32;
        let here = up_to_here - given;
        given = up_to_here;
        3 + here
    };
    (0..count).map(share).collect()
}

/// Vertex `step` of `count` on the ring at `polar` radians from the pole.
fn on_ring(polar: f32, step: u32, count: u32) -> Vec3 {
    let around = std::f32::consts::TAU * step as f32 / count as f32;
    let radius = math::sin(polar);
    // Counter-clockwise seen from the pole at +y.
    place(Vec3::new(radius * math::sin(around), math::cos(polar), radius * math::cos(around)))
}

/// The surface in a direction: about 1 from the middle, with large and small bumps.
fn place(direction: Vec3) -> Vec3 {
    let wave = |frequency: f32, phase: f32| {
        let angle = frequency * direction + Vec3::new(phase, 2.0 * phase, 3.0 * phase);
        math::sin(angle.x) * math::sin(angle.y) * math::sin(angle.z)
    };
    let bump = 0.2 * wave(3.0, 1.0) + 0.1 * wave(7.0, 2.0) + 0.02 * wave(29.0, 3.0);
    direction * (1.0 + bump)
}

/// The triangles between neighbouring rings, and those at the poles.
fn stitch(mesh: &mut Mesh, rings: &[u32]) {
    let mut above = Ring { first: 0, count: 1 };
    for &count in rings {
        let below = Ring { first: above.first + above.count, count };
        mesh.triangles.extend(Band::new(above, below));
        above = below;
    }
    let last = Ring { first: above.first + above.count, count: 1 };
    mesh.triangles.extend(Band::new(above, last));
}

/// Vertices around the axis, numbered from `first`.
#[derive(Clone, Copy)]
struct Ring {
    first: u32,
    count: u32,
}

impl Ring {
    fn vertex(self, step: u32) -> u32 {
        self.first + step % self.count
    }

    /// How many of the band's triangles have an edge on this ring; a pole has no edges.
    fn edges(self) -> u32 {
        if self.count == 1 { 0 } else { self.count }
    }
}

/// The triangles between two rings, going round like a zipper.
struct Band {
    above: Ring,
    below: Ring,
    passed_above: u32,
    passed_below: u32,
}

impl Band {
    fn new(above: Ring, below: Ring) -> Self {
        Self { above, below, passed_above: 0, passed_below: 0 }
    }
}

impl Iterator for Band {
    type Item = [u32; 3];

    /// Steps ahead on the ring whose next vertex comes first, compared in whole numbers.
    fn next(&mut self) -> Option<[u32; 3]> {
        let (i, j) = (self.passed_above, self.passed_below);
        let (m, n) = (self.above.edges(), self.below.edges());
        if i == m && j == n {
            return None;
        }
        let on_above =
            j == n || (i < m && u64::from(i + 1) * u64::from(n) <= u64::from(j + 1) * u64::from(m));
        let (top, bottom) = (self.above.vertex(i), self.below.vertex(j));
        if on_above {
            self.passed_above += 1;
            Some([top, bottom, self.above.vertex(i + 1)])
        } else {
            self.passed_below += 1;
            Some([top, bottom, self.below.vertex(j + 1)])
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::sphere;
    use crate::area::has_area;
    use crate::closed::edges_without_partner;
    use crate::mesh::Mesh;

    /// Six times the volume; positive when the triangles turn their outside out.
    fn volume(mesh: &Mesh) -> f64 {
        let volume = |index| {
            let [a, b, c] = mesh.corners(index).map(|corner| corner.as_dvec3());
            DVec3::dot(a, b.cross(c))
        };
        (0..mesh.triangles.len()).map(volume).sum()
    }

    #[test]
    fn every_size_is_met_and_closed() {
        for size in (6..400).chain([960, 1001, 12_345, 99_998]) {
            let mesh = sphere(size);
            assert_eq!(mesh.triangles.len() as u32, size + size % 2);
            assert_eq!(mesh.positions.len(), mesh.triangles.len() / 2 + 2, "Euler's formula");
            assert_eq!(edges_without_partner(&mesh.triangles), 0, "{size}");
            assert!((0..mesh.triangles.len()).all(|index| has_area(&mesh.corners(index))));
            assert!(volume(&mesh) > 2.0, "{size}");
            assert!(mesh.normals.iter().all(|normal| (normal.length() - 1.0).abs() < 1e-6));
        }
    }

    #[test]
    fn larger_meshes_come_nearer_to_one_surface() {
        let [coarse, fine, finest] = [2_000, 20_000, 200_000].map(|size| volume(&sphere(size)));
        assert!((fine - finest).abs() < 0.2 * (coarse - finest).abs());
    }
}
