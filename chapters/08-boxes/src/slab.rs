//! The slab test: whether a ray meets a box, and never no when it meets what is in it.

use common::tally::Event;
use glam::{BVec4A, Vec3, Vec4};
use ray_casting::ray::Ray;

use crate::aabb::Aabb;

/// Questions asked of a box: does this ray meet you?
pub const BOX_TESTS: Event = Event::new(8, 0, "box_tests");

// ANCHOR: ray
/// A ray made ready to be tested against many boxes.
///
/// On each axis a box has one face that the ray meets first, the near one, and one that it leaves
/// by, the far one. Which is which depends on the ray alone, and so does all that keeps the test on
/// the safe side: near faces are measured from an origin moved a little ahead and by a reciprocal a
/// little too small, far ones the other way. So safety costs nothing for each box.
///
/// The fourth lane is no axis: there the interval from 0 to `t_max` is a pair of faces like any other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxRay {
    /// Where it runs downwards, so that a box's greatest coordinate comes first.
    downward: BVec4A,
    near_origin: Vec4,
    far_origin: Vec4,
    near_inverse: Vec4,
    far_inverse: Vec4,
}
// ANCHOR_END: ray

// ANCHOR: pad
/// How far a face is moved outward, as a part of the distance between the ray's origin and the
/// farthest corner of the scene: 16 u, where u is 2⁻²⁴. About a millionth.
///
/// The watertight triangle test moves a corner by up to 4 u of that distance, two differences here
/// by 1 u each; the sphere and the quad of chapter 1 take up to 14 u. See the page of chapter 8.
pub const PAD: f32 = 8.0 * f32::EPSILON;

/// How much a reciprocal is changed, as a part of it: 6 u, of which four roundings take 4.
///
/// Ize, "Robust BVH Ray Traversal" (Journal of Computer Graphics Techniques 2(2), 2013), widens the
/// interval by such a factor for each box. Moving the reciprocals instead is Embree's way (its flag
/// "robust"), and costs nothing for each box.
pub const STRETCH: f32 = 3.0 * f32::EPSILON;
// ANCHOR_END: pad

impl BoxRay {
    // ANCHOR: new
    /// Makes `ray` ready for boxes inside `scene_bounds`.
    ///
    /// A ray that isn't finite or has no direction hits nothing, and so meets no box.
    #[inline]
    pub fn new(ray: &Ray, scene_bounds: &Aabb) -> Self {
        let Ray { origin, direction } = *ray;
        if !(origin.is_finite() && direction.is_finite() && direction != Vec3::ZERO) {
            return Self::NOWHERE;
        }
        // The sum turns -0 into 0, and changes nothing else: both are one direction, and get one
        // answer, even where a face lies exactly a pad away.
        let inverse = (direction + Vec3::ZERO).recip();
        let downward = inverse.cmplt(Vec3::ZERO);
        let pad = margin(origin, PAD * reach(origin, scene_bounds));
        let (below, above) = (origin - pad, origin + pad);
        let greatest = Vec3::splat(f32::MAX);
        // Held below infinity: a ray may run in the plane of a face, and 0 * inf is NaN.
        let near_inverse = (inverse * (1.0 - STRETCH)).clamp(-greatest, greatest);
        Self {
            downward: inverse.extend(1.0).cmplt(Vec4::ZERO),
            near_origin: Vec3::select(downward, below, above).extend(0.0),
            far_origin: Vec3::select(downward, above, below).extend(0.0),
            near_inverse: near_inverse.extend(1.0),
            far_inverse: (inverse * (1.0 + STRETCH)).extend(1.0),
        }
    }
    // ANCHOR_END: new

    /// A ray that meets no box: every near face is infinitely far ahead.
    const NOWHERE: Self = Self {
        downward: BVec4A::FALSE,
        near_origin: Vec4::NEG_INFINITY,
        far_origin: Vec4::INFINITY,
        near_inverse: Vec4::ONE,
        far_inverse: Vec4::ONE,
    };

    /// The same numbers sorted by face instead of by nearness, for layouts that test several boxes
    /// at once.
    #[inline]
    pub fn by_face(&self) -> FaceRay {
        let Self { downward, near_origin, far_origin, near_inverse, far_inverse } = *self;
        FaceRay {
            downward,
            min_origin: Vec4::select(downward, far_origin, near_origin),
            max_origin: Vec4::select(downward, near_origin, far_origin),
            min_inverse: Vec4::select(downward, far_inverse, near_inverse),
            max_inverse: Vec4::select(downward, near_inverse, far_inverse),
        }
    }

    // ANCHOR: enter
    /// Where the ray enters the box, 0 for a ray that starts in it; None when it doesn't between 0
    /// and `t_max`, both included.
    ///
    /// Whatever in the box the ray hits at a `t` up to `t_max`: this is not None, and not above `t`.
    /// It may say yes to a box that is missed by a hair. `t_max` is included so that of two hits at
    /// the same distance none is lost. An empty box is never met, nor one with NaN in it.
    #[inline]
    pub fn enter(&self, bounds: &Aabb, t_max: f32) -> Option<f32> {
        let (min, max) = (bounds.min.extend(0.0), bounds.max.extend(t_max));
        let near = Vec4::select(self.downward, max, min);
        let far = Vec4::select(self.downward, min, max);
        let near = (near - self.near_origin) * self.near_inverse;
        let far = (far - self.far_origin) * self.far_inverse;

        // It is in once it has passed the last near face, and out at the first far one.
        let (enter, leave) = (near.max_element(), far.min_element());
        (enter <= leave && near.cmple(far).all()).then_some(enter)
    }
    // ANCHOR_END: enter
}

/// A [`BoxRay`] sorted by face: on each axis the ray passes the plane of a box's `min` at
/// `(min - min_origin) * min_inverse`, and that of its `max` likewise. The fourth lanes mean nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceRay {
    /// Where it runs downwards, so that `max` is the near face.
    pub downward: BVec4A,
    /// Where `min` is measured from.
    pub min_origin: Vec4,
    /// Where `max` is measured from.
    pub max_origin: Vec4,
    /// What `min` is multiplied by.
    pub min_inverse: Vec4,
    /// What `max` is multiplied by.
    pub max_inverse: Vec4,
}

/// A little more than `pad`, so that the sum of it and `origin` is at least `pad` away from `origin`
/// whatever the sum's rounding, which is up to u of each. Near 0 one of the least numbers does.
#[inline]
fn margin(origin: Vec3, pad: f32) -> Vec3 {
    origin.abs() * f32::EPSILON + (pad * (1.0 + STRETCH) + f32::MIN_POSITIVE)
}

// ANCHOR: reach
/// The largest distance, along any axis, from `origin` to a corner of the scene; 0 when it is empty.
#[inline]
fn reach(origin: Vec3, scene_bounds: &Aabb) -> f32 {
    if scene_bounds.is_empty() {
        return 0.0;
    }
    let (below, above) = (scene_bounds.min - origin, scene_bounds.max - origin);
    below.abs().max(above.abs()).max_element().min(f32::MAX)
}
// ANCHOR_END: reach

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::Vec3;
    use ray_casting::ray::Ray;

    use super::BoxRay;
    use crate::aabb::Aabb;

    /// One wide, two high, three deep.
    const LOPSIDED: Aabb =
        Aabb { min: Vec3::new(4.0, -7.0, 10.0), max: Vec3::new(5.0, -5.0, 13.0) };

    const FAR: f32 = f32::INFINITY;

    fn enter(origin: Vec3, direction: Vec3, t_max: f32) -> Option<f32> {
        BoxRay::new(&Ray { origin, direction }, &LOPSIDED).enter(&LOPSIDED, t_max)
    }

    /// The page's worked number.
    #[test]
    fn a_box_by_hand() {
        // From the origin along (2, -3, 6): in x from 2 to 2.5, y from 5/3 to 7/3, z from 5/3 to
        // 13/6. So it is in the box from 2 to 13/6.
        let direction = Vec3::new(2.0, -3.0, 6.0);
        let found = enter(Vec3::ZERO, direction, FAR).expect("it is met");
        assert!(found <= 2.0 && found > 1.9999, "{found}");
        assert_eq!(enter(Vec3::ZERO, direction, 2.0), Some(found), "t_max is included");
        assert_eq!(enter(Vec3::ZERO, direction, 1.999), None);
        assert_eq!(enter(Vec3::ZERO, -direction, FAR), None, "behind");
        // Along (2, -3, 12) it is out of z's slab at 13/12, before it is in the others.
        assert_eq!(enter(Vec3::ZERO, Vec3::new(2.0, -3.0, 12.0), FAR), None);
    }

    /// A ray from inside, a ray that ends before the box, and rays that are no rays.
    #[test]
    fn the_ends_of_the_ray() {
        let inside = Vec3::new(4.5, -6.0, 11.0);
        assert_eq!(enter(inside, Vec3::new(1.0, 2.0, -3.0), FAR), Some(0.0));
        assert_eq!(enter(inside, Vec3::X, 0.0), Some(0.0));
        for t_max in [-1.0, f32::NEG_INFINITY, f32::NAN] {
            assert_eq!(enter(inside, Vec3::X, t_max), None, "{t_max}");
        }
        for (origin, direction) in [
            (inside, Vec3::ZERO),
            (inside, Vec3::NAN),
            (inside, Vec3::X * f32::INFINITY),
            (Vec3::NAN, Vec3::X),
            (Vec3::NEG_INFINITY, Vec3::X),
        ] {
            assert_eq!(enter(origin, direction, FAR), None, "{origin} {direction}");
        }
    }

    /// What is entered is never above the true distance, and less by a millionth or so.
    #[test]
    fn the_distance_agrees_with_f64() {
        let mut met = 0;
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(803, trial);
            let mut point = |side: f32| {
                let mut component = || stream.between(-side, side);
                Vec3::new(component(), component(), component())
            };
            let (corners, origin) = ([point(3.0), point(3.0)], point(8.0));
            let ray = Ray { origin, direction: point(2.0) - origin };
            let bounds = Aabb::of_points(corners);
            let (d, o) = (ray.direction.as_dvec3(), origin.as_dvec3());
            let (low, high) = ((bounds.min.as_dvec3() - o) / d, (bounds.max.as_dvec3() - o) / d);
            let exact = low.min(high).max_element().max(0.0);
            let is_met = exact <= low.max(high).min_element();
            let found = BoxRay::new(&ray, &bounds).enter(&bounds, FAR);
            assert!(found.is_some() || !is_met, "{trial}");
            met += u32::from(is_met);
            if let (Some(found), true) = (found, is_met) {
                // A millionth of the distance, over a component of the direction.
                let slack = 2e-6 * 11.0 / d.abs().min_element() + 1e-6 * exact;
                assert!(f64::from(found) <= exact && exact - f64::from(found) < slack, "{trial}");
            }
        }
        assert!(met > 10_000, "{met}");
    }

    /// Hard case BX-07: what isn't there is not met, from wherever.
    #[test]
    fn empty_boxes_and_nan_are_never_met() {
        let nan = |axis: usize, low: bool| {
            let mut bounds = Aabb { min: Vec3::splat(-9.0), max: Vec3::splat(9.0) };
            let corner = if low { &mut bounds.min } else { &mut bounds.max };
            corner[axis] = f32::NAN;
            bounds
        };
        let mut boxes = vec![Aabb::EMPTY, Aabb { min: Vec3::NAN, max: Vec3::NAN }];
        boxes.extend((0..3).flat_map(|axis| [nan(axis, true), nan(axis, false)]));
        for direction in [Vec3::X, -Vec3::X, Vec3::Y, -Vec3::Z, Vec3::new(1.0, -2.0, 3.0)] {
            for scene in [LOPSIDED, Aabb::EMPTY] {
                let ray = BoxRay::new(&Ray { origin: Vec3::ONE, direction }, &scene);
                for bounds in &boxes {
                    assert_eq!(ray.enter(bounds, FAR), None, "{bounds:?}");
                }
            }
        }
    }
}
