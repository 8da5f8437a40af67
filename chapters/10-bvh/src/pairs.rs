//! Both children at once: the tree in a layout the processor likes.

use boxes::aabb::Aabb;
use boxes::slab::{BoxRay, FaceRay};
use glam::{Vec4, Vec4Swizzles};

/// Where a branch of the tree leads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Branch(u32);

const LEAF: u32 = 1 << 31;
const GROUPS: u32 = 27;

impl Branch {
    /// To the pair at this place.
    pub(crate) fn to_pair(place: usize) -> Self {
        Self(place as u32)
    }
    /// To `count` groups of items, 1 to 16, from this place on.
    pub(crate) fn to_leaf(place: usize, count: usize) -> Self {
        Self(LEAF | (count as u32 - 1) << GROUPS | place as u32)
    }
    #[inline]
    pub(crate) fn pair(self) -> Option<usize> {
        (self.0 & LEAF == 0).then_some(self.0 as usize)
    }
    #[inline]
    pub(crate) fn groups(self) -> std::ops::Range<usize> {
        let place = (self.0 & ((1 << GROUPS) - 1)) as usize;
        let count = ((self.0 & !LEAF) >> GROUPS) as usize;
        place..place + count + 1
    }
}

/// Two boxes side by side, and where they lead.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub(crate) struct Pair {
    /// For each axis: the lower planes of both, and the upper planes of both, negated.
    pub(crate) planes: [Vec4; 3],
    pub(crate) branches: [Branch; 2],
}

impl Pair {
    pub(crate) fn new(boxes: [Aabb; 2], branches: [Branch; 2]) -> Self {
        let [a, b] = boxes;
        let planes = [0, 1, 2]
            .map(|axis| Vec4::new(a.min[axis], b.min[axis], -a.max[axis], -b.max[axis]));
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

impl PairRay {
    /// The same as `ray`, in the layout of a [`Pair`].
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
            downward: [0, 1, 2].map(|axis| downward.test(axis)),
        }
    }

    /// Where both boxes are entered, and which are, a bit for each.
    #[inline(always)]
    pub(crate) fn enter(&self, pair: &Pair, t_max: f32) -> (Vec4, u32) {
        let [x, y, z] = [0, 1, 2].map(|axis| {
            let passed = (pair.planes[axis] - self.origin[axis]) * self.inverse[axis];
            if self.downward[axis] { passed.zwxy() } else { passed }
        });
        let last = x.max(y).max(z.max(Vec4::new(0.0, 0.0, -t_max, -t_max)));
        (last, last.cmple(-last.zwxy()).bitmask() & 3)
    }
}
