//! What exact edge functions cost.

use std::hint::black_box;
use std::rc::Rc;

use common::cost::{Experiment, Method, Plot, no_note};
use glam::Vec2;

use crate::edge::{covers, edges};
use crate::fixed::Fixed;
use crate::hard::{Fan, fan};
use crate::naive::float_covers;
use crate::reference::wide_covers;

/// Samples on shared edges, each asked of four triangles.
const SAMPLES: u64 = 40_000;

/// Edge functions in f32, in fixed point with i64, and in i128.
pub(super) fn experiment() -> Experiment<'static> {
    let fans: Rc<Vec<Fan>> = Rc::new((0..SAMPLES).map(fan).collect());
    let snapped: Rc<Vec<Snapped>> = Rc::new(fans.iter().map(Snapped::new).collect());
    let method = |label: &'static str, owners: Box<dyn Fn() -> Vec<usize>>| Method {
        label: label.into(),
        series: label,
        size: 0.0,
        work: SAMPLES * 4,
        error: owners().iter().filter(|&&count| count != 1).count() as f64 / SAMPLES as f64,
        run: Box::new(move || drop(black_box(owners()))),
    };
    let wide = Rc::clone(&snapped);
    Experiment {
        name: "edges",
        title: "Edge functions, for samples on shared edges",
        work_unit: "triangle and sample pairs",
        error_metric: "share of samples owned by no triangle or by two",
        plot: Plot::ErrorOverTime("share of samples"),
        methods: vec![
            method(
                "f32, not snapped",
                Box::new(move || {
                    let owns =
                        |fan: &Fan, triangle: &&[Vec2; 3]| float_covers(**triangle, fan.sample);
                    fans.iter()
                        .map(|fan| {
                            fan.triangles.iter().filter(|triangle| owns(fan, triangle)).count()
                        })
                        .collect()
                }),
            ),
            method(
                "i64, 24.8 fixed point",
                Box::new(move || {
                    count(&snapped, |triangle, sample| {
                        edges(triangle).is_some_and(|edges| covers(&edges, sample))
                    })
                }),
            ),
            method("i128, 24.8 fixed point", Box::new(move || count(&wide, wide_covers))),
        ],
        note: no_note,
    }
}

/// A fan on the grid.
struct Snapped {
    triangles: [[Fixed; 3]; 4],
    sample: Fixed,
}

impl Snapped {
    fn new(fan: &Fan) -> Self {
        let snap = |point: Vec2| Fixed::snap(point.as_dvec2());
        Self { triangles: fan.triangles.map(|corners| corners.map(snap)), sample: snap(fan.sample) }
    }
}

fn count(fans: &[Snapped], owns: impl Fn([Fixed; 3], Fixed) -> bool) -> Vec<usize> {
    let owners = |fan: &Snapped| {
        fan.triangles.iter().filter(|&&triangle| owns(triangle, fan.sample)).count()
    };
    fans.iter().map(owners).collect()
}
