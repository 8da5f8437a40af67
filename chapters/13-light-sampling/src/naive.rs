//! The textbook's formulas and the report's lines: right on paper, or nearly.
//!
//! They are kept to be looked at, and as the negative controls of tests and hard cases.

use std::f32::consts::PI;

use common::film::Color;
use common::math::acos;
use common::tally::Tally;
use glam::Vec3;
use path_tracing::bsdf::Bsdf;
use path_tracing::random::Random;
use path_tracing::space::{Met, Space};
use path_tracing::strategy::Lighting;
use path_tracing::vertex::{Departure, Vertex};
use ray_casting::ray::Ray;

use crate::by_light::{ByLight, arriving};

// ANCHOR: cap
/// 1 - cos θ of the cap in which a ball of radius 1 is seen from a `distance` of its centre.
pub fn cap_height(distance: f32) -> f32 {
    let sine = 1.0 / distance;
    1.0 - (1.0 - sine * sine).sqrt()
}
// ANCHOR_END: cap

// ANCHOR: girard
/// The solid angle of a triangle, by Girard's theorem: what its angles on the sphere are more than π.
pub fn girard(corners: &[Vec3; 3], from: Vec3) -> f32 {
    let [a, b, c] = corners.map(|corner| (corner - from).normalize());
    let [ab, bc, ca] = [a.cross(b), b.cross(c), c.cross(a)].map(Vec3::normalize);
    acos(-ab.dot(bc)) + acos(-bc.dot(ca)) + acos(-ca.dot(ab)) - PI
}
// ANCHOR_END: girard

// ANCHOR: renormalised
/// Weights of the second and the third corner, whose sum rounding carried above 1, made to fit: as a
/// well-known program does it.
pub fn renormalised(mut second: f32, mut third: f32) -> [f32; 3] {
    if second + third > 1.0 {
        second /= second + third;
        third /= second + third;
    }
    [1.0 - second - third, second, third]
}
// ANCHOR_END: renormalised

// ANCHOR: density
/// Equation 4-4 as it is written: the density per steradian of a point chosen uniformly over `area`.
pub fn density(from: Vec3, point: Vec3, normal: Vec3, area: f32) -> f32 {
    let way = point - from;
    let square = way.length_squared();
    let direction = way / square.sqrt();
    square / (area * direction.dot(normal).abs())
}
// ANCHOR_END: density

// ANCHOR: pick
/// The first thing at which the running sum of the weights reaches the number `u` of [0, 1), times
/// the sum of all.
pub fn pick(weights: &[f32], u: f32) -> Option<usize> {
    let total: f32 = weights.iter().sum();
    let mut sum = 0.0;
    weights.iter().position(|weight| {
        sum += weight;
        sum >= u * total
    })
}
// ANCHOR_END: pick

// ANCHOR: published
/// The report's estimate of the light from a lamp (§5.3): its radiance, the surface's BRDF, both
/// cosines, the distance, and the density with which the point was chosen.
pub fn published(
    radiance: Color,
    brdf: Color,
    cosine: f32,
    lamp_cosine: f32,
    distance: f32,
    density: f32,
) -> Color {
    radiance * brdf * cosine * lamp_cosine * (distance * distance) / density
}
// ANCHOR_END: published

// ANCHOR: epsilon
/// The report's test of visibility: whether the nearest thing towards a lamp is no nearer than the
/// lamp, but for an EPSILON that has a unit.
pub fn published_visible<T: Tally>(
    space: &Space,
    from: Vec3,
    target: Vec3,
    epsilon: f32,
    tally: &mut T,
) -> bool {
    let distance = (target - from).length();
    let ray = Ray { origin: from, direction: (target - from) / distance };
    let nearest = space.nearest(&ray, tally).map_or(f32::INFINITY, |met| met.hit.t);
    nearest - distance > -epsilon
}
// ANCHOR_END: epsilon

// ANCHOR: counted
/// Light that is looked for as by [`ByLight`], with another rule of what else counts.
#[derive(Clone, Copy, Debug)]
pub struct Counted<'a> {
    /// How light is looked for.
    pub lighting: ByLight<'a>,
    /// What else counts.
    pub rule: Rule,
}

/// What counts of the lamps that a path comes upon by itself, though they are looked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// Only what the eye itself sees, from here: the report's rule (§5.3).
    OnlyFrom(Vec3),
    /// All of it, which counts some light twice.
    Always,
}

impl Lighting for Counted<'_> {
    #[inline]
    fn direct<B: Bsdf, T: Tally>(
        &self,
        space: &Space,
        vertex: &Vertex<B>,
        random: &Random,
        tally: &mut T,
    ) -> Color {
        self.lighting.direct(space, vertex, random, tally)
    }

    #[inline]
    fn share(&self, departure: &Departure, _met: &Met) -> f32 {
        match self.rule {
            Rule::OnlyFrom(eye) if departure.from != eye => 0.0,
            Rule::OnlyFrom(_) | Rule::Always => 1.0,
        }
    }
}
// ANCHOR_END: counted

/// Erratum 2: light that is multiplied by the squared distance by which it should be divided.
#[derive(Clone, Copy, Debug)]
pub struct Multiplied<'a>(pub ByLight<'a>);

impl Lighting for Multiplied<'_> {
    fn direct<B: Bsdf, T: Tally>(
        &self,
        space: &Space,
        vertex: &Vertex<B>,
        random: &Random,
        tally: &mut T,
    ) -> Color {
        let from = vertex.hit().point;
        let Some(sample) = self.0.lights.sample(from, random) else { return Color::ZERO };
        let square = (sample.hit().point - from).length_squared();
        arriving(space, vertex, &sample, tally) / sample.pdf * square * square
    }

    fn share(&self, departure: &Departure, met: &Met) -> f32 {
        self.0.share(departure, met)
    }
}

#[cfg(test)]
mod tests {
    use std::f32::consts::FRAC_PI_2;

    use common::film::Color;
    use glam::Vec3;

    use super::{cap_height, density, girard, pick, published, renormalised};

    #[test]
    fn they_are_right_where_they_are_tried() {
        assert!((cap_height(1.25) - 0.4).abs() < 1e-6);
        let octant = girard(&[Vec3::X, Vec3::Y, Vec3::Z], Vec3::ZERO);
        assert!((octant - FRAC_PI_2).abs() < 1e-6);
        assert_eq!(renormalised(0.25, 0.5), [0.25, 0.25, 0.5]);
        let point = Vec3::new(3.0, 0.0, 4.0);
        assert!((density(Vec3::ZERO, point, Vec3::Z, 3.0) - 25.0 / 2.4).abs() < 1e-5);
        assert_eq!([0.0, 0.3, 0.9].map(|u| pick(&[1.0, 3.0], u)), [Some(0), Some(1), Some(1)]);
    }

    #[test]
    fn they_are_wrong_where_they_are_needed() {
        let ratio = cap_height(4096.0) * 2.0 * 4096.0 * 4096.0;
        assert!((ratio - 2.0).abs() < 1e-6, "twice what it should be: {ratio}");
        assert_eq!(cap_height(6000.0), 0.0);
        assert!(renormalised(0.7, 0.4)[0] < 0.0);
        assert!(!density(Vec3::X, Vec3::ZERO, Vec3::Z, 1.0).is_finite());
        assert_eq!(pick(&[0.0, 1.0], 0.0), Some(0), "a lamp of no power");
    }

    /// Errata 2 and 3: equation 4-4 divides by the squared distance, and its density is one over the
    /// area. At a distance of 1 the first mistake doesn't show; at 2 it makes 16 times the light.
    #[test]
    fn the_published_line_is_right_at_a_distance_of_one_only() {
        let right = |distance: f32| 8.0 * 0.25 * 0.5 * 0.5 / (distance * distance) / 0.125;
        let line =
            |distance| published(Color::splat(8.0), Color::splat(0.25), 0.5, 0.5, distance, 0.125);
        assert_eq!(line(1.0), Color::splat(right(1.0)));
        assert_eq!(line(2.0), Color::splat(16.0 * right(2.0)));
    }
}
