//! A k-d tree walked along a line without a width.

use common::tally::Off;
use ray_casting::ray::Ray;
use triangles::brute::Found;

use crate::kd::KdTree;
use crate::leaf::{NearestHit, Question};
use crate::plane_tree::Node;
use crate::wide::WideRay;

// ANCHOR: split
/// The nearest hit in a k-d tree, as it is commonly printed. The side of a plane that the ray starts
/// on is nearer: but a ray that starts in the plane, or runs in it, is on both (hard case AC-06).
pub fn along_a_line_in_a_tree(tree: &KdTree, ray: &Ray) -> Option<Found> {
    let mut question = NearestHit::new(ray, f32::INFINITY)?;
    visit(tree, 0, ray, [0.0, f32::INFINITY], &mut question);
    question.found()
}

fn visit(tree: &KdTree, node: usize, ray: &Ray, [from, to]: [f32; 2], question: &mut NearestHit) {
    let (axis, plane, above) = match tree.node(node) {
        Node::Leaf { first, count } => {
            question.ask_all(tree.leaf(first, count), &mut Off);
            return;
        }
        Node::Inner { direction, plane, above } => (direction as usize, plane, above as usize),
    };
    let starts_below = ray.origin[axis] < plane;
    let [near, far] = if starts_below { [node + 1, above] } else { [above, node + 1] };
    let crossing = (plane - ray.origin[axis]) / ray.direction[axis];
    if crossing <= 0.0 || crossing >= to {
        return visit(tree, near, ray, [from, to], question);
    }
    if crossing > from {
        visit(tree, near, ray, [from, crossing], question);
    }
    if crossing <= question.limit() {
        visit(tree, far, ray, [crossing.max(from), to], question);
    }
}
// ANCHOR_END: split

/// The nearest hit in a k-d tree by a ray without a width. What the watertight test hits a hair
/// beside the ray lies in a leaf that such a ray doesn't come to (hard case BX-03).
pub fn without_width(tree: &KdTree, ray: &Ray) -> Option<Found> {
    let mut question = NearestHit::new(ray, f32::INFINITY)?;
    tree.walk_wide(&WideRay::of_width(ray, 0.0), &mut question);
    question.found()
}
