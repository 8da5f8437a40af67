//! Axes around a direction.

use glam::Vec3;

// ANCHOR: frame
/// Three directions at right angles, each of length 1: right-handed, so that `tangent` cross
/// `bitangent` is `normal`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The x axis.
    pub tangent: Vec3,
    /// The y axis.
    pub bitangent: Vec3,
    /// The z axis.
    pub normal: Vec3,
}

impl Frame {
    /// A frame whose z axis is `normal`, a direction of length 1.
    ///
    /// Duff, Burgess, Christensen, Hery, Kensler, Liani and Villemin, "Building an orthonormal basis,
    /// revisited" (Journal of Computer Graphics Techniques 6(1), 2017), listing 3.
    #[inline]
    pub fn around(normal: Vec3) -> Self {
        // The sign of -0 is -1 here. With a sign of 0 the next line would divide by 0.
        let sign = 1f32.copysign(normal.z);
        let a = -1.0 / (sign + normal.z);
        let b = normal.x * normal.y * a;
        let tangent = Vec3::new(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
        let bitangent = Vec3::new(b, sign + normal.y * normal.y * a, -normal.y);
        Self { tangent, bitangent, normal }
    }

    /// The world's vector for one along these axes.
    #[inline]
    pub fn to_world(&self, local: Vec3) -> Vec3 {
        local.x * self.tangent + local.y * self.bitangent + local.z * self.normal
    }

    /// The vector along these axes for one of the world.
    #[inline]
    pub fn to_local(&self, world: Vec3) -> Vec3 {
        Vec3::new(world.dot(self.tangent), world.dot(self.bitangent), world.dot(self.normal))
    }
}
// ANCHOR_END: frame

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::Vec3;

    use super::Frame;

    /// The largest part by which the axes miss right angles and length 1, in f64.
    fn error(frame: &Frame) -> f64 {
        let [x, y, z] = [frame.tangent, frame.bitangent, frame.normal].map(Vec3::as_dvec3);
        let parts = [x.dot(y), y.dot(z), z.dot(x), x.length() - 1.0, y.length() - 1.0];
        parts.into_iter().map(f64::abs).fold(0.0, f64::max)
    }

    #[test]
    fn right_angles_around_every_direction() {
        let corners = [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z];
        let published = [
            Vec3::new(0.000_385_273_16, 0.000_384_600_16, -0.999_999_9),
            Vec3::new(-0.000_198_135_81, -0.000_089_468_39, -0.999_999_9),
            Vec3::new(1.0, 0.0, -0.0),
        ];
        for normal in corners.into_iter().chain(published) {
            assert!(error(&Frame::around(normal)) < 4e-7, "{normal}");
        }
        for trial in 0..100_000 {
            let mut stream = Stream::of_trial(1101, trial);
            let mut component = || stream.between(-1.0, 1.0);
            let normal = Vec3::new(component(), component(), component()).normalize_or(Vec3::Z);
            let frame = Frame::around(normal);
            assert!(error(&frame) < 1e-6, "{normal}");
            assert!((frame.tangent.cross(frame.bitangent) - normal).length() < 1e-6);
        }
    }

    #[test]
    fn there_and_back() {
        let frame = Frame::around(Vec3::new(0.6, 0.0, -0.8));
        let vector = Vec3::new(3.0, -1.0, 2.0);
        assert!((frame.to_world(frame.to_local(vector)) - vector).length() < 1e-6);
        assert_eq!(frame.to_world(Vec3::Z), Vec3::new(0.6, 0.0, -0.8));
    }
}
