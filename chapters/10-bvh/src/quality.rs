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

#[cfg(test)]
mod tests {
    use boxes::aabb::Aabb;
    use glam::Vec3;

    use crate::build::Recipe;
    use crate::split::{STEP, Split};

    /// The page's worked number: 1x2x3 boxes side by side along x, with a gap of 2.
    #[test]
    fn two_boxes_by_hand() {
        let at = |x: f32| {
            let low = Vec3::new(x, 5.0, -4.0);
            Aabb { min: low, max: low + Vec3::new(1.0, 2.0, 3.0) }
        };
        let boxes = [at(0.0), at(3.0)];
        let cut = Recipe { split: Split::Median, leaf: 1, together: 1 }.build(boxes);
        // Half surfaces: 1*2 + 2*3 + 3*1 = 11 each, and 4*2 + 2*3 + 3*4 = 26 of the root.
        let expected = f64::from(STEP) + 2.0 * 11.0 / 26.0;
        assert!((cut.expected_work(1) - expected).abs() < 1e-12);
        let whole = Recipe { leaf: 2, ..Recipe::default() };
        let leaf = Recipe { split: Split::Median, ..whole }.build(boxes);
        assert_eq!((leaf.expected_work(1), leaf.expected_work(4)), (2.0, 1.0));
        // 0.5 + 0.85 is less than 2: the heuristic cuts as well.
        assert_eq!(whole.build(boxes).nodes.len(), 3);
    }
}
