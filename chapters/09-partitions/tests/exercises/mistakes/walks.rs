//! What readers get wrong of exercise 9.2.

use common::exercise::Mistake;
use glam::Vec3;

use crate::cases::Line;

/// Of exercise 9.2.
pub(crate) fn cells_along() -> Vec<Mistake<Line, Vec<[i32; 3]>>> {
    vec![
        Mistake {
            name: "the wrong axis",
            diagnosis: "You step along the axis whose border is farthest away. The line leaves its \
                        cell through the border it comes to first: take the least t.",
            answer: |line| {
                walk(line, forward, border, |leaves| {
                    let finite = leaves.to_array().map(|it| if it.is_finite() { it } else { -1.0 });
                    Vec3::from(finite).max_position()
                })
            },
        },
        Mistake {
            name: "upwards only",
            diagnosis: "You always step to the next higher cell. Along an axis on which the line \
                        runs down, step by -1.",
            answer: |line| walk(line, |_| 1, border, Vec3::min_position),
        },
        Mistake {
            name: "the border behind",
            diagnosis: "You take the border at the cell's lower end for a line that runs up. It \
                        leaves through the upper end: that is border cell + 1.",
            answer: |line| walk(line, forward, |cell, _| cell, Vec3::min_position),
        },
        Mistake {
            name: "minus zero",
            diagnosis: "You take -0 for a number above 0, but 1/-0 is minus infinity, so that border \
                        seems to be passed at once. Take the sign of the reciprocal. See 'From cell \
                        to cell'.",
            answer: |line| walk(line, not_below_zero, border, Vec3::min_position),
        },
        Mistake {
            name: "minus zero, then NaN",
            diagnosis: "You take -0 for a number above 0, but dividing by -0 gives minus infinity, so \
                        that border seems to be passed at once. Then you add the time for one cell, \
                        which is plus infinity, and have NaN. Take the sign of the reciprocal. See \
                        'From cell to cell'.",
            answer: |line| walk_by_adding(line, not_below_zero, Vec3::min_position),
        },
        Mistake {
            name: "minus zero, then NaN for the last axis",
            diagnosis: "You take -0 for a number above 0, but dividing by -0 gives minus infinity, so \
                        that border seems to be passed at once. Then you add plus infinity, the time \
                        for one cell: that is NaN, all your comparisons say no, and what is left is \
                        z. Take the sign of the reciprocal. See 'From cell to cell'.",
            answer: |line| walk_by_adding(line, not_below_zero, first_or_z),
        },
        Mistake {
            name: "plus zero",
            diagnosis: "You take 0 for a number below 0, and look for the border behind. Dividing by 0 \
                        gives minus infinity for it, so that it seems to be passed at once. Take the \
                        sign of the reciprocal. See 'From cell to cell'.",
            answer: |line| walk(line, above_zero, border, Vec3::min_position),
        },
        Mistake {
            name: "plus zero, then NaN",
            diagnosis: "You take 0 for a number below 0, and look for the border behind. Dividing by 0 \
                        gives minus infinity for it; then you add the time for one cell, which is \
                        plus infinity, and have NaN. Take the sign of the reciprocal. See 'From cell \
                        to cell'.",
            answer: |line| walk_by_adding(line, above_zero, Vec3::min_position),
        },
        Mistake {
            name: "plus zero, then NaN for the last axis",
            diagnosis: "You take 0 for a number below 0, and look for the border behind. Dividing by 0 \
                        gives minus infinity for it; then you add plus infinity, the time for one \
                        cell: that is NaN, all your comparisons say no, and what is left is z. Take \
                        the sign of the reciprocal. See 'From cell to cell'.",
            answer: |line| walk_by_adding(line, above_zero, first_or_z),
        },
    ]
}

fn not_below_zero(component: f32) -> i32 {
    if component >= 0.0 { 1 } else { -1 }
}

fn above_zero(component: f32) -> i32 {
    if component > 0.0 { 1 } else { -1 }
}

/// The least of three by a chain of questions, which all say no to NaN.
fn first_or_z(leaves: Vec3) -> usize {
    let Vec3 { x, y, z } = leaves;
    match () {
        () if x < y && x < z => 0,
        () if y < z => 1,
        () => 2,
    }
}

/// The walk that adds the time for one cell at each step, with parts to be replaced.
fn walk_by_adding(
    line: &Line,
    step: impl Fn(f32) -> i32,
    choose: impl Fn(Vec3) -> usize,
) -> Vec<[i32; 3]> {
    let step = line.direction.to_array().map(step);
    let mut cell = line.origin.floor().to_array().map(|it| it as i32);
    let mut leaves = [0, 1, 2].map(|axis| {
        let border = border(cell[axis], step[axis]) as f32;
        (border - line.origin[axis]) / line.direction[axis]
    });
    let one_cell = line.direction.abs().recip();
    let mut passed = Vec::new();
    while cell.iter().all(|index| (0..line.cells).contains(index)) && passed.len() < 100 {
        passed.push(cell);
        let axis = choose(leaves.into());
        cell[axis] += step[axis];
        leaves[axis] += one_cell[axis];
    }
    passed
}

fn forward(component: f32) -> i32 {
    if 1.0 / component > 0.0 { 1 } else { -1 }
}

fn border(cell: i32, step: i32) -> i32 {
    cell + i32::from(step > 0)
}

/// The walk with parts to be replaced. It gives up where a wrong one would go on for ever.
fn walk(
    line: &Line,
    step: impl Fn(f32) -> i32,
    border: impl Fn(i32, i32) -> i32,
    choose: impl Fn(Vec3) -> usize,
) -> Vec<[i32; 3]> {
    let step = line.direction.to_array().map(step);
    let mut cell = line.origin.floor().to_array().map(|it| it as i32);
    let mut passed = Vec::new();
    while cell.iter().all(|index| (0..line.cells).contains(index)) && passed.len() < 100 {
        passed.push(cell);
        let leaves = [0, 1, 2].map(|axis| {
            let border = border(cell[axis], step[axis]) as f32;
            (border - line.origin[axis]) / line.direction[axis]
        });
        let axis = choose(leaves.into());
        cell[axis] += step[axis];
    }
    passed
}
