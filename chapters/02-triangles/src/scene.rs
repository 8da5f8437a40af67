//! The chapter's scenes: the bunny, spheres of any size, and the reader's own meshes.

use std::path::Path;

use common::chapter::{Failure, SceneName, unknown_scene};
use common::obj::{self, Material};
use common::plan::Call;
use glam::Vec3;
use ray_casting::camera::View;

use crate::bumpy;
use crate::bunny::bunny;
use crate::calls;
use crate::convert::{Normals, mesh_of};
use crate::mesh::Mesh;

/// The scenes this chapter has.
pub const SCENES: &[SceneName] = &[
    SceneName { name: "bunny", about: "the Stanford bunny, 3,674 triangles" },
    SceneName { name: "two-triangles", about: "two triangles that share an edge" },
    SceneName { name: "sphere:N", about: "a bumpy closed sphere with N triangles" },
    SceneName { name: "FILE.obj", about: "a mesh of your own" },
];

/// A mesh, and where it is seen from.
#[derive(Clone, Debug)]
pub struct MeshScene {
    /// The mesh.
    pub mesh: Mesh,
    /// The camera's place and direction.
    pub view: View,
    /// What the user should be told of the file.
    pub warnings: Vec<String>,
    /// The effects its data call for.
    pub calls: Vec<Call>,
    /// The materials of a file.
    pub materials: Vec<Material>,
    /// Which of them each triangle is of; empty for a mesh that is built in.
    pub material_of: Vec<Option<u32>>,
}

impl MeshScene {
    /// The scene called `name`: "bunny", "two-triangles", "sphere:N", or an OBJ file.
    ///
    /// # Errors
    /// A name that is none of these (exit code 2), or a file that is no mesh (exit code 1).
    pub fn named(name: &str) -> Result<Self, Failure> {
        Self::with_normals(name, Normals::Given)
    }

    /// The same with normals of the reader's choice.
    ///
    /// # Errors
    /// As for [`MeshScene::named`].
    pub fn with_normals(name: &str, normals: Normals) -> Result<Self, Failure> {
        if name == "bunny" {
            let mesh = bunny(normals).map_err(failure)?;
            return Ok(Self::built_in(mesh, BUNNY_VIEW, normals));
        }
        if name == "two-triangles" {
            return Ok(Self::built_in(two_triangles(), TWO_TRIANGLES_VIEW, normals));
        }
        if let Some(count) = name.strip_prefix("sphere:") {
            let size = sphere_size(count)?;
            let scene = Self::built_in(bumpy::sphere(size), SPHERE_VIEW, normals);
            return Ok(Self { warnings: odd(size), ..scene });
        }
        if is_file(name) {
            return from_file(Path::new(name), normals);
        }
        Err(unknown_scene(name, SCENES))
    }

    fn built_in(mut mesh: Mesh, view: View, normals: Normals) -> Self {
        if normals == Normals::Flat {
            mesh.normals.clear();
        }
        let calls = calls::of_mesh(&mesh);
        Self {
            mesh,
            view,
            warnings: Vec::new(),
            calls,
            materials: Vec::new(),
            material_of: Vec::new(),
        }
    }
}

/// Whether a scene's name is that of a file: one that ends in `.obj`, or is there.
pub fn is_file(name: &str) -> bool {
    let path = Path::new(name);
    path.extension().is_some_and(|it| it.eq_ignore_ascii_case("obj")) || path.exists()
}

fn from_file(path: &Path, normals: Normals) -> Result<MeshScene, Failure> {
    let mut model = obj::load(path).map_err(failure)?;
    let warnings = std::mem::take(&mut model.warnings);
    let mesh = mesh_of(&model, normals);
    let view = framed(&mesh).ok_or_else(|| too_large(path))?;
    let calls = calls::of_model(&mesh, &model);
    let material_of = model.triangles.iter().map(|triangle| triangle.material).collect();
    Ok(MeshScene { mesh, view, warnings, calls, materials: model.materials, material_of })
}

fn failure(error: obj::ObjError) -> Failure {
    Failure::Work(error.to_string())
}

fn too_large(path: &Path) -> Failure {
    let path = path.display();
    Failure::Work(format!("{path}: the mesh is too large to step back from; make it smaller"))
}

/// What to say when a sphere gets one triangle more than was asked for.
fn odd(size: u32) -> Vec<String> {
    let text = || {
        let more = size + 1;
        format!("sphere:{size} has {more} triangles: every closed mesh has an even number of them")
    };
    if size.is_multiple_of(2) { Vec::new() } else { vec![text()] }
}

/// The number of triangles in "sphere:N".
fn sphere_size(text: &str) -> Result<u32, Failure> {
    let (fewest, most) = (bumpy::FEWEST, bumpy::MOST);
    let size = text.parse().ok().filter(|size| (fewest..=most).contains(size));
    size.ok_or_else(|| {
        Failure::Usage(format!(
            "'sphere:{text}' needs a whole number of triangles from {fewest} to {most}, \
             such as sphere:1000"
        ))
    })
}

/// Where the report's §5.2 sees the bunny from.
pub const BUNNY_VIEW: View = View {
    eye: Vec3::new(-1.0, 5.0, 10.0),
    target: Vec3::new(-1.0, 5.0, 0.0),
    up: Vec3::Y,
    vertical_fov: 90.0,
};

const SPHERE_VIEW: View =
    View { eye: Vec3::new(0.6, 1.2, 3.2), target: Vec3::ZERO, up: Vec3::Y, vertical_fov: 42.0 };

const TWO_TRIANGLES_VIEW: View = View {
    eye: Vec3::new(0.0, 0.5, 4.0),
    target: Vec3::new(0.0, 0.0, 0.0),
    up: Vec3::Y,
    vertical_fov: 40.0,
};

/// Two triangles that share an edge, like an open book.
fn two_triangles() -> Mesh {
    let positions = vec![
        Vec3::new(-0.2, -1.0, 0.0),
        Vec3::new(0.3, 0.9, 0.2),
        Vec3::new(-1.5, 0.1, 0.6),
        Vec3::new(1.4, -0.2, 0.9),
    ];
    Mesh { positions, triangles: vec![[0, 1, 2], [1, 0, 3]], ..Mesh::default() }
}

/// A view of the whole mesh from the front right, a little above. None for one so large that the
/// camera's place would overflow.
fn framed(mesh: &Mesh) -> Option<View> {
    let extent = mesh.extent()?;
    let middle = 0.5 * extent.low + 0.5 * extent.high;
    let half = (0.5 * extent.high - 0.5 * extent.low).as_dvec3().length() as f32;
    // A sphere of this radius just fits between the sides of 1 / sin(20°) = 2.92 times as far.
    let eye = middle + 2.95 * half * Vec3::new(0.48, 0.36, 0.8);
    let view = View { eye, target: middle, up: Vec3::Y, vertical_fov: 40.0 };
    (eye.is_finite() && eye != middle).then_some(view)
}

#[cfg(test)]
mod tests {
    use common::chapter::Failure;
    use common::plan::Effect;

    use super::MeshScene;
    use crate::convert::Normals;

    #[test]
    fn the_built_in_scenes() {
        let bunny = MeshScene::named("bunny").expect("it is built in");
        assert_eq!(bunny.mesh.triangles.len(), 3674);
        let effects = |scene: &MeshScene| -> Vec<Effect> {
            scene.calls.iter().map(|call| call.effect).collect()
        };
        assert_eq!(effects(&bunny), [Effect::PrimaryVisibility, Effect::SmoothNormals]);
        let flat = MeshScene::with_normals("bunny", Normals::Flat).expect("it is built in");
        assert_eq!(effects(&flat), [Effect::PrimaryVisibility]);
        let sphere = MeshScene::named("sphere:1000").expect("it is built in");
        assert_eq!(sphere.mesh.triangles.len(), 1000);
        assert!(sphere.warnings.is_empty());
        let odd = MeshScene::named("sphere:7").expect("it is built in");
        assert!(odd.warnings[0].contains("has 8 triangles"), "{:?}", odd.warnings);
        assert!(MeshScene::named("two-triangles").is_ok());
    }

    #[test]
    fn wrong_names_are_wrong_command_lines_and_wrong_files_are_failed_work() {
        for name in [
            "",
            "nothing",
            "sphere:",
            "sphere:0",
            "sphere:-3",
            "sphere:abc",
            "sphere:5",
            "sphere:10000001",
            "sphere:1e400",
            "sphere:99999999999999999999",
        ] {
            assert!(matches!(MeshScene::named(name), Err(Failure::Usage(_))), "{name}");
        }
        let failed = MeshScene::named("missing.obj");
        assert!(matches!(failed, Err(Failure::Work(text)) if text.contains("missing.obj")));
    }

    #[test]
    fn a_file_is_framed_and_its_materials_call_for_effects() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/two-materials.obj");
        let scene = MeshScene::named(path).expect("the file is part of the project");
        let called = |effect| scene.calls.iter().any(|call| call.effect == effect);
        assert!(called(Effect::LocalShading) && called(Effect::AreaLights));
        assert!(!called(Effect::Refraction) && !called(Effect::MirrorReflection));
        assert!(scene.view.eye.z > 3.0 && scene.warnings.is_empty());
        assert_eq!(scene.material_of.len(), scene.mesh.triangles.len());
        let used = scene
            .material_of
            .iter()
            .flatten()
            .map(|&it| scene.materials[it as usize].name.as_str());
        assert!(["plaster", "sign"].iter().all(|name| used.clone().any(|it| it == *name)));
    }
}
