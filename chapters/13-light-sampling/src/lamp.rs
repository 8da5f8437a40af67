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
pub fn by_area(from: Vec3, hit: Hit, area: f32) -> Option<LampPoint> {
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
mod tests;
