//! Trees of branches without any geometry: the hardest thing there is to follow.

use common::film::Color;
use common::sampler::Stream;
use common::tally::{Event, Tally};
use glam::DVec3;

use crate::scatter::{Branch, Scatter, Scattered};

/// Branches of trees that were followed.
pub const FOLLOWED: Event = Event::new(6, 7, "followed");

/// A tree without end whose nodes have random light and weights. The ray is the node's number: the
/// children of node k are 2 k and 2 k + 1. What two branches get adds up to 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tree {
    /// Which random numbers.
    pub seed: u64,
    /// How many branches each node has: 0, 1 or 2.
    pub branches: u64,
}

impl Tree {
    /// The number of the first node.
    pub const ROOT: u64 = 1;

    /// The light of `node` and of all its branches to `depth`, by plain recursion in `f64`.
    pub fn exactly(&self, node: u64, depth: u32) -> DVec3 {
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
            (child < self.branches).then_some(Branch { ray, weight, event: &FOLLOWED })
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
