//! The surface between two media, and Snell's law for cosines.

use crate::index::Index;

// ANCHOR: interface
/// Where one medium ends and another begins, as seen by a ray that comes from the near one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interface {
    near: Index,
    far: Index,
    /// n_near / n_far: the sine beyond, for each unit of sine on this side.
    ratio: f64,
    /// 1 - ratio².
    rest: f64,
}

impl Interface {
    /// The interface for a ray in `near` that comes upon `far`.
    pub fn new(near: Index, far: Index) -> Self {
        let (n, f) = (near.number(), far.number());
        // The difference is taken first: of two nearly equal indices it is exact.
        Self { near, far, ratio: n / f, rest: (f - n) * (f + n) / (f * f) }
    }
    // ANCHOR_END: interface

    /// The same interface for a ray from the other side.
    pub fn reversed(&self) -> Self {
        Self::new(self.far, self.near)
    }

    /// n_near / n_far.
    pub fn ratio(&self) -> f64 {
        self.ratio
    }

    /// 1 - (n_near / n_far)²: above 0 into the denser medium, below 0 out of it.
    pub fn rest(&self) -> f64 {
        self.rest
    }

    /// Whether both media have the same index, so that light doesn't notice.
    pub fn is_none(&self) -> bool {
        self.near == self.far
    }

    // ANCHOR: far_cosine
    /// The cosine of the angle beyond, for that on this side, from 0 to 1. None for total
    /// reflection.
    ///
    /// Snell's law, squared: cos²θ' = 1 - ratio² sin²θ = (1 - ratio²) + (ratio cosθ)². With equal
    /// indices the sum is 0 + cos²θ, and the root of an exact square is exact.
    pub fn far_cosine(&self, cosine: f64) -> Option<f64> {
        let squared = self.rest + (self.ratio * cosine) * (self.ratio * cosine);
        (squared >= -self.slack()).then(|| squared.max(0.0).sqrt())
    }

    /// What may be rounding in a square of [`Self::far_cosine`], and no total reflection.
    ///
    /// A cosine of two rounded directions is wrong by up to 6 u, with u = 2⁻⁵³; its square, by 12 u;
    /// `ratio`, its square and the sum, by 4 u more.
    fn slack(&self) -> f64 {
        8.0 * f64::EPSILON * self.ratio * self.ratio
    }
    // ANCHOR_END: far_cosine

    /// The cosine of the critical angle: with a smaller one, all is reflected. None when light gets
    /// through at every angle.
    pub fn critical_cosine(&self) -> Option<f64> {
        (self.rest < 0.0).then(|| (-self.rest).sqrt() / self.ratio)
    }
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;

    use super::Interface;
    use crate::index::Index;

    fn index(number: f32) -> Index {
        Index::new(number).expect("an index")
    }

    #[test]
    fn by_hand() {
        // sin 0.6 beyond 4/3: sin 0.8 back, so cosines 0.8 and 0.6.
        let leaving = Interface::new(index(1.333_333_4), index(1.0));
        let cosine = leaving.far_cosine(0.8).expect("below the critical angle");
        assert!((cosine - 0.6).abs() < 1e-6, "{cosine}");
        let entering = leaving.reversed().far_cosine(0.6).expect("it always enters");
        assert!((entering - 0.8).abs() < 1e-6, "{entering}");
    }

    #[test]
    fn the_critical_angle_of_water() {
        // asin(1 / 1.33) is 48.7535 degrees, whose cosine is 0.659300.
        let leaving = Interface::new(Index::WATER, Index::AIR);
        let critical = leaving.critical_cosine().expect("water is denser");
        assert!((critical - 0.659_300).abs() < 1e-5, "{critical}");
        assert_eq!(leaving.far_cosine(critical - 1e-9), None);
        assert!(leaving.far_cosine(critical + 1e-9).is_some_and(|cosine| cosine < 1e-4));
        assert_eq!(leaving.reversed().critical_cosine(), None);
    }

    #[test]
    fn snell_s_law_of_sines() {
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(701, trial);
            let (near, far) = (stream.between(0.5, 3.0), stream.between(0.5, 3.0));
            let cosine = f64::from(stream.uniform());
            let interface = Interface::new(index(near), index(far));
            let sine = |cosine: f64| (1.0 - cosine * cosine).sqrt();
            let bent = f64::from(near) / f64::from(far) * sine(cosine);
            match interface.far_cosine(cosine) {
                Some(beyond) => assert!((sine(beyond) - bent).abs() < 1e-7, "{near} {far}"),
                None => assert!(bent > 1.0, "{near} {far} {cosine}"),
            }
        }
    }

    #[test]
    fn equal_indices_change_no_bit_of_a_cosine() {
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(702, trial);
            let medium = index(stream.between(0.1, 4.0));
            let cosine = f64::from(stream.uniform()) / 3.0;
            assert_eq!(Interface::new(medium, medium).far_cosine(cosine), Some(cosine));
        }
    }

    #[test]
    fn from_the_smallest_index_to_the_largest_and_back() {
        let into = Interface::new(index(Index::LEAST), index(Index::MOST));
        assert!(into.far_cosine(0.5).is_some_and(|cosine| cosine > 1.0 - 1e-12));
        assert_eq!(into.reversed().far_cosine(0.5), None);
        assert_eq!(into.reversed().far_cosine(1.0), Some(1.0));
    }
}
