//! Where in each pixel the picture is sampled: on the same grid as the vertices.

use common::render::Pixel;
use common::sampler::Sampler;
use glam::{DVec2, Vec2};

use crate::fixed::{Fixed, STEPS};

// ANCHOR: offset
/// Where in its pixel a sample lies, in 1/256 pixel: the sampler's place, rounded down.
///
/// Both orders sample here, and one sample a pixel lies in the pixel's centre.
pub fn offset(sampler: &Sampler) -> Fixed {
    let offset = sampler.pixel_offset() * STEPS as f32;
    Fixed { x: offset.x as i32, y: offset.y as i32 }
}
// ANCHOR_END: offset

/// A sample's place on the film, in pixels. It is exact.
pub fn position(pixel: Pixel, offset: Fixed) -> Vec2 {
    let step = 1.0 / STEPS as f32;
    let inside = Vec2::new(offset.x as f32, offset.y as f32) * step;
    Vec2::new(pixel.x as f32, pixel.y as f32) + inside
}

/// The same for `f64` arithmetic.
pub fn exact_position(pixel: Pixel, offset: Fixed) -> DVec2 {
    position(pixel, offset).as_dvec2()
}

/// A sample for each pixel: where in the pixel it lies.
pub trait Samples {
    /// The offset in the pixel, in 1/256 pixel, each coordinate from 0 to 255.
    fn offset(&self, pixel: Pixel) -> Fixed;
}

/// One sample in the centre of each pixel. The compiler knows the numbers, so it costs nothing.
#[derive(Clone, Copy, Debug)]
pub struct Centres;

impl Samples for Centres {
    #[inline(always)]
    fn offset(&self, _pixel: Pixel) -> Fixed {
        Fixed { x: STEPS / 2, y: STEPS / 2 }
    }
}

/// One sample anywhere in each pixel of some rows.
#[derive(Clone, Debug)]
pub struct Scattered {
    width: u32,
    top: u32,
    offsets: Vec<Fixed>,
}

impl Scattered {
    /// The samples of `rows`, each `width` pixels wide; `sampler` gives a pixel's random numbers.
    pub fn new(width: u32, rows: std::ops::Range<u32>, sampler: impl Fn(Pixel) -> Sampler) -> Self {
        let top = rows.start;
        let pixels = rows.flat_map(|y| (0..width).map(move |x| Pixel { x, y }));
        Self { width, top, offsets: pixels.map(|pixel| offset(&sampler(pixel))).collect() }
    }
}

impl Samples for Scattered {
    #[inline]
    fn offset(&self, pixel: Pixel) -> Fixed {
        let row = (pixel.y - self.top) as usize;
        self.offsets[row * self.width as usize + pixel.x as usize]
    }
}

#[cfg(test)]
mod tests {
    use common::render::Pixel;
    use common::sampler::Sampler;
    use glam::Vec2;

    use super::{Centres, Samples, Scattered, offset, position};

    #[test]
    fn one_sample_is_the_centre() {
        let only = Sampler::new(5, 77, 0, 1);
        let pixel = Pixel { x: 12, y: 900 };
        assert_eq!(offset(&only), Centres.offset(pixel));
        assert_eq!(position(pixel, offset(&only)), Vec2::new(12.5, 900.5));
    }

    #[test]
    fn scattered_samples_are_those_of_the_sampler() {
        let sampler = |pixel: Pixel| Sampler::new(5, u64::from(pixel.y * 7 + pixel.x), 2, 4);
        let samples = Scattered::new(7, 3..6, sampler);
        for y in 3..6 {
            for x in 0..7 {
                let pixel = Pixel { x, y };
                assert_eq!(samples.offset(pixel), offset(&sampler(pixel)));
                assert!((0..256).contains(&samples.offset(pixel).x));
            }
        }
    }
}
