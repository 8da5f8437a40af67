//! What sixteen rays hit first.

use glam::Vec3;

use crate::brute::Found;
use crate::bundle::{Floats, RAYS, Vectors};
use crate::few::MOST;
use crate::intersect::TriangleHit;
use crate::watertight::Measured;

/// What the rays hit first.
#[derive(Clone, Copy, Debug)]
pub struct Nearest {
    /// The triangles' places in the list, or [`NONE`].
    pub place: [u32; RAYS],
    /// How far along the rays.
    pub t: Floats,
    /// The barycentric weights of the points.
    pub weights: Vectors,
}

/// The place of no triangle.
pub const NONE: u32 = u32::MAX;

/// The best hits so far.
pub(crate) struct Best {
    triangle: [u32; RAYS],
    pub(crate) t: Floats,
    edges: [[f64; RAYS]; 3],
    determinant: [f64; RAYS],
}

impl Best {
    /// None yet, and none from `limit` on.
    #[inline(always)]
    pub(crate) fn new(limit: f32) -> Self {
        Self {
            triangle: [NONE; RAYS],
            t: [limit; RAYS],
            edges: [[0.0; RAYS]; 3],
            determinant: [1.0; RAYS],
        }
    }

    /// Takes a hit, which is nearer than all before it. They come in the triangles' order, so of two at
    /// the same distance the first stays.
    #[inline(always)]
    pub(crate) fn take(&mut self, ray: usize, asked: u32, measured: Option<Measured>) {
        let better = (asked != NONE) & measured.is_some();
        let new = measured.unwrap_or(Measured::NONE);
        let pick = |new: f64, old: f64| if better { new } else { old };
        self.triangle[ray] = if better { asked } else { self.triangle[ray] };
        self.t[ray] = if better { new.t } else { self.t[ray] };
        self.determinant[ray] = pick(new.determinant, self.determinant[ray]);
        for (old, new) in self.edges.iter_mut().zip(new.edges) {
            old[ray] = pick(new, old[ray]);
        }
    }

    /// Whether each ray hits anything.
    #[inline(always)]
    pub(crate) fn is_any(&self) -> [bool; RAYS] {
        let mut is_any = [false; RAYS];
        for ray in 0..RAYS {
            is_any[ray] = self.triangle[ray] != NONE;
        }
        is_any
    }

    /// The hits, by their `places` in the list.
    #[inline(always)]
    pub(crate) fn nearest(&self, places: &[u32; MOST]) -> Nearest {
        let mut nearest = Nearest { place: [NONE; RAYS], t: self.t, weights: Vectors::ZERO };
        for ray in 0..RAYS {
            let triangle = self.triangle[ray];
            let place = places[triangle as usize % MOST];
            nearest.place[ray] = if triangle == NONE { NONE } else { place };
            let weight = |edge: usize| (self.edges[edge][ray] / self.determinant[ray]) as f32;
            nearest.weights.set(ray, Vec3::new(weight(0), weight(1), weight(2)));
        }
        nearest
    }
}

impl Nearest {
    /// What ray number `ray` hits first.
    pub fn found(&self, ray: usize) -> Option<Found> {
        let hit = TriangleHit { t: self.t[ray], barycentric: self.weights.at(ray) };
        (self.place[ray] != NONE).then(|| Found { hit, index: self.place[ray] as usize })
    }
}
