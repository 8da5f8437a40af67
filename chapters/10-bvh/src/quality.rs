//! How good a tree is, before the first ray.

use glam::DVec3;

use crate::node::Node;
use crate::split::STEP;
use crate::tree::Bvh;

impl Bvh {
    // ANCHOR: cost
    /// The work to be expected for a ray that meets the root, with items asked `together` at a time:
    /// each node counts as often as a ray that meets the root also meets it.
    ///
    /// MacDonald and Booth, "Heuristics for ray tracing using space subdivision" (The Visual Computer
    /// 6, 1990): for rays from far away that is the node's share of the root's surface.
    pub fn expected_work(&self, together: u32) -> f64 {
        let Some(root) = self.nodes.first() else { return 0.0 };
        let work = |node: &Node| match node.is_leaf() {
            true => f64::from(node.count.div_ceil(together)),
            false => f64::from(STEP),
        };
        self.nodes.iter().map(|node| work(node) * surface(node)).sum::<f64>() / surface(root)
    }
    // ANCHOR_END: cost
}

/// Half the surface of a node's box, in `f64`, where no square overflows or vanishes.
fn surface(node: &Node) -> f64 {
    let DVec3 { x, y, z } = node.bounds.max.as_dvec3() - node.bounds.min.as_dvec3();
    x * y + y * z + z * x
}
