//! What comes back: by chance, and as the sum says.

use common::stats::estimate::{Estimate, z_test};
use common::stats::running::Running;
use fresnel::conductor::Metal;
use fresnel::index::Index;
use glam::Vec3;
use path_tracing::bsdf::{Bsdf, Material};
use path_tracing::mirror::mirrored;

use super::{at, materials, random};
use crate::albedo::{albedo, roughest};
use crate::conductor::PERFECT;
use crate::facets::Masking;
use crate::rough::Rough;

/// The mean weight of samples: lost ones count 0.
fn sampled(material: &Rough, outgoing: Vec3, count: u64) -> Estimate {
    let weight = |trial| material.sample(outgoing, &random(1501, trial));
    let weights: Running =
        (0..count).map(|trial| weight(trial).map_or(0.0, |it| f64::from(it.weight.x))).collect();
    Estimate::of(&weights).expect("many samples")
}

#[test]
fn the_roughest_metal_sends_1_minus_ln_2_back() {
    for outgoing in [at(1.0, 0.0), at(0.5, 1.0), at(-0.3, 2.0), at(0.05, 4.0)] {
        let found = sampled(&Rough::metal(PERFECT, 1.0), outgoing, 100_000);
        let closed = roughest(f64::from(outgoing.z.abs()), Masking::Correlated);
        assert!(z_test(&found, &Estimate::exact(closed)).p_value > 1e-3, "{found:?} {closed}");
    }
}

#[test]
fn samples_weigh_what_the_sum_says_for_all_choices() {
    for alpha in [0.1, 0.4] {
        for material in materials(alpha) {
            let Rough::Conductor(conductor) = material else { continue };
            if conductor.metal != PERFECT {
                continue;
            }
            for z in [0.9, 0.3] {
                let found = sampled(&material, at(z, 0.5), 100_000);
                let masking = conductor.facets.masking;
                let sum = Estimate::exact(albedo(f64::from(alpha), f64::from(z), masking, 300));
                let test = z_test(&found, &sum);
                assert!(test.p_value > 1e-4, "{material:?} {z}: {found:?} {sum:?}");
            }
        }
    }
}

#[test]
fn nearly_smooth_glass_loses_nothing() {
    for (index, z) in [(1.5, 0.8), (1.5, -0.9), (0.75, 0.9), (1.5, -0.2), (2.4, 0.3)] {
        let index = Index::new(index).expect("an index");
        let found = sampled(&Rough::glass(index, 0.002), at(z, 0.7), 20_000);
        assert!((found.mean - 1.0).abs() < 1e-3, "{index:?} {z}: {found:?}");
    }
}

#[test]
fn no_visible_sample_brings_more_than_all() {
    for alpha in [0.01, 0.2, 1.0] {
        for material in [Rough::metal(PERFECT, alpha), Rough::glass(Index::GLASS, alpha)] {
            for trial in 0..50_000 {
                let outgoing = at(random(1502, trial).number(path_tracing::random::LOBE), 0.3);
                let Some(sample) = material.sample(outgoing, &random(1503, trial)) else {
                    continue;
                };
                assert!(sample.weight.max_element() <= 1.0, "{material:?} {sample:?}");
            }
        }
    }
}

#[test]
fn rough_metal_becomes_a_mirror() {
    let smooth = Rough::metal(Metal::GOLD, 0.0);
    let outgoing = at(0.6, 1.0);
    let mirror = smooth.sample(outgoing, &random(1504, 0)).expect("a mirror");
    assert!(mirror.is_delta && mirror.incoming == mirrored(outgoing));
    for tiny in [0.0, 1e-8, 9e-4] {
        let material = Rough::metal(Metal::GOLD, tiny);
        assert_eq!(material.sample(outgoing, &random(1504, 0)), Some(mirror), "{tiny}");
        assert!(!material.spreads() && material.check().is_ok());
    }
    for trial in 0..1000 {
        let near = Rough::metal(Metal::GOLD, 0.001_01).sample(outgoing, &random(1505, trial));
        let near = near.expect("so smooth loses nothing");
        assert!((near.weight - mirror.weight).abs().max_element() < 0.01, "{near:?}");
        assert!(near.incoming.dot(mirror.incoming) > 0.5 && !near.is_delta);
    }
}

#[test]
fn what_is_no_roughness_is_refused() {
    for bad in [-0.1, 1.001, f32::NAN, f32::INFINITY] {
        assert!(Rough::metal(Metal::GOLD, bad).check().is_err(), "{bad}");
        assert!(Rough::glass(Index::GLASS, bad).check().is_err(), "{bad}");
    }
    let nothing = Metal { index: [f64::NAN; 3], absorption: [0.0; 3] };
    assert!(Rough::metal(nothing, 0.1).check().is_err());
}
