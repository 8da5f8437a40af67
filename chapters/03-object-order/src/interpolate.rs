//! Depth and barycentric coordinates at any sample of the film, perspective-correct.
//!
//! After Olano and Greer, "Triangle Scan Conversion Using 2D Homogeneous Coordinates" (Graphics
//! Hardware 1997): the functions need no division at the corners, so a triangle that reaches behind
//! the eye has them too.

use glam::{DVec2, DVec3};

use crate::project::FilmPoint;

// ANCHOR: functions
/// What a triangle is at a sample of the film, as linear functions of the sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interpolation {
    /// 1/w.
    inverse_depth: DVec3,
    /// The second corner's share, over w.
    second: DVec3,
    /// The third corner's share, over w.
    third: DVec3,
}
// ANCHOR_END: functions

/// A triangle at one sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Depth along the line of sight, in units of the scene.
    pub depth: f64,
    /// The shares of the three corners; they add up to 1.
    pub barycentric: DVec3,
}

impl Interpolation {
    // ANCHOR: new
    /// The functions of a triangle; None when it is seen exactly edge-on.
    pub fn new([a, b, c]: [FilmPoint; 3]) -> Option<Self> {
        let corner = a.vector();
        let (to_b, to_c) = (b.vector() - corner, c.vector() - corner);
        let normal = to_b.cross(to_c);
        let volume = normal.dot(corner);
        (volume != 0.0 && volume.is_finite()).then(|| Self {
            inverse_depth: normal / volume,
            second: to_c.cross(corner) / volume,
            third: corner.cross(to_b) / volume,
        })
    }
    // ANCHOR_END: new

    // ANCHOR: at
    /// 1/w at a sample (in pixels): all that the depth test needs.
    pub fn inverse_depth(&self, sample: DVec2) -> f64 {
        self.inverse_depth.dot(sample.extend(1.0))
    }

    /// Depth and shares at a sample: the one division of a pixel.
    pub fn surface(&self, sample: DVec2) -> Surface {
        let sample = sample.extend(1.0);
        let depth = 1.0 / self.inverse_depth.dot(sample);
        let (b, c) = (self.second.dot(sample) * depth, self.third.dot(sample) * depth);
        Surface { depth, barycentric: DVec3::new(1.0 - b - c, b, c) }
    }
    // ANCHOR_END: at
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::DVec3;

    use super::{FilmPoint, Interpolation};

    #[test]
    fn depth_by_hand() {
        // The book's worked number: half way on the film between w = 1 and w = 3, 1/w is 2/3.
        let near = FilmPoint { x: 0.0, y: 0.0, w: 1.0 };
        let far = FilmPoint { x: 24.0, y: 0.0, w: 3.0 };
        let below = FilmPoint { x: 0.0, y: 10.0, w: 1.0 };
        let surface = Interpolation::new([near, far, below])
            .expect("it faces the eye")
            .surface(glam::DVec2::new(4.0, 0.0));
        assert!((surface.depth - 1.5).abs() < 1e-15);
        assert!((surface.barycentric - DVec3::new(0.75, 0.25, 0.0)).length() < 1e-15);
    }

    #[test]
    fn any_point_of_a_triangle_is_found_again() {
        for trial in 0..100_000 {
            let mut stream = Stream::of_trial(3, trial);
            let mut coordinate = |most: f32| f64::from(stream.between(-most, most));
            // Corners behind the eye too.
            let corners: [DVec3; 3] = std::array::from_fn(|_| {
                DVec3::new(coordinate(900.0), coordinate(700.0), coordinate(2.0))
            });
            let (b, c) = (coordinate(0.5) + 0.5, coordinate(0.5) + 0.5);
            let shares = if b + c < 1.0 { [b, c] } else { [1.0 - b, 1.0 - c] };
            let shares = DVec3::new(1.0 - shares[0] - shares[1], shares[0], shares[1]);
            let point = corners[0] * shares.x + corners[1] * shares.y + corners[2] * shares.z;
            let sharpness = corners[0]
                .normalize()
                .dot((corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize());
            if point.z < 1e-3 || sharpness.abs() < 1e-6 {
                continue;
            }
            let found = Interpolation::new(corners.map(FilmPoint::from))
                .expect("not edge-on")
                .surface(FilmPoint::from(point).divide());
            assert!((found.depth / point.z - 1.0).abs() < 1e-6, "trial {trial}: {found:?}");
            assert!((found.barycentric - shares).length() < 1e-6, "trial {trial}: {found:?}");
        }
    }
}
