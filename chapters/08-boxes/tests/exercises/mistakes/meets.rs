//! What readers get wrong of exercise 8.4.

use boxes::aabb::Aabb;
use boxes::naive::{PlainRay, glam_vectors, natural, old_weekend, smits, tavian_2022};
use common::exercise::Mistake;
use glam::Vec3;

use crate::Meeting;

/// Of exercise 8.4.
pub(crate) fn meets() -> Vec<Mistake<Meeting, bool>> {
    unpadded().into_iter().chain(thicker()).chain(thicker_and_nan()).collect()
}

fn unpadded() -> [Mistake<Meeting, bool>; 5] {
    [
        Mistake {
            name: "< for <=",
            diagnosis: "You rejected an interval that is one point, as the published line does. A box \
                        without thickness is entered and left at the same t. Reject enter > leave. \
                        See 'Rays in the plane of a face'.",
            answer: |Meeting { ray, bounds }| {
                old_weekend(&PlainRay::from(ray), bounds, f32::INFINITY)
            },
        },
        Mistake {
            name: "0 times infinity",
            diagnosis: "A ray in the plane of a face is a miss with you. 0 times infinity is NaN, and \
                        f32::min and f32::max then give the other face's infinity. Compare so that \
                        NaN changes nothing. See 'Rays in the plane of a face'.",
            answer: |Meeting { ray, bounds }| natural(&PlainRay::from(ray), bounds, f32::INFINITY),
        },
        Mistake {
            name: "0 times infinity, by glam",
            diagnosis: "A ray in the plane of a face is a miss with you, for half of the faces. 0 \
                        times infinity is NaN, and of a number and NaN glam's min and max give the \
                        second. Compare so that NaN changes nothing. See 'Rays in the plane of a \
                        face'.",
            answer: |Meeting { ray, bounds }| {
                glam_vectors(&PlainRay::from(ray), bounds, f32::INFINITY)
            },
        },
        Mistake {
            name: "the sign of the direction",
            diagnosis: "You asked for the sign of the direction. -0 is not below 0, but its reciprocal \
                        is -infinity. Ask for the sign of the reciprocal. See 'Zeros with a minus'.",
            answer: |Meeting { ray, bounds }| smits(&PlainRay::from(ray), bounds, f32::INFINITY),
        },
        Mistake {
            name: "the published line of today",
            diagnosis: "You sorted the faces by asking t0 < t1, and rejected an interval that is one \
                        point. NaN answers no, so that in the plane of a face near and far change \
                        places; and a flat box is entered and left at the same t. See 'Rays in the \
                        plane of a face'.",
            answer: |Meeting { ray, bounds }| new_weekend(&PlainRay::from(ray), bounds),
        },
    ]
}

/// With a test that is right apart from the thickness, or the published one.
fn thicker() -> [Mistake<Meeting, bool>; 5] {
    [
        Mistake {
            name: "0.0001 thicker",
            diagnosis: "You gave flat boxes a thickness, in units that the scene did not promise: a \
                        small box is met from far outside. The interval may be one point. See 'Rays \
                        in the plane of a face'.",
            answer: |it| right_in_plane(it, centered),
        },
        Mistake {
            name: "0.0001 thicker where flat",
            diagnosis: "You gave a thickness to the sides that are 0, in units that the scene did not \
                        promise: a small flat box is met from far outside. Leave it flat: the \
                        interval may be one point. See 'Rays in the plane of a face'.",
            answer: |it| right_in_plane(it, |bounds| both(bounds, if_flat)),
        },
        Mistake {
            name: "0.0001 more at max",
            diagnosis: "You moved max by 0.0001, in units that the scene did not promise: a small box \
                        is met from far outside, on one side. Leave it flat: the interval may be one \
                        point. See 'Rays in the plane of a face'.",
            answer: |it| right_in_plane(it, |bounds| above(bounds, if_thin)),
        },
        Mistake {
            name: "0.0001 more at max where flat",
            diagnosis: "You moved max by 0.0001 where it is equal to min, in units that the scene did \
                        not promise: a small flat box is met from far outside, on one side. Leave it \
                        flat: the interval may be one point. See 'Rays in the plane of a face'.",
            answer: |it| right_in_plane(it, |bounds| above(bounds, if_flat)),
        },
        Mistake {
            name: "the published repair",
            diagnosis: "That is the published line of today, with its repair: boxes at least 0.0001 \
                        thick, in units that the scene did not promise, so that a small box is met \
                        from far outside. And in the plane of a face t0 < t1 is asked of NaN, so that \
                        near and far change places. See 'Rays in the plane of a face'.",
            answer: |it| new_weekend(&PlainRay::from(&it.ray), &centered(&it.bounds)),
        },
    ]
}

/// With the test as one would write it.
fn thicker_and_nan() -> [Mistake<Meeting, bool>; 5] {
    [
        Mistake {
            name: "0.0001 thicker, and 0 times infinity",
            diagnosis: "Two things. You gave flat boxes a thickness, in units that the scene did not \
                        promise: a small box is met from far outside. And a ray in the plane of a \
                        face is a miss with you: 0 times infinity is NaN. Compare so that NaN changes \
                        nothing. See 'Rays in the plane of a face'.",
            answer: |it| missed_in_plane(it, centered),
        },
        Mistake {
            name: "0.0001 thicker where flat, and 0 times infinity",
            diagnosis: "Two things. You gave a thickness to the sides that are 0, in units that the \
                        scene did not promise: a small flat box is met from far outside. And a ray in \
                        the plane of a face is a miss with you: 0 times infinity is NaN. Compare so \
                        that NaN changes nothing. See 'Rays in the plane of a face'.",
            answer: |it| missed_in_plane(it, |bounds| both(bounds, if_flat)),
        },
        Mistake {
            name: "0.0001 more at max of all boxes, and 0 times infinity",
            diagnosis: "Two things. You moved max by 0.0001, in units that the scene did not promise: \
                        a small box is met from far outside, on one side. And min is where it was: a \
                        ray in the plane of that face is a miss with you, for 0 times infinity is NaN. \
                        Compare so that NaN changes nothing. See 'Rays in the plane of a face'.",
            answer: |it| missed_in_plane(it, |bounds| above(bounds, |_| THICKNESS)),
        },
        Mistake {
            name: "0.0001 more at max of thin boxes, and 0 times infinity",
            diagnosis: "Two things. You moved max of thin sides by 0.0001, in units that the scene did \
                        not promise: a small box is met from far outside, on one side. And a ray in \
                        the plane of a face is a miss with you: 0 times infinity is NaN. Compare so \
                        that NaN changes nothing. See 'Rays in the plane of a face'.",
            answer: |it| missed_in_plane(it, |bounds| above(bounds, if_thin)),
        },
        Mistake {
            name: "0.0001 more at max where flat, and 0 times infinity",
            diagnosis: "Two things. You moved max by 0.0001 where it is equal to min, in units that \
                        the scene did not promise: a small flat box is met from far outside, on one \
                        side. And a ray in the plane of a face is a miss with you: 0 times infinity is \
                        NaN. Compare so that NaN changes nothing. See 'Rays in the plane of a face'.",
            answer: |it| missed_in_plane(it, |bounds| above(bounds, if_flat)),
        },
    ]
}

/// The length that boxes are made thicker by.
const THICKNESS: f32 = 1e-4;

fn right_in_plane(Meeting { ray, bounds }: &Meeting, thicker: fn(&Aabb) -> Aabb) -> bool {
    tavian_2022(&PlainRay::from(ray), &thicker(bounds), f32::INFINITY)
}

fn missed_in_plane(Meeting { ray, bounds }: &Meeting, thicker: fn(&Aabb) -> Aabb) -> bool {
    natural(&PlainRay::from(ray), &thicker(bounds), f32::INFINITY)
}

/// At least so thick.
fn centered(bounds: &Aabb) -> Aabb {
    let half = (0.5 * (Vec3::splat(THICKNESS) - bounds.size())).max(Vec3::ZERO);
    Aabb { min: bounds.min - half, max: bounds.max + half }
}

fn both(bounds: &Aabb, more: fn(f32) -> f32) -> Aabb {
    Aabb { min: bounds.min - each(bounds, more), ..above(bounds, more) }
}

fn above(bounds: &Aabb, more: fn(f32) -> f32) -> Aabb {
    Aabb { max: bounds.max + each(bounds, more), ..*bounds }
}

fn each(bounds: &Aabb, more: fn(f32) -> f32) -> Vec3 {
    bounds.size().to_array().map(more).into()
}

fn if_flat(side: f32) -> f32 {
    if side == 0.0 { THICKNESS } else { 0.0 }
}

fn if_thin(side: f32) -> f32 {
    if side < THICKNESS { THICKNESS } else { 0.0 }
}

/// "Ray Tracing: The Next Week", since it thickens its boxes.
fn new_weekend(ray: &PlainRay, bounds: &Aabb) -> bool {
    let (mut enter, mut leave) = (0.0, f32::INFINITY);
    for axis in 0..3 {
        let a = (bounds.min[axis] - ray.origin[axis]) * ray.inverse[axis];
        let b = (bounds.max[axis] - ray.origin[axis]) * ray.inverse[axis];
        let (near, far) = if a < b { (a, b) } else { (b, a) };
        enter = if near > enter { near } else { enter };
        leave = if far < leave { far } else { leave };
        if leave <= enter {
            return false;
        }
    }
    true
}
