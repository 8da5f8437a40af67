//! The hard cases of this chapter: inputs on which the textbook's formula fails and ours doesn't.

mod angles;
mod critical;
mod energy;
mod matched;
mod picture;
mod slabs;
mod touching;

use common::film::Film;
use common::hard::Case;
use common::sampler::Stream;
use glam::{DVec3, Vec3};

use crate::index::Index;

/// All of them, in the catalogue's order.
pub const CASES: &[Case] = &[
    critical::CRITICAL,
    angles::ABOVE_ONE,
    matched::MATCHED,
    angles::GRAZING,
    slabs::TRAPPED,
    angles::SCHLICK,
    touching::TOUCHING,
    energy::BALANCE,
];

/// What becomes of rays in a slab: by the textbook's formula, and by ours.
pub fn picture() -> Film {
    picture::picture()
}

/// This chapter, as the ledger names it.
const CHAPTER: &str = "07-fresnel";

/// An index between two numbers.
fn index(stream: &mut Stream, low: f32, high: f32) -> Index {
    Index::new(stream.between(low, high)).unwrap_or(Index::GLASS)
}

/// A direction of length 1, to `f32`; not quite uniform, which no case needs.
fn direction(stream: &mut Stream) -> Vec3 {
    let mut component = || stream.between(-1.0, 1.0);
    let vector = Vec3::new(component(), component(), component());
    if vector.length() > 0.1 { vector.normalize() } else { direction(stream) }
}

/// The direction that comes upon a surface with `normal` at an angle with this cosine.
fn upon(stream: &mut Stream, normal: Vec3, cosine: f64) -> DVec3 {
    let normal = normal.as_dvec3().normalize();
    let other = direction(stream).as_dvec3();
    let across = other - other.dot(normal) * normal;
    if across.length() < 0.1 {
        return upon(stream, normal.as_vec3(), cosine);
    }
    (1.0 - cosine * cosine).sqrt() * across.normalize() - cosine * normal
}

/// Fresnel's equations with both cosines from the sine, in `f64`: plain, and independent of the
/// forms that are tested.
fn oracle(near: Index, far: Index, cosine: f64) -> f64 {
    let (near, far) = (near.number(), far.number());
    let sine = near / far * (1.0 - cosine * cosine).sqrt();
    if sine >= 1.0 {
        return 1.0;
    }
    let beyond = (1.0 - sine * sine).sqrt();
    let perpendicular = (near * cosine - far * beyond) / (near * cosine + far * beyond);
    let parallel = (far * cosine - near * beyond) / (far * cosine + near * beyond);
    (perpendicular * perpendicular + parallel * parallel) / 2.0
}

#[cfg(test)]
mod tests {
    use common::hard::Ledger;

    use super::CASES;

    fn check(trials: u64) {
        let ledger = Ledger::of(CASES, trials);
        assert!(ledger.broken().is_empty(), "{ledger}");
    }

    #[test]
    fn the_naive_fails_and_the_robust_does_not() {
        check(50_000);
    }

    #[test]
    #[ignore = "takes minutes: cargo test --release -p fresnel -- --ignored"]
    fn not_once_in_a_hundred_million() {
        check(100_000_000);
    }
}
