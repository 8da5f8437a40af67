//! The light of a triangular lamp in closed form: what every estimate is held against.

use std::f64::consts::PI;

use glam::DVec3;

// ANCHOR: irradiance
/// The irradiance at the origin, on a surface with this `normal`, of a triangle whose every point
/// sends the radiance 1 this way: for each edge the angle under which it is seen, times the cosine
/// between the normal and that of the edge's plane.
///
/// J. H. Lambert, "Photometria" (1760). What is below the horizon is cut off first.
pub fn irradiance(corners: &[DVec3; 3], normal: DVec3) -> f64 {
    let polygon = above(corners, normal);
    let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
    let sum: f64 = edges.map(|(from, to)| edge(*from, *to, normal)).sum();
    (0.5 * sum).abs()
}

/// One edge's part.
fn edge(from: DVec3, to: DVec3, normal: DVec3) -> f64 {
    let across = from.cross(to);
    let length = across.length();
    if length == 0.0 {
        return 0.0;
    }
    libm::atan2(length, from.dot(to)) * across.dot(normal) / length
}
// ANCHOR_END: irradiance

/// The part of the triangle above the horizon (Sutherland and Hodgman, "Reentrant polygon clipping",
/// 1974).
fn above(corners: &[DVec3; 3], normal: DVec3) -> Vec<DVec3> {
    let mut polygon = Vec::with_capacity(4);
    for (index, &corner) in corners.iter().enumerate() {
        let next = corners[(index + 1) % 3];
        let (height, other) = (corner.dot(normal), next.dot(normal));
        if height >= 0.0 {
            polygon.push(corner);
        }
        if (height > 0.0) != (other > 0.0) && height != other {
            polygon.push(corner + height / (height - other) * (next - corner));
        }
    }
    polygon
}

/// What a matte surface of this albedo sends on of it, to everywhere.
pub fn radiance(corners: &[DVec3; 3], normal: DVec3, albedo: f64) -> f64 {
    albedo / PI * irradiance(corners, normal)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_4, PI};

    use glam::DVec3;

    use super::{irradiance, radiance};

    /// A quarter of the hemisphere has a quarter of π.
    #[test]
    fn by_hand() {
        let octant = [DVec3::X, DVec3::Y, DVec3::Z];
        // From the origin an octant looks like the triangle: two of its edges are in upright planes.
        assert!((irradiance(&octant, DVec3::Z) - FRAC_PI_4).abs() < 1e-15);
        assert!((radiance(&octant, DVec3::Z, 0.5) - 0.125).abs() < 1e-15);
        assert_eq!(irradiance(&octant, -DVec3::Z), 0.0);
    }

    #[test]
    fn far_away_it_is_area_times_cosines_over_the_distance_squared() {
        let [x, y] = [DVec3::X, DVec3::Y];
        let corners =
            [DVec3::Z * 1000.0 - x - y, DVec3::Z * 1000.0 + 2.0 * x, DVec3::Z * 1000.0 + y];
        let area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).length() / 2.0;
        assert!((irradiance(&corners, DVec3::Z) / (area * 1e-6) - 1.0).abs() < 1e-5);
    }

    /// A triangle that is halved by the horizon sends what its upper half does.
    #[test]
    fn the_horizon_cuts() {
        let whole =
            [DVec3::new(1.0, 0.0, -1.0), DVec3::new(1.0, 1.0, 0.0), DVec3::new(1.0, 0.0, 1.0)];
        let half =
            [DVec3::new(1.0, 0.0, 0.0), DVec3::new(1.0, 1.0, 0.0), DVec3::new(1.0, 0.0, 1.0)];
        let (whole, half) = (irradiance(&whole, DVec3::Z), irradiance(&half, DVec3::Z));
        assert!((whole - half).abs() < 1e-15 && whole > 0.05 && whole < PI);
    }
}
