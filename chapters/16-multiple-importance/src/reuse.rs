//! Paths that neighbouring pixels share.
//!
//! Pixels that lie side by side mostly see the same wall, and what one of them finds out about the
//! light in a corner of the room is true for all. So each pixel of a small square starts one path, and
//! all look at the second vertices of all. A vertex could have been found by any pixel that sees it:
//! these are so many strategies, and the balance heuristic shares it among them.
//!
//! Philippe Bekaert, Mateu Sbert and John Halton, "Accelerating path tracing by re-using paths"
//! (Eurographics Workshop on Rendering, 2002).

mod block;
mod claim;

use std::ops::Range;

use common::film::{Color, Mean};
use common::render::bands::render_bands;
use common::render::{Rendering, Settings};
use common::tally::{Event, Tally};
use path_tracing::bsdf::Bsdf;
use path_tracing::random::Random;
use path_tracing::shot::{ByPixel, Exposure, position};
use path_tracing::space::Met;
use path_tracing::strategy::{Ending, Lighting, Never};
use path_tracing::tracer::{PathTracer, Segment};
use path_tracing::vertex::Vertex;
use ray_casting::camera::{CAMERA_RAYS, Camera};

use block::Block;
pub use claim::Division;
use claim::{First, Source};

/// Paths of other pixels that counted for one.
pub const REUSED_PATHS: Event = Event::new(16, 0, "reused_paths");

// ANCHOR: reuse
/// The film in squares of pixels that share their paths.
#[derive(Clone, Copy, Debug)]
pub struct Reuse {
    /// Pixels along a side of a square: a power of two. 1 shares nothing.
    pub side: u32,
    /// How a vertex is divided among those who could have found it.
    pub division: Division,
}
// ANCHOR_END: reuse

impl Exposure for Reuse {
    fn expose<B, L, E, T, const EMITTERS: bool, const SKY: bool>(
        &self,
        tracer: &PathTracer<B, L, E, EMITTERS, SKY>,
        camera: &Camera,
        settings: &Settings,
    ) -> Rendering<T>
    where
        B: Bsdf,
        L: Lighting + Copy,
        E: Ending + Copy,
        T: Tally,
    {
        if self.side == 1 || tracer.depth == 0 {
            return ByPixel.expose(tracer, camera, settings);
        }
        let squares = Squares { tracer, camera, settings, division: self.division };
        let side = self.side;
        render_bands(settings, side, |rows, tally| squares.band(rows, side, tally))
    }
}

/// A film that is being exposed.
struct Squares<'a, B, L, E, const EMITTERS: bool, const SKY: bool> {
    tracer: &'a PathTracer<'a, B, L, E, EMITTERS, SKY>,
    camera: &'a Camera,
    settings: &'a Settings,
    division: Division,
}

/// What a pixel sees.
struct Seen {
    /// The pixel's place in its block.
    place: usize,
    segment: Segment,
    met: Met,
}

impl<B: Bsdf, L: Lighting + Copy, E: Ending + Copy, const EMITTERS: bool, const SKY: bool>
    Squares<'_, B, L, E, EMITTERS, SKY>
{
    /// Some rows of pixels, or `None` if the watch said stop.
    fn band<T: Tally>(&self, rows: Range<u32>, side: u32, tally: &mut T) -> Option<Vec<Mean>> {
        let width = self.settings.width as usize;
        let mut means = vec![Mean::default(); width * rows.len()];
        for block in Block::across(self.settings, side, rows.clone()) {
            for index in 0..self.settings.spp {
                if self.settings.watch.stop() {
                    return None;
                }
                let colors = self.sample(&block, index, tally);
                for (pixel, color) in block.pixels.iter().zip(colors) {
                    let row = (pixel.y - rows.start) as usize;
                    means[row * width + pixel.x as usize].add(color);
                }
            }
        }
        Some(means)
    }

    // ANCHOR: sample
    /// Sample number `index` of all pixels of a block.
    fn sample<T: Tally>(&self, block: &Block, index: u32, tally: &mut T) -> Vec<Color> {
        let mut colors = vec![Color::ZERO; block.pixels.len()];
        let seen = self.seen(block, index, &mut colors, tally);
        let (mut firsts, mut sources) = (Vec::new(), Vec::new());
        for Seen { place, segment, met } in &seen {
            let surface = &self.tracer.world.surfaces[met.owner as usize];
            let vertex = Vertex::new(&segment.ray, met, &surface.bsdf);
            let color = &mut colors[*place];
            *color += self.tracer.emitted(&surface.emission, &vertex, segment, tally);
            let random = Random::at(&block.own(*place, index), 1);
            *color += self.tracer.direct(&vertex, segment, &random, tally);
            let first = First { place: *place, vertex };
            let source = self.source(&first, segment, block, index, color, tally);
            sources.extend(source);
            if surface.bsdf.spreads() {
                firsts.push(first);
            }
        }
        let space = self.tracer.world.space;
        for source in &sources {
            source.divide(space, &firsts, self.division, &mut colors, tally);
        }
        colors
    }
    // ANCHOR_END: sample

    /// What the pixels of a block see; those that see nothing get the sky.
    fn seen<T: Tally>(
        &self,
        block: &Block,
        index: u32,
        colors: &mut [Color],
        tally: &mut T,
    ) -> Vec<Seen> {
        let mut seen = Vec::with_capacity(colors.len());
        for (place, color) in colors.iter_mut().enumerate() {
            let on_film = position(block.pixels[place], &block.own(place, index));
            let segment = Segment::from_eye(self.camera.ray(on_film));
            tally.count(CAMERA_RAYS, 1);
            match self.tracer.world.space.nearest(&segment.ray, tally) {
                Some(met) => seen.push(Seen { place, segment, met }),
                None => *color += self.tracer.sky(tally),
            }
        }
        seen
    }

    // ANCHOR: source
    /// The second vertex of a pixel's path, if all may use it. What only this path could find counts
    /// for its pixel at once: lamps and the sky that it comes upon, all that a mirror shows, and all that
    /// leaves a surface differently in each direction.
    fn source<T: Tally>(
        &self,
        first: &First<B>,
        segment: &Segment,
        block: &Block,
        index: u32,
        color: &mut Color,
        tally: &mut T,
    ) -> Option<Source> {
        let sampler = block.shared(first.place, index);
        // No roulette yet: it would be part of the density with which the vertex is found.
        let tracer = self.tracer;
        let (world, lighting, depth) = (tracer.world, tracer.lighting, tracer.depth);
        let going = PathTracer::<_, _, _, EMITTERS, SKY> { world, lighting, ending: Never, depth };
        let onward = going.onward(&first.vertex, segment, &Random::at(&sampler, 1), tally)?;
        if onward.departure.is_delta {
            *color += tracer.follow(onward, &sampler, tally);
            return None;
        }
        let Some(met) = world.space.nearest(&onward.ray, tally) else {
            *color += onward.throughput * tracer.sky(tally);
            return None;
        };
        let surface = &world.surfaces[met.owner as usize];
        let vertex = Vertex::new(&onward.ray, &met, &surface.bsdf);
        *color += tracer.emitted(&surface.emission, &vertex, &onward, tally);
        let unweighted = Segment { throughput: Color::ONE, ..onward };
        let radiance = tracer.reflected(&vertex, &unweighted, &sampler, tally);
        if !surface.bsdf.is_diffuse() {
            *color += onward.throughput * radiance;
            return None;
        }
        let side = -onward.ray.direction.dot(met.hit.geometric);
        let Segment { throughput, .. } = onward;
        let source = Source { place: first.place, hit: met.hit, side, radiance, throughput };
        (radiance != Color::ZERO).then_some(source)
    }
    // ANCHOR_END: source
}

#[cfg(test)]
mod tests;
