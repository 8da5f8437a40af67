//! Sixteen paths side by side, for scenes of a few matte triangles.
//!
//! A processor does one operation on eight or sixteen numbers as fast as on one. A path tracer that
//! follows one path gives it one number at a time. This one follows sixteen, and does each step for all
//! of them before the next. The steps are those of chapters 12 to 14: the same functions in the same
//! order, so the picture is the same to the last bit.

mod column;
mod fresh;
mod lamps;
mod paths;
mod room;
mod sights;
mod vertices;
mod waiting;

use std::ops::Range;

use common::film::{Color, Mean};
use common::render::bands::render_bands;
use common::render::{Rendering, Settings};
use common::tally::Tally;
use light_sampling::lights::Lights;
use path_tracing::lambert::Lambert;
use path_tracing::strategy::Ending;
use path_tracing::world::World;
use pulp::{Arch, NullaryFnOnce};
use ray_casting::camera::{CAMERA_RAYS, Camera};
use triangles::bundle::RAYS;

use fresh::{Cursor, Fresh};
use paths::{Paths, Tracer};
use room::Room;
use waiting::Waiting;

/// Rows of pixels that a thread does in one go.
const ROWS: u32 = 8;
/// Samples after which sixteen paths wait for the last of them, and Ctrl-C is heard.
const BATCH: usize = 1 << 14;

/// A small scene of matte triangles, its lamps looked at by their area.
#[derive(Debug)]
pub struct Abreast<'a, E> {
    room: Room,
    ending: E,
    depth: u32,
    camera: Camera,
    settings: &'a Settings,
    start: Start,
}

impl<'a, E: Ending + Copy> Abreast<'a, E> {
    /// The scene, if it is one of a few matte triangles and nothing else.
    pub fn new(
        world: &World<Lambert>,
        camera: &Camera,
        lights: &Lights,
        (ending, depth): (E, u32),
        settings: &'a Settings,
    ) -> Option<Self> {
        let room = Room::new(world, lights)?;
        let camera = camera.with_film(settings.width, settings.height);
        Some(Self { room, ending, depth, camera, settings, start: Start::default() })
    }

    /// The same, with paths that start so: the picture doesn't change.
    pub fn starting(self, start: Start) -> Self {
        Self { start, ..self }
    }

    /// The picture.
    pub fn draw<T: Tally>(&self) -> Rendering<T> {
        render_bands(self.settings, ROWS, |rows, tally| self.band(rows, tally))
    }

    /// Some rows of pixels, or `None` if the watch said stop.
    fn band<T: Tally>(&self, rows: Range<u32>, tally: &mut T) -> Option<Vec<Mean>> {
        let (width, spp) = (self.settings.width as usize, self.settings.spp as usize);
        let first = rows.start as usize * width * spp;
        let mut means = vec![Mean::default(); width * rows.len()];
        let mut colors = vec![Color::ZERO; BATCH];
        for start in (0..means.len() * spp).step_by(BATCH) {
            if self.settings.watch.stop() {
                return None;
            }
            let count = BATCH.min(means.len() * spp - start);
            let colors = &mut colors[..count];
            Arch::new().dispatch(Batch { abreast: self, first: first + start, colors, tally });
            for (sample, color) in (start..).zip(colors.iter()) {
                means[sample / spp].add(*color);
            }
        }
        Some(means)
    }
}

/// When paths start.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Start {
    /// As soon as another one has ended.
    #[default]
    AtOnce,
    /// When all have ended: what not to do.
    Together,
}

/// Samples of the film, numbered pixel by pixel.
struct Batch<'a, E, T> {
    abreast: &'a Abreast<'a, E>,
    first: usize,
    colors: &'a mut [Color],
    tally: &'a mut T,
}

impl<E: Ending + Copy, T: Tally> NullaryFnOnce for Batch<'_, E, T> {
    type Output = ();

    // ANCHOR: batch
    #[inline(always)]
    fn call(self) {
        let Self { abreast, first, colors, tally } = self;
        let Abreast { room, ending, depth, camera, settings, start } = abreast;
        let tracer = Tracer { room, ending: *ending, depth: *depth };
        let (mut paths, mut waiting, mut next) = (Paths::new(), Waiting::new(), 0);
        colors.fill(Color::ZERO);
        let mut cursor = Cursor::at(first as u64, settings);
        let mut fresh = Fresh::new();
        loop {
            let all_ended = !paths.used.contains(&true);
            for path in 0..RAYS {
                let has_room = !paths.used[path] && (all_ended || *start == Start::AtOnce);
                if has_room && next < colors.len() {
                    if next % RAYS == 0 {
                        fresh.fill(&mut cursor, camera, settings);
                    }
                    paths.start(path, next, &fresh, next % RAYS);
                    next += 1;
                }
            }
            if !paths.used.contains(&true) {
                break;
            }
            paths.step(&tracer, &mut waiting, colors, tally);
        }
        waiting.ask(&room.few, colors, tally);
        tally.count(CAMERA_RAYS, colors.len() as u64);
    }
    // ANCHOR_END: batch
}

#[cfg(test)]
mod tests;
