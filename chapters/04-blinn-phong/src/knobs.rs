//! This chapter's own options.

use std::str::FromStr;

use common::chapter::Failure;
use common::film::Color;
use ray_casting::knobs::{Aim, Point};

use crate::light::{Light, LightError, STEADY};
use crate::material::BlinnPhong;
use crate::paint::Paint;
use crate::scene::Scene;
use crate::scenes::Stage;

/// The options of this chapter alone.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct Knobs {
    /// How light is returned
    #[arg(long, value_enum, default_value_t)]
    pub model: ModelChoice,
    /// Which terms of the sum are shown
    #[arg(long, value_enum, default_value_t)]
    pub term: Term,
    /// The exponent of every highlight, instead of the materials' own
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub shininess: Option<Amount>,
    /// Light from everywhere, instead of the scene's own
    #[arg(long, value_name = "LEVEL", allow_hyphen_values = true)]
    pub ambient: Option<Amount>,
    /// A white lamp at this place, instead of the scene's own lamps
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub lamp: Option<Point>,
    /// How the lamp's light falls off: at distance d it is divided by C + L d + Q d²
    #[arg(long, value_name = "C,L,Q", allow_hyphen_values = true, requires = "lamp")]
    pub falloff: Option<Point>,
    /// A white lamp far away in this direction, instead of the scene's own lamps
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub sun: Option<Point>,
    /// Where to look from.
    #[command(flatten)]
    pub aim: Aim,
}

/// A model of highlights.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum ModelChoice {
    /// None at all
    Lambert,
    /// Around the direction of the mirror
    Phong,
    /// By the half vector
    #[default]
    BlinnPhong,
    /// By the half vector, brighter where it is narrower
    Normalized,
    /// The report's equation 2-1 as it is printed
    Published,
}

/// A term of equation 2-1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Term {
    /// The sum
    #[default]
    All,
    /// Light from everywhere
    Ambient,
    /// Light from lamps, evenly returned
    Diffuse,
    /// Light from lamps, around the mirror
    Highlight,
}

impl Term {
    /// Takes the other terms out of a material.
    fn keep(self, material: &mut BlinnPhong) {
        const BLACK: Paint = Paint::Plain(Color::ZERO);
        let kept = |term| self == Self::All || self == term;
        if !kept(Self::Ambient) {
            material.ambient = BLACK;
        }
        if !kept(Self::Diffuse) {
            material.diffuse = BLACK;
        }
        if !kept(Self::Highlight) {
            (material.specular, material.shininess) = (Color::ZERO, 0.0);
        }
    }
}

impl Knobs {
    /// The stage as the options want it.
    ///
    /// # Errors
    /// A camera or a lamp that can't be.
    pub fn apply(&self, stage: Stage) -> Result<Stage, Failure> {
        let lamps = self.lamps().map_err(|error| Failure::Usage(format!("no light: {error}")))?;
        stage.changed(|scene| {
            self.aim.apply(&mut scene.view);
            if !lamps.is_empty() {
                scene.lights = lamps;
            }
            self.change_light(scene);
        })
    }

    fn change_light(&self, scene: &mut Scene<BlinnPhong>) {
        if let Some(Amount(level)) = self.ambient {
            scene.ambient = Color::splat(level);
        }
        for object in &mut scene.objects {
            if let Some(Amount(shininess)) = self.shininess {
                object.material.shininess = shininess;
            }
            self.term.keep(&mut object.material);
        }
    }

    /// The lamps that the options ask for.
    fn lamps(&self) -> Result<Vec<Light>, LightError> {
        let falloff = self.falloff.map_or(STEADY, |Point(falloff)| falloff.to_array());
        let lamp = |Point(position)| Light::Point { position, color: Color::ONE, falloff };
        let sun =
            self.sun.map(|Point(toward): Point| Light::far(toward, Color::ONE)).transpose()?;
        Ok(self.lamp.map(lamp).into_iter().chain(sun).collect())
    }
}

/// A finite number from 0 up on the command line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amount(pub f32);

impl FromStr for Amount {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim().parse::<f32>() {
            Ok(amount) if (0.0..=1e9).contains(&amount) => Ok(Self(amount)),
            _ => Err("that needs a number from 0 to 1000000000, such as 0.2 or 25".into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use common::chapter::Failure;
    use common::film::Color;
    use common::plan::Effect;
    use glam::Vec3;
    use ray_casting::knobs::Point;

    use super::{Amount, Knobs, Term};
    use crate::scenes::{Stage, brute_force};

    fn stage(knobs: &Knobs) -> Result<Stage, Failure> {
        knobs.apply(Stage::named("whitted", brute_force).expect("it is built in"))
    }

    #[test]
    fn amounts_good_and_bad() {
        assert_eq!(" 2.5".parse(), Ok(Amount(2.5)));
        for bad in ["", "-1", "nan", "inf", "1e10", "1e400", "many", "-0.001"] {
            assert!(bad.parse::<Amount>().is_err(), "{bad}");
        }
    }

    #[test]
    fn lamps_of_the_command_line_replace_the_scene_s() {
        let lamp = Some(Point(Vec3::new(1.0, 2.0, 3.0)));
        let knobs = Knobs { lamp, sun: lamp, ..Knobs::default() };
        assert_eq!(stage(&knobs).expect("good lamps").scene.lights.len(), 2);
        let bad = [
            Knobs { sun: Some(Point(Vec3::ZERO)), ..Knobs::default() },
            Knobs { lamp, falloff: Some(Point(Vec3::ZERO)), ..Knobs::default() },
            Knobs { lamp, falloff: Some(Point(Vec3::NEG_X)), ..Knobs::default() },
        ];
        for knobs in bad {
            let refused = stage(&knobs);
            assert!(matches!(refused, Err(Failure::Usage(text)) if text.contains("no light")));
        }
    }

    #[test]
    fn a_term_alone_calls_for_less() {
        let calls = |term| {
            let stage = stage(&Knobs { term, ..Knobs::default() }).expect("as above");
            let called = |effect| stage.calls.iter().any(|call| call.effect == effect);
            [Effect::LocalShading, Effect::Textures].map(called)
        };
        assert_eq!(calls(Term::All), [true, true]);
        assert_eq!(calls(Term::Highlight), [true, false], "highlights are white");
        assert_eq!(calls(Term::Ambient), [false, false], "there is no ambient light");
    }

    #[test]
    fn the_exponent_is_everybody_s() {
        let knobs =
            Knobs { shininess: Some(Amount(7.0)), ambient: Some(Amount(0.25)), ..Knobs::default() };
        let scene = stage(&knobs).expect("as above").scene;
        assert!(scene.objects.iter().all(|object| object.material.shininess == 7.0));
        assert_eq!(scene.ambient, Color::splat(0.25));
    }
}
