//! The program.

use common::chapter::{Chapter, Defaults, Entry, Failure, SceneName, unknown_scene};
use common::cost::Experiment;
use common::film::Film;
use common::hard::Case;
use common::plan::{Call, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};

use crate::chart::Funnel;
use crate::knobs::Knobs;
use crate::picture::Panels;
use crate::{cost, hard};

/// Points that were drawn, or samples whose mean was.
pub const SAMPLES: Event = Event::new(11, 0, "samples");

/// Chapter 11's program.
pub struct MonteCarlo;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<MonteCarlo>();

/// What there is to draw. None of it has anything that light does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// Three kinds of points, in the square and in the disk.
    Points,
    /// One kind of points, in six places.
    Warps,
    /// Means of more and more samples.
    Convergence,
}

impl Chapter for MonteCarlo {
    const ID: &'static str = "11-monte-carlo";
    const ABOUT: &'static str = "Chapter 11: integrals by chance, and how wrong chance is";
    const DEFAULTS: Defaults = Defaults { scene: "points", width: 960, height: 640, spp: 4 };
    const SCENES: &'static [SceneName] = &[
        SceneName {
            name: "points",
            about: "random, stratified and Sobol points, in a square and in a disk",
        },
        SceneName { name: "warps", about: "one kind of points in disks, a triangle, and on domes" },
        SceneName {
            name: "convergence",
            about: "means of 1 to 4096 samples, and what they are of",
        },
    ];
    const SKILLS: &'static [Skill] = &[];
    const EVENTS: &'static [Event] = &[SAMPLES];

    type Knobs = Knobs;
    type Scene = Subject;

    fn build(name: &str, _knobs: &Knobs) -> Result<Subject, Failure> {
        match name {
            "points" => Ok(Subject::Points),
            "warps" => Ok(Subject::Warps),
            "convergence" => Ok(Subject::Convergence),
            _ => Err(unknown_scene(name, Self::SCENES)),
        }
    }

    fn calls(_subject: &Subject, _knobs: &Knobs) -> Vec<Call> {
        Vec::new()
    }

    fn draw<T: Tally>(
        subject: &Subject,
        _plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        let seed = settings.seed;
        match subject {
            Subject::Points => Panels::of_points(knobs.count, seed).draw(settings),
            Subject::Warps => Panels::of_warps(knobs.points, knobs.count, seed).draw(settings),
            Subject::Convergence => Funnel::new(knobs.points, seed).draw(settings),
        }
    }

    fn cost() -> Vec<Experiment<'static>> {
        cost::experiments()
    }

    fn hard() -> Vec<Case> {
        hard::CASES.to_vec()
    }

    fn hard_picture() -> Option<Film> {
        Some(hard::picture())
    }
}
