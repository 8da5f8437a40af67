//! What the plan saves: each effect beside a loop that was written for it alone.

use std::hint::black_box;
use std::rc::Rc;

use blinn_phong::scenes::brute_force;
use common::cost::{Experiment, Method, Plot, Table};
use common::film::Color;
use common::sampler::Sampler;
use common::tally::Off;
use ray_casting::ray::Ray;
use whitted::limits::Limits;

use super::{by_hand, rays, root_mean_square};
use crate::index::Index;
use crate::path::{Branching, Formula};
use crate::picture::Picture;
use crate::scenes::Stage;
use crate::shade::Lit;

const LIMITS: Limits = Limits { depth: 5, cutoff: 0.001 };
const REPEATS: usize = 4;

/// A scene and the rays that are sent into it.
pub(super) struct Sight {
    pub(super) stage: Stage,
    rays: Vec<Ray>,
}

impl Sight {
    /// None if the scene could not be built, which a test of the scenes would tell.
    fn new(name: &str) -> Option<Rc<Self>> {
        let stage = Stage::named(name, brute_force, Index::GLASS, |_| ()).ok()?;
        let rays = rays(&stage, 64, 48);
        Some(Rc::new(Self { stage, rays }))
    }

    fn picture(&self) -> Picture<'_> {
        let (formula, branching) = (Formula::Exact, Branching::Both);
        Picture { stage: &self.stage, formula, branching, limits: LIMITS }
    }

    /// The radiance of every ray by the integrator with these effects.
    fn follow<const MIRRORS: bool, const GLASS: bool>(&self) -> Vec<Color> {
        let picture = self.picture();
        let integrator = picture.integrator::<_, MIRRORS, GLASS>(Lit::<true, true, true>);
        let sampler = Sampler::new(1, 1, 0, 1);
        let radiance =
            |ray: &Ray| integrator.radiance(&LIMITS, black_box(*ray), &sampler, &mut Off);
        self.rays.iter().map(radiance).collect()
    }

    fn by_hand(&self, radiance: fn(&Stage, &Ray) -> Color) -> Vec<Color> {
        self.rays.iter().map(|ray| radiance(&self.stage, black_box(ray))).collect()
    }
}

/// The scenes: what each needs, everything, and a loop by hand.
pub(super) fn experiment() -> Option<Experiment<'static>> {
    let (matte, glass) = (Sight::new("two-lamps")?, Sight::new("whitted")?);
    let by_hand_matte = |sight: &Sight| sight.by_hand(by_hand::matte);
    let by_hand_glass = |sight: &Sight| sight.by_hand(by_hand::glass);
    Some(Experiment {
        name: "plan",
        title: "A scene without glass and one with it: what is not called for costs nothing",
        work_unit: "camera rays",
        error_metric: "RMS difference from the loop by hand",
        plot: Plot::ErrorOverTime("difference (RMS)"),
        methods: vec![
            method("no glass, by hand", &matte, by_hand_matte, by_hand_matte),
            method("no glass, needed", &matte, Sight::follow::<false, false>, by_hand_matte),
            method("no glass, all", &matte, Sight::follow::<true, true>, by_hand_matte),
            method("glass, by hand", &glass, by_hand_glass, by_hand_glass),
            method("glass, needed", &glass, Sight::follow::<true, true>, by_hand_glass),
        ],
        note,
    })
}

fn method(
    label: &'static str,
    sight: &Rc<Sight>,
    follow: impl Fn(&Sight) -> Vec<Color> + 'static,
    by_hand: impl Fn(&Sight) -> Vec<Color>,
) -> Method<'static> {
    let pairs = follow(sight).into_iter().zip(by_hand(sight));
    let error =
        root_mean_square(pairs.flat_map(|(one, other)| (one - other).to_array().map(f64::from)));
    let sight = sight.clone();
    Method {
        label: label.into(),
        series: label,
        size: 1.0,
        work: (REPEATS * sight.rays.len()) as u64,
        error,
        run: Box::new(move || {
            for _ in 0..REPEATS {
                black_box(follow(&sight));
            }
        }),
    }
}

fn note(table: &Table) -> String {
    let [hand, needed, all, glass_hand, glass] = &table.rows[..] else { return String::new() };
    let more = |row: &common::cost::Row, base: &common::cost::Row| {
        common::cost::change(row.nanoseconds() / base.nanoseconds())
    };
    format!(
        "Against the loop by hand: without glass, what is needed takes {} time, and all takes {}; with \
         glass, what is needed takes {}.",
        more(needed, hand),
        more(all, hand),
        more(glass, glass_hand)
    )
}
