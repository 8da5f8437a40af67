//! Spheres in a tree, and rays that count whom they ask.

use boxes::aabb::Aabb;
use boxes::bounded::Bounded;
use boxes::slab::BoxRay;
use bvh::build::Recipe;
use bvh::tree::Bvh;
use common::sampler::Stream;
use glam::Vec3;
use ray_casting::ray::Ray;
use ray_casting::shape::Shape;
use ray_casting::sphere::Sphere;

use crate::{Ask, Hit};

/// So many spheres, made from a seed.
#[derive(Debug)]
pub(crate) struct Forest {
    pub(crate) spheres: u64,
    pub(crate) seed: u64,
}

/// The nearest hits of some rays, and how many spheres were asked.
#[derive(Debug, PartialEq)]
pub(crate) struct Found {
    pub(crate) hits: Vec<Hit>,
    pub(crate) asked: u32,
}

/// Whether some rays are blocked, and whether questions were asked that should not have been. A
/// reader sees these names.
#[derive(Debug, PartialEq)]
pub(crate) struct Blocked {
    blocked: Vec<bool>,
    asked_after_a_hit: bool,
    /// Of a sphere.
    asked_though_its_box_is_missed: bool,
}

/// How far the rays of exercise 10.4 go.
const T_MAX: f32 = 9.0;
/// More than enough to tell one answer from another.
const RAYS: u64 = 40;

type Nearest = fn(&Bvh, &BoxRay, Ask) -> Hit;
type IsHit = fn(&Bvh, &BoxRay, f32, Ask) -> bool;

impl Forest {
    fn all(&self) -> Vec<Sphere> {
        let next = |number| {
            let mut stream = Stream::of_trial(1013 + self.seed, number);
            let center = crate::point(&mut stream, Vec3::new(10.0, 8.0, 6.0));
            Sphere { center, radius: 0.1 + 0.5 * stream.uniform() }
        };
        (0..self.spheres).map(next).collect()
    }

    fn tree(&self) -> Bvh {
        Recipe::default().build(self.all().iter().map(Sphere::bounds))
    }

    /// Rays from outside through the middle, as often as not.
    fn rays(&self) -> Vec<Ray> {
        let next = |number| {
            let mut stream = Stream::of_trial(2013 + self.seed, number);
            let origin = Vec3::new(-4.0, 3.0, 5.0) + crate::point(&mut stream, Vec3::splat(2.0));
            let target = crate::point(&mut stream, Vec3::new(10.0, 8.0, 6.0));
            Ray::new(origin, target - origin)
        };
        (0..RAYS).filter_map(next).collect()
    }

    pub(crate) fn nearest(&self, nearest: Nearest) -> Found {
        let (spheres, tree, mut asked) = (self.all(), self.tree(), 0);
        let hit = |ray: &Ray| {
            let boxes = BoxRay::new(ray, &tree.bounds());
            nearest(&tree, &boxes, &mut |item, limit| {
                asked += 1;
                spheres[item as usize].hit(ray, limit).map(|hit| hit.t)
            })
        };
        Found { hits: self.rays().iter().map(hit).collect(), asked }
    }

    /// By asking all; those have to be asked whose boxes are entered before the hit.
    pub(crate) fn nearest_by_scan(&self) -> Found {
        let (spheres, mut asked) = (self.all(), 0);
        let hit = |ray: &Ray| {
            let each = (0..).zip(&spheres);
            let hits = each.filter_map(|(at, it)| Some((at, it.hit(ray, f32::INFINITY)?.t)));
            let hit = hits.min_by(|one, other| one.1.total_cmp(&other.1));
            let limit = hit.map_or(f64::INFINITY, |(_, t)| f64::from(t));
            let before = |it: &&Sphere| enter(&it.bounds(), ray).is_some_and(|at| at < limit);
            asked += spheres.iter().filter(before).count() as u32;
            hit
        };
        Found { hits: self.rays().iter().map(hit).collect(), asked }
    }

    pub(crate) fn blocked(&self, is_hit: IsHit) -> Blocked {
        let (spheres, tree) = (self.all(), self.tree());
        let (mut asked_after_a_hit, mut asked_though_its_box_is_missed) = (false, false);
        let blocked = |ray: &Ray| {
            let (boxes, mut hit) = (BoxRay::new(ray, &tree.bounds()), false);
            is_hit(&tree, &boxes, T_MAX, &mut |item, limit| {
                let sphere = &spheres[item as usize];
                asked_after_a_hit |= hit;
                asked_though_its_box_is_missed |=
                    boxes.enter(&sphere.bounds(), f32::INFINITY).is_none();
                let t = sphere.hit(ray, limit).map(|hit| hit.t);
                hit |= t.is_some();
                t
            })
        };
        let blocked = self.rays().iter().map(blocked).collect();
        Blocked { blocked, asked_after_a_hit, asked_though_its_box_is_missed }
    }

    pub(crate) fn blocked_by_scan(&self) -> Blocked {
        let spheres = self.all();
        let blocked = |ray: &Ray| spheres.iter().any(|it| it.hit(ray, T_MAX).is_some());
        let blocked = self.rays().iter().map(blocked).collect();
        Blocked { blocked, asked_after_a_hit: false, asked_though_its_box_is_missed: false }
    }
}

/// Where a ray enters a box, in `f64`.
fn enter(bounds: &Aabb, ray: &Ray) -> Option<f64> {
    let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let low = (bounds.min.as_dvec3() - origin) / direction;
    let high = (bounds.max.as_dvec3() - origin) / direction;
    let (enter, leave) = (low.min(high).max_element(), low.max(high).min_element());
    (enter <= leave && leave >= 0.0).then_some(enter.max(0.0))
}
