//! The program: lit scenes, and pictures of the tree and of what it costs to walk it.

use blinn_phong::picture::{LIGHT_SAMPLES, SHADING_POINTS, TEXTURE_LOOKUPS};
use boxes::slab::BOX_TESTS;
use common::chapter::{Chapter, Defaults, Entry, Failure, OwnCommand, SceneName};
use common::cost::Experiment;
use common::hard::Case;
use common::plan::{Call, Effect, Plan, Skill};
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};
use partitions::accelerator::{Accelerator, CELL_STEPS, NODE_VISITS};
use partitions::heat;
use ray_casting::camera::CAMERA_RAYS;
use ray_casting::picture::Show;
use ray_casting::shape::SHAPE_TESTS;
use shadows::offset::Offset;
use shadows::picture::Picture as LitPicture;
use shadows::scenes::SCENES;
use shadows::visibility::{BLOCKED_RAYS, SHADOW_RAYS};
use triangles::brute::TRIANGLE_TESTS;
use triangles::picture::{Picture, SMOOTH_NORMALS};

use crate::choice::ViewChoice;
use crate::cut::Cut;
use crate::knobs::Knobs;
use crate::stage::{Alone, Stage, Structure};
use crate::{cost, hard, headline};

/// Chapter 10's program.
pub struct Hierarchies;

/// The same as a value, compiled here once for all who run it.
pub static PROGRAM: Entry = Entry::of::<Hierarchies>();

impl Chapter for Hierarchies {
    const ID: &'static str = "10-bvh";
    const ABOUT: &'static str =
        "Chapter 10: boxes around boxes, and rays that pass most of them by";
    const DEFAULTS: Defaults = Defaults { scene: "bunny", width: 640, height: 480, spp: 1 };
    const SCENES: &'static [SceneName] = SCENES;
    const SKILLS: &'static [Skill] = &[
        Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" },
        Skill { effect: Effect::SmoothNormals, unless: "the picture shows no vertex normals" },
        Skill { effect: Effect::LocalShading, unless: "the picture shows no light" },
        Skill { effect: Effect::Textures, unless: "no colour that is lit varies over a surface" },
        Skill { effect: Effect::HardShadows, unless: "the picture shows no shadow" },
    ];
    const EVENTS: &'static [Event] = &[
        CAMERA_RAYS,
        SHADOW_RAYS,
        BLOCKED_RAYS,
        SHAPE_TESTS,
        BOX_TESTS,
        NODE_VISITS,
        CELL_STEPS,
        TRIANGLE_TESTS,
        SHADING_POINTS,
        LIGHT_SAMPLES,
        SMOOTH_NORMALS,
        TEXTURE_LOOKUPS,
    ];
    const COMMANDS: &'static [OwnCommand] = &[headline::COMMAND];

    type Knobs = Knobs;
    type Scene = Stage;

    fn build(name: &str, knobs: &Knobs) -> Result<Stage, Failure> {
        Stage::named(name, knobs)
    }

    fn warnings(stage: &Stage) -> &[String] {
        stage.warnings()
    }

    fn calls(stage: &Stage, knobs: &Knobs) -> Vec<Call> {
        stage.calls(knobs)
    }

    fn draw<T: Tally>(
        stage: &Stage,
        plan: &Plan,
        settings: &Settings,
        knobs: &Knobs,
    ) -> Rendering<T> {
        match stage {
            Stage::Lit(lit) => {
                let camera = lit.camera.with_film(settings.width, settings.height);
                LitPicture { scene: &lit.scene, camera, offset: Offset::Bound }.draw(settings, plan)
            }
            Stage::Alone(alone) => alone.draw(plan, settings, knobs.view),
        }
    }

    fn cost() -> Vec<Experiment<'static>> {
        cost::experiments()
    }

    fn hard() -> Vec<Case> {
        hard::CASES.to_vec()
    }
}

impl Alone {
    /// Which structure it is, is settled here, before the first ray.
    fn draw<T: Tally>(&self, plan: &Plan, settings: &Settings, view: ViewChoice) -> Rendering<T> {
        match &self.structure {
            Structure::Brute(scan) => self.draw_with(scan, plan, settings, view),
            Structure::Grid(grid) => self.draw_with(grid, plan, settings, view),
            Structure::Octree(tree) => self.draw_with(tree, plan, settings, view),
            Structure::Kd(tree) => self.draw_with(tree, plan, settings, view),
            Structure::Bsp(tree) => self.draw_with(tree, plan, settings, view),
            Structure::Bvh(tree) => self.draw_with(tree, plan, settings, view),
            Structure::Both(tree) => self.draw_with(tree, plan, settings, view),
            Structure::Shown(tree) => Cut::new(tree, settings).draw(settings),
        }
    }

    fn draw_with<T: Tally>(
        &self,
        accelerator: &impl Accelerator,
        plan: &Plan,
        settings: &Settings,
        view: ViewChoice,
    ) -> Rendering<T> {
        let camera = self.camera.with_film(settings.width, settings.height);
        if view == ViewChoice::Work {
            return heat::draw(accelerator, &camera, settings);
        }
        let show = if view == ViewChoice::Depth { Show::Depth } else { Show::Normals };
        let picture = Picture { mesh: &self.mesh, camera, show, depths: self.depths };
        picture.draw(settings, plan.simulates(Effect::SmoothNormals), |ray, tally| {
            accelerator.nearest(ray, f32::INFINITY, tally)
        })
    }
}

#[cfg(test)]
mod tests {
    use clap::ValueEnum;
    use common::chapter::{Chapter, Failure};
    use common::plan::{Plan, Simulate};
    use common::render::Settings;
    use common::tally::Counts;
    use triangles::brute::TRIANGLE_TESTS;

    use super::{Hierarchies, Knobs, ViewChoice};
    use crate::choice::{AccelChoice, Traversal};
    use crate::split::Split;

    /// The picture's hash, and the triangles that were asked.
    fn drawn(name: &str, knobs: &Knobs) -> (u64, u64) {
        let stage = Hierarchies::build(name, knobs).expect("it is built in");
        let plan =
            Plan::new(&Hierarchies::calls(&stage, knobs), Hierarchies::SKILLS, Simulate::Needed);
        let settings = Settings { width: 48, height: 36, ..Settings::default() };
        let made = Hierarchies::draw::<Counts>(&stage, &plan, &settings, knobs);
        assert_eq!(made.film.nonfinite, 0);
        (made.film.hash(), made.tally.of(TRIANGLE_TESTS))
    }

    #[test]
    fn every_structure_draws_the_same_bits() {
        for view in [ViewChoice::Lit, ViewChoice::Normals, ViewChoice::Depth] {
            let of = |accel| drawn("sphere:2000", &Knobs { accel, view, ..Knobs::default() });
            let (hash, all) = of(AccelChoice::Brute);
            for &accel in
                AccelChoice::value_variants().iter().filter(|&&it| it != AccelChoice::Brute)
            {
                let (same, asked) = of(accel);
                assert_eq!(same, hash, "{accel:?} {view:?}");
                assert!(10 * asked < all, "{accel:?} {view:?}: {asked} of {all}");
            }
        }
    }

    #[test]
    fn every_tree_and_every_way_through_it_draws_the_same_bits() {
        let view = ViewChoice::Normals;
        let (hash, _) = drawn("bunny", &Knobs { view, ..Knobs::default() });
        for &split in Split::value_variants() {
            for leaf in [1, 3, 64] {
                let knobs =
                    Knobs { view, split: Some(split), leaf: Some(leaf), ..Knobs::default() };
                let [both, ordered] = [Traversal::Both, Traversal::Ordered].map(|traversal| {
                    drawn("bunny", &Knobs { traversal: Some(traversal), ..knobs.clone() })
                });
                assert!(both.0 == hash && ordered.0 == hash, "{split:?} {leaf}");
                assert!(both.1 > ordered.1, "{split:?} {leaf}: erratum 7");
            }
        }
    }

    #[test]
    fn only_meshes_have_a_tree_to_show() {
        for view in [ViewChoice::Cut, ViewChoice::Work] {
            let knobs = Knobs { view, ..Knobs::default() };
            assert!(drawn("bunny", &knobs).0 != 0);
            assert!(matches!(Hierarchies::build("whitted", &knobs), Err(Failure::Usage(_))));
        }
    }
}
