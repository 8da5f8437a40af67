//! Choosing one of many, each as often as its weight says.

/// A uniform `f32` is one of this many.
const SLOTS: u32 = 1 << 24;

// ANCHOR: table
/// The chances of a list of things.
///
/// Uniform numbers have 24 bits, so there are 2²⁴ slots, and each thing has a whole number of them.
/// Its probability is therefore exact: what [`Table::probability`] says is what [`Table::pick`] does.
/// A thing of weight 0 has no slot (hard case MC-07), and neither has one whose weight is less than
/// 2⁻²⁴ of all (LS-11); [`Table::left_out`] counts the latter.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// For each thing, the first slot after its own.
    ends: Vec<u32>,
    left_out: usize,
}

/// A thing that was picked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pick {
    /// Its place in the list.
    pub index: usize,
    /// The probability it had.
    pub probability: f32,
    /// What is left of the number that picked it: uniform in [0, 1) again.
    pub rest: f32,
}
// ANCHOR_END: table

impl Table {
    // ANCHOR: new
    /// The table of these weights. `None` unless one is above 0 and all are at least 0 and finite.
    pub fn new(weights: &[f32]) -> Option<Self> {
        let total: f64 = weights.iter().map(|&weight| f64::from(weight)).sum();
        let valid = weights.iter().all(|weight| weight.is_finite() && *weight >= 0.0);
        if !(valid && total > 0.0) {
            return None;
        }
        let share = |weight: f32| (f64::from(weight) / total * f64::from(SLOTS)) as u32;
        let mut slots: Vec<u32> = weights.iter().map(|&weight| share(weight)).collect();
        // What rounding down has left goes to the one with the most, where it matters least.
        let spare = SLOTS - slots.iter().sum::<u32>();
        if let Some(most) = slots.iter_mut().max() {
            *most += spare;
        }
        let pairs = weights.iter().zip(&slots);
        let left_out = pairs.filter(|(weight, slots)| **weight > 0.0 && **slots == 0).count();
        let sum = |end: &mut u32, slots: u32| {
            *end += slots;
            Some(*end)
        };
        Some(Self { ends: slots.into_iter().scan(0, sum).collect(), left_out })
    }
    // ANCHOR_END: new

    // ANCHOR: pick
    /// The thing in whose slots the number `u` of [0, 1) lies.
    #[inline]
    pub fn pick(&self, u: f32) -> Pick {
        let slot = slot(u);
        let index = self.ends.partition_point(|&end| end <= slot);
        let (start, slots) = self.slots(index);
        Pick::of_slot(index, slot, start, slots)
    }
    // ANCHOR_END: pick

    /// The probability of the thing number `index`.
    #[inline]
    pub fn probability(&self, index: usize) -> f32 {
        self.slots(index).1 as f32 / SLOTS as f32
    }

    /// How many things have a weight and no chance.
    pub fn left_out(&self) -> usize {
        self.left_out
    }

    /// How many things there are.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there is nothing to choose, which is never so.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The first slot of a thing, and how many it has.
    #[inline]
    pub fn slots(&self, index: usize) -> (u32, u32) {
        let start = index.checked_sub(1).map_or(0, |before| self.ends[before]);
        (start, self.ends[index] - start)
    }
}

/// The slot in which the number `u` of [0, 1) lies.
#[inline]
pub fn slot(u: f32) -> u32 {
    (u * SLOTS as f32) as u32
}

impl Pick {
    /// Thing number `index`, which has `slots` slots from `start` on, picked by `slot`.
    #[inline]
    pub fn of_slot(index: usize, slot: u32, start: u32, slots: u32) -> Self {
        let rest = slot.wrapping_sub(start) as f32 / slots as f32;
        Self { index, probability: slots as f32 / SLOTS as f32, rest: rest.min(BELOW_ONE) }
    }
}

/// The largest `f32` below 1.
const BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;

#[cfg(test)]
mod tests {
    use super::{BELOW_ONE, Pick, SLOTS, Table};

    #[test]
    fn every_slot_belongs_to_the_thing_whose_probability_it_is() {
        let table = Table::new(&[0.0, 3.0, 0.0, 1e-3, 5.0, 0.0]).expect("weights");
        let mut found = [0u32; 6];
        for slot in 0..SLOTS {
            let pick = table.pick(slot as f32 / SLOTS as f32);
            found[pick.index] += 1;
            assert!((0.0..1.0).contains(&pick.rest));
            assert_eq!(pick.probability, table.probability(pick.index));
        }
        for (index, count) in found.into_iter().enumerate() {
            assert_eq!(count as f32 / SLOTS as f32, table.probability(index), "{index}");
        }
        assert_eq!([found[0], found[2], found[5]], [0; 3]);
        assert!((f64::from(table.probability(1)) - 3.0 / 8.001).abs() < 1e-6);
    }

    /// Weights 1 and 3: a number below 1/4 picks the first, and 0.125 is half of its way.
    #[test]
    fn by_hand() {
        let table = Table::new(&[1.0, 3.0]).expect("weights");
        assert_eq!(table.pick(0.125), Pick { index: 0, probability: 0.25, rest: 0.5 });
        assert_eq!(table.pick(0.25), Pick { index: 1, probability: 0.75, rest: 0.0 });
    }

    #[test]
    fn the_ends() {
        let table = Table::new(&[0.0, 0.0, 1.0, 0.0]).expect("weights");
        for u in [0.0, 0.5, BELOW_ONE] {
            assert_eq!((table.pick(u).index, table.pick(u).probability), (2, 1.0));
        }
    }

    #[test]
    fn what_is_too_small_to_be_found_is_counted() {
        let table = Table::new(&[1e30, 1e-30, 0.0]).expect("weights");
        assert_eq!((table.left_out(), table.probability(1), table.probability(0)), (1, 0.0, 1.0));
        let many = Table::new(&vec![0.1; 1_000_000]).expect("weights");
        assert_eq!(many.left_out(), 0);
        let sum: f64 = (0..many.len()).map(|index| f64::from(many.probability(index))).sum();
        assert_eq!(sum, 1.0);
    }

    #[test]
    fn weights_that_are_none() {
        for weights in [&[][..], &[0.0], &[1.0, -1.0], &[f32::NAN], &[f32::INFINITY, 1.0]] {
            assert_eq!(Table::new(weights), None);
        }
        assert!(Table::new(&[f32::MAX; 3]).is_some(), "the sum is taken in f64");
    }
}
