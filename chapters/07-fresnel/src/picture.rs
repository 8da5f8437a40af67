//! From a plan to a picture: the integrator with the effects that are simulated, and no others.

use common::plan::{Effect, Plan};
use common::render::{Rendering, Settings, render_counted};
use common::tally::Tally;
use ray_casting::camera::CAMERA_RAYS;
use whitted::limits::Limits;

use crate::integrator::Integrator;
use crate::path::{Branching, Formula};
use crate::scenes::Stage;
use crate::shade::Lit;

/// A scene, and how it is to be drawn.
#[derive(Clone, Copy)]
pub struct Picture<'a> {
    /// What.
    pub stage: &'a Stage,
    /// How much is reflected.
    pub formula: Formula,
    /// What becomes of two rays.
    pub branching: Branching,
    /// Where following rays ends.
    pub limits: Limits,
}

impl Picture<'_> {
    // ANCHOR: specialise
    /// The picture with what `plan` simulates. Each effect that is left out is left out of the
    /// code: every combination is a function of its own.
    pub fn draw<T: Tally>(&self, plan: &Plan, settings: &Settings) -> Rendering<T> {
        let details = plan.simulates(Effect::SmoothNormals) || plan.simulates(Effect::Textures);
        match (plan.simulates(Effect::PrimaryVisibility), details) {
            (false, _) => self.draw_nothing(settings),
            (true, false) => self.draw_lit::<T, false>(plan, settings),
            (true, true) => self.draw_lit::<T, true>(plan, settings),
        }
    }

    fn draw_lit<T: Tally, const DETAILS: bool>(
        &self,
        plan: &Plan,
        settings: &Settings,
    ) -> Rendering<T> {
        match (plan.simulates(Effect::LocalShading), plan.simulates(Effect::HardShadows)) {
            (false, _) => self.draw_glass::<T, false, DETAILS, false>(plan, settings),
            (true, false) => self.draw_glass::<T, true, DETAILS, false>(plan, settings),
            (true, true) => self.draw_glass::<T, true, DETAILS, true>(plan, settings),
        }
    }

    fn draw_glass<T: Tally, const SHADING: bool, const DETAILS: bool, const SHADOWS: bool>(
        &self,
        plan: &Plan,
        settings: &Settings,
    ) -> Rendering<T> {
        let lit = Lit::<SHADING, DETAILS, SHADOWS>;
        if plan.simulates(Effect::Refraction) {
            // Glass reflects, too.
            self.follow(&self.integrator::<_, true, true>(lit), settings)
        } else if plan.simulates(Effect::MirrorReflection) {
            self.follow(&self.integrator::<_, true, false>(lit), settings)
        } else {
            self.follow(&self.integrator::<_, false, false>(lit), settings)
        }
    }
    // ANCHOR_END: specialise

    /// The integrator of the scene.
    pub fn integrator<L, const MIRRORS: bool, const GLASS: bool>(
        &self,
        lit: L,
    ) -> Integrator<'_, L, MIRRORS, GLASS> {
        let Self { stage, formula, branching, .. } = *self;
        let Stage { scene, around_eye, unseen, .. } = stage;
        Integrator { scene, formula, branching, around_eye: *around_eye, unseen: *unseen, lit }
    }

    /// The picture that the integrator makes of it.
    fn follow<
        T: Tally,
        const SHADING: bool,
        const DETAILS: bool,
        const SHADOWS: bool,
        const MIRRORS: bool,
        const GLASS: bool,
    >(
        &self,
        integrator: &Integrator<'_, Lit<SHADING, DETAILS, SHADOWS>, MIRRORS, GLASS>,
        settings: &Settings,
    ) -> Rendering<T> {
        let camera = self.stage.camera.with_film(settings.width, settings.height);
        render_counted(settings, |pixel, sampler, tally: &mut T| {
            let ray = camera.ray(pixel.position(sampler));
            tally.count(CAMERA_RAYS, 1);
            integrator.radiance(&self.limits, ray, sampler, tally)
        })
    }

    /// The picture of nothing, for which no ray is needed.
    fn draw_nothing<T: Tally>(&self, settings: &Settings) -> Rendering<T> {
        render_counted(settings, |_pixel, _sampler, _tally| self.stage.scene.background)
    }
}
