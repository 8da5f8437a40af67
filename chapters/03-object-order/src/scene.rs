//! The chapter's scenes: those of chapter 2, and one that surrounds the eye.

use std::path::Path;

use common::chapter::{Failure, SceneName, unknown_scene};
use common::plan::{Call, Effect};
use glam::Vec3;
use ray_casting::camera::{Camera, View};
use ray_casting::knobs::Aim;
use triangles::convert::Normals;
use triangles::mesh::Mesh;
use triangles::scene::MeshScene;

use crate::clip::Volume;
use crate::project::{FilmPoint, Projection};
use crate::setup::project;

/// The scenes this chapter has.
pub const SCENES: &[SceneName] = &[
    SceneName { name: "bunny", about: "the Stanford bunny, 3,674 triangles" },
    SceneName { name: "two-triangles", about: "two triangles that share an edge" },
    SceneName { name: "sphere:N", about: "a bumpy closed sphere with N triangles" },
    SceneName { name: "inside", about: "a bumpy sphere seen from within, half of it behind you" },
    SceneName { name: "FILE.obj", about: "a mesh of your own" },
];

/// A mesh with a camera, and what is to be known before it is drawn.
pub struct Stage {
    /// The mesh.
    pub mesh: Mesh,
    /// The corners of all triangles, for the rays.
    pub corners: Vec<[Vec3; 3]>,
    /// The camera; its film is still to be chosen.
    pub camera: Camera,
    /// The depths of the nearest and the farthest vertex before the eye.
    pub depths: [f32; 2],
    /// What the mesh and its materials call for.
    pub calls: Vec<Call>,
    /// Why triangles must be clipped, if they must.
    pub clipping: Option<Call>,
    /// What the reader should be told of the file.
    pub warnings: Vec<String>,
}

impl Stage {
    /// The scene called `name`: "inside", or one of chapter 2's; seen from where `aim` says.
    ///
    /// # Errors
    /// A name that is none of these, or a view that can't be (exit code 2), or a file that is no
    /// mesh (exit code 1).
    pub fn named(name: &str, aim: &Aim) -> Result<Self, Failure> {
        if name == "inside" {
            // Without vertex normals, so that each triangle shows.
            let scene = MeshScene::with_normals("sphere:2000", Normals::Flat)?;
            return Self::of(MeshScene { view: INSIDE_VIEW, ..scene }, aim);
        }
        if !is_of_chapter_2(name) {
            return Err(unknown_scene(name, SCENES));
        }
        Self::of(MeshScene::named(name)?, aim)
    }

    fn of(scene: MeshScene, aim: &Aim) -> Result<Self, Failure> {
        let MeshScene { mesh, mut view, warnings, calls, .. } = scene;
        aim.apply(&mut view);
        // Half of a film two pixels high is one pixel: see `comfortable`.
        let camera = Camera::new(&view, 2, 2);
        let camera = camera.map_err(|error| Failure::Usage(format!("no picture: {error}")))?;
        let (vertices, deepest) = project(&Projection::new(&camera), &mesh.positions);
        let before = vertices.iter().map(|vertex| vertex.w).filter(|&depth| depth > 0.0);
        let nearest = before.fold(deepest, f64::min);
        let corners = mesh.all_corners();
        let depths = [nearest as f32, deepest as f32];
        let clipping = clipping(&vertices, deepest);
        Ok(Self { mesh, corners, camera, depths, calls, clipping, warnings })
    }
}

/// Whether chapter 2 knows the scene, or says best what is wrong with it.
fn is_of_chapter_2(name: &str) -> bool {
    let path = Path::new(name);
    let is_mesh = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("obj"));
    ["bunny", "two-triangles"].contains(&name)
        || name.starts_with("sphere:")
        || is_mesh
        || path.exists()
}

/// The eye in the middle of things.
const INSIDE_VIEW: View = View {
    eye: Vec3::new(0.15, -0.1, 0.25),
    target: Vec3::new(-0.6, 0.3, -1.0),
    up: Vec3::Y,
    vertical_fov: 75.0,
};

// ANCHOR: clipping
/// The call for near clipping, if there is a vertex that can't be divided as it is.
fn clipping(vertices: &[FilmPoint], deepest: f64) -> Option<Call> {
    let volume = Volume::for_depth(deepest)?;
    let first = |odd: &dyn Fn(&FilmPoint) -> bool| vertices.iter().position(odd);
    let because = match first(&|vertex| vertex.w < volume.near) {
        Some(vertex) => format!("vertex {vertex} lies behind the near plane"),
        None => format!("vertex {} lies far aside", first(&|&it| !volume.comfortable(it))?),
    };
    Some(Call { effect: Effect::NearClipping, because })
}
// ANCHOR_END: clipping

#[cfg(test)]
mod tests {
    use common::plan::Effect;
    use ray_casting::knobs::Aim;

    use super::Stage;

    #[test]
    fn only_a_mesh_that_surrounds_the_eye_calls_for_clipping() {
        let calls = |name: &str| Stage::named(name, &Aim::default()).map(|stage| stage.clipping);
        assert!(matches!(calls("bunny"), Ok(None)));
        assert!(matches!(calls("sphere:1000"), Ok(None)));
        let inside = calls("inside").ok().flatten().expect("it does");
        assert_eq!(inside.effect, Effect::NearClipping);
        assert!(inside.because.ends_with("behind the near plane"), "{}", inside.because);
    }

    #[test]
    fn an_unknown_scene_is_refused() {
        assert!(Stage::named("teapot", &Aim::default()).is_err());
    }
}
