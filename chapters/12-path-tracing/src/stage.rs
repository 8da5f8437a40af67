//! A scene made ready to be drawn.

use common::film::Color;
use common::plan::{Call, Effect};
use ray_casting::camera::{Camera, CameraError};

use crate::bsdf::{Material, MaterialError};
use crate::model::Model;
use crate::part::{Part, is_light};
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
    /// What the user should be told of its file.
    pub warnings: Vec<String>,
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
            warnings: model.warnings.clone(),
        })
    }

    /// The scene as paths see it.
    pub fn world(&self) -> World<'_, M> {
        World { space: &self.space, surfaces: self.surfaces.clone(), sky: self.sky }
    }
}

fn check<M: Material>(part: &Part<M>) -> Result<(), MaterialError> {
    part.material.check()?;
    part.emission.check()
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

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::plan::Effect;
    use glam::Vec3;
    use ray_casting::camera::CameraError;

    use super::{Stage, StageError};
    use crate::bsdf::MaterialError;
    use crate::furnace;
    use crate::lambert::Lambert;
    use crate::mirror::Mirror;
    use crate::model::Model;
    use crate::smooth::Smooth;

    fn refused(change: impl FnOnce(&mut Model<Smooth>)) -> StageError {
        let mut model = furnace::shell(0.5);
        change(&mut model);
        Stage::new(&model).expect_err("it can't be")
    }

    #[test]
    fn materials_that_make_light_are_refused() {
        let material = |reflectance| {
            refused(|model| model.parts[1].material = Smooth::Lambert(Lambert { reflectance }))
        };
        let error = MaterialError::Reflectance;
        for red in [1.001, -0.1, f32::NAN, f32::INFINITY] {
            let found = material(Color::new(red, 0.5, 0.5));
            assert_eq!(found, StageError::Part { index: 1, error });
        }
        let mirror = Smooth::Mirror(Mirror { reflectance: Color::new(0.0, 2.0, 0.0) });
        let found = refused(|model| model.parts[0].material = mirror);
        assert!(found.to_string().starts_with("thing 0 of the scene: the reflectance"), "{found}");
    }

    #[test]
    fn light_that_is_no_amount_is_refused() {
        for blue in [f32::NAN, f32::INFINITY, -1.0] {
            let light = Color::new(1.0, 1.0, blue);
            let found = refused(|model| model.parts[1].emission.radiance = light);
            assert_eq!(found, StageError::Part { index: 1, error: MaterialError::Emission });
            assert_eq!(refused(|model| model.sky = light), StageError::Sky);
        }
    }

    #[test]
    fn a_view_of_nothing_is_refused() {
        let found = refused(|model| model.view.target = model.view.eye);
        assert!(matches!(found, StageError::View(CameraError::NoForward)), "{found:?}");
        let found = refused(|model| model.view.eye = Vec3::NAN);
        assert!(found.to_string().starts_with("no picture"), "{found}");
    }

    #[test]
    fn a_scene_calls_for_what_is_in_it() {
        let effects = |model: &Model<Smooth>| -> Vec<Effect> {
            super::calls(model).iter().map(|call| call.effect).collect()
        };
        let mut model = furnace::shell(0.5);
        let seen = [Effect::PrimaryVisibility, Effect::IndirectLight, Effect::AreaLights];
        assert_eq!(effects(&model), seen);
        model.parts[1].emission.radiance = Color::ZERO;
        model.parts[0].material = Smooth::BLACK;
        model.sky = Color::ONE;
        assert_eq!(effects(&model), [Effect::PrimaryVisibility, Effect::EnvironmentLight]);
        model.parts.clear();
        model.sky = Color::ZERO;
        assert!(effects(&model).is_empty());
    }
}
