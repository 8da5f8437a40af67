//! Strata: equal parts of an interval, and a point in each.

// ANCHOR: place
/// The point at the part `u` of stratum number `index` of `count` of [0, 1), always in it.
///
/// (i + u) / n in `f32` rounds into the next stratum, or to 1 (hard case MC-09).
#[inline]
pub fn place(index: u32, count: u32, u: f32) -> f32 {
    let count = f64::from(count);
    let exact = (f64::from(index) + f64::from(u)) / count;
    let near = exact as f32;
    // Rounding to the nearest `f32` may have left the stratum by one.
    let number = (f64::from(near) * count) as u32;
    match number.cmp(&index) {
        std::cmp::Ordering::Less => near.next_up(),
        std::cmp::Ordering::Equal => near,
        std::cmp::Ordering::Greater => near.next_down(),
    }
}
// ANCHOR_END: place

// ANCHOR: number
/// The number of the stratum of `count` in which x of [0, 1) lies. `count` is at most 2²⁴.
///
/// The product of two 24-bit numbers is exact in `f64`.
#[inline]
pub fn number(x: f32, count: u32) -> u32 {
    (f64::from(x) * f64::from(count)) as u32
}
// ANCHOR_END: number

#[cfg(test)]
mod tests {
    use super::{number, place};

    #[test]
    fn every_stratum_keeps_its_points() {
        let below_one = 1.0f32.next_down();
        for count in [1, 3, 10, 1000, 65_537] {
            for index in 0..count {
                for u in [0.0, 0.3, below_one] {
                    assert_eq!(number(place(index, count, u), count), index, "{count} {u}");
                }
            }
        }
    }
}
