//! SH-08: a scene somewhere else is the same scene.

use blinn_phong::light::Light;
use common::film::Color;
use common::sampler::Stream;
use common::tally::Off;
use glam::Vec3;
use ray_casting::ray::Ray;
use ray_casting::shape::Shape;
use ray_casting::sphere::Sphere;

use super::draw;
use crate::lighting::reaches;
use crate::naive;

/// A sloping floor, a lamp over it, and a ball in between or clearly beside. All coordinates are
/// quarters, so that moving them by up to 2¹⁸ rounds nothing.
struct Scene {
    shapes: Vec<Box<dyn Shape>>,
    eye: Vec3,
    light: Light,
    hidden: bool,
}

fn scene(trial: u64) -> Scene {
    let mut stream = Stream::of_trial(508, trial);
    let shift = draw::power_of_two(draw::whole(&mut stream, 4, 18));
    let shift = shift * draw::in_cube(&mut stream, 1.0).signum();
    let mut quarters = |low, high| draw::whole(&mut stream, 4 * low, 4 * high) as f32 / 4.0;
    let heights = [(); 3].map(|()| quarters(-6, 6));
    let corners = [(-40.0, -30.0), (38.0, -32.0), (2.0, 44.0)];
    let corner = |at: usize| Vec3::new(corners[at].0, heights[at], corners[at].1) + shift;
    let target = Vec3::new(quarters(-5, 5), 0.0, quarters(-5, 5));
    let lamp = target + Vec3::new(quarters(-6, 6), quarters(20, 30), quarters(-6, 6));
    let radius = 2.0 + quarters(0, 1);
    let middle = (2.0 * (target + lamp)).round() / 4.0;
    // The floor's height at the target, up to 6, moves the line of sight by a third of that or less.
    let hidden = trial.is_multiple_of(2);
    let center = if hidden { middle } else { middle + Vec3::X * 9.0 };
    let floor = draw::triangle([corner(0), corner(1), corner(2)]);
    let ball = Sphere { center: center + shift, radius };
    Scene {
        shapes: vec![Box::new(floor), Box::new(ball)],
        eye: target + Vec3::Y * 40.0 + shift,
        light: Light::steady(lamp + shift, Color::ONE),
        hidden,
    }
}

fn is_wrong(trial: u64, robust: bool) -> bool {
    let Scene { shapes, eye, light, hidden } = scene(trial);
    // The floor itself is asked, whatever the ball hides from the eye.
    let Some(hit) = shapes[0].hit(&Ray { origin: eye, direction: Vec3::NEG_Y }, f32::INFINITY)
    else {
        return true;
    };
    let seen = match robust {
        true => reaches(&shapes[..], &light, &hit, &mut Off),
        false => naive::reaches(&shapes[..], &light, &hit, naive::normal, &mut Off),
    };
    seen == hidden
}

pub(super) fn naive(trial: u64) -> bool {
    is_wrong(trial, false)
}

pub(super) fn robust(trial: u64) -> bool {
    is_wrong(trial, true)
}
