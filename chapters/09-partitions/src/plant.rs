//! Planting a tree of planes: which plane to cut with is the caller's choice, all else is here.

use boxes::aabb::Aabb;
use glam::Vec3;

use crate::accelerator::MOST_COPIES;
use crate::leaf::{Stored, hittable};
use crate::plane_tree::{DEEPEST, Node, PlaneTree};

// ANCHOR: span
/// What a triangle, or a cell, covers along one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// The least coordinate.
    pub low: f32,
    /// The greatest.
    pub high: f32,
}
// ANCHOR_END: span

impl Span {
    /// The middle; halved before the sum, which could overflow.
    pub fn middle(&self) -> f32 {
        0.5 * self.low + 0.5 * self.high
    }
}

/// A plane: a direction's number, and how far along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// The number of the direction the plane stands across.
    pub direction: usize,
    /// How far along that direction.
    pub place: f32,
}

/// What a plane is chosen by: a cell and the triangles in it.
pub struct Cell<'a, const N: usize> {
    /// What each triangle of the whole tree covers.
    pub spans: &'a [[Span; N]],
    /// Which of them are in the cell.
    pub members: &'a [u32],
    /// What the cell covers.
    pub extent: [Span; N],
}

impl<const N: usize> Cell<'_, N> {
    /// What the members cover along one direction.
    pub fn spans_along(&self, direction: usize) -> impl Iterator<Item = Span> {
        self.members.iter().map(move |&member| self.spans[member as usize][direction])
    }
}

/// A way to choose planes: None makes the cell a leaf.
pub type Choose<const N: usize> = fn(&Cell<N>) -> Option<Plane>;

/// Plants a tree whose planes stand across `directions`.
pub fn plant<const N: usize>(
    triangles: &[[Vec3; 3]],
    directions: [Vec3; N],
    base: impl Fn(&Aabb) -> Vec3,
    choose: Choose<N>,
) -> PlaneTree<N> {
    let members = hittable(triangles);
    let bounds = Aabb::of_points(members.iter().flat_map(|it| it.corners));
    let base = base(&bounds);
    let spans: Vec<[Span; N]> =
        members.iter().map(|it| directions.map(|along| span(&it.corners, along, base))).collect();
    let tree = PlaneTree {
        directions,
        base,
        bounds,
        nodes: Vec::new(),
        stored: Vec::new(),
        triangles: triangles.len(),
        left_out: triangles.len() - members.len(),
        depth: 0,
    };
    let mut planting = Planting { tree, triangles: members, spans, choose };
    let all: Vec<u32> = (0..planting.triangles.len() as u32).collect();
    let extent = [0; N].map(|_| Span { low: f32::INFINITY, high: f32::NEG_INFINITY });
    let extent = planting.spans.iter().fold(extent, around);
    planting.cell(&all, extent, 0, MOST_COPIES);
    planting.tree
}

/// The smallest spans around both.
fn around<const N: usize>(mut all: [Span; N], one: &[Span; N]) -> [Span; N] {
    for (all, one) in all.iter_mut().zip(one) {
        *all = Span { low: all.low.min(one.low), high: all.high.max(one.high) };
    }
    all
}

// ANCHOR: span_of
/// What a triangle covers along `direction` from `base`: measured in f64, and rounded outward
/// unless it is a coordinate itself.
fn span(corners: &[Vec3; 3], direction: Vec3, base: Vec3) -> Span {
    let along = |corner: &Vec3| direction.as_dvec3().dot(corner.as_dvec3() - base.as_dvec3());
    let places = [0, 1, 2].map(|at| along(&corners[at]));
    let low = places.into_iter().fold(f64::INFINITY, f64::min);
    let high = places.into_iter().fold(f64::NEG_INFINITY, f64::max);
    let [mut low32, mut high32] = [low as f32, high as f32];
    if f64::from(low32) > low {
        low32 = low32.next_down();
    }
    if f64::from(high32) < high {
        high32 = high32.next_up();
    }
    Span { low: low32, high: high32 }
}
// ANCHOR_END: span_of

struct Planting<const N: usize> {
    tree: PlaneTree<N>,
    triangles: Vec<Stored>,
    spans: Vec<[Span; N]>,
    choose: Choose<N>,
}

impl<const N: usize> Planting<N> {
    // ANCHOR: cell
    /// Makes a leaf of the cell, or cuts it and makes two cells of it.
    ///
    /// `copies` is how many times the memory of its members may be spent on the cell. A cut that
    /// stores some of them twice spends a part of it, the rest is for both halves. So the whole tree
    /// can't store more than it was allowed at the root, whatever the triangles.
    fn cell(&mut self, members: &[u32], extent: [Span; N], depth: usize, copies: f32) {
        self.tree.depth = self.tree.depth.max(depth);
        let Some((plane, [below, above])) = self.cut(members, extent, depth, copies) else {
            self.leaf(members);
            return;
        };
        let copies = copies * members.len() as f32 / (below.len() + above.len()) as f32;
        let place = self.tree.nodes.len();
        self.tree.nodes.push(Node::Leaf { first: 0, count: 0 });
        let [mut lower, mut upper] = [extent; 2];
        lower[plane.direction].high = plane.place;
        upper[plane.direction].low = plane.place;
        self.cell(&below, lower, depth + 1, copies);
        self.tree.nodes[place] = Node::Inner {
            direction: plane.direction as u8,
            plane: plane.place,
            above: self.tree.nodes.len() as u32,
        };
        self.cell(&above, upper, depth + 1, copies);
    }

    /// A plane and the members below and above it, if cutting is allowed and does any good.
    fn cut(
        &self,
        members: &[u32],
        extent: [Span; N],
        depth: usize,
        copies: f32,
    ) -> Option<(Plane, [Vec<u32>; 2])> {
        if depth == DEEPEST {
            return None;
        }
        let plane = (self.choose)(&Cell { spans: &self.spans, members, extent })?;
        let Span { low, high } = extent[plane.direction];
        // A plane at the cell's end would cut off nothing, and NaN would lose triangles.
        if !(low < plane.place && plane.place < high) {
            return None;
        }
        let [below, above] = self.part(members, plane);
        let stored = below.len() + above.len();
        let useful = below.len().max(above.len()) < members.len() || stored == members.len();
        let affordable = copies * members.len() as f32 >= stored as f32;
        (useful && affordable).then_some((plane, [below, above]))
    }
    // ANCHOR_END: cell

    // ANCHOR: part
    /// The members that reach below the plane, and those that reach above it. One that ends in the
    /// plane is on its own side only, one that lies in it is below: a wide ray that comes near the
    /// plane asks both sides.
    fn part(&self, members: &[u32], plane: Plane) -> [Vec<u32>; 2] {
        let span = |member: &u32| self.spans[*member as usize][plane.direction];
        let below = |it: &u32| span(it).low < plane.place || span(it).high <= plane.place;
        let above = |it: &u32| span(it).high > plane.place;
        let those =
            |wanted: &dyn Fn(&u32) -> bool| members.iter().copied().filter(wanted).collect();
        [those(&below), those(&above)]
    }
    // ANCHOR_END: part

    fn leaf(&mut self, members: &[u32]) {
        let first = self.tree.stored.len() as u32;
        self.tree.nodes.push(Node::Leaf { first, count: members.len() as u32 });
        self.tree.stored.extend(members.iter().map(|&it| self.triangles[it as usize]));
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::{Span, span};

    #[test]
    fn a_span_holds_its_triangle_and_a_coordinate_is_exact() {
        let corners =
            [Vec3::new(0.1, 0.2, 0.3), Vec3::new(-0.7, 1e-9, 0.4), Vec3::new(0.3, -0.3, 1e7)];
        let expected = Span { low: -0.7, high: 0.3 };
        assert_eq!(span(&corners, Vec3::X, Vec3::ZERO), expected);
        let slanted = Vec3::new(1.0, -1.0, 1.0);
        let Span { low, high } = span(&corners, slanted, Vec3::ZERO);
        for corner in corners {
            let along = corner.as_dvec3().dot(slanted.as_dvec3());
            assert!(f64::from(low) <= along && along <= f64::from(high));
        }
        assert!(low.next_up().next_up() > -0.300_001 && high.next_down() <= 1e7 + 1.0);
    }
}
