//! From a plan to a picture: a path tracer with the effects that are simulated, and no others.

use common::film::Color;
use common::plan::{Effect, Plan};
use common::render::{Pixel, Rendering, Settings, render_counted};
use common::sampler::{PIXEL_OFFSET, Sampler};
use common::tally::Tally;
use glam::Vec2;
use ray_casting::camera::{CAMERA_RAYS, Camera};

use crate::bsdf::Bsdf;
use crate::random::Random;
use crate::strategy::{Ending, Lighting};
use crate::tracer::PathTracer;
use crate::world::World;

// ANCHOR: shot
/// How a scene is to be drawn.
#[derive(Clone, Copy, Debug)]
pub struct Shot<'a, L, E> {
    /// From where.
    pub camera: &'a Camera,
    /// How light is looked for.
    pub lighting: L,
    /// When a path ends.
    pub ending: E,
    /// The most surfaces a path may leave.
    pub depth: u32,
}

impl<L: Lighting + Copy, E: Ending + Copy> Shot<'_, L, E> {
    /// The picture with what `plan` simulates. Each effect that is left out is left out of the code.
    pub fn draw<B: Bsdf, T: Tally>(
        &self,
        world: &World<B>,
        plan: &Plan,
        settings: &Settings,
    ) -> Rendering<T> {
        if !plan.simulates(Effect::PrimaryVisibility) {
            return render_counted(settings, |_pixel, _sampler, _tally| world.sky);
        }
        let depth = if plan.simulates(Effect::IndirectLight) { self.depth } else { 0 };
        let shot = Self { depth, ..*self };
        match (plan.simulates(Effect::AreaLights), plan.simulates(Effect::EnvironmentLight)) {
            (false, false) => render_counted(settings, |_pixel, _sampler, _tally| Color::ZERO),
            (true, false) => shot.film::<B, T, true, false>(world, settings),
            (false, true) => shot.film::<B, T, false, true>(world, settings),
            (true, true) => shot.film::<B, T, true, true>(world, settings),
        }
    }
    // ANCHOR_END: shot

    /// The picture that one of these path tracers makes.
    fn film<B: Bsdf, T: Tally, const EMITTERS: bool, const SKY: bool>(
        &self,
        world: &World<B>,
        settings: &Settings,
    ) -> Rendering<T> {
        let Self { lighting, ending, depth, .. } = *self;
        let tracer = PathTracer::<B, L, E, EMITTERS, SKY> { world, lighting, ending, depth };
        let camera = self.camera.with_film(settings.width, settings.height);
        render_counted(settings, |pixel, sampler, tally: &mut T| {
            tally.count(CAMERA_RAYS, 1);
            tracer.radiance(camera.ray(position(pixel, sampler)), sampler, tally)
        })
    }
}

// ANCHOR: position
/// Where on the film a sample lies, in pixels: spread evenly over the pixel, or in its middle when
/// it is the only one.
#[inline]
pub fn position(pixel: Pixel, sampler: &Sampler) -> Vec2 {
    if sampler.count() == 1 {
        return pixel.position(sampler);
    }
    Vec2::new(pixel.x as f32, pixel.y as f32) + Random::at(sampler, 0).pair(PIXEL_OFFSET)
}
// ANCHOR_END: position
