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
    naive_fails: |trial| fails(trial, through_naive),
    robust_fails: |trial| fails(trial, through_ours),
};

/// A way through a slab: the direction behind it, or None if the ray is trapped.
type Through = fn(Index, Vec3, Vec3) -> Option<DVec3>;

fn fails(trial: u64, through: Through) -> bool {
    let Slab { far, direction, normal } = slab(trial);
    through(far, direction, normal).is_none_or(|outside| away(direction, outside))
}

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

/// In and out by the textbook's formula.
pub(super) fn through_naive(far: Index, direction: Vec3, normal: Vec3) -> Option<DVec3> {
    let ratio = (1.0 / far.number()) as f32;
    let inside = naive::refract(direction, normal, ratio)?;
    naive::refract(inside, normal, 1.0 / ratio).map(Vec3::as_dvec3)
}

/// In and out with all digits.
pub(super) fn through_ours(far: Index, direction: Vec3, normal: Vec3) -> Option<DVec3> {
    let into = Interface::new(Index::AIR, far);
    let inside = cross(&into, precise(direction), normal)?;
    // The face at the back has the same normal, turned round.
    cross(&into.reversed(), inside, -normal)
}

fn cross(interface: &Interface, direction: DVec3, normal: Vec3) -> Option<DVec3> {
    let incidence = Incidence::new(direction, normal);
    let far_cosine = interface.far_cosine(incidence.cosine)?;
    Some(incidence.refracted(interface, far_cosine))
}

/// Whether a ray comes out in another direction: by more than 10⁻⁵, the catalogue's bound.
pub(super) fn away(direction: Vec3, outside: DVec3) -> bool {
    !((outside - precise(direction)).length() <= 1e-5)
}

#[cfg(test)]
mod tests {
    use super::{Slab, cross, slab, through_naive, through_ours};
    use crate::bend::precise;
    use crate::index::Index;
    use crate::interface::Interface;

    /// Counts what the case does not tell apart: traps, and directions that changed.
    #[test]
    fn a_million_crossings_and_no_trap() {
        let (mut naive_traps, mut worst) = (0, 0.0_f64);
        for trial in 0..1_000_000 {
            let Slab { far, direction, normal } = slab(trial);
            naive_traps += u32::from(through_naive(far, direction, normal).is_none());
            let outside = through_ours(far, direction, normal).expect("no trap");
            worst = worst.max((outside - precise(direction)).length());
        }
        assert!(naive_traps > 1000, "the control: {naive_traps}");
        assert!(worst < 1e-9, "{worst:e}");
    }

    /// Below a cosine of 10⁻⁸ the square is lost in f64 as well. Then the ray leaves along the
    /// surface, which is where it came from to within 10⁻⁷, and still is not trapped.
    #[test]
    fn cosines_that_f64_can_not_carry() {
        let cosines = std::iter::successors(Some(1e-5), |cosine| Some(cosine / 10.0));
        for cosine in cosines.take(36) {
            let along: f64 = 1.0 - cosine * cosine;
            let direction = glam::DVec3::new(along.sqrt(), -cosine, 0.0);
            for far in [Index::WATER, Index::GLASS, Index::DIAMOND] {
                let into = Interface::new(Index::AIR, far);
                let inside = cross(&into, direction, glam::Vec3::Y).expect("it enters");
                let outside = cross(&into.reversed(), inside, glam::Vec3::Y).expect("no trap");
                assert!((outside - direction).length() < 1e-7, "{cosine:e}");
            }
        }
    }
}
