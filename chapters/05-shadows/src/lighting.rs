//! A surface under several lamps, each of which may be hidden.

use blinn_phong::light::{Arriving, Light};
use blinn_phong::picture::LIGHT_SAMPLES;
use common::film::Color;
use common::tally::Tally;
use glam::Vec3;
use ray_casting::rounding::gamma;
use ray_casting::shape::Hit;

use crate::occluder::Occluder;
use crate::visibility::{End, open, visible};

/// The least sine of a lamp's height over the horizon. Two directions of length 1 and their product
/// are rounded ten times: below this nobody can say on which side of the surface the lamp is.
const HORIZON: f32 = gamma(16);

// ANCHOR: from_lamps
/// What a surface sends `toward_eye` of the light of all lamps that reach it, where `returned` is
/// what it makes of one lamp's.
///
/// With `SHADOWS` false no lamp is ever hidden. That is chosen before the first ray.
#[inline]
pub fn from_lamps<const SHADOWS: bool, T: Tally>(
    scene: &(impl Occluder + ?Sized),
    lights: &[Light],
    hit: &Hit,
    toward_eye: Vec3,
    tally: &mut T,
    returned: impl Fn(&Arriving) -> Color,
) -> Color {
    sum_of_lamps(lights, hit, toward_eye, tally, returned, |light, tally| {
        !SHADOWS || reaches(scene, light, hit, tally)
    })
}

/// The same, where `reaches` says of a lamp whether it is to be seen.
#[inline]
pub fn sum_of_lamps<T: Tally>(
    lights: &[Light],
    hit: &Hit,
    toward_eye: Vec3,
    tally: &mut T,
    returned: impl Fn(&Arriving) -> Color,
    reaches: impl Fn(&Light, &mut T) -> bool,
) -> Color {
    let mut sum = Color::ZERO;
    for light in lights {
        tally.count(LIGHT_SAMPLES, 1);
        let Some(arriving) = light.at(hit.point) else { continue };
        if !same_side(hit, toward_eye, arriving.toward) {
            continue;
        }
        let color = returned(&arriving);
        // What adds nothing needs no ray.
        if color != Color::ZERO && reaches(light, tally) {
            sum += color;
        }
    }
    sum
}
// ANCHOR_END: from_lamps

// ANCHOR: same_side
/// Whether the eye and the lamp are on the same side of the surface itself, whatever the normal is
/// that it is shaded with: otherwise light would shine through.
fn same_side(hit: &Hit, toward_eye: Vec3, toward_light: Vec3) -> bool {
    let height = hit.geometric.dot(toward_light);
    let height = if hit.geometric.dot(toward_eye) < 0.0 { -height } else { height };
    height > HORIZON
}
// ANCHOR_END: same_side

// ANCHOR: reaches
/// Whether nothing hides the lamp from the surface.
pub fn reaches<T: Tally>(
    scene: &(impl Occluder + ?Sized),
    light: &Light,
    hit: &Hit,
    tally: &mut T,
) -> bool {
    match *light {
        Light::Point { position, .. } => visible(scene, End::On(hit), End::Free(position), tally),
        Light::Directional { toward, .. } => open(scene, hit, toward, tally),
    }
}
// ANCHOR_END: reaches
