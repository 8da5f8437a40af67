//! Whether a ray meets a box, in `f64` from the same `f32` numbers.

use ray_casting::ray::Ray;

use crate::aabb::Aabb;

/// What `f64` says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The ray meets the box, faces and edges included.
    Met,
    /// It stays clear of it by more than the margin.
    Missed,
    /// Neither: a careful test may say yes.
    Close,
}

/// Whether the ray meets the box at a `t` from 0 to `t_max`, and if not, whether it stays clear of it
/// by more than `margin`. A ray beside a slab is asked where it is, and nothing divided.
pub fn verdict(ray: &Ray, bounds: &Aabb, t_max: f64, margin: f64) -> Verdict {
    match (meets(ray, bounds, t_max, 0.0), meets(ray, bounds, t_max, margin)) {
        (true, _) => Verdict::Met,
        (_, true) => Verdict::Close,
        _ => Verdict::Missed,
    }
}

fn meets(ray: &Ray, bounds: &Aabb, t_max: f64, margin: f64) -> bool {
    crossing(ray, bounds, margin)
        .is_some_and(|[enter, leave]| f64::max(enter, 0.0) <= f64::min(leave, t_max))
}

/// Where the ray's line enters and leaves the box when its faces are moved outward by `margin`. None
/// when it misses it.
pub fn crossing(ray: &Ray, bounds: &Aabb, margin: f64) -> Option<[f64; 2]> {
    let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let (min, max) = (bounds.min.as_dvec3() - margin, bounds.max.as_dvec3() + margin);
    let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..3 {
        let (below, above) = (min[axis] - o[axis], max[axis] - o[axis]);
        if d[axis] == 0.0 {
            if !(below <= 0.0 && above >= 0.0) {
                return None;
            }
            continue;
        }
        let (low, high) = (below / d[axis], above / d[axis]);
        let (near, far) = if d[axis] > 0.0 { (low, high) } else { (high, low) };
        enter = enter.max(near);
        leave = leave.min(far);
    }
    (enter <= leave).then_some([enter, leave])
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use ray_casting::ray::Ray;

    use super::{Verdict, crossing, verdict};
    use crate::aabb::Aabb;

    const LOPSIDED: Aabb =
        Aabb { min: Vec3::new(4.0, -7.0, 10.0), max: Vec3::new(5.0, -5.0, 13.0) };

    #[test]
    fn a_crossing_by_hand() {
        let ray = Ray { origin: Vec3::ZERO, direction: Vec3::new(2.0, -3.0, 6.0) };
        assert_eq!(crossing(&ray, &LOPSIDED, 0.0), Some([2.0, 13.0 / 6.0]));
        assert_eq!(crossing(&ray, &LOPSIDED, 1.0), Some([1.5, 14.0 / 6.0]));
    }

    #[test]
    fn a_ray_beside_the_box_is_close_within_the_margin() {
        let beside = |y: f32| Ray { origin: Vec3::new(0.0, y, 11.0), direction: Vec3::X };
        let ask = |y: f32| verdict(&beside(y), &LOPSIDED, 9.0, 0.5);
        assert_eq!(
            [ask(-5.0), ask(-4.6), ask(-4.4)],
            [Verdict::Met, Verdict::Close, Verdict::Missed]
        );
        assert_eq!(verdict(&beside(-6.0), &LOPSIDED, 3.0, 0.5), Verdict::Missed, "t_max");
    }
}
