//! TR-12 and TR-13: numbers that are none.

use common::obj::nasty::{Nasty, OBJ};
use glam::Vec3;
use ray_casting::ray::Ray;

use super::shapes::ask;
use crate::intersect::TriangleTest;
use crate::naive::Unguarded;
use crate::watertight::ShearedRay;

/// Numbers that spoil whatever they are put in.
const SPOILERS: [f32; 3] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY];

/// Origin, direction and three corners have 15 coordinates.
const COORDINATES: u64 = 15;

/// Each coordinate spoiled in three ways, and a limit that is NaN or minus infinity.
pub(super) const BROKEN_INPUTS: u64 = COORDINATES * 3 + 2;

/// Whether a ray or triangle that isn't finite, or a limit that no distance is below, gives a hit.
fn hits_nonsense<Test: TriangleTest>(trial: u64) -> bool {
    let mut vectors = [
        Vec3::new(0.3, 0.2, -2.0),
        Vec3::new(0.1, 0.05, 1.0),
        Vec3::new(-1.0, -1.5, 0.5),
        Vec3::new(2.0, -1.0, 1.0),
        Vec3::new(0.5, 2.5, 0.0),
    ];
    let mut limit = f32::INFINITY;
    if trial < COORDINATES * 3 {
        let (place, spoiler) = ((trial / 3) as usize, SPOILERS[(trial % 3) as usize]);
        vectors[place / 3][place % 3] = spoiler;
    } else {
        limit = [f32::NAN, f32::NEG_INFINITY][(trial - COORDINATES * 3) as usize];
    }
    let [origin, direction, a, b, c] = vectors;
    ask::<Test>(&Ray { origin, direction }, &[a, b, c], limit).is_some()
}

pub(super) fn broken_naive(trial: u64) -> bool {
    hits_nonsense::<Unguarded>(trial)
}

pub(super) fn broken_robust(trial: u64) -> bool {
    hits_nonsense::<ShearedRay>(trial)
}

/// Files that are hard to read, and what must come of each.
pub(super) const FILES: &[Nasty] = OBJ;

/// Whether the parser library alone gets file number `trial` wrong.
pub(super) fn file_naive(trial: u64) -> bool {
    !FILES[trial as usize].naive()
}

/// Whether our reader does.
pub(super) fn file_robust(trial: u64) -> bool {
    !FILES[trial as usize].robust()
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use ray_casting::ray::Ray;

    use crate::hard::shapes::ask;
    use crate::watertight::ShearedRay;

    /// TR-12 proves something only if the unspoiled ray hits.
    #[test]
    fn the_unspoiled_ray_hits() {
        let ray = Ray { origin: Vec3::new(0.3, 0.2, -2.0), direction: Vec3::new(0.1, 0.05, 1.0) };
        let corners =
            [Vec3::new(-1.0, -1.5, 0.5), Vec3::new(2.0, -1.0, 1.0), Vec3::new(0.5, 2.5, 0.0)];
        assert!(ask::<ShearedRay>(&ray, &corners, f32::INFINITY).is_some());
    }
}
