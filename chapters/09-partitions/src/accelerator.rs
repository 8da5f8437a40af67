//! What every acceleration structure can do: find the triangle a ray hits first, without asking all.

use common::tally::{Event, Tally};
use glam::Vec3;
use ray_casting::ray::Ray;
use triangles::brute::Found;

use crate::leaf::{AnyHit, NearestHit, Question};

/// Cells of a grid that a ray was in.
pub const CELL_STEPS: Event = Event::new(9, 0, "cell_steps");
/// Nodes of a tree that a ray was in, leaves included.
pub const NODE_VISITS: Event = Event::new(9, 1, "node_visits");

/// Triangles that a structure was given.
pub const TRIANGLES: Event = Event::new(9, 2, "triangles");
/// Triangles that it stores, each as often as it is stored.
pub const TRIANGLES_STORED: Event = Event::new(9, 3, "triangles_stored");
/// Its nodes or cells.
pub const STRUCTURE_NODES: Event = Event::new(9, 4, "structure_nodes");
/// Its memory.
pub const STRUCTURE_BYTES: Event = Event::new(9, 5, "structure_bytes");

/// How often a structure stores a triangle at most, on average, whatever the triangles are. Where
/// cutting on would take more, it isn't done: memory has an end, and slow is better than none.
pub const MOST_COPIES: f32 = 8.0;

// ANCHOR: accelerator
/// Triangles, arranged so that a ray is tested against few of them.
///
/// Whatever the arrangement, the answer is the linear scan's, to the bit: the nearest hit, and of
/// several at the same distance the one on the triangle that comes first in the list.
pub trait Accelerator: Send + Sync {
    /// Arranges triangles, given by their corners.
    fn build(triangles: Vec<[Vec3; 3]>) -> Self
    where
        Self: Sized;

    /// Puts `question` to the triangles along the ray, nearer ones first as far as it can be done
    /// cheaply, until the question is answered. No triangle may be left out that the ray could hit
    /// at a distance up to the question's limit.
    fn walk<Q: Question, T: Tally>(&self, ray: &Ray, question: &mut Q, tally: &mut T);

    /// What it is made of.
    fn statistics(&self) -> Statistics;

    /// The nearest hit with `0 < t < t_max`.
    fn nearest<T: Tally>(&self, ray: &Ray, t_max: f32, tally: &mut T) -> Option<Found> {
        let mut question = NearestHit::new(ray, t_max)?;
        self.walk(ray, &mut question, tally);
        question.found()
    }

    /// Whether there is any hit with `0 < t < t_max`.
    fn is_hit<T: Tally>(&self, ray: &Ray, t_max: f32, tally: &mut T) -> bool {
        AnyHit::new(ray, t_max).is_some_and(|mut question| {
            self.walk(ray, &mut question, tally);
            question.answered()
        })
    }
}
// ANCHOR_END: accelerator

// ANCHOR: statistics
/// What a structure is made of. The same triangles give the same figures on every machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Triangles it was given.
    pub triangles: usize,
    /// Triangles among them that no ray can hit: without area, or with a corner that isn't finite.
    /// They are not stored.
    pub left_out: usize,
    /// Triangles stored, each as often as it is stored.
    pub references: usize,
    /// Nodes of the tree, leaves included, or cells of the grid.
    pub nodes: usize,
    /// Steps from the root to the deepest leaf; 0 for a grid.
    pub depth: usize,
    /// Memory for all of this.
    pub bytes: usize,
}
// ANCHOR_END: statistics

impl Statistics {
    /// Counts what the structure is made of, once for a picture.
    pub fn count(&self, tally: &mut impl Tally) {
        tally.count(TRIANGLES, self.triangles as u64);
        tally.count(TRIANGLES_STORED, self.references as u64);
        tally.count(STRUCTURE_NODES, self.nodes as u64);
        tally.count(STRUCTURE_BYTES, self.bytes as u64);
    }

    /// How often a triangle that is stored at all is stored on average; 0 where there are none.
    pub fn copies(&self) -> f64 {
        self.references as f64 / (self.triangles - self.left_out).max(1) as f64
    }
}
