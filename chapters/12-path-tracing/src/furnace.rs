//! Closed rooms whose light is known in closed form, whatever their shape.

use common::film::Color;
use glam::{Vec3, Vec3Swizzles};
use ray_casting::camera::View;

use crate::lambert::Lambert;
use crate::model::Model;
use crate::part::{Emission, Form, Part};
use crate::smooth::Smooth;

// ANCHOR: radiance
/// The radiance in a furnace after at most `depth` surfaces were left: 1 + a + a² + … with `depth` + 1
/// terms.
///
/// Each wall emits the radiance 1 and reflects the part a of what comes, the albedo. What comes is
/// what other walls send. So L = 1 + a L where nothing is cut off, and L = 1 / (1 - a).
pub fn radiance(albedo: f64, depth: u32) -> f64 {
    (0..=depth).fold(0.0, |beyond, _| 1.0 + albedo * beyond)
}
// ANCHOR_END: radiance

/// A cube from -1 to 1 whose walls emit the radiance 1.
pub fn cube(albedo: f32) -> Model<Smooth> {
    let mut triangles = Vec::new();
    let mut wall = |[a, b, c, d]: [Vec3; 4]| triangles.extend([[a, b, c], [a, c, d]]);
    for side in [-1.0, 1.0] {
        for turn in [|v: Vec3| v, |v: Vec3| v.yzx(), |v: Vec3| v.zxy()] {
            let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
            wall(corners.map(|[x, y]| turn(Vec3::new(x, y, side))));
        }
    }
    furnace(Form::Triangles(triangles), albedo)
}

/// A ball of radius 1 whose wall emits the radiance 1.
pub fn ball(albedo: f32) -> Model<Smooth> {
    furnace(Form::ball(Vec3::ZERO, 1.0), albedo)
}

fn furnace(form: Form, albedo: f32) -> Model<Smooth> {
    let emission = Emission { radiance: Color::ONE, both_sides: true };
    let part = Part { form, material: grey(albedo), emission };
    Model::new(vec![part], Color::ZERO, view())
}

fn grey(albedo: f32) -> Smooth {
    Smooth::Lambert(Lambert { reflectance: Color::splat(albedo) })
}

/// From off the middle, so that no two ways to a wall are alike.
fn view() -> View {
    let eye = Vec3::new(0.1, -0.2, 0.3);
    View { eye, target: eye - Vec3::Z, up: Vec3::Y, vertical_fov: 60.0 }
}

/// The part of all that a point of the shell's wall sees which is the lamp, each direction counted
/// with its cosine: the square of the radii's ratio.
pub const LAMP_SHARE: f64 = 0.25;

/// A black ball of radius 1 that emits the radiance 1, in the middle of a dark one of radius 2.
pub fn shell(albedo: f32) -> Model<Smooth> {
    let wall = Part::dark(Form::ball(Vec3::ZERO, 2.0), grey(albedo));
    let lamp = Part::glowing(Form::ball(Vec3::ZERO, 1.0), Smooth::BLACK, Color::ONE);
    let eye = Vec3::new(1.5, 0.25, -0.125);
    let view = View { eye, target: eye + Vec3::X, up: Vec3::Y, vertical_fov: 60.0 };
    Model::new(vec![wall, lamp], Color::ZERO, view)
}

// ANCHOR: shell
/// The radiance of the shell's wall after at most `depth` surfaces were left.
///
/// Of what a wall's point sees, the part F is the lamp and the rest is wall: B = a (F + (1 - F) B).
pub fn shell_radiance(albedo: f64, depth: u32) -> f64 {
    (0..depth).fold(0.0, |wall, _| albedo * (LAMP_SHARE + (1.0 - LAMP_SHARE) * wall))
}
// ANCHOR_END: shell

#[cfg(test)]
mod tests {
    use super::{ball, cube, radiance, shell, shell_radiance};
    use crate::stage::Stage;

    #[test]
    fn the_series_is_the_closed_form() {
        for albedo in [0.0, 0.5, 0.8, 0.9, 0.99] {
            for depth in [0, 1, 2, 8, 50] {
                let closed = (1.0 - libm::pow(albedo, f64::from(depth) + 1.0)) / (1.0 - albedo);
                assert!((radiance(albedo, depth) - closed).abs() < 1e-12 * closed);
            }
        }
        assert_eq!(radiance(1.0, 7), 8.0, "white walls: one more for each surface");
    }

    #[test]
    fn the_page_s_worked_number() {
        // Albedo 0.5 and at most two surfaces: 1 + 0.5 + 0.25, an eighth less than 2.
        assert_eq!(radiance(0.5, 2), 1.75);
        assert!((radiance(0.5, 60) - 2.0).abs() < 1e-15);
    }

    #[test]
    fn the_shell_s_series_tends_to_its_fixed_point() {
        // B = 0.8 (0.25 + 0.75 B): 0.4 B = 0.2.
        assert!((shell_radiance(0.8, 100) - 0.5).abs() < 1e-15);
        assert_eq!(shell_radiance(0.8, 0), 0.0);
        assert_eq!(shell_radiance(0.5, 1), 0.125, "the lamp alone, half reflected");
    }

    #[test]
    fn all_three_can_be_drawn() {
        for model in [cube(0.5), ball(1.0), shell(0.8)] {
            assert!(Stage::new(&model).is_ok());
        }
    }
}
