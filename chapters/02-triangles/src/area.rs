//! Whether a triangle has an area at all, decided without rounding.

use glam::{DVec3, Vec3};

// ANCHOR: area
/// Whether the triangle's area is other than zero, however small it is.
///
/// The squared length of the cross product, the textbook's test, vanishes in `f32` for triangles
/// that a microscope could see (hard case TR-09). Here the components of the cross product are
/// compared with their own rounding error. Only where that leaves a doubt they are added exactly.
pub fn has_area(corners: &[Vec3; 3]) -> bool {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    let (ab, ac) = (b - a, c - a);
    let cross = ab.cross(ac);
    let size = ab.abs().max_element() * ac.abs().max_element();
    if cross.abs().max_element() > DOUBT * size {
        return true;
    }
    [DVec3::new, |x, y, z| DVec3::new(y, z, x), |x, y, z| DVec3::new(z, x, y)]
        .iter()
        .any(|turned| !in_line(&[a, b, c].map(|point| turned(point.x, point.y, point.z))))
}
// ANCHOR_END: area

/// Sixteen times the rounding unit of f64: more than the error of a component of the cross product
/// of two differences, over the size of its products.
const DOUBT: f64 = 8.0 * f64::EPSILON;

/// Whether three points are exactly in line when seen along the third axis. The coordinates must be
/// those of `f32` points, so that their products are exact.
fn in_line(points: &[DVec3; 3]) -> bool {
    let [a, b, c] = points;
    vanishes([a.x * b.y, -a.y * b.x, b.x * c.y, -b.y * c.x, c.x * a.y, -c.y * a.x])
}

/// Whether the exact sum of these numbers is zero.
///
/// Keeps what each addition rounds away (Shewchuk, "Adaptive Precision Floating-Point Arithmetic
/// and Fast Robust Geometric Predicates", 1997: an expansion is zero when all its parts are).
fn vanishes(terms: [f64; 6]) -> bool {
    let mut parts = [0.0; 6];
    for (used, term) in terms.into_iter().enumerate() {
        let mut carry = term;
        for part in &mut parts[..used] {
            (carry, *part) = two_sum(carry, *part);
        }
        parts[used] = carry;
    }
    parts.iter().all(|part| *part == 0.0)
}

/// The sum of two numbers, and exactly what rounding took from it (Knuth).
fn two_sum(x: f64, y: f64) -> (f64, f64) {
    let sum = x + y;
    let of_y = sum - x;
    let of_x = sum - of_y;
    (sum, (x - of_x) + (y - of_y))
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::Vec3;

    use super::has_area;
    use crate::naive;

    #[test]
    fn exactly_in_line_has_no_area_and_one_step_beside_has() {
        for trial in 0..20_000 {
            let mut stream = Stream::of_trial(6, trial);
            let mut digits = |low, high| stream.between(low, high).round();
            let start = Vec3::new(digits(-9e3, 9e3), digits(-7e4, 7e4), digits(-100.0, 100.0));
            let step = Vec3::new(digits(-50.0, 50.0), digits(1.0, 70.0), digits(-90.0, 90.0));
            let scale = f32::from_bits((27 + (trial as u32 % 200)) << 23);
            let line = [start, start + 3.0 * step, start + 11.0 * step].map(|it| scale * it);
            assert!(!has_area(&line), "{line:?}");
            let mut beside = line;
            beside[1].x = beside[1].x.next_up();
            assert!(has_area(&beside), "{beside:?}");
        }
    }

    #[test]
    fn lopsided_coordinates_are_no_excuse() {
        // The smallest and the largest in one triangle: differences in f64 round the smallest away.
        let tiny = Vec3::new(f32::from_bits(1), 0.0, 0.0);
        assert!(has_area(&[Vec3::ZERO, tiny, Vec3::new(0.0, 1e38, 0.0)]));
        assert!(has_area(&[Vec3::new(1e30, 1e30, 1e30), tiny, Vec3::ZERO]));
        assert!(!has_area(&[Vec3::splat(1e30), Vec3::splat(1e-30), Vec3::ZERO]));
        assert!(!has_area(&[tiny, tiny, Vec3::Z]));
    }

    #[test]
    fn nonsense_has_no_area_that_counts() {
        // NaN is not zero; what matters is that nothing panics. The test rejects such corners.
        let _answer = has_area(&[Vec3::NAN, Vec3::X, Vec3::Y]);
        assert!(!naive::has_area(&[Vec3::ZERO, 1e-12 * Vec3::X, 1e-12 * Vec3::Y]));
    }
}
