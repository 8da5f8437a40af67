//! PT-05: a white room, in which no path loses anything.

use common::film::Color;
use common::hard::Case;
use common::sampler::Sampler;
use common::tally::Counts;
use glam::Vec3;
use ray_casting::ray::Ray;

use super::CHAPTER;
use super::furnace::{BALL, room};
use crate::naive;
use crate::strategy::{ByDirection, Never};
use crate::tracer::{PathTracer, TRUNCATED_PATHS};

/// PT-05: what is left out is known, and counted.
pub(super) const WHITE: Case = Case {
    id: "PT-05",
    chapter: CHAPTER,
    input: "a path in a white furnace, to a depth of 0 to 499",
    most: 500,
    naive_fails: |_trial| naive::surfaces_until_faint(1.0, 1_000_000).is_none(),
    robust_fails: |trial| {
        let depth = trial as u32;
        let world = room(&BALL, 1.0);
        let (lighting, ending) = (ByDirection, Never);
        let tracer: PathTracer<_, _, _, true, false> =
            PathTracer { world: &world, lighting, ending, depth };
        let ray = Ray { origin: Vec3::new(0.1, -0.2, 0.3), direction: Vec3::X };
        let mut counts = Counts::default();
        let found = tracer.radiance(ray, &Sampler::new(1250, trial, 0, 1), &mut counts);
        // One for each surface that was seen, without any rounding.
        found != Color::splat(depth as f32 + 1.0) || counts.of(TRUNCATED_PATHS) != 1
    },
};
