//! The textbook's lines that fail. They are kept as negative controls, and for the book to show.

use boxes::aabb::Aabb;
use glam::Vec3;
use partitions::leaf::Stored;
use ray_casting::ray::Ray;
use triangles::brute::Found;
use triangles::intersect::TriangleTest;
use triangles::watertight::ShearedRay;

use crate::node::Node;
use crate::plain::PlainBvh;

// ANCHOR: get_intersection
/// The report's `getIntersection` (its figure 5.3), line by line: no nearest hit so far, and of two
/// hits at the same distance the right child's. `meets` is its question to a box.
pub fn get_intersection(
    tree: &PlainBvh,
    node: &Node,
    ray: &Ray,
    meets: &dyn Fn(&Aabb) -> bool,
) -> Option<Found> {
    if !meets(&node.bounds) {
        return None;
    }
    if node.is_leaf() {
        return first_of(ray, &tree.stored()[node.items()]);
    }
    let [left, right] =
        node.children().map(|child| get_intersection(tree, &tree.tree().nodes[child], ray, meets));
    let distance = |found: Option<Found>| found.map_or(f32::INFINITY, |found| found.hit.t);
    if distance(left) < distance(right) { left } else { right }
}
// ANCHOR_END: get_intersection

/// The nearest of a few triangles, the first of two at the same distance.
fn first_of(ray: &Ray, triangles: &[Stored]) -> Option<Found> {
    let ray = ShearedRay::prepare(ray)?;
    let mut nearest: Option<Found> = None;
    for triangle in triangles {
        let limit = nearest.map_or(f32::INFINITY, |found| found.hit.t);
        let hit = ray.hit(&triangle.corners, limit);
        let index = triangle.index as usize;
        nearest = hit.map(|hit| Found { hit, index }).or(nearest);
    }
    nearest
}

// ANCHOR: slabs
/// The textbook's slab test: exact if nothing were rounded.
pub fn meets_slabs(bounds: &Aabb, ray: &Ray) -> bool {
    let low = (bounds.min - ray.origin) / ray.direction;
    let high = (bounds.max - ray.origin) / ray.direction;
    let (enter, leave) = (low.min(high).max_element(), low.max(high).min_element());
    enter <= leave && leave >= 0.0
}
// ANCHOR_END: slabs

// ANCHOR: bounds
/// The box around everything, whatever it is made of: one NaN and it is no box.
pub fn bounds(triangles: &[[Vec3; 3]]) -> Aabb {
    let corners = triangles.iter().flatten();
    corners.fold(Aabb::EMPTY, |bounds, &corner| Aabb {
        min: bounds.min.min(corner),
        max: bounds.max.max(corner),
    })
}
// ANCHOR_END: bounds

// ANCHOR: midpoint
/// How deep a tree gets that always cuts the longest axis of its centres through the middle, down to
/// single things. None when it never ends: with one centre twice, one side stays empty for ever.
pub fn midpoint_depth(centers: &[Vec3]) -> Option<u32> {
    if centers.len() <= 1 {
        return Some(0);
    }
    let bounds = Aabb::of_points(centers.iter().copied());
    let (axis, middle) = (bounds.longest_axis(), bounds.center());
    let (left, right): (Vec<Vec3>, Vec<Vec3>) =
        centers.iter().partition(|center| center[axis] < middle[axis]);
    if left.is_empty() || right.is_empty() {
        return None;
    }
    Some(1 + midpoint_depth(&left)?.max(midpoint_depth(&right)?))
}
// ANCHOR_END: midpoint

/// Slabs of the textbook's heuristic.
const BINS: usize = 16;

// ANCHOR: plane
/// The textbook's binned surface area heuristic in plain `f32`: the axis and the slab from which on
/// things go to the right. None when no plane costs less than all others so far.
pub fn cheapest_plane(boxes: &[Aabb]) -> Option<(usize, usize)> {
    let centers = Aabb::of_points(boxes.iter().map(Aabb::center));
    let mut best = None;
    let mut least = f32::INFINITY;
    for (axis, plane) in (0..3).flat_map(|axis| (1..BINS).map(move |plane| (axis, plane))) {
        let bin = |bounds: &Aabb| {
            let along = bounds.center()[axis] - centers.min[axis];
            (along / centers.size()[axis] * BINS as f32) as usize
        };
        let cost = |side: &dyn Fn(usize) -> bool| {
            let inside = boxes.iter().filter(|bounds| side(bin(bounds).min(BINS - 1)));
            let (count, whole) = inside
                .fold((0, Aabb::EMPTY), |(count, whole), bounds| (count + 1, whole.union(*bounds)));
            count as f32 * whole.surface_area()
        };
        let cost = cost(&|bin| bin < plane) + cost(&|bin| bin >= plane);
        if cost < least {
            (least, best) = (cost, Some((axis, plane)));
        }
    }
    best
}
// ANCHOR_END: plane
