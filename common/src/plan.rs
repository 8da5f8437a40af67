//! The plan: the effects a scene calls for, those the program simulates, and why the rest are not.

use std::fmt;

/// Something light does that a picture can show or leave out.
///
/// `common` knows the names, so that an early chapter can say which later one teaches what its
/// scene asks for. What an effect is, its chapter teaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effect {
    /// What the camera sees first.
    PrimaryVisibility,
    /// Normals interpolated over a mesh.
    SmoothNormals,
    /// Triangles cut where they pass behind the eye.
    NearClipping,
    /// Diffuse and glossy light from lamps.
    LocalShading,
    /// Colours that vary over a surface.
    Textures,
    /// Points a lamp can't reach.
    HardShadows,
    /// Mirrors.
    MirrorReflection,
    /// Glass and water.
    Refraction,
    /// Lamps with an extent.
    AreaLights,
    /// Light by way of other surfaces.
    IndirectLight,
    /// Rough mirrors and rough glass.
    GlossyReflection,
    /// Light from all around the scene.
    EnvironmentLight,
}

impl Effect {
    /// The name in plans, `--json` and the book.
    pub fn name(self) -> &'static str {
        match self {
            Self::PrimaryVisibility => "primary visibility",
            Self::SmoothNormals => "smooth normals",
            Self::NearClipping => "near clipping",
            Self::LocalShading => "local shading",
            Self::Textures => "textures",
            Self::HardShadows => "hard shadows",
            Self::MirrorReflection => "mirror reflection",
            Self::Refraction => "refraction",
            Self::AreaLights => "area lights",
            Self::IndirectLight => "indirect light",
            Self::GlossyReflection => "glossy reflection",
            Self::EnvironmentLight => "environment light",
        }
    }

    /// The chapter that teaches it.
    pub fn taught_in(self) -> &'static str {
        match self {
            Self::PrimaryVisibility => "01-ray-casting",
            Self::SmoothNormals => "02-triangles",
            Self::NearClipping => "03-object-order",
            Self::LocalShading | Self::Textures => "04-blinn-phong",
            Self::HardShadows => "05-shadows",
            Self::MirrorReflection => "06-whitted",
            Self::Refraction => "07-fresnel",
            Self::IndirectLight | Self::EnvironmentLight => "12-path-tracing",
            Self::AreaLights => "13-light-sampling",
            Self::GlossyReflection => "15-microfacets",
        }
    }
}

impl fmt::Display for Effect {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.write_str(self.name())
    }
}

/// An effect that a scene's data call for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Call {
    /// What is called for.
    pub effect: Effect,
    /// The part of the scene that calls for it, such as "sphere 2 is glass".
    pub because: String,
}

/// An effect an integrator can simulate, and when it is not needed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Skill {
    /// What it can simulate.
    pub effect: Effect,
    /// What a scene that doesn't call for it lacks, such as "no mesh has vertex normals".
    pub unless: &'static str,
}

/// Which effects to simulate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "native", derive(clap::ValueEnum))]
pub enum Simulate {
    /// Those the scene calls for.
    #[default]
    Needed,
    /// All the program can do, asked for or not: the picture is the same, to the bit.
    All,
}

/// An effect that is left out.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Skipped {
    /// Its name.
    pub effect: &'static str,
    /// Why it is left out.
    pub why: String,
}

/// What will be simulated, what will not, and why.
#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Plan {
    /// Names of the effects that are simulated.
    pub simulated: Vec<&'static str>,
    /// The effects that are not, with reasons.
    pub skipped: Vec<Skipped>,
}

impl Plan {
    /// The plan for a scene that makes these `calls`, by an integrator with these `skills`.
    ///
    /// An effect that is called for and can't be done is skipped with the chapter that teaches it.
    pub fn new(calls: &[Call], skills: &[Skill], simulate: Simulate) -> Self {
        let mut plan = Self::default();
        for skill in skills {
            let called = calls.iter().any(|call| call.effect == skill.effect);
            if called || simulate == Simulate::All {
                plan.simulated.push(skill.effect.name());
            } else {
                plan.skip(skill.effect, format!("not called for: {}", skill.unless));
            }
        }
        for call in calls {
            if !skills.iter().any(|skill| skill.effect == call.effect) {
                let chapter = call.effect.taught_in();
                plan.skip(call.effect, format!("{}; taught in {chapter}", call.because));
            }
        }
        plan
    }

    /// Whether `effect` is simulated.
    pub fn simulates(&self, effect: Effect) -> bool {
        self.simulated.contains(&effect.name())
    }

    fn skip(&mut self, effect: Effect, why: String) {
        self.skipped.push(Skipped { effect: effect.name(), why });
    }
}

impl fmt::Display for Plan {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        writeln!(out, "simulated: {}", self.simulated.join(", "))?;
        for Skipped { effect, why } in &self.skipped {
            writeln!(out, "  skipped: {effect} ({why})")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Call, Effect, Plan, Simulate, Skill};

    const SKILLS: [Skill; 2] = [
        Skill { effect: Effect::PrimaryVisibility, unless: "the scene is empty" },
        Skill { effect: Effect::SmoothNormals, unless: "no mesh has vertex normals" },
    ];

    fn calls() -> [Call; 2] {
        [
            Call { effect: Effect::PrimaryVisibility, because: "it has objects".into() },
            Call { effect: Effect::Refraction, because: "sphere 2 is glass".into() },
        ]
    }

    #[test]
    fn needed_does_what_is_called_for_and_says_why_not_the_rest() {
        let plan = Plan::new(&calls(), &SKILLS, Simulate::Needed);
        let printed = "simulated: primary visibility\n  \
            skipped: smooth normals (not called for: no mesh has vertex normals)\n  \
            skipped: refraction (sphere 2 is glass; taught in 07-fresnel)\n";
        assert_eq!(plan.to_string(), printed);
        assert!(plan.simulates(Effect::PrimaryVisibility));
        assert!(!plan.simulates(Effect::SmoothNormals));
    }

    #[test]
    fn all_does_everything_the_integrator_can() {
        let plan = Plan::new(&calls(), &SKILLS, Simulate::All);
        assert_eq!(plan.simulated, ["primary visibility", "smooth normals"]);
        assert_eq!(plan.skipped.len(), 1, "refraction is beyond it");
    }
}
