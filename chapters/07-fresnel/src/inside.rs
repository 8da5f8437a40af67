//! Which bodies a ray is in, and so in which medium.

use crate::glass::Glass;
use crate::index::Index;

/// The most bodies a ray can be in at a time; it doesn't notice entering more.
pub const MOST: usize = 6;

// ANCHOR: inside
/// The bodies a ray is in, in the order in which it entered them.
///
/// It is copied at every surface. Aligned so, it is two moves of 16 bytes each, which need not wait
/// for smaller ones that wrote it just before.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(align(16))]
pub struct Inside {
    bodies: [u32; MOST],
    count: u32,
}

impl Inside {
    /// The same, and in `body` as well.
    pub fn with(mut self, body: u32) -> Self {
        if !self.bodies().contains(&body) && (self.count as usize) < MOST {
            self.bodies[self.count as usize] = body;
            self.count += 1;
        }
        self
    }

    /// The same, but not in `body`.
    pub fn without(self, body: u32) -> Self {
        let others = self.bodies().iter().filter(|&&other| other != body);
        others.fold(Self::default(), |inside, &other| inside.with(other))
    }

    /// Whether it is in none, and so in air.
    pub fn is_air(&self) -> bool {
        self.count == 0
    }

    /// The bodies.
    pub fn bodies(&self) -> &[u32] {
        &self.bodies[..self.count as usize]
    }

    /// The index of the medium there: that of the body with the highest rank, or air.
    ///
    /// Schmidt and Budge, "Simple nested dielectrics in ray traced images" (Journal of Graphics
    /// Tools 7, 2002).
    pub fn index(&self, glass: impl Fn(u32) -> Option<Glass>) -> Index {
        let bodies = self.bodies().iter().filter_map(|&body| glass(body));
        // Of equal ranks `max_by_key` gives the last.
        bodies.max_by_key(|glass| glass.rank).map_or(Index::AIR, |glass| glass.index)
    }
}
// ANCHOR_END: inside

#[cfg(test)]
mod tests {
    use super::{Inside, MOST};
    use crate::glass::Glass;
    use crate::index::Index;

    /// Body 1 is glass of rank 2, body 2 water of rank 1, body 3 a bubble of rank 2.
    fn index(inside: Inside) -> Index {
        inside.index(|body| match body {
            1 => Some(Glass::new(Index::GLASS).ranked(2)),
            2 => Some(Glass::new(Index::WATER).ranked(1)),
            3 => Some(Glass::new(Index::AIR).ranked(2)),
            _ => None,
        })
    }

    #[test]
    fn the_highest_rank_counts_and_of_equal_ones_the_last() {
        let nowhere = Inside::default();
        assert_eq!(index(nowhere), Index::AIR);
        assert_eq!(index(nowhere.with(2)), Index::WATER);
        assert_eq!(index(nowhere.with(1).with(2)), Index::GLASS);
        assert_eq!(index(nowhere.with(2).with(1)), Index::GLASS);
        assert_eq!(index(nowhere.with(1).with(3)), Index::AIR, "a bubble in glass");
        assert_eq!(index(nowhere.with(1).with(3).without(3)), Index::GLASS);
    }

    #[test]
    fn a_body_is_entered_once_and_left_wholly() {
        let inside = Inside::default().with(7).with(2).with(7);
        assert_eq!(inside.bodies(), [7, 2]);
        assert_eq!(inside.without(7).bodies(), [2]);
        assert_eq!(inside.without(3), inside);
        let many = (0..20).fold(Inside::default(), Inside::with);
        assert_eq!(many.bodies().len(), MOST);
    }
}
