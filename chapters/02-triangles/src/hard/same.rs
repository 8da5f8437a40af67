//! TR-03 and X-08: the same question put in another way must get the same answer, to the bit.

use common::sampler::Stream;
use ray_casting::ray::Ray;

use super::aimed::NEAR;
use super::shapes::{Corners, ask, mix, point, towards, triangle};
use crate::intersect::{TriangleHit, TriangleTest};
use crate::naive::MollerTrumbore;
use crate::watertight::ShearedRay;
use glam::Vec3;

const ORDERS: [[usize; 3]; 5] = [[1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];

/// Whether hit or miss, or the distance, changes when the corners of a triangle are named in
/// another order. The rays are aimed at the triangle's edge.
fn order_matters<Test: TriangleTest>(trial: u64) -> bool {
    let mut stream = Stream::of_trial(203, trial);
    let mesh = &NEAR[(trial % NEAR.len() as u64) as usize];
    let Some(aim) = mesh.at_edge(&mut stream) else { return false };
    let corners = mesh.corners[aim.triangle];
    let distance = |corners: &Corners| {
        ask::<Test>(&aim.ray, corners, f32::INFINITY).map(|hit| hit.t.to_bits())
    };
    let first = distance(&corners);
    ORDERS.iter().any(|order| distance(&order.map(|at| corners[at])) != first)
}

pub(super) fn order_naive(trial: u64) -> bool {
    order_matters::<MollerTrumbore>(trial)
}

pub(super) fn order_robust(trial: u64) -> bool {
    order_matters::<ShearedRay>(trial)
}

/// Whether an answer changes when everything is made 2^k times as large, k from -60 to 60. Such a
/// product is exact, so a formula without constants of its own doesn't notice.
fn size_matters<Test: TriangleTest>(trial: u64) -> bool {
    let mut stream = Stream::of_trial(8, trial);
    let corners = triangle(&mut stream);
    let weights = Vec3::new(stream.uniform(), stream.uniform(), stream.uniform()) - 0.1;
    let target = mix(&corners, weights / weights.element_sum());
    let Some(ray) = towards(point(&mut stream), target) else { return false };
    let exponent = stream.bits() % 121;
    let factor = f32::from_bits((127 + exponent - 60) << 23);
    // The direction is scaled too, so that t, in lengths of it, stays as it is.
    let scaled = Ray { origin: factor * ray.origin, direction: factor * ray.direction };
    let bits = |hit: TriangleHit| (hit.t.to_bits(), hit.barycentric.to_array().map(f32::to_bits));
    let plain = ask::<Test>(&ray, &corners, f32::INFINITY).map(bits);
    let large = ask::<Test>(&scaled, &corners.map(|corner| factor * corner), f32::INFINITY);
    plain != large.map(bits)
}

pub(super) fn scale_naive(trial: u64) -> bool {
    size_matters::<MollerTrumbore>(trial)
}

pub(super) fn scale_robust(trial: u64) -> bool {
    size_matters::<ShearedRay>(trial)
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::Vec3;

    use super::ORDERS;
    use crate::hard::shapes::{ask, inner_weights, mix, point, towards, triangle};
    use crate::watertight::ShearedRay;

    /// The weights go with their corners, to the bit.
    #[test]
    fn the_weights_go_with_their_corners() {
        for trial in 0..100_000 {
            let mut stream = Stream::of_trial(3, trial);
            let corners = triangle(&mut stream);
            let target = mix(&corners, inner_weights(&mut stream));
            let ray = towards(point(&mut stream), target).expect("two random points");
            let Some(hit) = ask::<ShearedRay>(&ray, &corners, f32::INFINITY) else { continue };
            for order in ORDERS {
                let turned = ask::<ShearedRay>(&ray, &order.map(|at| corners[at]), f32::INFINITY);
                let expected = Vec3::from(order.map(|at| hit.barycentric[at]));
                assert_eq!(turned.map(|it| it.barycentric), Some(expected));
            }
        }
    }
}
