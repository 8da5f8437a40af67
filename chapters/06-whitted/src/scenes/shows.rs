//! The scenes that are made of mirrors.

use blinn_phong::light::Light;
use blinn_phong::material::BlinnPhong;
use blinn_phong::object::Object;
use blinn_phong::paint::Paint;
use blinn_phong::scene::Scene;
use blinn_phong::scenes::MeshShape;
use common::chapter::Failure;
use common::film::Color;
use common::sampler::Stream;
use glam::Vec3;
use ray_casting::camera::View;
use ray_casting::picture::BACKGROUND;
use ray_casting::plane::Plane;
use ray_casting::quad::Quad;
use ray_casting::shape::Shape;
use ray_casting::sphere::Sphere;
use triangles::bumpy;

use crate::material::Mirrored;

/// What a good mirror returns.
pub(super) const SILVER: Color = Color::new(0.8, 0.8, 0.8);

// ANCHOR: facing
/// The radiance that each of two facing mirrors sends by itself, and what it returns of the other's.
pub const FACING: [Color; 2] = [Color::new(0.04, 0.06, 0.1), Color::new(0.95, 0.9, 0.8)];

/// Two mirrors without end, five apart. A ray between them never gets out, and each mirror adds the
/// same light: a geometric series.
pub(super) fn facing_mirrors() -> Result<Scene<Mirrored>, Failure> {
    let [light, mirror] = FACING;
    let glow = Mirrored { surface: BlinnPhong::matte(Paint::Plain(light)), mirror };
    Ok(Scene {
        objects: vec![
            Object { shape: some(Plane::new(Vec3::Z * -3.0, Vec3::Z))?, material: glow },
            Object { shape: some(Plane::new(Vec3::Z * 2.0, Vec3::NEG_Z))?, material: glow },
        ],
        lights: Vec::new(),
        ambient: Color::ONE,
        background: Color::ZERO,
        view: view(Vec3::ZERO, Vec3::new(0.3, 0.2, -1.0), 50.0),
    })
}
// ANCHOR_END: facing

/// Three balls on a floor between two mirrors.
pub(super) fn hall() -> Result<Scene<Mirrored>, Failure> {
    let board = Paint::Checker {
        squares: 4.0,
        colors: [Color::new(0.75, 0.7, 0.6), Color::new(0.12, 0.14, 0.2)],
    };
    let glass = Color::new(0.9, 0.94, 0.92);
    let wall = |x: f32, edges| some(Quad::new(Vec3::new(x, 0.0, 2.0), edges));
    let (up, deep) = (Vec3::Y * 2.6, Vec3::Z * -4.0);
    let floor = some(Quad::new(Vec3::new(-2.0, 0.0, 2.0), [Vec3::X * 4.0, deep]))?;
    Ok(Scene {
        objects: vec![
            Object { shape: floor, material: Mirrored::dull(BlinnPhong::matte(board)) },
            Object { shape: wall(-2.0, [deep, up])?, material: pure(glass) },
            Object { shape: wall(2.0, [up, deep])?, material: pure(glass) },
            ball(Vec3::new(-0.7, 0.55, -0.6), 0.55, painted(Color::new(0.75, 0.16, 0.1))),
            ball(Vec3::new(0.75, 0.4, -1.0), 0.4, painted(Color::new(0.1, 0.35, 0.7))),
            ball(Vec3::new(0.2, 0.3, 0.5), 0.3, pure(SILVER)),
        ],
        lights: vec![lamp(Vec3::new(0.4, 2.4, 0.4), 5.0)],
        ambient: Color::splat(0.08),
        background: Color::new(0.1, 0.14, 0.2),
        view: view(Vec3::new(1.85, 1.45, -0.15), Vec3::new(-2.0, 0.25, -0.45), 60.0),
    })
}

/// Three long mirrors that face one another, and coloured beads behind them.
pub(super) fn kaleidoscope() -> Result<Scene<Mirrored>, Failure> {
    // The corners of the tube, a triangle with equal sides around the line of sight.
    let corners =
        [Vec3::new(0.0, 1.2, 0.0), Vec3::new(-1.04, -0.6, 0.0), Vec3::new(1.04, -0.6, 0.0)];
    let far = Vec3::Z * -6.0;
    let mut objects = Vec::new();
    for (corner, next) in corners.into_iter().zip(corners.into_iter().cycle().skip(1)) {
        let shape = some(Quad::new(corner, [next - corner, far]))?;
        objects.push(Object { shape, material: pure(Color::splat(0.94)) });
    }
    objects.extend((0..26).map(bead));
    Ok(Scene {
        objects,
        lights: vec![lamp(Vec3::new(0.3, 0.4, -5.0), 2.0)],
        ambient: Color::splat(0.25),
        background: Color::new(0.03, 0.02, 0.06),
        view: view(Vec3::new(0.1, 0.0, -0.2), Vec3::new(0.05, -0.05, -6.0), 95.0),
    })
}

/// A bead at the end of the kaleidoscope.
fn bead(number: u64) -> Object<Mirrored> {
    let mut stream = Stream::of_trial(660, number);
    let (x, y) = (stream.between(-0.9, 0.9), stream.between(-0.6, 1.0));
    let radius = stream.between(0.1, 0.24);
    let hue = Color::new(stream.uniform(), stream.uniform(), stream.uniform());
    // The strongest part of a colour is full, the weakest is gone.
    let hue = (hue - hue.min_element()) / (hue.max_element() - hue.min_element()).max(0.01);
    let z = -6.1 - 0.4 * stream.uniform();
    ball(Vec3::new(x, y, z), radius, painted(0.05 + 0.85 * hue))
}

/// A mirror of few triangles, shaded as if it were smooth, over a floor.
pub(super) fn chrome(mesh_shape: MeshShape) -> Result<Scene<Mirrored>, Failure> {
    let board = Paint::Checker {
        squares: 8.0,
        colors: [Color::new(0.8, 0.75, 0.65), Color::new(0.25, 0.08, 0.08)],
    };
    let floor = Quad::new(Vec3::new(-6.0, -1.5, 6.0), [Vec3::X * 12.0, Vec3::Z * -12.0]);
    Ok(Scene {
        objects: vec![
            Object { shape: mesh_shape(bumpy::sphere(300)), material: pure(SILVER) },
            Object { shape: some(floor)?, material: Mirrored::dull(BlinnPhong::matte(board)) },
        ],
        lights: vec![Light::steady(Vec3::new(-3.0, 5.0, 4.0), Color::splat(0.8))],
        ambient: Color::splat(0.2),
        background: BACKGROUND,
        view: view(Vec3::new(0.6, 1.2, 3.6), Vec3::new(0.0, -0.15, 0.0), 46.0),
    })
}

/// A surface that does nothing but mirror.
fn pure(mirror: Color) -> Mirrored {
    Mirrored { surface: BlinnPhong::matte(Paint::Plain(Color::ZERO)), mirror }
}

/// A coloured ball that mirrors a little.
fn painted(color: Color) -> Mirrored {
    let surface = BlinnPhong::glossy(Paint::Plain(color), Color::splat(0.4), 60.0);
    Mirrored { surface, mirror: Color::splat(0.06) }
}

fn ball(center: Vec3, radius: f32, material: Mirrored) -> Object<Mirrored> {
    Object { shape: Box::new(Sphere { center, radius }), material }
}

/// A lamp that fades with the square of the distance.
fn lamp(position: Vec3, strength: f32) -> Light {
    Light::Point { position, color: Color::splat(strength), falloff: [0.5, 0.0, 1.0] }
}

fn view(eye: Vec3, target: Vec3, vertical_fov: f32) -> View {
    View { eye, target, up: Vec3::Y, vertical_fov }
}

/// The shape, if its numbers make one.
fn some<S: Shape + 'static>(shape: Option<S>) -> Result<Box<dyn Shape>, Failure> {
    let shape = shape.ok_or_else(|| Failure::Usage("no picture: a mirror has no area".into()))?;
    Ok(Box::new(shape))
}
