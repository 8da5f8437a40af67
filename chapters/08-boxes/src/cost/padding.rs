//! What a margin costs, and what is lost without it.

use std::hint::black_box;
use std::sync::Arc;

use common::cost::{Experiment, Method, Plot, no_note};

use crate::aabb::Aabb;
use crate::hard::aimed::{Aimed, anywhere, far_away, lattice, room, sliver};
use crate::naive::{PlainRay, ize, tavian_2022};
use crate::slab::BoxRay;

/// Rays of each kind.
const EACH: u64 = 40_000;
/// How many of the hits are timed.
const TIMED: usize = 4096;
/// How often a run asks all of those, to be long enough for a clock.
const REPEATS: u64 = 16;

/// What a ray and its triangle are drawn by.
const KINDS: [fn(u64) -> Aimed; 5] = [anywhere, room, far_away, lattice, sliver];

/// Rays that hit a triangle, and whether a test meets that triangle's box.
pub(super) fn experiment() -> Experiment<'static> {
    let aimed = KINDS.iter().flat_map(|draw| (0..EACH).map(draw));
    let hits: Arc<Vec<Aimed>> = Arc::new(aimed.filter(|aimed| aimed.hit().is_some()).collect());
    Experiment {
        name: "padding",
        title: "Margins of the slab test: hits that are lost because the triangle's box isn't met",
        work_unit: "box tests",
        error_metric: "lost hits per million, of rays at corners, edges and insides of triangles",
        plot: Plot::ErrorOverTime("lost hits per million"),
        methods: vec![
            form("no margin", &hits, tavian_2022),
            form("Ize's factor", &hits, ize),
            ready("reciprocals alone", &hits, |_scene| Aabb::EMPTY),
            ready("reciprocals and pad", &hits, |scene| scene),
        ],
        note: no_note,
    }
}

fn form<F>(label: &'static str, hits: &Arc<Vec<Aimed>>, meets: F) -> Method<'static>
where
    F: Fn(&PlainRay, &Aabb, f32) -> bool + Copy + 'static,
{
    let lost = hits.iter().filter(|aimed| aimed.is_lost_by(meets)).count();
    let rays: Vec<(PlainRay, Aabb)> =
        sample(hits).map(|aimed| (PlainRay::from(&aimed.ray), aimed.bounds())).collect();
    method(label, lost, hits.len(), rays, move |ray, bounds| meets(ray, bounds, f32::INFINITY))
}

/// Our test with the pad for a scene made of the true one; an empty scene needs no pad.
fn ready(label: &'static str, hits: &Arc<Vec<Aimed>>, scene: fn(Aabb) -> Aabb) -> Method<'static> {
    let prepare = |aimed: &Aimed| BoxRay::new(&aimed.ray, &scene(aimed.scene));
    let enter = |aimed: &&Aimed| prepare(aimed).enter(&aimed.bounds(), f32::INFINITY).is_none();
    let lost = hits.iter().filter(enter).count();
    let rays: Vec<(BoxRay, Aabb)> =
        sample(hits).map(|aimed| (prepare(aimed), aimed.bounds())).collect();
    let meets = |ray: &BoxRay, bounds: &Aabb| ray.enter(bounds, f32::INFINITY).is_some();
    method(label, lost, hits.len(), rays, meets)
}

/// Some of the hits, of all kinds.
fn sample(hits: &[Aimed]) -> impl Iterator<Item = &Aimed> {
    hits.iter().step_by((hits.len() / TIMED).max(1)).take(TIMED)
}

fn method<R: 'static>(
    label: &'static str,
    lost: usize,
    of: usize,
    rays: Vec<(R, Aabb)>,
    meets: impl Fn(&R, &Aabb) -> bool + 'static,
) -> Method<'static> {
    Method {
        label: label.into(),
        series: label,
        size: 1.0,
        work: REPEATS * rays.len() as u64,
        error: 1e6 * lost as f64 / of as f64,
        run: Box::new(move || {
            for _ in 0..REPEATS {
                let met = rays.iter().filter(|(ray, bounds)| meets(ray, bounds)).count();
                black_box(met);
            }
        }),
    }
}
