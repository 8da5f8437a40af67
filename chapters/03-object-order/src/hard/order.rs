//! RA-04: both orders name the same triangle, at the same depth.

use common::render::Pixel;
use common::sampler::Stream;
use common::tally::Off;
use glam::Vec3;
use ray_casting::camera::{Camera, View};
use triangles::mesh::Mesh;

use crate::fixed::Fixed;
use crate::fragment::Fragment;
use crate::image;
use crate::naive::affine_depth;
use crate::parity::{Judge, Verdict, close_depths};
use crate::project::Projection;
use crate::rasterizer::Rasterizer;
use crate::samples::{exact_position, position};

/// Some triangles, a camera, and a sample.
struct Sight {
    mesh: Mesh,
    camera: Camera,
    pixel: Pixel,
    offset: Fixed,
}

const WIDTH: u32 = 320;
const HEIGHT: u32 = 200;
const TRIANGLES: u32 = 3;

fn sight(trial: u64) -> Sight {
    let mut stream = Stream::of_trial(304, trial);
    let mut point = |most: f32| {
        Vec3::new(
            stream.between(-most, most),
            stream.between(-most, most),
            stream.between(-most, most),
        )
    };
    // The eye is among the triangles, so some of them reach behind it.
    let view = View { eye: point(1.0), target: point(0.5), up: point(1.0), vertical_fov: 65.0 };
    let positions = (0..3 * TRIANGLES).map(|_| point(2.0)).collect();
    let triangles = (0..TRIANGLES).map(|index| [3 * index, 3 * index + 1, 3 * index + 2]).collect();
    let mesh = Mesh { positions, triangles, ..Mesh::default() };
    let camera = Camera::new(&view, WIDTH, HEIGHT).expect("random points don't coincide");
    let pixel = Pixel { x: stream.bits() % WIDTH, y: stream.bits() % HEIGHT };
    let offset = Fixed { x: (stream.bits() % 256) as i32, y: (stream.bits() % 256) as i32 };
    Sight { mesh, camera, pixel, offset }
}

impl Sight {
    fn image(&self) -> Option<Fragment> {
        let place = position(self.pixel, self.offset);
        image::fragment(&self.mesh.all_corners(), &self.camera, place, &mut Off)
    }

    fn judge(&self) -> Judge<'_> {
        Judge::new(&self.mesh, &Projection::new(&self.camera))
    }
}

/// RA-04, robust.
pub(super) fn perspective_fails(trial: u64) -> bool {
    let sight = sight(trial);
    let rasterizer = Rasterizer::new::<true, Off>(&sight.mesh, &sight.camera, &mut Off);
    let object = rasterizer.at(sight.pixel, sight.offset);
    let (image, judge) = (sight.image(), sight.judge());
    let sample = exact_position(sight.pixel, sight.offset);
    match judge.judge(sample, object, image) {
        Verdict::Unjustified => true,
        Verdict::Same => object.is_some_and(|object| {
            // Near an edge the buffer holds the triangle's own limit; its plane says otherwise.
            let exact = judge.depth(object.triangle, sample);
            let inside = judge.edge_distance(object.triangle, sample) > 1.0 / 256.0;
            let right = |exact| close_depths(f64::from(object.depth), exact);
            inside && !exact.is_some_and(right)
        }),
        _ => false,
    }
}

/// RA-04, naive: the same coverage, with depth interpolated on the film.
pub(super) fn affine_fails(trial: u64) -> bool {
    let sight = sight(trial);
    let rasterizer = Rasterizer::new::<true, Off>(&sight.mesh, &sight.camera, &mut Off);
    let sample = exact_position(sight.pixel, sight.offset);
    let covering = rasterizer.covering(sight.pixel, sight.offset);
    let nearest = covering
        .map(|triangle| (triangle, affine_depth(rasterizer.corners(triangle), sample)))
        .min_by(|one, other| one.1.total_cmp(&other.1));
    let object = nearest.map(|(triangle, depth)| Fragment {
        triangle,
        depth: depth as f32,
        barycentric: Vec3::X,
    });
    let (image, judge) = (sight.image(), sight.judge());
    match judge.judge(sample, object, image) {
        Verdict::Unjustified => true,
        Verdict::Same => object.zip(image).is_some_and(|(object, image)| {
            !close_depths(f64::from(object.depth), f64::from(image.depth))
        }),
        _ => false,
    }
}
