//! What each pixel shows: the radiance of its rays, and of all that are followed from them.

use blinn_phong::scene::Scene;
use common::film::Color;
use common::plan::{Effect, Plan};
use common::render::{Rendering, Settings, render_counted};
use common::tally::Tally;
use ray_casting::camera::{CAMERA_RAYS, Camera};
use ray_casting::ray::Ray;

use crate::limits::Limits;
use crate::material::Mirrored;
use crate::scatter::Scatter;
use crate::world::World;

/// How rays are followed from mirror to mirror.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "native", derive(clap::ValueEnum))]
pub enum Tracing {
    /// A loop with a list of what is left to do
    #[default]
    Loop,
    /// A function that calls itself
    Recursion,
}

/// A scene, the camera it is seen with, and how far rays are followed.
#[derive(Clone, Copy)]
pub struct Picture<'a> {
    /// What there is to see.
    pub scene: &'a Scene<Mirrored>,
    /// Where from.
    pub camera: Camera,
    /// Where following ends.
    pub limits: Limits,
    /// How rays are followed.
    pub tracing: Tracing,
}

impl Picture<'_> {
    // ANCHOR: draw
    /// The picture with the effects of the plan, chosen one by one before the first ray.
    pub fn draw<T: Tally>(&self, settings: &Settings, plan: &Plan) -> Rendering<T> {
        let details = plan.simulates(Effect::SmoothNormals) || plan.simulates(Effect::Textures);
        match (plan.simulates(Effect::PrimaryVisibility), details) {
            (false, _) => render_counted(settings, |_, _, _| self.scene.background),
            (true, false) => self.draw_lit::<T, false>(settings, plan),
            (true, true) => self.draw_lit::<T, true>(settings, plan),
        }
    }

    fn draw_lit<T: Tally, const DETAILS: bool>(
        &self,
        settings: &Settings,
        plan: &Plan,
    ) -> Rendering<T> {
        match (plan.simulates(Effect::LocalShading), plan.simulates(Effect::HardShadows)) {
            (false, _) => self.draw_mirrors::<T, false, DETAILS, false>(settings, plan),
            (true, false) => self.draw_mirrors::<T, true, DETAILS, false>(settings, plan),
            (true, true) => self.draw_mirrors::<T, true, DETAILS, true>(settings, plan),
        }
    }

    fn draw_mirrors<T: Tally, const SHADING: bool, const DETAILS: bool, const SHADOWS: bool>(
        &self,
        settings: &Settings,
        plan: &Plan,
    ) -> Rendering<T> {
        let Self { scene, limits, .. } = *self;
        if !plan.simulates(Effect::MirrorReflection) {
            let world = World::<SHADING, DETAILS, SHADOWS, false> { scene };
            return self.draw_with(settings, |ray, tally| world.scatter(&ray, tally).light);
        }
        let world = World::<SHADING, DETAILS, SHADOWS, true> { scene };
        match self.tracing {
            Tracing::Loop => {
                self.draw_with(settings, |ray, tally| limits.trace(&world, ray, tally))
            }
            Tracing::Recursion => {
                self.draw_with(settings, |ray, tally| limits.trace_by_recursion(&world, ray, tally))
            }
        }
    }
    // ANCHOR_END: draw

    /// One ray for each sample of each pixel; `radiance` says what comes back along it.
    fn draw_with<T: Tally>(
        &self,
        settings: &Settings,
        radiance: impl Fn(Ray, &mut T) -> Color + Sync,
    ) -> Rendering<T> {
        render_counted(settings, |pixel, sampler, tally: &mut T| {
            tally.count(CAMERA_RAYS, 1);
            radiance(self.camera.ray(pixel.position(sampler)), tally)
        })
    }
}

#[cfg(all(test, feature = "native"))]
mod tests {
    use blinn_phong::scenes::brute_force;
    use common::plan::{Plan, Simulate};
    use common::render::{Rendering, Settings};
    use common::tally::{Counts, Event};
    use glam::DVec3;
    use shadows::visibility::SHADOW_RAYS;

    use super::{Picture, Tracing};
    use crate::command::SKILLS;
    use crate::facing::series;
    use crate::limits::{DEEPEST, Limits, STOPPED_BY_CUTOFF, STOPPED_BY_DEPTH};
    use crate::mirror::MIRROR_RAYS;
    use crate::scenes::Stage;
    use crate::scenes::shows::FACING;

    const LIMITS: Limits = Limits { depth: 5, cutoff: 0.001 };

    fn drawn(
        name: &str,
        simulate: Simulate,
        limits: Limits,
        tracing: Tracing,
    ) -> Rendering<Counts> {
        let Stage { scene, camera, calls, .. } =
            Stage::named(name, brute_force, |_| ()).expect("it is built in");
        let settings = Settings { width: 40, height: 30, spp: 2, ..Settings::default() };
        let picture = Picture { scene: &scene, camera: camera.with_film(40, 30), limits, tracing };
        picture.draw(&settings, &Plan::new(&calls, SKILLS, simulate))
    }

    const MIRRORED: [&str; 6] =
        ["whitted", "dark", "facing-mirrors", "hall", "kaleidoscope", "chrome"];
    const DULL: [&str; 4] = ["low-lamp", "two-lamps", "sphere:60", "empty"];

    #[test]
    fn what_is_not_called_for_changes_no_bit_and_is_not_done() {
        for name in MIRRORED.into_iter().chain(DULL) {
            let [needed, all] = [Simulate::Needed, Simulate::All]
                .map(|simulate| drawn(name, simulate, LIMITS, Tracing::Loop));
            assert_eq!(needed.film.hash(), all.film.hash(), "{name}");
            assert_eq!((needed.film.nonfinite, all.film.nonfinite), (0, 0), "{name}");
            let counted = |event: Event| needed.tally.of(event);
            let mirror = [MIRROR_RAYS, DEEPEST, STOPPED_BY_DEPTH, STOPPED_BY_CUTOFF].map(counted);
            assert_eq!(mirror != [0; 4], MIRRORED.contains(&name), "{name} {mirror:?}");
            let lit = !["dark", "facing-mirrors", "empty"].contains(&name);
            assert_eq!(counted(SHADOW_RAYS) > 0, lit, "{name}");
        }
    }

    #[test]
    fn recursion_and_loop_draw_the_same_bits() {
        for name in MIRRORED {
            for limits in
                [LIMITS, Limits { depth: 0, cutoff: 0.0 }, Limits { depth: 9, cutoff: 0.2 }]
            {
                let [looped, recursed] = [Tracing::Loop, Tracing::Recursion]
                    .map(|tracing| drawn(name, Simulate::Needed, limits, tracing));
                assert_eq!(looped.film.hash(), recursed.film.hash(), "{name} {limits:?}");
                assert_eq!(looped.tally, recursed.tally, "{name} {limits:?}");
            }
        }
    }

    /// The closed form: every pixel is the series to the depth, whatever the angle.
    #[test]
    fn facing_mirrors_are_a_geometric_series_in_every_pixel() {
        let [light, mirror] = FACING.map(|color| color.as_dvec3());
        for depth in [0, 1, 2, 7, 300] {
            let limits = Limits { depth, cutoff: 0.0 };
            let made = drawn("facing-mirrors", Simulate::Needed, limits, Tracing::Loop);
            let sums = mirror.to_array().map(|mirror| series(mirror, depth));
            let exact = light * DVec3::from_array(sums);
            for pixel in &made.film.pixels {
                let error = (pixel.as_dvec3() - exact).abs() / exact;
                assert!(error.max_element() < 2e-7, "{depth}: {pixel} and {exact}");
            }
            assert_eq!(made.tally.of(DEEPEST), u64::from(depth));
            assert_eq!(made.tally.of(MIRROR_RAYS), 2400 * u64::from(depth));
            assert_eq!(made.tally.of(STOPPED_BY_DEPTH), 2400);
        }
    }

    #[test]
    fn the_deepest_recursion_fits_the_stack_of_a_thread() {
        let limits = Limits { depth: crate::recursion::MOST_RECURSION, cutoff: 0.0 };
        let made = drawn("facing-mirrors", Simulate::All, limits, Tracing::Recursion);
        assert_eq!(made.tally.of(DEEPEST), u64::from(limits.depth));
    }

    #[test]
    fn a_cutoff_alone_ends_every_ray() {
        let limits = Limits { depth: u32::MAX, cutoff: 0.01 };
        let made = drawn("facing-mirrors", Simulate::Needed, limits, Tracing::Loop);
        // 0.95^89 is above 0.01, and 0.95^90 below.
        assert_eq!(made.tally.of(DEEPEST), 89);
        assert_eq!(made.tally.of(STOPPED_BY_CUTOFF), 2400);
    }
}
