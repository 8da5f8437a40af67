//! What each pixel shows: the light of the lamps that reach the surface, and that from everywhere.

use blinn_phong::light::Light;
use blinn_phong::material::BlinnPhong;
use blinn_phong::models::{Blinn, Model};
use blinn_phong::object::Object;
use blinn_phong::picture::{SHADING_POINTS, TEXTURE_LOOKUPS};
use blinn_phong::scene::Scene;
use blinn_phong::shading::{facing, seen_normal};
use common::film::Color;
use common::plan::{Effect, Plan};
use common::render::{Rendering, Settings, render_counted};
use common::tally::Tally;
use ray_casting::camera::{CAMERA_RAYS, Camera};
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Nearest};
use triangles::picture::SMOOTH_NORMALS;

use crate::lighting::{reaches, sum_of_lamps};
use crate::naive;
use crate::offset::{Leave, Offset};

/// A scene, the camera it is seen with, and where shadow rays start.
#[derive(Clone, Copy)]
pub struct Picture<'a> {
    /// What there is to see, and what lights it.
    pub scene: &'a Scene<BlinnPhong>,
    /// Where from.
    pub camera: Camera,
    /// Where rays start that leave a surface.
    pub offset: Offset,
}

/// How it is decided whether a lamp reaches a surface, before the first ray.
trait Reach: Sync {
    fn reaches<T: Tally>(
        &self,
        scene: &Scene<BlinnPhong>,
        light: &Light,
        hit: &Hit,
        tally: &mut T,
    ) -> bool;
}

/// Nothing is ever hidden: no shadows are called for.
struct Always;

/// By this chapter's visibility.
struct Bound;

/// By a ray that starts where a formula says.
struct Chosen(Leave);

impl Reach for Always {
    #[inline]
    fn reaches<T: Tally>(&self, _: &Scene<BlinnPhong>, _: &Light, _: &Hit, _: &mut T) -> bool {
        true
    }
}

impl Reach for Bound {
    fn reaches<T: Tally>(
        &self,
        scene: &Scene<BlinnPhong>,
        light: &Light,
        hit: &Hit,
        tally: &mut T,
    ) -> bool {
        reaches(scene, light, hit, tally)
    }
}

impl Reach for Chosen {
    fn reaches<T: Tally>(
        &self,
        scene: &Scene<BlinnPhong>,
        light: &Light,
        hit: &Hit,
        tally: &mut T,
    ) -> bool {
        naive::reaches(scene, light, hit, self.0, tally)
    }
}

impl Picture<'_> {
    // ANCHOR: draw
    /// The picture with the effects of the plan. What is left out is not in the loop.
    pub fn draw<T: Tally>(&self, settings: &Settings, plan: &Plan) -> Rendering<T> {
        if !plan.simulates(Effect::PrimaryVisibility) {
            return render_counted(settings, |_, _, _| self.scene.background);
        }
        if !plan.simulates(Effect::LocalShading) {
            return self.draw_with(settings, |_, _, _| Color::ZERO);
        }
        match (plan.simulates(Effect::HardShadows), self.offset) {
            (false, _) => self.draw_reached(settings, plan, &Always),
            (true, Offset::Bound) => self.draw_reached(settings, plan, &Bound),
            (true, offset) => self.draw_reached(settings, plan, &Chosen(offset.leave())),
        }
    }
    // ANCHOR_END: draw

    fn draw_reached<T: Tally>(
        &self,
        settings: &Settings,
        plan: &Plan,
        reach: &impl Reach,
    ) -> Rendering<T> {
        match (plan.simulates(Effect::SmoothNormals), plan.simulates(Effect::Textures)) {
            (true, true) => self.draw_lit::<T, true, true>(settings, reach),
            (true, false) => self.draw_lit::<T, true, false>(settings, reach),
            (false, true) => self.draw_lit::<T, false, true>(settings, reach),
            (false, false) => self.draw_lit::<T, false, false>(settings, reach),
        }
    }

    fn draw_lit<T: Tally, const SMOOTH: bool, const TEXTURES: bool>(
        &self,
        settings: &Settings,
        reach: &impl Reach,
    ) -> Rendering<T> {
        self.draw_with(settings, |ray, nearest, tally| {
            self.radiance::<T, SMOOTH, TEXTURES>(ray, nearest, reach, tally)
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
    /// What the point hit sends back along the ray: light from everywhere, which nothing hides, and
    /// that of the lamps that reach it.
    #[inline]
    fn radiance<T: Tally, const SMOOTH: bool, const TEXTURES: bool>(
        &self,
        ray: &Ray,
        nearest: &Nearest<Object<BlinnPhong>>,
        reach: &impl Reach,
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

        let lights = &self.scene.lights;
        let returned = |arriving: &_| Blinn::returned(&surface, normal, toward_eye, arriving);
        let lamps = sum_of_lamps(lights, hit, toward_eye, tally, returned, |light, tally| {
            reach.reaches(self.scene, light, hit, tally)
        });
        self.scene.ambient * surface.ambient + lamps
    }
    // ANCHOR_END: radiance
}
