//! A lamp: a triangle or a ball that glows, and points of it.

use std::f32::consts::PI;

use common::film::Color;
use glam::{DVec3, Vec2, Vec3};
use monte_carlo::frame::Frame;
use monte_carlo::warp::cap::Cap;
use monte_carlo::warp::{sphere, triangle};
use path_tracing::part::Emission;
use path_tracing::space::Piece;
use ray_casting::rounding::{Placed, gamma};
use ray_casting::shape::Hit;
use ray_casting::sphere::Sphere;
use triangles::surface::{area_vector, geometric_normal, place};

use crate::spherical::Spherical;

// ANCHOR: lamp
/// A piece of the scene that glows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lamp {
    shape: Shape,
    /// The light it sends out.
    pub emission: Emission,
}

/// Where a lamp is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    Triangle(Triangle),
    Ball(Sphere),
}

/// A triangle that glows.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Triangle {
    corners: [Vec3; 3],
    /// Along the normal, as long as twice the area.
    across: DVec3,
    normal: Vec3,
    area: f32,
}

/// How points of lamps are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Way {
    /// Uniform over the area: the report's equation 4-4.
    #[default]
    Area,
    /// Uniform over the directions in which the lamp is seen.
    SolidAngle,
}

/// A point of a lamp, chosen by chance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LampPoint {
    /// Where it is.
    pub hit: Hit,
    /// The direction to it, of length 1.
    pub direction: Vec3,
    /// The density with which that direction was chosen, per steradian: finite and above 0.
    pub pdf: f32,
}
// ANCHOR_END: lamp

impl Lamp {
    /// The lamp of a piece. `None` when it has no area.
    pub fn new(piece: Piece, emission: Emission) -> Option<Self> {
        let shape = match piece {
            Piece::Triangle(corners) => {
                let normal = geometric_normal(&corners)?;
                let across = area_vector(&corners);
                let area = (0.5 * across.length()) as f32;
                Shape::Triangle(Triangle { corners, across, normal, area })
            }
            Piece::Ball(sphere) => Shape::Ball(sphere),
        };
        let lamp = Self { shape, emission };
        (lamp.area() > 0.0 && lamp.area().is_finite()).then_some(lamp)
    }

    /// The area that can be met.
    pub fn area(&self) -> f32 {
        match self.shape {
            Shape::Triangle(Triangle { area, .. }) => area,
            Shape::Ball(Sphere { radius, .. }) => 4.0 * PI * radius * radius,
        }
    }

    // ANCHOR: power
    /// The power it sends out, in watts if the radiance is in watts per square metre and steradian:
    /// π times radiance times area, for each side that glows; the mean of the three colours.
    pub fn power(&self) -> f32 {
        let Emission { radiance, both_sides } = self.emission;
        let sides = if both_sides { 2.0 } else { 1.0 };
        sides * PI * self.area() * radiance.element_sum() / 3.0
    }
    // ANCHOR_END: power

    // ANCHOR: point
    /// A point of it, as seen from `from`. `None` where it can't be seen from there.
    #[inline]
    pub fn point(&self, from: Vec3, way: Way, u: Vec2) -> Option<LampPoint> {
        match &self.shape {
            Shape::Triangle(shape) => match shape.seen(from, way) {
                Some(seen) => of_triangle(shape, from, &seen, u),
                None => by_area(from, shape.at(triangle::barycentric(u)), shape.area),
            },
            Shape::Ball(ball) => match seen(ball, from, way) {
                Some((distance, cap)) => Some(of_cap(ball, from, distance, &cap, u)),
                None => {
                    let normal = sphere::uniform(u);
                    by_area(from, on_ball(ball, normal), self.area())
                }
            },
        }
    }
    // ANCHOR_END: point

    // ANCHOR: pdf
    /// The density with which [`Lamp::point`] chooses the direction in which `hit` is seen.
    #[inline]
    pub fn pdf(&self, from: Vec3, way: Way, hit: &Hit) -> f32 {
        match &self.shape {
            Shape::Triangle(shape) => match shape.seen(from, way) {
                Some(seen) => 1.0 / seen.solid_angle(),
                None => area_pdf(from, hit, shape.area),
            },
            Shape::Ball(ball) => match seen(ball, from, way) {
                Some((_distance, cap)) => 1.0 / cap.solid_angle(),
                None => area_pdf(from, hit, self.area()),
            },
        }
    }
    // ANCHOR_END: pdf
}

impl Triangle {
    // ANCHOR: seen
    /// The triangle on the sphere around `from`, where that is how its points are chosen. What asks
    /// for a point and what asks for its density must both take this turn, or both the other.
    #[inline]
    fn seen(&self, from: Vec3, way: Way) -> Option<Spherical> {
        if way == Way::Area {
            return None;
        }
        let seen = Spherical::new(&self.corners, self.across, from);
        seen.is_wide().then_some(seen)
    }
    // ANCHOR_END: seen

    /// The point with these weights of the corners.
    #[inline]
    fn at(&self, weights: Vec3) -> Hit {
        let Placed { point, error } = place(self.corners, weights);
        on(point, error, self.normal)
    }
}

/// The point of the triangle that is seen in a direction chosen uniformly.
#[inline]
fn of_triangle(shape: &Triangle, from: Vec3, seen: &Spherical, u: Vec2) -> Option<LampPoint> {
    let hit = shape.at(seen.weights(u));
    let way = hit.point - from;
    let direction = way / way.length();
    direction.is_finite().then_some(LampPoint { hit, direction, pdf: 1.0 / seen.solid_angle() })
}

/// The distance of the ball's centre, and the cap in which it is seen, where that is how its points
/// are chosen: not from inside.
#[inline]
fn seen(ball: &Sphere, from: Vec3, way: Way) -> Option<(f32, Cap)> {
    if way == Way::Area {
        return None;
    }
    let distance = (ball.center - from).length();
    let cap = Cap::of_ball(distance / ball.radius)?;
    // A ball so small or so far that its cap has no size left is a lamp that can't be found.
    (cap.height > 0.0).then_some((distance, cap))
}

// ANCHOR: by_area
/// A point that was chosen uniformly over `area`, seen from `from`.
#[inline]
fn by_area(from: Vec3, hit: Hit, area: f32) -> Option<LampPoint> {
    let way = hit.point - from;
    let direction = way / way.length();
    let pdf = area_pdf(from, &hit, area);
    // A lamp seen from its edge has no width, and from a point of it no direction (LS-06, LS-07).
    (pdf > 0.0 && pdf.is_finite() && direction.is_finite()).then_some(LampPoint {
        hit,
        direction,
        pdf,
    })
}

/// The density 1 / area, per unit of area, as one per steradian: distance² / (area · cosine).
///
/// Equation 4-4: dω = dA cos θ' / distance².
#[inline]
fn area_pdf(from: Vec3, hit: &Hit, area: f32) -> f32 {
    let way = hit.point - from;
    let square = way.length_squared();
    // The cosine times the distance, so that the distance is cubed and divided once.
    let rise = way.dot(hit.geometric).abs();
    square * square.sqrt() / (area * rise)
}
// ANCHOR_END: by_area

// ANCHOR: of_cap
/// The point of the ball that is seen in a direction chosen uniformly in the `cap` around its centre.
///
/// Pharr, Jakob and Humphreys, "Physically Based Rendering" (fourth edition, 2023), section 6.2.4:
/// the normal's angle at the centre follows from the sine rule without a difference of squares.
#[inline]
fn of_cap(ball: &Sphere, from: Vec3, distance: f32, cap: &Cap, u: Vec2) -> LampPoint {
    let axis = Frame::around((ball.center - from) / distance);
    let local = cap.sample(u);
    let largest_sine = ball.radius / distance;
    let square = local.truncate().length_squared() / (largest_sine * largest_sine);
    let cosine = square * largest_sine + local.z * (1.0 - square).max(0.0).sqrt();
    let sine = ((1.0 - cosine) * (1.0 + cosine)).max(0.0).sqrt();
    let around = local.truncate().normalize_or_zero() * sine;
    let normal = axis.to_world(around.extend(-cosine));
    let hit = on_ball(ball, normal / normal.length());
    LampPoint { hit, direction: axis.to_world(local), pdf: 1.0 / cap.solid_angle() }
}
// ANCHOR_END: of_cap

/// The point of the ball whose outward normal is `normal`.
#[inline]
fn on_ball(ball: &Sphere, normal: Vec3) -> Hit {
    let point = ball.center + ball.radius * normal;
    let error = gamma(5) * (ball.center.abs() + Vec3::splat(ball.radius));
    on(point, error, normal)
}

#[inline]
fn on(point: Vec3, error: Vec3, normal: Vec3) -> Hit {
    Hit { t: 1.0, point, error, geometric: normal, normal, uv: Vec2::ZERO }
}

impl LampPoint {
    /// The radiance that comes from it with this emission.
    #[inline]
    pub fn radiance(&self, emission: &Emission) -> Color {
        emission.towards(-self.direction.dot(self.hit.geometric))
    }
}

#[cfg(test)]
mod tests {
    use std::f32::consts::PI;

    use common::film::Color;
    use common::sampler::Stream;
    use glam::{Vec2, Vec3};
    use path_tracing::part::Emission;
    use path_tracing::space::Piece;
    use ray_casting::ray::Ray;
    use ray_casting::shape::Shape;
    use ray_casting::sphere::Sphere;

    use super::{Lamp, Way};

    const WAYS: [Way; 2] = [Way::Area, Way::SolidAngle];
    const GLOW: Emission = Emission { radiance: Color::new(3.0, 6.0, 9.0), both_sides: false };

    fn lamp(piece: Piece) -> Lamp {
        Lamp::new(piece, GLOW).expect("an area")
    }

    /// Two by three, at a distance of 4 above the origin.
    fn triangle() -> Lamp {
        let corners =
            [Vec3::new(0.0, 0.0, 4.0), Vec3::new(0.0, 2.0, 4.0), Vec3::new(3.0, 0.0, 4.0)];
        lamp(Piece::Triangle(corners))
    }

    fn vector(stream: &mut Stream) -> Vec3 {
        Vec3::from_array([(); 3].map(|()| stream.between(-2.0, 2.0)))
    }

    #[test]
    fn by_hand() {
        let lamp = triangle();
        assert_eq!(lamp.area(), 3.0);
        // The mean of 3, 6 and 9 is 6, times the area 3, times π.
        assert!((lamp.power() - 18.0 * PI).abs() < 1e-5);
        // u = (1, 1) is the third corner: distance 5, cosine 4 / 5.
        let point = lamp.point(Vec3::ZERO, Way::Area, Vec2::ONE).expect("in sight");
        assert!((point.direction - Vec3::new(0.6, 0.0, 0.8)).length() < 1e-6);
        assert!((point.pdf - 25.0 / (3.0 * 0.8)).abs() < 1e-5, "{}", point.pdf);
        assert_eq!(point.radiance(&GLOW), GLOW.radiance);
        let behind = lamp.point(Vec3::new(0.0, 0.0, 8.0), Way::Area, Vec2::ONE).expect("in sight");
        assert_eq!(behind.radiance(&GLOW), Color::ZERO);
    }

    #[test]
    fn what_has_no_area_is_no_lamp() {
        let line = Piece::Triangle([Vec3::ZERO, Vec3::ONE, 2.0 * Vec3::ONE]);
        let nowhere = Piece::Triangle([Vec3::ZERO, Vec3::X, Vec3::splat(f32::NAN)]);
        let point = Piece::Ball(Sphere { center: Vec3::ONE, radius: 0.0 });
        for piece in [line, nowhere, point] {
            assert_eq!(Lamp::new(piece, GLOW), None);
        }
    }

    /// MI-05: a path that comes upon the sampled point must find the density it was sampled with.
    #[test]
    fn the_density_of_a_hit_is_that_of_the_point() {
        for trial in 0..20_000 {
            let mut stream = Stream::of_trial(1310, trial);
            let corners = [(); 3].map(|()| vector(&mut stream));
            let sphere = Sphere { center: vector(&mut stream), radius: stream.between(0.1, 1.0) };
            let (from, u) = (vector(&mut stream), stream.uniform2());
            for (piece, way) in [Piece::Triangle(corners), Piece::Ball(sphere)]
                .into_iter()
                .flat_map(|piece| WAYS.map(|way| (piece, way)))
            {
                let lamp = lamp(piece);
                let Some(point) = lamp.point(from, way, u) else { continue };
                let pdf = lamp.pdf(from, way, &point.hit);
                assert!((pdf / point.pdf - 1.0).abs() < 1e-3, "trial {trial}, {piece:?}");
                assert!((point.direction.length() - 1.0).abs() < 1e-5);
                let way = point.hit.point - from;
                let aside = (way - way.length() * point.direction).length();
                assert!(aside < 5e-5, "trial {trial}, {piece:?}: {aside}");
            }
        }
    }

    /// Of both ways, the mean of 1 / pdf is the solid angle.
    #[test]
    fn densities_are_densities() {
        let lamp = triangle();
        let from = Vec3::new(0.5, -1.0, 3.2);
        let mean = |way| {
            let sum: f64 = (0..40_000)
                .map(|trial| {
                    let u = Stream::of_trial(1311, trial).uniform2();
                    lamp.point(from, way, u).map_or(0.0, |point| 1.0 / f64::from(point.pdf))
                })
                .sum();
            sum / 40_000.0
        };
        let [by_area, by_angle] = WAYS.map(mean);
        assert!((by_area / by_angle - 1.0).abs() < 0.02, "{by_area} {by_angle}");
    }

    #[test]
    fn the_points_of_a_cap_are_those_that_are_met_first() {
        let ball = Sphere { center: Vec3::new(1.0, 2.0, 3.0), radius: 1.5 };
        let lamp = lamp(Piece::Ball(ball));
        for trial in 0..10_000 {
            let mut stream = Stream::of_trial(1312, trial);
            let from = ball.center + stream.between(1.6, 9.0) * vector(&mut stream).normalize();
            let point = lamp.point(from, Way::SolidAngle, stream.uniform2()).expect("outside");
            let ray = Ray { origin: from, direction: point.direction };
            // At the very rim a rounded direction may pass by.
            let Some(hit) = ball.hit(&ray, f32::INFINITY) else { continue };
            let cosine = -point.direction.dot(hit.geometric);
            let off = (hit.point - point.hit.point).length();
            assert!(off < 1e-5 / cosine.max(1e-3), "trial {trial}: {off}, cosine {cosine}");
        }
    }

    #[test]
    fn inside_a_ball_all_of_it_is_seen() {
        let ball = Piece::Ball(Sphere { center: Vec3::ONE, radius: 2.0 });
        let lamp = Lamp::new(ball, Emission { both_sides: true, ..GLOW }).expect("an area");
        assert!((lamp.power() / (2.0 * PI * 16.0 * PI * 6.0) - 1.0).abs() < 1e-6);
        for way in WAYS {
            let from = Vec3::new(1.5, 0.5, 0.7);
            let sum: f64 = (0..40_000)
                .map(|trial| {
                    let u = Stream::of_trial(1313, trial).uniform2();
                    1.0 / f64::from(lamp.point(from, way, u).expect("all around").pdf)
                })
                .sum();
            assert!((sum / 40_000.0 / f64::from(4.0 * PI) - 1.0).abs() < 0.02, "{way:?}");
        }
    }

    /// LS-06 and LS-07: no NaN and no infinity, from wherever the lamp is looked at.
    #[test]
    fn from_its_plane_and_from_itself() {
        let lamp = triangle();
        let corner = Vec3::new(0.0, 0.0, 4.0);
        let points = [corner, corner + 5.0 * Vec3::X, Vec3::new(0.5, 0.5, 4.0)];
        for (from, way) in points.into_iter().flat_map(|from| WAYS.map(|way| (from, way))) {
            for u in [Vec2::ZERO, Vec2::new(0.25, 0.5), Vec2::new(0.0, 0.7)] {
                let found = lamp.point(from, way, u);
                assert!(found.is_none_or(|point| point.pdf.is_finite() && point.pdf > 0.0));
            }
        }
    }
}
