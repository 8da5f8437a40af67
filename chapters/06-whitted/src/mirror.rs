//! Which way a mirror sends a ray on.

use common::tally::Event;
use glam::Vec3;
use ray_casting::direction::unit;
use ray_casting::ray::Ray;
use ray_casting::shape::Hit;
use shadows::spawn::spawn;

/// Rays that leave a mirror.
pub const MIRROR_RAYS: Event = Event::new(6, 0, "mirror_rays");

// ANCHOR: reflect
/// The direction that a mirror turns `incoming` into: what runs along the normal is turned round,
/// what runs along the surface stays. It is the same for a normal that points to the other side.
pub fn reflect(incoming: Vec3, normal: Vec3) -> Vec3 {
    incoming - 2.0 * incoming.dot(normal) * normal
}
// ANCHOR_END: reflect

/// How far a mirrored ray rises at least, for each unit of its length. The roundings of a direction
/// and of its scalar product with a normal are below 8 · 2⁻²⁴; twice that leaves no doubt.
const LEAST_RISE: f32 = 16.0 * f32::EPSILON / 2.0;

// ANCHOR: leaving
/// The direction, of length 1, in which a ray goes on that came in along `incoming` and met a
/// mirror: by the normal it is shaded with, but never into the surface.
///
/// None where numbers end: a direction that isn't finite.
pub fn leaving(incoming: Vec3, hit: &Hit) -> Option<Vec3> {
    // The side it came from. In f64, or rounding decides for rays that all but run along the surface.
    let against = incoming.as_dvec3().dot(hit.geometric.as_dvec3()) < 0.0;
    let outward = if against { hit.geometric } else { -hit.geometric };
    let direction = unit(reflect(incoming, hit.normal))?;

    // A normal that isn't the surface's own can send the ray below the horizon, and so can rounding.
    // Then it goes along the horizon, as near to where it was sent as can be.
    let rise = direction.dot(outward);
    if rise >= LEAST_RISE {
        return Some(direction);
    }
    unit(direction + (LEAST_RISE - rise) * outward)
}
// ANCHOR_END: leaving

// ANCHOR: mirrored
/// The ray that leaves a mirror which `ray` met at `hit`.
pub fn mirrored(ray: &Ray, hit: &Hit) -> Option<Ray> {
    let direction = leaving(ray.direction, hit)?;
    Some(Ray { origin: spawn(hit, direction), direction })
}
// ANCHOR_END: mirrored

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::{Vec2, Vec3};
    use ray_casting::direction::unit;
    use ray_casting::shape::Hit;

    use super::{LEAST_RISE, leaving, reflect};

    fn any(stream: &mut Stream) -> Vec3 {
        let mut component = || stream.between(-1.0, 1.0);
        unit(Vec3::new(component(), component(), component())).unwrap_or(Vec3::X)
    }

    fn hit(geometric: Vec3, normal: Vec3) -> Hit {
        Hit { t: 1.0, point: Vec3::ZERO, error: Vec3::ZERO, geometric, normal, uv: Vec2::ZERO }
    }

    #[test]
    fn a_mirror_by_hand() {
        // The page's worked number: (2, -3, 6) / 7 on a floor; only y is turned round.
        let incoming = Vec3::new(2.0, -3.0, 6.0) / 7.0;
        assert_eq!(reflect(incoming, Vec3::Y), Vec3::new(2.0, 3.0, 6.0) / 7.0);
        // And on a slanted mirror: 3-4-5, d · n = -0.8.
        let slanted = reflect(Vec3::NEG_Y, Vec3::new(0.6, 0.8, 0.0));
        assert!((slanted - Vec3::new(0.96, 0.28, 0.0)).length() < 1e-6);
    }

    #[test]
    fn twice_is_the_way_back_and_either_side_is_one_mirror() {
        for trial in 0..10_000 {
            let mut stream = Stream::of_trial(61, trial);
            let (incoming, normal) = (any(&mut stream), any(&mut stream));
            let reflected = reflect(incoming, normal);
            // A normal whose length is 2 ε wrong counts four times in each.
            assert!((reflect(reflected, normal) - incoming).length() < 2.5e-6);
            assert_eq!(reflect(incoming, -normal), reflected);
        }
    }

    #[test]
    fn a_mirrored_ray_leaves_the_surface_whatever_it_is_shaded_with() {
        let mut below = 0;
        for trial in 0..100_000 {
            let mut stream = Stream::of_trial(62, trial);
            let hit = hit(any(&mut stream), any(&mut stream));
            let incoming = any(&mut stream);
            let outward = -hit.geometric * incoming.dot(hit.geometric).signum();
            let direction = leaving(incoming, &hit).expect("finite");
            assert!(direction.dot(outward) > 0.0, "{hit:?}");
            assert!((direction.length() - 1.0).abs() < 1e-6);
            let plain = reflect(incoming, hit.normal);
            below += u32::from(plain.dot(outward) < LEAST_RISE);
            let kept = plain.dot(outward) < 2.0 * LEAST_RISE || (plain - direction).length() < 1e-6;
            assert!(kept, "what is above the horizon stays where it is");
        }
        assert!(below > 10_000, "the control: normals that send the ray below");
    }

    #[test]
    fn no_direction_no_mirror() {
        assert_eq!(leaving(Vec3::NAN, &hit(Vec3::Y, Vec3::Y)), None);
    }
}
