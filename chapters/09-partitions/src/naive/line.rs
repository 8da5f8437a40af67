//! A grid walked along a line without a width, as it is commonly printed.

use common::tally::Off;
use glam::Vec3;
use ray_casting::ray::Ray;
use triangles::brute::Found;

use crate::cells::Side;
use crate::grid::Grid;
use crate::leaf::{NearestHit, Question};

/// When the walk ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// With the first hit, whichever cell it is in.
    AtFirstHit,
    /// With a hit that is in the cell where it was found.
    AtHitInCell,
}

// ANCHOR: line
/// The nearest hit, cell by cell along a line.
///
/// Four mistakes are in it. A triangle that reaches into this cell may be hit in a later one, behind
/// another that isn't in this cell (hard case AC-01). The sign of -0 is taken for that of a number
/// above 0, and 1/-0 is not (AC-10). The places of borders are summed up. And the line has no width.
pub fn along_a_line(grid: &Grid, ray: &Ray, stop: Stop) -> Option<Found> {
    let (bounds, sides) = (grid.bounds(), grid.sides());
    let mut question = NearestHit::new(ray, f32::INFINITY)?;
    let inverse = 1.0 / ray.direction;
    let (one, other) = ((bounds.min - ray.origin) * inverse, (bounds.max - ray.origin) * inverse);
    let enter = one.min(other).max_element().max(0.0);
    if !(enter <= one.max(other).min_element()) {
        return None;
    }
    let mut line = Line::new(sides, ray, inverse, enter);
    loop {
        question.ask_all(grid.cell(line.cell), &mut Off);
        let leaves = line.next.min_element();
        let hit = question.found().filter(|it| stop == Stop::AtFirstHit || it.hit.t <= leaves);
        if hit.is_some() || !line.step(sides) {
            return hit;
        }
    }
}
// ANCHOR_END: line

/// Where a line is, and where along each axis it leaves its cell.
struct Line {
    cell: [i32; 3],
    step: [i32; 3],
    next: Vec3,
    delta: Vec3,
}

impl Line {
    fn new(sides: &[Side; 3], ray: &Ray, inverse: Vec3, enter: f32) -> Self {
        let axes = [0, 1, 2];
        let place = ray.at(enter);
        let cell = axes.map(|axis| sides[axis].index(place[axis]));
        let step = axes.map(|axis| if ray.direction[axis] >= 0.0 { 1 } else { -1 });
        let border = |axis: usize| cell[axis] + i32::from(step[axis] > 0);
        let next =
            axes.map(|axis| sides[axis].border(border(axis), ray.origin[axis]) * inverse[axis]);
        let delta = axes.map(|axis| sides[axis].cell * inverse[axis].abs());
        Self { cell, step, next: next.into(), delta: delta.into() }
    }

    /// Goes on to the next cell; false when that is outside.
    fn step(&mut self, sides: &[Side; 3]) -> bool {
        let axis = self.next.min_position();
        self.cell[axis] += self.step[axis];
        self.next[axis] += self.delta[axis];
        (0..sides[axis].count).contains(&self.cell[axis])
    }
}
