//! From the world to the film: one matrix, and no division yet.

use glam::{DMat3, DVec2, DVec3, Vec3};
use ray_casting::camera::Camera;

// ANCHOR: film_point
/// A point before the division: `x` and `y` are its film coordinates times `w`.
///
/// `w` is the point's depth, how far it lies before the eye along the line of sight. Points behind
/// the eye have a negative one, and points beside it have 0. These are homogeneous coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilmPoint {
    /// Pixels from the left edge of the film, times `w`.
    pub x: f64,
    /// Pixels from the top edge, times `w`.
    pub y: f64,
    /// Depth, in units of the scene.
    pub w: f64,
}
// ANCHOR_END: film_point

impl FilmPoint {
    /// Where on the film the point appears, in pixels. Only for points before the eye (`w` > 0).
    pub fn divide(self) -> DVec2 {
        DVec2::new(self.x, self.y) / self.w
    }

    /// The three coordinates as a vector, for dot and cross products.
    pub fn vector(self) -> DVec3 {
        DVec3::new(self.x, self.y, self.w)
    }
}

impl From<DVec3> for FilmPoint {
    fn from(vector: DVec3) -> Self {
        Self { x: vector.x, y: vector.y, w: vector.z }
    }
}

/// What a camera does to points of the world: the opposite of its rays.
///
/// The arithmetic is `f64`. It is done once a vertex, not once a pixel, so it costs little, and both
/// orders then mean the same camera to far better than the 1/256 pixel of the fixed-point grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projection {
    eye: DVec3,
    film_from_world: DMat3,
}

impl Projection {
    // ANCHOR: matrix
    /// The projection that undoes the rays of `camera`.
    pub fn new(camera: &Camera) -> Self {
        let (frame, size) = (camera.frame(), camera.size().as_dvec2());
        let [right, up, forward] =
            [frame.right, frame.up, frame.forward].map(|axis| axis.as_dvec3());
        // Pixels that one unit of height takes up at depth 1.
        let scale = size.y / (2.0 * f64::from(camera.tangent()));

        // From film coordinates back to the world, column by column: what Camera::ray does.
        let world_from_film = DMat3::from_cols(
            right / scale,
            -up / scale,
            forward - right * (size.x / 2.0 / scale) + up * (size.y / 2.0 / scale),
        );
        Self { eye: camera.eye().as_dvec3(), film_from_world: world_from_film.inverse() }
    }

    /// The film coordinates of a point, times its depth.
    pub fn project(&self, point: Vec3) -> FilmPoint {
        (self.film_from_world * (point.as_dvec3() - self.eye)).into()
    }
    // ANCHOR_END: matrix
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::{Vec2, Vec3};
    use ray_casting::camera::{Camera, View};

    use super::Projection;

    fn camera(width: u32, height: u32) -> Camera {
        let view = View {
            eye: Vec3::new(3.0, -2.0, 7.0),
            target: Vec3::new(-1.0, 4.0, 0.5),
            up: Vec3::new(0.1, 1.0, 0.3),
            vertical_fov: 37.0,
        };
        Camera::new(&view, width, height).expect("a good view")
    }

    #[test]
    fn a_point_on_a_pixels_ray_projects_to_that_pixel() {
        let camera = camera(640, 360);
        let projection = Projection::new(&camera);
        for trial in 0..10_000 {
            let mut stream = Stream::of_trial(1, trial);
            let position = stream.uniform2() * Vec2::new(640.0, 360.0);
            let ray = camera.ray(position);
            let point = projection.project(ray.at(stream.between(0.1, 90.0)));
            // The f32 ray and the f32 point on it are what is inexact here.
            let error = (point.divide() - position.as_dvec2()).length();
            assert!(error < 1.0 / 512.0, "{position}: {error}");
            assert!(point.w > 0.0);
        }
    }

    #[test]
    fn depth_is_measured_along_the_line_of_sight() {
        let camera = camera(320, 500);
        let projection = Projection::new(&camera);
        let ray = camera.ray(Vec2::new(11.5, 402.5));
        let depth = ray.direction.dot(camera.frame().forward);
        for t in [-4.0, 0.0, 0.5, 60.0] {
            let found = projection.project(ray.at(t)).w;
            assert!((found - f64::from(t * depth)).abs() < 1e-5, "{t}: {found}");
        }
    }
}
