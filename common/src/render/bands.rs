//! The picture by whole rows, for methods that don't go pixel by pixel.

use std::ops::Range;

use super::{Rendering, Settings, Shaded, Tile, assemble, run};
use crate::film::Mean;
use crate::tally::Tally;

/// The picture whose rows `shade` fills, so many of them at a time.
///
/// `shade` gives the pixels of a range of rows, row by row, each with all its samples, or None if it
/// asked the watch on the way and was told to stop. Bands are done by any thread and put together in
/// their order.
pub fn render_bands<T: Tally>(
    settings: &Settings,
    height: u32,
    shade: impl Fn(Range<u32>, &mut T) -> Option<Vec<Mean>> + Sync,
) -> Rendering<T> {
    let bands = Tile::bands(settings, height);
    let finished = run(settings, &bands, |band| {
        if settings.watch.stop() {
            return None;
        }
        let mut shaded = Shaded::new(T::default());
        let pixels = shade(band.top..band.top + band.height, &mut shaded.tally)?;
        pixels.iter().for_each(|mean| shaded.push(mean));
        settings.watch.done(u64::from(band.width) * u64::from(band.height));
        Some(shaded)
    });
    assemble(settings, &bands, finished)
}

impl Tile {
    /// Tiles as wide as the film and `height` rows high, from the top.
    fn bands(settings: &Settings, height: u32) -> Vec<Self> {
        let tops = (0..settings.height).step_by(height.max(1) as usize);
        let band = |top| Self {
            left: 0,
            top,
            width: settings.width,
            height: height.max(1).min(settings.height - top),
        };
        tops.map(band).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::render_bands;
    use crate::film::{Color, Mean};
    use crate::render::{Pixel, Settings, render_counted};
    use crate::tally::{Counts, Event, Tally};

    const SAMPLES: Event = Event::new(0, 0, "samples");

    fn color(x: u32, y: u32) -> Color {
        Color::new(x as f32, y as f32, (x * y) as f32)
    }

    #[test]
    fn bands_of_any_height_make_the_same_picture() {
        let settings = Settings { width: 37, height: 21, ..Settings::default() };
        let expected = render_counted(&settings, |Pixel { x, y }, _, tally: &mut Counts| {
            tally.count(SAMPLES, 1);
            color(x, y)
        });
        for (height, threads) in [(1, 3), (4, 2), (16, 1), (400, 7)] {
            let settings = Settings { threads, ..settings.clone() };
            let found = render_bands(&settings, height, |rows, tally: &mut Counts| {
                let pixels = rows.flat_map(|y| (0..37).map(move |x| (x, y)));
                let shaded = pixels.map(|(x, y)| {
                    tally.count(SAMPLES, 1);
                    let mut mean = Mean::default();
                    mean.add(color(x, y));
                    mean
                });
                Some(shaded.collect())
            });
            assert_eq!((&found.film, &found.tally), (&expected.film, &expected.tally));
            assert!(found.complete);
        }
    }
}
