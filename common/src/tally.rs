//! Counters of work done: rays, tests, samples.
//!
//! A function that counts is generic over [`Tally`]. With [`Off`] every call is an empty function
//! the compiler removes; with [`Counts`] it is one addition. So counting costs nothing when it is
//! off, and nobody writes a loop twice (`cargo bench -p common` shows both).

/// A kind of work that is counted, such as "triangle tests".
///
/// A chapter declares its own events as constants; each has a slot of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Event {
    slot: usize,
    name: &'static str,
}

const PER_CHAPTER: usize = 8;
const SLOTS: usize = 32 * PER_CHAPTER;

impl Event {
    /// The event number `index` (0 to 7) of chapter `chapter` (0 to 31; 0 is for `common`).
    ///
    /// `name` is the key in `--json`: lower case, words joined by underscores.
    pub const fn new(chapter: usize, index: usize, name: &'static str) -> Self {
        assert!(index < PER_CHAPTER);
        let slot = chapter * PER_CHAPTER + index;
        assert!(slot < SLOTS);
        Self { slot, name }
    }

    /// The key in `--json`.
    pub const fn name(self) -> &'static str {
        self.name
    }
}

/// Something that counts events, or doesn't.
pub trait Tally: Default + Send {
    /// Counts `event` `times` times.
    fn count(&mut self, event: Event, times: u64);

    /// The counters, when there are any. A `dyn` object can't be generic over its tally; it takes
    /// these instead (see `ray_casting::Shape`).
    fn counts(&mut self) -> Option<&mut Counts>;

    /// Adds what another part of the work counted. Sums of integers come out the same in any
    /// order, so counters don't depend on the number of threads.
    fn merge(&mut self, other: &Self);
}

/// Counts nothing and costs nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Off;

impl Tally for Off {
    #[inline(always)]
    fn count(&mut self, _event: Event, _times: u64) {}

    #[inline(always)]
    fn counts(&mut self) -> Option<&mut Counts> {
        None
    }

    fn merge(&mut self, _other: &Self) {}
}

/// Counts every event.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Counts {
    slots: Box<[u64; SLOTS]>,
}

impl Counts {
    /// How often `event` was counted.
    pub fn of(&self, event: Event) -> u64 {
        self.slots[event.slot]
    }
}

impl Default for Counts {
    fn default() -> Self {
        Self { slots: Box::new([0; SLOTS]) }
    }
}

impl Tally for Counts {
    #[inline(always)]
    fn count(&mut self, event: Event, times: u64) {
        self.slots[event.slot] += times;
    }

    #[inline(always)]
    fn counts(&mut self) -> Option<&mut Counts> {
        Some(self)
    }

    fn merge(&mut self, other: &Self) {
        for (slot, more) in self.slots.iter_mut().zip(other.slots.iter()) {
            *slot += more;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Counts, Event, Off, Tally};

    const RAYS: Event = Event::new(1, 0, "rays");
    const TESTS: Event = Event::new(2, 7, "tests");

    fn work(tally: &mut impl Tally) {
        tally.count(RAYS, 1);
        tally.count(TESTS, 12);
    }

    #[test]
    fn counts_add_up_and_merge() {
        let mut left = Counts::default();
        let mut right = Counts::default();
        work(&mut left);
        work(&mut right);
        work(&mut right);
        left.merge(&right);
        assert_eq!((left.of(RAYS), left.of(TESTS)), (3, 36));
    }

    #[test]
    fn off_has_no_counters_and_no_size() {
        let mut off = Off;
        work(&mut off);
        assert!(off.counts().is_none());
        assert_eq!(size_of::<Off>(), 0);
    }
}
