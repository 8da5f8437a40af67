//! What `f32` and glam do that nobody expects: characterisations, so that a change is noticed.

use common::sampler::Stream;
use glam::{Vec3, Vec3A};

/// Hard case X-01: four ways to take the minimum of a number and NaN.
#[test]
fn a_minimum_may_lose_nan_or_keep_it() {
    assert_eq!((f32::NAN.min(1.0), 1f32.min(f32::NAN)), (1.0, 1.0), "f32 loses it");
    assert_eq!(Vec3::NAN.min(Vec3::ONE), Vec3::ONE, "a vector loses it on the left");
    assert!(Vec3::ONE.min(Vec3::NAN).is_nan(), "and keeps it on the right");
    assert_eq!(Vec3::new(f32::NAN, 1.0, 2.0).min_element(), 1.0, "an element first is lost");
    assert!(Vec3::new(1.0, 2.0, f32::NAN).min_element().is_nan(), "and last is kept");
}

/// Hard case X-03: the two vector types of glam disagree in their last bits, so pixels use one.
#[test]
fn the_aligned_vector_has_other_bits() {
    let mut different = 0;
    for trial in 0..100_000 {
        let mut stream = Stream::of_trial(31, trial);
        let mut component = || stream.between(-3.0, 5.0);
        let vector = Vec3::new(component(), component(), component());
        let (plain, aligned) = (vector.normalize(), Vec3::from(Vec3A::from(vector).normalize()));
        different += u32::from(plain != aligned);
        assert!((plain - aligned).abs().max_element() <= 2.0 * f32::EPSILON);
    }
    // How many depends on the processor; on x86-64 it is every second one.
    assert!(cfg!(not(target_arch = "x86_64")) || different > 10_000, "{different}");
}

/// Hard case X-04: an arc cosine knows nothing of small angles; the length of the chord does.
#[test]
fn small_angles_vanish() {
    for angle in [1e-5f32, 1e-4] {
        // To f32, (1, angle, 0) is at this angle from the x axis.
        let (a, b) = (Vec3::X, Vec3::new(1.0, angle, 0.0));
        assert_eq!(a.angle_between(b), 0.0, "the true angle is {angle}");
        let half_chord = (b / b.length() - a).length() / 2.0;
        assert!((2.0 * half_chord - angle).abs() < 1e-6 * angle, "2 asin(x) is 2 x for small x");
    }
}
