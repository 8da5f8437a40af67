//! A sample says the density that it was chosen with, and a weight that belongs to it.

use common::stats::chi_squared::goodness_of_fit;
use glam::Vec3;
use path_tracing::bsdf::Bsdf;
use path_tracing::random::DIRECTION;

use super::{at, materials, random};
use crate::ggx::Ggx;
use crate::rough::Rough;

#[test]
fn weight_times_density_is_what_is_scattered() {
    for alpha in [0.05, 0.3, 1.0] {
        for material in materials(alpha) {
            for trial in 0..2_000 {
                let z = [0.95, 0.4, -0.7, -0.1][trial as usize % 4];
                let outgoing = at(z, trial as f32);
                let Some(sample) = material.sample(outgoing, &random(1507, trial)) else {
                    continue;
                };
                let density = material.pdf(outgoing, sample.incoming);
                let near = (density / sample.pdf - 1.0).abs() < 0.02;
                assert!(near, "{material:?} {outgoing}: {density} {sample:?}");
                let scattered = material.eval(outgoing, sample.incoming);
                let weight = scattered * sample.incoming.z.abs() / sample.pdf;
                let apart = (weight - sample.weight).abs().max_element();
                let allowed = 0.02 * sample.weight.max_element();
                assert!(apart <= allowed, "{material:?} {outgoing}: {weight} {sample:?}");
            }
        }
    }
}

const BINS: usize = 16;
const FINE: usize = 40;

/// The bin of a direction: by its height and its turn.
fn bin(direction: Vec3) -> usize {
    let row = ((direction.z + 1.0) / 2.0 * BINS as f32) as usize;
    let turn = common::math::atan2(direction.y, direction.x) / std::f32::consts::TAU + 0.5;
    row.min(BINS - 1) * BINS + ((turn * BINS as f32) as usize).min(BINS - 1)
}

/// The integral of the density over each bin, and what is missing of 1: the lost samples.
fn expected(material: &Rough, outgoing: Vec3, count: f64) -> Vec<f64> {
    let steps = BINS * FINE;
    let mut bins = vec![0.0; BINS * BINS + 1];
    let middle = |step: usize| (step as f32 + 0.5) / steps as f32;
    let area = 2.0 * std::f64::consts::TAU / (steps * steps) as f64;
    for (i, j) in (0..steps).flat_map(|i| (0..steps).map(move |j| (i, j))) {
        let turn = std::f32::consts::TAU * (middle(j) - 0.5);
        let incoming = at(2.0 * middle(i) - 1.0, turn);
        let density = f64::from(material.pdf(outgoing, incoming));
        bins[i / FINE * BINS + j / FINE] += count * area * density;
    }
    bins[BINS * BINS] = (count - bins.iter().sum::<f64>()).max(0.0);
    bins
}

#[test]
fn samples_follow_their_density() {
    const COUNT: u64 = 40_000;
    let outgoings = [at(0.7, 1.0), at(-0.5, 2.0)].into_iter().cycle();
    for (material, outgoing) in materials(0.5).into_iter().zip(outgoings) {
        let mut observed = vec![0; BINS * BINS + 1];
        for trial in 0..COUNT {
            let sample = material.sample(outgoing, &random(1508, trial));
            observed[sample.map_or(BINS * BINS, |sample| bin(sample.incoming))] += 1;
        }
        let mut expected = expected(&material, outgoing, COUNT as f64);
        // A bin may overlap with what is possible by less than the grid can see.
        for (observed, expected) in observed.iter().zip(&mut expected) {
            if *observed > 0 {
                *expected = expected.max(1e-3);
            }
        }
        let fit = goodness_of_fit(&observed, &expected).expect("comparable");
        assert!(fit.p_value > 1e-4, "{material:?} {outgoing}: {fit:?}");
    }
}

/// Normals in coordinates that follow the lobe (hard case MF-10): by the root of the part of D cosθ
/// that is steeper, and by their turn.
fn lobe_bin(normal: Vec3, alpha: f32) -> usize {
    let slope = normal.truncate() / (alpha * normal.z);
    let root = 1.0 / (1.0 + slope.length_squared()).sqrt();
    let turn = common::math::atan2(slope.y, slope.x) / std::f32::consts::TAU + 0.5;
    let index = |part: f32| ((part * BINS as f32) as usize).min(BINS - 1);
    index(root) * BINS + index(turn)
}

/// A normal of a point of these coordinates, and its density in them over that per steradian.
fn of_lobe(ggx: &Ggx, root: f32, turn: f32) -> (Vec3, f32) {
    let radius = ggx.alpha * ((1.0 - root) * (1.0 + root)).sqrt() / root;
    let angle = std::f32::consts::TAU * (turn - 0.5);
    let (x, y) = (common::math::cos(angle), common::math::sin(angle));
    let normal = Vec3::new(radius * x, radius * y, 1.0).normalize();
    (normal, 2.0 * root / (ggx.density(normal) * normal.z))
}

#[test]
fn visible_normals_follow_their_density_in_the_narrowest_lobes_too() {
    const COUNT: u64 = 40_000;
    let views = [(0.5, 0.9), (0.1, 0.01), (1e-3, 0.5), (1e-4, 0.1), (1.0, 1e-3), (1.0, 1.0)];
    for (alpha, z) in views {
        let (ggx, outgoing) = (Ggx { alpha }, at(z, 0.8));
        let mut observed = vec![0; BINS * BINS];
        for trial in 0..COUNT {
            let normal = ggx.visible_normal(outgoing, random(1509, trial).pair(DIRECTION));
            observed[lobe_bin(normal, alpha)] += 1;
        }
        let mut expected = vec![0.0; BINS * BINS];
        let steps = BINS * FINE;
        let middle = |step: usize| (step as f32 + 0.5) / steps as f32;
        for (i, j) in (0..steps).flat_map(|i| (0..steps).map(move |j| (i, j))) {
            let (normal, ratio) = of_lobe(&ggx, middle(i), middle(j));
            let share = f64::from(ggx.visible_density(outgoing, normal) * ratio);
            let cells = (steps * steps) as f64;
            expected[i / FINE * BINS + j / FINE] += COUNT as f64 * share / cells;
        }
        for (observed, expected) in observed.iter().zip(&mut expected) {
            if *observed > 0 {
                *expected = expected.max(1e-3);
            }
        }
        let fit = goodness_of_fit(&observed, &expected).expect("comparable");
        assert!(fit.p_value > 1e-4, "{alpha} {z}: {fit:?}");
    }
}
