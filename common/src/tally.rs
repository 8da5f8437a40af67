//! Counters of work done: rays, tests, samples.
//!
//! A function that counts is generic over [`Tally`]. With [`Off`] every call is an empty function
//! the compiler removes; with [`Counts`] it is one addition. So counting costs nothing when it is
//! off, and nobody writes a loop twice (`cargo bench -p common` shows both).

/// A kind of work that is counted, such as "triangle tests", or a record that is kept, such as "the
/// deepest ray".
///
/// A chapter declares its own events as constants; each has a slot of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Event {
    slot: usize,
    name: &'static str,
}

const PER_CHAPTER: usize = 8;
/// Slots below this one are sums; the others, as many again, are records.
const RECORDS: usize = 32 * PER_CHAPTER;
const SLOTS: usize = 2 * RECORDS;

impl Event {
    /// The event number `index` (0 to 7) of chapter `chapter` (0 to 31; 0 is for `common`).
    ///
    /// `name` is the key in `--json`: lower case, words joined by underscores.
    pub const fn new(chapter: usize, index: usize, name: &'static str) -> Self {
        assert!(index < PER_CHAPTER);
        let slot = chapter * PER_CHAPTER + index;
        assert!(slot < RECORDS);
        Self { slot, name }
    }

    /// The record number `index` (0 to 7) of chapter `chapter`: counting it keeps the largest number
    /// that was ever counted instead of the sum.
    pub const fn record(chapter: usize, index: usize, name: &'static str) -> Self {
        let Self { slot, name } = Self::new(chapter, index, name);
        Self { slot: RECORDS + slot, name }
    }

    /// The key in `--json`.
    pub const fn name(self) -> &'static str {
        self.name
    }
}

/// Something that counts events, or doesn't.
pub trait Tally: Default + Send {
    /// Counts `event` `times` times; raises a record to `times`.
    fn count(&mut self, event: Event, times: u64);

    /// The counters, when there are any. A `dyn` object can't be generic over its tally; it takes
    /// these instead (see `ray_casting::Shape`).
    fn counts(&mut self) -> Option<&mut Counts>;

    /// Adds what another part of the work counted. Sums of integers and their maxima come out the
    /// same in any order, so counters don't depend on the number of threads.
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
    /// How often `event` was counted, or the largest number a record was raised to.
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
        let slot = &mut self.slots[event.slot];
        *slot = if event.slot < RECORDS { *slot + times } else { times.max(*slot) };
    }

    #[inline(always)]
    fn counts(&mut self) -> Option<&mut Counts> {
        Some(self)
    }

    fn merge(&mut self, other: &Self) {
        let (sums, records) = self.slots.split_at_mut(RECORDS);
        let (other_sums, other_records) = other.slots.split_at(RECORDS);
        for (sum, more) in sums.iter_mut().zip(other_sums) {
            *sum += more;
        }
        for (record, other) in records.iter_mut().zip(other_records) {
            *record = (*record).max(*other);
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
    fn a_record_keeps_the_largest() {
        const DEEPEST: Event = Event::record(2, 7, "deepest");
        let mut left = Counts::default();
        let mut right = Counts::default();
        for value in [3, 8, 5] {
            left.count(DEEPEST, value);
        }
        right.count(DEEPEST, 7);
        right.count(TESTS, 2);
        left.merge(&right);
        right.merge(&left);
        assert_eq!([left.of(DEEPEST), right.of(DEEPEST)], [8, 8]);
        assert_eq!((left.of(TESTS), right.of(TESTS)), (2, 4), "the sum of the same number");
    }

    #[test]
    fn off_has_no_counters_and_no_size() {
        let mut off = Off;
        work(&mut off);
        assert!(off.counts().is_none());
        assert_eq!(size_of::<Off>(), 0);
    }
}
