//! WH-01: within 2000 floats of the critical angle, is it total reflection, and if not, how much?

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;

use super::{CHAPTER, index, oracle};
use crate::dielectric::reflectance;
use crate::index::Index;
use crate::interface::Interface;
use crate::naive;

/// WH-01: the class by exact integers, the part by `f64`.
pub(super) const CRITICAL: Case = Case {
    id: "WH-01",
    chapter: CHAPTER,
    input: "a cosine within 2000 floats of the critical angle's",
    most: UNLIMITED,
    naive_fails: |trial| {
        let (near, cosine) = near_critical(trial);
        let ratio = near.number() as f32;
        is_wrong(near, cosine, f64::from(naive::reflectance(ratio, cosine)))
    },
    robust_fails: |trial| {
        let (near, cosine) = near_critical(trial);
        let leaving = Interface::new(near, Index::AIR);
        is_wrong(near, cosine, reflectance(&leaving, f64::from(cosine)))
    },
};

fn near_critical(trial: u64) -> (Index, f32) {
    let mut stream = Stream::of_trial(711, trial);
    let near = index(&mut stream, 1.1, 3.0);
    let sine = 1.0 / near.number();
    let critical = (1.0 - sine * sine).sqrt() as f32;
    let bits = critical.to_bits() - 2000 + stream.bits() % 4001;
    (near, f32::from_bits(bits))
}

/// Reflectance falls from 1 as steeply as a root, so a cosine's neighbour already differs by 1e-4.
/// In `f64` the root of a rounding is below 4e-8: 1e-7 is asked for. All is reflected just where
/// the integers say, or at the one float beside it, where nothing can tell 1 from it.
fn is_wrong(near: Index, cosine: f32, found: f64) -> bool {
    let right = oracle(near, Index::AIR, f64::from(cosine));
    let total = is_total(near.number() as f32, cosine);
    let close = (found - right).abs() <= 1e-7;
    !(close && (total == (found == 1.0) || right > 1.0 - 1e-7))
}

/// Whether near² (1 - cosine²) is above 1, exactly: both numbers are multiples of 2⁻²⁶ below 4.
fn is_total(near: f32, cosine: f32) -> bool {
    let whole = |number: f32| (f64::from(number) * f64::from(1 << 26)) as i128;
    let (near, cosine, one) = (whole(near), whole(cosine), 1_i128 << 26);
    near * near * (one * one - cosine * cosine) > one * one * one * one
}

#[cfg(test)]
mod tests {
    use crate::dielectric::reflectance;
    use crate::index::Index;
    use crate::interface::Interface;

    /// From one float to the next, reflectance never rises with the cosine c. Beyond the critical
    /// angle it falls as 1 - 2 c' (r + 1/r) / c, with c' the root of twice r² c for each step.
    #[test]
    fn it_falls_without_a_jump() {
        for near in [Index::WATER, Index::GLASS, Index::DIAMOND] {
            let leaving = Interface::new(near, Index::AIR);
            let critical = leaving.critical_cosine().expect("denser") as f32;
            let (ratio, cosine) = (leaving.ratio(), f64::from(critical));
            let beyond = (2.0 * ratio * ratio * cosine * f64::from(f32::EPSILON / 2.0)).sqrt();
            let jump = 2.0 * beyond * (ratio + 1.0 / ratio) / cosine;
            let at = |bits| reflectance(&leaving, f64::from(f32::from_bits(bits)));
            for bits in critical.to_bits() - 2000..critical.to_bits() + 2000 {
                let (here, next) = (at(bits), at(bits + 1));
                assert!(next <= here + 1e-15 && here - next <= jump, "{near:?} {here} {next}");
            }
        }
    }
}
