//! Edge functions: on which side of a line a sample lies, in whole numbers.
//!
//! Pineda, "A Parallel Algorithm for Polygon Rasterization" (SIGGRAPH 1988).

use crate::fixed::Fixed;

// ANCHOR: edge
/// A directed edge of a triangle whose inside lies on its right hand as the film shows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    from: Fixed,
    /// How much the value grows for one step (1/256 pixel) to the right.
    pub per_x: i64,
    /// How much it grows for one step down.
    pub per_y: i64,
    /// 0 when samples on the edge belong to this triangle, -1 when they are the neighbour's.
    rule: i64,
}

impl Edge {
    /// The edge from one corner to the next.
    pub fn new(from: Fixed, to: Fixed) -> Self {
        let per_x = i64::from(from.y) - i64::from(to.y);
        let per_y = i64::from(to.x) - i64::from(from.x);
        // A left edge goes up (rows count downwards); a top edge is level and goes right.
        let top_left = per_x > 0 || (per_x == 0 && per_y > 0);
        Self { from, per_x, per_y, rule: if top_left { 0 } else { -1 } }
    }

    /// Twice the area of the triangle of this edge and `sample`, in steps squared, less 1 when the
    /// rule asks for it. The sample is this triangle's if the value is not negative.
    pub fn value(&self, sample: Fixed) -> i64 {
        let right = i64::from(sample.x) - i64::from(self.from.x);
        let down = i64::from(sample.y) - i64::from(self.from.y);
        self.per_y * down + self.per_x * right + self.rule
    }
}
// ANCHOR_END: edge

// ANCHOR: area
/// Twice the signed area of a triangle, in steps squared: positive when its corners go clockwise as
/// the film shows them.
pub fn doubled_area([a, b, c]: [Fixed; 3]) -> i64 {
    let side = |from: Fixed, to: Fixed| {
        (i64::from(to.x) - i64::from(from.x), i64::from(to.y) - i64::from(from.y))
    };
    let ((right_b, down_b), (right_c, down_c)) = (side(a, b), side(a, c));
    right_b * down_c - down_b * right_c
}
// ANCHOR_END: area

/// The three edges of a triangle, its corners put in clockwise order; None when it has no area.
pub fn edges([a, b, c]: [Fixed; 3]) -> Option<[Edge; 3]> {
    let [b, c] = match doubled_area([a, b, c]) {
        0 => return None,
        1.. => [b, c],
        _ => [c, b],
    };
    Some([Edge::new(a, b), Edge::new(b, c), Edge::new(c, a)])
}

/// Whether the triangle with these edges covers the sample.
pub fn covers(edges: &[Edge; 3], sample: Fixed) -> bool {
    edges.iter().all(|edge| edge.value(sample) >= 0)
}

#[cfg(test)]
mod tests {
    use super::{Edge, Fixed, covers, doubled_area, edges};

    fn at(x: i32, y: i32) -> Fixed {
        Fixed { x, y }
    }

    #[test]
    fn by_hand() {
        // The book's worked number: (1, 1), (7, 2), (2, 6) and the sample (3, 3), in pixels.
        let triangle = [at(1, 1), at(7, 2), at(2, 6)];
        assert_eq!(doubled_area(triangle), 29);
        let values = edges(triangle).expect("it has an area").map(|edge| edge.value(at(3, 3)));
        // 10, 11 and 8 add up to 29. Only the third edge is a left one: the others lose 1.
        assert_eq!(values, [9, 10, 8]);
    }

    #[test]
    fn a_sample_on_a_shared_edge_belongs_to_one_triangle() {
        let (a, b) = (at(-300, 512), at(900, -88));
        let middle = at(300, 212);
        for far in [at(700, 700), at(301, 212), at(300, 100_000)] {
            for near in [at(-700, -700), at(299, 212), at(300, -100_000)] {
                let owners = [[a, b, far], [b, a, near]]
                    .map(|triangle| edges(triangle).is_some_and(|edges| covers(&edges, middle)));
                assert_eq!(owners.iter().filter(|&&owner| owner).count(), 1);
            }
        }
    }

    #[test]
    fn an_edge_and_its_reverse_never_agree_on_a_sample() {
        let slanted = [at(17, -240), at(401, 272)];
        let level = [at(17, 30), at(401, 30)];
        let upright = [at(17, -240), at(17, 272)];
        for [a, b] in [slanted, level, upright] {
            for sample in (-50..450).flat_map(|x| (-260..300).map(move |y| at(x, y))) {
                let there = Edge::new(a, b).value(sample) >= 0;
                assert_ne!(there, Edge::new(b, a).value(sample) >= 0, "{a:?} {b:?} {sample:?}");
            }
        }
    }

    #[test]
    fn a_sliver_without_area_covers_nothing() {
        assert_eq!(edges([at(0, 0), at(256, 512), at(512, 1024)]), None);
    }
}
