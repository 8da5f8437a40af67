//! The hard cases of this chapter: inputs on which the textbook's formula fails and ours doesn't.

mod endless;
mod furnace;
mod grazing;
mod quarantine;
mod throughput;

use common::hard::Case;
use common::sampler::Stream;
use glam::Vec3;

/// All of them, in the catalogue's order.
pub const CASES: &[Case] = &[
    furnace::FURNACE,
    throughput::UNDERFLOW,
    endless::WHITE,
    quarantine::COUNTED,
    grazing::WEIGHT,
    grazing::BELOW,
];

/// This chapter, as the ledger names it.
const CHAPTER: &str = "12-path-tracing";

/// A direction of length 1, to `f32`; not quite uniform, which no case needs.
fn direction(stream: &mut Stream) -> Vec3 {
    let mut component = || stream.between(-1.0, 1.0);
    let vector = Vec3::new(component(), component(), component());
    if vector.length() > 0.1 { vector.normalize() } else { direction(stream) }
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
    #[ignore = "takes minutes: cargo test --release -p path-tracing -- --ignored"]
    fn not_once_in_a_hundred_million() {
        check(100_000_000);
    }
}
