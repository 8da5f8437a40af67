//! The linear scan of chapter 2 as an accelerator that accelerates nothing: the reference for all.

use common::tally::Tally;
use glam::Vec3;
use ray_casting::ray::Ray;
use triangles::brute::{Found, TRIANGLE_TESTS};
use triangles::lanes::Packed;

use crate::accelerator::{Accelerator, Statistics};
use crate::leaf::{Question, Stored};

/// All triangles in a row, asked four at a time.
#[derive(Clone, Debug, Default)]
pub struct Scan(Packed);

impl Accelerator for Scan {
    fn build(triangles: Vec<[Vec3; 3]>) -> Self {
        Self(Packed::new(triangles))
    }

    fn walk<Q: Question, T: Tally>(&self, _ray: &Ray, question: &mut Q, tally: &mut T) {
        for (index, &corners) in (0..).zip(self.0.corners()) {
            question.ask_all(&[Stored { corners, index }], tally);
            if question.answered() {
                return;
            }
        }
    }

    fn statistics(&self) -> Statistics {
        // A triangle's corners, and the same again in its pack of four.
        let bytes = 2 * size_of_val(self.0.corners());
        let triangles = self.0.len();
        Statistics { triangles, references: triangles, bytes, nodes: 1, ..Statistics::default() }
    }

    fn nearest<T: Tally>(&self, ray: &Ray, t_max: f32, tally: &mut T) -> Option<Found> {
        tally.count(TRIANGLE_TESTS, self.0.len() as u64);
        self.0.nearest(ray, t_max)
    }
}
