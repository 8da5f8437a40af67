//! The tree as a lesson wants it: node by node, in the report's way and in a better one.

use arrayvec::ArrayVec;
use boxes::slab::{BOX_TESTS, BoxRay};
use common::tally::Tally;
use glam::Vec3;
use partitions::accelerator::{Accelerator, NODE_VISITS, Statistics};
use partitions::leaf::{Question, Stored};
use ray_casting::ray::Ray;

use crate::build::{DEPTH, Recipe};
use crate::node::Node;
use crate::packed::hittable_bounds;
use crate::tree::Bvh;

// ANCHOR: plain
/// Triangles in a tree, leaf after leaf.
#[derive(Clone, Debug)]
pub struct PlainBvh {
    tree: Bvh,
    stored: Vec<Stored>,
    triangles: usize,
}
// ANCHOR_END: plain

impl PlainBvh {
    /// The tree over these triangles, each given by its corners.
    pub fn new(triangles: &[[Vec3; 3]], recipe: &Recipe) -> Self {
        let tree = recipe.build(triangles.iter().map(hittable_bounds));
        let stored = tree.order.iter().map(|&index| {
            let corners = triangles[index as usize];
            Stored { corners, index }
        });
        Self { stored: stored.collect(), tree, triangles: triangles.len() }
    }

    /// The tree itself.
    pub fn tree(&self) -> &Bvh {
        &self.tree
    }

    /// Its triangles, leaf after leaf.
    pub fn stored(&self) -> &[Stored] {
        &self.stored
    }

    // ANCHOR: both
    /// The report's traversal (its figure 5.3): whoever meets a box meets both its children, whatever
    /// was found before (erratum 7).
    fn both<Q: Question, T: Tally>(
        &self,
        node: &Node,
        ray: &BoxRay,
        t_max: f32,
        question: &mut Q,
        tally: &mut T,
    ) {
        tally.count(BOX_TESTS, 1);
        if question.answered() || ray.enter(&node.bounds, t_max).is_none() {
            return;
        }
        tally.count(NODE_VISITS, 1);
        if node.is_leaf() {
            question.ask_all(&self.stored[node.items()], tally);
        } else {
            for child in node.children() {
                self.both(&self.tree.nodes[child], ray, t_max, question, tally);
            }
        }
    }
    // ANCHOR_END: both

    // ANCHOR: ordered
    /// The nearer child first, and the other one only if nothing was found before it.
    ///
    /// Each node visited is replaced by two at most, so that a level adds one to those that wait.
    fn ordered<Q: Question, T: Tally>(&self, ray: &BoxRay, question: &mut Q, tally: &mut T) {
        let mut waiting = ArrayVec::<(usize, f32), { DEPTH as usize + 1 }>::new();
        let nodes = &self.tree.nodes;
        let enter = |place: usize, limit: f32, tally: &mut T| {
            tally.count(BOX_TESTS, 1);
            ray.enter(&nodes[place].bounds, limit).map(|enter| (place, enter))
        };
        waiting.extend(enter(0, question.limit(), tally));
        while let Some((place, entered)) = waiting.pop() {
            let node = &nodes[place];
            if question.answered() || entered > question.limit() {
                continue;
            }
            tally.count(NODE_VISITS, 1);
            if node.is_leaf() {
                question.ask_all(&self.stored[node.items()], tally);
                continue;
            }
            let [one, other] = node.children().map(|child| enter(child, question.limit(), tally));
            // What is put down last is taken up first.
            match (one, other) {
                (Some(one), Some(other)) => {
                    let (near, far) = if other.1 < one.1 { (other, one) } else { (one, other) };
                    waiting.push(far);
                    waiting.push(near);
                }
                (one, other) => waiting.extend(one.or(other)),
            }
        }
    }
    // ANCHOR_END: ordered

    fn statistics(&self) -> Statistics {
        Statistics {
            triangles: self.triangles,
            left_out: self.triangles - self.stored.len(),
            references: self.stored.len(),
            nodes: self.tree.nodes.len(),
            depth: self.tree.depth() as usize,
            bytes: size_of_val(&self.tree.nodes[..]) + size_of_val(&self.stored[..]),
        }
    }
}

/// The tree with the report's traversal.
#[derive(Clone, Debug)]
pub struct BothChildren(pub PlainBvh);

/// The tree with the nearer child first.
#[derive(Clone, Debug)]
pub struct NearChildFirst(pub PlainBvh);

impl Accelerator for BothChildren {
    fn build(triangles: Vec<[Vec3; 3]>) -> Self {
        Self(PlainBvh::new(&triangles, &Recipe::TRIANGLES))
    }

    fn walk<Q: Question, T: Tally>(&self, ray: &Ray, question: &mut Q, tally: &mut T) {
        if let Some(root) = self.0.tree.nodes.first() {
            let boxes = BoxRay::new(ray, &root.bounds);
            self.0.both(root, &boxes, question.limit(), question, tally);
        }
    }

    fn statistics(&self) -> Statistics {
        self.0.statistics()
    }
}

impl Accelerator for NearChildFirst {
    fn build(triangles: Vec<[Vec3; 3]>) -> Self {
        Self(PlainBvh::new(&triangles, &Recipe::TRIANGLES))
    }

    fn walk<Q: Question, T: Tally>(&self, ray: &Ray, question: &mut Q, tally: &mut T) {
        if let Some(root) = self.0.tree.nodes.first() {
            self.0.ordered(&BoxRay::new(ray, &root.bounds), question, tally);
        }
    }

    fn statistics(&self) -> Statistics {
        self.0.statistics()
    }
}
