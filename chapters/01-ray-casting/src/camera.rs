//! The pinhole camera: which ray belongs to which point of the film.

use common::math;
use common::tally::Event;
use glam::{Vec2, Vec3};

use crate::direction::{cross, unit};
use crate::ray::Ray;

/// Rays that start at the eye.
pub const CAMERA_RAYS: Event = Event::new(1, 0, "camera_rays");

/// Where the eye is, where it looks, and how much it sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The eye: where every ray starts.
    pub eye: Vec3,
    /// A point in the middle of the picture.
    pub target: Vec3,
    /// Any direction that points up in the picture, but not along the line of sight.
    pub up: Vec3,
    /// The angle between the top and the bottom edge of the picture, in degrees, between 0 and 180.
    pub vertical_fov: f32,
}

/// A pinhole camera for a film of a given size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    eye: Vec3,
    frame: Frame,
    size: Vec2,
    tangent: f32,
}

/// The camera's own axes: three directions at right angles, each of length 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Towards the right edge of the picture.
    pub right: Vec3,
    /// Towards the top edge.
    pub up: Vec3,
    /// Into the picture.
    pub forward: Vec3,
}

/// Why there is no camera for a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CameraError {
    /// The eye and the target coincide, or one of them or their distance isn't finite.
    #[error("the eye and the point it looks at must be two different points, both finite")]
    NoForward,
    /// There is no telling which way is up.
    #[error("the up direction must not lie along the line of sight")]
    NoUp,
    /// No lens sees that much.
    #[error("the vertical field of view must lie between 0 and 180 degrees")]
    FieldOfView,
}

/// The sine of an angle that may be rounding and nothing else: each of two directions of length 1
/// is wrong by up to half of this.
const STRAIGHT_UP: f32 = 4.0 * f32::EPSILON;

impl Camera {
    // ANCHOR: new
    /// The camera at `view` with a film of `width` by `height` pixels.
    pub fn new(view: &View, width: u32, height: u32) -> Result<Self, CameraError> {
        // Half the picture's height, one unit before the eye.
        let tangent = math::tan(view.vertical_fov.to_radians() / 2.0);
        if !(view.vertical_fov > 0.0 && view.vertical_fov < 180.0 && tangent > 0.0) {
            return Err(CameraError::FieldOfView);
        }
        let forward = unit(view.target - view.eye).ok_or(CameraError::NoForward)?;
        let upright = unit(view.up).ok_or(CameraError::NoUp)?;
        let sideways = cross(forward, upright);
        if sideways.length() < STRAIGHT_UP {
            return Err(CameraError::NoUp);
        }
        let right = sideways / sideways.length();
        let frame = Frame { right, up: cross(right, forward), forward };
        Ok(Self { eye: view.eye, frame, size: Vec2::new(width as f32, height as f32), tangent })
    }
    // ANCHOR_END: new

    /// The same camera with a film of another size.
    pub fn with_film(self, width: u32, height: u32) -> Self {
        Self { size: Vec2::new(width as f32, height as f32), ..self }
    }

    // ANCHOR: ray
    /// The ray through a point of the film, in pixels from its top left corner.
    #[inline(always)]
    pub fn ray(&self, position: Vec2) -> Ray {
        let Frame { right, up, forward } = self.frame;
        let film = self.plane(position);
        let direction = film.x * right + film.y * up + forward;
        Ray { origin: self.eye, direction: direction / direction.length() }
    }

    /// A point of the film, in pixels, on the plane one unit before the eye: x to the right, y up.
    ///
    /// The differences are exact, so mirrored pixels have mirrored points to the bit.
    #[inline(always)]
    fn plane(&self, position: Vec2) -> Vec2 {
        let x = (2.0 * position.x - self.size.x) / self.size.y;
        let y = (self.size.y - 2.0 * position.y) / self.size.y;
        self.tangent * Vec2::new(x, y)
    }
    // ANCHOR_END: ray

    /// The eye.
    pub fn eye(&self) -> Vec3 {
        self.eye
    }

    /// The camera's axes.
    pub fn frame(&self) -> Frame {
        self.frame
    }

    /// Pixels across and down.
    pub fn size(&self) -> Vec2 {
        self.size
    }

    /// Half the height of the picture on the plane one unit before the eye: tan(field of view / 2).
    pub fn tangent(&self) -> f32 {
        self.tangent
    }
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::camera::rh::view::look_to_mat4;
    use glam::{Vec2, Vec3};

    use super::{Camera, CameraError, View};
    use crate::naive::report_ray;

    const VIEW: View = View {
        eye: Vec3::new(1.0, 2.0, 3.0),
        target: Vec3::new(-4.0, 1.0, -9.0),
        up: Vec3::Y,
        vertical_fov: 40.0,
    };

    const ULP: f32 = f32::EPSILON;

    fn assert_valid(camera: &Camera) {
        let frame = camera.frame();
        let axes = [frame.right, frame.up, frame.forward];
        for (index, axis) in axes.iter().enumerate() {
            assert!((axis.length() - 1.0).abs() <= 4.0 * ULP, "{frame:?}");
            assert!(axis.dot(axes[(index + 1) % 3]).abs() <= 4.0 * ULP, "{frame:?}");
        }
        // Right, up and backwards are a right-handed frame.
        assert!(frame.right.cross(frame.up).dot(frame.forward) < -0.99);
    }

    #[test]
    fn corners_by_hand() {
        // tan 45° = 1, and the film is twice as wide as high: its corner is at (-2, 1, -1).
        let view = View { eye: Vec3::ZERO, target: -Vec3::Z, up: Vec3::Y, vertical_fov: 90.0 };
        let camera = Camera::new(&view, 8, 4).expect("a good view");
        let corner = Vec3::new(-2.0, 1.0, -1.0).normalize();
        assert!((camera.ray(Vec2::ZERO).direction - corner).length() < 1e-6);
        assert!(
            (camera.ray(Vec2::new(8.0, 4.0)).direction * Vec3::new(1.0, 1.0, -1.0) + corner)
                .length()
                < 1e-6
        );
    }

    #[test]
    fn up_along_the_view_is_refused_where_glam_gives_nan() {
        let view = View { eye: Vec3::ZERO, target: Vec3::Y, up: Vec3::Y, vertical_fov: 60.0 };
        assert_eq!(Camera::new(&view, 4, 4), Err(CameraError::NoUp));
        assert!(look_to_mat4(Vec3::ZERO, Vec3::Y, Vec3::Y).is_nan(), "the naive form");
    }

    #[test]
    fn degenerate_views_are_refused() {
        let eye_on_target = View { target: VIEW.eye, ..VIEW };
        assert_eq!(Camera::new(&eye_on_target, 4, 3), Err(CameraError::NoForward));
        let nowhere = View { eye: Vec3::NAN, ..VIEW };
        assert_eq!(Camera::new(&nowhere, 4, 3), Err(CameraError::NoForward));
        let no_up = View { up: Vec3::ZERO, ..VIEW };
        assert_eq!(Camera::new(&no_up, 4, 3), Err(CameraError::NoUp));
        for vertical_fov in [0.0, -1.0, 180.0, 1e-45, 400.0, f32::NAN, f32::INFINITY] {
            let refused = Camera::new(&View { vertical_fov, ..VIEW }, 4, 3);
            assert_eq!(refused, Err(CameraError::FieldOfView), "{vertical_fov}");
        }
    }

    #[test]
    fn extreme_lenses_and_films_give_directions_of_length_1() {
        for vertical_fov in [1e-6, 0.01, 90.0, 179.9, 179.999] {
            for (width, height) in [(1, 1), (10_000, 1), (1, 10_000), (640, 480)] {
                let camera = Camera::new(&View { vertical_fov, ..VIEW }, width, height);
                let camera = camera.expect("a good view");
                assert_valid(&camera);
                let size = camera.size();
                for corner in [Vec2::ZERO, size, Vec2::new(size.x, 0.0), size / 3.0] {
                    let length = camera.ray(corner).direction.as_dvec3().length();
                    assert!((length - 1.0).abs() <= f64::from(2.0 * ULP), "{vertical_fov} {size}");
                }
                let difference = camera.ray(size / 2.0).direction - camera.frame().forward;
                assert!(difference.abs().max_element() <= 2.0 * ULP);
            }
        }
    }

    #[test]
    fn mirrored_pixels_have_mirrored_rays_to_the_bit() {
        let view = View { eye: VIEW.eye, target: VIEW.eye - Vec3::Z, ..VIEW };
        let camera = Camera::new(&view, 640, 427).expect("a good view");
        for trial in 0..100_000 {
            let mut stream = Stream::of_trial(15, trial);
            let pixel = (stream.uniform2() * camera.size()).floor() + Vec2::splat(0.5);
            let there = camera.ray(pixel).direction;
            let back = camera.ray(camera.size() - pixel).direction;
            assert_eq!(there * Vec3::new(-1.0, -1.0, 1.0), back, "{pixel}");
        }
    }

    /// Erratum 6: the report's camera is this one at the origin, and another anywhere else.
    #[test]
    fn the_report_is_right_at_the_origin_only() {
        for (eye, agrees) in [(Vec3::ZERO, true), (Vec3::new(0.0, 2.0, 0.0), false)] {
            let view = View { eye, target: eye - Vec3::Z, up: Vec3::Y, vertical_fov: 90.0 };
            let camera = Camera::new(&view, 1280, 960).expect("a good view");
            let furthest = (0..960).map(|row| {
                let position = Vec2::new(200.5, row as f32 + 0.5);
                let report = report_ray(position, camera.size(), eye, camera.tangent());
                (camera.ray(position).direction - report.direction).length()
            });
            let furthest = furthest.fold(0.0, f32::max);
            assert_eq!(furthest < 4.0 * ULP, agrees, "{eye}: {furthest}");
        }
    }
}
