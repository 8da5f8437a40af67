//! A triangle as it is seen from a point: the solid angle, and directions spread evenly over it.

use std::f32::consts::TAU;

use common::math::{atan2, sin};
use glam::{DVec3, Vec2, Vec3};

// ANCHOR: spherical
/// The triangle that a triangle's directions make on the unit sphere around a point.
///
/// In `f64`: a lamp that is far, or seen from its edge, is a small difference of large numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spherical {
    /// The corners' distances.
    distances: [f64; 3],
    /// The cosines of the angles between corners: first and second, first and third, second and
    /// third.
    cosines: [f64; 3],
    /// The volume that the three directions span: their triple product.
    volume: f64,
    /// The denominator of tan(Ω / 2): 1 and the three cosines.
    height: f64,
    /// The solid angle Ω, in steradians.
    solid_angle: f32,
}
// ANCHOR_END: spherical

/// The solid angles in which points are chosen by direction. Below, a lamp is a point for all that
/// anybody could see; above, the eye all but touches it, and the corners have lost their directions.
const SIZES: std::ops::RangeInclusive<f32> = 1e-13..=TAU - 1e-3;

impl Spherical {
    // ANCHOR: new
    /// The triangle with these corners, whose normal with twice its area as length is `across`.
    ///
    /// tan(Ω / 2) = |a · (b × c)| / (1 + a · b + a · c + b · c) for corners at distance 1: van Oosterom
    /// and Strackee, "The solid angle of a plane triangle" (IEEE Transactions on Biomedical Engineering
    /// 30(2), 1983). The triple product is taken of one corner and the edges, which are shorter than the
    /// corners are far.
    #[inline]
    pub fn new(corners: &[Vec3; 3], across: DVec3, from: Vec3) -> Self {
        let ways = corners.map(|corner| corner.as_dvec3() - from.as_dvec3());
        let distances = ways.map(DVec3::length);
        let [a, b, c] = [0, 1, 2].map(|corner| ways[corner] / distances[corner]);
        let cosines = [a.dot(b), a.dot(c), b.dot(c)];
        let [one, other, third] = distances;
        let volume = (ways[0].dot(across) / (one * other * third)).abs();
        let height = 1.0 + cosines[0] + cosines[1] + cosines[2];
        let solid_angle = 2.0 * atan2(volume as f32, height as f32);
        Self { distances, cosines, volume, height, solid_angle }
    }
    // ANCHOR_END: new

    /// The solid angle, in steradians: from 0 to 2π. NaN from a corner itself.
    #[inline]
    pub fn solid_angle(&self) -> f32 {
        self.solid_angle
    }

    /// Whether directions can be chosen: the triangle is neither too small nor all around.
    #[inline]
    pub fn is_wide(&self) -> bool {
        SIZES.contains(&self.solid_angle)
    }

    // ANCHOR: weights
    /// The weights of the corners, each at least 0 and 1 together, of the point that is seen in a
    /// direction chosen uniformly over the solid angle.
    ///
    /// James Arvo, "Stratified sampling of spherical triangles" (SIGGRAPH 1995): the first number cuts
    /// off a part of the solid angle, by a line from the second corner to a point between the first and
    /// the third. The second number chooses a height on that line. The tangent of half a solid angle is
    /// linear in the vector halfway to that point (Christoph Peters, "BRDF importance sampling for
    /// polygonal lights", SIGGRAPH 2021), so that no angle of the triangle is needed, and with the two
    /// parts' sines nothing is subtracted.
    #[inline]
    pub fn weights(&self, u: Vec2) -> Vec3 {
        let [first_second, first_third, second_third] = self.cosines;
        // Halfway: h = near a + far c. Both parts are at least 0, and near is no less than far.
        let half = 0.5 * self.solid_angle;
        let length = (self.volume * self.volume + self.height * self.height).sqrt();
        let more = length * f64::from(sin((1.0 - u.x) * half));
        let far = (1.0 + first_second).max(0.0) * f64::from(sin(u.x * half));
        let near = far + more;
        let square = more * more + 2.0 * near * far * (1.0 + first_third).max(0.0);

        // Twice as far, the point on the third edge: a reflected at h.
        let first = more * (near + far) / square;
        let third = 2.0 * far * (near + far * first_third).max(0.0) / square;
        let cosine = first * first_second + third * second_third;

        // The height on the line from b to there is uniform.
        let chosen = f64::from(u.y);
        let height = 1.0 - chosen * (1.0 - cosine);
        let part = (chosen * (1.0 + height) / (1.0 + cosine).max(f64::MIN_POSITIVE)).sqrt();
        let second = (height - part * cosine).max(0.0);
        self.normalised([part * first, second, part * third])
    }
    // ANCHOR_END: weights

    /// The weights of corners of any distance, for weights of those at distance 1.
    #[inline]
    fn normalised(&self, weights: [f64; 3]) -> Vec3 {
        let [a, b, c] = [0, 1, 2].map(|corner| weights[corner] / self.distances[corner]);
        // All three are divided by the same sum: a part by a sum of changed parts is none (LS-04).
        (DVec3::new(a, b, c) / (a + b + c)).as_vec3()
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI, TAU};

    use common::sampler::Stream;
    use common::stats::chi_squared::goodness_of_fit;
    use glam::{DVec3, Vec2, Vec3};
    use triangles::surface::{area_vector, between};

    use super::Spherical;

    fn seen(corners: &[Vec3; 3], from: Vec3) -> Spherical {
        Spherical::new(corners, area_vector(corners), from)
    }

    /// By angles on the sphere, L'Huilier's theorem: tan(Ω / 4) from the half perimeter.
    fn by_sides(corners: &[Vec3; 3], from: Vec3) -> f64 {
        let [a, b, c] = corners.map(|corner| (corner - from).as_dvec3().normalize());
        let side = |one: DVec3, other: DVec3| 2.0 * libm::asin((one - other).length() / 2.0);
        let sides = [side(a, b), side(b, c), side(c, a)];
        let half = sides.iter().sum::<f64>() / 2.0;
        let product: f64 = sides.iter().map(|side| libm::tan((half - side) / 2.0)).product();
        4.0 * libm::atan((libm::tan(half / 2.0) * product).max(0.0).sqrt())
    }

    #[test]
    fn an_eighth_of_the_sphere_by_hand() {
        let octant = seen(&[Vec3::X, Vec3::Y, Vec3::Z], Vec3::ZERO);
        assert!((f64::from(octant.solid_angle()) - FRAC_PI_2).abs() < 1e-6);
        // Half of a cube's face, of which twelve are all around.
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0]].map(|[x, y]| Vec3::new(x, y, 1.0));
        let face = seen(&corners, Vec3::ZERO);
        assert!((f64::from(face.solid_angle()) - PI / 3.0).abs() < 1e-6);
    }

    #[test]
    fn near_the_lamp_it_fills_half_of_all_directions() {
        let corners = [Vec3::X, Vec3::Y, Vec3::new(-1.0, -1.0, 0.0)];
        for height in [1e-3, 1e-6, 1e-20, 0.0] {
            let solid_angle = f64::from(seen(&corners, height * Vec3::Z).solid_angle());
            assert!((solid_angle - TAU).abs() < 20.0 * f64::from(height) + 1e-6, "{height}");
        }
        assert_eq!(seen(&corners, 3.0 * Vec3::X).solid_angle(), 0.0, "seen from its edge");
        assert!(!seen(&corners, Vec3::X).is_wide(), "from a corner there is no direction");
    }

    fn random(trial: u64) -> ([Vec3; 3], Vec3) {
        let mut stream = Stream::of_trial(1301, trial);
        let mut point = || Vec3::from_array([(); 3].map(|()| stream.between(-1.0, 1.0)));
        ([point(), point(), point()], point())
    }

    #[test]
    fn the_sides_give_the_same_solid_angle() {
        for trial in 0..20_000 {
            let (corners, from) = random(trial);
            let (found, right) = (seen(&corners, from).solid_angle(), by_sides(&corners, from));
            assert!((f64::from(found) - right).abs() < 1e-5 * right + 1e-6, "trial {trial}");
        }
    }

    #[test]
    fn weights_are_weights() {
        for trial in 0..100_000 {
            let mut stream = Stream::of_trial(1302, trial);
            let (corners, from) = random(trial);
            let triangle = seen(&corners, from);
            let ends = [0.0, 1.0 - f32::EPSILON / 2.0, stream.uniform(), f32::EPSILON / 2.0];
            for (x, y) in ends.into_iter().flat_map(|x| ends.map(|y| (x, y))) {
                let weights = triangle.weights(Vec2::new(x, y));
                assert!(weights.min_element() >= 0.0, "trial {trial}: {weights}");
                let sum = weights.as_dvec3().element_sum();
                assert!((sum - 1.0).abs() < 4.0 * f64::from(f32::EPSILON), "trial {trial}: {sum}");
            }
        }
    }

    /// The triangle cut into 64: each piece is chosen as often as it is large on the sphere. `shift`
    /// is what the second corner is pulled nearer by, a planted error.
    fn fit(corners: &[Vec3; 3], sampled: &[Vec3; 3]) -> f64 {
        const SIDE: usize = 8;
        const SAMPLES: u64 = 200_000;
        let from = Vec3::ZERO;
        let cell = |weights: Vec3| {
            let [row, column] = [weights.y, weights.z].map(|part| part * SIDE as f32);
            let upper = row.fract() + column.fract() > 1.0;
            let at = (row as usize).min(SIDE - 1) * SIDE + (column as usize).min(SIDE - 1);
            2 * at + usize::from(upper)
        };
        let mut observed = vec![0; 2 * SIDE * SIDE];
        let triangle = seen(sampled, from);
        for trial in 0..SAMPLES {
            let u = Stream::of_trial(1303, trial).uniform2();
            observed[cell(triangle.weights(u))] += 1;
        }
        let mut expected = vec![0.0; 2 * SIDE * SIDE];
        let at = |row: usize, column: usize| {
            let [y, z] = [row, column].map(|place| place as f32 / SIDE as f32);
            between(*corners, Vec3::new(1.0 - y - z, y, z))
        };
        for (row, column) in (0..SIDE).flat_map(|row| (0..SIDE - row).map(move |to| (row, to))) {
            let index = 2 * (row * SIDE + column);
            let [here, down, right] = [at(row, column), at(row + 1, column), at(row, column + 1)];
            expected[index] = by_sides(&[here, down, right], from);
            if row + column + 1 < SIDE {
                let across = at(row + 1, column + 1);
                expected[index + 1] = by_sides(&[down, across, right], from);
            }
        }
        let scale = SAMPLES as f64 / expected.iter().sum::<f64>();
        expected.iter_mut().for_each(|share| *share *= scale);
        goodness_of_fit(&observed, &expected).expect("many samples").p_value
    }

    #[test]
    fn equal_solid_angles_are_equally_likely() {
        let large = [[1.0, 0.2, 0.1], [-0.3, 1.5, 0.4], [0.2, -0.1, 0.3]].map(Vec3::from_array);
        let beyond = [[-2.0, 1.0, 0.2], [2.0, 1.0, 0.3], [0.1, -3.0, 0.1]].map(Vec3::from_array);
        let grazing = [[1.0, 0.0, 0.01], [9.0, 1.0, 0.01], [3.0, 4.0, 0.01]].map(Vec3::from_array);
        for corners in [large, beyond, grazing] {
            let p_value = fit(&corners, &corners);
            assert!(p_value > 1e-3, "{corners:?}: {p_value}");
        }
        let [a, b, c] = large;
        let nearer = [a, 0.95 * b, c];
        assert!(fit(&large, &nearer) < 1e-6, "a corner's distance wrong by 5 % is noticed");
    }
}
