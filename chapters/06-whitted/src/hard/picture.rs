//! The mirror of few triangles twice: by its smooth normals as they are, and by ours.

use blinn_phong::scene::Scene;
use blinn_phong::scenes::brute_force;
use common::film::{Color, Film};
use common::render::{Settings, render};
use common::tally::{Off, Tally};
use ray_casting::ray::Ray;

use crate::limits::Limits;
use crate::material::Mirrored;
use crate::mirror::MIRROR_RAYS;
use crate::naive::unchecked;
use crate::scatter::{Branch, Scatter, Scattered};
use crate::scenes::Stage;
use crate::world::World;

/// The world with all its effects, as this chapter has it.
type Ours<'a> = World<'a, true, true, true, true>;

/// The same, but that a mirror's ray goes where the smooth normal sends it.
struct Unchecked<'a>(Ours<'a>);

impl Scatter for Unchecked<'_> {
    type Ray = Ray;

    fn scatter<T: Tally>(&self, ray: &Ray, tally: &mut T) -> Scattered<Ray> {
        let met = self.0.scatter(ray, tally);
        let Some(found) = self.0.scene.nearest(ray, tally) else { return met };
        let weight = found.object.material.mirror;
        let branch = unchecked(ray, &found.hit).filter(|_| weight != Color::ZERO);
        Scattered::with(met.light, branch.map(|ray| Branch { ray, weight, event: &MIRROR_RAYS }))
    }
}

/// Both, side by side: unchecked on the left. None if the scene could not be built.
pub fn picture() -> Option<Film> {
    let Stage { scene, camera, .. } = Stage::named("chrome", brute_force, |_| ()).ok()?;
    let settings = Settings { width: 640, height: 240, ..Settings::default() };
    let camera = camera.with_film(320, 240);
    let scene: &Scene<Mirrored> = &scene;
    let (ours, limits) = (Ours { scene }, Limits { depth: 8, cutoff: 0.001 });
    let rendering = render(&settings, |pixel, sampler| {
        let position = pixel.position(sampler);
        let on_right = glam::Vec2::new(position.x - 320.0, position.y);
        match pixel.x < 320 {
            true => limits.trace(&Unchecked(ours), camera.ray(position), &mut Off),
            false => limits.trace(&ours, camera.ray(on_right), &mut Off),
        }
    });
    Some(rendering.film)
}
