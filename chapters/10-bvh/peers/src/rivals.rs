//! The trees, behind one door.

use std::time::Duration;

use bvh_chapter::build::Recipe;
use bvh_chapter::packed::PackedBvh;
use common::tally::Off;
use glam::{Vec3, Vec3A};
use nalgebra::{Point3, Vector3};
use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::ray::RayHit;
use obvhs::rt_triangle::RtTriangle;
use obvhs::triangle::Triangle;
use partitions::accelerator::Accelerator;
use peer::aabb::{Aabb, Bounded, IntersectsAabb};
use peer::bounding_hierarchy::{BHShape, BoundingHierarchy};
use std::cell::Cell;

use crate::rays::Limited;

/// A tree over triangles.
pub trait Rival: Sized {
    /// What it is called.
    const NAME: &'static str;
    /// Builds it, ready to be asked.
    fn build(corners: &[[Vec3; 3]]) -> Self;
    /// How far the nearest hit is; infinite for none.
    fn nearest(&self, ray: &Limited) -> f32;
    /// Whether there is any hit.
    fn any(&self, ray: &Limited) -> bool;
    /// The bytes it takes, triangles included.
    fn bytes(&self) -> usize;
}

/// This chapter's.
pub struct Ours {
    /// The tree.
    pub tree: PackedBvh,
}

impl Rival for Ours {
    const NAME: &'static str = "ours";

    fn build(corners: &[[Vec3; 3]]) -> Self {
        Self { tree: PackedBvh::new(corners, &Recipe::TRIANGLES) }
    }

    #[inline]
    fn nearest(&self, ray: &Limited) -> f32 {
        self.tree.nearest(&ray.ray, ray.t_max, &mut Off).map_or(f32::INFINITY, |found| found.hit.t)
    }

    #[inline]
    fn any(&self, ray: &Limited) -> bool {
        self.tree.is_hit(&ray.ray, ray.t_max, &mut Off)
    }

    fn bytes(&self) -> usize {
        self.tree.statistics().bytes
    }
}

/// `obvhs`: a binary tree, built with its medium settings.
pub struct Obvhs {
    tree: Bvh2,
    triangles: Vec<RtTriangle>,
}

impl Rival for Obvhs {
    const NAME: &'static str = "obvhs 0.4, Bvh2, medium build";

    fn build(corners: &[[Vec3; 3]]) -> Self {
        let triangles: Vec<Triangle> = corners
            .iter()
            .map(|corners| corners.map(Vec3A::from))
            .map(|[v0, v1, v2]| Triangle { v0, v1, v2 })
            .collect();
        let mut spent = Duration::default();
        let tree = build_bvh2_from_tris(&triangles, BvhBuildParams::medium_build(), &mut spent);
        let in_order = tree.primitive_indices.iter();
        let triangles = in_order.map(|&at| RtTriangle::from(&triangles[at as usize])).collect();
        Self { tree, triangles }
    }

    #[inline]
    fn nearest(&self, ray: &Limited) -> f32 {
        let mut hit = RayHit::none();
        self.tree
            .ray_traverse(obvhs_ray(ray), &mut hit, |ray, at| self.triangles[at].intersect(ray));
        if hit.primitive_id == u32::MAX { f32::INFINITY } else { hit.t }
    }

    #[inline]
    fn any(&self, ray: &Limited) -> bool {
        !self.tree.ray_traverse_miss(obvhs_ray(ray), |ray, at| self.triangles[at].intersect(ray))
    }

    fn bytes(&self) -> usize {
        size_of_val(&self.tree.nodes[..])
            + size_of_val(&self.tree.primitive_indices[..])
            + size_of_val(&self.triangles[..])
    }
}

#[inline]
fn obvhs_ray(ray: &Limited) -> obvhs::ray::Ray {
    obvhs::ray::Ray::new(ray.ray.origin.into(), ray.ray.direction.into(), 0.0, ray.t_max)
}

/// `bvh`: asked through a box test that prunes by the nearest hit so far.
pub struct Svenstaro {
    tree: peer::bvh::Bvh<f32, 3>,
    shapes: Vec<Corners>,
}

struct Corners {
    corner: Vec3,
    edges: [Vec3; 2],
    bounds: Aabb<f32, 3>,
    node: usize,
}

impl Bounded<f32, 3> for Corners {
    fn aabb(&self) -> Aabb<f32, 3> {
        self.bounds
    }
}

impl BHShape<f32, 3> for Corners {
    fn set_bh_node_index(&mut self, index: usize) {
        self.node = index;
    }
    fn bh_node_index(&self) -> usize {
        self.node
    }
}

/// A ray that prunes by the nearest hit so far, which the crate's own rays don't.
struct Pruning {
    origin: Vec3,
    inverse: Vec3,
    limit: Cell<f32>,
}

impl IntersectsAabb<f32, 3> for Pruning {
    #[inline]
    fn intersects_aabb(&self, bounds: &Aabb<f32, 3>) -> bool {
        let (mut enter, mut leave) = (0.0_f32, self.limit.get());
        for axis in 0..3 {
            let first = (bounds.min[axis] - self.origin[axis]) * self.inverse[axis];
            let second = (bounds.max[axis] - self.origin[axis]) * self.inverse[axis];
            enter = enter.max(first.min(second));
            leave = leave.min(first.max(second));
        }
        enter <= leave
    }
}

impl Svenstaro {
    #[inline]
    fn ask(&self, ray: &Limited, any: bool) -> f32 {
        let Limited { ray, t_max } = ray;
        let query = Pruning {
            origin: ray.origin,
            inverse: ray.direction.recip(),
            limit: Cell::new(*t_max),
        };
        let mut nearest = f32::INFINITY;
        for shape in self.tree.traverse_iterator(&query, &self.shapes) {
            if let Some(t) = shape.hit(ray.origin, ray.direction, query.limit.get()) {
                nearest = t;
                query.limit.set(t);
                if any {
                    break;
                }
            }
        }
        nearest
    }
}

impl Corners {
    /// Möller and Trumbore's test.
    #[inline]
    fn hit(&self, origin: Vec3, direction: Vec3, t_max: f32) -> Option<f32> {
        let [first, second] = self.edges;
        let across = direction.cross(second);
        let determinant = first.dot(across);
        if determinant == 0.0 {
            return None;
        }
        let inverse = 1.0 / determinant;
        let from = origin - self.corner;
        let u = from.dot(across) * inverse;
        if !(0.0..=1.0).contains(&u) {
            return None;
        }
        let turned = from.cross(first);
        let v = direction.dot(turned) * inverse;
        if v < 0.0 || u + v > 1.0 {
            return None;
        }
        let t = second.dot(turned) * inverse;
        (t > 0.0 && t < t_max).then_some(t)
    }
}

impl Rival for Svenstaro {
    const NAME: &'static str = "bvh 0.13";

    fn build(corners: &[[Vec3; 3]]) -> Self {
        let point = |corner: Vec3| Point3::from(Vector3::from(corner.to_array()));
        let mut shapes: Vec<Corners> = corners
            .iter()
            .map(|&[a, b, c]| Corners {
                corner: a,
                edges: [b - a, c - a],
                bounds: Aabb::empty().grow(&point(a)).grow(&point(b)).grow(&point(c)),
                node: 0,
            })
            .collect();
        let tree = <peer::bvh::Bvh<f32, 3> as BoundingHierarchy<f32, 3>>::build_par(&mut shapes);
        Self { tree, shapes }
    }

    #[inline]
    fn nearest(&self, ray: &Limited) -> f32 {
        self.ask(ray, false)
    }

    #[inline]
    fn any(&self, ray: &Limited) -> bool {
        self.ask(ray, true).is_finite()
    }

    fn bytes(&self) -> usize {
        size_of_val(&self.tree.nodes[..]) + size_of_val(&self.shapes[..])
    }
}
