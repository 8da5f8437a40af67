//! What accuracy costs: cracks against nanoseconds, and what the layout of the triangles does.

use std::hint::black_box;

use common::cost::{Experiment, Method, Plot, Table, no_note};
use common::sampler::Stream;
use glam::{Vec2, Vec3};
use ray_casting::camera::Camera;
use ray_casting::ray::Ray;
use ray_casting::shape::Shape;

use crate::brute::nearest;
use crate::bunny::bunny;
use crate::convert::Normals;
use crate::hard::aimed::{Aim, Closed, NEAR};
use crate::intersect::TriangleTest;
use crate::lanes::Packed;
use crate::mesh::Mesh;
use crate::naive::MollerTrumbore;
use crate::reference::DoubleRay;
use crate::scene::BUNNY_VIEW;
use crate::watertight::ShearedRay;

/// The chapter's experiments.
pub fn experiments() -> Vec<Experiment<'static>> {
    let layouts = bunny(Normals::Flat).ok().and_then(layouts);
    std::iter::once(cracks()).chain(layouts).collect()
}

/// Rays for counting cracks, of which there may be few.
const COUNTED: u64 = 200_000;
/// Rays for measuring time.
const TIMED: usize = 1000;

/// Ray-triangle tests: rays that slip through a closed mesh, against the time for one test.
fn cracks() -> Experiment<'static> {
    let mesh = &NEAR[1];
    let aims: Vec<Aim> =
        (0..COUNTED).filter_map(|trial| mesh.at_edge(&mut Stream::of_trial(22, trial))).collect();
    let rays: Vec<Ray> = aims.iter().take(TIMED).map(|aim| aim.ray).collect();
    let packed = Packed::new(mesh.corners.clone());
    let slipped = aims.iter().filter(|it| packed.nearest(&it.ray, f32::INFINITY).is_none());
    let four = Method {
        error: per_million(slipped.count(), aims.len()),
        ..method("watertight, four at a time", mesh.corners.len(), &rays, move |ray| {
            packed.nearest(ray, f32::INFINITY).map(|found| found.hit.t)
        })
    };
    Experiment {
        name: "cracks",
        title: "Ray-triangle tests: cracks against time",
        work_unit: "triangle tests",
        error_metric: "misses per million rays at edges of a closed mesh",
        plot: Plot::ErrorOverTime("misses per million rays"),
        methods: vec![
            one_by_one::<MollerTrumbore>("Möller-Trumbore, f32", mesh, &aims, &rays),
            one_by_one::<DoubleRay>("Möller-Trumbore, f64", mesh, &aims, &rays),
            one_by_one::<ShearedRay>("watertight", mesh, &aims, &rays),
            four,
        ],
        note: cracks_note,
    }
}

fn one_by_one<Test: TriangleTest>(
    label: &'static str,
    mesh: &'static Closed,
    aims: &[Aim],
    rays: &[Ray],
) -> Method<'static> {
    let slipped = aims.iter().filter(|aim| mesh.is_missed::<Test>(aim)).count();
    let run =
        |ray: &Ray| nearest::<Test>(&mesh.corners, ray, f32::INFINITY).map(|found| found.hit.t);
    Method {
        error: per_million(slipped, aims.len()),
        ..method(label, mesh.corners.len(), rays, run)
    }
}

fn per_million(part: usize, whole: usize) -> f64 {
    1e6 * part as f64 / whole as f64
}

/// A method that asks for the nearest hit of each ray among `triangles` triangles; its error is
/// still to be filled in.
fn method(
    label: &'static str,
    triangles: usize,
    rays: &[Ray],
    distance: impl Fn(&Ray) -> Option<f32> + 'static,
) -> Method<'static> {
    let rays = rays.to_vec();
    Method {
        label: label.into(),
        series: label,
        size: triangles as f64,
        work: (triangles * rays.len()) as u64,
        error: 0.0,
        run: Box::new(move || {
            for ray in &rays {
                black_box(distance(black_box(ray)));
            }
        }),
    }
}

fn cracks_note(table: &Table) -> String {
    let time =
        |label: &str| table.rows.iter().find(|row| row.label == label).map(|row| row.nanoseconds());
    match (time("watertight"), time("Möller-Trumbore, f32")) {
        (Some(ours), Some(theirs)) => {
            let ratio = ours / theirs;
            format!("The watertight test takes {ratio:.2} times the time of Möller and Trumbore's.")
        }
        _ => String::new(),
    }
}

/// Where the corners lie in memory, for the bunny's rays.
fn layouts(mesh: Mesh) -> Option<Experiment<'static>> {
    let camera = Camera::new(&BUNNY_VIEW, 28, 21).ok()?;
    let pixels = (0..21).flat_map(|y| (0..28).map(move |x| Vec2::new(x as f32, y as f32) + 0.5));
    let rays: Vec<Ray> = pixels.map(|position| camera.ray(position)).collect();
    let (corners, count) = (mesh.all_corners(), mesh.triangles.len());
    let packed = Packed::new(corners.clone());
    let side_by_side = corners.clone();
    let methods = vec![
        measured("by index", count, &rays, &corners, move |ray| {
            mesh.hit(ray, f32::INFINITY).map(|hit| hit.t)
        }),
        measured("corners side by side", count, &rays, &corners, move |ray| {
            nearest::<ShearedRay>(&side_by_side, ray, f32::INFINITY).map(|found| found.hit.t)
        }),
        measured("four at a time", count, &rays, &corners, move |ray| {
            packed.nearest(ray, f32::INFINITY).map(|found| found.hit.t)
        }),
    ];
    Some(Experiment {
        name: "layout",
        title: "The watertight test on the bunny: where the corners lie in memory",
        work_unit: "triangle tests",
        error_metric: "RMS relative error of t against f64",
        plot: Plot::ErrorOverTime("error of t (RMS, relative)"),
        methods,
        note: no_note,
    })
}

/// The method with its error against the f64 reference.
fn measured(
    label: &'static str,
    triangles: usize,
    rays: &[Ray],
    corners: &[[Vec3; 3]],
    distance: impl Fn(&Ray) -> Option<f32> + 'static,
) -> Method<'static> {
    let error = |ray: &Ray| {
        let exact = f64::from(nearest::<DoubleRay>(corners, ray, f32::INFINITY)?.hit.t);
        Some((f64::from(distance(ray)?) - exact) / exact)
    };
    let errors: Vec<f64> = rays.iter().filter_map(error).collect();
    let square = errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64;
    Method { error: square.sqrt(), ..method(label, triangles, rays, distance) }
}
