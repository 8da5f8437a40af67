//! The chapter's scenes: those of chapter 4 with their mirrors, and some that have little else.

pub mod shows;

use blinn_phong::scene::Scene;
use blinn_phong::scenes::{self, MeshShape};
use common::chapter::{Failure, SceneName, unknown_scene};
use common::film::Color;
use common::plan::{Call, Effect};
use ray_casting::camera::{Camera, View};
use triangles::scene::is_file;

use crate::material::Mirrored;
use crate::mtl;

/// The scenes this chapter has.
pub const SCENES: &[SceneName] = &[
    SceneName { name: "whitted", about: "the report's two spheres; the second is a mirror yet" },
    SceneName { name: "facing-mirrors", about: "two endless mirrors: the light is a series" },
    SceneName { name: "hall", about: "balls between two mirrors" },
    SceneName { name: "kaleidoscope", about: "beads at the end of three mirrors" },
    SceneName { name: "chrome", about: "a mirror made of 300 triangles that is to look smooth" },
    SceneName { name: "bunny", about: "the report's bunny under two lamps: no mirror" },
    SceneName { name: "low-lamp", about: "a wet floor and a ball, towards a low lamp" },
    SceneName { name: "two-lamps", about: "a ball, a lamp near by and one far away" },
    SceneName { name: "sphere:N", about: "a bumpy sphere with N triangles, glossy" },
    SceneName { name: "dark", about: "the report's spheres with the lamps off" },
    SceneName { name: "empty", about: "nothing at all" },
    SceneName { name: "FILE.obj", about: "a mesh of your own, with its MTL materials" },
];

/// A scene with mirrors that can be drawn.
pub struct Stage {
    /// Objects, lamps, background, and the view that belongs to `camera`.
    pub scene: Scene<Mirrored>,
    /// The camera, its film still to be chosen.
    pub camera: Camera,
    /// The effects its data call for.
    pub calls: Vec<Call>,
    /// What the user should be told of the file.
    pub warnings: Vec<String>,
}

impl Stage {
    /// The scene called `name`: one of [`SCENES`], or an OBJ file. `mesh_shape` makes meshes into
    /// shapes, and `aim` says where it is seen from.
    ///
    /// # Errors
    /// As [`blinn_phong::scenes::Stage::named`].
    pub fn named(
        name: &str,
        mesh_shape: MeshShape,
        aim: impl FnOnce(&mut View),
    ) -> Result<Self, Failure> {
        match name {
            "facing-mirrors" => Self::new(shows::facing_mirrors()?, aim),
            "hall" => Self::new(shows::hall()?, aim),
            "kaleidoscope" => Self::new(shows::kaleidoscope()?, aim),
            "chrome" => Self::new(shows::chrome(mesh_shape)?, aim),
            name if name.starts_with("sphere:") || is_file(name) || is_built_in(name) => {
                Self::of_earlier(name, scenes::Stage::named(name, mesh_shape)?, aim)
            }
            name => Err(unknown_scene(name, SCENES)),
        }
    }

    /// A stage for a scene of this chapter.
    fn new(scene: Scene<Mirrored>, aim: impl FnOnce(&mut View)) -> Result<Self, Failure> {
        let mut mirrors = Vec::new();
        let lit = scene.map(|_, Mirrored { surface, mirror }| {
            mirrors.push(mirror);
            surface
        });
        Self::with_mirrors(scenes::Stage::new(lit, Vec::new())?, &mirrors, aim)
    }

    /// A scene of chapter 4, with what its data say of mirrors.
    fn of_earlier(
        name: &str,
        mut stage: scenes::Stage,
        aim: impl FnOnce(&mut View),
    ) -> Result<Self, Failure> {
        let records = stage.records.iter();
        let mirror = |record: &Option<_>| record.as_ref().map_or(Color::ZERO, mtl::mirror);
        let mut mirrors: Vec<Color> = records.clone().map(mirror).collect();
        stage.warnings.extend(records.flatten().filter_map(mtl::warning));
        mirrors.resize(stage.scene.objects.len(), Color::ZERO);
        if ["whitted", "dark"].contains(&name) {
            mirrors[1] = shows::SILVER;
        }
        Self::with_mirrors(stage, &mirrors, aim)
    }

    /// The stage with a mirror for each of its objects.
    fn with_mirrors(
        stage: scenes::Stage,
        mirrors: &[Color],
        aim: impl FnOnce(&mut View),
    ) -> Result<Self, Failure> {
        let scenes::Stage { scene, camera, calls, warnings, .. } = stage.seen_from(aim)?;
        let calls = called(shadows::calls::of_scene(&scene, &calls), mirrors);
        let scene = scene.map(|index, surface| Mirrored { surface, mirror: mirrors[index] });
        Ok(Self { scene, camera, calls, warnings })
    }
}

fn is_built_in(name: &str) -> bool {
    SCENES.iter().any(|scene| scene.name == name)
}

/// The calls, with the one for mirrors as the objects have them.
fn called(mut calls: Vec<Call>, mirrors: &[Color]) -> Vec<Call> {
    let count = mirrors.iter().filter(|&&mirror| mirror != Color::ZERO).count();
    let is_call = |call: &Call| call.effect == Effect::MirrorReflection;
    if count == 0 {
        calls.retain(|call| !is_call(call));
    } else if !calls.iter().any(is_call) {
        let because = format!("{count} of {} objects mirror", mirrors.len());
        calls.push(Call { effect: Effect::MirrorReflection, because });
    }
    calls
}
