//! Both orders, against the number of triangles and against the number of pixels.

use std::hint::black_box;
use std::rc::Rc;

use common::cost::{Experiment, Method, Plot};
use common::tally::Off;
use glam::{Vec2, Vec3};
use ray_casting::camera::{Camera, View};
use triangles::brute::nearest;
use triangles::bumpy;
use triangles::mesh::Mesh;
use triangles::reference::DoubleRay;

use super::crossing::sentence;
use crate::fragment::Fragment;
use crate::image;
use crate::rasterizer::Rasterizer;

const OBJECT: &str = "object order";
const IMAGE: &str = "image order";
const ERROR: &str = "share of pixels whose triangle is not that of an f64 ray";

/// Time against triangles, on a small film.
pub(super) fn triangles() -> Experiment<'static> {
    let sizes = [100, 1_000, 10_000, 100_000];
    let methods = sizes.into_iter().flat_map(|count| {
        let sight = Rc::new(Sight::new(count, 32, 24));
        let size = f64::from(count);
        [
            sight.object(size, format!("{OBJECT}, {count} triangles")),
            sight.image(size, format!("{IMAGE}, {count} triangles")),
        ]
    });
    Experiment {
        name: "triangles",
        title: "One small picture (32x24), more and more triangles",
        work_unit: "triangles projected or tested",
        error_metric: ERROR,
        plot: Plot::TimeOver("triangles"),
        methods: methods.collect(),
        note: |table| sentence(table, OBJECT, IMAGE),
    }
}

/// Time against pixels, for one mesh. Above 64x64 the ray caster would take minutes.
pub(super) fn pixels() -> Experiment<'static> {
    let sizes = [1_u32, 2, 4, 8, 16, 32, 64, 256];
    let methods = sizes.into_iter().flat_map(|side| {
        let sight = Rc::new(Sight::new(10_000, side, side));
        let size = f64::from(side) * f64::from(side);
        let object = sight.object(size, format!("{OBJECT}, {side}x{side}"));
        let image = (side <= 64).then(|| sight.image(size, format!("{IMAGE}, {side}x{side}")));
        [Some(object), image].into_iter().flatten()
    });
    Experiment {
        name: "pixels",
        title: "10,000 triangles, more and more pixels",
        work_unit: "triangles projected or tested",
        error_metric: ERROR,
        plot: Plot::TimeOver("pixels"),
        methods: methods.collect(),
        note: |table| sentence(table, OBJECT, IMAGE),
    }
}

/// A bumpy sphere that fills most of a film.
struct Sight {
    mesh: Mesh,
    corners: Vec<[Vec3; 3]>,
    camera: Camera,
    /// Which triangle each pixel sees, by f64 rays; empty for a film too large for that.
    truth: Vec<Option<u32>>,
}

const VIEW: View = View {
    eye: Vec3::new(0.6, 1.2, 3.2),
    target: Vec3::new(0.03, 0.02, 0.0),
    up: Vec3::Y,
    vertical_fov: 42.0,
};

impl Sight {
    fn new(triangles: u32, width: u32, height: u32) -> Self {
        let mesh = bumpy::sphere(triangles);
        let corners = mesh.all_corners();
        let camera = Camera::new(&VIEW, width, height).expect("a good view");
        let truth = if width <= 64 { exact(&corners, &camera) } else { Vec::new() };
        Self { mesh, corners, camera, truth }
    }

    fn object(self: &Rc<Self>, size: f64, label: String) -> Method<'static> {
        let sight = Rc::clone(self);
        let draw = move || {
            let camera = &sight.camera;
            Rasterizer::new::<false, Off>(&sight.mesh, camera, &mut Off).fragments(&mut Off)
        };
        let (work, error) = (self.corners.len() as u64, self.error(&draw()));
        let run = Box::new(move || drop(black_box(draw())));
        Method { label, series: OBJECT, size, work, error, run }
    }

    fn image(self: &Rc<Self>, size: f64, label: String) -> Method<'static> {
        let sight = Rc::clone(self);
        let draw = move || image::fragments(&sight.corners, &sight.camera, &mut Off);
        let work = self.corners.len() as u64 * self.truth.len() as u64;
        let error = self.error(&draw());
        let run = Box::new(move || drop(black_box(draw())));
        Method { label, series: IMAGE, size, work, error, run }
    }

    /// The share of pixels that see another triangle than the truth's.
    fn error(&self, found: &[Option<Fragment>]) -> f64 {
        let ids = found.iter().map(|fragment| fragment.map(|fragment| fragment.triangle));
        let wrong = ids.zip(&self.truth).filter(|(found, truth)| found != *truth).count();
        wrong as f64 / self.truth.len().max(1) as f64
    }
}

/// The triangle each pixel's centre sees, by rays in `f64`.
fn exact(corners: &[[Vec3; 3]], camera: &Camera) -> Vec<Option<u32>> {
    let size = camera.size();
    let (width, height) = (size.x as u32, size.y as u32);
    let centres = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let see = |(x, y): (u32, u32)| {
        let ray = camera.ray(Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
        nearest::<DoubleRay>(corners, &ray, f32::INFINITY).map(|found| found.index as u32)
    };
    centres.map(see).collect()
}
