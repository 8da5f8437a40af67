//! Drawing a piece: which samples it covers, and which of those it is nearest at.

use std::ops::Range;

use common::render::Pixel;
use common::tally::{Event, Tally};

use crate::fixed::{Fixed, STEPS};
use crate::samples::{Samples, exact_position};
use crate::setup::Piece;
use crate::zbuffer::{ZBuffer, nearness};

/// Samples that were asked on which side of three edges they lie.
pub const PIXELS_TESTED: Event = Event::new(3, 3, "pixels_tested");
/// Samples inside a triangle, whose depth was compared.
pub const DEPTH_TESTS: Event = Event::new(3, 4, "depth_tests");
/// Samples written to the z-buffer because they were nearer.
pub const PIXELS_WRITTEN: Event = Event::new(3, 5, "pixels_written");

/// Some rows of the film with a z-buffer of their own.
#[derive(Clone, Debug)]
pub struct Band {
    /// Pixels in a row.
    pub width: u32,
    /// The rows.
    pub rows: Range<u32>,
    /// The depth of the near plane, in units of the scene.
    pub near: f64,
    /// A sample a pixel, row by row.
    pub buffer: ZBuffer,
}

impl Band {
    /// Empty rows.
    pub fn new(width: u32, rows: Range<u32>, near: f64) -> Self {
        let buffer = ZBuffer::new(width as usize * rows.len());
        Self { width, rows, near, buffer }
    }

    /// The place of a pixel in the buffer.
    pub fn index(&self, pixel: Pixel) -> usize {
        (pixel.y - self.rows.start) as usize * self.width as usize + pixel.x as usize
    }

    // ANCHOR: draw
    /// Draws what of `piece` lies in these rows.
    pub fn draw<T: Tally>(&mut self, piece: &Piece, samples: &impl Samples, tally: &mut T) {
        let rows = piece.rows.start.max(self.rows.start)..piece.rows.end.min(self.rows.end);
        let (mut inside, mut written) = (0, 0);
        for y in rows.clone() {
            // The edge functions at the top left corner of the row's first pixel.
            let corner = Fixed { x: piece.columns.start as i32 * STEPS, y: y as i32 * STEPS };
            let mut values = piece.edges.map(|edge| edge.value(corner));
            for x in piece.columns.clone() {
                let pixel = Pixel { x, y };
                let Fixed { x: right, y: down } = samples.offset(pixel);
                let mut least = i64::MAX;
                for (edge, value) in piece.edges.iter().zip(&mut values) {
                    let step = edge.per_x * i64::from(right) + edge.per_y * i64::from(down);
                    least = least.min(*value + step);
                    *value += edge.per_x * i64::from(STEPS);
                }
                if least >= 0 {
                    inside += 1;
                    written += u64::from(self.offer(piece, pixel, Fixed { x: right, y: down }));
                }
            }
        }
        tally.count(PIXELS_TESTED, rows.len() as u64 * piece.columns.len() as u64);
        tally.count(DEPTH_TESTS, inside);
        tally.count(PIXELS_WRITTEN, written);
    }

    /// The depth test at one covered sample.
    fn offer(&mut self, piece: &Piece, pixel: Pixel, offset: Fixed) -> bool {
        let inverse = piece.inverse_depth(exact_position(pixel, offset));
        let nearness = nearness(self.near, inverse);
        self.buffer.offer(self.index(pixel), piece.triangle, nearness)
    }
    // ANCHOR_END: draw
}
