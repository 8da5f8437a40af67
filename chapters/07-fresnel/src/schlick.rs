//! Schlick's approximation of how much glass reflects.

use crate::interface::Interface;

// ANCHOR: reflectance
/// About the part of the light that an interface reflects, for the cosine on this side.
///
/// Schlick, "An inexpensive BRDF model for physically-based rendering" (Eurographics 1994),
/// equation 15. It was made for light that enters a denser medium; light that leaves one is
/// reflected as much as light that enters along the same path, so the larger angle counts: the one
/// in the thinner medium.
pub fn reflectance(interface: &Interface, cosine: f64) -> f64 {
    let far_cosine = interface.far_cosine(cosine);
    far_cosine.map_or(1.0, |far_cosine| between(interface, cosine, far_cosine))
}

/// The same where both cosines are known.
pub fn between(interface: &Interface, cosine: f64, far_cosine: f64) -> f64 {
    if interface.is_none() {
        return 0.0;
    }
    let thinner = if interface.rest() > 0.0 { cosine } else { far_cosine };
    polynomial(straight(interface), thinner)
}

/// What an interface reflects of light that comes straight upon it.
pub fn straight(interface: &Interface) -> f64 {
    let ratio = interface.ratio();
    let amplitude = (1.0 - ratio) / (1.0 + ratio);
    amplitude * amplitude
}

/// From `straight` at cosine 1 to 1 at cosine 0, with the fifth power of 1 - cosine.
pub fn polynomial(straight: f64, cosine: f64) -> f64 {
    let x = (1.0 - cosine).clamp(0.0, 1.0);
    straight + (1.0 - straight) * (x * x) * (x * x) * x
}
// ANCHOR_END: reflectance

#[cfg(test)]
mod tests {
    use super::{polynomial, reflectance};
    use crate::dielectric;
    use crate::index::Index;
    use crate::interface::Interface;

    #[test]
    fn by_hand() {
        // 0.04 + 0.96 (1 - 0.8)^5 = 0.04 + 0.96 * 0.00032.
        let glass = Interface::new(Index::AIR, Index::GLASS);
        assert!((reflectance(&glass, 0.8) - 0.040_307_2).abs() < 1e-12);
        assert_eq!(reflectance(&glass, 0.0), 1.0);
    }

    #[test]
    fn right_at_both_ends_and_near_between() {
        let glass = Interface::new(Index::AIR, Index::GLASS);
        let worst = (0..=1000)
            .map(|step| f64::from(step) / 1000.0)
            .map(|c| (reflectance(&glass, c) - dielectric::reflectance(&glass, c)).abs())
            .fold(0.0, f64::max);
        assert!((0.035..0.037).contains(&worst), "{worst}");
    }

    #[test]
    fn leaving_is_entering_along_the_same_path() {
        let leaving = Interface::new(Index::GLASS, Index::AIR);
        assert_eq!(reflectance(&leaving, 0.7), 1.0, "beyond the critical angle");
        for cosine in [0.75, 0.8, 0.9, 1.0] {
            let beyond = leaving.far_cosine(cosine).expect("below the critical angle");
            let entering = reflectance(&leaving.reversed(), beyond);
            assert!((reflectance(&leaving, cosine) - entering).abs() < 1e-12);
        }
    }

    #[test]
    fn an_interface_that_is_none_reflects_nothing() {
        let none = Interface::new(Index::WATER, Index::WATER);
        assert_eq!(reflectance(&none, 0.1), 0.0, "the polynomial would say otherwise");
        assert!(polynomial(0.0, 0.1) > 0.5);
    }
}
