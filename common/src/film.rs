//! The film: linear pixels, the average behind each, and how they become a file.

#[cfg(feature = "native")]
pub mod exr;
#[cfg(feature = "native")]
pub mod png;
pub mod srgb;

use glam::{DVec3, Vec3};

/// Linear red, green and blue (Rec. 709 primaries), unbounded above; 1 is display white.
pub type Color = Vec3;

/// A picture in linear light, row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// `width * height` colours, row by row from the top.
    pub pixels: Vec<Color>,
    /// Samples that were NaN or infinite. They are counted here, before anything clamps them, and
    /// left out of their pixel's average.
    pub nonfinite: u64,
}

impl Film {
    /// A black film.
    pub fn new(width: u32, height: u32) -> Self {
        let pixels = vec![Color::ZERO; width as usize * height as usize];
        Self { width, height, pixels, nonfinite: 0 }
    }

    /// A film whose pixel at column `x` and row `y` is `shade(x, y)`.
    pub fn from_fn(width: u32, height: u32, mut shade: impl FnMut(u32, u32) -> Color) -> Self {
        let mut film = Self::new(width, height);
        for y in 0..height {
            for x in 0..width {
                *film.pixel_mut(x, y) = shade(x, y);
            }
        }
        film
    }

    /// The colour at column `x` and row `y`, both from the top left.
    #[inline]
    pub fn pixel(&self, x: u32, y: u32) -> Color {
        self.pixels[self.index(x, y)]
    }

    /// The same, to be changed.
    #[inline]
    pub fn pixel_mut(&mut self, x: u32, y: u32) -> &mut Color {
        let index = self.index(x, y);
        &mut self.pixels[index]
    }

    /// A 64-bit FNV-1a hash over the size and the bits of every pixel: two films have the same
    /// hash when they are the same picture to the last bit.
    pub fn hash(&self) -> u64 {
        let size = [self.width, self.height];
        let bits = self.pixels.iter().flat_map(|pixel| pixel.to_array().map(f32::to_bits));
        size.into_iter().chain(bits).flat_map(u32::to_le_bytes).fold(FNV_OFFSET, fnv1a)
    }

    /// The average colour of each tile of an even `columns` by `rows` grid, row by row: a summary
    /// short enough to be read in a snapshot.
    pub fn tile_means(&self, columns: u32, rows: u32) -> Vec<Color> {
        let edge = |index: u32, count: u32, size: u32| index * size / count;
        let mut means = Vec::new();
        for row in 0..rows {
            for column in 0..columns {
                let mut mean = Mean::default();
                for y in edge(row, rows, self.height)..edge(row + 1, rows, self.height) {
                    for x in
                        edge(column, columns, self.width)..edge(column + 1, columns, self.width)
                    {
                        mean.add(self.pixel(x, y));
                    }
                }
                means.push(mean.color());
            }
        }
        means
    }

    #[inline]
    fn index(&self, x: u32, y: u32) -> usize {
        debug_assert!(x < self.width && y < self.height);
        y as usize * self.width as usize + x as usize
    }
}

/// The running average of a pixel's samples.
///
/// The sum is kept in `f64`: an `f32` sum of ones sticks at 2²⁴ = 16,777,216 (hard case FI-01).
#[derive(Clone, Copy, Debug, Default)]
pub struct Mean {
    sum: DVec3,
    samples: u64,
    nonfinite: u64,
}

impl Mean {
    /// Takes in one sample. One that is NaN or infinite is counted and otherwise ignored, so that
    /// it can't blacken the pixel and can't hide either.
    #[inline]
    pub fn add(&mut self, sample: Color) {
        if sample.is_finite() {
            self.sum += sample.as_dvec3();
            self.samples += 1;
        } else {
            self.nonfinite += 1;
        }
    }

    /// The average of the finite samples; black where there were none.
    #[inline]
    pub fn color(&self) -> Color {
        if self.samples == 0 { Color::ZERO } else { (self.sum / self.samples as f64).as_vec3() }
    }

    /// How many samples were NaN or infinite.
    #[inline]
    pub fn nonfinite(&self) -> u64 {
        self.nonfinite
    }
}

const FNV_OFFSET: u64 = 0xcbf2_9ce4_8422_2325;

/// One step of the Fowler-Noll-Vo hash, variant 1a, 64 bits.
fn fnv1a(hash: u64, byte: u8) -> u64 {
    (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
}

#[cfg(test)]
mod tests {
    use super::{Color, Film, Mean};

    #[test]
    fn the_hash_sees_the_sign_of_zero_and_the_shape() {
        let wide = Film::new(3, 2);
        let tall = Film::new(2, 3);
        let mut negative = wide.clone();
        negative.pixel_mut(0, 0).x = -0.0;
        assert_ne!(wide.hash(), tall.hash());
        assert_ne!(wide.hash(), negative.hash());
    }

    #[test]
    fn the_hash_is_fnv_1a() {
        // The published test vector: FNV-1a of "a" is af63dc4c8601ec8c.
        assert_eq!(super::fnv1a(super::FNV_OFFSET, b'a'), 0xaf63_dc4c_8601_ec8c);
    }

    #[test]
    fn one_bad_sample_neither_blackens_the_pixel_nor_hides() {
        let mut mean = Mean::default();
        mean.add(Color::new(1.0, 2.0, 3.0));
        mean.add(Color::new(f32::NAN, 0.0, 0.0));
        mean.add(Color::new(3.0, 2.0, f32::INFINITY));
        assert_eq!(mean.color(), Color::new(1.0, 2.0, 3.0));
        assert_eq!(mean.nonfinite(), 2);
    }

    #[test]
    fn tile_means_of_a_lopsided_film() {
        let film = Film::from_fn(5, 3, |x, y| Color::new(x as f32, y as f32, 1.0));
        let means = film.tile_means(2, 1);
        assert_eq!(means, [Color::new(0.5, 1.0, 1.0), Color::new(3.0, 1.0, 1.0)]);
    }
}
