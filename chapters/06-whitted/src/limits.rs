//! Which rays are worth following: by how many surfaces they met, and by how much they still count.

use common::tally::{Event, Tally};
use glam::DVec3;

use crate::scatter::Branch;

/// The most surfaces any ray left on its way.
pub const DEEPEST: Event = Event::record(6, 0, "deepest");
/// Branches that were not followed because they were too deep.
pub const STOPPED_BY_DEPTH: Event = Event::new(6, 1, "stopped_by_depth");
/// Branches that were not followed because they counted too little.
pub const STOPPED_BY_CUTOFF: Event = Event::new(6, 2, "stopped_by_cutoff");

// ANCHOR: limits
/// Where following rays ends.
///
/// Whitted (1980) has the depth; the cut-off is the "adaptive depth control" of Hall and Greenberg, "A
/// testbed for realistic image synthesis" (IEEE Computer Graphics and Applications 3, 1983).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The most surfaces that a ray leaves on its way; 0 follows the camera's rays alone.
    pub depth: u32,
    /// A branch is followed only if more than this part of its radiance reaches the eye, in [0, 1).
    pub cutoff: f32,
}

/// A ray that is still to be followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pending<R> {
    /// The ray.
    pub ray: R,
    /// The part of its radiance that reaches the eye. In `f64`: it is a product of up to `depth`
    /// numbers, and a million roundings of an `f32` would show.
    pub throughput: DVec3,
    /// How many surfaces were left on the way to it.
    pub depth: u32,
}
// ANCHOR_END: limits

impl<R> Pending<R> {
    /// A ray from the eye.
    pub fn first(ray: R) -> Self {
        Self { ray, throughput: DVec3::ONE, depth: 0 }
    }
}

impl Limits {
    // ANCHOR: admit
    /// The branches of `from` that are followed, in the order in which they are.
    ///
    /// The one that counts less comes first. Of two branches that get at most 1 together, it has at
    /// most half of the throughput. So while the other one waits, at most log₂(3 / cutoff) halvings
    /// follow, and no more than that many branches ever wait at a time.
    pub fn admit<'b, R, T: Tally>(
        &self,
        from: &Pending<R>,
        branches: &'b [Option<Branch<R>>; 2],
        tally: &mut T,
    ) -> [Option<Pending<&'b R>>; 2] {
        let [one, other] = branches
            .each_ref()
            .map(|branch| branch.as_ref().and_then(|branch| self.follow(from, branch, tally)));
        match (one, other) {
            (Some(one), Some(other)) if other.weighs() < one.weighs() => [Some(other), Some(one)],
            (None, other) => [other, None],
            both => [both.0, both.1],
        }
    }

    /// The branch, if it brings any light and passes both limits.
    pub(crate) fn follow<'b, R, T: Tally>(
        &self,
        from: &Pending<R>,
        branch: &'b Branch<R>,
        tally: &mut T,
    ) -> Option<Pending<&'b R>> {
        let throughput = from.throughput * branch.weight.as_dvec3();
        // Products below the smallest normal number round to themselves and never get to 0. NaN is
        // above nothing.
        let above = |limit: f64| throughput.cmpgt(DVec3::splat(limit)).any();
        if !above(f64::MIN_POSITIVE) {
            return None;
        }
        if from.depth >= self.depth {
            tally.count(STOPPED_BY_DEPTH, 1);
            return None;
        }
        if !above(f64::from(self.cutoff)) {
            tally.count(STOPPED_BY_CUTOFF, 1);
            return None;
        }
        let depth = from.depth + 1;
        tally.count(*branch.event, 1);
        tally.count(DEEPEST, u64::from(depth));
        Some(Pending { ray: &branch.ray, throughput, depth })
    }
    // ANCHOR_END: admit
}

impl<R: Copy> Pending<&R> {
    /// The same with a ray of its own.
    #[inline]
    pub fn copied(self) -> Pending<R> {
        let Self { ray, throughput, depth } = self;
        Pending { ray: *ray, throughput, depth }
    }
}

impl<R> Pending<R> {
    fn weighs(&self) -> f64 {
        self.throughput.element_sum()
    }
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::tally::{Counts, Event, Off, Tally};
    use glam::DVec3;

    use super::{DEEPEST, Limits, Pending, STOPPED_BY_CUTOFF, STOPPED_BY_DEPTH};
    use crate::scatter::Branch;

    const FOLLOWED: Event = Event::new(6, 7, "followed");

    fn branch(ray: char, weight: f32) -> Option<Branch<char>> {
        Some(Branch { ray, weight: weight * Color::new(0.5, 1.0, 0.75), event: &FOLLOWED })
    }

    /// The rays that are followed after `from`, in their order.
    fn admitted<T: Tally>(
        limits: &Limits,
        from: &Pending<char>,
        branches: [Option<Branch<char>>; 2],
        tally: &mut T,
    ) -> String {
        let admitted = limits.admit(from, &branches, tally);
        admitted.into_iter().flatten().map(|pending| pending.ray).collect()
    }

    #[test]
    fn the_lesser_branch_comes_first_and_a_lone_one_is_the_first() {
        let limits = Limits { depth: 9, cutoff: 0.0 };
        let first = Pending::first('o');
        let admit = |one, other| admitted(&limits, &first, [one, other], &mut Off);
        assert_eq!(admit(branch('a', 0.3), branch('b', 0.6)), "ab");
        assert_eq!(admit(branch('a', 0.6), branch('b', 0.3)), "ba");
        assert_eq!(admit(branch('a', 0.5), branch('b', 0.5)), "ab");
        assert_eq!(admit(None, None), "");
        let branches = [None, branch('b', 0.5)];
        let [one, other] = limits.admit(&first, &branches, &mut Off);
        assert_eq!((one.map(|it| it.ray), other), (Some(&'b'), None));
    }

    #[test]
    fn each_limit_stops_and_is_counted() {
        let limits = Limits { depth: 4, cutoff: 0.1 };
        let at = |depth, throughput| Pending { ray: 'o', throughput, depth };
        let mut counts = Counts::default();
        let mut admit = |from: Pending<char>, weight| {
            admitted(&limits, &from, [branch('a', weight), None], &mut counts)
        };
        assert_eq!(admit(at(3, DVec3::ONE), 0.5), "a", "the fourth surface");
        assert_eq!(admit(at(4, DVec3::ONE), 0.5), "", "the fifth");
        assert_eq!(admit(at(0, DVec3::splat(0.25)), 0.5), "a", "0.125 of green");
        assert_eq!(admit(at(0, DVec3::new(1.0, 0.2, 0.2)), 0.5), "a", "0.25 of red");
        assert_eq!(admit(at(0, DVec3::splat(0.2)), 0.375), "", "0.075 of green at most");
        for nothing in [0.0, -0.5, f32::NAN] {
            assert_eq!(admit(at(0, DVec3::ONE), nothing), "", "nothing to follow: {nothing}");
        }
        let counted = [FOLLOWED, DEEPEST, STOPPED_BY_DEPTH, STOPPED_BY_CUTOFF];
        assert_eq!(counted.map(|event| counts.of(event)), [3, 4, 1, 1]);
    }

    #[test]
    fn what_is_too_small_to_shrink_is_nothing() {
        let limits = Limits { depth: 9, cutoff: 0.0 };
        let least = f64::from_bits(1);
        assert_eq!(least * 0.75, least, "the smallest f64 there is");
        let at = |throughput| Pending { ray: 'o', throughput: DVec3::splat(throughput), depth: 0 };
        let admit =
            |throughput| admitted(&limits, &at(throughput), [branch('a', 0.75), None], &mut Off);
        assert_eq!(admit(least), "");
        assert_eq!(admit(1e-300), "a");
    }

    #[test]
    fn a_cutoff_of_almost_1_follows_perfect_mirrors() {
        let limits = Limits { depth: 1, cutoff: 0.999 };
        let first = Pending::first('o');
        assert_eq!(admitted(&limits, &first, [branch('a', 1.0), None], &mut Off), "a");
    }
}
