//! This chapter's own options.

use std::str::FromStr;

use glam::Vec3;

use crate::camera::View;
use crate::double::DoubleSphere;
use crate::naive::NaiveSphere;
use crate::picture::Show;
use crate::scene::SphereShape;

/// The options of this chapter alone.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct Knobs {
    /// What the picture shows of what was hit
    #[arg(long, value_enum, default_value_t)]
    pub view: Show,
    /// The formula for spheres
    #[arg(long, value_enum, default_value_t)]
    pub sphere: Formula,
    /// How pixels become rays
    #[arg(long, value_enum, default_value_t)]
    pub camera: Lens,
    /// Where to look from.
    #[command(flatten)]
    pub aim: Aim,
}

/// Where to look from, instead of the scene's own view.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
pub struct Aim {
    /// Where the eye is, instead of the scene's own place; it then looks along -z
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub eye: Option<Point>,
    /// The point in the middle of the picture
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub look_at: Option<Point>,
    /// The angle between the top and the bottom of the picture
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true)]
    pub fov: Option<Degrees>,
}

/// The formula for spheres.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Formula {
    /// The textbook's quadratic formula.
    Naive,
    /// The one that doesn't cancel.
    #[default]
    Stable,
    /// The textbook's, with twice the digits.
    F64,
}

impl Formula {
    /// Makes spheres into shapes that use this formula.
    pub fn shape(self) -> SphereShape {
        match self {
            Self::Naive => |sphere| Box::new(NaiveSphere(sphere)),
            Self::Stable => |sphere| Box::new(sphere),
            Self::F64 => |sphere| Box::new(DoubleSphere(sphere)),
        }
    }
}

/// How pixels become rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Lens {
    /// By the camera's own three axes.
    #[default]
    Frame,
    /// By the report's section 5.1, which forgets where the eye is.
    Report,
}

impl Aim {
    /// Moves the view to where the options say.
    pub fn apply(&self, view: &mut View) {
        if let Some(Point(eye)) = self.eye {
            *view = View { eye, target: eye - Vec3::Z, ..*view };
        }
        if let Some(Point(target)) = self.look_at {
            view.target = target;
        }
        if let Some(Degrees(vertical_fov)) = self.fov {
            view.vertical_fov = vertical_fov;
        }
    }
}

/// A point on the command line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point(pub Vec3);

impl FromStr for Point {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || "a point is three finite numbers, such as 0,1.5,-4".to_string();
        let numbers: Result<Vec<f32>, _> =
            text.split(',').map(|number| number.trim().parse()).collect();
        match numbers.as_deref() {
            Ok(&[x, y, z]) if Vec3::new(x, y, z).is_finite() => Ok(Self(Vec3::new(x, y, z))),
            _ => Err(wrong()),
        }
    }
}

/// An angle between 0 and 180 degrees on the command line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Degrees(pub f32);

impl FromStr for Degrees {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim().parse::<f32>() {
            Ok(angle) if 0.0 < angle && angle < 180.0 => Ok(Self(angle)),
            _ => Err("a field of view is a number of degrees between 0 and 180, such as 40".into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::{Degrees, Point};

    #[test]
    fn points_good_and_bad() {
        assert_eq!("-1, 5,1e1".parse(), Ok(Point(Vec3::new(-1.0, 5.0, 10.0))));
        for bad in ["", "1,2", "1,2,3,4", "nan,0,0", "0,inf,0", "1e400,0,0", "a,b,c", "1 2 3"] {
            assert!(bad.parse::<Point>().is_err(), "{bad}");
        }
    }

    #[test]
    fn angles_good_and_bad() {
        assert_eq!("90".parse(), Ok(Degrees(90.0)));
        for bad in ["", "0", "-0", "180", "-5", "nan", "inf", "1e400", "ninety"] {
            assert!(bad.parse::<Degrees>().is_err(), "{bad}");
        }
    }
}
