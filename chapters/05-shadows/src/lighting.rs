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

#[cfg(test)]
mod tests {
    use blinn_phong::light::{Arriving, Light};
    use common::film::Color;
    use common::tally::{Counts, Off};
    use glam::{Vec2, Vec3};
    use ray_casting::shape::{Hit, Shape};
    use ray_casting::sphere::Sphere;

    use super::from_lamps;
    use crate::visibility::SHADOW_RAYS;

    const RED: Color = Color::new(1.0, 0.0, 0.0);
    const BLUE: Color = Color::new(0.0, 0.0, 1.0);

    /// The origin, facing up.
    const HIT: Hit = Hit {
        t: 1.0,
        point: Vec3::ZERO,
        error: Vec3::splat(1e-7),
        geometric: Vec3::Y,
        normal: Vec3::Y,
        uv: Vec2::ZERO,
    };

    /// A ball over the origin, between it and the first lamp.
    fn ball() -> [Box<dyn Shape>; 1] {
        [Box::new(Sphere { center: Vec3::Y * 3.0, radius: 0.5 })]
    }

    fn lamps() -> [Light; 3] {
        [
            Light::steady(Vec3::Y * 9.0, RED),
            Light::steady(Vec3::new(4.0, 3.0, 0.0), BLUE),
            Light::steady(Vec3::new(1.0, -2.0, 0.5), Color::ONE),
        ]
    }

    fn cosine(arriving: &Arriving) -> Color {
        arriving.color * arriving.toward.y.abs()
    }

    #[test]
    fn a_hidden_lamp_takes_only_its_own_light_away() {
        let lamps = lamps();
        let sum =
            |hit: &Hit, eye| from_lamps::<true, _>(&ball()[..], &lamps, hit, eye, &mut Off, cosine);
        assert!((sum(&HIT, Vec3::Y) - 0.6 * BLUE).length() < 1e-6);
        // From below, the third lamp alone is on the eye's side.
        let height = 2.0 / 5.25f32.sqrt();
        assert!((sum(&HIT, Vec3::NEG_Y) - Color::splat(height)).length() < 1e-6);
    }

    #[test]
    fn without_shadows_no_ray_is_sent_and_nothing_hidden() {
        let (lamps, mut counts) = (lamps(), Counts::default());
        let sum = from_lamps::<false, _>(&ball()[..], &lamps, &HIT, Vec3::Y, &mut counts, cosine);
        assert!((sum - (RED + 0.6 * BLUE)).length() < 1e-6);
        assert_eq!(counts.of(SHADOW_RAYS), 0);
        from_lamps::<true, _>(&ball()[..], &lamps, &HIT, Vec3::Y, &mut counts, cosine);
        assert_eq!(counts.of(SHADOW_RAYS), 2, "the lamp below is asked nothing");
    }

    #[test]
    fn a_lamp_at_the_point_or_on_the_horizon_gives_nothing() {
        let below = Vec3::new(3.0, -1e-9, 0.0);
        for position in [Vec3::ZERO, Vec3::X * 3.0, below, -below] {
            let lamp = [Light::steady(position, Color::ONE)];
            for eye in [Vec3::Y, Vec3::NEG_Y] {
                let sum = from_lamps::<true, _>(&ball()[..], &lamp, &HIT, eye, &mut Off, cosine);
                assert_eq!(sum, Color::ZERO, "{position}");
            }
        }
    }
}
