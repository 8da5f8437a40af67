//! Three kinds of points of the unit square.

use common::sampler::{Purpose, Sampler, Stream};
use glam::Vec2;

use crate::{sobol, strata};

// ANCHOR: points
/// How the points of the unit square are spread.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "native", derive(clap::ValueEnum))]
pub enum Points {
    /// Each knows nothing of the others
    Random,
    /// One in each cell of a grid
    Stratified,
    /// The points of a scrambled Sobol sequence
    #[default]
    Sobol,
}

impl Points {
    /// Point number `index` of `count`, at least 1; each `seed` has points of its own.
    #[inline]
    pub fn at(self, index: u32, count: u32, seed: u64) -> Vec2 {
        match self {
            Self::Random => Stream::of_trial(seed, u64::from(index)).uniform2(),
            Self::Stratified => stratified(index, count, seed),
            Self::Sobol => {
                sobol::pair(index, Sampler::new(seed, 0, 0, 1).shared(0, Purpose::named("points")))
            }
        }
    }
}

/// A grid of as many columns as rows, or one row more or several; what doesn't fit is random.
#[inline]
fn stratified(index: u32, count: u32, seed: u64) -> Vec2 {
    let u = Points::Random.at(index, count, seed);
    let columns = count.isqrt().max(1);
    let rows = count / columns;
    if index >= columns * rows {
        return u;
    }
    let (column, row) = (index % columns, index / columns);
    Vec2::new(strata::place(column, columns, u.x), strata::place(row, rows, u.y))
}
// ANCHOR_END: points

impl Points {
    /// All kinds.
    pub const ALL: [Self; 3] = [Self::Random, Self::Stratified, Self::Sobol];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Stratified => "stratified",
            Self::Sobol => "Sobol",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Points;

    #[test]
    fn one_in_each_cell() {
        for points in [Points::Stratified, Points::Sobol] {
            let mut cells = [0; 64];
            for index in 0..64 {
                let at = points.at(index, 64, 9);
                cells[(at.y * 8.0) as usize * 8 + (at.x * 8.0) as usize] += 1;
            }
            assert_eq!(cells, [1; 64], "{points:?}");
        }
    }

    #[test]
    fn any_count_stays_in_the_square() {
        for points in Points::ALL {
            for count in [1, 2, 3, 5, 7, 12, 99, 1000] {
                for index in 0..count {
                    let at = points.at(index, count, 4);
                    assert!(at.min_element() >= 0.0 && at.max_element() < 1.0, "{points:?} {at}");
                }
            }
        }
    }
}
