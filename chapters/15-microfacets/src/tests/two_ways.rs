//! The same there and back.

use common::sampler::Stream;
use path_tracing::bsdf::Bsdf;

use super::{direction, materials};
use crate::rough::Rough;

/// n on the side of a direction whose height is `z`.
fn index(material: &Rough, z: f32) -> f32 {
    match material {
        Rough::Dielectric(glass) if z < 0.0 => glass.index.number() as f32,
        _ => 1.0,
    }
}

#[test]
fn what_is_scattered_is_the_same_in_both_directions() {
    for alpha in [0.05, 0.3, 1.0] {
        for material in materials(alpha) {
            for trial in 0..2_000 {
                let mut stream = Stream::of_trial(1506, trial);
                let (one, other) = (direction(&mut stream), direction(&mut stream));
                let square = |z| index(&material, z) * index(&material, z);
                let there = material.eval(one, other) / square(other.z);
                let back = material.eval(other, one) / square(one.z);
                let scale = there.max_element().max(back.max_element()).max(1e-20);
                let apart = (there - back).abs().max_element() / scale;
                // Where both nearly graze, what is left of outgoing + (n' / n) incoming has few digits.
                assert!(apart < 0.02, "{material:?} {one} {other}: {there} {back}");
            }
        }
    }
}
