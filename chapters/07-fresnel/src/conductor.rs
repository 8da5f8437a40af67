//! How much metal reflects: Fresnel's equations for media that absorb light.

use common::film::Color;

use crate::index::Index;
use crate::schlick::polynomial;

// ANCHOR: metal
/// A metal: light that enters is slowed down, and absorbed within a fraction of its wavelength.
///
/// The index is the complex number n + i k. Both parts differ for red, green and blue, and that is
/// why gold is yellow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metal {
    /// n: the index of refraction for red, green and blue.
    pub index: [f64; 3],
    /// k: how fast it absorbs them.
    pub absorption: [f64; 3],
}
// ANCHOR_END: metal

/// Gold, silver and copper near 660, 549 and 451 nm: Johnson and Christy, "Optical constants of the
/// noble metals" (Physical Review B 6, 1972), table 1, at 1.88, 2.26 and 2.75 eV.
impl Metal {
    /// Gold.
    pub const GOLD: Self = Self { index: [0.14, 0.43, 1.38], absorption: [3.697, 2.455, 1.914] };
    /// Silver.
    pub const SILVER: Self = Self { index: [0.05, 0.06, 0.04], absorption: [4.483, 3.586, 2.657] };
    /// Copper.
    pub const COPPER: Self = Self { index: [0.22, 1.02, 1.24], absorption: [3.747, 2.577, 2.397] };

    /// What is reflected of red, green and blue into a medium of index `near`.
    pub fn reflectance(&self, near: Index, cosine: f64) -> Color {
        let of = |channel: usize| {
            let (n, k) = (self.index[channel], self.absorption[channel]);
            reflectance(n / near.number(), k / near.number(), cosine) as f32
        };
        Color::new(of(0), of(1), of(2))
    }

    /// The same by Schlick's approximation.
    pub fn schlick(&self, near: Index, cosine: f64) -> Color {
        let straight = self.reflectance(near, 1.0).as_dvec3();
        straight.map(|straight| polynomial(straight, cosine)).as_vec3()
    }
}

// ANCHOR: reflectance
/// The part of unpolarized light that a conductor reflects, for its index `n` and absorption `k`
/// divided by the index of the medium before it, both 0 or more, and the cosine from 0 to 1.
///
/// Born and Wolf, "Principles of Optics" (seventh edition, 1999), section 14.2: Snell's law holds
/// for the complex index, and the cosine beyond it is (a + i b) / (n + i k) with
/// (a + i b)² = (n + i k)² - sin²θ.
pub fn reflectance(n: f64, k: f64, cosine: f64) -> f64 {
    let sine_squared = 1.0 - cosine * cosine;
    let real = n * n - k * k - sine_squared;
    let imaginary = 2.0 * n * k;

    // |a + i b|² and a: of the two forms of a² the one that adds.
    let modulus = (real * real + imaginary * imaginary).sqrt();
    let a_squared = if real >= 0.0 {
        (modulus + real) / 2.0
    } else {
        imaginary * imaginary / (2.0 * (modulus - real))
    };
    let a = a_squared.sqrt();

    let perpendicular = ratio(modulus + cosine * cosine, 2.0 * a * cosine);
    let square = modulus * cosine * cosine + sine_squared * sine_squared;
    let parallel = perpendicular * ratio(square, 2.0 * a * cosine * sine_squared);
    (perpendicular + parallel) / 2.0
}

/// (sum - cross) / (sum + cross); 1 where there is nothing to divide.
fn ratio(sum: f64, cross: f64) -> f64 {
    if sum > 0.0 { (sum - cross) / (sum + cross) } else { 1.0 }
}
// ANCHOR_END: reflectance

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::sampler::Stream;

    use super::{Metal, reflectance};
    use crate::dielectric;
    use crate::index::Index;
    use crate::interface::Interface;

    #[test]
    fn gold_by_hand() {
        // ((n - 1)² + k²) / ((n + 1)² + k²): for red (0.7396 + 13.6678) / (1.2996 + 13.6678).
        let straight = Metal::GOLD.reflectance(Index::AIR, 1.0);
        let expected = Color::new(0.962_585, 0.786_916, 0.408_220);
        assert!((straight - expected).abs().max_element() < 1e-5, "{straight}");
        assert_eq!(Metal::GOLD.reflectance(Index::AIR, 0.0), Color::ONE, "grazing");
    }

    #[test]
    fn a_metal_that_absorbs_nothing_is_glass() {
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(707, trial);
            let near = Index::new(stream.between(0.5, 2.5)).expect("an index");
            let far = Index::new(stream.between(0.5, 2.5)).expect("an index");
            let cosine = f64::from(stream.uniform());
            let metal = reflectance(far.number() / near.number(), 0.0, cosine);
            let glass = dielectric::reflectance(&Interface::new(near, far), cosine);
            assert!((metal - glass).abs() < 1e-7, "{near:?} {far:?} {cosine}: {metal} {glass}");
        }
    }

    #[test]
    fn never_more_than_all_and_all_at_grazing() {
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(708, trial);
            let (n, k) = (f64::from(stream.between(0.0, 5.0)), f64::from(stream.between(0.0, 9.0)));
            let reflected = reflectance(n, k, f64::from(stream.uniform()));
            assert!((0.0..=1.0).contains(&reflected), "{n} {k}: {reflected}");
            assert_eq!(reflectance(n, k, 0.0), 1.0);
        }
        assert_eq!(reflectance(0.0, 0.0, 1.0), 1.0, "nothing to go on in");
    }

    #[test]
    fn schlick_is_near_for_gold_too() {
        for step in 0..=100 {
            let cosine = f64::from(step) / 100.0;
            let [exact, near] = [Metal::reflectance, Metal::schlick]
                .map(|reflectance| reflectance(&Metal::GOLD, Index::AIR, cosine));
            assert!((exact - near).abs().max_element() < 0.05, "{cosine}");
        }
    }
}
