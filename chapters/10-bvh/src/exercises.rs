//! The exercises of chapter 10: replace both lines of a body with your own.
//!
//! ```text
//! cargo test -p bvh --test exercises
//! ```
//!
//! says what is missing, what is done, and what went wrong. The page of chapter 10 has the story of
//! each.

use boxes::aabb::Aabb;
use boxes::slab::BoxRay;
use glam::Vec3;

use crate::tree::Bvh;

/// Exercise 10.1, half of them on each side: the places in the list of the half of the centres that
/// lies lower along the longest axis.
///
/// The longest axis is that of the box around all centres. Of `n` centres give `n / 2`, rounded down,
/// in any order. No two centres have the same coordinate. See the section "Where to cut".
pub fn lower_half(centers: &[Vec3]) -> Vec<usize> {
    let _ = centers;
    todo!("exercise 10.1")
}

/// Exercise 10.2, what a cut costs: the surface area heuristic for a node that is cut in two.
///
/// Visiting the node costs `step`, asking an item costs 1. Each side is asked as often as a ray that
/// meets the node's box meets the side's box. See the section "What a cut costs".
pub fn cost_of_cut(node: &Aabb, sides: &[(Aabb, u32); 2], step: f32) -> f32 {
    let _ = (node, sides, step);
    todo!("exercise 10.2")
}

/// Exercise 10.3, not behind what was found: the nearest item a ray hits, and where.
///
/// `ask` puts the question to one item: where the ray hits it, below the limit you give. The check
/// counts how often you ask: items behind the nearest hit should not be, and the nearer of two
/// children is worth asking first. Of two hits at the same distance either counts: there are none
/// here (exercise 10.5 is about them). See the section "The nearer child first".
pub fn nearest(
    tree: &Bvh,
    ray: &BoxRay,
    ask: &mut dyn FnMut(u32, f32) -> Option<f32>,
) -> Option<(u32, f32)> {
    let _ = (tree, ray, ask);
    todo!("exercise 10.3")
}

/// Exercise 10.4, is anything in the way: whether the ray hits an item below `t_max`.
///
/// `ask` is the one of exercise 10.3. The check notes whether you ask after a hit, and whether you ask
/// an item whose box the ray doesn't meet: neither is needed. See the section "Any hit will do".
pub fn is_hit(
    tree: &Bvh,
    ray: &BoxRay,
    t_max: f32,
    ask: &mut dyn FnMut(u32, f32) -> Option<f32>,
) -> bool {
    let _ = (tree, ray, t_max, ask);
    todo!("exercise 10.4")
}

/// Exercise 10.5, find the mistake: which of the hits in two children is the ray's.
///
/// The report's last line is `return left.distance < right.distance ? left : right`. A hit is an
/// item's number and its distance. Of two at the same distance the one with the lower number counts,
/// or the picture would depend on how the tree was built. See the section "The report's traversal".
pub fn nearer(left: Option<(u32, f32)>, right: Option<(u32, f32)>) -> Option<(u32, f32)> {
    let _ = (left, right);
    todo!("exercise 10.5")
}
