//! The scenes that are made of spheres and a floor.

use common::chapter::Failure;
use common::film::Color;
use common::plan::Call;
use glam::Vec3;
use ray_casting::camera::View;
use ray_casting::picture::BACKGROUND;
use ray_casting::quad::Quad;
use ray_casting::scene::{self, Geometry};
use ray_casting::shape::Shape;
use ray_casting::sphere::Sphere;

use crate::light::{Light, LightError};
use crate::material::BlinnPhong;
use crate::object::Object;
use crate::paint::Paint;
use crate::scene::Scene;

// ANCHOR: whitted
/// The report's figure 5.2: its geometry is chapter 1's, its colours and lamps are these.
pub(super) fn whitted() -> Scene<BlinnPhong> {
    let floor = Paint::Checker {
        squares: 5.0,
        colors: [Color::new(0.815, 0.235, 0.031), Color::new(0.937, 0.937, 0.231)],
    };
    let materials = [
        framework(Paint::Plain(Color::new(0.6, 0.7, 0.8))),
        // Glass and a mirror at once, which later chapters teach: until then a dark, glossy ball.
        framework(Paint::Plain(Color::splat(0.2))),
        framework(floor),
    ];
    let Geometry { view, shapes, .. } = geometry();
    let objects = shapes.into_iter().zip(materials);
    Scene {
        objects: objects.map(|(shape, material)| Object { shape, material }).collect(),
        lights: vec![
            Light::steady(Vec3::new(-20.0, 70.0, 20.0), Color::splat(0.5)),
            Light::steady(Vec3::new(30.0, 50.0, -12.0), Color::splat(0.5)),
        ],
        ambient: Color::ZERO,
        background: BACKGROUND,
        view,
    }
}

/// The material that GAMES101's framework, the report's, gives to whatever has a colour: 0.8 of it
/// diffusely, 0.2 of white in the highlight, and an exponent of 25.
fn framework(color: Paint) -> BlinnPhong {
    BlinnPhong::glossy(color.map(|color| 0.8 * color), Color::splat(0.2), 25.0)
}
// ANCHOR_END: whitted

fn geometry() -> Geometry {
    scene::whitted(|sphere| Box::new(sphere))
}

/// What the report's picture of these spheres asks for.
pub(super) fn whitted_calls() -> Vec<Call> {
    geometry().calls
}

/// The same with its lamps off.
pub(super) fn dark() -> Scene<BlinnPhong> {
    Scene { lights: Vec::new(), ..whitted() }
}

/// Where Phong and Blinn part: a floor seen at a grazing angle, and a low lamp straight ahead.
pub(super) fn low_lamp() -> Result<Scene<BlinnPhong>, Failure> {
    let wet = BlinnPhong::glossy(
        Paint::Plain(Color::new(0.05, 0.06, 0.08)),
        Color::new(0.9, 0.8, 0.6),
        60.0,
    );
    let ball =
        BlinnPhong::glossy(Paint::Plain(Color::new(0.5, 0.12, 0.06)), Color::splat(0.5), 40.0);
    let lamp = Light::steady(Vec3::new(2.0, 5.0, -30.0), Color::ONE);
    let sky = Light::far(Vec3::new(-0.5, 1.0, 0.8), Color::new(0.3, 0.35, 0.45));
    Ok(Scene {
        objects: vec![
            Object { shape: floor(Vec3::new(-60.0, 0.0, 10.0), 120.0)?, material: wet },
            object(Vec3::new(-1.9, 1.0, -7.0), 1.0, ball),
        ],
        lights: vec![lamp, sky.map_err(no_light)?],
        ambient: Color::splat(0.08),
        background: Color::new(0.02, 0.03, 0.06),
        view: ahead(Vec3::new(0.0, 1.6, 1.0), Vec3::new(0.0, 0.7, -9.0), 46.0),
    })
}

/// One ball between a lamp that is near and fades and one that is far away and doesn't.
pub(super) fn two_lamps() -> Result<Scene<BlinnPhong>, Failure> {
    let white = Paint::Plain(Color::splat(0.7));
    let near = Light::Point {
        position: Vec3::new(-2.2, 2.4, 1.6),
        color: Color::new(9.0, 5.5, 2.4),
        falloff: [0.0, 0.0, 1.0],
    };
    let sun = Light::far(Vec3::new(3.0, 2.0, 0.5), Color::new(0.25, 0.4, 0.7)).map_err(no_light)?;
    let board = Paint::Checker { squares: 12.0, colors: [0.75, 0.45].map(Color::splat) };
    Ok(Scene {
        objects: vec![
            object(
                Vec3::new(0.0, 1.0, 0.0),
                1.0,
                BlinnPhong::glossy(white, Color::splat(0.4), 50.0),
            ),
            Object {
                shape: floor(Vec3::new(-6.0, 0.0, 6.0), 12.0)?,
                material: BlinnPhong::matte(board),
            },
        ],
        lights: vec![near, sun],
        ambient: Color::splat(0.06),
        background: Color::new(0.02, 0.02, 0.03),
        view: ahead(Vec3::new(0.6, 1.9, 5.4), Vec3::new(0.0, 0.8, 0.0), 40.0),
    })
}

/// Nothing at all.
pub(super) fn empty() -> Scene<BlinnPhong> {
    Scene { objects: Vec::new(), ..dark() }
}

fn object(center: Vec3, radius: f32, material: BlinnPhong) -> Object<BlinnPhong> {
    Object { shape: Box::new(Sphere { center, radius }), material }
}

/// A square floor that faces up, from its front left corner.
fn floor(corner: Vec3, side: f32) -> Result<Box<dyn Shape>, Failure> {
    let floor = Quad::new(corner, [Vec3::X * side, Vec3::NEG_Z * side]);
    let floor = floor.ok_or_else(|| Failure::Usage("no picture: the floor has no area".into()))?;
    Ok(Box::new(floor))
}

fn ahead(eye: Vec3, target: Vec3, vertical_fov: f32) -> View {
    View { eye, target, up: Vec3::Y, vertical_fov }
}

/// The message about a lamp that can't be.
pub(super) fn no_light(error: LightError) -> Failure {
    Failure::Usage(format!("no light: {error}"))
}
