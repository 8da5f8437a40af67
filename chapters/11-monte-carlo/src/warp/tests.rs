//! Every warp against its density, with a test that would see an error of 1 %.

use std::f64::consts::{PI, TAU};

use common::stats::chi_squared::goodness_of_fit;
use common::stats::sidak;
use glam::{DVec2, Vec2, Vec3};

use super::cap::Cap;
use super::{disk, hemisphere, sphere, triangle};
use crate::fit;

/// A warp into coordinates, its density in them, and a pattern that leaves the total as it is.
struct Claim {
    name: &'static str,
    warp: fn(Vec2) -> Vec2,
    density: fn(DVec2) -> f64,
    pattern: fn(DVec2) -> f64,
}

const CAP: Cap = Cap { height: 0.3 };

fn around(place: DVec2) -> f64 {
    f64::from(common::math::cos((TAU * place.y) as f32))
}

/// The density of the corner weights (b, c): 2 in the triangle. A midpoint on its edge counts half.
fn in_triangle(place: DVec2) -> f64 {
    let beyond = place.x + place.y - 1.0;
    if beyond.abs() < 1e-9 {
        1.0
    } else if beyond < 0.0 {
        2.0
    } else {
        0.0
    }
}

const CLAIMS: [Claim; 7] = [
    Claim {
        name: "polar disk",
        warp: |u| fit::of_disk(disk::polar(u)),
        density: |_| PI * disk::DENSITY as f64,
        pattern: around,
    },
    Claim {
        name: "concentric disk",
        warp: |u| fit::of_disk(disk::concentric(u)),
        density: |_| PI * disk::DENSITY as f64,
        pattern: around,
    },
    Claim {
        name: "uniform hemisphere",
        warp: |u| fit::of_direction(hemisphere::uniform(u), 0.0),
        density: |_| TAU * hemisphere::UNIFORM as f64,
        pattern: around,
    },
    Claim {
        name: "cosine hemisphere",
        warp: |u| fit::of_direction(hemisphere::cosine(u), 0.0),
        density: |place| TAU * f64::from(hemisphere::cosine_density(place.x as f32)),
        pattern: around,
    },
    Claim {
        name: "sphere",
        warp: |u| fit::of_direction(sphere::uniform(u), -1.0),
        density: |_| 2.0 * TAU * sphere::DENSITY as f64,
        pattern: around,
    },
    Claim {
        name: "cap",
        warp: |u| fit::of_direction(CAP.sample(u), 1.0 - CAP.height),
        density: |_| TAU * f64::from(CAP.height) / f64::from(CAP.solid_angle()),
        pattern: around,
    },
    Claim {
        name: "triangle",
        warp: |u| {
            let Vec3 { y, z, .. } = triangle::barycentric(u);
            Vec2::new(y, z)
        },
        density: in_triangle,
        pattern: |place| place.x - place.y,
    },
];

// ANCHOR: power
/// How often a right warp would fit as badly, when its density is claimed to be larger by the part
/// `planted` at one side, and smaller at the other.
fn p_value(claim: &Claim, samples: u64, planted: f64) -> f64 {
    let density = |place| (claim.density)(place) * (1.0 + planted * (claim.pattern)(place));
    let observed = fit::counts(1103, samples, claim.warp);
    let fit = goodness_of_fit(&observed, &fit::expected(samples, density));
    fit.unwrap_or_else(|why| panic!("{}: {why}", claim.name)).p_value
}

/// Hard case MC-08. An error of 1 % moves the statistic by at least 4·10⁶ · 0.01² / 6 = 66, and one
/// of 5 % by 3·10⁵ · 0.05² / 6 = 125; chance moves it by √(2 · 63) = 11.
#[test]
fn each_follows_its_density_and_no_other() {
    let significance = sidak(1e-3, CLAIMS.len() as u32);
    for claim in &CLAIMS {
        let right = p_value(claim, 4_000_000, 0.0);
        assert!(right > significance, "{}: {right}", claim.name);
        let rejected = p_value(claim, 4_000_000, 0.01).max(p_value(claim, 300_000, 0.05));
        assert!(rejected < significance, "{}: {rejected}", claim.name);
    }
}
// ANCHOR_END: power

#[test]
fn a_density_that_does_not_add_up_is_refused() {
    let observed = fit::counts(1103, 10_000, CLAIMS[0].warp);
    assert!(goodness_of_fit(&observed, &fit::expected(10_000, |_| 1.05)).is_err());
}

#[test]
fn points_by_hand() {
    // A quarter of the disk's area is within half its radius; straight up at 1/4 turn.
    assert!((disk::polar(Vec2::new(0.25, 0.25)) - Vec2::new(0.0, 0.5)).length() < 1e-6);
    assert_eq!(disk::concentric(Vec2::splat(0.5)), Vec2::ZERO);
    assert_eq!(disk::concentric(Vec2::new(1.0, 0.5)), Vec2::X);
    // Half the hemisphere is above half its height.
    assert!(
        (hemisphere::uniform(Vec2::new(0.5, 0.0)) - Vec3::new(0.75f32.sqrt(), 0.0, 0.5)).length()
            < 1e-6
    );
    // A quarter of a triangle is beyond half of its height.
    assert_eq!(triangle::barycentric(Vec2::new(0.25, 0.5)), Vec3::new(0.5, 0.25, 0.25));
    // A ball of radius 3 seen from 5: sine 0.6, cosine 0.8.
    let cap = Cap::of_ball(5.0 / 3.0).expect("outside");
    assert!((cap.height - 0.2).abs() < 1e-7 && (cap.solid_angle() - 0.4 * PI as f32).abs() < 1e-6);
    assert_eq!(Cap::of_ball(1.0), None);
    assert_eq!(Cap::of_ball(f32::NAN), None);
}
