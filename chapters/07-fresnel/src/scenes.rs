//! The chapter's scenes: chapter 4's, with glass and metal in them.

mod shows;

use blinn_phong::material::BlinnPhong;
use blinn_phong::scene::Scene;
use blinn_phong::scenes::{Stage, brute_force};
use common::chapter::{Failure, SceneName};
use common::plan::{Call, Effect};
use glam::Vec3;
use ray_casting::camera::Camera;
use ray_casting::knobs::Aim;
use ray_casting::ray::Ray;
use whitted::material::Mirrored;

use crate::glass::{Glass, Surface};
use crate::index::Index;
use crate::inside::Inside;

/// The scenes this chapter has.
pub const SCENES: &[SceneName] = &[
    SceneName { name: "whitted", about: "the report's figure 5.2: a ball of glass and one behind it" },
    SceneName { name: "pool", about: "from under water: the whole sky in a round window" },
    SceneName { name: "nested", about: "water in a glass ball, a bubble, and glass under water" },
    SceneName { name: "metals", about: "balls of gold, silver and copper" },
    SceneName { name: "two-lamps", about: "chapter 4's ball: no glass, no mirror" },
    SceneName { name: "empty", about: "nothing at all" },
];

/// A scene that can be drawn.
pub struct GlassStage {
    /// Objects, lamps and background.
    pub scene: Scene<Surface>,
    /// The camera, its film still to be chosen.
    pub camera: Camera,
    /// The effects its data call for.
    pub calls: Vec<Call>,
    /// The bodies around the eye.
    pub around_eye: Inside,
    /// Whether there may be a surface of glass that is no interface.
    pub unseen: bool,
}

impl GlassStage {
    /// The scene called `name`, its glass of index `index`, seen from where `aim` says.
    ///
    /// # Errors
    /// A name that is none, or a view that can't be (exit code 2).
    pub fn named(name: &str, index: Index, aim: &Aim) -> Result<Self, Failure> {
        let (stage, surfaces) = match name {
            "whitted" => (Stage::named("whitted", brute_force)?, shows::whitted(index)),
            "pool" => shows::pool()?,
            "nested" => shows::nested(index)?,
            "metals" => shows::metals()?,
            "two-lamps" | "empty" => (Stage::named(name, brute_force)?, Vec::new()),
            name => return Err(common::chapter::unknown_scene(name, SCENES)),
        };
        Self::new(stage.seen_from(|view| aim.apply(view))?, &surfaces)
    }

    /// A stage whose objects are made of `surfaces`, and those it has nothing for of what they were.
    fn new(stage: Stage, surfaces: &[Option<Surface>]) -> Result<Self, Failure> {
        let Stage { scene, camera, calls, .. } = stage;
        let own = |material: BlinnPhong| Surface::Opaque(Mirrored::dull(material));
        let scene = scene.map(|number, material| {
            surfaces.get(number).copied().flatten().unwrap_or_else(|| own(material))
        });
        let calls = with_glass(calls, &scene);
        let around_eye = around(&scene, scene.view.eye);
        let glasses: Vec<&Glass> = glasses(&scene).map(|(_, glass)| glass).collect();
        let unseen = glasses.len() > 1 || glasses.iter().any(|glass| glass.index == Index::AIR);
        Ok(Self { scene, camera, calls, around_eye, unseen })
    }
}

/// The bodies of glass, by their place in the scene.
fn glasses(scene: &Scene<Surface>) -> impl Iterator<Item = (usize, &Glass)> {
    let objects = scene.objects.iter().enumerate();
    objects.filter_map(|(number, object)| Some((number, object.material.glass()?)))
}

// ANCHOR: around
/// The bodies of glass that are around a point: those that a ray from there leaves before it
/// enters them.
pub fn around(scene: &Scene<Surface>, point: Vec3) -> Inside {
    let bodies = glasses(scene).filter(|&(number, _)| {
        // A body without end, as water under a plane, isn't met in every direction.
        let directions = Vec3::AXES.into_iter().flat_map(|axis| [axis, -axis]);
        let first = directions.into_iter().find_map(|direction| {
            let ray = Ray { origin: point, direction };
            let hit = scene.objects[number].shape.hit(&ray, f32::INFINITY)?;
            Some(hit.geometric.dot(direction) > 0.0)
        });
        first.unwrap_or(false)
    });
    bodies.fold(Inside::default(), |inside, (number, _)| inside.with(number as u32))
}
// ANCHOR_END: around

// ANCHOR: calls
/// What the scene calls for: what chapter 4 found, and what its glass and metal ask for.
fn with_glass(mut calls: Vec<Call>, scene: &Scene<Surface>) -> Vec<Call> {
    calls.retain(|it| !matches!(it.effect, Effect::MirrorReflection | Effect::Refraction));
    let first = |wanted: fn(&Surface) -> bool| {
        let place = scene.objects.iter().position(|object| wanted(&object.material));
        place.map(|place| format!("object {}", place + 1))
    };
    let reflects = first(|surface| match surface {
        Surface::Opaque(material) => material.reflects(),
        Surface::Metal(_) | Surface::Glass(_) => true,
    });
    let refracts = first(|surface| surface.glass().is_some());
    let because = |object: String, what: &str| format!("{object} {what}");
    calls.extend(reflects.map(|object| Call {
        effect: Effect::MirrorReflection,
        because: because(object, "reflects"),
    }));
    calls.extend(refracts.map(|object| Call {
        effect: Effect::Refraction,
        because: because(object, "is glass"),
    }));
    calls
}
// ANCHOR_END: calls
