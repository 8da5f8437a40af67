//! Longitude and latitude: where on a sphere a point is.

use std::f32::consts::{PI, TAU};

use common::math;
use glam::{Vec2, Vec3, Vec3Swizzles};

// ANCHOR: uv
/// Longitude and latitude of the point with this normal, each scaled to [0, 1].
///
/// u runs once around the y axis, v from the lowest point to the highest. Both angles come from
/// `atan2`, which has a value for every pair of numbers: at the poles, where longitude means
/// nothing, and for a component that rounding carried above 1, where `acos` gives NaN.
pub fn uv(normal: Vec3) -> Vec2 {
    let longitude = math::atan2(-normal.z, normal.x);
    let latitude = math::atan2(normal.xz().length(), -normal.y);
    Vec2::new(((longitude + PI) / TAU).min(1.0), latitude / PI)
}
// ANCHOR_END: uv

#[cfg(test)]
mod tests {
    use glam::{Vec2, Vec3};

    use super::uv;

    #[test]
    fn longitude_and_latitude_of_six_directions() {
        let close = |normal, u, v| (uv(normal) - Vec2::new(u, v)).length() < 1e-6;
        assert!(
            close(Vec3::X, 0.5, 0.5) && close(-Vec3::Z, 0.75, 0.5) && close(Vec3::Z, 0.25, 0.5)
        );
        assert_eq!((uv(Vec3::Y).y, uv(-Vec3::Y).y), (1.0, 0.0));
        assert!(uv(Vec3::Y).is_finite() && uv(Vec3::new(0.0, 1.000_000_1, 0.0)).is_finite());
        assert!(uv(-Vec3::X).x <= 1.0, "where the longitude wraps");
    }
}
