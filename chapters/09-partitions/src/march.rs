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

#[cfg(test)]
mod tests {
    use boxes::aabb::Aabb;
    use common::sampler::Stream;
    use glam::Vec3;
    use ray_casting::ray::Ray;

    use super::March;
    use crate::cells::Side;
    use crate::wide::WideRay;

    const BOUNDS: Aabb = Aabb { min: Vec3::new(-3.0, 1.0, 5.0), max: Vec3::new(3.0, 5.0, 7.0) };

    /// Cells of edge 1: six by four by two.
    fn sides() -> [Side; 3] {
        let count = BOUNDS.size().to_array().map(|size| size as i32);
        [0, 1, 2].map(|axis| Side::new(BOUNDS.min[axis], BOUNDS.max[axis], count[axis]))
    }

    fn cells(ray: &WideRay, t_max: f32) -> (Vec<[i32; 3]>, usize) {
        let Some(mut march) = March::start(ray, &BOUNDS, &sides(), t_max) else {
            return (Vec::new(), 0);
        };
        let (mut cells, mut steps) = (Vec::new(), 0);
        while let Some(next) = march.next_cells() {
            cells.extend(next);
            steps += 1;
        }
        (cells, steps)
    }

    #[test]
    fn a_way_by_hand() {
        // In at the left, at a height of 1.6, and up by a third for each cell to the right.
        let ray = Ray { origin: Vec3::new(-4.0, 1.2666, 6.5), direction: Vec3::new(3.0, 1.0, 0.0) };
        let (cells, steps) = cells(&WideRay::new(&ray, &BOUNDS), f32::INFINITY);
        let expected = [[0, 0], [1, 0], [1, 1], [2, 1], [3, 1], [4, 1], [4, 2], [5, 2]];
        assert_eq!(cells, expected.map(|[x, y]| [x, y, 1]));
        assert_eq!(steps, 8);
    }

    #[test]
    fn a_limit_ends_it_and_a_miss_has_no_way() {
        let ray = Ray { origin: Vec3::new(-4.0, 1.5, 5.5), direction: Vec3::X };
        assert_eq!(cells(&WideRay::new(&ray, &BOUNDS), 2.5).0.len(), 2);
        let away = Ray { direction: -Vec3::X, ..ray };
        assert_eq!(cells(&WideRay::new(&away, &BOUNDS), f32::INFINITY).1, 0);
    }

    /// AC-10: along an edge that four cells share, whatever the signs of the zeros, both ways.
    #[test]
    fn along_an_edge_between_cells_all_four_are_passed() {
        for (x, y, z) in [(1.0, 0.0, 0.0), (1.0, -0.0, 0.0), (-1.0, 0.0, -0.0), (-1.0, -0.0, -0.0)]
        {
            let direction = Vec3::new(x, y, z);
            let ray = Ray { origin: Vec3::new(-9.0 * x, 2.0, 6.0), direction };
            let (cells, _) = cells(&WideRay::new(&ray, &BOUNDS), f32::INFINITY);
            assert_eq!(cells.len(), 24, "{direction:?}");
            assert!(cells.iter().all(|[_, y, _]| *y < 2));
        }
    }

    /// AC-08: each cell once, in few steps, for rays of any width; and a wider ray passes all cells
    /// that a narrower one does.
    #[test]
    fn no_cell_twice_and_no_more_steps_than_cells_along_the_sides() {
        for trial in 0..50_000 {
            let mut stream = Stream::of_trial(921, trial);
            let mut point = || Vec3::from([0, 1, 2].map(|_| stream.between(-8.0, 9.0)));
            let mut ray = Ray { origin: point().round(), direction: point().round() };
            ray.direction *= [1.0, 1e-20, 1e30][trial as usize % 3];
            if ray.direction == Vec3::ZERO {
                continue;
            }
            let mut last = 0;
            for width in [1e-5, 0.1, 0.7, 3.0, f32::INFINITY] {
                let (mut cells, steps) = cells(&WideRay::of_width(&ray, width), f32::INFINITY);
                assert!(steps <= 6 + 4 + 2 + 3 && cells.len() >= last, "{ray:?}");
                last = cells.len();
                cells.sort_unstable();
                cells.dedup();
                assert_eq!(cells.len(), last, "{ray:?}");
            }
        }
    }
}
