//! LS-08 and LS-09: what the mean of many estimates is, against the closed form.

use common::film::Color;
use common::hard::Case;
use common::sampler::Stream;
use common::stats::running::Running;
use glam::Vec3;
use path_tracing::space::Piece;

use super::{CHAPTER, direction, lamp, point};
use crate::lamp::{Lamp, Way};
use crate::naive::published;
use crate::polygon::irradiance;

/// A right mean is farther off than this once in two million times.
const DEVIATIONS: f64 = 5.0;
const SAMPLES: u64 = 4000;

/// A triangular lamp that sends a radiance of 1, over a surface at the origin.
struct Sight {
    lamp: Lamp,
    corners: [Vec3; 3],
    normal: Vec3,
}

/// How the light of a point is counted: its cosines, its distance, and its density by area.
type Weight = fn(cosine: f32, lamp_cosine: f32, distance: f32, area: f32) -> f32;

impl Sight {
    fn new(corners: [Vec3; 3], normal: Vec3) -> Option<Self> {
        Some(Self { lamp: lamp(Piece::Triangle(corners))?, corners, normal })
    }

    fn right(&self) -> f64 {
        irradiance(&self.corners.map(Vec3::as_dvec3), self.normal.as_dvec3())
    }

    /// Estimates of the irradiance.
    fn estimates(&self, way: Way) -> Running {
        let estimate = |trial| {
            let u = Stream::of_trial(1338, trial).uniform2();
            let point = self.lamp.point(Vec3::ZERO, way, u)?;
            Some(point.direction.dot(self.normal).max(0.0) / point.pdf)
        };
        (0..SAMPLES).map(|trial| f64::from(estimate(trial).unwrap_or(0.0))).collect()
    }

    /// The same by a formula with the distance and both cosines.
    fn weighted(&self, weight: Weight) -> Running {
        let estimate = |trial| {
            let u = Stream::of_trial(1338, trial).uniform2();
            let point = self.lamp.point(Vec3::ZERO, Way::Area, u)?;
            let cosine = point.direction.dot(self.normal).max(0.0);
            let lamp_cosine = point.direction.dot(point.hit.geometric).abs();
            let distance = point.hit.point.length();
            Some(weight(cosine, lamp_cosine, distance, self.lamp.area()))
        };
        (0..SAMPLES).map(|trial| f64::from(estimate(trial).unwrap_or(0.0))).collect()
    }

    /// Whether chance doesn't explain how far the mean is off.
    fn is_off(&self, samples: &Running) -> bool {
        let error = samples.standard_error().unwrap_or(0.0);
        !((samples.mean() - self.right()).abs() <= DEVIATIONS * error + 1e-5 * self.right())
    }
}

/// LS-08: a lamp that stands on the floor, at a distance of 2⁻¹ to 2⁻²⁰.
pub(super) const AT_A_WALL: Case = Case {
    id: "LS-08",
    chapter: CHAPTER,
    input: "a lamp that touches the floor, 2^-1 to 2^-20 away: the spread of estimates",
    most: 20,
    naive_fails: |trial| spread(trial, Way::Area),
    robust_fails: |trial| spread(trial, Way::SolidAngle),
};

/// Whether the mean is off, or single estimates spread by more than the mean itself.
fn spread(trial: u64, way: Way) -> bool {
    let gap = 0.5 / (1_u64 << trial) as f32;
    let corners = [[-1.0, gap, 0.0], [1.0, gap, 0.0], [0.25, gap, 1.0]].map(Vec3::from_array);
    let Some(sight) = Sight::new(corners, Vec3::Z) else { return true };
    let samples = sight.estimates(way);
    let deviation = samples.variance().unwrap_or(f64::NAN).sqrt();
    sight.is_off(&samples) || !(deviation <= samples.mean())
}

/// LS-09: triangles anywhere around a surface, some partly below its horizon.
pub(super) const CLOSED_FORM: Case = Case {
    id: "LS-09",
    chapter: CHAPTER,
    input: "the light of 300 lamps, some cut by the horizon, against the closed form",
    most: 300,
    naive_fails: |trial| {
        let line: Weight = |cosine, lamp_cosine, distance, area| {
            published(Color::ONE, Color::ONE, cosine, lamp_cosine, distance, 1.0 / area).x
        };
        around(trial).is_none_or(|sight| sight.is_off(&sight.weighted(line)))
    },
    robust_fails: |trial| {
        around(trial).is_none_or(|sight| {
            [Way::Area, Way::SolidAngle].iter().any(|way| sight.is_off(&sight.estimates(*way)))
        })
    },
};

fn around(trial: u64) -> Option<Sight> {
    let mut stream = Stream::of_trial(1339, trial);
    let center = 2.0 * direction(&mut stream);
    let corners = [(); 3].map(|()| center + point(&mut stream));
    let sight = Sight::new(corners, direction(&mut stream))?;
    // Of a lamp that is all but set, hardly a sample is seen, and their spread says nothing.
    let is_all_but_set = (f64::MIN_POSITIVE..1e-4).contains(&sight.right());
    if is_all_but_set { around(trial + (1 << 40)) } else { Some(sight) }
}
