//! What there is to see: shapes, and where to look at them from.

use common::plan::{Call, Effect};
use glam::Vec3;

use crate::camera::View;
use crate::plane::Plane;
use crate::quad::Quad;
use crate::shape::Shape;
use crate::sphere::Sphere;

/// A scene as geometry alone: this chapter knows no light and no material.
pub struct Geometry {
    /// Where it is seen from.
    pub view: View,
    /// What there is to see.
    pub shapes: Vec<Box<dyn Shape>>,
    /// The distances that a picture of depth shows as white and as black.
    pub depths: [f32; 2],
    /// What a finished picture of it asks for.
    pub calls: Vec<Call>,
}

/// Chooses the formula: makes a sphere into a shape.
pub type SphereShape = fn(Sphere) -> Box<dyn Shape>;

// ANCHOR: whitted
/// The report's figure 5.2: two spheres over a floor.
pub fn whitted(sphere: SphereShape) -> Geometry {
    let corner = Vec3::new(-5.0, -3.0, -6.0);
    let floor = Quad::new(corner, [Vec3::X * 10.0, Vec3::NEG_Z * 10.0]);
    let mut shapes = vec![
        sphere(Sphere { center: Vec3::new(-1.0, 0.0, -12.0), radius: 2.0 }),
        sphere(Sphere { center: Vec3::new(0.5, -0.5, -8.0), radius: 1.5 }),
    ];
    shapes.extend(floor.map(|floor| Box::new(floor) as Box<dyn Shape>));
    Geometry { view: ahead(Vec3::ZERO, 90.0), shapes, depths: [4.0, 18.0], calls: whitted_calls() }
}
// ANCHOR_END: whitted

/// What the report's picture of these spheres has.
fn whitted_calls() -> Vec<Call> {
    [
        (Effect::PrimaryVisibility, "it has two spheres and a floor"),
        (Effect::LocalShading, "two lamps light it"),
        (Effect::HardShadows, "its lamps are points"),
        (Effect::MirrorReflection, "sphere 2 reflects"),
        (Effect::Refraction, "sphere 2 is glass"),
        (Effect::Textures, "the floor is a checkerboard"),
    ]
    .map(|(effect, because)| Call { effect, because: because.into() })
    .into()
}

// ANCHOR: ground
/// A ball on the ground, and the ground is a sphere with a radius of ten million: hard case RC-02.
pub fn ground(sphere: SphereShape) -> Geometry {
    let radius = 1e7;
    let shapes = vec![
        sphere(Sphere { center: Vec3::new(0.0, 1.0, -5.0), radius: 1.0 }),
        sphere(Sphere { center: Vec3::new(0.0, -radius, 0.0), radius }),
    ];
    let view = ahead(Vec3::new(1.5, 1.0, 0.0), 60.0);
    Geometry { view, shapes, depths: [1.0, 30.0], calls: seen("a ball and the ground") }
}
// ANCHOR_END: ground

// ANCHOR: far
/// A sphere of radius 1, ten thousand away, through a very long lens: hard case RC-01.
pub fn far(sphere: SphereShape) -> Geometry {
    // 4800² + 3600² = 6000², and 6000² + 8000² = 10000².
    let center = Vec3::new(4800.0, 3600.0, -8000.0);
    let view = View { eye: Vec3::ZERO, target: center, up: Vec3::Y, vertical_fov: 0.04 };
    let shapes = vec![sphere(Sphere { center, radius: 1.0 })];
    Geometry { view, shapes, depths: [9999.0, 10000.0], calls: seen("one sphere") }
}
// ANCHOR_END: far

/// A ball over a plane that ends nowhere, seen from a slope of one in five.
pub fn horizon(sphere: SphereShape) -> Geometry {
    let mut shapes = vec![sphere(Sphere { center: Vec3::new(-0.5, 0.8, -4.0), radius: 1.2 })];
    shapes.extend(Plane::new(Vec3::ZERO, Vec3::Y).map(|plane| Box::new(plane) as Box<dyn Shape>));
    let eye = Vec3::new(0.0, 1.5, 2.0);
    let view = View { target: eye + Vec3::new(0.0, -1.0, -5.0), ..ahead(eye, 60.0) };
    Geometry { view, shapes, depths: [1.0, 30.0], calls: seen("a ball and a plane") }
}

/// Nothing at all, which asks for nothing.
pub fn empty() -> Geometry {
    let view = ahead(Vec3::ZERO, 90.0);
    Geometry { view, shapes: Vec::new(), depths: [0.0, 1.0], calls: Vec::new() }
}

/// The view along -z.
fn ahead(eye: Vec3, vertical_fov: f32) -> View {
    View { eye, target: eye - Vec3::Z, up: Vec3::Y, vertical_fov }
}

/// The call of a scene that has nothing but shapes.
fn seen(what: &str) -> Vec<Call> {
    vec![Call { effect: Effect::PrimaryVisibility, because: format!("it has {what}") }]
}
