//! LS-10 and LS-11: which lamp is chosen, where some have no area or hardly any power.

use common::film::Color;
use common::hard::Case;
use common::sampler::Stream;
use glam::Vec3;
use monte_carlo::table::Table;
use path_tracing::part::{Form, Part};
use path_tracing::random::Random;
use path_tracing::smooth::Smooth;
use path_tracing::space::Space;
use path_tracing::world::Surface;

use super::{CHAPTER, decades, point};
use crate::lamp::Way;
use crate::lights::{Choice, Lights};
use crate::naive;

/// LS-10: lamps without area among others.
pub(super) const NO_AREA: Case = Case {
    id: "LS-10",
    chapter: CHAPTER,
    input: "lamps without area, or whose area is no number, among others",
    most: 1 << 16,
    naive_fails: |trial| {
        let areas = triangles(trial).map(|[a, b, c]| 0.5 * (b - a).cross(c - a).length());
        let u = Stream::of_trial(1341, trial).uniform();
        !naive::pick(&areas, u).is_some_and(|index| areas[index] > 0.0)
    },
    robust_fails: no_area_is_chosen,
};

/// Eight triangles, some of them lines or nowhere.
fn triangles(trial: u64) -> [[Vec3; 3]; 8] {
    let mut stream = Stream::of_trial(1340, trial);
    let mut corners = [(); 8].map(|()| [(); 3].map(|()| point(&mut stream)));
    for (index, [first, second, third]) in corners.iter_mut().enumerate().take(7) {
        match stream.bits() % 4 {
            0 => *third = *second,
            1 if index == 3 => first.x = f32::NAN,
            _ => {}
        }
    }
    corners
}

fn no_area_is_chosen(trial: u64) -> bool {
    let triangles = triangles(trial);
    let has_area =
        triangles.map(|[a, b, c]| (b - a).as_dvec3().cross((c - a).as_dvec3()).length() > 0.0);
    // A tree has no place for what is nowhere.
    let placed = |corners: &&[Vec3; 3]| corners.iter().all(|corner| corner.is_finite());
    let form = Form::Triangles(triangles.iter().filter(placed).copied().collect());
    let parts = [Part::glowing(form, Smooth::BLACK, Color::ONE)];
    let surfaces =
        parts.clone().map(|part| Surface { bsdf: part.material, emission: part.emission });
    let lights = Lights::new(&Space::new(&parts), &surfaces, Choice::Power, Way::Area);
    let sample = lights.sample(3.0 * Vec3::X, &Random::of_trial(1342, trial));
    let count = has_area.iter().filter(|has_area| **has_area).count();
    let sum: f64 = (0..8).filter_map(|piece| lights.probability(piece)).map(f64::from).sum();
    lights.lamps().len() != count
        || sum != 1.0
        || sample.is_some_and(|sample| !(sample.pdf > 0.0 && sample.pdf.is_finite()))
}

/// LS-11: powers from 10⁻³⁰ to 10³⁰.
pub(super) const WIDE: Case = Case {
    id: "LS-11",
    chapter: CHAPTER,
    input: "16 lamps of 10^-30 to 10^30: none with a density is out of reach",
    most: 1 << 16,
    naive_fails: |trial| {
        let powers = powers(trial);
        let total: f32 = powers.iter().sum();
        let reached = slots(|u| naive::pick(&powers, u).unwrap_or(15));
        powers.iter().zip(reached).any(|(power, slots)| power / total > 0.0 && slots == 0)
    },
    robust_fails: |trial| {
        let powers = powers(trial);
        let Some(table) = Table::new(&powers) else { return true };
        let reached = slots(|u| table.pick(u).index);
        let says = |index: usize| table.probability(index) * SLOTS as f32;
        let unreachable = reached.iter().filter(|slots| **slots == 0).count();
        (0..16).any(|index| says(index) != reached[index] as f32) || table.left_out() != unreachable
    },
};

/// A uniform number is one of this many.
const SLOTS: u32 = 1 << 24;

fn powers(trial: u64) -> [f32; 16] {
    let mut stream = Stream::of_trial(1343, trial);
    let widest = stream.between(0.0, 30.0);
    [(); 16].map(|()| decades(&mut stream, -widest, widest))
}

/// How many uniform numbers pick each of 16 things, which are picked in their order.
fn slots(pick: impl Fn(f32) -> usize) -> [u32; 16] {
    let number = |slot: u32| slot as f32 / SLOTS as f32;
    let (mut counts, mut before) = ([0; 16], 0);
    for (index, count) in counts.iter_mut().enumerate() {
        // The first slot that picks a later one.
        let (mut low, mut high) = (before, SLOTS);
        while low < high {
            let middle = low.midpoint(high);
            if pick(number(middle)) > index { high = middle } else { low = middle + 1 }
        }
        *count = low - before;
        before = low;
    }
    counts
}
