//! Both children at once: the tree in a layout the processor likes.

use std::ops::Range;

use boxes::aabb::Aabb;
use boxes::slab::{BoxRay, FaceRay};
use glam::{Vec4, Vec4Swizzles};

/// Where a branch of the tree leads: to a pair of nodes, or to the groups of items in a leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Branch(u32);

/// The bit that says that it is a leaf.
const LEAF: u32 = 1 << 31;
/// The bits for the place of a leaf's first group.
const PLACE: u32 = 27;
/// The most groups in a leaf: what four bits can count.
pub(crate) const MOST_GROUPS: usize = 16;

impl Branch {
    /// To the pair at this place.
    pub(crate) fn to_pair(place: usize) -> Self {
        Self(place as u32)
    }

    /// To 1 to [`MOST_GROUPS`] groups of items, from this place on.
    pub(crate) fn to_leaf(place: usize, count: usize) -> Self {
        debug_assert!((1..=MOST_GROUPS).contains(&count) && place < 1 << PLACE);
        Self(LEAF | (count as u32 - 1) << PLACE | place as u32)
    }

    /// The place of the pair, if it leads to one.
    #[inline]
    pub(crate) fn pair(self) -> Option<usize> {
        (self.0 & LEAF == 0).then_some(self.0 as usize)
    }

    /// The places of the leaf's groups, if it leads to some.
    #[inline]
    pub(crate) fn groups(self) -> Range<usize> {
        let place = (self.0 & ((1 << PLACE) - 1)) as usize;
        let more = ((self.0 & !LEAF) >> PLACE) as usize;
        place..place + more + 1
    }
}

// ANCHOR: pair
/// The boxes of two children, side by side, and where they lead. It fills one line of the
/// processor's cache: whoever reads a part of it has the whole.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub(crate) struct Pair {
    /// For each axis the least coordinates of both boxes, then the greatest of both, negated.
    planes: [Vec4; 3],
    /// Where they lead.
    pub(crate) branches: [Branch; 2],
}
// ANCHOR_END: pair

impl Pair {
    /// Two boxes and where they lead.
    pub(crate) fn new([a, b]: [Aabb; 2], branches: [Branch; 2]) -> Self {
        let planes =
            [0, 1, 2].map(|axis| Vec4::new(a.min[axis], b.min[axis], -a.max[axis], -b.max[axis]));
        Self { planes, branches }
    }
}

/// A ray made ready to be tested against two boxes at once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PairRay {
    origin: [Vec4; 3],
    inverse: [Vec4; 3],
    downward: [bool; 3],
}

/// What a ray does with two boxes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Entered {
    /// Where it enters them.
    pub(crate) at: [f32; 2],
    /// Which of them it meets, a bit for each.
    pub(crate) which: u32,
}

impl PairRay {
    /// The same ray in the layout of a [`Pair`].
    #[inline]
    pub(crate) fn new(ray: &BoxRay) -> Self {
        let FaceRay { downward, min_origin, max_origin, min_inverse, max_inverse } = ray.by_face();
        let both = |min: Vec4, max: Vec4| {
            [
                Vec4::new(min.x, min.x, max.x, max.x),
                Vec4::new(min.y, min.y, max.y, max.y),
                Vec4::new(min.z, min.z, max.z, max.z),
            ]
        };
        Self {
            origin: both(min_origin, -max_origin),
            inverse: both(min_inverse.abs(), max_inverse.abs()),
            downward: [downward.test(0), downward.test(1), downward.test(2)],
        }
    }

    // ANCHOR: enter
    /// What [`BoxRay::enter`] says of both boxes.
    ///
    /// With the far planes negated, a lane holds where the ray enters a slab, or minus where it
    /// leaves it, and one maximum finds both the last entry and the first exit. A ray that runs
    /// downwards meets the upper plane first: there the halves change places.
    #[inline]
    pub(crate) fn enter(&self, pair: &Pair, t_max: f32) -> Entered {
        let passed = |axis: usize| {
            let passed = (pair.planes[axis] - self.origin[axis]) * self.inverse[axis];
            if self.downward[axis] { passed.zwxy() } else { passed }
        };
        let (x, y, z) = (passed(0), passed(1), passed(2));
        let ends = Vec4::new(0.0, 0.0, -t_max, -t_max);
        let last = x.max(y).max(z.max(ends));
        let which = last.cmple(-last.zwxy()).bitmask() & 0b11;
        Entered { at: [last.x, last.y], which }
    }
    // ANCHOR_END: enter
}

#[cfg(test)]
mod tests {
    use boxes::aabb::Aabb;
    use boxes::slab::BoxRay;
    use common::sampler::Stream;
    use glam::Vec3;
    use ray_casting::ray::Ray;

    use super::{Branch, Pair, PairRay};

    #[test]
    fn a_pair_fills_a_cache_line() {
        assert_eq!((size_of::<Pair>(), align_of::<Pair>()), (64, 64));
    }

    #[test]
    fn a_branch_says_where_it_leads() {
        assert_eq!(Branch::to_pair(12_345).pair(), Some(12_345));
        for (place, count) in [(0, 1), (7, 3), ((1 << 27) - 1, 16)] {
            let leaf = Branch::to_leaf(place, count);
            assert_eq!((leaf.pair(), leaf.groups()), (None, place..place + count));
        }
    }

    /// Both boxes get the answer that each gets alone, to the bit, from every direction.
    #[test]
    fn two_at_once_are_one_and_one() {
        let mut met = 0;
        for trial in 0..100_000 {
            let mut stream = Stream::of_trial(102, trial);
            let mut point = |side: f32| {
                let mut component = || stream.between(-side, side).round();
                Vec3::new(component(), component(), component())
            };
            let boxes = [0, 1].map(|_| Aabb::of_points([point(3.0), point(3.0)]));
            let scene = boxes[0].union(boxes[1]);
            // Whole numbers: many rays run along an axis, or in a face.
            let ray = Ray { origin: point(5.0), direction: point(2.0) };
            let ray = BoxRay::new(&ray, &scene);
            let t_max = if trial % 3 == 0 { 2.0 } else { f32::INFINITY };
            if ray.enter(&scene, f32::INFINITY).is_none() {
                continue;
            }
            let pair = Pair::new(boxes, [Branch::to_pair(0); 2]);
            let entered = PairRay::new(&ray).enter(&pair, t_max);
            for (number, bounds) in boxes.iter().enumerate() {
                let expected = ray.enter(bounds, t_max);
                let found = (entered.which >> number & 1 == 1).then_some(entered.at[number]);
                assert_eq!(found, expected, "{trial} {number}");
                met += u32::from(found.is_some());
            }
        }
        assert!(met > 10_000, "{met}");
    }
}
