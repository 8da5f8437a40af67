//! The hard cases of this chapter: inputs on which the textbook's formula fails and ours doesn't.

mod balls;
mod edges;
mod estimates;
mod tables;
mod triangles;

use common::film::Color;
use common::hard::Case;
use common::sampler::Stream;
use glam::Vec3;
use path_tracing::part::Emission;
use path_tracing::space::Piece;

use crate::lamp::{Lamp, LampPoint, Way};

/// All of them, in the catalogue's order.
pub const CASES: &[Case] = &[
    balls::CAP,
    balls::TOUCHING,
    triangles::SOLID_ANGLE,
    triangles::WEIGHTS,
    edges::IN_PLANE,
    edges::COINCIDENT,
    estimates::AT_A_WALL,
    estimates::CLOSED_FORM,
    tables::NO_AREA,
    tables::WIDE,
];

/// This chapter, as the ledger names it.
const CHAPTER: &str = "13-light-sampling";

const WAYS: [Way; 2] = [Way::Area, Way::SolidAngle];

/// The lamp of a piece that glows on both sides with a radiance of 1.
fn lamp(piece: Piece) -> Option<Lamp> {
    Lamp::new(piece, Emission { radiance: Color::ONE, both_sides: true })
}

/// A point of the cube from -1 to 1.
fn point(stream: &mut Stream) -> Vec3 {
    Vec3::from_array([(); 3].map(|()| stream.between(-1.0, 1.0)))
}

/// A direction of length 1, to `f32`; not quite uniform, which no case needs.
fn direction(stream: &mut Stream) -> Vec3 {
    let vector = point(stream);
    if vector.length() > 0.1 { vector.normalize() } else { direction(stream) }
}

/// A number between two powers of ten, as likely in each.
fn decades(stream: &mut Stream, low: f32, high: f32) -> f32 {
    common::math::pow(10.0, stream.between(low, high))
}

/// Whether it is no point: a density that is none, or no direction.
fn is_broken(point: &LampPoint) -> bool {
    !(point.pdf > 0.0 && point.pdf.is_finite() && point.direction.is_finite())
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
        check(20_000);
    }

    #[test]
    #[ignore = "takes minutes: cargo test --release -p light-sampling -- --ignored"]
    fn not_once_in_ten_million() {
        check(10_000_000);
    }
}
