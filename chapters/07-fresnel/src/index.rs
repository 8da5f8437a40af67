//! The index of refraction: how many times slower light is in a medium.

use std::str::FromStr;

// ANCHOR: index
/// How many times slower light is in a medium than in a vacuum: 1 for air, about 1.33 for water,
/// 1.5 for glass. From [`Index::LEAST`] to [`Index::MOST`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Index(f32);
// ANCHOR_END: index

/// Why a number is no index of refraction.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("an index of refraction is a number from 0.001 to 1000, such as 1.5; {0} is not")]
pub struct NoIndex(f32);

impl Index {
    /// A vacuum; air is nearly one.
    pub const AIR: Self = Self(1.0);
    /// Water.
    pub const WATER: Self = Self(1.33);
    /// Window glass, and the report's glass ball.
    pub const GLASS: Self = Self(1.5);
    /// Diamond.
    pub const DIAMOND: Self = Self(2.42);
    /// The smallest that an MTL file may have.
    pub const LEAST: f32 = 0.001;
    /// The largest. Radiance grows with the index's square, and has to stay a number.
    pub const MOST: f32 = 1000.0;

    /// The index `number`. Fails for one that is too small, too large or NaN.
    pub fn new(number: f32) -> Result<Self, NoIndex> {
        let possible = (Self::LEAST..=Self::MOST).contains(&number);
        if possible { Ok(Self(number)) } else { Err(NoIndex(number)) }
    }

    /// The number itself, with twice the digits: what is computed from it keeps them.
    pub fn number(self) -> f64 {
        f64::from(self.0)
    }
}

impl FromStr for Index {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = text.trim().parse();
        let number = number.map_err(|_| "an index of refraction is a number, such as 1.5")?;
        Self::new(number).map_err(|error| error.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::Index;

    #[test]
    fn numbers_that_are_no_indices() {
        for bad in [0.0, -0.0, -1.5, 0.000_9, 1000.1, f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            let message = Index::new(bad).expect_err("no index").to_string();
            assert!(message.contains("0.001") && message.contains(&bad.to_string()), "{message}");
        }
        for bad in ["", "glass", "1,5", "1e400", "nan", "-2"] {
            assert!(bad.parse::<Index>().is_err(), "{bad}");
        }
    }

    #[test]
    fn numbers_that_are() {
        for good in [0.001, 0.75, 1.0, 2.42, 1000.0] {
            assert_eq!(Index::new(good).map(Index::number), Ok(f64::from(good)));
        }
        assert_eq!(" 1.5".parse(), Ok(Index::GLASS));
    }
}
