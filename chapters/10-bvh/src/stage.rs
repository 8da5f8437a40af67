//! A scene made ready to be drawn: lit, or a mesh alone with what finds its triangles.

use blinn_phong::scenes::Stage as Lit;
use common::chapter::Failure;
use common::plan::{Call, Effect};
use ray_casting::camera::Camera;
use shadows::calls;
use shadows::scenes::named;
use triangles::mesh::Mesh;
use triangles::picture::Depths;
use triangles::scene::MeshScene;

use partitions::accelerator::Accelerator;
use partitions::bsp::BspTree;
use partitions::grid::Grid;
use partitions::kd::KdTree;
use partitions::octree::Octree;
use partitions::scan::Scan;

use crate::choice::{AccelChoice, Traversal, ViewChoice};
use crate::knobs::Knobs;
use crate::packed::PackedBvh;
use crate::plain::{BothChildren, PlainBvh};

/// A scene made ready.
pub enum Stage {
    /// Objects under lamps.
    Lit(Box<Lit>),
    /// A mesh.
    Alone(Box<Alone>),
}

/// A mesh, and what finds its triangles.
pub struct Alone {
    /// The mesh.
    pub mesh: Mesh,
    /// What finds its triangles.
    pub structure: Structure,
    /// Where it is seen from.
    pub camera: Camera,
    /// How far away it is.
    pub depths: Depths,
    calls: Vec<Call>,
    warnings: Vec<String>,
}

/// A structure that was built.
pub enum Structure {
    /// The linear scan.
    Brute(Scan),
    /// Equal boxes.
    Grid(Grid),
    /// Boxes cut in eight.
    Octree(Octree),
    /// Boxes cut in two.
    Kd(KdTree),
    /// Space cut in two.
    Bsp(BspTree),
    /// This chapter's tree.
    Bvh(PackedBvh),
    /// The same, walked in the report's way.
    Both(BothChildren),
    /// The tree that is to be shown itself.
    Shown(PlainBvh),
}

impl Stage {
    /// The scene called `name` as the options want it.
    ///
    /// # Errors
    /// Options that don't go together, an unknown name, or a file that is no mesh.
    pub fn named(name: &str, knobs: &Knobs) -> Result<Self, Failure> {
        knobs.check()?;
        match knobs.view {
            ViewChoice::Lit => {
                let stage = named(name, knobs.accel.shape())?;
                Ok(Self::Lit(Box::new(stage.seen_from(|view| knobs.aim.apply(view))?)))
            }
            _ => Ok(Self::Alone(Box::new(Alone::named(name, knobs)?))),
        }
    }

    /// The effects its data call for.
    pub fn calls(&self, knobs: &Knobs) -> Vec<Call> {
        match self {
            Self::Lit(stage) => calls::of_scene(&stage.scene, &stage.calls),
            Self::Alone(alone) => {
                let mut calls = alone.calls.clone();
                // Only one view shows normals, whatever the mesh has.
                let normals = knobs.view == ViewChoice::Normals;
                calls.retain(|call| call.effect != Effect::SmoothNormals || normals);
                calls
            }
        }
    }

    /// What the user should be told of the file.
    pub fn warnings(&self) -> &[String] {
        match self {
            Self::Lit(stage) => &stage.warnings,
            Self::Alone(alone) => &alone.warnings,
        }
    }
}

impl Alone {
    fn named(name: &str, knobs: &Knobs) -> Result<Self, Failure> {
        let scene = MeshScene::with_normals(name, knobs.normals.unwrap_or_default())?;
        let MeshScene { mesh, mut view, warnings, calls, .. } = scene;
        knobs.aim.apply(&mut view);
        let camera = Camera::new(&view, 1, 1);
        let camera = camera.map_err(|error| Failure::Usage(format!("no picture: {error}")))?;
        let depths = Depths::of(&mesh, view.eye);
        let structure = Structure::over(&mesh, knobs);
        Ok(Self { mesh, structure, camera, depths, calls, warnings })
    }
}

impl Structure {
    fn over(mesh: &Mesh, knobs: &Knobs) -> Self {
        let (corners, recipe) = (mesh.all_corners(), knobs.recipe());
        match knobs.accel {
            AccelChoice::Brute => Self::Brute(Scan::build(corners)),
            AccelChoice::Grid => Self::Grid(Grid::build(corners)),
            AccelChoice::Octree => Self::Octree(Octree::build(corners)),
            AccelChoice::Kd => Self::Kd(KdTree::build(corners)),
            AccelChoice::Bsp => Self::Bsp(BspTree::build(corners)),
            AccelChoice::Bvh if knobs.view == ViewChoice::Cut => {
                Self::Shown(PlainBvh::new(&corners, &recipe))
            }
            AccelChoice::Bvh => match knobs.traversal.unwrap_or_default() {
                Traversal::Both => Self::Both(BothChildren(PlainBvh::new(&corners, &recipe))),
                Traversal::Ordered => Self::Bvh(PackedBvh::new(&corners, &recipe)),
            },
        }
    }
}
