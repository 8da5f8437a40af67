//! Scenes that show what glass and metal do.

use blinn_phong::light::Light;
use blinn_phong::material::BlinnPhong;
use blinn_phong::object::Object;
use blinn_phong::paint::Paint;
use blinn_phong::scene::Scene;
use blinn_phong::scenes::Stage;
use common::chapter::Failure;
use common::film::Color;
use glam::Vec3;
use ray_casting::camera::View;
use ray_casting::picture::BACKGROUND;
use ray_casting::plane::Plane;
use ray_casting::quad::Quad;
use ray_casting::shape::Shape;
use ray_casting::sphere::Sphere;

use super::Surfaces;
use crate::conductor::Metal;
use crate::glass::{Glass, Surface};
use crate::index::Index;

/// A stage, and what its objects are made of.
type Show = (Stage, Surfaces);

// ANCHOR: whitted
/// The report's figure 5.2 is chapter 4's scene, but for the second ball.
pub(super) fn whitted(index: Index) -> Surfaces {
    vec![None, Some(Surface::Glass(Glass::new(index))), None]
}
// ANCHOR_END: whitted

/// The eye under water, and balls above it and below.
pub(super) fn pool() -> Result<Show, Failure> {
    let red = BlinnPhong::glossy(plain(0.8, 0.15, 0.1), Color::splat(0.3), 30.0);
    let yellow = BlinnPhong::glossy(plain(0.9, 0.7, 0.1), Color::splat(0.3), 30.0);
    let white = BlinnPhong::matte(plain(0.7, 0.75, 0.7));
    let water = Surface::Glass(Glass::new(Index::WATER));
    let things = vec![
        (plane(Vec3::Y)?, black(), Some(water)),
        (floor(Vec3::new(-40.0, -3.0, 40.0), 80.0)?, tiles(80.0), None),
        (sphere(Vec3::new(1.5, 1.1, -1.0), 1.0), red, None),
        (sphere(Vec3::new(-1.2, 0.6, 0.6), 0.5), yellow, None),
        (sphere(Vec3::new(-1.7, -0.9, -1.2), 0.5), white, None),
    ];
    let lights = vec![
        Light::steady(Vec3::new(-4.0, 7.0, 6.0), Color::splat(0.9)),
        // A lamp in the water: the one above can't be found through the surface.
        Light::steady(Vec3::new(3.0, -0.4, 3.0), Color::splat(1.2)),
    ];
    let view = View {
        eye: Vec3::new(0.3, -2.4, 0.6),
        target: Vec3::new(0.3, 0.0, 0.4),
        up: Vec3::NEG_Z,
        vertical_fov: 115.0,
    };
    show(things, lights, Lit { ambient: 0.15, background: EVENING }, view)
}

/// Media in media: water in a ball of glass, a bubble in another, and glass half under water.
pub(super) fn nested(index: Index) -> Result<Show, Failure> {
    let glass = Glass::new(index).ranked(2);
    let water = Glass::new(Index::WATER).ranked(1);
    let filled = Glass::new(Index::WATER).ranked(3);
    let bubble = Glass::new(Index::AIR).ranked(3);
    let of = |glass| Some(Surface::Glass(glass));
    let center = [Vec3::new(-2.3, 0.1, -7.0), Vec3::new(0.1, 0.1, -6.4), Vec3::new(2.5, 0.1, -7.0)];
    let things = vec![
        (sphere(center[0], 1.1), black(), of(glass)),
        (sphere(center[0], 0.95), black(), of(filled)),
        (sphere(center[1], 1.1), black(), of(glass)),
        (sphere(center[1], 0.7), black(), of(bubble)),
        // The lower half of this ball is filled: water overlaps glass, and glass has the rank.
        (sphere(center[2], 1.1), black(), of(glass)),
        (sphere(center[2] - 0.9 * Vec3::Y, 0.95), black(), of(water)),
        (floor(Vec3::new(-8.0, -1.9, -2.0), 16.0)?, tiles(16.0), None),
    ];
    let lights = vec![Light::steady(Vec3::new(-6.0, 12.0, 4.0), Color::splat(0.9))];
    let view = View {
        eye: Vec3::new(0.0, 1.0, 0.0),
        target: Vec3::new(0.0, -0.2, -7.0),
        up: Vec3::Y,
        vertical_fov: 50.0,
    };
    show(things, lights, Lit { ambient: 0.2, background: BACKGROUND }, view)
}

/// Gold, silver and copper under a sky, over a checkerboard.
pub(super) fn metals() -> Result<Show, Failure> {
    let ball = |x: f32, metal| {
        (sphere(Vec3::new(x, 1.0, -6.0), 1.0), black(), Some(Surface::Metal(metal)))
    };
    let things = vec![
        ball(-2.3, Metal::GOLD),
        ball(0.0, Metal::SILVER),
        ball(2.3, Metal::COPPER),
        (floor(Vec3::new(-9.0, 0.0, 3.0), 18.0)?, tiles(18.0), None),
    ];
    let lights = vec![Light::steady(Vec3::new(-6.0, 12.0, 4.0), Color::splat(0.8))];
    let view = View {
        eye: Vec3::new(0.0, 1.8, 1.0),
        target: Vec3::new(0.0, 0.8, -6.0),
        up: Vec3::Y,
        vertical_fov: 40.0,
    };
    show(things, lights, Lit { ambient: 0.2, background: HAZE }, view)
}

type Thing = (Box<dyn Shape>, BlinnPhong, Option<Surface>);

/// A sky that water makes 1.77 times as bright.
const EVENING: Color = Color::new(0.12, 0.34, 0.5);
/// A sky with hardly any colour of its own.
const HAZE: Color = Color::new(0.7, 0.76, 0.8);

/// The light from all around.
struct Lit {
    ambient: f32,
    background: Color,
}

fn show(
    things: Vec<Thing>,
    lights: Vec<Light>,
    Lit { ambient, background }: Lit,
    view: View,
) -> Result<Show, Failure> {
    let mut objects = Vec::new();
    let mut surfaces = Vec::new();
    for (shape, material, surface) in things {
        objects.push(Object { shape, material });
        surfaces.push(surface);
    }
    let scene = Scene { objects, lights, ambient: Color::splat(ambient), background, view };
    Ok((Stage::new(scene, Vec::new())?, surfaces))
}

fn plain(red: f32, green: f32, blue: f32) -> Paint {
    Paint::Plain(Color::new(red, green, blue))
}

/// What glass and metal have of their own colour.
fn black() -> BlinnPhong {
    BlinnPhong::matte(Paint::Plain(Color::ZERO))
}

fn tiles(squares: f32) -> BlinnPhong {
    let colors = [Color::new(0.75, 0.75, 0.7), Color::new(0.25, 0.35, 0.4)];
    BlinnPhong::matte(Paint::Checker { squares, colors })
}

fn sphere(center: Vec3, radius: f32) -> Box<dyn Shape> {
    Box::new(Sphere { center, radius })
}

/// A square floor that faces up, from its front left corner.
fn floor(corner: Vec3, side: f32) -> Result<Box<dyn Shape>, Failure> {
    let floor = Quad::new(corner, [Vec3::X * side, Vec3::NEG_Z * side]);
    Ok(Box::new(floor.ok_or_else(|| impossible("the floor has no area"))?))
}

/// The plane through the origin.
fn plane(normal: Vec3) -> Result<Box<dyn Shape>, Failure> {
    let plane = Plane::new(Vec3::ZERO, normal);
    Ok(Box::new(plane.ok_or_else(|| impossible("the water has no surface"))?))
}

fn impossible(why: &str) -> Failure {
    Failure::Usage(format!("no picture: {why}"))
}
