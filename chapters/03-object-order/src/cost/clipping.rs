//! What it saves to leave out clipping where no triangle needs it.

use std::hint::black_box;
use std::rc::Rc;

use common::cost::{Experiment, Method, Plot, no_note};
use common::tally::Off;
use glam::Vec3;
use ray_casting::camera::{Camera, View};
use triangles::bumpy;
use triangles::mesh::Mesh;

use crate::project::Projection;
use crate::setup::{Prepared, prepare};

const SIZE: [u32; 2] = [320, 240];

const VIEW: View = View {
    eye: Vec3::new(0.6, 1.2, 3.2),
    target: Vec3::new(0.03, 0.02, 0.0),
    up: Vec3::Y,
    vertical_fov: 42.0,
};

/// Preparing meshes that lie before the eye, with and without a look at the clip volume.
pub(super) fn experiment() -> Experiment<'static> {
    let camera = Camera::new(&VIEW, SIZE[0], SIZE[1]).expect("a good view");
    let projection = Projection::new(&camera);
    let methods = [1_000, 10_000, 100_000].into_iter().flat_map(|count| {
        let mesh = Rc::new(bumpy::sphere(count));
        let exact = prepare::<true, Off>(&mesh, &projection, SIZE, &mut Off);
        let method = |series: &'static str, prepare: fn(&Mesh, &Projection) -> Prepared| {
            let mesh = Rc::clone(&mesh);
            let found = prepare(&mesh, &projection);
            let same = found.pieces.iter().zip(&exact.pieces).filter(|(one, other)| one == other);
            Method {
                label: format!("{series}, {count} triangles"),
                series,
                size: f64::from(count),
                work: u64::from(count),
                error: 1.0 - same.count() as f64 / exact.pieces.len() as f64,
                run: Box::new(move || drop(black_box(prepare(&mesh, &projection)))),
            }
        };
        [
            method("needed", |mesh, to| prepare::<false, Off>(mesh, to, SIZE, &mut Off)),
            method("all", |mesh, to| prepare::<true, Off>(mesh, to, SIZE, &mut Off)),
        ]
    });
    Experiment {
        name: "clipping",
        title: "Preparing triangles that need no clipping",
        work_unit: "triangles",
        error_metric: "share of triangles prepared differently",
        plot: Plot::TimeOver("triangles"),
        methods: methods.collect(),
        note: no_note,
    }
}
