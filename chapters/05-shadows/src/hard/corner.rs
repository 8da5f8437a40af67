//! SH-06: an offset by the point's own error is not enough.

use common::sampler::Stream;
use glam::Vec3;
use ray_casting::rounding::gamma;
use triangles::surface::between;

use super::draw;
use super::grid::Spot;
use crate::spawn::spawn;

/// A point near a corner near the origin: the numbers that make the point are small, and so is its
/// error. The other corners, which the test has to round as well, are far away.
fn spot(trial: u64) -> Spot {
    let mut stream = Stream::of_trial(506, trial);
    loop {
        let size = draw::decade(&mut stream, -4.0, 4.0);
        let mut corners = [(); 3].map(|()| size * draw::in_cube(&mut stream, 1.0));
        corners[0] *= draw::decade(&mut stream, -8.0, -3.0);
        let mut weights = draw::decade(&mut stream, -3.0, -0.5) * draw::weights(&mut stream);
        weights.x = 1.0 - weights.y - weights.z;
        if let Some(spot) = Spot::seen(&mut stream, corners, weights, size) {
            return spot;
        }
    }
}

/// The error of the point and nothing else: four roundings of each corner's part.
fn own_error(spot: &Spot) -> Vec3 {
    let uv = spot.hit.uv;
    let weights = Vec3::new(1.0 - uv.x - uv.y, uv.x, uv.y);
    gamma(4) * between(spot.mesh.corners(0).map(Vec3::abs), weights)
}

pub(super) fn naive(trial: u64) -> bool {
    let mut spot = spot(trial);
    spot.hit.error = own_error(&spot);
    spot.hits_itself(spawn)
}

pub(super) fn robust(trial: u64) -> bool {
    spot(trial).hits_itself(spawn)
}
