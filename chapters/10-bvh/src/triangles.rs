//! A tree over triangles.
use boxes::aabb::Aabb;
use boxes::slab::BoxRay;
use glam::Vec3;
use ray_casting::ray::Ray;
use triangles::area::has_area;
use triangles::brute::Found;
use triangles::intersect::TriangleTest;
use triangles::lanes::{FourRays, LANES, Pack};
use triangles::watertight::ShearedRay;

use crate::build::{Recipe, DEPTH};
use crate::pairs::{Branch, Pair, PairRay};

#[derive(Clone, Copy, Debug)]
struct Group {
    pack: Pack,
    index: [u32; LANES],
}
const NONE: u32 = u32::MAX;

/// Triangles in a tree.
pub struct TriangleBvh {
    pairs: Vec<Pair>,
    groups: Vec<Group>,
    root: Option<Branch>,
    bounds: Aabb,
}

impl TriangleBvh {
    pub fn new(corners: &[[Vec3; 3]], recipe: &Recipe) -> Self {
        let empty = Aabb { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };
        let boxes = corners.iter().map(|triangle| {
            if has_area(triangle) {
            let [a, b, c] = *triangle;
            Aabb { min: a.min(b).min(c), max: a.max(b).max(c) } } else { empty }
        });
        let tree = recipe.build(boxes);
        let mut groups = Vec::with_capacity(tree.nodes.len()/2+1);
        let mut branch = |node: &crate::node::Node| {
            if !node.is_leaf() { return Branch::to_pair((node.first as usize - 1) / 2); }
            let place = groups.len();
            for items in tree.order[node.items()].chunks(LANES) {
                let mut index = [NONE; LANES];
                index[..items.len()].copy_from_slice(items);
                let first = corners[items[0] as usize];
                let four = index.map(|index| corners.get(index as usize).copied().unwrap_or(first));
                groups.push(Group { pack: Pack::new(&four), index });
            }
            Branch::to_leaf(place, groups.len() - place)
        };
        let root = tree.nodes.first().map(&mut branch);
        let pairs = tree.nodes.get(1..).unwrap_or(&[]).chunks(2).map(|two| {
            Pair::new([two[0].bounds, two[1].bounds], [branch(&two[0]), branch(&two[1])])
        }).collect();
        Self { pairs, groups, root, bounds: tree.bounds().unwrap_or(empty) }
    }

    pub fn bytes(&self) -> usize {
        self.pairs.len() * size_of::<Pair>() + self.groups.len() * size_of::<Group>()
    }
    pub fn sizes(&self) -> (usize, usize) { (self.pairs.len(), self.groups.len()) }

    pub fn nearest(&self, ray: &Ray, t_max: f32) -> Option<Found> {
        let sheared = ShearedRay::prepare(ray)?;
        let root = self.root?;
        let boxes = PairRay::new(&BoxRay::new(ray, &self.bounds));
        let sheared = &sheared;
        let four = FourRays::new(sheared);
        let mut stack = arrayvec::ArrayVec::<(Branch, f32), { DEPTH as usize }>::new();
        let mut limit = t_max;
        let mut best: Option<Found> = None;
        let mut here = root;
        loop {
            if let Some(place) = here.pair() {
                let pair = &self.pairs[place];
                let (times, entered) = boxes.enter(pair, limit);
                let [a, b] = pair.branches;
                if entered == 3 {
                    let first = times.x <= times.y;
                    let (near, far) = if first { (a, b) } else { (b, a) };
                    stack.push((far, if first { times.y } else { times.x }));
                    here = near;
                    continue;
                }
                if entered != 0 {
                    here = if entered == 1 { a } else { b };
                    continue;
                }
            } else {
                for group in &self.groups[here.groups()] {
                    let mut candidates = group.pack.candidates(&four);
                    while candidates != 0 {
                        let lane = candidates.trailing_zeros() as usize;
                        candidates &= candidates - 1;
                        let index = group.index[lane];
                        if index == NONE { continue; }
                        if let Some(hit) = sheared.measure(group.pack.sheared(lane, &four), limit) {
                            let index = index as usize;
                            if best.is_none_or(|best| hit.t < best.hit.t || index < best.index) {
                                limit = hit.t.next_up();
                                best = Some(Found { hit, index });
                            }
                        }
                    }
                }
            }
            loop {
                let Some((waiting, enter)) = stack.pop() else { return best };
                if enter < limit { here = waiting; break; }
            }
        }
    }
}
