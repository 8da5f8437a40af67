//! What readers get wrong.

use boxes::aabb::Aabb;
use boxes::slab::BoxRay;
use bvh::node::Node;
use bvh::tree::Bvh;

use crate::{Ask, Children, Cloud, Cut, Hit, solutions};

pub(crate) fn first_of_the_list(Cloud { centers }: &Cloud) -> Vec<usize> {
    (0..centers.len() / 2).collect()
}

pub(crate) fn along_x(Cloud { centers }: &Cloud) -> Vec<usize> {
    let mut places: Vec<usize> = (0..centers.len()).collect();
    places.sort_by(|&a, &b| centers[a].x.total_cmp(&centers[b].x));
    places.truncate(centers.len() / 2);
    crate::sorted(places)
}

pub(crate) fn upper_half(cloud: &Cloud) -> Vec<usize> {
    let (lower, centers) = (solutions::lower_half(cloud), &cloud.centers);
    let upper: Vec<usize> = (0..centers.len()).filter(|place| !lower.contains(place)).collect();
    upper.into_iter().take(centers.len() / 2).collect()
}

pub(crate) fn below_the_middle(Cloud { centers }: &Cloud) -> Vec<usize> {
    let bounds = Aabb::of_points(centers.iter().copied());
    let (axis, middle) = (bounds.longest_axis(), bounds.center());
    (0..centers.len()).filter(|&place| centers[place][axis] < middle[axis]).collect()
}

fn weighed(case: &Cut, size: fn(&Aabb) -> f32) -> f32 {
    let side = |(bounds, count): &(Aabb, u32)| size(bounds) * *count as f32;
    case.step + (side(&case.sides[0]) + side(&case.sides[1])) / size(&case.node)
}

pub(crate) fn by_volume(case: &Cut) -> f32 {
    weighed(case, |bounds| bounds.size().element_product())
}

pub(crate) fn undivided(Cut { sides, step, .. }: &Cut) -> f32 {
    let side = |(bounds, count): &(Aabb, u32)| bounds.surface_area() * *count as f32;
    step + side(&sides[0]) + side(&sides[1])
}

pub(crate) fn without_counts(Cut { node, sides, step }: &Cut) -> f32 {
    step + (sides[0].0.surface_area() + sides[1].0.surface_area()) / node.surface_area()
}

pub(crate) fn two_pairs(case: &Cut) -> f32 {
    weighed(case, |bounds| bounds.size().y * (bounds.size().x + bounds.size().z))
}

/// The nearer of two hits.
fn better(one: Hit, other: Hit) -> Hit {
    solutions::nearer(&Children { left: one, right: other })
}

/// The nearest of a leaf's items below the limit.
fn of_leaf(tree: &Bvh, leaf: &Node, limit: f32, ask: Ask) -> Hit {
    let mut nearest = None;
    for &item in &tree.order[leaf.items()] {
        nearest = better(nearest, ask(item, limit).map(|t| (item, t)));
    }
    nearest
}

pub(crate) fn never_prunes(tree: &Bvh, ray: &BoxRay, ask: Ask) -> Hit {
    let mut nearest = None;
    let mut waiting = vec![0];
    while let Some(place) = waiting.pop() {
        let node = &tree.nodes[place];
        if ray.enter(&node.bounds, f32::INFINITY).is_none() {
            continue;
        }
        if node.is_leaf() {
            nearest = better(nearest, of_leaf(tree, node, f32::INFINITY, ask));
        } else {
            waiting.extend(node.children());
        }
    }
    nearest
}

/// The children that are met, the nearer one last.
fn met(tree: &Bvh, node: &Node, ray: &BoxRay, limit: f32) -> Vec<(usize, f32)> {
    let children = node.children().into_iter();
    let mut met: Vec<(usize, f32)> = children
        .filter_map(|child| Some((child, ray.enter(&tree.nodes[child].bounds, limit)?)))
        .collect();
    met.sort_by(|one, other| other.1.total_cmp(&one.1));
    met
}

pub(crate) fn in_any_order(tree: &Bvh, ray: &BoxRay, ask: Ask) -> Hit {
    let mut nearest: Hit = None;
    let mut waiting = vec![0];
    while let Some(place) = waiting.pop() {
        let limit = nearest.map_or(f32::INFINITY, |(_, t)| t);
        let node = &tree.nodes[place];
        if ray.enter(&node.bounds, limit).is_none() {
            continue;
        }
        if node.is_leaf() {
            nearest = better(nearest, of_leaf(tree, node, limit, ask));
        } else {
            waiting.extend(node.children());
        }
    }
    nearest
}

pub(crate) fn first_found(tree: &Bvh, ray: &BoxRay, ask: Ask) -> Hit {
    let mut waiting = vec![0];
    while let Some(place) = waiting.pop() {
        let node = &tree.nodes[place];
        if ray.enter(&node.bounds, f32::INFINITY).is_none() {
            continue;
        }
        if !node.is_leaf() {
            waiting.extend(node.children());
        } else if let Some(hit) = of_leaf(tree, node, f32::INFINITY, ask) {
            return Some(hit);
        }
    }
    None
}

pub(crate) fn near_child_only(tree: &Bvh, ray: &BoxRay, ask: Ask) -> Hit {
    fn below(tree: &Bvh, node: &Node, ray: &BoxRay, ask: Ask) -> Hit {
        if node.is_leaf() {
            return of_leaf(tree, node, f32::INFINITY, ask);
        }
        let children = met(tree, node, ray, f32::INFINITY);
        children.iter().rev().find_map(|(child, _)| below(tree, &tree.nodes[*child], ray, ask))
    }
    below(tree, &tree.nodes[0], ray, ask)
}

pub(crate) fn by_nearest(tree: &Bvh, ray: &BoxRay, t_max: f32, ask: Ask) -> bool {
    solutions::nearest(tree, ray, &mut |item, limit| ask(item, limit.min(t_max))).is_some()
}

pub(crate) fn by_nearest_of_all(tree: &Bvh, ray: &BoxRay, t_max: f32, ask: Ask) -> bool {
    solutions::nearest(tree, ray, ask).is_some_and(|(_, t)| t < t_max)
}

pub(crate) fn without_end(tree: &Bvh, ray: &BoxRay, _t_max: f32, ask: Ask) -> bool {
    solutions::is_hit(tree, ray, f32::INFINITY, ask)
}

pub(crate) fn asks_everybody(tree: &Bvh, _ray: &BoxRay, t_max: f32, ask: Ask) -> bool {
    tree.order.iter().any(|&item| ask(item, t_max).is_some())
}

pub(crate) fn one_path(tree: &Bvh, ray: &BoxRay, t_max: f32, ask: Ask) -> bool {
    let mut node = &tree.nodes[0];
    while !node.is_leaf() {
        let Some((child, _)) = met(tree, node, ray, t_max).pop() else { return false };
        node = &tree.nodes[child];
    }
    of_leaf(tree, node, t_max, ask).is_some()
}

pub(crate) fn published(Children { left, right }: &Children) -> Hit {
    let distance = |hit: &Hit| hit.map_or(f32::INFINITY, |(_, t)| t);
    if distance(left) < distance(right) { *left } else { *right }
}

pub(crate) fn left_of_two(Children { left, right }: &Children) -> Hit {
    published(&Children { left: *right, right: *left })
}

pub(crate) fn none_is_nearest(case: &Children) -> Hit {
    let Children { left, right } = case;
    if left.is_none() || right.is_none() { None } else { solutions::nearer(case) }
}

pub(crate) fn farther(case: &Children) -> Hit {
    let nearer = solutions::nearer(case);
    if nearer == case.left { case.right.or(nearer) } else { case.left.or(nearer) }
}

pub(crate) fn lower_number(Children { left, right }: &Children) -> Hit {
    [*left, *right].into_iter().flatten().min_by_key(|(item, _)| *item)
}
