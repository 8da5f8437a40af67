//! BP-03: a lamp at the point it lights, or hardly away from it.

use common::film::Color;
use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::Vec3;

use super::CHAPTER;
use super::draw::{decade, direction};
use crate::light::{Arriving, Light};
use crate::naive;

/// BP-03: what arrives from no distance.
pub(super) const NEAR: Case = Case {
    id: "BP-03",
    chapter: CHAPTER,
    input: "a lamp 0 to 10^-10 away, fall-offs of 0 among others",
    most: UNLIMITED,
    naive_fails: |trial| {
        let Near { position, falloff, point } = near(trial);
        near(trial).is_wrong(Some(naive::arriving(position, COLOR, falloff, point)))
    },
    robust_fails: |trial| {
        let Near { position, falloff, point } = near(trial);
        near(trial).is_wrong(Light::Point { position, color: COLOR, falloff }.at(point))
    },
};

const COLOR: Color = Color::new(0.0, 0.5, 3.0);

struct Near {
    position: Vec3,
    falloff: [f32; 3],
    point: Vec3,
}

/// The point is the origin, so that the lamp is as near as it says and not rounded onto it.
fn near(trial: u64) -> Near {
    let mut stream = Stream::of_trial(403, trial);
    let position = match stream.bits() % 8 {
        0 => Vec3::ZERO,
        _ => direction(&mut stream) * decade(&mut stream, -44.0, -10.0),
    };
    let falloffs = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.5, 0.25, 4.0], [0.0; 3]];
    let falloff = falloffs[(stream.bits() % 5) as usize];
    Near { position, falloff, point: Vec3::ZERO }
}

impl Near {
    /// Nothing arrives from no distance or by a fall-off of nothing. From elsewhere the light comes
    /// from the lamp, with the fall-off of `f64`, which stops at 10^-18.
    ///
    /// The direction is right to 2 ε, and the fall-off to a few roundings. Squares below the smallest
    /// `f32` may count as 0: then nothing arrives.
    fn is_wrong(&self, found: Option<Arriving>) -> bool {
        let away = self.position.as_dvec3() - self.point.as_dvec3();
        let (distance, [constant, linear, quadratic]) =
            (away.length(), self.falloff.map(f64::from));
        let falloff = constant + linear * distance + quadratic * distance * distance;
        let Some(Arriving { toward, color, .. }) = found else {
            return distance > 0.0 && falloff > 1e-44;
        };
        if falloff == 0.0 || distance == 0.0 {
            return true;
        }
        let exact = COLOR.as_dvec3() / falloff.max(1e-18);
        let color_error = (color.as_dvec3() - exact).length() / exact.length();
        let direction_error = (toward.as_dvec3() - away / distance).length();
        !(color_error <= 1e-6 && direction_error <= 3e-7)
    }
}
