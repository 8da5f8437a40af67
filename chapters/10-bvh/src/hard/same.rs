//! AC-01, AC-05 and AC-12: what a tree finds is what the linear scan finds.

use std::sync::LazyLock;

use boxes::aabb::Aabb;
use boxes::slab::BoxRay;
use common::sampler::Stream;
use common::tally::Off;
use partitions::accelerator::Accelerator;
use partitions::hard::rays::{KINDS, around, ray, t_max};
use partitions::hard::scenes::{Answer, Corners, SCENES, Scene, soup, with_garbage, with_holes};
use partitions::scan::Scan;
use ray_casting::ray::Ray;
use triangles::brute::Found;

use crate::build::Recipe;
use crate::naive;
use crate::packed::PackedBvh;
use crate::plain::{BothChildren, NearChildFirst, PlainBvh};
use crate::split::Split;

/// The same triangles in several trees.
struct Trees {
    packed: PackedBvh,
    midpoint: PackedBvh,
    ordered: NearChildFirst,
    both: BothChildren,
}

impl Trees {
    fn new(triangles: &[Corners]) -> Self {
        let recipe = |split, leaf| Recipe { split, leaf, ..Recipe::TRIANGLES };
        let plain = |split, leaf| PlainBvh::new(triangles, &recipe(split, leaf));
        Self {
            packed: PackedBvh::new(triangles, &Recipe::TRIANGLES),
            midpoint: PackedBvh::new(triangles, &recipe(Split::Midpoint, 1)),
            ordered: NearChildFirst(plain(Split::Median, 3)),
            both: BothChildren(plain(Split::Sah, 1)),
        }
    }

    /// Whether the packed tree says something else, or, in one trial of four, one of the others.
    fn differ(&self, trial: u64, ray: &Ray, t_max: f32, expected: Option<Found>) -> bool {
        let other = match trial % 12 {
            0 => Answer::of(&self.midpoint, ray, t_max),
            4 => Answer::of(&self.ordered, ray, t_max),
            8 => Answer::of(&self.both, ray, t_max),
            _ => return !Answer::of(&self.packed, ray, t_max).is(expected),
        };
        !(other.is(expected) && Answer::of(&self.packed, ray, t_max).is(expected))
    }

    /// What the report's traversal finds with this question to boxes.
    fn report(&self, ray: &Ray, meets: &dyn Fn(&Aabb) -> bool) -> Option<Found> {
        let tree = &self.both.0;
        tree.tree().nodes.first().and_then(|root| naive::get_intersection(tree, root, ray, meets))
    }
}

static TREES: LazyLock<Vec<Trees>> =
    LazyLock::new(|| SCENES.iter().map(|scene| Trees::new(&scene.triangles)).collect());

/// The scene and ray of a trial, and the limit for hits.
fn draw(trial: u64) -> Option<(&'static Scene, &'static Trees, Ray, f32)> {
    let mut stream = Stream::of_trial(1000, trial);
    let count = SCENES.len() as u64;
    let at = (trial % count) as usize;
    let ray = ray(&SCENES[at], trial / count % KINDS, &mut stream)?;
    let size = around(&SCENES[at]).size().max_element();
    Some((&SCENES[at], &TREES[at], ray, t_max(&mut stream, size)))
}

/// Whether a tree of the textbook's boxes finds a hit at another distance, or none.
pub(super) fn any_naive(trial: u64) -> bool {
    draw(trial).is_some_and(|(scene, trees, ray, _)| {
        let found = trees.report(&ray, &|bounds| naive::meets_slabs(bounds, &ray));
        let expected = scene.scan.nearest(&ray, f32::INFINITY, &mut Off);
        found.map(|it| it.hit.t) != expected.map(|it| it.hit.t)
    })
}

pub(super) fn any_robust(trial: u64) -> bool {
    draw(trial).is_some_and(|(scene, trees, ray, t_max)| {
        let expected = scene.scan.nearest(&ray, t_max, &mut Off);
        trees.differ(trial, &ray, t_max, expected)
    })
}

/// Triangles among others with corners that are NaN or infinite; the trees over all of them, and
/// the scan of the good ones alone.
static GARBAGE: LazyLock<Vec<(Scene, Trees, Scan)>> = LazyLock::new(|| {
    let scene = |count: u64| {
        let spoil = if count.is_multiple_of(2) { with_garbage } else { with_holes };
        let triangles = spoil(soup(count));
        let trees = Trees::new(&triangles);
        (Scene::new(triangles), trees, Scan::build(soup(count)))
    };
    (1..24).map(scene).collect()
});

fn among_garbage(trial: u64) -> Option<(&'static (Scene, Trees, Scan), Ray)> {
    let mut stream = Stream::of_trial(1005, trial);
    let these = &GARBAGE[(trial % GARBAGE.len() as u64) as usize];
    Some((these, ray(&these.0, trial % 4, &mut stream)?))
}

/// Whether a box around everything keeps a ray from a good triangle.
pub(super) fn garbage_naive(trial: u64) -> bool {
    among_garbage(trial).is_some_and(|((scene, _, good), ray)| {
        let bounds = naive::bounds(&scene.triangles);
        let is_hit = good.nearest(&ray, f32::INFINITY, &mut Off).is_some();
        is_hit && BoxRay::new(&ray, &bounds).enter(&bounds, f32::INFINITY).is_none()
    })
}

/// Whether a tree finds something else than a good triangle, at its place among the others.
pub(super) fn garbage_robust(trial: u64) -> bool {
    among_garbage(trial).is_some_and(|((_, trees, good), ray)| {
        let expected = good.nearest(&ray, f32::INFINITY, &mut Off);
        let expected = expected.map(|found| Found { index: 2 * found.index + 1, ..found });
        trees.differ(trial, &ray, f32::INFINITY, expected)
    })
}

/// Seven triangles, nine times each.
const COPIES: usize = 6;

fn at_copies(trial: u64) -> Option<(&'static Scene, &'static Trees, Ray)> {
    let mut stream = Stream::of_trial(1012, trial);
    let ray = ray(&SCENES[COPIES], trial % KINDS, &mut stream)?;
    Some((&SCENES[COPIES], &TREES[COPIES], ray))
}

/// Whether the report's choice between two children takes another of those in one place.
pub(super) fn ties_naive(trial: u64) -> bool {
    at_copies(trial).is_some_and(|(scene, trees, ray)| {
        let boxes = BoxRay::new(&ray, &trees.both.0.tree().bounds());
        let found = trees.report(&ray, &|bounds| boxes.enter(bounds, f32::INFINITY).is_some());
        let expected = scene.scan.nearest(&ray, f32::INFINITY, &mut Off);
        found.map(|it| it.index) != expected.map(|it| it.index)
    })
}

pub(super) fn ties_robust(trial: u64) -> bool {
    at_copies(trial).is_some_and(|(scene, trees, ray)| {
        let expected = scene.scan.nearest(&ray, f32::INFINITY, &mut Off);
        trees.differ(trial, &ray, f32::INFINITY, expected)
    })
}
