//! Exercise 6.4: branches of branches, and a watch on the stack.

use common::sampler::Stream;
use whitted::exercises::Node;

/// Nodes that meet one another.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Forest {
    shape: Shape,
    nodes: usize,
    seed: u64,
}

#[derive(Clone, Copy, Debug)]
enum Shape {
    /// Each node has one branch.
    Row,
    /// Each has two.
    Tree,
    /// Each has two, of which the second ends at once.
    Comb,
}

pub(crate) fn forests() -> Vec<Forest> {
    let forest = |shape, nodes, seed| Forest { shape, nodes, seed };
    vec![
        forest(Shape::Row, 1, 0),
        forest(Shape::Row, 2, 1),
        forest(Shape::Tree, 3, 2),
        forest(Shape::Comb, 5, 3),
        forest(Shape::Tree, 1023, 4),
        forest(Shape::Comb, 99, 5),
        forest(Shape::Row, 100_000, 6),
        forest(Shape::Comb, 100_001, 7),
    ]
}

impl Forest {
    fn node(&self, number: usize) -> Node {
        let mut stream = Stream::of_trial(self.seed, number as u64);
        let light = f64::from(stream.between(0.1, 2.0));
        // Those of long rows return nearly all, so that their ends count.
        let share = f64::from(stream.between(0.3, 0.6));
        let branches = match self.shape {
            Shape::Row => vec![(number + 1, 1.0 - 1e-4 * share)],
            Shape::Tree => vec![(2 * number + 1, share), (2 * number + 2, 0.9 - share)],
            Shape::Comb if number % 2 == 1 => Vec::new(),
            Shape::Comb => vec![(number + 2, 1.0 - 1e-4 * share), (number + 1, 1e-4 * share)],
        };
        let inside = |branch: &(usize, f64)| branch.0 < self.nodes;
        Node { light, branches: branches.into_iter().filter(inside).collect() }
    }

    /// From the last node to the first: a branch always meets a later one.
    pub(crate) fn total(&self) -> f64 {
        let mut totals = vec![0.0; self.nodes];
        for number in (0..self.nodes).rev() {
            let Node { light, branches } = self.node(number);
            let rest = branches.iter().map(|&(branch, weight)| weight * totals[branch]);
            totals[number] = light + rest.sum::<f64>();
        }
        totals[0]
    }

    /// What `total` says, if its stack doesn't grow while it asks.
    pub(crate) fn asked(&self, total: fn(&dyn Fn(usize) -> Node) -> f64) -> f64 {
        let start = address();
        let meet = |number| {
            assert!(
                start.abs_diff(address()) < 64 * 1024,
                "the stack grew by 64 KiB: the function calls itself"
            );
            self.node(number)
        };
        total(&meet)
    }
}

/// Where on the stack this is called, nearly.
#[inline(never)]
fn address() -> usize {
    let here = 0u8;
    std::ptr::from_ref(std::hint::black_box(&here)).addr()
}
