//! A scene made ready to be drawn.

use common::film::Color;
use common::plan::{Call, Effect};
use ray_casting::camera::{Camera, CameraError};

use crate::bsdf::{Material, MaterialError};
use crate::model::Model;
use crate::part::Part;
use crate::space::Space;
use crate::world::{Surface, World};

// ANCHOR: stage
/// A scene that was checked, its triangles in a tree.
#[derive(Clone, Debug)]
pub struct Stage<M> {
    /// Where things are.
    pub space: Space,
    /// What they are made of.
    pub surfaces: Vec<Surface<M>>,
    /// The radiance from all around.
    pub sky: Color,
    /// The camera, its film still to be chosen.
    pub camera: Camera,
    /// The effects that it calls for.
    pub calls: Vec<Call>,
}
// ANCHOR_END: stage

/// Why a scene can't be drawn.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StageError {
    /// A thing that can't be.
    #[error("thing {index} of the scene: {error}")]
    Part {
        /// Its place in the list.
        index: usize,
        /// Why.
        error: MaterialError,
    },
    /// A sky that can't be.
    #[error("the sky's radiance must be finite and at least 0 in every colour")]
    Sky,
    /// A view that can't be.
    #[error("no picture: {0}")]
    View(#[from] CameraError),
}

impl<M: Material> Stage<M> {
    /// The stage of a scene.
    ///
    /// # Errors
    /// Materials, lights and views that can't be.
    pub fn new(model: &Model<M>) -> Result<Self, StageError> {
        for (index, part) in model.parts.iter().enumerate() {
            check(part).map_err(|error| StageError::Part { index, error })?;
        }
        if !is_light(model.sky) {
            return Err(StageError::Sky);
        }
        let camera = Camera::new(&model.view, 1, 1)?;
        let surface = |part: &Part<M>| Surface { bsdf: part.material, emission: part.emission };
        Ok(Self {
            space: Space::new(&model.parts),
            surfaces: model.parts.iter().map(surface).collect(),
            sky: model.sky,
            camera,
            calls: calls(model),
        })
    }

    /// The scene as paths see it.
    pub fn world(&self) -> World<'_, M> {
        World { space: &self.space, surfaces: self.surfaces.clone(), sky: self.sky }
    }
}

fn check<M: Material>(part: &Part<M>) -> Result<(), MaterialError> {
    part.material.check()?;
    if is_light(part.emission.radiance) { Ok(()) } else { Err(MaterialError::Emission) }
}

/// Whether it is an amount of light.
fn is_light(radiance: Color) -> bool {
    radiance.to_array().iter().all(|part| part.is_finite() && *part >= 0.0)
}

// ANCHOR: calls
/// The effects that a scene calls for, each with the first thing that does.
pub fn calls<M: Material>(model: &Model<M>) -> Vec<Call> {
    let mut calls = Vec::new();
    let mut call = |effect, because: String| {
        if !calls.iter().any(|call: &Call| call.effect == effect) {
            calls.push(Call { effect, because });
        }
    };
    for (index, part) in model.parts.iter().enumerate() {
        call(Effect::PrimaryVisibility, "there is something to see".into());
        if part.emission.glows() {
            call(Effect::AreaLights, format!("thing {index} glows"));
        }
        if part.material.reflects() {
            call(Effect::IndirectLight, format!("thing {index} sends light on"));
        }
        if let Some(effect) = part.material.effect() {
            call(effect, format!("thing {index} is made for it"));
        }
    }
    if model.sky != Color::ZERO {
        call(Effect::EnvironmentLight, "the sky is bright".into());
    }
    calls
}
// ANCHOR_END: calls
