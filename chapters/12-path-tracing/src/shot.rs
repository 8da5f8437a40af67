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
        self.exposed(&ByPixel, world, plan, settings)
    }
    // ANCHOR_END: shot

    /// The same, with the film exposed in another way.
    pub fn exposed<B: Bsdf, T: Tally>(
        &self,
        exposure: &impl Exposure,
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
            (true, false) => shot.film::<B, T, true, false>(exposure, world, settings),
            (false, true) => shot.film::<B, T, false, true>(exposure, world, settings),
            (true, true) => shot.film::<B, T, true, true>(exposure, world, settings),
        }
    }

    /// The picture that one of these path tracers makes.
    fn film<B: Bsdf, T: Tally, const EMITTERS: bool, const SKY: bool>(
        &self,
        exposure: &impl Exposure,
        world: &World<B>,
        settings: &Settings,
    ) -> Rendering<T> {
        let Self { lighting, ending, depth, .. } = *self;
        let tracer = PathTracer::<B, L, E, EMITTERS, SKY> { world, lighting, ending, depth };
        let camera = self.camera.with_film(settings.width, settings.height);
        exposure.expose(&tracer, &camera, settings)
    }
}

/// How a film gets its light from a path tracer.
pub trait Exposure {
    /// The film that `tracer` exposes with `camera`.
    fn expose<B, L, E, T, const EMITTERS: bool, const SKY: bool>(
        &self,
        tracer: &PathTracer<B, L, E, EMITTERS, SKY>,
        camera: &Camera,
        settings: &Settings,
    ) -> Rendering<T>
    where
        B: Bsdf,
        L: Lighting + Copy,
        E: Ending + Copy,
        T: Tally;
}

/// Each pixel by itself: it is the mean of its own paths.
#[derive(Clone, Copy, Debug)]
pub struct ByPixel;

impl Exposure for ByPixel {
    fn expose<B, L, E, T, const EMITTERS: bool, const SKY: bool>(
        &self,
        tracer: &PathTracer<B, L, E, EMITTERS, SKY>,
        camera: &Camera,
        settings: &Settings,
    ) -> Rendering<T>
    where
        B: Bsdf,
        L: Lighting + Copy,
        E: Ending + Copy,
        T: Tally,
    {
        render_counted(settings, |pixel, sampler, tally: &mut T| {
            tally.count(CAMERA_RAYS, 1);
            tracer.radiance(camera.ray(position(pixel, sampler)), sampler, tally)
        })
    }
}

// ANCHOR: position
/// Where on the film a sample lies, in pixels: spread evenly over the pixel, or in its middle when
/// it is the only one.
#[inline(always)]
pub fn position(pixel: Pixel, sampler: &Sampler) -> Vec2 {
    if sampler.count() == 1 {
        return pixel.position(sampler);
    }
    Vec2::new(pixel.x as f32, pixel.y as f32) + Random::at(sampler, 0).pair(PIXEL_OFFSET)
}
// ANCHOR_END: position

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::plan::{Plan, Simulate};
    use common::render::{Pixel, Settings};
    use common::sampler::Sampler;
    use common::tally::Counts;
    use glam::Vec2;
    use ray_casting::camera::CAMERA_RAYS;

    use super::{Shot, position};
    use crate::furnace;
    use crate::model::Model;
    use crate::smooth::Smooth;
    use crate::stage::Stage;
    use crate::strategy::{ByDirection, Never};

    const PIXEL: Pixel = Pixel { x: 3, y: 5 };

    #[test]
    fn samples_are_spread_over_the_pixel() {
        assert_eq!(position(PIXEL, &Sampler::new(1, 9, 0, 1)), Vec2::new(3.5, 5.5));
        let mut quarters = [0; 4];
        for index in 0..4 {
            let within = position(PIXEL, &Sampler::new(1, 9, index, 4)) - Vec2::new(3.0, 5.0);
            assert!(within.min_element() >= 0.0 && within.max_element() < 1.0);
            let Vec2 { x, y } = (2.0 * within).floor();
            quarters[(2.0 * y + x) as usize] += 1;
        }
        assert_eq!(quarters, [1; 4]);
    }

    #[test]
    fn a_scene_of_nothing_is_its_sky() {
        let sky = Color::new(0.1, 0.2, 0.3);
        let model: Model<Smooth> = Model { parts: Vec::new(), sky, ..furnace::ball(0.5) };
        let stage = Stage::new(&model).expect("sound");
        let (camera, lighting, ending) = (&stage.camera, ByDirection, Never);
        let shot = Shot { camera, lighting, ending, depth: 4 };
        let settings = Settings { width: 5, height: 4, ..Settings::default() };
        let plan = Plan::new(&stage.calls, &[], Simulate::Needed);
        let drawn = shot.draw::<_, Counts>(&stage.world(), &plan, &settings);
        assert!(drawn.film.pixels.iter().all(|&pixel| pixel == sky));
        assert_eq!(drawn.tally.of(CAMERA_RAYS), 0);
    }
}
