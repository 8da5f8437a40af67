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
