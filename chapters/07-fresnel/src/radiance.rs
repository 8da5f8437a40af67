//! What happens to radiance on its way into another medium.

use crate::interface::Interface;

// ANCHOR: scale
/// How many times as much radiance there is on this side of the interface as beyond it, when
/// nothing is reflected: (n_near / n_far)².
///
/// Radiance is power for each area and each solid angle. Refraction leaves power and area as they
/// are and squeezes a cone of directions in the denser medium, so that radiance / n² stays. Veach,
/// "Non-symmetric scattering in light transport algorithms" (Eurographics Workshop on Rendering
/// 1996); Nicodemus, "Radiance" (American Journal of Physics 31, 1963).
pub fn scale(interface: &Interface) -> f64 {
    interface.ratio() * interface.ratio()
}
// ANCHOR_END: scale

#[cfg(test)]
mod tests {
    use common::sampler::Stream;

    use super::scale;
    use crate::dielectric::reflectance;
    use crate::index::Index;
    use crate::interface::Interface;

    #[test]
    fn by_hand() {
        let into_glass = Interface::new(Index::AIR, Index::GLASS);
        assert!((scale(&into_glass) - 1.0 / 2.25).abs() < 1e-15);
    }

    #[test]
    fn in_and_out_again_it_is_what_it_was() {
        for trial in 0..1_000_000 {
            let mut stream = Stream::of_trial(709, trial);
            let mut index = || Index::new(stream.between(0.3, 4.0)).expect("an index");
            let (first, second, third) = (index(), index(), index());
            let there = Interface::new(first, second);
            assert!((scale(&there) * scale(&there.reversed()) - 1.0).abs() < 1e-15);
            // By way of a third medium it is the same as straight.
            let by_way = scale(&there) * scale(&Interface::new(second, third));
            assert!((by_way / scale(&Interface::new(first, third)) - 1.0).abs() < 2e-15);
        }
    }

    /// The cone of directions itself: what power there is in a narrow ring of angles beyond the
    /// interface, divided by the area's projection and by the ring's solid angle, on both sides.
    #[test]
    fn rings_of_directions_are_squeezed_by_just_as_much() {
        let glass = Interface::new(Index::AIR, Index::GLASS);
        for step in 1..100 {
            let sine_squared = f64::from(step) / 100.0;
            let cosine = |sine_squared: f64| (1.0 - sine_squared).sqrt();
            // cosθ dω = π d(sin²θ), so that the projected solid angle is a difference of squares.
            let step = 1e-6;
            let outside = step;
            let beyond = |sine_squared| {
                let cosine = glass.far_cosine(cosine(sine_squared)).expect("it enters");
                1.0 - cosine * cosine
            };
            let inside = beyond(sine_squared) - beyond(sine_squared - step);
            assert!((inside / outside / scale(&glass) - 1.0).abs() < 1e-6);
        }
    }

    /// Inside a furnace all radiance is n² B, with one B for all media. What leaves glass towards
    /// the eye is what glass sends through and what the air reflects.
    #[test]
    fn in_a_furnace_nothing_can_be_seen() {
        for step in 0..=1000 {
            let cosine = f64::from(step) / 1000.0;
            let from_air = Interface::new(Index::AIR, Index::GLASS);
            let reflected = reflectance(&from_air, cosine);
            let (air, glass) = (1.0, 1.5 * 1.5);
            let seen = reflected * air + (1.0 - reflected) * scale(&from_air) * glass;
            assert!((seen - air).abs() < 1e-15, "{cosine}: {seen}");
        }
    }
}
