//! Cutting away what can't be divided: the part of a triangle behind the eye.
//!
//! Sutherland and Hodgman, "Reentrant Polygon Clipping" (Communications of the ACM 17, 1974), done in
//! homogeneous coordinates as in Blinn and Newell, "Clipping Using Homogeneous Coordinates"
//! (SIGGRAPH 1978).

use crate::fixed::GUARD;
use crate::project::FilmPoint;

/// The part of space whose points may be divided by their depth: beyond the near plane, and not so
/// far beside the film that fixed-point numbers overflow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Volume {
    /// The smallest depth, in units of the scene; above 0.
    pub near: f64,
}

/// A plane through the eye or across the line of sight; its inside is where the value is >= 0.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Plane {
    Near(f64),
    Left,
    Right,
    Top,
    Bottom,
}

/// A triangle cut by the planes of a [`Volume`]: at most one corner more for each plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polygon {
    corners: [FilmPoint; MOST_CORNERS],
    length: usize,
}

const MOST_CORNERS: usize = 8;

/// How much nearer than the farthest vertex the near plane lies.
///
/// A power of two, so a scene scaled by another one is clipped in the same bits. Small, because
/// the depth buffer is as exact near the eye as far from it (see `zbuffer`).
const NEAR_RATIO: f64 = 1.0 / 1_048_576.0;

/// Half heights of the picture, from its middle. On the largest film this is half the guard band.
const COMFORT: f64 = 64.0;

impl Volume {
    /// The volume for points no deeper than `deepest`; None when nothing lies before the eye.
    pub fn for_depth(deepest: f64) -> Option<Self> {
        (deepest > 0.0).then_some(Self { near: deepest * NEAR_RATIO })
    }

    /// Whether a point lies inside all planes, so that it may be divided.
    pub fn contains(&self, point: FilmPoint) -> bool {
        self.planes().iter().all(|plane| plane.value(point) >= 0.0)
    }

    /// Whether a point lies well inside, for films of any allowed size. Its coordinates are those of
    /// a film two pixels high and wide, so the picture reaches 1 up and down from its middle.
    pub fn comfortable(&self, point: FilmPoint) -> bool {
        let (right, down) = (point.x - point.w, point.y - point.w);
        point.w >= self.near && right.abs().max(down.abs()) <= COMFORT * point.w
    }

    fn planes(&self) -> [Plane; 5] {
        [Plane::Near(self.near), Plane::Left, Plane::Right, Plane::Top, Plane::Bottom]
    }

    // ANCHOR: clip
    /// What is left of a triangle; a polygon without corners when nothing is.
    pub fn clip(&self, triangle: [FilmPoint; 3]) -> Polygon {
        let mut polygon = Polygon::new(&triangle);
        for plane in self.planes() {
            polygon = polygon.cut(plane);
        }
        polygon
    }
    // ANCHOR_END: clip
}

impl Plane {
    // ANCHOR: value
    /// Negative outside, 0 on the plane, linear in between.
    fn value(self, point: FilmPoint) -> f64 {
        match self {
            Self::Near(near) => point.w - near,
            Self::Left => point.x + GUARD * point.w,
            Self::Right => GUARD * point.w - point.x,
            Self::Top => point.y + GUARD * point.w,
            Self::Bottom => GUARD * point.w - point.y,
        }
    }
    // ANCHOR_END: value
}

impl Polygon {
    /// The polygon with these corners, at most 8.
    pub fn new(corners: &[FilmPoint]) -> Self {
        let origin = FilmPoint { x: 0.0, y: 0.0, w: 0.0 };
        let mut polygon = Self { corners: [origin; MOST_CORNERS], length: 0 };
        corners.iter().for_each(|&corner| polygon.push(corner));
        polygon
    }

    /// Its corners in order.
    pub fn corners(&self) -> &[FilmPoint] {
        &self.corners[..self.length]
    }

    // ANCHOR: cut
    /// The part on the inner side of a plane.
    fn cut(self, plane: Plane) -> Self {
        let mut kept = Self::new(&[]);
        let corners = self.corners();
        for (index, &corner) in corners.iter().enumerate() {
            let next = corners[(index + 1) % corners.len()];
            let (here, there) = (plane.value(corner), plane.value(next));
            if here >= 0.0 {
                kept.push(corner);
            }
            // The edge crosses the plane. Both triangles at this edge must find the same point, so
            // it is always reckoned from the inner end to the outer one.
            if (here >= 0.0) != (there >= 0.0) {
                let inside_first = here >= 0.0;
                let (inner, outer) = if inside_first { (corner, next) } else { (next, corner) };
                let (near, far) = if inside_first { (here, there) } else { (there, here) };
                kept.push(between(inner, outer, near / (near - far)));
            }
        }
        kept
    }
    // ANCHOR_END: cut

    fn push(&mut self, corner: FilmPoint) {
        self.corners[self.length] = corner;
        self.length += 1;
    }
}

/// The point at `share` of the way from one point to another.
fn between(from: FilmPoint, to: FilmPoint, share: f64) -> FilmPoint {
    let (start, end) = (from.vector(), to.vector());
    (start + share * (end - start)).into()
}

#[cfg(test)]
mod tests {
    use super::{FilmPoint, Volume};

    const VOLUME: Volume = Volume { near: 0.25 };

    fn point(x: f64, y: f64, w: f64) -> FilmPoint {
        FilmPoint { x, y, w }
    }

    #[test]
    fn a_triangle_inside_is_left_alone() {
        let triangle = [point(1.0, 2.0, 3.0), point(40.0, 2.0, 0.25), point(-5.0, 60.0, 9.0)];
        assert_eq!(VOLUME.clip(triangle).corners(), triangle);
    }

    #[test]
    fn a_corner_behind_the_eye_becomes_two_on_the_near_plane() {
        // By hand: from w = 1.25 to w = -0.75 the plane w = 0.25 is half way.
        let triangle = [point(2.0, 0.0, 1.25), point(6.0, 4.0, 1.25), point(4.0, 8.0, -0.75)];
        let kept = VOLUME.clip(triangle);
        let expected = [triangle[0], triangle[1], point(5.0, 6.0, 0.25), point(3.0, 4.0, 0.25)];
        assert_eq!(kept.corners(), expected);
    }

    #[test]
    fn nothing_is_left_of_a_triangle_behind_the_eye() {
        let triangle = [point(2.0, 0.0, -1.0), point(6.0, 4.0, 0.0), point(4.0, 8.0, 0.125)];
        assert!(VOLUME.clip(triangle).corners().is_empty());
    }

    #[test]
    fn two_triangles_cut_their_shared_edge_at_the_same_point() {
        let (a, b) = (point(2.3, 0.7, 1.1), point(-7.9, 4.1, -0.7));
        let left = VOLUME.clip([a, b, point(1.0, 1.0, 2.0)]);
        let right = VOLUME.clip([b, a, point(3.0, -1.0, 5.0)]);
        let shared = left.corners().iter().filter(|corner| right.corners().contains(corner));
        assert_eq!(shared.count(), 2, "one end of the edge and the cut");
    }

    #[test]
    fn every_corner_may_be_divided() {
        let wild = [point(1e9, -2e9, 1.0), point(-3e12, 1.0, 0.5), point(4.0, 8e15, -0.75)];
        let kept = VOLUME.clip(wild);
        assert!(kept.corners().len() >= 3);
        assert!(kept.corners().iter().all(|corner| corner.divide().abs().max_element() < 4.2e6));
    }
}
