//! RA-02: telling near from far.

use common::math;
use common::sampler::Stream;

use crate::naive::standard_depth;
use crate::zbuffer::nearness;

/// Two depths, the second larger by a hundred-thousandth.
struct Planes {
    first: f32,
    second: f32,
}

const NEAR: f32 = 0.1;
const FAR: f32 = 1e8;

fn planes(trial: u64) -> Planes {
    let mut stream = Stream::of_trial(302, trial);
    let first = math::pow(10.0, stream.between(0.0, 7.0));
    Planes { first, second: first * 1.000_01 }
}

/// RA-02, naive.
pub(super) fn standard_fails(trial: u64) -> bool {
    let Planes { first, second } = planes(trial);
    standard_depth(NEAR, FAR, first) >= standard_depth(NEAR, FAR, second)
}

/// RA-02, robust.
pub(super) fn reversed_fails(trial: u64) -> bool {
    let Planes { first, second } = planes(trial);
    let [first, second] =
        [first, second].map(|depth| nearness(f64::from(NEAR), 1.0 / f64::from(depth)));
    first <= second
}
