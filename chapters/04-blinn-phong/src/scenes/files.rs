//! The scenes that are made of a mesh: built in, made up, or from a file.

use common::chapter::Failure;
use common::film::Color;
use glam::Vec3;
use ray_casting::picture::BACKGROUND;
use triangles::parts::{Part, by_material};
use triangles::scene::MeshScene;

use super::shows::no_light;
use super::{MeshShape, Stage};
use crate::light::Light;
use crate::material::BlinnPhong;
use crate::mtl;
use crate::object::Object;
use crate::paint::Paint;
use crate::scene::Scene;

/// The report's §5.2: the bunny under two lamps.
pub(super) fn bunny(mesh_shape: MeshShape) -> Result<Stage, Failure> {
    let lamp = |x: f32| Light::steady(Vec3::new(x, 70.0, 20.0), Color::ONE);
    // 0.6 of a half, as the report's framework has it for meshes.
    let material = BlinnPhong::matte(Paint::Plain(Color::splat(0.3)));
    let MeshScene { mesh, view, calls, .. } = MeshScene::named("bunny")?;
    let scene = Scene {
        objects: vec![Object { shape: mesh_shape(mesh), material }],
        lights: vec![lamp(-20.0), lamp(20.0)],
        ambient: Color::ZERO,
        background: BACKGROUND,
        view,
    };
    Stage::new(scene, calls)
}

/// A bumpy sphere of the named number of triangles.
pub(super) fn sphere(name: &str, mesh_shape: MeshShape) -> Result<Stage, Failure> {
    let MeshScene { mesh, view, calls, .. } = MeshScene::named(name)?;
    let red = Paint::Plain(Color::new(0.7, 0.25, 0.15));
    let sun = Light::far(Vec3::new(0.5, 1.0, 0.3), Color::splat(0.6)).map_err(no_light)?;
    let scene = Scene {
        objects: vec![Object {
            shape: mesh_shape(mesh),
            material: BlinnPhong::glossy(red, Color::splat(0.4), 30.0),
        }],
        lights: vec![Light::steady(Vec3::new(-3.0, 2.0, 4.0), Color::splat(0.5)), sun],
        ambient: Color::splat(0.1),
        background: BACKGROUND,
        view,
    };
    Stage::new(scene, calls)
}

// ANCHOR: file
/// The mesh of a file, an object a material. An OBJ file knows no lamps, so it gets two: one to the
/// left of the eye and a weaker one far to the right.
pub(super) fn file(name: &str, mesh_shape: MeshShape) -> Result<Stage, Failure> {
    let MeshScene { mesh, view, warnings, calls, materials, material_of } = MeshScene::named(name)?;
    let lamp = |toward: Vec3, level: f32| Light::far(toward, Color::splat(level)).map_err(no_light);
    let lights = vec![lamp(Vec3::new(-0.4, 1.0, 0.9), 0.9)?, lamp(Vec3::new(1.0, 0.4, 0.1), 0.3)?];

    let mut objects = Vec::new();
    for Part { mesh, material } in by_material(&mesh, &material_of) {
        let material = material.and_then(|number| materials.get(number as usize));
        let material = material.map_or(Ok(mtl::UNNAMED), mtl::material);
        let material = material.map_err(|error| Failure::Work(format!("{name}: {error}")))?;
        objects.push(Object { shape: mesh_shape(mesh), material });
    }

    let scene = Scene { objects, lights, ambient: Color::ONE, background: BACKGROUND, view };
    Ok(Stage { warnings, ..Stage::new(scene, calls)? })
}
// ANCHOR_END: file
