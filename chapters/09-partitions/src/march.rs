//! The way of a wide ray through the cells of a grid: each cell once, nearer ones first.
//!
//! After Amanatides and Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing" (Eurographics
//! 1987): the next border is the nearest of three, one for each axis. Theirs is for a line. A wide
//! ray has a front edge and a back edge along each axis, and is in all the cells between the two.

use boxes::aabb::Aabb;

use crate::cells::Side;
use crate::wide::{Track, WideRay};

// ANCHOR: lane
/// Where the ray is along one axis: in the cells from that of its back edge to that of its front.
#[derive(Clone, Copy, Debug)]
struct Lane {
    back: i32,
    front: i32,
    /// Where on the ray the back edge leaves its cell, and the front edge its own.
    back_leaves: f32,
    front_leaves: f32,
    /// 1 or -1, and the cell after which there are no more.
    step: i32,
    last: i32,
    /// From the ray's origin, moved to its back edge or front edge, to where cell 0 begins.
    back_offset: f32,
    front_offset: f32,
    cell: f32,
    inverse: f32,
}

impl Lane {
    /// The cells along `side` of a ray that is `start` along its longest axis.
    fn new(side: &Side, track: &Track, start: f32) -> Self {
        let (step, last) = if track.ascends() { (1, side.count - 1) } else { (-1, 0) };
        let (place, ahead) = (track.origin + start * track.slope, step as f32 * track.width);
        let offset = side.low - track.origin;
        let mut lane = Self {
            back: side.index(place - ahead),
            front: side.index(place + ahead),
            back_leaves: 0.0,
            front_leaves: 0.0,
            step,
            last,
            back_offset: offset + ahead,
            front_offset: offset - ahead,
            cell: side.cell,
            inverse: track.inverse,
        };
        lane.back_leaves = lane.leaves(lane.back, lane.back_offset);
        lane.front_leaves = lane.leaves(lane.front, lane.front_offset);
        lane
    }

    /// Where an edge of the ray leaves cell `index`; infinite where it never does. It is found anew
    /// from the cell's number: a sum of steps would add up their roundings.
    #[inline]
    fn leaves(&self, index: i32, offset: f32) -> f32 {
        if index == self.last || self.inverse.is_infinite() {
            return f32::INFINITY;
        }
        let border = index + i32::from(self.step > 0);
        (offset + border as f32 * self.cell) * self.inverse
    }
    // ANCHOR_END: lane

    // ANCHOR: lane_steps
    /// The front edge enters the next cell. No number of floats can keep it from the last.
    #[inline]
    fn advance(&mut self) {
        self.front += self.step;
        self.front_leaves = self.leaves(self.front, self.front_offset);
    }

    /// Gives up the cells in which nothing of the ray is any more at `place`.
    #[inline]
    fn draw_up(&mut self, place: f32) {
        while self.back_leaves < place && self.back != self.front {
            self.back += self.step;
            self.back_leaves = self.leaves(self.back, self.back_offset);
        }
    }
    // ANCHOR_END: lane_steps

    #[inline]
    fn cells(&self) -> [i32; 2] {
        [self.back.min(self.front), self.back.max(self.front)]
    }
}

// ANCHOR: march
/// The way of a wide ray through a grid.
#[derive(Clone, Copy, Debug)]
pub struct March {
    lanes: [Lane; 3],
    end: f32,
    started: bool,
}

impl March {
    /// The way of `ray` through what is within `bounds`, cut into cells along three sides, for hits
    /// at a `t` up to `t_max`. None when the ray can't hit anything there.
    pub fn start(ray: &WideRay, bounds: &Aabb, sides: &[Side; 3], t_max: f32) -> Option<Self> {
        let part = ray.within(bounds, t_max);
        let lane = |axis| Lane::new(&sides[axis], &ray.track(axis), part.from);
        (!part.is_empty()).then(|| Self {
            lanes: [0, 1, 2].map(lane),
            end: part.to,
            started: false,
        })
    }

    /// The cells that the ray comes to next; None when there are no more. The first are those it
    /// starts in, one as a rule. After them the front edge that leaves its cell first goes on to the
    /// next, and comes to all cells there that the ray is in along the two other axes.
    ///
    /// A step takes one of three integers closer to its last value, so there are fewer steps than
    /// cells along the three sides together, whatever the ray (hard case AC-08).
    #[inline]
    pub fn next_cells(&mut self) -> Option<Cells> {
        if !self.started {
            self.started = true;
            return Some(Cells::between(self.cells()));
        }
        let axis = self.first_to_leave();
        let place = self.lanes[axis].front_leaves;
        if !(place <= self.end) {
            return None;
        }
        self.lanes[axis].advance();
        for lane in &mut self.lanes {
            lane.draw_up(place);
        }
        let mut cells = self.cells();
        cells[axis] = [self.lanes[axis].front; 2];
        Some(Cells::between(cells))
    }
    // ANCHOR_END: march

    /// The cells that the ray is in along each axis: from these to those.
    #[inline]
    fn cells(&self) -> [[i32; 2]; 3] {
        [0, 1, 2].map(|axis| self.lanes[axis].cells())
    }

    /// Makes the way end at `place` along the ray's longest axis, if it doesn't end before.
    #[inline]
    pub fn end_at(&mut self, place: f32) {
        self.end = self.end.min(place);
    }

    /// The axis along which the front edge leaves its cell first.
    #[inline]
    fn first_to_leave(&self) -> usize {
        let [x, y, z] = [0, 1, 2].map(|axis| self.lanes[axis].front_leaves);
        match () {
            () if x < y && x < z => 0,
            () if y < z => 1,
            () => 2,
        }
    }
}

/// A block of cells, by their indices.
#[derive(Clone, Copy, Debug)]
pub struct Cells {
    low: [i32; 3],
    high: [i32; 3],
    next: [i32; 3],
}

impl Cells {
    #[inline]
    fn between(ends: [[i32; 2]; 3]) -> Self {
        let low = ends.map(|[low, _]| low);
        Self { low, high: ends.map(|[_, high]| high), next: low }
    }
}

impl Iterator for Cells {
    type Item = [i32; 3];

    #[inline]
    fn next(&mut self) -> Option<[i32; 3]> {
        let cell = self.next;
        if cell[2] > self.high[2] {
            return None;
        }
        self.next[0] += 1;
        for axis in 0..2 {
            if self.next[axis] > self.high[axis] {
                self.next[axis] = self.low[axis];
                self.next[axis + 1] += 1;
            }
        }
        Some(cell)
    }
}
