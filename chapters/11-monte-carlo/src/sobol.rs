//! Points spread more evenly than chance would: the first two dimensions of Sobol's sequence, with
//! their digits scrambled.

use glam::Vec2;

// ANCHOR: pair
/// Point number `index` of the sequence that belongs to `seed`, each coordinate in [0, 1).
///
/// Any 2ᵏ points from a multiple of 2ᵏ on lie one in each of 2ᵏ equal boxes, whatever the boxes'
/// shape. Each point alone is uniform over the square when the seed is. Two seeds give sequences
/// that don't know of each other: their order is shuffled, too.
///
/// Sobol, "On the distribution of points in a cube" (1967); the scrambling is Owen's ("Randomly
/// permuted (t,m,s)-nets and (t,s)-sequences", 1995) by hashing: Burley, "Practical hash-based Owen
/// scrambling" (Journal of Computer Graphics Techniques 9(4), 2020).
#[inline(always)]
pub fn pair(index: u32, seed: u64) -> Vec2 {
    let (order, digits) = (seed as u32, (seed >> 32) as u32);
    let index = scrambled(index, order);
    let x = scrambled_reversed(index, digits).reverse_bits();
    let y = scrambled_reversed(second_reversed(index), digits.rotate_left(16) ^ OTHER);
    Vec2::new(unit(x), unit(y.reverse_bits()))
}
// ANCHOR_END: pair

/// The first coordinate of [`pair`] alone, to the bit.
#[inline(always)]
pub fn first(index: u32, seed: u64) -> f32 {
    let (order, digits) = (seed as u32, (seed >> 32) as u32);
    unit(scrambled_reversed(scrambled(index, order), digits).reverse_bits())
}

/// Makes the scrambling of the second coordinate another one.
const OTHER: u32 = 0x5851_f42d;

// ANCHOR: unit
/// The number in [0, 1) with these 24 leading binary digits. The lowest eight bits have no place in
/// an `f32` just below 1; keeping them rounds the top 128 numbers to 1 (hard case MC-01).
#[inline(always)]
pub fn unit(bits: u32) -> f32 {
    (bits >> 8) as f32 * f32::EPSILON / 2.0
}
// ANCHOR_END: unit

// ANCHOR: second
/// The second coordinate's 32 binary digits, the first of them in the lowest bit.
///
/// The first coordinate of a point is its index with the digits reversed; the second multiplies the
/// index's digits by Pascal's triangle modulo 2. Each step adds the columns of one power of two.
#[inline(always)]
fn second_reversed(index: u32) -> u32 {
    let mut digits = index;
    digits ^= (digits & 0xaaaa_aaaa) >> 1;
    digits ^= (digits & 0xcccc_cccc) >> 2;
    digits ^= (digits & 0xf0f0_f0f0) >> 4;
    digits ^= (digits & 0xff00_ff00) >> 8;
    digits ^ ((digits & 0xffff_0000) >> 16)
}
// ANCHOR_END: second

// ANCHOR: scramble
/// Scrambles digits, the first of which is in the lowest bit: each is flipped or not, as a hash of
/// those before it says.
///
/// Multiplying by an even number, and adding, lets a bit change only higher ones. Laine and Karras,
/// "Stratified sampling for stochastic transparency" (Eurographics Symposium on Rendering 2011), with
/// Vegdahl's constants (2021).
#[inline(always)]
fn scrambled_reversed(digits: u32, seed: u32) -> u32 {
    let mut digits = digits;
    digits ^= digits.wrapping_mul(0x3d20_adea);
    digits = digits.wrapping_add(seed);
    digits = digits.wrapping_mul((seed >> 16) | 1);
    digits ^= digits.wrapping_mul(0x0552_6c56);
    digits ^ digits.wrapping_mul(0x53a2_2864)
}

/// The same for digits whose first is in the highest bit.
#[inline(always)]
fn scrambled(number: u32, seed: u32) -> u32 {
    scrambled_reversed(number.reverse_bits(), seed).reverse_bits()
}
// ANCHOR_END: scramble

#[cfg(test)]
mod tests {
    use super::{first, pair, second_reversed};

    #[test]
    fn the_unscrambled_second_dimension_is_sobol_s() {
        // In the natural order: 0, 1/2, 3/4, 1/4, 5/8, 1/8, 3/8, 7/8.
        let found = [0, 1, 2, 3, 4, 5, 6, 7].map(|index| second_reversed(index).reverse_bits());
        let eighths = found.map(|bits| bits >> 29);
        assert_eq!(eighths, [0, 4, 6, 2, 5, 1, 3, 7]);
    }

    #[test]
    fn one_number_is_the_first_of_two() {
        for index in 0..1000 {
            let seed = u64::from(index).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            assert_eq!(first(index, seed), pair(index, seed).x);
        }
    }

    #[test]
    fn one_point_in_each_box_of_every_shape() {
        for seed in 0..200_u64 {
            let seed = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
            for across in 0..=6 {
                let (columns, rows) = (1 << across, 64 >> across);
                let mut seen = [false; 64];
                for index in 64..128 {
                    let point = pair(index, seed);
                    let column = (point.x * columns as f32) as usize;
                    let row = (point.y * rows as f32) as usize;
                    let cell = &mut seen[row * columns + column];
                    assert!(!*cell, "seed {seed}, {columns} columns");
                    *cell = true;
                }
            }
        }
    }

    #[test]
    fn each_point_alone_is_uniform_over_seeds() {
        // The mean of n uniforms has standard deviation 1 / √(12 n).
        let n = 100_000u64;
        for index in [0, 1, 5, 1000] {
            let seeds = (0..n).map(|seed| seed.wrapping_mul(0x2545_f491_4f6c_dd1d).rotate_left(17));
            let sum = seeds
                .map(|seed| pair(index, seed))
                .fold(glam::DVec2::ZERO, |sum, point| sum + point.as_dvec2());
            let deviation = (sum / n as f64 - 0.5) * (12.0 * n as f64).sqrt();
            assert!(deviation.abs().max_element() < 5.0, "{index}: {deviation}");
        }
    }
}
