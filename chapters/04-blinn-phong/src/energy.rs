//! How much of a lamp's light a highlight returns.

use std::f32::consts::PI;

use crate::power::exp2;

/// The exponent from which highlights get no brighter. They still get narrower; but the cosine next
/// below 1 in `f32` is wide enough by then to hold the whole of it.
const NARROWEST: f32 = 1e7;

// ANCHOR: normalization
/// The factor that makes a highlight of exponent n return all light that comes from straight above,
/// and no more from anywhere: one over the integral of (N · H)ⁿ (N · L) over the hemisphere.
///
/// For n = 0 it is 1/π, Lambert's. Giesen, "Phong normalization factors" (2009), derives it;
/// Akenine-Möller, Haines and Hoffman, "Real-Time Rendering" (2008), have (n + 8) / 8π for it,
/// which is up to 7.5 % too much (hard case BP-05).
pub fn normalization(shininess: f32) -> f32 {
    let n = shininess.min(NARROWEST);
    (n + 2.0) * (n + 4.0) / (8.0 * PI * (n + exp2(f64::from(-n / 2.0)) as f32))
}
// ANCHOR_END: normalization

#[cfg(test)]
mod tests {
    use std::f32::consts::PI;

    use super::normalization;

    #[test]
    fn by_hand() {
        assert!((normalization(0.0) * PI - 1.0).abs() < 1e-6, "Lambert's");
        // 3 · 5 / 8π (1 + 1/√2), and 6 · 8 / 8π (4 + 1/4).
        assert!((normalization(1.0) * PI - 15.0 / (8.0 * 1.707_106_8)).abs() < 1e-6);
        assert!((normalization(4.0) * PI - 48.0 / 34.0).abs() < 1e-6);
    }

    #[test]
    fn it_has_an_end() {
        assert!(normalization(f32::MAX).is_finite());
        assert_eq!(normalization(1e9), normalization(f32::INFINITY));
    }
}
