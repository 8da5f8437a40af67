//! Following rays by a loop: what is left to do stands in a list, and no function calls itself.

use common::film::Color;
use common::tally::Tally;
use glam::DVec3;

use crate::limits::{Limits, Pending};
use crate::scatter::Scatter;

// ANCHOR: trace
impl Limits {
    /// The radiance that `ray` brings, added up in the order of [`Limits::trace_by_recursion`], so
    /// that both give the same bits.
    ///
    /// A ray with one branch goes on without the list, so mirrors never need it. How long it can
    /// grow is with [`Limits::admit`].
    pub fn trace<S: Scatter, T: Tally>(&self, scene: &S, ray: S::Ray, tally: &mut T) -> Color {
        let mut sum = DVec3::ZERO;
        let mut waiting = Vec::new();
        let mut next = Some(Pending::first(ray));
        while let Some(current) = next {
            let met = scene.scatter(&current.ray, tally);
            sum += current.throughput * met.light.as_dvec3();
            let [first, second] = self.admit(&current, met.branches, tally);
            waiting.extend(second);
            next = first.or_else(|| waiting.pop());
        }
        sum.as_vec3()
    }
}
// ANCHOR_END: trace
