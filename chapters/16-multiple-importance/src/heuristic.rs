//! How much a sample counts that another strategy could have found as well.

// ANCHOR: heuristic
/// Rules that share one light among the strategies that can find it.
///
/// Eric Veach and Leonidas Guibas, "Optimally combining sampling techniques for Monte Carlo
/// rendering" (SIGGRAPH 1995).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Heuristic {
    /// Each strategy's share is its part of all densities: equation 9.8 of Veach's thesis (1997).
    Balance,
    /// The same with squared densities, which leaves less to those that are unlikely: his equation
    /// 9.13 with the exponent 2.
    #[default]
    Power,
}
// ANCHOR_END: heuristic

impl Heuristic {
    // ANCHOR: weight
    /// The share, from 0 to 1, of a sample that its strategy found with the density `own`, and that
    /// the other one would have found with the density `other`. Both are at least 0, in the same
    /// unit. What a strategy never finds is none of its own: 0, and all the other's.
    ///
    /// The shares of two strategies add up to 1, though squares of densities are no `f32` any more
    /// (hard cases MI-01 to MI-03): the ratio comes first.
    #[inline]
    pub fn weight(self, own: f32, other: f32) -> f32 {
        if !(own > 0.0) {
            return 0.0;
        }
        // Two densities without a limit: neither is the surer one.
        let ratio = if own == other { 1.0 } else { other / own };
        match self {
            Self::Balance => 1.0 / (1.0 + ratio),
            Self::Power => 1.0 / (1.0 + ratio * ratio),
        }
    }
    // ANCHOR_END: weight

    // ANCHOR: among
    /// The share of strategy number `own` among any number of them.
    #[inline]
    pub fn among(self, densities: &[f32], own: usize) -> f32 {
        let Some(&density) = densities.get(own).filter(|density| **density > 0.0) else {
            return 0.0;
        };
        let against = |&other: &f32| {
            let ratio = if other == density { 1.0 } else { other / density };
            match self {
                Self::Balance => ratio,
                Self::Power => ratio * ratio,
            }
        };
        1.0 / densities.iter().map(against).sum::<f32>()
    }
    // ANCHOR_END: among
}

#[cfg(test)]
mod tests {
    use super::Heuristic::{self, Balance, Power};
    use crate::naive;

    /// 2⁻¹²⁷ to 2¹²⁷, all the powers of two there are.
    fn powers() -> impl Iterator<Item = f32> + Clone {
        (-127..=127).map(|exponent| libm::ldexpf(1.0, exponent))
    }

    fn violations(weight: impl Fn(f32, f32) -> f32) -> usize {
        let pairs = powers().flat_map(|one| powers().map(move |other| (one, other)));
        let sums = pairs.map(|(one, other)| weight(one, other) + weight(other, one));
        sums.filter(|sum| !((sum - 1.0).abs() <= 1e-6)).count()
    }

    /// *By hand:* densities 6 and 2 share as 3/4 and 1/4, and their squares as 9/10 and 1/10.
    #[test]
    fn by_hand() {
        assert_eq!((Balance.weight(6.0, 2.0), Balance.weight(2.0, 6.0)), (0.75, 0.25));
        let [large, small] = [Power.weight(6.0, 2.0), Power.weight(2.0, 6.0)];
        assert!((large - 0.9).abs() < 1e-6 && (small - 0.1).abs() < 1e-6);
    }

    /// *By hand:* with 6 and 2, a direction where f is 3 counts 3/8 whoever found it; its mean square,
    /// for each unit of f², is 1/8, and with shares of one half it is 1/6.
    #[test]
    fn by_hand_balance_has_the_least_mean_square() {
        let [lamp, lobe] = [6.0, 2.0];
        let [one, other] = [Balance.weight(lamp, lobe), Balance.weight(lobe, lamp)];
        assert_eq!((one * 3.0 / lamp, other * 3.0 / lobe), (0.375, 0.375));
        let square = |share: f32| share * share / lamp + (1.0 - share) * (1.0 - share) / lobe;
        assert!((square(one) - 1.0 / 8.0).abs() < 1e-6);
        assert!((square(0.5) - 1.0 / 6.0).abs() < 1e-6 && (square(1.0) - 1.0 / 6.0).abs() < 1e-6);
        assert!((0..=100).all(|part| square(part as f32 / 100.0) >= square(one)));
    }

    /// MI-01, all 65025 pairs.
    #[test]
    fn shares_add_up_to_one_for_all_exponents() {
        assert_eq!([Balance, Power].map(|rule| violations(|f, g| rule.weight(f, g))), [0, 0]);
        assert_eq!(violations(naive::power), 31_353);
        assert_eq!(violations(naive::infinite_is_one), 6_905);
    }

    /// MI-02 and MI-03.
    #[test]
    fn what_is_never_found_and_what_is_always_found() {
        for rule in [Balance, Power] {
            assert_eq!(rule.weight(0.0, 0.0), 0.0);
            assert_eq!((rule.weight(0.0, 3.0), rule.weight(3.0, 0.0)), (0.0, 1.0));
            let limit = f32::INFINITY;
            assert_eq!((rule.weight(limit, 3.0), rule.weight(3.0, limit)), (1.0, 0.0));
            assert_eq!(rule.weight(limit, limit), 0.5);
            assert_eq!(rule.weight(f32::NAN, 1.0), 0.0);
            assert!(rule.weight(1.0, f32::NAN).is_nan(), "it is seen, and counted");
        }
    }

    /// MI-04: three strategies, and five.
    #[test]
    fn shares_of_many_add_up_to_one() {
        let sum = |rule: Heuristic, densities: &[f32]| {
            (0..densities.len()).map(|own| rule.among(densities, own)).sum::<f32>()
        };
        for rule in [Balance, Power] {
            for one in powers().step_by(5) {
                for two in powers().step_by(5) {
                    for three in powers().step_by(5) {
                        let densities = [one, two, three];
                        assert!((sum(rule, &densities) - 1.0).abs() < 1e-6, "{densities:?}");
                    }
                }
            }
            assert!((sum(rule, &[3.0, 0.0, 1e30, 1e-30, 7.0]) - 1.0).abs() < 1e-6);
            assert_eq!(sum(rule, &[0.0, 0.0]), 0.0);
            assert_eq!(rule.among(&[1.0], 1), 0.0);
        }
    }

    #[test]
    fn two_are_many() {
        for rule in [Balance, Power] {
            for (own, other) in [(1.0, 3.0), (0.2, 0.0), (0.0, 2.0), (1e30, 1e25), (5.0, 5.0)] {
                assert_eq!(rule.weight(own, other), rule.among(&[own, other], 0));
            }
        }
    }
}
