//! Building: cut the items in two, and each part again.

use boxes::aabb::Aabb;
use triangles::lanes::LANES;

use crate::item::{Item, Span};
use crate::node::Node;
use crate::split::{Limits, Split, cut};
use crate::tree::Bvh;

// ANCHOR: depth
/// The most levels of children below the root.
///
/// A node at level d may hold at most `leaf << (DEPTH - d)` items: then halving them, once a level,
/// is sure to end in leaves of `leaf` items. A cut that would leave more on one side is replaced by
/// the median. So a traversal that puts aside one node a level needs a stack of this size and never
/// more (hard case AC-04).
pub const DEPTH: u32 = 64;
// ANCHOR_END: depth

/// Parts of this many items are worth a task of their own.
const TASK: usize = 4096;

/// How a tree is built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Recipe {
    /// How items are cut in two.
    pub split: Split,
    /// The most items in a leaf, at least 1.
    pub leaf: usize,
    /// How many items are asked for the price of one: a power of two.
    pub together: u32,
}

impl Recipe {
    /// For triangles that are asked four at a time: by surface area, up to four a leaf.
    pub const TRIANGLES: Self = Self { split: Split::Sah, leaf: LANES, together: LANES as u32 };
}

impl Default for Recipe {
    /// By surface area, down to single items.
    fn default() -> Self {
        Self { split: Split::Sah, leaf: 1, together: 1 }
    }
}

/// A part of the items that is to become a subtree.
struct Part<'a> {
    items: &'a mut [Item],
    /// Where in the order the first of them is.
    place: usize,
    /// How many steps below the root.
    level: u32,
}

impl Recipe {
    /// The tree over these boxes. Empty boxes and those that are not finite are left out.
    pub fn build(&self, boxes: impl IntoIterator<Item = Aabb>) -> Bvh {
        let boxes = (0..).zip(boxes);
        let mut items: Vec<Item> =
            boxes.filter_map(|(index, bounds)| Item::new(&bounds, index)).collect();
        let mut nodes = Vec::with_capacity(items.len());
        if !items.is_empty() {
            nodes.push(Node { bounds: Span::EMPTY.aabb(), first: 0, count: 0 });
            let whole = Part { items: &mut items, place: 0, level: 0 };
            nodes[0] = self.grow(whole, &mut nodes);
        }
        Bvh { nodes, order: items.iter().map(Item::index).collect() }
    }

    // ANCHOR: grow
    /// The node for these items; all that is below it is added to `nodes`, first children first.
    fn grow(&self, part: Part, nodes: &mut Vec<Node>) -> Node {
        let Part { items, place, level } = part;
        let (mut bounds, mut centers) = (Span::EMPTY, Span::EMPTY);
        for item in items.iter() {
            bounds.add(item);
            centers.add_point(item.center());
        }
        let middle =
            self.limits(level).and_then(|limits| cut(items, &bounds, &centers, self.split, limits));
        let Some(middle) = middle else {
            return Node { bounds: bounds.aabb(), first: place as u32, count: items.len() as u32 };
        };
        let (left, right) = items.split_at_mut(middle);
        let left = Part { items: left, place, level: level + 1 };
        let right = Part { items: right, place: place + middle, level: level + 1 };

        let first = nodes.len();
        let inner = Node { bounds: bounds.aabb(), first: first as u32, count: 0 };
        nodes.extend([inner; 2]);
        if left.items.len().min(right.items.len()) < TASK {
            nodes[first] = self.grow(left, nodes);
            nodes[first + 1] = self.grow(right, nodes);
        } else {
            let ((left, below_left), (right, below_right)) =
                both(|| self.grow_apart(left), || self.grow_apart(right));
            nodes[first] = append(nodes, left, below_left);
            nodes[first + 1] = append(nodes, right, below_right);
        }
        inner
    }
    // ANCHOR_END: grow

    /// The node for these items, and a list of all that is below it.
    fn grow_apart(&self, part: Part) -> (Node, Vec<Node>) {
        let mut below = Vec::with_capacity(part.items.len());
        (self.grow(part, &mut below), below)
    }

    /// What a cut of a node at this level may do; None on the lowest, where no more is needed.
    fn limits(&self, level: u32) -> Option<Limits> {
        let (leaf, below) = (self.leaf.max(1), DEPTH.checked_sub(level + 1)?);
        let most = leaf.checked_mul(1_usize.checked_shl(below).unwrap_or(usize::MAX));
        let together = self.together.max(1).next_power_of_two();
        Some(Limits { leaf, together, most: most.unwrap_or(usize::MAX) })
    }
}

/// Adds a subtree that was built apart; gives its root.
fn append(nodes: &mut Vec<Node>, root: Node, below: Vec<Node>) -> Node {
    let moved = nodes.len() as u32;
    let moved =
        |node: Node| if node.is_leaf() { node } else { Node { first: node.first + moved, ..node } };
    nodes.extend(below.into_iter().map(moved));
    moved(root)
}

/// Runs both, on two threads where there are two. What they do does not depend on it.
#[cfg(feature = "native")]
fn both<L: Send, R: Send>(
    left: impl FnOnce() -> L + Send,
    right: impl FnOnce() -> R + Send,
) -> (L, R) {
    rayon::join(left, right)
}

#[cfg(not(feature = "native"))]
fn both<L, R>(left: impl FnOnce() -> L, right: impl FnOnce() -> R) -> (L, R) {
    (left(), right())
}

#[cfg(test)]
mod tests {
    use boxes::aabb::Aabb;
    use common::sampler::Stream;
    use glam::Vec3;

    use super::{DEPTH, Recipe};
    use crate::split::Split;

    const SPLITS: [Split; 3] = [Split::Midpoint, Split::Median, Split::Sah];

    fn point(stream: &mut Stream, side: f32) -> Vec3 {
        let x = stream.between(-side, side);
        let y = stream.between(-side, side);
        Vec3::new(x, y, stream.between(-side, side))
    }

    fn scattered(count: u64) -> Vec<Aabb> {
        let next = |trial| {
            let mut stream = Stream::of_trial(101, trial);
            let center = point(&mut stream, 50.0);
            Aabb::of_points([center, center + point(&mut stream, 2.0)])
        };
        (0..count).map(next).collect()
    }

    fn check(boxes: &[Aabb]) {
        for (split, leaf) in SPLITS.into_iter().flat_map(|split| [(split, 1), (split, 4)]) {
            let tree = Recipe { split, leaf, together: 4 }.build(boxes.iter().copied());
            assert_eq!(tree.flaw(boxes), None, "{split:?} {leaf}");
            let largest = tree.nodes.iter().map(|node| node.count).max();
            assert!(largest <= Some(leaf as u32), "{split:?} {leaf}");
        }
    }

    #[test]
    fn every_thing_is_in_one_leaf_and_every_child_in_its_parent() {
        for count in [0, 1, 2, 3, 4, 5, 9, 100, 5000] {
            check(&scattered(count));
        }
    }

    /// Five boxes in a row along y: the middle of the longest axis has two below it, the median too;
    /// by surface area the far one is cut off.
    #[test]
    fn three_cuts_by_hand() {
        let boxes = [0.0, 1.0, 2.0, 3.0, 20.0].map(|y| {
            let low = Vec3::new(0.0, y, 0.0);
            Aabb { min: low, max: low + Vec3::new(0.5, 0.9, 0.2) }
        });
        let first = |split| {
            let tree = Recipe { split, ..Recipe::default() }.build(boxes);
            let left = &tree.nodes[1].bounds;
            boxes.iter().filter(|it| left.union(**it) == *left).count()
        };
        assert_eq!(SPLITS.map(first), [4, 2, 4]);
    }

    /// Hard case AC-02, at its full size.
    #[test]
    fn a_hundred_thousand_copies() {
        check(&vec![scattered(1)[0]; 100_000]);
        let around = |size: u32| Aabb {
            min: Vec3::new(-1.0, -2.0, -3.0) * size as f32,
            max: Vec3::new(1.0, 2.0, 3.0) * size as f32,
        };
        check(&(0..50_000).map(around).collect::<Vec<_>>());
    }

    /// Hard case AC-04, at its full size.
    #[test]
    fn a_million_in_a_line_and_all_powers_of_two() {
        let at = |x: f32| Aabb { min: Vec3::X * x, max: Vec3::X * x };
        let line: Vec<Aabb> = (0..1_000_000).map(|x| at(x as f32)).collect();
        let tree = Recipe::default().build(line.iter().copied());
        assert_eq!((tree.flaw(&line), tree.nodes.len()), (None, 1_999_999));
        let powers: Vec<Aabb> = (1..255).map(|power| at(f32::from_bits(power << 23))).collect();
        check(&powers);
        let deep = Recipe { split: Split::Midpoint, ..Recipe::default() }.build(powers);
        assert!(deep.depth() > 40 && deep.depth() <= DEPTH, "{}", deep.depth());
    }

    /// Hard case AC-05: what isn't finite is in no box.
    #[test]
    fn what_no_ray_can_hit_is_left_out() {
        let good = scattered(20);
        let bad = [Aabb::EMPTY, Aabb { min: Vec3::NAN, max: Vec3::ONE }];
        let endless = Aabb { min: Vec3::ZERO, max: Vec3::splat(f32::INFINITY) };
        let all = good.iter().flat_map(|it| [bad[0], *it, bad[1], endless]);
        let tree = Recipe::default().build(all);
        let clean = Recipe::default().build(good.iter().copied());
        assert_eq!(tree.nodes, clean.nodes);
        assert!(tree.order.iter().zip(&clean.order).all(|(all, good)| *all == 4 * good + 1));
    }

    #[test]
    fn the_largest_floats_and_the_smallest() {
        for scale in [1e-44, 1e-38, 1e-20, 1e20, 3e36] {
            let boxes: Vec<Aabb> = scattered(300)
                .iter()
                .map(|it| Aabb { min: scale * it.min, max: scale * it.max })
                .collect();
            check(&boxes);
        }
        let ends = [-f32::MAX, f32::MAX, 0.0, 1.0];
        check(&ends.map(|x| Aabb { min: Vec3::splat(x), max: Vec3::splat(x) }));
    }

    #[cfg(feature = "native")]
    #[test]
    fn any_number_of_threads_builds_the_same_tree() {
        let boxes = scattered(50_000);
        let built = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            pool.expect("a few threads").install(|| Recipe::TRIANGLES.build(boxes.iter().copied()))
        };
        let one = built(1);
        assert!([2, 3, 7].into_iter().all(|threads| built(threads) == one));
    }
}
