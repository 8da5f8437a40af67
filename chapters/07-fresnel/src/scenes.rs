//! The chapter's scenes: chapter 4's, with glass and metal in them.

mod shows;

use blinn_phong::scene::Scene;
use blinn_phong::scenes::{self, MeshShape};
use common::chapter::{Failure, SceneName, unknown_scene};
use common::obj::Material;
use common::plan::{Call, Effect};
use glam::Vec3;
use ray_casting::camera::{Camera, View};
use ray_casting::ray::Ray;
use triangles::scene::is_file;
use whitted::material::Mirrored;

use crate::glass::{Glass, Surface};
use crate::index::Index;
use crate::inside::Inside;
use crate::mtl;

/// The scenes this chapter has.
pub const SCENES: &[SceneName] = &[
    SceneName {
        name: "whitted",
        about: "the report's figure 5.2: a glass ball, and one behind it",
    },
    SceneName { name: "pool", about: "from under water: the whole sky in a round window" },
    SceneName { name: "nested", about: "water in a glass ball, a bubble, and a ball half filled" },
    SceneName { name: "metals", about: "balls of gold, silver and copper" },
    SceneName { name: "curves", about: "no scene: a chart of how much glass reflects" },
    SceneName { name: "bunny", about: "the report's bunny under two lamps: no glass" },
    SceneName { name: "low-lamp", about: "a wet floor and a ball, towards a low lamp" },
    SceneName { name: "two-lamps", about: "a ball, a lamp near by and one far away" },
    SceneName { name: "sphere:N", about: "a bumpy sphere with N triangles, glossy" },
    SceneName { name: "dark", about: "the report's spheres with the lamps off" },
    SceneName { name: "empty", about: "nothing at all" },
    SceneName { name: "FILE.obj", about: "a mesh of your own, with its MTL materials" },
];

/// A scene with glass that can be drawn.
pub struct Stage {
    /// Objects, lamps, background, and the view that belongs to `camera`.
    pub scene: Scene<Surface>,
    /// The camera, its film still to be chosen.
    pub camera: Camera,
    /// The effects its data call for.
    pub calls: Vec<Call>,
    /// What the user should be told of the file.
    pub warnings: Vec<String>,
    /// The bodies around the eye.
    pub around_eye: Inside,
    /// Whether there may be a surface of glass that is no interface.
    pub unseen: bool,
}

/// What the objects of a scene are made of, where chapter 4 has no word for it.
type Surfaces = Vec<Option<Surface>>;

impl Stage {
    /// The scene called `name`: one of [`SCENES`], or an OBJ file. `mesh_shape` makes meshes into
    /// shapes, `aim` says where it is seen from, and `index` is that of glass which has none of its
    /// own.
    ///
    /// # Errors
    /// As [`blinn_phong::scenes::Stage::named`], and for an index that can't be (exit code 1).
    pub fn named(
        name: &str,
        mesh_shape: MeshShape,
        index: Index,
        aim: impl FnOnce(&mut View),
    ) -> Result<Self, Failure> {
        let (stage, surfaces) = match name {
            "pool" => shows::pool()?,
            "nested" => shows::nested(index)?,
            "metals" => shows::metals()?,
            "whitted" | "dark" => (scenes::Stage::named(name, mesh_shape)?, shows::whitted(index)),
            name if is_known(name) => of_records(name, scenes::Stage::named(name, mesh_shape)?)?,
            name => return Err(unknown_scene(name, SCENES)),
        };
        Ok(Self::new(stage.seen_from(aim)?, &surfaces))
    }

    /// A stage whose objects are made of `surfaces`; where those say nothing, of what chapter 4 says.
    fn new(stage: scenes::Stage, surfaces: &[Option<Surface>]) -> Self {
        let scenes::Stage { scene, camera, calls, warnings, .. } = stage;
        let scene = scene.map(|number, material| {
            let surface = surfaces.get(number).copied().flatten();
            surface.unwrap_or_else(|| Surface::Opaque(Mirrored::dull(material)))
        });
        let calls = with_glass(calls, &scene);
        let around_eye = around(&scene, scene.view.eye);
        let air = glasses(&scene).any(|(_, glass)| glass.index == Index::AIR);
        let unseen = air || glasses(&scene).count() > 1;
        Self { scene, camera, calls, warnings, around_eye, unseen }
    }
}

fn is_known(name: &str) -> bool {
    let built_in = SCENES.iter().any(|scene| scene.name == name);
    (built_in && name != "curves") || name.starts_with("sphere:") || is_file(name)
}

/// A scene of chapter 4, with what its file says of glass and mirrors.
fn of_records(name: &str, mut stage: scenes::Stage) -> Result<(scenes::Stage, Surfaces), Failure> {
    let mut surfaces = Vec::new();
    let materials = stage.scene.objects.iter().map(|object| object.material);
    for (material, record) in materials.zip(&stage.records) {
        let surface = record.as_ref().map(|record| mtl::surface(record, material)).transpose();
        surfaces.push(surface.map_err(|error| Failure::Work(format!("{name}: {error}")))?);
    }
    let records: Vec<&Material> = stage.records.iter().flatten().collect();
    let told: Vec<String> = records.into_iter().filter_map(whitted::mtl::warning).collect();
    stage.warnings.extend(told);
    Ok((stage, surfaces))
}

/// The bodies of glass, by their place in the scene.
fn glasses(scene: &Scene<Surface>) -> impl Iterator<Item = (usize, &Glass)> {
    let objects = scene.objects.iter().enumerate();
    objects.filter_map(|(number, object)| Some((number, object.material.glass()?)))
}

// ANCHOR: around
/// The bodies of glass that are around a point: those that a ray from there leaves before it
/// enters them.
pub fn around(scene: &Scene<Surface>, point: Vec3) -> Inside {
    let bodies = glasses(scene).filter(|&(number, _)| {
        // A body without end, as water under a plane, isn't met in every direction.
        let directions = Vec3::AXES.into_iter().flat_map(|axis| [axis, -axis]);
        let first = directions.into_iter().find_map(|direction| {
            let ray = Ray { origin: point, direction };
            let hit = scene.objects[number].shape.hit(&ray, f32::INFINITY)?;
            Some(hit.geometric.dot(direction) > 0.0)
        });
        first.unwrap_or(false)
    });
    bodies.fold(Inside::default(), |inside, (number, _)| inside.with(number as u32))
}
// ANCHOR_END: around

// ANCHOR: calls
/// What the scene calls for: what chapter 4 found, and what its glass and metal ask for.
fn with_glass(mut calls: Vec<Call>, scene: &Scene<Surface>) -> Vec<Call> {
    calls.retain(|it| !matches!(it.effect, Effect::MirrorReflection | Effect::Refraction));
    let first = |wanted: fn(&Surface) -> bool| {
        let place = scene.objects.iter().position(|object| wanted(&object.material));
        place.map(|place| format!("object {}", place + 1))
    };
    let reflects = first(|surface| match surface {
        Surface::Opaque(material) | Surface::Polished(material) => material.reflects(),
        Surface::Metal(_) | Surface::Glass(_) => true,
    });
    let refracts = first(|surface| surface.glass().is_some());
    let because = |object: String, what: &str| format!("{object} {what}");
    calls.extend(reflects.map(|object| Call {
        effect: Effect::MirrorReflection,
        because: because(object, "reflects"),
    }));
    calls.extend(
        refracts.map(|object| Call {
            effect: Effect::Refraction,
            because: because(object, "is glass"),
        }),
    );
    calls
}
// ANCHOR_END: calls
