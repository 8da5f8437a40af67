//! The pixel loop: a chapter says what one sample of one pixel is worth, this does all of them.
//!
//! ```
//! use common::{film::Color, render::{Settings, render}};
//! let settings = Settings { width: 4, height: 3, ..Settings::default() };
//! let rendering = render(&settings, |pixel, sampler| {
//!     let position = pixel.position(sampler);
//!     Color::new(position.x / 4.0, position.y / 3.0, 0.0)
//! });
//! assert_eq!(rendering.film.pixel(0, 0), Color::new(0.125, 0.5 / 3.0, 0.0));
//! ```

pub mod bands;

use std::fmt;
use std::sync::Arc;

use glam::Vec2;

use crate::film::{Color, Film, Mean};
use crate::sampler::Sampler;
use crate::tally::{Off, Tally};

/// How a picture is to be made.
#[derive(Clone)]
pub struct Settings {
    /// Pixels in a row, at least 1.
    pub width: u32,
    /// Rows, at least 1.
    pub height: u32,
    /// Samples per pixel, at least 1.
    pub spp: u32,
    /// Which random numbers: the same seed gives the same picture to the last bit.
    pub seed: u64,
    /// Threads; 0 takes one for each processor.
    pub threads: usize,
    /// Told of progress, and asked whether to stop.
    pub watch: Arc<dyn Watch>,
}

impl Default for Settings {
    /// 640x480, one sample a pixel, seed 1, every processor, nobody watching.
    fn default() -> Self {
        Self { width: 640, height: 480, spp: 1, seed: 1, threads: 0, watch: Arc::new(Unwatched) }
    }
}

impl fmt::Debug for Settings {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        let Self { width, height, spp, seed, threads, .. } = self;
        write!(out, "{width}x{height}, {spp} spp, seed {seed}, {threads} threads")
    }
}

/// Somebody who watches the work: a progress bar, or Ctrl-C.
pub trait Watch: Send + Sync {
    /// So many more pixels are done.
    fn done(&self, pixels: u64);
    /// Whether the rest should be left undone.
    fn stop(&self) -> bool;
}

/// Nobody watches.
pub struct Unwatched;

impl Watch for Unwatched {
    fn done(&self, _pixels: u64) {}

    fn stop(&self) -> bool {
        false
    }
}

/// A pixel's column and row, from the top left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    /// Column, from the left.
    pub x: u32,
    /// Row, from the top.
    pub y: u32,
}

impl Pixel {
    /// Where on the film the sample lies, in pixels: (0, 0) is the film's top left corner and the
    /// centre of the first pixel is (0.5, 0.5).
    #[inline]
    pub fn position(self, sampler: &Sampler) -> Vec2 {
        Vec2::new(self.x as f32, self.y as f32) + sampler.pixel_offset()
    }
}

/// A picture, and what was counted on the way.
#[derive(Clone, Debug)]
pub struct Rendering<T> {
    /// The picture; pixels that were not reached are black.
    pub film: Film,
    /// The counters of all threads together.
    pub tally: T,
    /// Whether every pixel was done, which it was not if the watch said stop.
    pub complete: bool,
}

/// The picture whose pixels average `shade` over the samples.
pub fn render(
    settings: &Settings,
    shade: impl Fn(Pixel, &Sampler) -> Color + Sync,
) -> Rendering<Off> {
    render_counted(settings, |pixel, sampler, _off| shade(pixel, sampler))
}

/// The same, for a `shade` that counts its work.
pub fn render_counted<T: Tally>(
    settings: &Settings,
    shade: impl Fn(Pixel, &Sampler, &mut T) -> Color + Sync,
) -> Rendering<T> {
    let tiles = Tile::cover(settings.width, settings.height);
    let finished = run(settings, &tiles, |tile| {
        let shaded = shade_tile(settings, tile, &shade)?;
        settings.watch.done(u64::from(tile.width) * u64::from(tile.height));
        Some(shaded)
    });
    assemble(settings, &tiles, finished)
}

/// What one tile came to.
struct Shaded<T> {
    pixels: Vec<Color>,
    nonfinite: u64,
    tally: T,
}

impl<T> Shaded<T> {
    fn new(tally: T) -> Self {
        Self { pixels: Vec::new(), nonfinite: 0, tally }
    }

    fn push(&mut self, mean: &Mean) {
        self.pixels.push(mean.color());
        self.nonfinite += mean.nonfinite();
    }
}

/// The tile's pixels, or None if the watch said stop before the last one: a pixel of very many
/// samples must not make Ctrl-C wait for its whole tile.
fn shade_tile<T: Tally>(
    settings: &Settings,
    tile: &Tile,
    shade: &impl Fn(Pixel, &Sampler, &mut T) -> Color,
) -> Option<Shaded<T>> {
    let mut shaded = Shaded::new(T::default());
    for y in tile.top..tile.top + tile.height {
        for x in tile.left..tile.left + tile.width {
            if settings.watch.stop() {
                return None;
            }
            let number = u64::from(y) * u64::from(settings.width) + u64::from(x);
            let mut mean = Mean::default();
            for index in 0..settings.spp {
                let sampler = Sampler::new(settings.seed, number, index, settings.spp);
                mean.add(shade(Pixel { x, y }, &sampler, &mut shaded.tally));
            }
            shaded.push(&mean);
        }
    }
    Some(shaded)
}

fn assemble<T: Tally>(
    settings: &Settings,
    tiles: &[Tile],
    finished: Vec<Option<Shaded<T>>>,
) -> Rendering<T> {
    let mut film = Film::new(settings.width, settings.height);
    let mut tally = T::default();
    let mut complete = true;
    for (tile, shaded) in tiles.iter().zip(finished) {
        let Some(shaded) = shaded else {
            complete = false;
            continue;
        };
        tally.merge(&shaded.tally);
        film.nonfinite += shaded.nonfinite;
        for (index, color) in (0u32..).zip(shaded.pixels) {
            let (x, y) = (tile.left + index % tile.width, tile.top + index / tile.width);
            *film.pixel_mut(x, y) = color;
        }
    }
    Rendering { film, tally, complete }
}

/// A small rectangle of the film: what a thread does in one go.
#[derive(Debug)]
struct Tile {
    left: u32,
    top: u32,
    width: u32,
    height: u32,
}

/// Small enough that the last tiles keep every thread busy, large enough that handing them out
/// costs nothing.
const TILE_SIDE: u32 = 16;

impl Tile {
    /// Tiles that cover a film, row by row.
    fn cover(width: u32, height: u32) -> Vec<Self> {
        let side = TILE_SIDE as usize;
        let mut tiles = Vec::new();
        for top in (0..height).step_by(side) {
            for left in (0..width).step_by(side) {
                tiles.push(Self {
                    left,
                    top,
                    width: TILE_SIDE.min(width - left),
                    height: TILE_SIDE.min(height - top),
                });
            }
        }
        tiles
    }
}

/// `work` on every tile, results in the tiles' order whichever thread did them.
#[cfg(feature = "native")]
fn run<R: Send>(settings: &Settings, tiles: &[Tile], work: impl Fn(&Tile) -> R + Sync) -> Vec<R> {
    use rayon::prelude::{IntoParallelRefIterator, ParallelIterator};
    match rayon::ThreadPoolBuilder::new().num_threads(settings.threads).build() {
        Ok(pool) => pool.install(|| tiles.par_iter().map(&work).collect()),
        // No new threads are to be had: this one does it all.
        Err(_) => tiles.iter().map(work).collect(),
    }
}

/// A web page has one thread.
#[cfg(not(feature = "native"))]
fn run<R>(_settings: &Settings, tiles: &[Tile], work: impl Fn(&Tile) -> R) -> Vec<R> {
    tiles.iter().map(work).collect()
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;
    use std::sync::atomic::{AtomicU64, Ordering};

    use super::{Settings, Watch, render, render_counted};
    use crate::film::Color;
    use crate::sampler::Purpose;
    use crate::tally::{Counts, Event, Tally};

    const SAMPLES: Event = Event::new(0, 0, "samples");

    fn noisy(threads: usize) -> u64 {
        let settings = Settings { width: 37, height: 21, spp: 5, threads, ..Settings::default() };
        let noise = Purpose::named("noise");
        let rendering = render(&settings, |pixel, sampler| {
            let position = pixel.position(sampler);
            Color::new(position.x, position.y, sampler.stream(0, noise).uniform())
        });
        rendering.film.hash()
    }

    #[test]
    fn any_number_of_threads_gives_the_same_bits() {
        assert!([2, 3, 7].iter().all(|&threads| noisy(threads) == noisy(1)));
    }

    #[test]
    fn every_sample_is_taken_once() {
        let settings = Settings { width: 33, height: 17, spp: 3, ..Settings::default() };
        let rendering = render_counted(&settings, |_, _, tally: &mut Counts| {
            tally.count(SAMPLES, 1);
            Color::ONE
        });
        assert_eq!(rendering.tally.of(SAMPLES), 33 * 17 * 3);
        assert!(rendering.complete && rendering.film.pixels.iter().all(|&p| p == Color::ONE));
    }

    #[test]
    fn nonfinite_samples_are_counted() {
        let settings = Settings { width: 20, height: 9, spp: 2, ..Settings::default() };
        let rendering = render(&settings, |pixel, sampler| {
            let bad = pixel.x == 4 && sampler.index() == 1;
            if bad { Color::NAN } else { Color::new(0.5, 0.25, 2.0) }
        });
        assert_eq!(rendering.film.nonfinite, 9);
        assert_eq!(rendering.film.pixel(4, 3), Color::new(0.5, 0.25, 2.0));
    }

    struct StopAfter(u64, AtomicU64);

    impl Watch for StopAfter {
        fn done(&self, pixels: u64) {
            self.1.fetch_add(pixels, Ordering::Relaxed);
        }

        fn stop(&self) -> bool {
            self.1.load(Ordering::Relaxed) >= self.0
        }
    }

    #[test]
    fn a_stopped_picture_keeps_what_is_done() {
        let watch = Arc::new(StopAfter(300, AtomicU64::new(0)));
        let settings = Settings { width: 64, height: 64, threads: 1, watch, ..Settings::default() };
        let rendering = render(&settings, |_, _| Color::ONE);
        let white = rendering.film.pixels.iter().filter(|&&pixel| pixel == Color::ONE).count();
        assert!(!rendering.complete);
        assert_eq!(white, 512, "two tiles of 16x16");
    }
}
