//! Film coordinates as whole numbers of 1/256 pixel.

use glam::DVec2;

/// Steps in a pixel: 8 bits behind the point, as graphics cards have it.
pub const STEPS: i32 = 256;

/// The largest film coordinate that is snapped, either side of the film's corner, in pixels: 2^22.
/// With 8 bits behind the point that is 2^30, which an i32 holds with a bit to spare.
pub const GUARD: f64 = 4_194_304.0;

/// The longest side of a film, in pixels. Its far end is well inside the guard band.
pub const LONGEST_SIDE: u32 = 1 << 16;

// ANCHOR: fixed
/// A point of the film on a grid of 1/256 pixel, from the film's top left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fixed {
    /// To the right, in 1/256 pixel.
    pub x: i32,
    /// Downwards.
    pub y: i32,
}

impl Fixed {
    /// The grid point nearest to `point` (in pixels), which must lie in the guard band.
    ///
    /// It is at most half a step off in each direction, so at most 1/362 pixel away.
    pub fn snap(point: DVec2) -> Self {
        let DVec2 { x, y } = (point * f64::from(STEPS)).round();
        Self { x: x as i32, y: y as i32 }
    }
}
// ANCHOR_END: fixed

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::{DVec2, Vec2};

    use super::{Fixed, GUARD};

    #[test]
    fn snapping_moves_a_point_by_less_than_a_362nd() {
        for trial in 0..100_000 {
            let mut stream = Stream::of_trial(2, trial);
            let place = stream.uniform2() * 2e6 - Vec2::new(5e5, 9e5);
            let Fixed { x, y } = Fixed::snap(place.as_dvec2());
            let moved = place.as_dvec2() - DVec2::new(f64::from(x), f64::from(y)) / 256.0;
            assert!(moved.length() <= 1.0 / 362.0);
        }
    }

    #[test]
    fn the_guard_band_fits() {
        let corner = Fixed::snap(DVec2::new(-GUARD, GUARD));
        assert_eq!((corner.x, corner.y), (-(1 << 30), 1 << 30));
    }
}
