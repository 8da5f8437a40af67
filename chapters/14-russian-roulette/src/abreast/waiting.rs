//! Shadow rays that wait until there are sixteen of them.

use common::film::Color;
use common::tally::Tally;
use glam::Vec3;
use shadows::visibility::{BLOCKED_RAYS, SHADOW_RAYS};
use triangles::brute::TRIANGLE_TESTS;
use triangles::bundle::{Bundle, RAYS, Vectors};
use triangles::few::{Few, MOST, Sheared};

/// As many as there may be: fewer than sixteen from before, and what a step may add, the light of a lamp
/// that was met and of one that was looked for, for each path.
const ROOM: usize = 3 * RAYS;

/// Light that counts if nothing is on the way to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight {
    /// The sample for which it counts.
    pub(super) sample: usize,
    /// Where the shadow ray starts.
    pub(super) origin: Vec3,
    /// The way to the lamp; none at all where nothing can be on it.
    pub(super) way: Vec3,
    /// What the light counts at the eye.
    pub(super) light: Color,
}

/// Such light in the order in which it was found. Not every path looks for a lamp at each step, and a
/// bundle of rays should have no gaps.
pub(super) struct Waiting {
    sights: [Sight; ROOM],
    count: usize,
    sheared: Sheared,
}

impl Waiting {
    /// None.
    pub(super) fn new() -> Self {
        let (origin, way, light) = (Vec3::ZERO, Vec3::ZERO, Color::ZERO);
        let sights = [Sight { sample: 0, origin, way, light }; ROOM];
        Self { sights, count: 0, sheared: [Vectors::ZERO; MOST] }
    }

    /// One more.
    #[inline(always)]
    pub(super) fn push(&mut self, sight: Sight) {
        self.sights[self.count] = sight;
        self.count += 1;
    }

    /// Whether a bundle is full.
    #[inline(always)]
    pub(super) fn is_full(&self) -> bool {
        self.count >= RAYS
    }

    /// Adds the light of the first sixteen, or of all if they are fewer, to their samples' `colors`.
    #[inline(always)]
    pub(super) fn ask<T: Tally>(&mut self, few: &Few, colors: &mut [Color], tally: &mut T) {
        let asked = self.count.min(RAYS);
        let origin = Vectors::of(|ray| self.sights[ray].origin);
        let way = Vectors::of(|ray| self.sights[ray].way);
        let mut used = [false; RAYS];
        for ray in 0..RAYS {
            used[ray] = (ray < asked) & (way.at(ray) != Vec3::ZERO);
        }
        let blocked = few.blocked(&Bundle::new(&origin, &way, &used), &mut self.sheared);
        for ray in 0..asked {
            let Sight { sample, light, .. } = self.sights[ray];
            colors[sample] += if blocked[ray] { Color::ZERO } else { light };
        }
        self.sights.copy_within(asked..self.count, 0);
        self.count -= asked;
        count(few, &used, &blocked, tally);
    }
}

/// Counts shadow rays.
#[inline(always)]
fn count<T: Tally>(few: &Few, used: &[bool; RAYS], blocked: &[bool; RAYS], tally: &mut T) {
    let Some(counts) = tally.counts() else { return };
    let (mut rays, mut found) = (0, 0);
    for ray in 0..RAYS {
        rays += u64::from(used[ray]);
        found += u64::from(used[ray] & blocked[ray]);
    }
    counts.count(SHADOW_RAYS, rays);
    counts.count(BLOCKED_RAYS, found);
    counts.count(TRIANGLE_TESTS, rays * few.len() as u64);
}
