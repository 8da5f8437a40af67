//! What textbooks print, and where it ends: kept as controls that must fail.

use common::film::Color;
use common::tally::{Counts, Tally};
use glam::Vec3;
use ray_casting::direction::unit;
use ray_casting::ray::Ray;
use ray_casting::shape::Hit;
use shadows::spawn::spawn;

use crate::iteration::MOST_WAITING;
use crate::limits::{Limits, Pending};
use crate::mirror::reflect;
use crate::scatter::Scatter;

// ANCHOR: radiance
/// The textbook's recursion: a surface's own light, and what its branches bring. It is right, and
/// needs a piece of the stack for each surface on the way.
///
/// Whitted, "An improved illumination model for shaded display" (CACM 23, 1980).
pub fn radiance<S: Scatter, T: Tally>(scene: &S, ray: &S::Ray, depth: u32, tally: &mut T) -> Color {
    let met = scene.scatter(ray, tally);
    let mut sum = met.light;
    if depth > 0 {
        for branch in met.branches.iter().flatten() {
            sum += branch.weight * radiance(scene, &branch.ray, depth - 1, tally);
        }
    }
    sum
}
// ANCHOR_END: radiance

/// The loop with `f32` throughput, for rays with one branch: each of `depth` products and sums is
/// rounded to 24 digits.
pub fn trace_in_single<S: Scatter, T: Tally>(
    scene: &S,
    ray: S::Ray,
    depth: u32,
    tally: &mut T,
) -> Color {
    let (mut sum, mut throughput) = (Color::ZERO, Color::ONE);
    let mut next = Some(ray);
    for _ in 0..=depth {
        let Some(ray) = next else { break };
        let met = scene.scatter(&ray, tally);
        sum += throughput * met.light;
        next = met.branches[0].map(|branch| branch.ray);
        throughput *= met.branches[0].map_or(Color::ZERO, |branch| branch.weight);
    }
    sum
}

/// How many mirrors it takes until an `f32` throughput is 0; None if it isn't after `most`.
pub fn mirrors_until_dark(mirror: f32, most: u32) -> Option<u32> {
    let mut throughput = 1.0;
    (1..=most).find(|_| {
        throughput *= mirror;
        throughput == 0.0
    })
}

/// How many branches wait at most when those of a surface are followed as they come, whichever
/// counts more.
pub fn most_waiting_in_order<S: Scatter>(limits: &Limits, scene: &S, ray: S::Ray) -> u64 {
    let mut counts = Counts::default();
    let mut waiting = vec![Pending::first(ray)];
    while let Some(current) = waiting.pop() {
        let branches = scene.scatter(&current.ray, &mut counts).branches;
        let followed = branches.iter().rev().flatten();
        let followed = followed.filter_map(|it| limits.follow(&current, it, &mut counts));
        waiting.extend(followed.map(Pending::copied));
        // The last one is followed at once.
        counts.count(MOST_WAITING, waiting.len().saturating_sub(1) as u64);
    }
    counts.of(MOST_WAITING)
}

/// A mirrored direction that nobody gives its length again.
pub fn drifting(incoming: Vec3, normal: Vec3) -> Vec3 {
    reflect(incoming, normal)
}

/// The ray of a mirror by the normal it is shaded with, wherever that one sends it.
pub fn unchecked(ray: &Ray, hit: &Hit) -> Option<Ray> {
    let direction = unit(reflect(ray.direction, hit.normal))?;
    Some(Ray { origin: spawn(hit, direction), direction })
}

// ANCHOR: origin
/// Where GAMES101's framework, the report's, lets the ray of a mirror start: `epsilon` from the
/// point, to the side that the ray does *not* go.
pub fn framework_origin(point: Vec3, normal: Vec3, direction: Vec3, epsilon: f32) -> Vec3 {
    if direction.dot(normal) < 0.0 { point + normal * epsilon } else { point - normal * epsilon }
}
// ANCHOR_END: origin

#[cfg(test)]
mod tests {
    use common::tally::Off;

    use super::{radiance, trace_in_single};
    use crate::facing::{Facing, series};
    use crate::tree::Tree;

    #[test]
    fn the_textbook_is_right_where_it_ends() {
        for seed in 0..20 {
            let tree = Tree { seed, branches: 2 };
            let exact = tree.exactly(Tree::ROOT, 8);
            let sum = radiance(&tree, &Tree::ROOT, 8, &mut Off).as_dvec3();
            assert!((sum - exact).abs().max_element() < 1e-6 * exact.max_element(), "seed {seed}");
        }
    }

    #[test]
    fn few_mirrors_are_no_trouble_for_f32() {
        let mirrors = Facing { light: 0.7, mirror: 0.6 };
        let exact = f64::from(0.7f32) * series(f64::from(0.6f32), 9);
        let sum = f64::from(trace_in_single(&mirrors, 0, 9, &mut Off).x);
        assert!((sum - exact).abs() < 1e-6, "{sum} {exact}");
    }
}
