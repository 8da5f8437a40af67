//! Trees of branches without any geometry, for tests of what follows them.

use common::film::Color;
use common::sampler::Stream;
use common::tally::{Event, Tally};
use glam::DVec3;

use crate::scatter::{Branch, Scatter, Scattered};

pub(crate) const FOLLOWED: Event = Event::new(6, 7, "followed");

/// Branches that come from a number: each node has its own light and weights.
pub(crate) struct Tree {
    pub(crate) seed: u64,
    /// How many each node has: 0, 1 or 2.
    pub(crate) branches: u64,
}

impl Tree {
    /// Two mirrors that return everything, face to face.
    pub(crate) fn mirror() -> Facing {
        Facing { light: 1.0, weight: 1.0 }
    }

    pub(crate) fn root(&self) -> u64 {
        1
    }

    /// The same light by plain recursion in `f64`, to `depth` branches.
    pub(crate) fn exactly(&self, node: u64, depth: u32) -> DVec3 {
        let met = self.node(node);
        let branches = met.branches.into_iter().flatten().filter(|_| depth > 0);
        branches.fold(met.light.as_dvec3(), |sum, branch| {
            sum + branch.weight.as_dvec3() * self.exactly(branch.ray, depth - 1)
        })
    }

    fn node(&self, node: u64) -> Scattered<u64> {
        let mut stream = Stream::of_trial(self.seed, node);
        let mut color = |low, high| {
            Color::new(
                stream.between(low, high),
                stream.between(low, high),
                stream.between(low, high),
            )
        };
        let light = color(0.1, 3.0);
        let share = color(0.1, 0.9);
        let branch = |child: u64| {
            let weight = if child == 0 { share } else { Color::ONE - share };
            let ray = node.wrapping_mul(2).wrapping_add(child);
            (child < self.branches).then_some(Branch { ray, weight, event: FOLLOWED })
        };
        Scattered { light, branches: [branch(0), branch(1)] }
    }
}

impl Scatter for Tree {
    type Ray = u64;

    fn scatter<T: Tally>(&self, ray: &u64, _tally: &mut T) -> Scattered<u64> {
        self.node(*ray)
    }
}

/// Two equal mirrors face to face: the closed form is a geometric series.
pub(crate) struct Facing {
    /// What each sends by itself.
    pub(crate) light: f32,
    /// What each returns.
    pub(crate) weight: f32,
}

impl Scatter for Facing {
    type Ray = u64;

    fn scatter<T: Tally>(&self, ray: &u64, _tally: &mut T) -> Scattered<u64> {
        let weight = Color::splat(self.weight);
        let branch = Branch { ray: ray + 1, weight, event: FOLLOWED };
        Scattered::with(Color::splat(self.light), Some(branch))
    }
}
