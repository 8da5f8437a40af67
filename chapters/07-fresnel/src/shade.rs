//! What an opaque surface sends of the lamps' light, with glass around.

use blinn_phong::models::Blinn;
use blinn_phong::scene::Scene;
use blinn_phong::shading::{returned, seen_normal};
use common::film::Color;
use common::tally::Tally;
use glam::Vec3;
use ray_casting::ray::Ray;
use ray_casting::shape::Hit;
use shadows::lighting::from_lamps;
use shadows::occluder::Occluder;
use whitted::material::Mirrored;

use crate::glass::Surface;
use crate::inside::Inside;
use crate::passage::{Met, next};

/// What light of lamps and from everywhere is simulated: all of it, colours and normals that vary over
/// a surface, shadows. As in chapter 6, what is left out is not in the program.
#[derive(Clone, Copy, Debug)]
pub struct Lit<const SHADING: bool, const DETAILS: bool, const SHADOWS: bool>;

// ANCHOR: occluders
/// What hides lamps: all that a ray meets. Glass bends the light, so a straight ray says nothing of
/// where it would go, and glass hides a lamp as if it were black. But a surface of glass that is no
/// interface hides nothing.
struct Occluders<'a> {
    scene: &'a Scene<Surface>,
    /// The bodies around the surface that is lit.
    inside: Inside,
    /// Whether the scene has glass that may be no interface.
    unseen: bool,
}

impl Occluder for Occluders<'_> {
    fn blocks<T: Tally>(&self, ray: &Ray, t_max: f32, tally: &mut T) -> bool {
        if !self.unseen {
            return self.scene.blocks(ray, t_max, tally);
        }
        match next(self.scene, ray, self.inside, tally) {
            Some(Met::Surface { hit, .. } | Met::Interface { hit, .. }) => hit.t < t_max,
            None => false,
        }
    }
}
// ANCHOR_END: occluders

/// A surface that is seen.
#[derive(Clone, Copy)]
pub struct Seen<'a> {
    /// The scene.
    pub scene: &'a Scene<Surface>,
    /// Where.
    pub hit: &'a Hit,
    /// The direction back along the ray, of length 1.
    pub toward_eye: Vec3,
    /// The bodies around it.
    pub inside: Inside,
    /// Whether the scene has glass that may be no interface.
    pub unseen: bool,
}

/// What a surface sends towards the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sent {
    /// Of the light from everywhere.
    pub ambient: Color,
    /// Of lamps.
    pub lamps: Color,
}

impl<const SHADING: bool, const DETAILS: bool, const SHADOWS: bool> Lit<SHADING, DETAILS, SHADOWS> {
    /// What the surface sends of the light that reaches it directly.
    pub fn sent<T: Tally>(seen: &Seen, material: &Mirrored, tally: &mut T) -> Sent {
        if !SHADING {
            return Sent { ambient: Color::ZERO, lamps: Color::ZERO };
        }
        let Seen { scene, hit, toward_eye, inside, unseen } = *seen;
        let surface = material.surface.at::<DETAILS>(hit.uv);
        let normal = seen_normal(hit, toward_eye);
        let occluders = Occluders { scene, inside, unseen };
        let lamps = from_lamps::<SHADOWS, T>(
            &occluders,
            &scene.lights,
            hit,
            toward_eye,
            tally,
            |arriving| returned::<Blinn>(&surface, normal, toward_eye, arriving),
        );
        Sent { ambient: scene.ambient * surface.ambient, lamps }
    }
}
