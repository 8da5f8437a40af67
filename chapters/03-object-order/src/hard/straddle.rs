//! RA-03: triangles that reach behind the eye.

use common::sampler::Stream;

use crate::clip::Volume;
use crate::edge::{covers, edges};
use crate::fixed::{Fixed, STEPS};
use crate::naive::divided_covers;
use crate::project::FilmPoint;

/// Whole numbers, so that an exact answer exists: x and y are film coordinates times w.
struct Straddling {
    corners: [[i64; 3]; 3],
    /// In 1/256 pixel.
    sample: Fixed,
}

const VOLUME: Volume = Volume { near: 0.25 };

fn straddling(trial: u64) -> Straddling {
    let mut stream = Stream::of_trial(303, trial);
    let mut whole = |low: i64, high: i64| low + i64::from(stream.bits()) % (high - low + 1);
    let mut corners: [[i64; 3]; 3] =
        std::array::from_fn(|_| [whole(-9000, 9000), whole(-9000, 9000), whole(1, 30)]);
    // The first corner is behind the eye, or right beside it.
    corners[0][2] = whole(-20, 0);
    let sample = Fixed { x: whole(0, 1 << 16) as i32, y: whole(0, 1 << 16) as i32 };
    Straddling { corners, sample }
}

/// What exact arithmetic says of the ray through the sample.
#[derive(PartialEq)]
enum Truth {
    Hit,
    Miss,
    /// Within 1/256 pixel of an edge or of the near plane: either answer is right.
    Close,
}

/// Solves w s = b0 p0 + b1 p1 + b2 p2 by whole determinants; the sample is s = (x, y, 256) / 256.
fn truth(Straddling { corners: [a, b, c], sample }: &Straddling) -> Truth {
    let wide = |corner: &[i64; 3]| corner.map(i128::from);
    let (a, b, c) = (wide(a), wide(b), wide(c));
    let s = [i128::from(sample.x), i128::from(sample.y), i128::from(STEPS)];
    let lines = [cross(b, c), cross(c, a), cross(a, b)];
    let volume = dot(a, lines[0]);
    let values = lines.map(|line| dot(line, s) * volume.signum());
    let total: i128 = values.iter().sum();

    // The near plane appears as a line too: where 4 * 256 * total = 4 * volume / near.
    let [right, down] = [0, 1].map(|axis| lines.iter().map(|line| line[axis]).sum());
    let beyond = i128::from(STEPS) * volume.abs() * 4 - total;
    let near_edge = close([right, down, 0], beyond);
    if near_edge || lines.iter().any(|&line| close(line, dot(line, s))) {
        return Truth::Close;
    }
    let inside = volume != 0 && values.iter().all(|&value| value > 0) && beyond > 0;
    if inside { Truth::Hit } else { Truth::Miss }
}

/// Whether a sample is within 1/256 pixel of a line whose function has this `value` there.
fn close(line: [i128; 3], value: i128) -> bool {
    // One step changes the value by up to the length of (x, y); in whole numbers, squared.
    value * value <= line[0] * line[0] + line[1] * line[1]
}

fn cross(p: [i128; 3], q: [i128; 3]) -> [i128; 3] {
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

fn dot(p: [i128; 3], q: [i128; 3]) -> i128 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}

fn film_points(straddling: &Straddling) -> [FilmPoint; 3] {
    let [a, b, c] = straddling.corners;
    [a, b, c].map(|[x, y, w]| FilmPoint { x: x as f64, y: y as f64, w: w as f64 })
}

fn wrong(covered: bool, truth: Truth) -> bool {
    match truth {
        Truth::Close => false,
        Truth::Hit => !covered,
        Truth::Miss => covered,
    }
}

/// RA-03, naive.
pub(super) fn dividing_first_fails(trial: u64) -> bool {
    let straddling = straddling(trial);
    wrong(divided_covers(film_points(&straddling), straddling.sample), truth(&straddling))
}

/// RA-03, robust.
pub(super) fn clipping_first_fails(trial: u64) -> bool {
    let straddling = straddling(trial);
    let covered = clipped_covers(film_points(&straddling), straddling.sample);
    wrong(covered, truth(&straddling))
}

/// Coverage with the cut before the division.
pub(super) fn clipped_covers(corners: [FilmPoint; 3], sample: Fixed) -> bool {
    let polygon = VOLUME.clip(corners);
    let snapped: Vec<_> =
        polygon.corners().iter().map(|corner| Fixed::snap(corner.divide())).collect();
    (2..snapped.len()).any(|last| {
        edges([snapped[0], snapped[last - 1], snapped[last]])
            .is_some_and(|edges| covers(&edges, sample))
    })
}
