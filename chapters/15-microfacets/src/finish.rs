//! The materials of chapters 12 and 15.

use common::film::Color;
use common::plan::{Effect, Plan};
use glam::Vec3;
use path_tracing::bsdf::{Bsdf, BsdfSample, Material, MaterialError};
use path_tracing::lambert::Lambert;
use path_tracing::random::Random;
use path_tracing::smooth::Smooth;
use path_tracing::world::World;

use crate::facets::Facets;
use crate::rough::Rough;

// ANCHOR: finish
/// A surface of any finish.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Finish {
    /// Chapter 12's: matte, a mirror, or clear glass.
    Smooth(Smooth),
    /// In between.
    Rough(Rough),
}
// ANCHOR_END: finish

impl Finish {
    /// The material where nothing rough is simulated.
    pub fn smooth(&self) -> Option<Smooth> {
        match self {
            Self::Smooth(smooth) => Some(*smooth),
            Self::Rough(_) => None,
        }
    }

    /// The material where nothing rough, no mirror and no glass is simulated.
    pub fn lambert(&self) -> Option<Lambert> {
        self.smooth().and_then(|smooth| smooth.lambert())
    }

    /// The same, its facets changed where it has some.
    pub fn with_facets(mut self, change: impl Fn(&mut Facets)) -> Self {
        if let Self::Rough(rough) = &mut self {
            change(rough.facets_mut());
        }
        self
    }
}

impl From<Smooth> for Finish {
    fn from(smooth: Smooth) -> Self {
        Self::Smooth(smooth)
    }
}

impl From<Rough> for Finish {
    fn from(rough: Rough) -> Self {
        Self::Rough(rough)
    }
}

// ANCHOR: narrowest
/// A scene in the simplest materials that it can be drawn with: those that are left out have no case
/// in the program.
#[derive(Clone, Debug)]
pub enum Narrowest<'a> {
    /// All is matte.
    Matte(World<'a, Lambert>),
    /// Nothing is rough.
    Smooth(World<'a, Smooth>),
    /// Anything may be.
    Finish(World<'a, Finish>),
}

impl<'a> Narrowest<'a> {
    /// Of `world`, where `plan` is simulated.
    pub fn new(world: World<'a, Finish>, plan: &Plan) -> Self {
        let rough = plan.simulates(Effect::GlossyReflection);
        match (!rough).then(|| world.narrowed(Finish::smooth)).flatten() {
            Some(smooth) => smooth.matte(plan).map_or(Self::Smooth(smooth), Self::Matte),
            None => Self::Finish(world),
        }
    }
}
// ANCHOR_END: narrowest

impl Bsdf for Finish {
    #[inline]
    fn eval(&self, outgoing: Vec3, incoming: Vec3) -> Color {
        match self {
            Self::Smooth(smooth) => smooth.eval(outgoing, incoming),
            Self::Rough(rough) => rough.eval(outgoing, incoming),
        }
    }

    #[inline]
    fn pdf(&self, outgoing: Vec3, incoming: Vec3) -> f32 {
        match self {
            Self::Smooth(smooth) => smooth.pdf(outgoing, incoming),
            Self::Rough(rough) => rough.pdf(outgoing, incoming),
        }
    }

    #[inline]
    fn sample(&self, outgoing: Vec3, random: &Random) -> Option<BsdfSample> {
        match self {
            Self::Smooth(smooth) => smooth.sample(outgoing, random),
            Self::Rough(rough) => rough.sample(outgoing, random),
        }
    }

    #[inline]
    fn spreads(&self) -> bool {
        match self {
            Self::Smooth(smooth) => smooth.spreads(),
            Self::Rough(rough) => rough.spreads(),
        }
    }

    #[inline]
    fn is_diffuse(&self) -> bool {
        matches!(self, Self::Smooth(smooth) if smooth.is_diffuse())
    }
}

impl Material for Finish {
    fn check(&self) -> Result<(), MaterialError> {
        match self {
            Self::Smooth(smooth) => smooth.check(),
            Self::Rough(rough) => rough.check(),
        }
    }

    fn effect(&self) -> Option<Effect> {
        match self {
            Self::Smooth(smooth) => smooth.effect(),
            Self::Rough(rough) => rough.effect(),
        }
    }

    fn reflects(&self) -> bool {
        match self {
            Self::Smooth(smooth) => smooth.reflects(),
            Self::Rough(rough) => rough.reflects(),
        }
    }
}

#[cfg(test)]
mod tests {
    use common::plan::{Plan, Simulate};
    use path_tracing::stage::Stage;

    use super::Narrowest;
    use crate::command::SKILLS;
    use crate::scenes::named;

    #[test]
    fn no_material_that_the_scene_or_the_plan_does_not_call_for() {
        let narrowest = |name: &str, simulate| {
            let stage = Stage::new(&named(name, 0.5).expect("a scene")).expect("sound");
            match Narrowest::new(stage.world(), &Plan::new(&stage.calls, SKILLS, simulate)) {
                Narrowest::Matte(_) => "matte",
                Narrowest::Smooth(_) => "smooth",
                Narrowest::Finish(_) => "finish",
            }
        };
        assert_eq!(narrowest("cornell", Simulate::Needed), "matte");
        assert_eq!(narrowest("cornell-glass", Simulate::Needed), "smooth");
        assert_eq!(narrowest("rough-metals", Simulate::Needed), "finish");
        assert_eq!(narrowest("cornell", Simulate::All), "finish");
    }
}
