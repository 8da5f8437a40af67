//! The z-buffer: for each sample the nearest surface so far.
//!
//! Catmull, "A Subdivision Algorithm for Computer Display of Curved Surfaces" (1974).

/// The number that stands for "no triangle".
pub const NOTHING: u32 = u32::MAX;

// ANCHOR: zbuffer
/// For each sample of a piece of the film: the triangle seen there, and how near it is.
#[derive(Clone, Debug, PartialEq)]
pub struct ZBuffer {
    /// The triangle's number in the mesh, or [`NOTHING`].
    pub triangles: Vec<u32>,
    /// near/w, so 1 on the near plane and 0 infinitely far away: "reversed z".
    pub nearness: Vec<f32>,
}

impl ZBuffer {
    /// A buffer of `samples` samples with nothing in it.
    pub fn new(samples: usize) -> Self {
        Self { triangles: vec![NOTHING; samples], nearness: vec![0.0; samples] }
    }

    /// Puts `triangle` into sample number `index` if it is nearer than what is there. Of two that
    /// are equally near the first stands, as it does for rays.
    pub fn offer(&mut self, index: usize, triangle: u32, nearness: f32) -> bool {
        let nearer = nearness > self.nearness[index];
        if nearer {
            self.triangles[index] = triangle;
            self.nearness[index] = nearness;
        }
        nearer
    }
}
// ANCHOR_END: zbuffer

// ANCHOR: nearness
/// What the buffer holds of a surface at depth w, from 1/w.
///
/// An f32 keeps 24 bits of any number, however small. So two depths that differ by a few
/// millionths of themselves are told apart at any distance.
pub fn nearness(near: f64, inverse_depth: f64) -> f32 {
    (near * inverse_depth) as f32
}
// ANCHOR_END: nearness

#[cfg(test)]
mod tests {
    use super::{NOTHING, ZBuffer};

    #[test]
    fn the_nearest_stays_in_any_order() {
        for order in [[0, 1, 2], [2, 1, 0], [1, 2, 0]] {
            let mut buffer = ZBuffer::new(3);
            for triangle in order {
                buffer.offer(1, triangle, [0.25, 0.75, 0.5][triangle as usize]);
            }
            assert_eq!(buffer.triangles, [NOTHING, 1, NOTHING]);
        }
    }

    #[test]
    fn the_first_of_two_equals_stays() {
        let mut buffer = ZBuffer::new(1);
        assert!(buffer.offer(0, 7, 0.5) && !buffer.offer(0, 8, 0.5));
        assert_eq!(buffer.triangles, [7]);
    }
}
