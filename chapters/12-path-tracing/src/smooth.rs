//! The materials of this chapter.

use common::film::Color;
use common::plan::{Effect, Plan};
use glam::Vec3;

use crate::bsdf::{Bsdf, BsdfSample, Material, MaterialError, check_reflectance};
use crate::glass::Glass;
use crate::lambert::Lambert;
use crate::mirror::Mirror;
use crate::random::Random;
use crate::world::World;

// ANCHOR: smooth
/// A material whose surface is either perfectly rough or perfectly smooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Smooth {
    /// Scatters light in all directions.
    Lambert(Lambert),
    /// Reflects it in one.
    Mirror(Mirror),
    /// Reflects it in one and lets it through in another.
    Glass(Glass),
}
// ANCHOR_END: smooth

impl Bsdf for Smooth {
    #[inline]
    fn eval(&self, outgoing: Vec3, incoming: Vec3) -> Color {
        match self {
            Self::Lambert(lambert) => lambert.eval(outgoing, incoming),
            Self::Mirror(_) | Self::Glass(_) => Color::ZERO,
        }
    }

    #[inline]
    fn pdf(&self, outgoing: Vec3, incoming: Vec3) -> f32 {
        match self {
            Self::Lambert(lambert) => lambert.pdf(outgoing, incoming),
            Self::Mirror(_) | Self::Glass(_) => 0.0,
        }
    }

    #[inline]
    fn sample(&self, outgoing: Vec3, random: &Random) -> Option<BsdfSample> {
        match self {
            Self::Lambert(lambert) => lambert.sample(outgoing, random),
            Self::Mirror(mirror) => mirror.sample(outgoing, random),
            Self::Glass(glass) => glass.sample(outgoing, random),
        }
    }

    #[inline]
    fn spreads(&self) -> bool {
        matches!(self, Self::Lambert(lambert) if lambert.spreads())
    }

    #[inline]
    fn is_diffuse(&self) -> bool {
        matches!(self, Self::Lambert(_))
    }
}

impl Smooth {
    /// The material where no mirror and no glass is simulated.
    pub fn lambert(&self) -> Option<Lambert> {
        match self {
            Self::Lambert(lambert) => Some(*lambert),
            Self::Mirror(_) | Self::Glass(_) => None,
        }
    }

    /// A matte material.
    pub const fn matte(red: f32, green: f32, blue: f32) -> Self {
        Self::Lambert(Lambert::new(red, green, blue))
    }

    /// A material that reflects nothing.
    pub const BLACK: Self = Self::Lambert(Lambert::BLACK);
}

impl Material for Smooth {
    fn check(&self) -> Result<(), MaterialError> {
        match self {
            Self::Lambert(lambert) => check_reflectance(lambert.reflectance),
            Self::Mirror(mirror) => check_reflectance(mirror.reflectance),
            Self::Glass(_) => Ok(()),
        }
    }

    fn effect(&self) -> Option<Effect> {
        match self {
            Self::Lambert(_) => None,
            Self::Mirror(_) => Some(Effect::MirrorReflection),
            Self::Glass(_) => Some(Effect::Refraction),
        }
    }

    fn reflects(&self) -> bool {
        match self {
            Self::Lambert(lambert) => lambert.spreads(),
            Self::Mirror(mirror) => mirror.reflectance != Color::ZERO,
            Self::Glass(_) => true,
        }
    }
}

// ANCHOR: matte
impl<'a> World<'a, Smooth> {
    /// The same scene of matte surfaces, where it has no others and `plan` simulates no others.
    pub fn matte(&self, plan: &Plan) -> Option<World<'a, Lambert>> {
        let specular = [Effect::MirrorReflection, Effect::Refraction];
        let matte = !specular.iter().any(|&effect| plan.simulates(effect));
        matte.then(|| self.narrowed(Smooth::lambert)).flatten()
    }
}
// ANCHOR_END: matte

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::plan::Effect;
    use fresnel::index::Index;
    use glam::Vec3;

    use super::Smooth;
    use crate::bsdf::tests::check_sampling;
    use crate::bsdf::{Bsdf, Material};
    use crate::glass::Glass;
    use crate::mirror::Mirror;
    use crate::random::Random;

    const GLASS: Smooth = Smooth::Glass(Glass { index: Index::GLASS });
    const MIRROR: Smooth = Smooth::Mirror(Mirror { reflectance: Color::splat(0.9) });
    const MATTE: Smooth = Smooth::matte(0.5, 0.25, 0.125);

    #[test]
    fn each_answers_for_its_own_kind() {
        let outgoing = Vec3::new(0.6, 0.0, 0.8);
        check_sampling(&MATTE, outgoing);
        let random = Random::of_trial(128, 1);
        for (smooth, is_delta) in [(GLASS, true), (MIRROR, true), (MATTE, false)] {
            let sample = smooth.sample(outgoing, &random).expect("it reflects");
            assert_eq!(sample.is_delta, is_delta);
            assert_eq!(smooth.spreads(), !is_delta);
            assert_eq!(smooth.eval(outgoing, sample.incoming) == Color::ZERO, is_delta);
            assert_eq!(smooth.pdf(outgoing, sample.incoming) == 0.0, is_delta);
            assert!(smooth.check().is_ok() && smooth.reflects());
            assert_eq!(smooth.lambert().is_some(), !is_delta);
        }
    }

    #[test]
    fn each_calls_for_its_effect() {
        let effects = [MATTE, MIRROR, GLASS].map(|smooth| smooth.effect());
        assert_eq!(effects, [None, Some(Effect::MirrorReflection), Some(Effect::Refraction)]);
        assert!(!Smooth::BLACK.reflects());
        assert!(Smooth::matte(1.5, 0.0, 0.0).check().is_err());
    }
}
