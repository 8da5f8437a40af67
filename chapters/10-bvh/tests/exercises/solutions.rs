//! One right answer to each exercise.

use boxes::aabb::Aabb;
use boxes::slab::BoxRay;
use bvh::tree::Bvh;

use crate::{Ask, Children, Cloud, Cut, Hit};

pub(crate) fn lower_half(Cloud { centers }: &Cloud) -> Vec<usize> {
    let axis = Aabb::of_points(centers.iter().copied()).longest_axis();
    let mut places: Vec<usize> = (0..centers.len()).collect();
    places.sort_by(|&a, &b| centers[a][axis].total_cmp(&centers[b][axis]));
    places.truncate(centers.len() / 2);
    places
}

pub(crate) fn cost_of_cut(Cut { node, sides, step }: &Cut) -> f32 {
    let side = |(bounds, count): &(Aabb, u32)| bounds.surface_area() * *count as f32;
    step + (side(&sides[0]) + side(&sides[1])) / node.surface_area()
}

pub(crate) fn nearest(tree: &Bvh, ray: &BoxRay, ask: Ask) -> Hit {
    let mut nearest: Hit = None;
    let mut waiting = vec![(0, 0.0)];
    while let Some((place, entered)) = waiting.pop() {
        let limit = nearest.map_or(f32::INFINITY, |(_, t)| t);
        let Some(node) = tree.nodes.get(place).filter(|_| entered <= limit) else { continue };
        if node.is_leaf() {
            for &item in &tree.order[node.items()] {
                let limit = nearest.map_or(f32::INFINITY, |(_, t)| t);
                nearest = ask(item, limit).map(|t| (item, t)).or(nearest);
            }
            continue;
        }
        let mut met: Vec<(usize, f32)> = node
            .children()
            .into_iter()
            .filter_map(|child| Some((child, ray.enter(&tree.nodes[child].bounds, limit)?)))
            .collect();
        met.sort_by(|one, other| other.1.total_cmp(&one.1));
        waiting.extend(met);
    }
    nearest
}

pub(crate) fn is_hit(tree: &Bvh, ray: &BoxRay, t_max: f32, ask: Ask) -> bool {
    let mut waiting = vec![0];
    while let Some(node) = waiting.pop().and_then(|place| tree.nodes.get(place)) {
        if ray.enter(&node.bounds, t_max).is_none() {
            continue;
        }
        if !node.is_leaf() {
            waiting.extend(node.children());
        } else if tree.order[node.items()].iter().any(|&item| ask(item, t_max).is_some()) {
            return true;
        }
    }
    false
}

pub(crate) fn nearer(Children { left, right }: &Children) -> Hit {
    match (*left, *right) {
        (Some(left), Some(right)) => {
            let first = left.1 < right.1 || left.1 == right.1 && left.0 < right.0;
            Some(if first { left } else { right })
        }
        (left, right) => left.or(right),
    }
}
