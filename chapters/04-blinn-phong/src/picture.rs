//! What each pixel shows: the light that reaches the eye.

use common::film::Color;
use common::plan::{Effect, Plan};
use common::render::{Rendering, Settings, render_counted};
use common::tally::{Event, Tally};
use ray_casting::camera::{CAMERA_RAYS, Camera};
use ray_casting::ray::Ray;
use ray_casting::shape::Nearest;
use triangles::picture::SMOOTH_NORMALS;

use crate::material::BlinnPhong;
use crate::models::Model;
use crate::object::Object;
use crate::scene::Scene;
use crate::shading::{facing, seen_normal};

/// Points of a surface whose light was added up.
pub const SHADING_POINTS: Event = Event::new(4, 0, "shading_points");
/// Lamps that were asked what arrives of them.
pub const LIGHT_SAMPLES: Event = Event::new(4, 1, "light_samples");
/// Paints that were looked up by their place.
pub const TEXTURE_LOOKUPS: Event = Event::new(4, 2, "texture_lookups");

/// A scene and the camera it is seen with.
#[derive(Clone, Copy)]
pub struct Picture<'a> {
    /// What there is to see, and what lights it.
    pub scene: &'a Scene<BlinnPhong>,
    /// Where from.
    pub camera: Camera,
}

impl Picture<'_> {
    // ANCHOR: draw
    /// The picture by model `M`, with the effects of the plan. Which they are is settled here, before
    /// the first ray: each combination is a loop of its own, and what it leaves out is not in it.
    pub fn draw<M: Model, T: Tally>(&self, settings: &Settings, plan: &Plan) -> Rendering<T> {
        if !plan.simulates(Effect::PrimaryVisibility) {
            return render_counted(settings, |_, _, _| self.scene.background);
        }
        if !plan.simulates(Effect::LocalShading) {
            return self.draw_with(settings, |_, _, _| Color::ZERO);
        }
        match (plan.simulates(Effect::SmoothNormals), plan.simulates(Effect::Textures)) {
            (true, true) => self.draw_lit::<M, T, true, true>(settings),
            (true, false) => self.draw_lit::<M, T, true, false>(settings),
            (false, true) => self.draw_lit::<M, T, false, true>(settings),
            (false, false) => self.draw_lit::<M, T, false, false>(settings),
        }
    }
    // ANCHOR_END: draw

    fn draw_lit<M: Model, T: Tally, const SMOOTH: bool, const TEXTURES: bool>(
        &self,
        settings: &Settings,
    ) -> Rendering<T> {
        self.draw_with(settings, |ray, nearest, tally| {
            self.radiance::<M, T, SMOOTH, TEXTURES>(ray, nearest, tally)
        })
    }

    /// One ray for each sample of each pixel; `shade` says what comes back of what it hits.
    fn draw_with<T: Tally>(
        &self,
        settings: &Settings,
        shade: impl Fn(&Ray, &Nearest<Object<BlinnPhong>>, &mut T) -> Color + Sync,
    ) -> Rendering<T> {
        render_counted(settings, |pixel, sampler, tally: &mut T| {
            let ray = self.camera.ray(pixel.position(sampler));
            tally.count(CAMERA_RAYS, 1);
            match self.scene.nearest(&ray, tally) {
                Some(nearest) => shade(&ray, &nearest, tally),
                None => self.scene.background,
            }
        })
    }

    // ANCHOR: radiance
    /// What the point hit sends back along the ray: equation 2-1.
    #[inline]
    pub fn radiance<M: Model, T: Tally, const SMOOTH: bool, const TEXTURES: bool>(
        &self,
        ray: &Ray,
        nearest: &Nearest<Object<BlinnPhong>>,
        tally: &mut T,
    ) -> Color {
        let (hit, toward_eye) = (&nearest.hit, -ray.direction);
        let normal = match SMOOTH {
            true => seen_normal(hit, toward_eye),
            false => facing(hit.geometric, toward_eye),
        };
        let surface = nearest.object.material.at::<TEXTURES>(hit.uv);
        tally.count(SHADING_POINTS, 1);
        tally.count(SMOOTH_NORMALS, u64::from(SMOOTH && hit.normal != hit.geometric));
        tally.count(TEXTURE_LOOKUPS, u64::from(TEXTURES && nearest.object.material.is_textured()));

        let mut radiance = self.scene.ambient * surface.ambient;
        for light in &self.scene.lights {
            tally.count(LIGHT_SAMPLES, 1);
            if let Some(arriving) = light.at(hit.point) {
                radiance += M::returned(&surface, normal, toward_eye, &arriving);
            }
        }
        radiance
    }
    // ANCHOR_END: radiance
}
