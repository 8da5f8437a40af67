//! Paths that are about to start, sixteen at a time.

use common::render::{Pixel, Settings};
use common::sampler::{Sampler, Samplers};
use path_tracing::shot::position;
use ray_casting::camera::Camera;
use triangles::bundle::{RAYS, Vectors};

/// Samples of the film in their order: pixel by pixel, row by row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cursor {
    pixel: Pixel,
    index: u32,
}

impl Cursor {
    /// At sample number `number` of the film.
    pub(super) fn at(number: u64, settings: &Settings) -> Self {
        let (pixel, index) = (number / u64::from(settings.spp), number % u64::from(settings.spp));
        let width = u64::from(settings.width);
        let (x, y) = ((pixel % width) as u32, (pixel / width) as u32);
        Self { pixel: Pixel { x, y }, index: index as u32 }
    }

    #[inline(always)]
    fn step(&mut self, settings: &Settings) {
        self.index += 1;
        if self.index == settings.spp {
            self.index = 0;
            self.pixel.x += 1;
        }
        if self.pixel.x == settings.width {
            self.pixel = Pixel { x: 0, y: self.pixel.y + 1 };
        }
    }
}

/// Sixteen samples, and the camera's rays for them.
pub(super) struct Fresh {
    pub(super) samplers: Samplers<RAYS>,
    pub(super) origin: Vectors,
    pub(super) direction: Vectors,
}

impl Fresh {
    /// None yet.
    #[inline(always)]
    pub(super) fn new() -> Self {
        let samplers = Samplers::splat(Sampler::new(0, 0, 0, 1));
        Self { samplers, origin: Vectors::ZERO, direction: Vectors::ZERO }
    }

    /// The next sixteen from `cursor` on. The last may be beyond the film, and mean nothing.
    #[inline(always)]
    pub(super) fn fill(&mut self, cursor: &mut Cursor, camera: &Camera, settings: &Settings) {
        let (mut x, mut y, mut index) = ([0; RAYS], [0; RAYS], [0; RAYS]);
        for path in 0..RAYS {
            (x[path], y[path], index[path]) = (cursor.pixel.x, cursor.pixel.y, cursor.index);
            cursor.step(settings);
        }
        for path in 0..RAYS {
            let pixel = Pixel { x: x[path], y: y[path] };
            let number = u64::from(pixel.y) * u64::from(settings.width) + u64::from(pixel.x);
            let sampler = Sampler::new(settings.seed, number, index[path], settings.spp);
            let ray = camera.ray(position(pixel, &sampler));
            self.samplers.set(path, sampler);
            self.origin.set(path, ray.origin);
            self.direction.set(path, ray.direction);
        }
    }
}
