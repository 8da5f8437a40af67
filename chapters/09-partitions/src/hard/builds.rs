//! Lists of triangles that are hard on a builder: each build ends, within bounds that are stated here.

use common::sampler::Stream;
use common::tally::{Counts, Off};
use glam::Vec3;
use ray_casting::ray::Ray;
use triangles::brute::{Found, TRIANGLE_TESTS};

use super::rays::ray;
use super::scenes::{Corners, STRUCTURES, Scene, progression, soup, with_garbage};
use crate::accelerator::{Accelerator, MOST_COPIES, Statistics};
use crate::plane_tree;

/// Builds everything over the triangles, checks how much it takes, and asks some rays.
fn holds(triangles: Vec<Corners>, rays: u64) {
    let scene = Scene::new(triangles);
    let statistics = [
        scene.grid.statistics(),
        scene.octree.statistics(),
        scene.median.statistics(),
        scene.sah.statistics(),
        scene.bsp.statistics(),
    ];
    for it in statistics {
        let Statistics { triangles, left_out, references, nodes, depth, bytes } = it;
        assert!(references >= triangles - left_out, "{it:?}");
        assert!(it.copies() <= f64::from(MOST_COPIES), "{it:?}");
        assert!(depth <= plane_tree::DEEPEST, "{it:?}");
        // 40 bytes for a triangle stored, 20 at most for a node.
        assert!(bytes <= 40 * references + 20 * nodes + 4, "{it:?}");
        assert!(nodes <= 20 * references + 10, "{it:?}");
    }
    for trial in 0..rays {
        let mut stream = Stream::of_trial(930, trial);
        let Some(ray) = ray(&scene, trial % 10, &mut stream) else { continue };
        let expected = scene.scan.nearest(&ray, f32::INFINITY, &mut Off);
        for structure in 0..STRUCTURES {
            let answer = scene.answer(structure, &ray, f32::INFINITY);
            assert!(answer.is(expected), "structure {structure}: {ray:?}");
        }
    }
}

#[test]
fn none_one_and_only_bad_ones() {
    holds(Vec::new(), 0);
    holds(soup(1), 200);
    holds(vec![[Vec3::NAN; 3]; 10], 0);
    holds(vec![[Vec3::ZERO, Vec3::X, 3.0 * Vec3::X]; 10], 50);
    holds(vec![[Vec3::INFINITY, Vec3::X, Vec3::Y]; 3], 0);
}

/// AC-02: a hundred thousand times the same triangle.
#[test]
fn copies_of_one_triangle() {
    holds(vec![soup(1)[0]; 100_000], 3);
}

/// AC-04: each half as large as the one before, from 2^20 to 2^-100.
#[test]
fn a_progression() {
    holds(progression(), 500);
    holds(progression().into_iter().cycle().take(3000).collect(), 100);
}

/// AC-07: between floats that are neighbours, or nearly.
#[test]
fn a_scene_a_few_floats_wide() {
    for start in [1.0_f32, 1e6, 1e-38] {
        let at = |steps: u32| f32::from_bits(start.to_bits() + steps);
        let triangle = |number: u32| {
            let corner = |shift: u32| {
                Vec3::new(at((number + shift) % 3), at((number / 3 + 2 * shift) % 4), at(shift % 2))
            };
            [corner(0), corner(1), corner(2)]
        };
        holds((0..200).map(triangle).collect(), 200);
    }
}

/// The largest that are finite, with small ones between.
#[test]
fn the_largest_triangles() {
    let mut triangles = soup(100);
    let far = 3e38;
    triangles.push([
        Vec3::new(-far, -far, 0.0),
        Vec3::new(far, -far, 0.1),
        Vec3::new(0.0, far, 0.2),
    ]);
    holds(with_garbage(triangles), 300);
}

fn in_a_line(count: usize) -> Vec<Corners> {
    let step = Vec3::new(0.5, 0.0, 0.0);
    let first = [Vec3::ZERO, Vec3::new(0.4, 0.1, 0.0), Vec3::new(0.1, 0.3, 0.2)];
    (0..count).map(|number| first.map(|corner| corner + number as f32 * step)).collect()
}

/// Needles from end to end of the scene, side by side: no cut across them does any good.
fn needles(count: usize) -> Vec<Corners> {
    let along = |number: usize| {
        let y = 1e-3 * number as f32;
        [Vec3::new(0.0, y, 0.0), Vec3::new(1000.0, y, 1.0), Vec3::new(1000.0, y + 1e-3, 0.0)]
    };
    (0..count).map(along).collect()
}

#[test]
fn a_hundred_thousand_in_a_line_and_needles() {
    holds(in_a_line(100_000), 5);
    holds(needles(20_000), 20);
}

#[test]
#[ignore = "takes a minute and 2 GB"]
fn a_million_in_a_line() {
    holds(in_a_line(1_000_000), 3);
}

/// From whichever side a ray comes, it asks the few in front and not the many behind them.
#[test]
fn nearer_ones_come_first() {
    for octant in 0..8 {
        let sign = |axis: u32| if octant >> axis & 1 == 1 { -1.0 } else { 1.0 };
        let direction = Vec3::new(sign(0), 0.9 * sign(1), 1.1 * sign(2));
        let (across, up) = direction.any_orthonormal_pair();
        let sheet = |number: i32| {
            let middle = (number - 100) as f32 * direction;
            [middle + 3.0 * across, middle - 2.0 * across + 3.0 * up, middle - across - 3.0 * up]
        };
        let scene = Scene::new((0..200).map(sheet).collect());
        let ray = Ray { origin: -300.0 * direction, direction };
        let check = |name: &str, nearest: &dyn Fn(&mut Counts) -> Option<Found>| {
            let mut counts = Counts::default();
            assert_eq!(nearest(&mut counts).map(|found| found.index), Some(0));
            let tests = counts.of(TRIANGLE_TESTS);
            assert!(tests <= 60, "{name} asks {tests} along {direction}");
        };
        check("grid", &|counts| scene.grid.nearest(&ray, f32::INFINITY, counts));
        check("octree", &|counts| scene.octree.nearest(&ray, f32::INFINITY, counts));
        check("median", &|counts| scene.median.nearest(&ray, f32::INFINITY, counts));
        check("sah", &|counts| scene.sah.nearest(&ray, f32::INFINITY, counts));
        check("bsp", &|counts| scene.bsp.nearest(&ray, f32::INFINITY, counts));
    }
}
