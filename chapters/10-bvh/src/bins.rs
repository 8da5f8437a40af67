//! The split by surface area, tried at a few planes an axis.

use glam::{Vec4, Vec4Swizzles};

use crate::item::{Item, Span};

/// Slabs an axis is cut into at most; the planes between them are tried.
const MOST: usize = 16;
/// Slabs for sets of few items, where more would cost more than they save.
const FEW: usize = 8;

// ANCHOR: slabs
/// The slabs along each axis, all of the same width, and which of them an item belongs to.
///
/// The counting and the sorting both ask here. Two ways to compute the same would differ at some
/// plane's edge, and the sorted halves would not be those that were counted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slabs {
    count: usize,
    low: Vec4,
    scale: Vec4,
}

impl Slabs {
    /// The slabs across the centres' span, for `items` items.
    pub(crate) fn new(centers: &Span, items: usize) -> Self {
        let count = if items < 2 * MOST { FEW } else { MOST };
        Self { count, low: centers.low, scale: count as f32 / (centers.high - centers.low) }
    }

    /// Where along each axis a centre is, in slabs. NaN where all centres are one, for 0/0; where
    /// they all but are, the scale is infinite, and so is this.
    #[inline]
    fn place(&self, center: Vec4) -> Vec4 {
        (center - self.low) * self.scale
    }

    /// The slab at a place; always one there is. A cast from NaN gives 0, from infinity the largest.
    #[inline]
    fn at(&self, place: f32) -> usize {
        (place as i32 as usize).min(self.count - 1)
    }

    /// Whether an item is on the near side of a plane.
    #[inline]
    pub(crate) fn is_below(&self, item: &Item, plane: &Plane) -> bool {
        self.at(self.place(item.center())[plane.axis]) < plane.slab
    }
}
// ANCHOR_END: slabs

/// A plane to split at, and what that is expected to cost.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    /// The axis across which it lies.
    axis: usize,
    /// The first slab on its far side.
    slab: usize,
    /// The groups of items on both sides, each weighted by its side's part of the whole surface.
    pub(crate) cost: f32,
}

/// What lies in one slab, or in several.
#[derive(Clone, Copy, Debug)]
struct Bin {
    span: Span,
    count: u32,
}

const EMPTY: Bin = Bin { span: Span::EMPTY, count: 0 };

// ANCHOR: cheapest
/// The cheapest plane between slabs that leaves something on both sides. None when there is none.
///
/// Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies" (IEEE Symposium on
/// Interactive Ray Tracing, 2007). Items that are asked `together` cost as one.
pub(crate) fn cheapest(
    items: &[Item],
    bounds: &Span,
    slabs: &Slabs,
    together: u32,
) -> Option<Plane> {
    let weigh = Weigh::new(bounds, together);
    let mut bins = [[EMPTY; MOST]; 3];
    fill(&mut bins, items, slabs);
    let mut best: Option<Plane> = None;
    for (axis, bins) in bins.iter().enumerate() {
        let above = from_above(&bins[..slabs.count], &weigh);
        let mut below = EMPTY;
        for slab in 1..slabs.count {
            below.join(&bins[slab - 1]);
            let cost = weigh.cost(&below) + above[slab];
            let parts = below.count > 0 && (below.count as usize) < items.len();
            // A cost of NaN is below nothing.
            if parts && cost < best.map_or(f32::INFINITY, |best| best.cost) {
                best = Some(Plane { axis, slab, cost });
            }
        }
    }
    best
}

/// Sorts the items into the slabs of each axis.
fn fill([x, y, z]: &mut [[Bin; MOST]; 3], items: &[Item], slabs: &Slabs) {
    for item in items {
        let place = slabs.place(item.center());
        x[slabs.at(place.x)].add(item);
        y[slabs.at(place.y)].add(item);
        z[slabs.at(place.z)].add(item);
    }
}

/// The cost of everything from each slab on.
fn from_above(bins: &[Bin], weigh: &Weigh) -> [f32; MOST] {
    let mut costs = [0.0; MOST];
    let mut above = EMPTY;
    for (cost, bin) in costs.iter_mut().zip(bins).rev() {
        above.join(bin);
        *cost = weigh.cost(&above);
    }
    costs
}
// ANCHOR_END: cheapest

impl Bin {
    #[inline]
    fn add(&mut self, item: &Item) {
        self.span.add(item);
        self.count += 1;
    }

    #[inline]
    fn join(&mut self, other: &Self) {
        self.span.join(&other.span);
        self.count += other.count;
    }
}

// ANCHOR: weigh
/// Costs as parts of the whole node's.
struct Weigh {
    /// 1 over the node's longest half side.
    scale: f32,
    /// 1 over its surface, so scaled.
    whole: f32,
    /// Items asked together: two to this power.
    together: u32,
}

impl Weigh {
    /// For parts of the node with these bounds.
    ///
    /// The square of a length of 10²⁰ is infinite in `f32`, that of 10⁻²⁵ is 0, and then all planes
    /// cost the same (hard case AC-03). As parts of the longest side, lengths have squares.
    fn new(bounds: &Span, together: u32) -> Self {
        let longest = (0.5 * bounds.high - 0.5 * bounds.low).truncate().max_element();
        let together = together.ilog2();
        let unscaled = Self { scale: (1.0 / longest).min(f32::MAX), whole: 1.0, together };
        Self { whole: 1.0 / unscaled.surface(bounds), ..unscaled }
    }

    /// An eighth of the surface of a box, the longest side being 2.
    #[inline]
    fn surface(&self, span: &Span) -> f32 {
        let side = (0.5 * span.high - 0.5 * span.low) * self.scale;
        let faces = side * side.yzxw();
        faces.x + faces.y + faces.z
    }

    /// How likely it is that a ray that meets the node comes by, times what it is asked there.
    #[inline]
    fn cost(&self, bin: &Bin) -> f32 {
        if bin.count == 0 {
            return 0.0;
        }
        let groups = (bin.count + (1 << self.together) - 1) >> self.together;
        groups as f32 * self.surface(&bin.span) * self.whole
    }
}
// ANCHOR_END: weigh
