//! Whole pictures: how rays are followed, and by which formula.

use std::hint::black_box;
use std::rc::Rc;

use blinn_phong::scenes::brute_force;
use common::cost::{Experiment, Method, Plot, Table, no_note};
use common::sampler::Sampler;
use common::stats::error::rmse;
use common::tally::{Counts, Off, Tally};
use glam::DVec3;
use ray_casting::ray::Ray;
use whitted::limits::Limits;

use super::rays;
use crate::index::Index;
use crate::integrator::{REFLECTED, REFRACTED};
use crate::path::{Branching, Formula};
use crate::picture::Picture;
use crate::scenes::Stage;
use crate::shade::Lit;

/// A scene, its rays, and what they bring when all is followed.
struct Sight {
    stage: Stage,
    rays: Vec<Ray>,
    truth: Vec<f64>,
}

/// How a picture is made.
#[derive(Clone, Copy)]
struct How {
    formula: Formula,
    branching: Branching,
    limits: Limits,
    spp: u32,
}

const EXACT: How = How {
    formula: Formula::Exact,
    branching: Branching::Both,
    limits: Limits { depth: 5, cutoff: 0.0 },
    spp: 1,
};

/// What the pictures are held against. A branch that is cut off takes away at most the cut-off, and
/// a furnace in the unit tests has five of them a pixel: here that makes 10⁻⁵ of the light.
const CONVERGED: How = How { limits: Limits { depth: 40, cutoff: 1e-6 }, ..EXACT };

impl Sight {
    /// None if the scene could not be built, which a test of the scenes would tell.
    fn new(name: &str, width: u32, height: u32) -> Option<Rc<Self>> {
        let stage = Stage::named(name, brute_force, Index::GLASS, |_| ()).ok()?;
        let rays = rays(&stage, width, height);
        let mut sight = Self { stage, rays, truth: Vec::new() };
        sight.truth = sight.draw::<Off>(CONVERGED).0;
        Some(Rc::new(sight))
    }

    /// The channels of all pixels. Every sample goes through its pixel's centre, so that no error
    /// is that of edges.
    fn draw<T: Tally>(&self, how: How) -> (Vec<f64>, T) {
        let How { formula, branching, limits, spp } = how;
        let picture = Picture { stage: &self.stage, formula, branching, limits };
        let integrator = picture.integrator::<_, true, true>(Lit::<true, true, true>);
        let mut tally = T::default();
        let mut channels = Vec::with_capacity(3 * self.rays.len());
        for (pixel, ray) in (0..).zip(&self.rays) {
            let mut sum = DVec3::ZERO;
            for sample in 0..spp {
                let sampler = Sampler::new(1, pixel, sample, spp);
                sum += integrator.radiance(&limits, *ray, &sampler, &mut tally).as_dvec3();
            }
            channels.extend((sum / f64::from(spp)).to_array());
        }
        (channels, tally)
    }

    fn method(self: &Rc<Self>, series: &'static str, label: String, how: How) -> Method<'static> {
        let sight = Rc::clone(self);
        let (channels, tally) = self.draw::<Counts>(how);
        let branches = tally.of(REFLECTED) + tally.of(REFRACTED);
        Method {
            label,
            series,
            size: branches as f64,
            work: 1,
            error: rmse(&self.truth, &channels).unwrap_or(f64::NAN),
            run: Box::new(move || drop(black_box(sight.draw::<Off>(how)))),
        }
    }
}

const BOTH: &str = "both, to a depth";
const CUTOFF: &str = "both, to a cut-off";
const ONE: &str = "one by chance";

/// Both ways to a depth, both ways to a cut-off, or one way by chance.
pub(super) fn branching() -> Option<Experiment<'static>> {
    let sight = Sight::new("nested", 40, 30)?;
    let depths = [1, 2, 4, 6, 8, 10].map(|depth| {
        let how = How { limits: Limits { depth, cutoff: 0.0 }, ..EXACT };
        sight.method(BOTH, format!("{BOTH} of {depth}"), how)
    });
    let cutoffs = [0.1, 0.03, 0.01, 0.003, 0.001, 0.0003].map(|cutoff| {
        let how = How { limits: Limits { depth: 40, cutoff }, ..EXACT };
        sight.method(CUTOFF, format!("{CUTOFF} of {cutoff}"), how)
    });
    let chances = [1, 4, 16, 64].map(|spp| {
        let limits = Limits { depth: 40, cutoff: 0.0 };
        let how = How { branching: Branching::One, limits, spp, ..EXACT };
        sight.method(ONE, format!("{ONE}, samples: {spp}"), how)
    });
    Some(Experiment {
        name: "branching",
        title: "Glass in glass, 40x30: what becomes of the second ray",
        work_unit: "pictures",
        error_metric: "RMSE against both ways to a cut-off of 10^-6",
        plot: Plot::ErrorOverTime("error of the picture (RMSE)"),
        methods: depths.into_iter().chain(cutoffs).chain(chances).collect(),
        note: first_below,
    })
}

/// Fresnel's equations against Schlick's approximation, in a picture.
pub(super) fn formulas() -> Option<Experiment<'static>> {
    let sight = Sight::new("whitted", 160, 120)?;
    let method =
        |label: &'static str, formula| sight.method(label, label.into(), How { formula, ..EXACT });
    Some(Experiment {
        name: "formulas",
        title: "The report's figure 5.2, 160x120, to a depth of 5",
        work_unit: "pictures",
        error_metric: "RMSE against Fresnel's equations to a cut-off of 10^-6",
        plot: Plot::ErrorOverTime("error of the picture (RMSE)"),
        methods: vec![method("Fresnel", Formula::Exact), method("Schlick", Formula::Schlick)],
        note: no_note,
    })
}

/// The first of each way with an error below a hundredth: how many rays leave interfaces for it.
fn first_below(table: &Table) -> String {
    let first = |series| {
        let mut rows = table.rows.iter();
        let row = rows.find(|row| row.series == series && row.error < 0.01);
        row.map(|row| format!("{} follows {} rays", row.label, row.size))
    };
    let found: Vec<String> = [BOTH, CUTOFF, ONE].into_iter().filter_map(first).collect();
    format!("The first of each way with an error below 0.01: {}.", found.join("; "))
}
