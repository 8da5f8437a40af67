//! A scene with mirrors, as something that rays can be followed through.

use blinn_phong::material::BlinnPhong;
use blinn_phong::models::Blinn;
use blinn_phong::picture::{SHADING_POINTS, TEXTURE_LOOKUPS};
use blinn_phong::scene::Scene;
use blinn_phong::shading::{returned, seen_normal};
use common::film::Color;
use common::tally::Tally;
use glam::Vec3;
use ray_casting::ray::Ray;
use ray_casting::shape::Hit;
use shadows::lighting::from_lamps;
use triangles::picture::SMOOTH_NORMALS;

use crate::material::Mirrored;
use crate::mirror::{MIRROR_RAYS, mirrored};
use crate::scatter::{Branch, Scatter, Scattered};

// ANCHOR: world
/// A scene, and the effects of it that are simulated. They are constants, so what is left out is not
/// in the program that follows the rays.
///
/// `SHADING` is the light of lamps and of all around, `DETAILS` are colours and normals that vary
/// over a surface, `SHADOWS` hide lamps, `MIRRORS` send rays on.
#[derive(Clone, Copy)]
pub struct World<
    'a,
    const SHADING: bool,
    const DETAILS: bool,
    const SHADOWS: bool,
    const MIRRORS: bool,
> {
    /// What there is.
    pub scene: &'a Scene<Mirrored>,
}
// ANCHOR_END: world

// ANCHOR: scatter
impl<const SHADING: bool, const DETAILS: bool, const SHADOWS: bool, const MIRRORS: bool> Scatter
    for World<'_, SHADING, DETAILS, SHADOWS, MIRRORS>
{
    type Ray = Ray;

    #[inline]
    fn scatter<T: Tally>(&self, ray: &Ray, tally: &mut T) -> Scattered<Ray> {
        let Some(mut found) = self.scene.nearest(ray, tally) else {
            return Scattered::only(self.scene.background);
        };
        let Mirrored { surface, mirror } = &found.object.material;
        let hit = detailed::<DETAILS, T>(&mut found.hit, tally);
        let light = match SHADING {
            true => local::<DETAILS, SHADOWS, T>(self.scene, surface, hit, -ray.direction, tally),
            false => Color::ZERO,
        };
        if !MIRRORS || *mirror == Color::ZERO {
            return Scattered::only(light);
        }
        let weight = *mirror;
        let branch = mirrored(ray, hit).map(|ray| Branch { ray, weight, event: &MIRROR_RAYS });
        Scattered::with(light, branch)
    }
}
// ANCHOR_END: scatter

/// The hit, given the normal to shade it with: the surface's own where there are no details.
#[inline]
pub fn detailed<'h, const DETAILS: bool, T: Tally>(hit: &'h mut Hit, tally: &mut T) -> &'h Hit {
    if DETAILS {
        tally.count(SMOOTH_NORMALS, u64::from(hit.normal != hit.geometric));
    } else {
        hit.normal = hit.geometric;
    }
    hit
}

// ANCHOR: local
/// What a surface sends `toward_eye` of the light of lamps and of all around: chapters 4 and 5.
#[inline]
pub fn local<const DETAILS: bool, const SHADOWS: bool, T: Tally>(
    scene: &Scene<impl Sync>,
    surface: &BlinnPhong,
    hit: &Hit,
    toward_eye: Vec3,
    tally: &mut T,
) -> Color {
    tally.count(SHADING_POINTS, 1);
    tally.count(TEXTURE_LOOKUPS, u64::from(DETAILS && surface.is_textured()));
    let surface = surface.at::<DETAILS>(hit.uv);
    let normal = seen_normal(hit, toward_eye);
    let lamps =
        from_lamps::<SHADOWS, T>(scene, &scene.lights, hit, toward_eye, tally, |arriving| {
            returned::<Blinn>(&surface, normal, toward_eye, arriving)
        });
    scene.ambient * surface.ambient + lamps
}
// ANCHOR_END: local
