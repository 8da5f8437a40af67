//! The tree as a program wants it: two boxes at once, then four triangles at once.

use arrayvec::ArrayVec;
use boxes::aabb::Aabb;
use boxes::slab::{BOX_TESTS, BoxRay};
use common::tally::Tally;
use glam::Vec3;
use partitions::accelerator::{Accelerator, NODE_VISITS, Statistics};
use partitions::leaf::{Question, Stored};
use ray_casting::ray::Ray;
use triangles::area::has_area;
use triangles::brute::{Found, TRIANGLE_TESTS};
use triangles::intersect::TriangleTest;
use triangles::lanes::{FourRays, LANES, Pack};
use triangles::watertight::{Measured, ShearedRay};

use crate::build::{DEPTH, Recipe};
use crate::node::Node;
use crate::pairs::{Branch, MOST_GROUPS, Pair, PairRay};
use crate::tree::Bvh;

// ANCHOR: packed
/// Triangles in a tree.
#[derive(Clone, Debug)]
pub struct PackedBvh {
    pairs: Vec<Pair>,
    fours: Vec<Four>,
    /// None when there is nothing to hit.
    root: Option<Branch>,
    bounds: Aabb,
    statistics: Statistics,
}

/// Up to four triangles of a leaf, and their places in the list they came from.
#[derive(Clone, Copy, Debug)]
struct Four {
    pack: Pack,
    indices: [u32; LANES],
}
// ANCHOR_END: packed

/// The place of a triangle that isn't there; its lane repeats another one.
const NONE: u32 = u32::MAX;

/// A branch put aside, and where the ray enters its box.
type Waiting = ArrayVec<(Branch, f32), { DEPTH as usize }>;

/// The box of a triangle; empty when no ray can hit it, because it has no area or a corner that is
/// not finite. So the tree leaves it out (hard case AC-05), and nobody has to ask again.
pub(crate) fn hittable_bounds(corners: &[Vec3; 3]) -> Aabb {
    let [a, b, c] = *corners;
    if a.is_finite() && b.is_finite() && c.is_finite() && has_area(corners) {
        Aabb { min: a.min(b).min(c), max: a.max(b).max(c) }
    } else {
        Aabb::EMPTY
    }
}

impl PackedBvh {
    /// The tree over these triangles, each given by its corners.
    pub fn new(triangles: &[[Vec3; 3]], recipe: &Recipe) -> Self {
        let recipe = Recipe { leaf: recipe.leaf.min(LANES * MOST_GROUPS), ..*recipe };
        Self::pack(&recipe.build(triangles.iter().map(hittable_bounds)), triangles)
    }

    /// The tree in this layout.
    fn pack(tree: &Bvh, triangles: &[[Vec3; 3]]) -> Self {
        let mut fours = Vec::with_capacity(tree.nodes.len() / 2 + 1);
        let root = tree.nodes.first().map(|root| branch(root, &tree.order, triangles, &mut fours));
        let children = tree.nodes.get(1..).unwrap_or_default().chunks_exact(2);
        let pairs: Vec<Pair> = children
            .map(|two| {
                let mut lead = |at: usize| branch(&two[at], &tree.order, triangles, &mut fours);
                Pair::new([two[0].bounds, two[1].bounds], [lead(0), lead(1)])
            })
            .collect();
        let statistics = Statistics {
            triangles: triangles.len(),
            left_out: triangles.len() - tree.order.len(),
            references: tree.order.len(),
            nodes: tree.nodes.len(),
            depth: tree.depth() as usize,
            bytes: size_of_val(&pairs[..]) + size_of_val(&fours[..]),
        };
        Self { pairs, fours, root, bounds: tree.bounds(), statistics }
    }

    // ANCHOR: descend
    /// Takes the ray through the tree. `ask` puts its question to the triangles of a leaf, and gives
    /// the distance beyond which hits are of no more interest; None ends the search.
    ///
    /// Where both children are met, one is put aside. That is done once a level at most, so the
    /// stack can't overflow. `NEAR_FIRST` goes to the nearer one, and is worth its price when hits
    /// shorten the way.
    #[inline]
    fn descend<const NEAR_FIRST: bool, T: Tally>(
        &self,
        ray: &Ray,
        t_max: f32,
        tally: &mut T,
        mut ask: impl FnMut(&Four, &mut T) -> Option<f32>,
    ) {
        let Some(mut here) = self.root else { return };
        let ray = PairRay::new(&BoxRay::new(ray, &self.bounds));
        let mut waiting = Waiting::new();
        let mut limit = t_max;
        loop {
            tally.count(NODE_VISITS, 1);
            if let Some(place) = here.pair() {
                tally.count(BOX_TESTS, 2);
                let pair = &self.pairs[place];
                let [first, second] = pair.branches;
                let entered = ray.enter(pair, limit);
                if entered.which == 0b11 {
                    let [one, other] = entered.at;
                    let swap = NEAR_FIRST && other < one;
                    waiting.push(if swap { (first, one) } else { (second, other) });
                    here = if swap { second } else { first };
                    continue;
                }
                if entered.which != 0 {
                    here = pair.branches[entered.which as usize >> 1];
                    continue;
                }
            } else {
                for four in &self.fours[here.groups()] {
                    let Some(nearer) = ask(four, tally) else { return };
                    limit = nearer;
                }
            }
            // What was put aside may lie behind what was found since.
            here = loop {
                let Some((branch, enter)) = waiting.pop() else { return };
                if enter <= limit {
                    break branch;
                }
            };
        }
    }
    // ANCHOR_END: descend
}

/// What leads to a node; a leaf's triangles are added to `fours`.
fn branch(node: &Node, order: &[u32], triangles: &[[Vec3; 3]], fours: &mut Vec<Four>) -> Branch {
    if !node.is_leaf() {
        return Branch::to_pair(node.pair());
    }
    let place = fours.len();
    fours.extend(order[node.items()].chunks(LANES).map(|items| {
        let mut indices = [NONE; LANES];
        indices[..items.len()].copy_from_slice(items);
        let corners = [0, 1, 2, 3].map(|lane: usize| {
            let index = items.get(lane).unwrap_or(&items[0]);
            triangles[*index as usize]
        });
        Four { pack: Pack::new(&corners), indices }
    }));
    Branch::to_leaf(place, fours.len() - place)
}

impl Four {
    /// Counts the triangles it really has.
    #[inline]
    fn tell<T: Tally>(&self, tally: &mut T) {
        if let Some(counts) = tally.counts() {
            let triangles = self.indices.iter().filter(|&&index| index != NONE).count();
            counts.count(TRIANGLE_TESTS, triangles as u64);
        }
    }

    // ANCHOR: hits
    /// The next hit below `limit` among the candidates, which are a bit for each lane. Those that
    /// were asked are taken out.
    #[inline]
    fn next_hit(
        &self,
        candidates: &mut u32,
        ray: &Prepared,
        limit: f32,
    ) -> Option<(Measured, u32)> {
        while *candidates != 0 {
            let lane = candidates.trailing_zeros() as usize;
            *candidates &= *candidates - 1;
            let index = self.indices[lane];
            if index == NONE {
                continue;
            }
            let sheared = self.pack.sheared(lane, &ray.four);
            if let Some(measured) = ray.sheared.measure(sheared, limit) {
                return Some((measured, index));
            }
        }
        None
    }
    // ANCHOR_END: hits
}

/// A ray made ready for triangles.
struct Prepared {
    sheared: ShearedRay,
    four: FourRays,
}

impl Prepared {
    /// The ray, made ready when it comes to its first leaf, for many never do. None for one that hits
    /// nothing, whatever there is.
    #[inline]
    fn once<'a>(prepared: &'a mut Option<Self>, ray: &Ray) -> Option<&'a Self> {
        if prepared.is_none() {
            let sheared = ShearedRay::prepare(ray)?;
            *prepared = Some(Self { sheared, four: FourRays::new(&sheared) });
        }
        prepared.as_ref()
    }
}

impl Accelerator for PackedBvh {
    fn build(triangles: Vec<[Vec3; 3]>) -> Self {
        Self::new(&triangles, &Recipe::TRIANGLES)
    }

    fn walk<Q: Question, T: Tally>(&self, ray: &Ray, question: &mut Q, tally: &mut T) {
        self.descend::<true, T>(ray, question.limit(), tally, |four, tally| {
            for (lane, &index) in four.indices.iter().enumerate().filter(|(_, it)| **it != NONE) {
                let corners = four.pack.triangle(lane);
                question.ask_all(&[Stored { corners, index }], tally);
                if question.answered() {
                    return None;
                }
            }
            Some(question.limit())
        });
    }

    fn statistics(&self) -> Statistics {
        self.statistics
    }

    // ANCHOR: nearest
    /// The nearest hit. Of several at the same distance the one with the lowest index stands,
    /// whichever was met first: so the limit after a hit is the next number above its distance.
    #[inline]
    fn nearest<T: Tally>(&self, ray: &Ray, t_max: f32, tally: &mut T) -> Option<Found> {
        let (mut prepared, mut limit) = (None, t_max);
        let mut nearest: Option<(Measured, u32)> = None;
        self.descend::<true, T>(ray, t_max, tally, |four, tally| {
            four.tell(tally);
            let prepared = Prepared::once(&mut prepared, ray)?;
            let mut candidates = four.pack.candidates(&prepared.four);
            while let Some(found) = four.next_hit(&mut candidates, prepared, limit) {
                let (measured, index) = found;
                let earlier = |best: &(Measured, u32)| best.0.t == measured.t && best.1 < index;
                if !nearest.as_ref().is_some_and(earlier) {
                    nearest = Some(found);
                }
                limit = measured.t.next_up();
            }
            Some(limit)
        });
        nearest.map(|(measured, index)| Found { hit: measured.hit(), index: index as usize })
    }
    // ANCHOR_END: nearest

    // ANCHOR: any
    /// Whether there is any hit: the first one found ends the search, so no order is kept.
    #[inline]
    fn is_hit<T: Tally>(&self, ray: &Ray, t_max: f32, tally: &mut T) -> bool {
        let (mut prepared, mut hit) = (None, false);
        self.descend::<false, T>(ray, t_max, tally, |four, tally| {
            four.tell(tally);
            let prepared = Prepared::once(&mut prepared, ray)?;
            let mut candidates = four.pack.candidates(&prepared.four);
            hit = four.next_hit(&mut candidates, prepared, t_max).is_some();
            (!hit).then_some(t_max)
        });
        hit
    }
    // ANCHOR_END: any
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use common::tally::{Counts, Off};
    use glam::Vec3;
    use partitions::accelerator::{Accelerator, NODE_VISITS};
    use partitions::scan::Scan;
    use ray_casting::ray::Ray;
    use triangles::brute::TRIANGLE_TESTS;
    use triangles::bumpy;

    use super::PackedBvh;
    use crate::build::Recipe;
    use crate::split::Split;

    fn ray(trial: u64) -> Ray {
        let mut stream = Stream::of_trial(103, trial);
        let mut point = |side: f32| {
            let mut component = || stream.between(-side, side);
            Vec3::new(component(), component(), component())
        };
        let origin = point(2.0);
        Ray { origin, direction: point(0.9) - origin }
    }

    #[test]
    fn the_scan_s_answer_to_the_bit_with_leaves_of_any_size() {
        let corners = bumpy::sphere(1000).all_corners();
        let scan = Scan::build(corners.clone());
        for leaf in [1, 2, 4, 7, 64] {
            for split in [Split::Midpoint, Split::Median, Split::Sah] {
                let tree = PackedBvh::new(&corners, &Recipe { split, leaf, ..Recipe::TRIANGLES });
                for trial in 0..2000 {
                    let (ray, limit) = (ray(trial), [f32::INFINITY, 0.7][trial as usize % 2]);
                    let found = scan.nearest(&ray, limit, &mut Off);
                    assert_eq!(tree.nearest(&ray, limit, &mut Off), found, "{leaf} {trial}");
                    assert_eq!(tree.is_hit(&ray, limit, &mut Off), found.is_some());
                }
            }
        }
    }

    #[test]
    fn few_are_asked_and_any_hit_asks_fewer() {
        let tree = PackedBvh::build(bumpy::sphere(20_000).all_corners());
        let count = |ask: &dyn Fn(&Ray, &mut Counts)| {
            let mut counts = Counts::default();
            (0..1000).for_each(|trial| ask(&ray(trial), &mut counts));
            (counts.of(TRIANGLE_TESTS), counts.of(NODE_VISITS))
        };
        let nearest = count(&|ray, counts| {
            tree.nearest(ray, f32::INFINITY, counts);
        });
        let any = count(&|ray, counts| {
            tree.is_hit(ray, f32::INFINITY, counts);
        });
        assert!(
            nearest.0 < 30_000 && any.0 < nearest.0 && any.1 < nearest.1,
            "{nearest:?} {any:?}"
        );
    }

    #[test]
    fn nothing_is_found_in_nothing() {
        let nothing = PackedBvh::build(Vec::new());
        assert_eq!(nothing.nearest(&ray(1), f32::INFINITY, &mut Off), None);
        let flat = PackedBvh::build(vec![[Vec3::ONE; 3], [Vec3::NAN; 3]]);
        assert!(!flat.is_hit(&ray(1), f32::INFINITY, &mut Off));
        assert_eq!((flat.statistics().left_out, flat.statistics().nodes), (2, 0));
        let nowhere = Ray { origin: Vec3::ZERO, direction: Vec3::ZERO };
        let tree = PackedBvh::build(bumpy::sphere(60).all_corners());
        assert_eq!(tree.nearest(&nowhere, f32::INFINITY, &mut Off), None);
        assert_eq!(tree.nearest(&ray(1), f32::NAN, &mut Off), None);
    }
}
