//! AC-01, AC-05, AC-06, AC-10, AC-11 and BX-03: what a structure finds is what the linear scan finds.

use std::sync::LazyLock;

use boxes::slab::BoxRay;
use common::sampler::Stream;
use common::tally::Off;
use ray_casting::ray::Ray;
use triangles::brute::Found;

use super::rays::{KINDS, around, ray, t_max};
use super::scenes::{
    BSP, MEDIAN, SAH, SCENES, STRUCTURES, Scene, bits, soup, with_garbage, with_holes,
};
use crate::accelerator::Accelerator;
use crate::naive::{
    Stop, along_a_line, along_a_line_in_a_tree, bounds, octree_by_centroids, without_width,
};
use crate::octree::Octree;
use crate::scan::Scan;

/// The scene and ray of a trial, and the limit for hits.
fn draw(trial: u64) -> Option<(&'static Scene, Ray, f32)> {
    let mut stream = Stream::of_trial(900, trial);
    let count = SCENES.len() as u64;
    let scene = &SCENES[(trial % count) as usize];
    let ray = ray(scene, trial / count % KINDS, &mut stream)?;
    Some((scene, ray, t_max(&mut stream, around(scene).size().max_element())))
}

fn scanned(scene: &Scene, ray: &Ray) -> Option<Found> {
    scene.scan.nearest(ray, f32::INFINITY, &mut Off)
}

/// Whether a grid walked along a line, until the first hit, finds something else.
pub(super) fn any_naive(trial: u64) -> bool {
    draw(trial).is_some_and(|(scene, ray, _)| {
        let found = along_a_line(&scene.grid, &ray, Stop::AtFirstHit);
        bits(found) != bits(scanned(scene, &ray))
    })
}

/// Whether a structure, another one in each trial, finds something else.
pub(super) fn any_robust(trial: u64) -> bool {
    differs(trial, trial / (SCENES.len() as u64 * KINDS) % STRUCTURES)
}

/// Whether the structure with this number answers a trial's ray otherwise than the scan.
fn differs(trial: u64, structure: u64) -> bool {
    draw(trial).is_some_and(|(scene, ray, t_max)| {
        let expected = scene.scan.nearest(&ray, t_max, &mut Off);
        !scene.answer(structure, &ray, t_max).is(expected)
    })
}

/// A ray from outside or inside at an edge of a scene.
fn at_an_edge(trial: u64) -> Option<(&'static Scene, Ray)> {
    let mut stream = Stream::of_trial(903, trial);
    let count = SCENES.len() as u64;
    let scene = &SCENES[(trial % count) as usize];
    Some((scene, ray(scene, [1, 2, 3, 6][(trial / count % 4) as usize], &mut stream)?))
}

/// Whether the k-d tree finds something else when the ray has no width.
pub(super) fn edge_naive(trial: u64) -> bool {
    at_an_edge(trial).is_some_and(|(scene, ray)| {
        bits(without_width(&scene.sah, &ray)) != bits(scanned(scene, &ray))
    })
}

pub(super) fn edge_robust(trial: u64) -> bool {
    at_an_edge(trial).is_some_and(|(scene, ray)| {
        !scene.answer(SAH, &ray, f32::INFINITY).is(scanned(scene, &ray))
    })
}

/// Scenes of good triangles and others with corners that are NaN or infinite, and the scan of the
/// good ones alone.
static GARBAGE: LazyLock<Vec<(Scene, Scan)>> = LazyLock::new(|| {
    let scene = |count: u64| {
        let spoil = if count.is_multiple_of(2) { with_garbage } else { with_holes };
        (Scene::new(spoil(soup(count))), Scan::build(soup(count)))
    };
    (1..24).map(scene).collect()
});

/// The scene of a trial, the scan of what is good in it, and a ray.
fn among_garbage(trial: u64) -> Option<(&'static Scene, &'static Scan, Ray)> {
    let mut stream = Stream::of_trial(905, trial);
    let (scene, good) = &GARBAGE[(trial % GARBAGE.len() as u64) as usize];
    Some((scene, good, ray(scene, trial % 4, &mut stream)?))
}

/// Whether a box around everything keeps a ray from a good triangle.
pub(super) fn garbage_naive(trial: u64) -> bool {
    among_garbage(trial).is_some_and(|(scene, good, ray)| {
        let bounds = bounds(&scene.triangles);
        let is_hit = good.nearest(&ray, f32::INFINITY, &mut Off).is_some();
        is_hit && BoxRay::new(&ray, &bounds).enter(&bounds, f32::INFINITY).is_none()
    })
}

/// Whether a structure finds something else than a good triangle, at its place among the others.
pub(super) fn garbage_robust(trial: u64) -> bool {
    among_garbage(trial).is_some_and(|(scene, good, ray)| {
        let expected = good.nearest(&ray, f32::INFINITY, &mut Off);
        let expected = expected.map(|found| Found { index: 2 * found.index + 1, ..found });
        let structure = trial / GARBAGE.len() as u64 % STRUCTURES;
        !scene.answer(structure, &ray, f32::INFINITY).is(expected)
    })
}

/// A ray through a corner of a scene whose planes coincide with walls, in a plane across an axis.
fn in_plane(trial: u64) -> Option<(&'static Scene, Ray)> {
    let mut stream = Stream::of_trial(906, trial);
    let scene = &SCENES[2 + (trial % 2) as usize];
    Some((scene, ray(scene, 4 + trial / 2 % 2, &mut stream)?))
}

pub(super) fn in_plane_naive(trial: u64) -> bool {
    in_plane(trial).is_some_and(|(scene, ray)| {
        bits(along_a_line_in_a_tree(&scene.median, &ray)) != bits(scanned(scene, &ray))
    })
}

pub(super) fn in_plane_robust(trial: u64) -> bool {
    in_plane(trial).is_some_and(|(scene, ray)| {
        let tree = [MEDIAN, SAH, BSP][(trial / 4 % 3) as usize];
        !scene.answer(tree, &ray, f32::INFINITY).is(scanned(scene, &ray))
    })
}

/// A ray along an axis through a corner of a scene, its zeros of either sign.
fn along_an_axis(trial: u64) -> Option<(&'static Scene, Ray)> {
    let mut stream = Stream::of_trial(910, trial);
    let scene = &SCENES[1 + (trial % 3) as usize];
    Some((scene, ray(scene, 4, &mut stream)?))
}

pub(super) fn axis_naive(trial: u64) -> bool {
    along_an_axis(trial).is_some_and(|(scene, ray)| {
        let found = along_a_line(&scene.grid, &ray, Stop::AtHitInCell);
        bits(found) != bits(scanned(scene, &ray))
    })
}

/// Whether the grid's answer is another than the scan's, or another when -0 is made 0.
pub(super) fn axis_robust(trial: u64) -> bool {
    along_an_axis(trial).is_some_and(|(scene, ray)| {
        let positive = Ray { direction: ray.direction + 0.0, ..ray };
        let [found, again] =
            [ray, positive].map(|ray| scene.grid.nearest(&ray, f32::INFINITY, &mut Off));
        bits(found) != bits(scanned(scene, &ray)) || bits(again) != bits(found)
    })
}

/// The scenes whose triangles meet where cells do, by triangles' boxes and by their centroids.
static STRADDLING: LazyLock<Vec<[Octree; 2]>> = LazyLock::new(|| {
    let trees = |scene: &Scene| {
        [Octree::build(scene.triangles.clone()), octree_by_centroids(&scene.triangles)]
    };
    SCENES[2..4].iter().map(trees).collect()
});

/// Whether an octree, by boxes or by centroids, misses a triangle at a cell's corner.
fn straddler_is_missed(trial: u64, by_centroids: bool) -> bool {
    let mut stream = Stream::of_trial(911, trial);
    let which = (trial % 2) as usize;
    let scene = &SCENES[2 + which];
    ray(scene, 1 + trial / 2 % 5, &mut stream).is_some_and(|ray| {
        let tree = &STRADDLING[which][usize::from(by_centroids)];
        let found = tree.nearest(&ray, f32::INFINITY, &mut Off);
        bits(found) != bits(scanned(scene, &ray))
    })
}

pub(super) fn straddling_naive(trial: u64) -> bool {
    straddler_is_missed(trial, true)
}

pub(super) fn straddling_robust(trial: u64) -> bool {
    straddler_is_missed(trial, false)
}

#[cfg(test)]
mod tests {
    use common::hard::{Case, Row};

    use super::differs;
    use crate::hard::CASES;

    /// `cargo test --release -p partitions -- --ignored --nocapture ten_million` takes minutes.
    #[test]
    #[ignore = "takes minutes"]
    fn ten_million_rays_for_each_structure() {
        let structures: [fn(u64) -> bool; 5] = [
            |trial| differs(trial, 0),
            |trial| differs(trial, 1),
            |trial| differs(trial, 2),
            |trial| differs(trial, 3),
            |trial| differs(trial, 4),
        ];
        for (structure, robust_fails) in structures.into_iter().enumerate() {
            let case = Case { robust_fails, ..CASES[0] };
            let Row { naive_failures, robust_failures, trials, .. } = case.run(10_000_000);
            println!(
                "structure {structure}: {robust_failures} of {trials}, naive {naive_failures}"
            );
            assert_eq!(robust_failures, 0, "structure {structure}");
        }
    }
}
