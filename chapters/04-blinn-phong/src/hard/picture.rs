//! The published equation, seen: what it takes away, and where it is no number.

use common::film::{Color, Film};
use common::tally::Off;
use glam::{Vec2, Vec3};
use ray_casting::camera::{Camera, View};
use ray_casting::sphere::Sphere;

use crate::light::Light;
use crate::material::BlinnPhong;
use crate::models::{Blinn, Model};
use crate::naive::Published;
use crate::object::Object;
use crate::paint::Paint;
use crate::picture::Picture;
use crate::scene::Scene;

const SIDE: u32 = 320;
const GAP: u32 = 8;
const NO_NUMBER: Color = Color::new(1.0, 0.0, 0.1);

/// A ball between two lamps, twice: by the published equation and by ours. Red is no number.
pub fn picture() -> Option<Film> {
    let scene = scene();
    let picture = Picture { scene: &scene, camera: Camera::new(&scene.view, SIDE, SIDE).ok()? };
    Some(Film::from_fn(2 * SIDE + GAP, SIDE, |x, y| {
        if x < SIDE {
            color::<Published>(&picture, x, y)
        } else if x < SIDE + GAP {
            Color::ONE
        } else {
            color::<Blinn>(&picture, x - SIDE - GAP, y)
        }
    }))
}

fn scene() -> Scene<BlinnPhong> {
    let blue = Paint::Plain(Color::new(0.35, 0.45, 0.8));
    let ball = Sphere { center: Vec3::ZERO, radius: 1.0 };
    Scene {
        objects: vec![Object {
            shape: Box::new(ball),
            material: BlinnPhong::glossy(blue, Color::splat(0.5), 12.5),
        }],
        lights: vec![
            Light::steady(Vec3::new(-7.0, 4.0, 3.0), Color::splat(0.9)),
            Light::steady(Vec3::new(6.0, 1.0, -1.5), Color::splat(0.6)),
        ],
        ambient: Color::splat(0.05),
        background: Color::splat(0.2),
        view: View {
            eye: Vec3::new(0.0, 0.0, 4.0),
            target: Vec3::ZERO,
            up: Vec3::Y,
            vertical_fov: 34.0,
        },
    }
}

fn color<M: Model>(picture: &Picture, x: u32, y: u32) -> Color {
    let ray = picture.camera.ray(Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
    let Some(nearest) = picture.scene.nearest(&ray, &mut Off) else {
        return picture.scene.background;
    };
    let radiance = picture.radiance::<M, Off, true, true>(&ray, &nearest, &mut Off);
    if radiance.is_nan() { NO_NUMBER } else { radiance.max(Color::ZERO) }
}
