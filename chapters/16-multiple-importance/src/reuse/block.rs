//! Squares of pixels, and their random numbers.

use std::ops::Range;

use common::render::{Pixel, Settings};
use common::sampler::Sampler;

/// Pixels that share their paths: a square, or what the film's edge leaves of it.
#[derive(Debug)]
pub(super) struct Block<'a> {
    /// Row by row.
    pub(super) pixels: Vec<Pixel>,
    settings: &'a Settings,
    /// Its own, among all blocks.
    number: u64,
    /// Pixels of a whole one.
    size: u32,
}

impl<'a> Block<'a> {
    /// The blocks in `rows`, as many as the blocks' side, from left to right.
    pub(super) fn across(
        settings: &'a Settings,
        side: u32,
        rows: Range<u32>,
    ) -> impl Iterator<Item = Self> {
        let count = settings.width.div_ceil(side);
        let before = u64::from(rows.start / side) * u64::from(count);
        (0..count).map(move |column| {
            let columns = column * side..settings.width.min((column + 1) * side);
            let row = |y| columns.clone().map(move |x| Pixel { x, y });
            let pixels = rows.clone().flat_map(row).collect();
            Self { pixels, settings, number: before + u64::from(column), size: side * side }
        })
    }

    // ANCHOR: samplers
    /// Numbers for what concerns the pixel at `place` alone: its point on the film, and the lamps as seen
    /// from its first vertex.
    pub(super) fn own(&self, place: usize, index: u32) -> Sampler {
        let Settings { seed, spp, width, .. } = *self.settings;
        let Pixel { x, y } = self.pixels[place];
        Sampler::new(seed, u64::from(y) * u64::from(width) + u64::from(x), index, spp)
    }

    /// Numbers for what all use: the paths of a block take one point each of the same sequence, so that
    /// together they are spread evenly.
    pub(super) fn shared(&self, place: usize, index: u32) -> Sampler {
        let Settings { seed, spp, .. } = *self.settings;
        let point = index.wrapping_mul(self.size).wrapping_add(place as u32);
        Sampler::new(seed, self.number, point, spp.saturating_mul(self.size))
    }
    // ANCHOR_END: samplers
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use common::render::{Pixel, Settings};
    use path_tracing::random::{DIRECTION, Random};

    use super::Block;

    #[test]
    fn each_pixel_is_in_one_block() {
        let settings = Settings { width: 10, height: 7, spp: 2, ..Settings::default() };
        let mut seen = vec![0; 70];
        let mut numbers = Vec::new();
        for rows in [0..4, 4..7] {
            for block in Block::across(&settings, 4, rows) {
                numbers.push(block.number);
                for Pixel { x, y } in block.pixels {
                    seen[(y * 10 + x) as usize] += 1;
                }
            }
        }
        assert_eq!(seen, [1; 70]);
        assert_eq!(numbers, [0, 1, 2, 3, 4, 5]);
    }

    /// And no pixel always gets the points of the same part: the sequence's order is shuffled.
    #[test]
    fn the_paths_of_a_sample_are_spread_evenly() {
        let settings = Settings { width: 4, height: 4, spp: 64, ..Settings::default() };
        let block = Block::across(&settings, 4, 0..4).next().expect("one block");
        let strip = |place, index| {
            let pair = Random::at(&block.shared(place, index), 1).pair(DIRECTION);
            (16.0 * pair.x) as usize
        };
        let mut counts = [0; 16];
        (0..16).for_each(|place| counts[strip(place, 3)] += 1);
        assert_eq!(counts, [1; 16]);
        let of_one: BTreeSet<usize> = (0..64).map(|index| strip(5, index)).collect();
        assert_eq!(of_one.len(), 16);
    }
}
