//! Following rays by a loop: what is left to do stands in a list, and no function calls itself.

use common::film::Color;
use common::tally::{Event, Tally};
use glam::DVec3;

use crate::limits::{Limits, Pending};
use crate::scatter::Scatter;

/// The most branches that waited at a time.
pub const MOST_WAITING: Event = Event::record(6, 1, "most_waiting");

// ANCHOR: trace
impl Limits {
    /// The radiance that `ray` brings, added up in the order of [`Limits::trace_by_recursion`], so
    /// that both give the same bits.
    ///
    /// A ray with one branch goes on without the list, so mirrors never need it. How long it can
    /// grow is with [`Limits::admit`].
    #[inline]
    pub fn trace<S: Scatter, T: Tally>(&self, scene: &S, ray: S::Ray, tally: &mut T) -> Color {
        self.trace_from(scene, Pending::first(ray), tally).as_vec3()
    }

    /// What `current` and all its branches bring. It is a function of its own so that the first ray
    /// is built where it is followed, and not copied there.
    fn trace_from<S: Scatter, T: Tally>(
        &self,
        scene: &S,
        mut current: Pending<S::Ray>,
        tally: &mut T,
    ) -> DVec3 {
        let mut sum = DVec3::ZERO;
        let mut waiting = Vec::new();
        loop {
            let met = scene.scatter(&current.ray, tally);
            sum += current.throughput * met.light.as_dvec3();
            let [first, second] = self.admit(&current, &met.branches, tally);
            if let Some(second) = second {
                waiting.push(second.copied());
                tally.count(MOST_WAITING, waiting.len() as u64);
            }
            let Some(next) = first.map(Pending::copied).or_else(|| waiting.pop()) else {
                return sum;
            };
            current = next;
        }
    }
}
// ANCHOR_END: trace

#[cfg(test)]
mod tests {
    use common::tally::{Counts, Off};

    use super::MOST_WAITING;
    use crate::facing::{Facing, series};
    use crate::limits::{DEEPEST, Limits};
    use crate::tree::Tree;

    /// Hard case WH-08: a million mirrors in a row, on a thread with 256 KiB of stack.
    #[test]
    fn a_million_mirrors_on_a_small_stack() {
        let sum = || {
            let limits = Limits { depth: 1_000_000, cutoff: 0.0 };
            limits.trace(&Facing { light: 0.1, mirror: 1.0 }, 0, &mut Off)
        };
        let thread = std::thread::Builder::new().stack_size(256 * 1024).spawn(sum);
        let sum = thread.expect("a thread").join().expect("no overflow").x;
        assert_eq!(sum, (f64::from(0.1f32) * series(1.0, 1_000_000)) as f32);
    }

    #[test]
    fn mirrors_need_no_list_and_two_branches_a_short_one() {
        for seed in 0..100 {
            let waited = |branches| {
                let mut counts = Counts::default();
                let limits = Limits { depth: 100_000, cutoff: 0.001 };
                limits.trace(&Tree { seed, branches }, Tree::ROOT, &mut counts);
                (counts.of(MOST_WAITING), counts.of(DEEPEST))
            };
            assert_eq!(waited(1).0, 0);
            let (most, deepest) = waited(2);
            // log2(3 / 0.001) is 11.55.
            assert!((3..=11).contains(&most) && deepest > 12, "{most} {deepest}");
        }
    }
}
