//! What the chapter's program does.

use clap::Args;
use common::chapter::{Chapter, Defaults, Entry, Failure, SceneName};
use common::cost::Experiment;
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};
use ray_casting::camera::{CAMERA_RAYS, Camera};
use ray_casting::knobs::Aim;
use ray_casting::picture::Show;
use triangles::brute::TRIANGLE_TESTS;
use triangles::convert::Normals;
use triangles::mesh::Mesh;
use triangles::picture::{Depths, Picture, SMOOTH_NORMALS};
use triangles::scene::{self, MeshScene};

use crate::accelerator::{
    Accelerator, CELL_STEPS, NODE_VISITS, STRUCTURE_BYTES, STRUCTURE_NODES, TRIANGLES,
    TRIANGLES_STORED,
};
use crate::bsp::BspTree;
use crate::choice::AccelChoice;
use crate::grid::Grid;
use crate::kd::{KdTree, Split};
use crate::octree::Octree;
use crate::scan::Scan;
use crate::{cost, hard, heat};

/// Chapter 9.
pub struct Partitions;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<Partitions>();

/// The chapter's own options.
#[derive(Clone, Debug, Args)]
pub struct Knobs {
    /// How the triangle that a ray hits first is found
    #[arg(long, value_enum, default_value_t)]
    pub accel: AccelChoice,
    /// Cells along the grid's longest side [default: as many as there are triangles suggest]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=512))]
    pub cells: Option<u32>,
    /// Where the k-d tree's planes are put
    #[arg(long, value_enum, default_value_t)]
    pub split: Split,
    /// What the picture shows
    #[arg(long, value_enum, default_value_t)]
    pub view: ViewChoice,
    /// Where the normals come from
    #[arg(long, value_enum, default_value_t)]
    pub normals: Normals,
    /// Where to look from.
    #[command(flatten)]
    pub aim: Aim,
}

/// What the picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum ViewChoice {
    /// Directions of the surface as colours
    Normals,
    /// Distances as greys
    Depth,
    /// Triangle tests, cells and nodes of each ray, from black for none to white for 400
    #[default]
    Work,
}

/// A structure that was built.
enum Structure {
    Brute(Scan),
    Grid(Grid),
    Octree(Octree),
    Kd(KdTree),
    Bsp(BspTree),
}

/// A scene made ready, with a camera that was found to be possible.
pub struct Stage {
    mesh: Mesh,
    structure: Structure,
    camera: Camera,
    depths: Depths,
    calls: Vec<Call>,
    warnings: Vec<String>,
}

impl Chapter for Partitions {
    const ID: &'static str = "09-partitions";
    const ABOUT: &'static str = "Where the work of the bunny is, when each ray asks the triangles in its way and few others";
    const DEFAULTS: Defaults = Defaults { scene: "bunny", width: 640, height: 480, spp: 1 };
    const SCENES: &'static [SceneName] = scene::SCENES;
    const SKILLS: &'static [Skill] = &[
        Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" },
        Skill { effect: Effect::SmoothNormals, unless: "the picture shows no vertex normals" },
    ];
    const EVENTS: &'static [Event] = &[
        TRIANGLES,
        TRIANGLES_STORED,
        STRUCTURE_NODES,
        STRUCTURE_BYTES,
        CAMERA_RAYS,
        CELL_STEPS,
        NODE_VISITS,
        TRIANGLE_TESTS,
        SMOOTH_NORMALS,
    ];

    type Knobs = Knobs;
    type Scene = Stage;

    fn build(name: &str, knobs: &Knobs) -> Result<Stage, Failure> {
        let MeshScene { mesh, mut view, warnings, calls, .. } =
            MeshScene::with_normals(name, knobs.normals)?;
        knobs.aim.apply(&mut view);
        let camera = Camera::new(&view, 1, 1);
        let camera = camera.map_err(|error| Failure::Usage(format!("no picture: {error}")))?;
        let depths = Depths::of(&mesh, view.eye);
        let structure = Structure::over(&mesh, knobs);
        Ok(Stage { mesh, structure, camera, depths, calls, warnings })
    }

    fn warnings(stage: &Stage) -> &[String] {
        &stage.warnings
    }

    fn calls(stage: &Stage, knobs: &Knobs) -> Vec<Call> {
        let mut calls = stage.calls.clone();
        // Only one view shows normals, whatever the mesh has.
        let normals = knobs.view == ViewChoice::Normals;
        calls.retain(|call| call.effect != Effect::SmoothNormals || normals);
        calls
    }

    fn draw<T: Tally>(
        stage: &Stage,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        let smooth = plan.simulates(Effect::SmoothNormals);
        match &stage.structure {
            Structure::Brute(scan) => drawn(stage, scan, smooth, settings, knobs.view),
            Structure::Grid(grid) => drawn(stage, grid, smooth, settings, knobs.view),
            Structure::Octree(tree) => drawn(stage, tree, smooth, settings, knobs.view),
            Structure::Kd(tree) => drawn(stage, tree, smooth, settings, knobs.view),
            Structure::Bsp(tree) => drawn(stage, tree, smooth, settings, knobs.view),
        }
    }

    fn cost() -> Vec<Experiment<'static>> {
        cost::experiments()
    }

    fn hard() -> Vec<Case> {
        hard::CASES.to_vec()
    }
}

impl Structure {
    fn over(mesh: &Mesh, knobs: &Knobs) -> Self {
        let corners = mesh.all_corners();
        match (knobs.accel, knobs.cells) {
            (AccelChoice::Brute, _) => Self::Brute(Scan::build(corners)),
            (AccelChoice::Grid, None) => Self::Grid(Grid::build(corners)),
            (AccelChoice::Grid, Some(cells)) => Self::Grid(Grid::with_cells(&corners, cells)),
            (AccelChoice::Octree, _) => Self::Octree(Octree::build(corners)),
            (AccelChoice::Kd, _) => Self::Kd(KdTree::with_split(&corners, knobs.split)),
            (AccelChoice::Bsp, _) => Self::Bsp(BspTree::build(corners)),
        }
    }
}

/// The picture, with one kind of structure: which one is settled before the first ray.
fn drawn<T: Tally>(
    stage: &Stage,
    accelerator: &impl Accelerator,
    smooth: bool,
    settings: &Settings,
    view: ViewChoice,
) -> Rendering<T> {
    let camera = stage.camera.with_film(settings.width, settings.height);
    let shown = |show| {
        let picture = Picture { mesh: &stage.mesh, camera, show, depths: stage.depths };
        picture.draw(settings, smooth, |ray, tally| accelerator.nearest(ray, f32::INFINITY, tally))
    };
    let mut rendering: Rendering<T> = match view {
        ViewChoice::Normals => shown(Show::Normals),
        ViewChoice::Depth => shown(Show::Depth),
        ViewChoice::Work => heat::draw(accelerator, &camera, settings),
    };
    accelerator.statistics().count(&mut rendering.tally);
    rendering
}

#[cfg(test)]
mod tests {
    use common::chapter::Chapter;
    use common::plan::{Plan, Simulate};
    use common::render::Settings;
    use common::tally::Counts;
    use ray_casting::knobs::Aim;
    use triangles::brute::TRIANGLE_TESTS;
    use triangles::convert::Normals;

    use super::{Knobs, Partitions, Split, ViewChoice};
    use crate::choice::AccelChoice;

    /// The hash of a small picture, and its triangle tests.
    fn drawn(accel: AccelChoice, cells: Option<u32>, split: Split, view: ViewChoice) -> (u64, u64) {
        let aim = Aim::default();
        let knobs = Knobs { accel, cells, split, view, normals: Normals::Given, aim };
        let stage = Partitions::build("bunny", &knobs).expect("it is built in");
        let calls = Partitions::calls(&stage, &knobs);
        let plan = Plan::new(&calls, Partitions::SKILLS, Simulate::Needed);
        let settings = Settings { width: 48, height: 36, ..Settings::default() };
        let rendering = Partitions::draw::<Counts>(&stage, &plan, &settings, &knobs);
        assert_eq!(rendering.film.nonfinite, 0);
        (rendering.film.hash(), rendering.tally.of(TRIANGLE_TESTS))
    }

    #[test]
    fn every_structure_draws_the_same_bits_with_less_work() {
        for view in [ViewChoice::Normals, ViewChoice::Depth] {
            let (expected, all) = drawn(AccelChoice::Brute, None, Split::Sah, view);
            for (accel, cells, split) in [
                (AccelChoice::Grid, None, Split::Sah),
                (AccelChoice::Grid, Some(1), Split::Sah),
                (AccelChoice::Grid, Some(90), Split::Sah),
                (AccelChoice::Octree, None, Split::Sah),
                (AccelChoice::Kd, None, Split::Median),
                (AccelChoice::Kd, None, Split::Sah),
                (AccelChoice::Bsp, None, Split::Sah),
            ] {
                let (hash, tests) = drawn(accel, cells, split, view);
                assert_eq!(hash, expected, "{accel:?} {cells:?} {split:?}");
                assert!(tests < all, "{accel:?}: {tests}");
                assert!(cells == Some(1) || tests < all / 50, "{accel:?}: {tests}");
            }
        }
    }
}
