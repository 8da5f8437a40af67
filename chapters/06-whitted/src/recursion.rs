//! Following rays by a function that calls itself, as Whitted did and most textbooks do.

use common::film::Color;
use common::tally::Tally;
use glam::DVec3;

use crate::limits::{Limits, Pending};
use crate::scatter::Scatter;

/// The deepest recursion that is begun: each level takes a piece of the thread's stack, and a stack
/// that is full ends the program.
pub const MOST_RECURSION: u32 = 500;

// ANCHOR: recursion
impl Limits {
    /// The radiance that `ray` brings: the same bits as [`Limits::trace`], but each surface on the
    /// way takes a piece of the stack. Nothing is followed deeper than [`MOST_RECURSION`].
    pub fn trace_by_recursion<S: Scatter, T: Tally>(
        &self,
        scene: &S,
        ray: S::Ray,
        tally: &mut T,
    ) -> Color {
        let shallow = Self { depth: self.depth.min(MOST_RECURSION), ..*self };
        shallow.add(scene, &Pending::first(ray), DVec3::ZERO, tally).as_vec3()
    }

    /// `sum`, and what `current` and all its branches bring to the eye.
    fn add<S: Scatter, T: Tally>(
        &self,
        scene: &S,
        current: &Pending<S::Ray>,
        sum: DVec3,
        tally: &mut T,
    ) -> DVec3 {
        let met = scene.scatter(&current.ray, tally);
        let sum = sum + current.throughput * met.light.as_dvec3();
        let branches = self.admit(current, &met.branches, tally);
        branches
            .iter()
            .flatten()
            .fold(sum, |sum, branch| self.add(scene, &branch.copied(), sum, tally))
    }
}
// ANCHOR_END: recursion

#[cfg(test)]
mod tests {
    use common::tally::{Counts, Off};

    use super::MOST_RECURSION;
    use crate::facing::Facing;
    use crate::limits::{DEEPEST, Limits, STOPPED_BY_CUTOFF, STOPPED_BY_DEPTH};
    use crate::tree::{FOLLOWED, Tree};

    #[test]
    fn the_loop_gives_the_same_bits_and_counters() {
        for seed in 0..400 {
            let tree = Tree { seed, branches: 1 + seed % 2 };
            for limits in [
                Limits { depth: 0, cutoff: 0.0 },
                Limits { depth: 7, cutoff: 0.0 },
                Limits { depth: 400, cutoff: 0.003 },
            ] {
                let (mut counts, mut by_recursion) = (Counts::default(), Counts::default());
                let looped = limits.trace(&tree, Tree::ROOT, &mut counts);
                let recursed = limits.trace_by_recursion(&tree, Tree::ROOT, &mut by_recursion);
                assert_eq!(
                    looped.to_array().map(f32::to_bits),
                    recursed.to_array().map(f32::to_bits)
                );
                for event in [FOLLOWED, DEEPEST, STOPPED_BY_DEPTH, STOPPED_BY_CUTOFF] {
                    assert_eq!(counts.of(event), by_recursion.of(event), "{limits:?} {event:?}");
                }
                assert_eq!(looped, limits.trace(&tree, Tree::ROOT, &mut Off));
            }
        }
    }

    #[test]
    fn it_adds_up_what_the_tree_was_made_of() {
        for seed in 0..50 {
            let tree = Tree { seed, branches: 2 };
            let limits = Limits { depth: 9, cutoff: 0.0 };
            let mut counts = Counts::default();
            let sum = limits.trace(&tree, Tree::ROOT, &mut counts).as_dvec3();
            let exact = tree.exactly(Tree::ROOT, 9);
            assert!((sum - exact).abs().max_element() <= 1e-7 * exact.max_element(), "seed {seed}");
            assert_eq!((counts.of(FOLLOWED), counts.of(DEEPEST)), ((1 << 10) - 2, 9));
        }
    }

    #[test]
    fn it_fits_into_half_a_megabyte_and_ends_there() {
        let deepest = || {
            let mut counts = Counts::default();
            let limits = Limits { depth: u32::MAX, cutoff: 0.0 };
            let mirrors = Facing { light: 1.0, mirror: 1.0 };
            limits.trace_by_recursion(&mirrors, 0, &mut counts);
            counts.of(DEEPEST)
        };
        let thread = std::thread::Builder::new().stack_size(512 * 1024).spawn(deepest);
        let deepest = thread.expect("a thread").join().expect("no overflow");
        assert_eq!(deepest, u64::from(MOST_RECURSION));
    }
}
