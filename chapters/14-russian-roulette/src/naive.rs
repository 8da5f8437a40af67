//! Roulettes that are not right on average.

use common::film::Color;
use path_tracing::random::Random;
use path_tracing::strategy::Ending;

use crate::roulette::SURVIVAL;

// ANCHOR: report
/// The report's line (section 5.3), which contradicts its equation 4-5: it *stops* with the
/// probability P, and divides by P. What a path brings counts (1 - P) / P on average at each surface,
/// which is 1 for P = 0.5 alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report {
    /// P, from 0 to 1, both excluded.
    pub probability: f32,
}

impl Ending for Report {
    #[inline]
    fn factor(&self, _throughput: Color, _bounce: u32, random: &Random) -> Option<f32> {
        report(self.probability, random.number(SURVIVAL))
    }
}

/// What a path counts if it goes on, `None` if it ends.
#[inline]
pub fn report(probability: f32, chance: f32) -> Option<f32> {
    if chance < probability {
        return None;
    }
    Some(1.0 / probability)
}
// ANCHOR_END: report

// ANCHOR: unweighted
/// Ends paths by chance, and forgets that those that go on stand for the others.
#[inline]
pub fn unweighted(probability: f32, chance: f32) -> Option<f32> {
    (chance < probability).then_some(1.0)
}
// ANCHOR_END: unweighted

// ANCHOR: textbook
/// The textbook's: as often as the throughput says, however little that is. A black path goes on if
/// `chance` is exactly 0, and 0 / 0 is no number.
#[inline]
pub fn textbook(throughput: Color, chance: f32) -> Option<f32> {
    let probability = throughput.max_element().min(1.0);
    if chance > probability {
        return None;
    }
    Some(1.0 / probability)
}
// ANCHOR_END: textbook

#[cfg(test)]
mod tests {
    use common::film::Color;

    use super::{report, textbook};

    #[test]
    fn by_hand_a_quarter() {
        // Of ten evenly spread chances two go on, and count 1.25 each: 2.5 of 10.
        let sum: f32 = (0..10).filter_map(|tenth| report(0.8, (tenth as f32 + 0.5) / 10.0)).sum();
        assert!((sum / 10.0 - 0.25).abs() < 1e-6);
    }

    #[test]
    fn the_textbook_divides_zero_by_zero() {
        let factor = textbook(Color::ZERO, 0.0).expect("it goes on");
        assert!((Color::ZERO * factor).is_nan());
        assert_eq!(textbook(Color::ZERO, f32::EPSILON / 2.0), None);
    }
}
