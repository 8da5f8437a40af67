//! An octree: space cut in eight equal parts, and each of those again where it holds too much.
//!
//! Glassner, "Space Subdivision for Fast Ray Tracing" (IEEE Computer Graphics and Applications
//! 4(10), 1984).

use boxes::aabb::Aabb;
use boxes::bounded::Bounded;
use common::tally::Tally;
use glam::Vec3;
use ray_casting::ray::Ray;

use crate::accelerator::{Accelerator, MOST_COPIES, NODE_VISITS, Statistics};
use crate::leaf::{Question, Stored, hittable};
use crate::wide::{Interval, WideRay};

// ANCHOR: octree
/// An octree.
#[derive(Clone, Debug)]
pub struct Octree {
    bounds: Aabb,
    nodes: Vec<Node>,
    stored: Vec<Stored>,
    triangles: usize,
    left_out: usize,
    depth: usize,
}

/// A node.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Node {
    /// Cut in eight at `center`. The parts follow one another from place `first` on; the lowest
    /// three bits of their number say whether they are above the centre along x, y and z.
    Inner { center: Vec3, first: u32 },
    /// Not cut: triangles `first` to `first + count`.
    Leaf { first: u32, count: u32 },
}
// ANCHOR_END: octree

/// The most triangles that are left together without an attempt to cut.
const FEW: usize = 8;
/// A leaf with nothing in it.
const NOTHING: Node = Node::Leaf { first: 0, count: 0 };
/// The most steps from the root to a leaf: a cell is then a millionth of the scene across.
const DEEPEST: usize = 20;

/// Which box says where a triangle belongs: the one around it, but for a mistake to be shown.
pub(crate) type Place = fn(&Stored) -> Aabb;

impl Octree {
    /// The tree, with each triangle in the cells that its `place` reaches into.
    pub(crate) fn planted(triangles: &[[Vec3; 3]], place: Place) -> Self {
        let hittable = hittable(triangles);
        let bounds = Aabb::of_points(hittable.iter().flat_map(|it| it.corners));
        let tree = Self {
            bounds,
            nodes: vec![NOTHING],
            stored: Vec::new(),
            triangles: triangles.len(),
            left_out: triangles.len() - hittable.len(),
            depth: 0,
        };
        let mut planting = Planting { tree, place };
        planting.cell(0, &hittable, bounds, Allowance { depth: DEEPEST, copies: MOST_COPIES });
        planting.tree
    }
}

/// What is left to be spent on a cell.
#[derive(Clone, Copy)]
struct Allowance {
    /// How many more times it may be cut.
    depth: usize,
    /// How many times its members' memory may be used, as in [`crate::plant`].
    copies: f32,
}

struct Planting {
    tree: Octree,
    place: Place,
}

impl Planting {
    /// Cuts the cell at place `node`, or makes it a leaf.
    fn cell(&mut self, node: usize, members: &[Stored], cell: Aabb, left: Allowance) {
        self.tree.depth = self.tree.depth.max(DEEPEST - left.depth);
        let Some(parts) = self.cut(members, &cell, left) else {
            let first = self.tree.stored.len() as u32;
            self.tree.stored.extend_from_slice(members);
            self.tree.nodes[node] = Node::Leaf { first, count: members.len() as u32 };
            return;
        };
        let stored: usize = parts.iter().map(Vec::len).sum();
        let copies = left.copies * members.len() as f32 / stored as f32;
        let first = self.tree.nodes.len();
        self.tree.nodes[node] = Node::Inner { center: cell.center(), first: first as u32 };
        self.tree.nodes.extend([NOTHING; 8]);
        for (part, members) in parts.iter().enumerate() {
            let left = Allowance { depth: left.depth - 1, copies };
            self.cell(first + part, members, eighth(&cell, part), left);
        }
    }

    /// The members of each eighth, if cutting is allowed and does any good.
    fn cut(&self, members: &[Stored], cell: &Aabb, left: Allowance) -> Option<[Vec<Stored>; 8]> {
        if members.len() <= FEW || left.depth == 0 || !progresses(cell) {
            return None;
        }
        let parts = parts(members, cell.center(), self.place);
        let stored: usize = parts.iter().map(Vec::len).sum();
        let affordable = stored as f32 <= left.copies * members.len() as f32;
        (affordable && is_useful(members.len(), stored)).then_some(parts)
    }
}

// ANCHOR: useful
/// Whether cutting saves tests. A ray that meets a cube meets an eighth of it, whose surface is a
/// quarter of the cube's, in one case of four. So of the triangles in all parts it asks a quarter,
/// and in exchange visits about two parts.
fn is_useful(members: usize, stored: usize) -> bool {
    stored as f32 / 4.0 + 2.0 < members as f32
}
// ANCHOR_END: useful

// ANCHOR: progresses
/// Whether the centre lies between the ends along some axis. Between two neighbouring floats there
/// is no number, and the parts would be the cell again, for ever (hard case AC-07).
fn progresses(cell: &Aabb) -> bool {
    let center = cell.center();
    (cell.min.cmplt(center) & center.cmplt(cell.max)).any()
}
// ANCHOR_END: progresses

// ANCHOR: parts
/// Which triangles go to which part: those whose box reaches into it (hard case AC-11).
fn parts(members: &[Stored], center: Vec3, place: Place) -> [Vec<Stored>; 8] {
    let mut parts = [const { Vec::new() }; 8];
    for triangle in members {
        let Aabb { min, max } = place(triangle);
        let above = max.cmpgt(center).bitmask();
        let below = (min.cmplt(center) | max.cmple(center)).bitmask();
        for (part, list) in (0..).zip(&mut parts) {
            // Above where the part is above, below where it is below.
            if part & !above == 0 && !part & 7 & !below == 0 {
                list.push(*triangle);
            }
        }
    }
    parts
}
// ANCHOR_END: parts

/// Part number `part` of a cell.
fn eighth(cell: &Aabb, part: usize) -> Aabb {
    let (center, mut eighth) = (cell.center(), *cell);
    for axis in 0..3 {
        let end = if part >> axis & 1 == 1 { &mut eighth.min } else { &mut eighth.max };
        end[axis] = center[axis];
    }
    eighth
}

/// A question on its way down the tree.
struct Descent<'a, Q, T> {
    tree: &'a Octree,
    ray: WideRay,
    /// For each axis that the ray comes down along, that axis' bit.
    downward: usize,
    question: &'a mut Q,
    tally: &'a mut T,
}

impl<Q: Question, T: Tally> Descent<'_, Q, T> {
    // ANCHOR: visit
    /// Puts the question to the part of the tree at `node`, in which the ray is on `part`.
    fn visit(&mut self, node: usize, part: Interval) {
        self.tally.count(NODE_VISITS, 1);
        let (center, first) = match self.tree.nodes[node] {
            Node::Leaf { first, count } => {
                let leaf = first as usize..(first + count) as usize;
                self.question.ask_all(&self.tree.stored[leaf], self.tally);
                return;
            }
            Node::Inner { center, first } => (center, first as usize),
        };
        let halves = [0, 1, 2].map(|axis| {
            let track = self.ray.track(axis);
            [part.below(&track, center[axis]), part.above(&track, center[axis])]
        });
        // With all axes upward, part 0 comes first and part 7 last, and none before one below it.
        for number in 0..8 {
            let number = number ^ self.downward;
            let [x, y, z] = [0, 1, 2].map(|axis| halves[axis][number >> axis & 1]);
            let inside = x.and(y).and(z);
            let limit = self.ray.reach(self.question.limit());
            if !inside.is_empty() && inside.from <= limit && !self.question.answered() {
                self.visit(first + number, inside);
            }
        }
    }
    // ANCHOR_END: visit
}

impl Accelerator for Octree {
    fn build(triangles: Vec<[Vec3; 3]>) -> Self {
        Self::planted(&triangles, |triangle| triangle.corners.bounds())
    }

    fn walk<Q: Question, T: Tally>(&self, ray: &Ray, question: &mut Q, tally: &mut T) {
        let ray = WideRay::new(ray, &self.bounds);
        let part = ray.within(&self.bounds, question.limit());
        if part.is_empty() {
            return;
        }
        let downward = (0..3).filter(|&axis| !ray.track(axis).ascends()).map(|axis| 1 << axis);
        let downward = downward.sum();
        Descent { tree: self, ray, downward, question, tally }.visit(0, part);
    }

    fn statistics(&self) -> Statistics {
        Statistics {
            triangles: self.triangles,
            left_out: self.left_out,
            references: self.stored.len(),
            nodes: self.nodes.len(),
            depth: self.depth,
            bytes: size_of_val(&self.nodes[..]) + size_of_val(&self.stored[..]),
        }
    }
}

#[cfg(test)]
mod tests {
    use boxes::aabb::Aabb;
    use glam::Vec3;

    use super::{eighth, parts, progresses};
    use crate::leaf::Stored;

    fn stored(corners: [[f32; 3]; 3], index: u32) -> Stored {
        Stored { corners: corners.map(Vec3::from), index }
    }

    /// AC-11: through the centre to all eight, beside it to one, and in a plane to those below it.
    #[test]
    fn triangles_go_to_the_parts_they_reach_into() {
        let center = Vec3::new(1.0, 2.0, 3.0);
        let members = [
            stored([[0.0, 1.0, 2.0], [2.0, 3.0, 2.0], [1.0, 2.0, 4.0]], 0),
            stored([[1.0, 2.0, 3.0], [2.0, 2.0, 3.5], [2.0, 3.0, 3.0]], 1),
            stored([[1.0, 2.0, 3.0], [0.0, 2.0, 2.0], [0.5, 0.0, 3.0]], 2),
            stored([[1.0, 2.5, 3.5], [1.0, 3.0, 3.5], [1.0, 3.0, 4.0]], 3),
        ];
        let parts = parts(&members, center, |it| boxes::bounded::Bounded::bounds(&it.corners));
        let held = |index: u32| -> Vec<usize> {
            (0..8).filter(|&part| parts[part].iter().any(|it| it.index == index)).collect()
        };
        assert_eq!(held(0), [0, 1, 2, 3, 4, 5, 6, 7]);
        assert_eq!(held(1), [7]);
        assert_eq!(held(2), [0]);
        assert_eq!(held(3), [6]);
    }

    #[test]
    fn an_eighth_by_its_bits() {
        let cell = Aabb { min: Vec3::new(0.0, 2.0, 4.0), max: Vec3::new(2.0, 6.0, 10.0) };
        let expected = Aabb { min: Vec3::new(1.0, 2.0, 7.0), max: Vec3::new(2.0, 4.0, 10.0) };
        assert_eq!(eighth(&cell, 0b101), expected);
    }

    /// AC-07.
    #[test]
    fn between_neighbouring_floats_nothing_progresses() {
        let at = |x: f32, steps: u32| Aabb {
            min: Vec3::splat(x),
            max: Vec3::splat(f32::from_bits(x.to_bits() + steps)),
        };
        assert!(progresses(&at(1.0, 2)) && !progresses(&at(1.0, 1)) && !progresses(&at(7e5, 0)));
        let widest = Aabb { min: Vec3::splat(-f32::MAX), max: Vec3::splat(f32::MAX) };
        assert!(progresses(&widest));
    }
}
