//! The chapter's scenes: what there is, what lights it, and what it calls for.

mod files;
mod shows;

use common::chapter::{Failure, SceneName, unknown_scene};
use common::plan::Call;
use ray_casting::camera::{Camera, View};
use ray_casting::shape::Shape;
use triangles::mesh::Mesh;
use triangles::packed::PackedMesh;
use triangles::scene::is_file;

use crate::calls;
use crate::material::BlinnPhong;
use crate::scene::Scene;

/// The scenes this chapter has.
pub const SCENES: &[SceneName] = &[
    SceneName { name: "whitted", about: "the report's two spheres over a checkerboard" },
    SceneName { name: "bunny", about: "the report's bunny under two lamps" },
    SceneName { name: "low-lamp", about: "a wet floor and a ball, towards a low lamp" },
    SceneName { name: "two-lamps", about: "a ball, a lamp near by and one far away" },
    SceneName { name: "sphere:N", about: "a bumpy sphere with N triangles, glossy" },
    SceneName { name: "dark", about: "the report's spheres with the lamps off" },
    SceneName { name: "empty", about: "nothing at all" },
    SceneName { name: "FILE.obj", about: "a mesh of your own, with its MTL materials" },
];

// ANCHOR: mesh_shape
/// Makes a mesh into something that rays can hit. Scenes never name what makes that quick: who
/// draws them chooses.
pub type MeshShape = fn(Mesh) -> Box<dyn Shape>;

/// Every ray asks every triangle, four at a time.
pub fn brute_force(mesh: Mesh) -> Box<dyn Shape> {
    Box::new(PackedMesh::new(mesh))
}
// ANCHOR_END: mesh_shape

/// A scene that can be drawn: its camera and its lamps were found to be possible.
pub struct Stage {
    /// Objects, lamps, background, and the view that belongs to `camera`.
    pub scene: Scene<BlinnPhong>,
    /// The camera, its film still to be chosen ([`Camera::with_film`]).
    pub camera: Camera,
    /// The effects its data call for, those that later chapters teach among them.
    pub calls: Vec<Call>,
    /// What the user should be told of the file.
    pub warnings: Vec<String>,
}

impl Stage {
    /// The scene called `name`: one of [`SCENES`], or an OBJ file. `mesh_shape` makes meshes into
    /// shapes; [`brute_force`] does in this chapter.
    ///
    /// # Errors
    /// A name that is none of these (exit code 2), or a file that is no mesh or has materials that
    /// can't be (exit code 1).
    pub fn named(name: &str, mesh_shape: MeshShape) -> Result<Self, Failure> {
        match name {
            "whitted" => Self::new(shows::whitted(), shows::whitted_calls()),
            "dark" => Self::new(shows::dark(), shows::whitted_calls()),
            "low-lamp" => Self::new(shows::low_lamp()?, Vec::new()),
            "two-lamps" => Self::new(shows::two_lamps()?, Vec::new()),
            "empty" => Self::new(shows::empty(), Vec::new()),
            "bunny" => files::bunny(mesh_shape),
            name if name.starts_with("sphere:") => files::sphere(name, mesh_shape),
            name if is_file(name) => files::file(name, mesh_shape),
            name => Err(unknown_scene(name, SCENES)),
        }
    }

    /// A stage for `scene`. `others` are calls for effects that the scene's own data can't show,
    /// such as those of materials that a later chapter will understand.
    ///
    /// # Errors
    /// A view or a lamp that can't be (exit code 2).
    pub fn new(scene: Scene<BlinnPhong>, others: Vec<Call>) -> Result<Self, Failure> {
        for light in &scene.lights {
            light.check().map_err(|error| Failure::Usage(format!("no light: {error}")))?;
        }
        let camera = Camera::new(&scene.view, 1, 1);
        let camera = camera.map_err(|error| Failure::Usage(format!("no picture: {error}")))?;
        let calls = calls::of_scene(&scene, &others);
        Ok(Self { scene, camera, calls, warnings: Vec::new() })
    }

    /// The same stage with its scene changed: seen from elsewhere, lit by other lamps, of other
    /// materials.
    ///
    /// # Errors
    /// As for [`Stage::new`].
    pub fn changed(mut self, change: impl FnOnce(&mut Scene<BlinnPhong>)) -> Result<Self, Failure> {
        change(&mut self.scene);
        Ok(Self { warnings: self.warnings, ..Self::new(self.scene, self.calls)? })
    }

    /// The same stage seen from elsewhere.
    ///
    /// # Errors
    /// As for [`Stage::new`].
    pub fn seen_from(self, aim: impl FnOnce(&mut View)) -> Result<Self, Failure> {
        self.changed(|scene| aim(&mut scene.view))
    }
}

#[cfg(test)]
mod tests {
    use common::chapter::Failure;
    use common::plan::Effect;
    use glam::Vec3;

    use super::{SCENES, Stage, brute_force};
    use crate::light::Light;
    use crate::object::Object;

    fn effects(stage: &Stage) -> Vec<Effect> {
        stage.calls.iter().map(|call| call.effect).collect()
    }

    fn stage(name: &str) -> Stage {
        Stage::named(name, brute_force).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    #[test]
    fn every_scene_calls_for_what_its_data_have() {
        use Effect::{
            HardShadows, LocalShading, MirrorReflection, PrimaryVisibility, Refraction,
            SmoothNormals, Textures,
        };
        let whitted =
            [PrimaryVisibility, LocalShading, Textures, HardShadows, MirrorReflection, Refraction];
        assert_eq!(effects(&stage("whitted")), whitted);
        let dark = [PrimaryVisibility, MirrorReflection, Refraction];
        assert_eq!(effects(&stage("dark")), dark);
        let bunny = [PrimaryVisibility, LocalShading, HardShadows, SmoothNormals];
        assert_eq!(effects(&stage("bunny")), bunny);
        assert_eq!(effects(&stage("sphere:100")), bunny);
        assert_eq!(effects(&stage("empty")), []);
    }

    #[test]
    fn every_built_in_scene_can_be_built() {
        for scene in SCENES.iter().filter(|scene| !scene.name.contains(char::is_uppercase)) {
            assert!(stage(scene.name).warnings.is_empty(), "{}", scene.name);
        }
    }

    #[test]
    fn wrong_names_are_wrong_command_lines() {
        for name in ["", "Whitted", "two-triangles", "sphere:", "sphere:5", "bunny.of"] {
            let refused = Stage::named(name, brute_force);
            assert!(matches!(refused, Err(Failure::Usage(_))), "{name}");
        }
        let missing = Stage::named("missing.obj", brute_force);
        assert!(matches!(missing, Err(Failure::Work(text)) if text.contains("missing.obj")));
    }

    #[test]
    fn a_change_is_checked_and_called_for_anew() {
        let off = stage("bunny").changed(|scene| scene.lights.clear()).expect("it may be dark");
        assert_eq!(effects(&off), [Effect::PrimaryVisibility, Effect::SmoothNormals]);
        let nowhere = Light::steady(Vec3::NAN, Vec3::ONE);
        let refused = stage("bunny").changed(|scene| scene.lights.push(nowhere));
        assert!(matches!(refused, Err(Failure::Usage(text)) if text.contains("place")));
        let refused = stage("whitted").seen_from(|view| view.target = view.eye);
        assert!(matches!(refused, Err(Failure::Usage(text)) if text.contains("picture")));
    }

    #[test]
    fn a_file_has_an_object_a_material() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/two-materials.obj");
        let stage = stage(path);
        let shininess: Vec<f32> = stage
            .scene
            .objects
            .iter()
            .map(|object: &Object<_>| object.material.shininess)
            .collect();
        assert_eq!(shininess, [0.0, 48.0]);
        assert!(effects(&stage).contains(&Effect::AreaLights), "the sign glows");
    }
}
