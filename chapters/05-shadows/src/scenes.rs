//! The chapter's scenes: those of chapter 4, and one that comes in three sizes.

use blinn_phong::light::Light;
use blinn_phong::material::BlinnPhong;
use blinn_phong::object::Object;
use blinn_phong::paint::Paint;
use blinn_phong::scene::Scene;
use blinn_phong::scenes::{MeshShape, SCENES as EARLIER, Stage};
use common::chapter::{Failure, SceneName};
use common::film::Color;
use glam::Vec3;
use ray_casting::camera::View;
use ray_casting::quad::Quad;
use ray_casting::shape::Shape;
use ray_casting::sphere::Sphere;
use triangles::bumpy;
use triangles::mesh::Mesh;

const OWN: [SceneName; 5] = [
    SceneName { name: "three-lamps", about: "a ball and a bumpy one under three coloured lamps" },
    SceneName { name: "small", about: "the same, everything times 2^-13" },
    SceneName { name: "large", about: "the same, everything times 2^13" },
    SceneName { name: "far", about: "the same, 100,000 to the right and as far behind" },
    SceneName { name: "alone", about: "its ball, and nothing that a shadow could fall on" },
];

const COUNT: usize = OWN.len() + EARLIER.len();

const ALL: [SceneName; COUNT] = {
    let mut all = [OWN[0]; COUNT];
    let mut index = 0;
    while index < COUNT {
        all[index] = if index < OWN.len() { OWN[index] } else { EARLIER[index - OWN.len()] };
        index += 1;
    }
    all
};

/// The scenes this chapter has.
pub const SCENES: &[SceneName] = &ALL;

/// The scene called `name`; `mesh_shape` makes meshes into shapes.
///
/// # Errors
/// As for [`Stage::named`].
pub fn named(name: &str, mesh_shape: MeshShape) -> Result<Stage, Failure> {
    let plain = Place { scale: 1.0, shift: Vec3::ZERO };
    let place = match name {
        "three-lamps" => plain,
        "small" => Place { scale: 1.0 / 8192.0, ..plain },
        "large" => Place { scale: 8192.0, ..plain },
        "far" => Place { shift: Vec3::new(1e5, 0.0, -1e5), ..plain },
        "alone" => return Stage::new(alone(plain), Vec::new()),
        name => return Stage::named(name, mesh_shape),
    };
    Stage::new(three_lamps(place, mesh_shape)?, Vec::new())
}

/// How large the scene is, and where.
#[derive(Clone, Copy)]
struct Place {
    scale: f32,
    shift: Vec3,
}

impl Place {
    fn point(self, x: f32, y: f32, z: f32) -> Vec3 {
        self.scale * Vec3::new(x, y, z) + self.shift
    }

    fn ball(self) -> Object<BlinnPhong> {
        let shape = Sphere { center: self.point(-1.1, 1.0, -0.4), radius: self.scale };
        Object { shape: Box::new(shape), material: white(0.5) }
    }

    fn lamps(self) -> Vec<Light> {
        let lamp = |x, y, z, color: [f32; 3]| Light::steady(self.point(x, y, z), color.into());
        vec![
            lamp(-5.0, 6.0, 3.5, [0.75, 0.12, 0.08]),
            lamp(0.5, 7.5, 4.5, [0.1, 0.62, 0.16]),
            lamp(5.5, 5.5, 2.0, [0.1, 0.2, 0.8]),
        ]
    }
}

// ANCHOR: three_lamps
/// A ball and a bumpy one on a floor, under a red, a green and a blue lamp.
fn three_lamps(place: Place, mesh_shape: MeshShape) -> Result<Scene<BlinnPhong>, Failure> {
    let mut bumpy = bumpy::sphere(400);
    for position in &mut bumpy.positions {
        *position = place.point(position.x + 1.4, position.y + 1.2, position.z + 0.3);
    }
    let bumpy = Mesh { normals: Vec::new(), ..bumpy };
    let floor = Object { shape: floor(place)?, material: white(0.0) };
    let bumpy = Object { shape: mesh_shape(bumpy), material: white(0.3) };
    Ok(Scene { objects: vec![floor, place.ball(), bumpy], ..alone(place) })
}
// ANCHOR_END: three_lamps

fn floor(place: Place) -> Result<Box<dyn Shape>, Failure> {
    let edges = [Vec3::X, Vec3::NEG_Z].map(|edge| 24.0 * place.scale * edge);
    let floor = Quad::new(place.point(-12.0, 0.0, 12.0), edges);
    Ok(Box::new(floor.ok_or_else(|| Failure::Usage("no picture: the floor has no area".into()))?))
}

fn alone(place: Place) -> Scene<BlinnPhong> {
    Scene {
        objects: vec![place.ball()],
        lights: place.lamps(),
        ambient: Color::splat(0.05),
        background: Color::new(0.02, 0.02, 0.03),
        view: View {
            eye: place.point(0.6, 4.4, 7.6),
            target: place.point(0.0, 0.6, 0.0),
            up: Vec3::Y,
            vertical_fov: 33.0,
        },
    }
}

/// White, with a highlight as strong as this.
fn white(highlight: f32) -> BlinnPhong {
    BlinnPhong::glossy(Paint::Plain(Color::splat(0.8)), Color::splat(highlight), 40.0)
}
