//! Four plates of metal that show four lamps.

use common::film::Color;
use fresnel::conductor::Metal;
use glam::Vec3;
use microfacets::finish::Finish;
use microfacets::rough::Rough;
use path_tracing::model::Model;
use path_tracing::part::{Form, Part};
use path_tracing::smooth::Smooth;
use ray_casting::camera::View;

// ANCHOR: plates
/// Plates and lamps as Veach and Guibas had them (1995, figure 2): each plate is tilted so that its
/// middle mirrors the lamps to the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plates {
    /// How rough the plates are, from the nearest to the farthest.
    pub roughness: [f32; 4],
    /// The radii of the lamps, from left to right. All send the same power.
    pub radii: [f32; 4],
}

impl Plates {
    /// The chapter's scene.
    pub const VEACH: Self =
        Self { roughness: [0.2, 0.08, 0.03, 0.008], radii: [1.0 / 30.0, 0.1, 0.3, 0.9] };
}
// ANCHOR_END: plates

/// Where the camera is.
const EYE: Vec3 = Vec3::new(0.0, 2.0, 15.0);
/// The middles of the plates, from the nearest to the farthest.
const MIDDLES: [Vec3; 4] = [
    Vec3::new(0.0, -3.908, 3.574),
    Vec3::new(0.0, -3.582, 2.223),
    Vec3::new(0.0, -3.063, 0.923),
    Vec3::new(0.0, -2.395, -0.135),
];
/// The lamps' places along x.
const ALONG: [f32; 4] = [-3.75, -1.25, 1.25, 3.75];
/// The tints of their light; each has a mean of 1, so that the powers are equal.
const TINTS: [Color; 4] = [
    Color::new(1.4, 1.0, 0.6),
    Color::new(0.6, 1.5, 0.9),
    Color::new(0.7, 0.9, 1.4),
    Color::new(1.5, 0.6, 0.9),
];

impl Plates {
    /// The scene.
    pub fn model(&self) -> Model<Finish> {
        let mut parts = room();
        parts.extend(
            MIDDLES.iter().zip(self.roughness).map(|(middle, alpha)| plate(*middle, alpha)),
        );
        parts.extend((0..4).map(|index| lamp(ALONG[index], self.radii[index], TINTS[index])));
        Model::new(parts, Color::ZERO, view(-2.16, 30.0))
    }

    /// The same seen from so near that no lamp is in sight, for those who measure: the edge of a lamp
    /// is noisy in all ways alike.
    pub fn close_up(&self) -> Model<Finish> {
        Model { view: view(-4.15, 15.0), ..self.model() }
    }
}

/// From the eye towards the height `y` in the lamps' plane.
fn view(y: f32, vertical_fov: f32) -> View {
    View { eye: EYE, target: Vec3::new(0.0, y, 0.0), up: Vec3::Y, vertical_fov }
}

/// A floor and a wall, both matte and dark.
fn room() -> Vec<Part<Finish>> {
    let grey: Finish = Smooth::matte(0.25, 0.25, 0.25).into();
    let [left, right, low, high] = [-12.0, 12.0, -4.3, 12.0];
    let [near, far] = [16.0, -4.0];
    let floor = [[left, near], [right, near], [right, far], [left, far]];
    let wall = [[left, low], [right, low], [right, high], [left, high]];
    vec![
        Part::dark(Form::quad(floor.map(|[x, z]| Vec3::new(x, low, z))), grey),
        Part::dark(Form::quad(wall.map(|[x, y]| Vec3::new(x, y, far))), grey),
    ]
}

/// A plate whose normal is half way between the directions to the eye and to the lamps.
fn plate(middle: Vec3, alpha: f32) -> Part<Finish> {
    let normal = ((EYE - middle).normalize() - middle.normalize()).normalize();
    let along = 4.0 * Vec3::X;
    let up = 0.5 * normal.cross(Vec3::X);
    let corners =
        [middle - along + up, middle + along + up, middle + along - up, middle - along - up];
    // Seen from the eye, counter-clockwise.
    let [a, b, c, d] = corners;
    Part::dark(Form::quad([a, d, c, b]), Rough::metal(Metal::SILVER, alpha).into())
}

fn lamp(x: f32, radius: f32, tint: Color) -> Part<Finish> {
    let form = Form::ball(Vec3::new(x, 0.0, 0.0), radius);
    Part::glowing(form, Smooth::BLACK.into(), tint / (radius * radius))
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use light_sampling::lamp::Way;
    use light_sampling::lights::{Choice, Lights};
    use path_tracing::part::Form;
    use path_tracing::stage::Stage;
    use triangles::surface::geometric_normal;

    use super::{EYE, Plates};

    #[test]
    fn plates_face_the_eye_and_mirror_the_lamps() {
        let model = Plates::VEACH.model();
        for part in &model.parts[2..6] {
            let Form::Triangles(triangles) = &part.form else { panic!("a plate") };
            let middle = (triangles[0][0] + triangles[0][2]) / 2.0;
            for corners in triangles {
                let normal = geometric_normal(corners).expect("an area");
                let view = (EYE - middle).normalize();
                assert!(normal.dot(view) > 0.0, "{middle}");
                let mirrored = 2.0 * normal.dot(view) * normal - view;
                assert!((mirrored - (Vec3::ZERO - middle).normalize()).length() < 1e-5);
            }
        }
    }

    #[test]
    fn all_lamps_have_the_same_power() {
        let stage = Stage::new(&Plates::VEACH.model()).expect("a scene");
        let lights = Lights::new(&stage.space, &stage.surfaces, Choice::Power, Way::SolidAngle);
        assert_eq!(lights.lamps().len(), 4);
        let power = lights.lamps()[0].power();
        assert!(lights.lamps().iter().all(|lamp| (lamp.power() / power - 1.0).abs() < 1e-5));
    }
}
