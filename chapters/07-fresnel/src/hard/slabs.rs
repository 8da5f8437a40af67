//! WH-05: through a slab of glass, in at a grazing angle and out at the parallel face.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::{DVec3, Vec3};

use super::{CHAPTER, direction, index, upon};
use crate::bend::{Incidence, precise};
use crate::index::Index;
use crate::interface::Interface;
use crate::naive;

/// WH-05: what came in must go out again, the way it came.
pub(super) const TRAPPED: Case = Case {
    id: "WH-05",
    chapter: CHAPTER,
    input: "through a slab: cosines of 10^-5 to 0.02 going in",
    most: UNLIMITED,
    naive_fails: |trial| {
        let Slab { far, direction, normal } = slab(trial);
        let ratio = (1.0 / far.number()) as f32;
        let inside = naive::refract(direction, normal, ratio);
        let outside = inside.and_then(|inside| naive::refract(inside, normal, 1.0 / ratio));
        is_changed(direction.as_dvec3(), outside.map(Vec3::as_dvec3))
    },
    robust_fails: |trial| {
        let Slab { far, direction, normal } = slab(trial);
        let direction = precise(direction);
        let into = Interface::new(Index::AIR, far);
        let inside = cross(&into, direction, normal);
        // The face at the back has the same normal, turned round.
        let outside = inside.and_then(|inside| cross(&into.reversed(), inside, -normal));
        is_changed(direction, outside)
    },
};

struct Slab {
    far: Index,
    direction: Vec3,
    normal: Vec3,
}

/// k · 10⁻⁵ for k up to 2000, from any side, into any glass.
fn slab(trial: u64) -> Slab {
    let mut stream = Stream::of_trial(716, trial);
    let normal = direction(&mut stream);
    let cosine = f64::from(1 + stream.bits() % 2000) * 1e-5;
    let direction = upon(&mut stream, normal, cosine).as_vec3();
    let far = index(&mut stream, 1.05, 3.0);
    Slab { far, direction, normal }
}

// ANCHOR: cross
fn cross(interface: &Interface, direction: DVec3, normal: Vec3) -> Option<DVec3> {
    let incidence = Incidence::new(direction, normal);
    let far_cosine = interface.far_cosine(incidence.cosine)?;
    Some(incidence.refracted(interface, far_cosine))
}
// ANCHOR_END: cross

/// Trapped, or sent elsewhere by more than 10⁻⁵ (the catalogue's bound; 10⁻¹⁰ is usual here).
fn is_changed(direction: DVec3, outside: Option<DVec3>) -> bool {
    outside.is_none_or(|outside| !((outside - direction).length() <= 1e-5))
}

#[cfg(test)]
mod tests {
    use super::{Slab, cross, slab};
    use crate::bend::precise;
    use crate::index::Index;
    use crate::interface::Interface;
    use crate::naive;

    /// Counts what the case does not tell apart: traps, and directions that changed.
    #[test]
    fn a_million_crossings_and_no_trap() {
        let (mut naive_traps, mut worst) = (0, 0.0_f64);
        for trial in 0..1_000_000 {
            let Slab { far, direction, normal } = slab(trial);
            let ratio = (1.0 / far.number()) as f32;
            let inside = naive::refract(direction, normal, ratio).expect("it enters");
            naive_traps += u32::from(naive::refract(inside, normal, 1.0 / ratio).is_none());
            let direction = precise(direction);
            let into = Interface::new(Index::AIR, far);
            let inside = cross(&into, direction, normal).expect("it enters");
            let outside = cross(&into.reversed(), inside, -normal).expect("no trap");
            worst = worst.max((outside - direction).length());
        }
        assert!(naive_traps > 1000, "the control: {naive_traps}");
        assert!(worst < 1e-9, "{worst:e}");
    }

    /// Below a cosine of 10⁻⁸ the square is lost in f64 as well. Then the ray leaves along the
    /// surface, which is where it came from to within 10⁻⁷, and still is not trapped.
    #[test]
    fn cosines_that_f64_can_not_carry() {
        for exponent in 5..=40 {
            let cosine = 10_f64.powi(-exponent);
            let direction = glam::DVec3::new((1.0 - cosine * cosine).sqrt(), -cosine, 0.0);
            for far in [Index::WATER, Index::GLASS, Index::DIAMOND] {
                let into = Interface::new(Index::AIR, far);
                let inside = cross(&into, direction, glam::Vec3::Y).expect("it enters");
                let outside = cross(&into.reversed(), inside, glam::Vec3::Y).expect("no trap");
                assert!((outside - direction).length() < 1e-7, "10^-{exponent}");
            }
        }
    }
}
