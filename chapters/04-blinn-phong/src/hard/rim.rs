//! BP-06: the rim of a smooth mesh, where the interpolated normal points away from the eye.

use common::film::Color;
use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::{Vec2, Vec3};
use ray_casting::shape::Hit;

use super::CHAPTER;
use super::draw::direction;
use crate::light::Arriving;
use crate::material::BlinnPhong;
use crate::models::{Blinn, Model};
use crate::naive;
use crate::paint::Paint;
use crate::shading::seen_normal;

/// BP-06: a lamp behind the surface must not light its rim.
pub(super) const BEHIND: Case = Case {
    id: "BP-06",
    chapter: CHAPTER,
    input: "a smooth normal that points away, a lamp behind",
    most: UNLIMITED,
    naive_fails: |trial| {
        let Rim { hit, toward_eye, .. } = rim(trial);
        rim(trial).is_lit(naive::seen_normal(hit.normal, toward_eye))
    },
    robust_fails: |trial| {
        let Rim { hit, toward_eye, .. } = rim(trial);
        rim(trial).is_lit(seen_normal(&hit, toward_eye))
    },
};

struct Rim {
    hit: Hit,
    toward_eye: Vec3,
    toward_light: Vec3,
}

/// The surface's own normal faces the eye by a little, the smooth one is turned away from both by up
/// to 0.3; the lamp is behind the surface by either.
fn rim(trial: u64) -> Rim {
    let mut stream = Stream::of_trial(406, trial);
    let toward_eye = direction(&mut stream);
    let across = toward_eye.any_orthonormal_vector();
    let tilted = |tilt: f32| (across + tilt * toward_eye).normalize();
    let geometric = tilted(stream.between(0.001, 0.2));
    let normal = tilted(-stream.between(0.0, 0.3));
    let hit =
        Hit { t: 1.0, point: Vec3::ZERO, error: Vec3::ZERO, geometric, normal, uv: Vec2::ZERO };
    let mut toward_light = direction(&mut stream);
    while [geometric, normal].iter().any(|normal| normal.dot(toward_light) > -0.05) {
        toward_light = direction(&mut stream);
    }
    Rim { hit, toward_eye, toward_light }
}

impl Rim {
    fn is_lit(&self, normal: Vec3) -> bool {
        let material = BlinnPhong::matte(Paint::Plain(Color::ONE));
        let surface = material.at::<false>(Vec2::ZERO);
        let arriving = Arriving { toward: self.toward_light, distance: 3.0, color: Color::ONE };
        Blinn::returned(&surface, normal, self.toward_eye, &arriving) != Color::ZERO
    }
}
