//! Points of lamps: where they are, how dense, and what they bring.

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
    let corners = [Vec3::new(0.0, 0.0, 4.0), Vec3::new(0.0, 2.0, 4.0), Vec3::new(3.0, 0.0, 4.0)];
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
