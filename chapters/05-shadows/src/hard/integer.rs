//! SH-05: steps in the last bits, and points of any size.

use common::sampler::Stream;
use glam::{Vec2, Vec3};
use ray_casting::rounding::gamma;
use ray_casting::shape::Hit;

use super::draw;
use crate::naive;
use crate::offset::Leave;
use crate::spawn::spawn;

/// A hit whose coordinates may be of very different sizes, and a direction.
fn hit(stream: &mut Stream) -> (Hit, Vec3) {
    let size = draw::whole(stream, -60, 100);
    let mut coordinate = || {
        let power = draw::power_of_two(size - draw::whole(stream, 0, 12));
        power * stream.between(-1.0, 1.0)
    };
    let point = Vec3::new(coordinate(), coordinate(), coordinate());
    let geometric = draw::direction(stream).as_vec3();
    let error = gamma(7) * point.abs();
    let direction = draw::leaving(stream, geometric);
    (Hit { t: 1.0, point, error, geometric, normal: geometric, uv: Vec2::ZERO }, direction)
}

/// Whether the origin is nearer to the surface than the error, or not where that of everything
/// times 2^k is.
fn is_wrong(trial: u64, leave: Leave) -> bool {
    let mut stream = Stream::of_trial(505, trial);
    let (hit, direction) = hit(&mut stream);
    let origin = leave(&hit, direction);
    let normal = hit.geometric.as_dvec3();
    let height = (origin.as_dvec3() - hit.point.as_dvec3()).dot(normal).abs();
    let least = normal.abs().dot(hit.error.as_dvec3());
    let scale = draw::power_of_two(draw::whole(&mut stream, -20, 20));
    let scaled = Hit { point: scale * hit.point, error: scale * hit.error, ..hit };
    !(height >= 0.999_999 * least) || leave(&scaled, direction) != scale * origin
}

pub(super) fn naive(trial: u64) -> bool {
    is_wrong(trial, naive::integer)
}

pub(super) fn robust(trial: u64) -> bool {
    is_wrong(trial, spawn)
}
