//! Polygons to triangles.

use earcut::Earcut;
use glam::{DVec2, DVec3, Vec3};

/// Splits polygons into triangles and keeps its working memory from one to the next.
///
/// Convex quads are split along a diagonal. The rest, concave polygons included, are laid flat on
/// the coordinate plane they face most and handed to the `earcut` crate.
pub(super) struct Splitter {
    earcut: Earcut<f64>,
    ring: Vec<u32>,
    flat: Vec<[f64; 2]>,
    triangles: Vec<u32>,
}

impl Splitter {
    /// A splitter with no memory yet.
    pub(super) fn new() -> Self {
        Self { earcut: Earcut::new(), ring: vec![], flat: vec![], triangles: vec![] }
    }

    /// The triangles of the polygon with these corners, in the polygon's winding, each as three
    /// indices into `corners`. None has an area of exactly zero, so a degenerate polygon has none.
    pub(super) fn split(&mut self, corners: &[Vec3]) -> Split<'_> {
        self.gather_ring(corners);
        self.triangles.clear();
        match *self.ring {
            [] | [_] | [_, _] => {}
            [a, b, c] => self.triangles.extend([a, b, c]),
            _ => self.cut(corners),
        }

        // A triangle without area has no normal and no ray can hit it (HARD CASE TR-14).
        let wanted = self.ring.len().saturating_sub(2);
        let mut kept = 0;
        for at in (0..self.triangles.len()).step_by(3) {
            let corner = |k: usize| corners[self.triangles[at + k] as usize];
            if has_area(corner(0), corner(1), corner(2)) {
                self.triangles.copy_within(at..at + 3, kept);
                kept += 3;
            }
        }
        self.triangles.truncate(kept);
        Split { triangles: self.triangles.as_chunks().0, complete: kept == 3 * wanted }
    }

    /// The corners without those that repeat the corner before them: `f 1 2 3 3` is a triangle.
    fn gather_ring(&mut self, corners: &[Vec3]) {
        self.ring.clear();
        for (at, corner) in (0..).zip(corners) {
            if self.ring.last().is_none_or(|&last| corners[last as usize] != *corner) {
                self.ring.push(at);
            }
        }
        while self.ring.len() > 1 && corners[self.ring[0] as usize] == self.last(corners) {
            self.ring.pop();
        }
    }

    fn last(&self, corners: &[Vec3]) -> Vec3 {
        corners[self.ring[self.ring.len() - 1] as usize]
    }

    /// Triangulates a ring of four or more corners.
    fn cut(&mut self, corners: &[Vec3]) {
        let normal = newell(self.ring.iter().map(|&at| corners[at as usize].as_dvec3()));
        self.flat.clear();
        self.flat.extend(self.ring.iter().map(|&at| flatten(corners[at as usize], normal)));
        if is_convex_quad(&self.flat) {
            let [a, b, c, d] = [0, 1, 2, 3].map(|k: usize| self.ring[k]);
            self.triangles.extend([a, b, c, a, c, d]);
            return;
        }

        // `earcut` winds all its triangles one way. Ours go round as the polygon does.
        self.earcut.earcut_slice::<u32>(&self.flat, &[], &mut self.triangles);
        for triangle in self.triangles.as_chunks_mut::<3>().0 {
            let [a, b, c] = triangle.map(|at| self.flat[at as usize]);
            if turn(a, b, c) < 0.0 {
                triangle.swap(1, 2);
            }
            *triangle = triangle.map(|at| self.ring[at as usize]);
        }
    }
}

/// What became of a polygon.
pub(super) struct Split<'a> {
    /// Corner numbers, three a triangle.
    pub(super) triangles: &'a [[u32; 3]],
    /// Whether every corner found its triangle. It does not where a polygon crosses or folds back
    /// on itself.
    pub(super) complete: bool,
}

/// Whether the triangle's area is other than zero, by the components of the cross product in f64.
/// Its squared length would vanish for small triangles that do have an area (HARD CASE TR-09).
fn has_area(a: Vec3, b: Vec3, c: Vec3) -> bool {
    let [a, b, c] = [a, b, c].map(|point| point.as_dvec3());
    (b - a).cross(c - a) != DVec3::ZERO
}

/// A normal of the polygon, as long as twice its area (Martin Newell's method; Ivan Sutherland,
/// Robert Sproull, Robert Schumacker, "A Characterization of Ten Hidden-Surface Algorithms", 1974).
/// Differences are taken from one corner, so that a polygon far from the origin loses no digits.
fn newell(mut points: impl Iterator<Item = DVec3>) -> DVec3 {
    let origin = points.next().unwrap_or_default();
    let mut sum = DVec3::ZERO;
    let mut before = DVec3::ZERO;
    for point in points {
        sum += before.cross(point - origin);
        before = point - origin;
    }
    sum
}

/// Drops the coordinate along which `normal` is longest. What is left goes round anticlockwise.
fn flatten(point: Vec3, normal: DVec3) -> [f64; 2] {
    let [x, y, z] = point.as_dvec3().to_array();
    let size = normal.abs();
    let (flat, along) = if size.z >= size.x && size.z >= size.y {
        ([x, y], normal.z)
    } else if size.y >= size.x {
        ([z, x], normal.y)
    } else {
        ([y, z], normal.x)
    };
    if along < 0.0 { [flat[1], flat[0]] } else { flat }
}

/// Twice the signed area of a flat triangle: positive where a, b, c turn left.
fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    let [a, b, c] = [a, b, c].map(DVec2::from_array);
    (b - a).perp_dot(c - a)
}

/// Whether this is a quad that turns left at every corner.
fn is_convex_quad(flat: &[[f64; 2]]) -> bool {
    let &[a, b, c, d] = flat else { return false };
    [[a, b, c], [b, c, d], [c, d, a], [d, a, b]].iter().all(|&[a, b, c]| turn(a, b, c) > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The area vector of the polygon and that of its triangles must be the same, which fails for a
    /// hole, an overlap outside the polygon, or a flipped triangle.
    fn check(corners: &[Vec3], triangles: usize) {
        let mut splitter = Splitter::new();
        let split = splitter.split(corners);
        assert_eq!(split.triangles.len(), triangles, "{corners:?}");
        assert!(split.complete);
        let whole = newell(corners.iter().map(|corner| corner.as_dvec3()));
        let mut sum = DVec3::ZERO;
        let mut sizes = 0.0;
        for triangle in split.triangles {
            let part = newell(triangle.iter().map(|&at| corners[at as usize].as_dvec3()));
            assert!(part.dot(whole) > 0.0, "flipped {triangle:?} of {corners:?}");
            sum += part;
            sizes += part.length();
        }
        assert!((sum - whole).length() <= 1e-6 * whole.length(), "{sum} {whole}");
        assert!(sizes <= whole.length() * (1.0 + 1e-6), "overlap in {corners:?}");
    }

    /// Both windings on all three coordinate planes and on a slanted one.
    fn check_everywhere(flat: &[[f32; 2]], triangles: usize) {
        let planes: [fn(f32, f32) -> Vec3; 4] = [
            |u, v| Vec3::new(u, v, 0.25),
            |u, v| Vec3::new(-3.0, u, v),
            |u, v| Vec3::new(u, 7.5, v),
            |u, v| Vec3::new(u - 2.0 * v, 2.0 * u + v, 0.5 * u + 4.0 * v),
        ];
        for plane in planes {
            let mut corners: Vec<_> = flat.iter().map(|&[u, v]| plane(u, v)).collect();
            check(&corners, triangles);
            corners.reverse();
            check(&corners, triangles);
        }
    }

    #[test]
    fn convex_concave_and_collinear_polygons_keep_area_and_winding() {
        check_everywhere(&[[0.0, 0.0], [3.0, 0.5], [1.0, 2.0]], 1);
        check_everywhere(&[[0.0, 0.0], [3.0, 0.0], [3.5, 2.0], [0.0, 1.0]], 2);
        // A dart: its diagonal from the first corner lies outside.
        check_everywhere(&[[0.0, 3.0], [1.0, 0.5], [0.0, -2.0], [4.0, 0.0]], 2);
        // A corner in the middle of a side must stay, or the neighbour's edge would gape.
        check_everywhere(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.5, 3.0]], 2);
        check_everywhere(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [5.0, 0.0], [0.5, 3.0]], 3);
        // An L and a comb.
        check_everywhere(
            &[[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]],
            4,
        );
        check_everywhere(
            &[
                [0.0, 0.0],
                [7.0, 0.0],
                [7.0, 3.0],
                [6.0, 1.0],
                [4.0, 3.5],
                [3.0, 1.0],
                [1.0, 4.0],
                [0.5, 0.75],
            ],
            6,
        );
    }

    #[test]
    fn a_ring_of_a_hundred_corners_takes_the_same_care() {
        let star = |k: i32| {
            let angle = f64::from(k) * std::f64::consts::TAU / 100.0;
            let radius = if k % 2 == 0 { 5.0 } else { 2.0 };
            [(radius * libm::cos(angle)) as f32, (radius * libm::sin(angle)) as f32]
        };
        check_everywhere(&(0..100).map(star).collect::<Vec<_>>(), 98);
    }

    #[test]
    fn polygons_without_area_have_no_triangles() {
        let (a, b) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(2.0, 4.0, 6.0));
        let on_line = [a, b, a * 3.0, a * 5.0];
        for corners in [&[a, a, b][..], &[a, b, a], &[a, a, a, a], &on_line, &on_line[..3]] {
            assert!(Splitter::new().split(corners).triangles.is_empty(), "{corners:?}");
        }
        // Small is not degenerate, though in f32 the cross product of this one is 0.
        let tiny = Vec3::splat(1e-43);
        let corners = [Vec3::ZERO, tiny.with_x(0.0), tiny.with_y(0.0)];
        assert_eq!(Splitter::new().split(&corners).triangles.len(), 1);
    }

    #[test]
    fn repeated_neighbours_make_a_smaller_polygon() {
        let (a, b, c) = (Vec3::X, Vec3::Y * 2.0, Vec3::Z * 3.0);
        let mut splitter = Splitter::new();
        assert_eq!(splitter.split(&[a, b, b, c, a]).triangles, [[0, 1, 3]]);
    }
}
