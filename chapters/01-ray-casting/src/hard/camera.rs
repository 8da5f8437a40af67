//! RC-08: cameras that look almost straight up.

use common::hard::{Case, UNLIMITED};
use common::sampler::Stream;
use glam::Vec3;

use super::{CHAPTER, draw};
use crate::camera::{Camera, Frame, View};
use crate::naive;

/// RC-08: an up direction that says next to nothing.
pub(super) const UPRIGHT: Case = Case {
    id: "RC-08",
    chapter: CHAPTER,
    input: "an up direction within 10^-9 to 10^-1 of the line of sight",
    most: UNLIMITED,
    naive_fails: |trial| !is_frame(&naive::frame(&upright(trial))),
    robust_fails: |trial| {
        // To refuse such a view is as good as to draw it.
        Camera::new(&upright(trial), 4, 3).is_ok_and(|camera| !is_frame(&camera.frame()))
    },
};

fn upright(trial: u64) -> View {
    let mut stream = Stream::of_trial(208, trial);
    let eye = draw::in_cube(&mut stream, 5.0);
    let target = eye + draw::in_cube(&mut stream, 3.0) + Vec3::splat(0.1);
    let off = draw::in_cube(&mut stream, 1.0) * draw::decade(&mut stream, -9.0, -1.0);
    let up = (target - eye) * stream.between(0.2, 4.0) + off;
    View { eye, target, up, vertical_fov: 50.0 }
}

/// Three axes of length 1 at right angles, to eight units in the last place.
fn is_frame(frame: &Frame) -> bool {
    let [right, up, forward] = [frame.right, frame.up, frame.forward].map(|axis| axis.as_dvec3());
    let lengths = [right, up, forward].map(|axis| (axis.length() - 1.0).abs());
    let angles = [right.dot(up), up.dot(forward), forward.dot(right)].map(f64::abs);
    let bound = 8.0 * f64::from(f32::EPSILON);
    lengths.iter().chain(&angles).all(|&error| error <= bound)
}
