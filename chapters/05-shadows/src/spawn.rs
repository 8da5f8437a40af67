//! Where a ray that leaves a surface has to start.

use glam::Vec3;
use ray_casting::rounding::gamma;
use ray_casting::shape::Hit;

// ANCHOR: spawn
/// The origin of a ray that leaves the surface at `hit` on the side of `direction`, whatever that
/// one's length.
///
/// Pharr, Jakob and Humphreys, "Physically Based Rendering" (fourth edition, 2023), section 6.8.6.
#[inline(always)]
pub fn spawn(hit: &Hit, direction: Vec3) -> Vec3 {
    leave(hit, direction, reach(hit))
}

/// How far from its point, along its normal, the surface at `hit` may be.
#[inline(always)]
fn reach(hit: &Hit) -> f32 {
    hit.geometric.abs().dot(hit.error)
}
// ANCHOR_END: spawn

/// The same for a surface that is asked from `distance` away, an upper bound of it.
///
/// Shapes know their own error for rays that start beside them. The longer the way, the more is
/// rounded: at most 32 roundings of the distance, and for a sphere as many of its radius, of which
/// `hit.error` has seven. A plane needs four and a triangle six.
#[inline(always)]
pub(crate) fn spawn_far(hit: &Hit, direction: Vec3, distance: f32) -> Vec3 {
    leave(hit, direction, 5.0 * reach(hit) + const { gamma(32) } * distance)
}

// ANCHOR: leave
/// The point of `hit`, moved `distance` or a little more along the surface's own normal to the side
/// of `direction`.
#[inline(always)]
fn leave(hit: &Hit, direction: Vec3, distance: f32) -> Vec3 {
    let normal = hit.geometric;
    let outward = normal.dot(direction) >= 0.0;
    let offset = if outward { ENOUGH * distance } else { -ENOUGH * distance } * normal;
    let moved = hit.point + offset;
    // The sum was rounded, maybe backwards. A float or two further it is not.
    let further = moved + (f32::EPSILON * moved.abs()).copysign(offset);
    Vec3::select(normal.abs().cmplt(ASIDE), moved, further)
}

/// An axis that the normal leans to by less than this has less than 1/256 of the offset. Floats may
/// be far apart there, and a step would lead along the surface instead of away from it.
const ASIDE: Vec3 = Vec3::splat(1.0 / 16.0);

/// What makes up for the parts of two such axes.
const ENOUGH: f32 = 1.0 + 1.0 / 64.0;
// ANCHOR_END: leave

#[cfg(test)]
mod tests {
    use glam::{Vec2, Vec3};
    use ray_casting::shape::Hit;

    use super::spawn;

    fn hit(point: Vec3, geometric: Vec3, error: Vec3) -> Hit {
        Hit { t: 1.0, point, error, geometric, normal: geometric, uv: Vec2::ZERO }
    }

    #[test]
    fn the_page_s_worked_number() {
        // The normal is (0.6, 0.8, 0) and the point may be off by (1, 2, 4) steps of 2^-20: along
        // the normal that is 0.6 + 1.6 = 2.2 steps, of which 1.32 go along x and 1.76 along y.
        let step = 1.0 / 1_048_576.0;
        let hit = hit(Vec3::splat(0.5), Vec3::new(0.6, 0.8, 0.0), step * Vec3::new(1.0, 2.0, 4.0));
        let moved = (spawn(&hit, Vec3::X) - hit.point) / step;
        assert!((moved - Vec3::new(1.32, 1.76, 0.0)).length() < 0.2, "{moved}");
        let moved = (spawn(&hit, Vec3::NEG_Y) - hit.point) / step;
        assert!((moved + Vec3::new(1.32, 1.76, 0.0)).length() < 0.2, "the other side: {moved}");
    }

    #[test]
    fn an_offset_below_half_a_float_is_a_float_or_two() {
        let hit = hit(Vec3::new(7.0, -3.0, 2.0), Vec3::NEG_Y, Vec3::splat(1e-12));
        let floats = |origin: Vec3| (origin - hit.point) / f32::EPSILON;
        let [down, up] = [Vec3::NEG_Y, Vec3::Y].map(|direction| floats(spawn(&hit, direction)));
        assert!(down.x == 0.0 && down.z == 0.0 && (-4.0..=-2.0).contains(&down.y), "{down}");
        assert!(up.x == 0.0 && up.z == 0.0 && (2.0..=4.0).contains(&up.y), "{up}");
    }

    #[test]
    fn the_length_of_the_direction_does_not_matter() {
        let hit = hit(Vec3::new(7.0, -3.0, 2.0), Vec3::new(0.6, 0.0, 0.8), Vec3::splat(1e-6));
        let direction = Vec3::new(3.0, 5.0, -2.0);
        assert_eq!(spawn(&hit, direction), spawn(&hit, 1e-20 * direction));
        assert!(spawn(&hit, Vec3::NAN).is_finite());
    }
}
