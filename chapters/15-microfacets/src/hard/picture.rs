//! The lobe of a surface that is nearly smooth, as a picture.

use common::film::{Color, Film};
use glam::Vec3;

use crate::ggx::Ggx;
use crate::naive;

const SIDE: u32 = 300;
const GAP: u32 = 8;
const ALPHA: f32 = 4e-4;

/// D for normals up to three times the roughness 0.0004 off the vertical, over its largest value. The
/// textbook's formula on the left, ours on the right.
pub(super) fn picture() -> Film {
    let largest = Ggx { alpha: ALPHA }.density(Vec3::Z);
    Film::from_fn(2 * SIDE + GAP, SIDE, |x, y| {
        let (column, ours) = (x % (SIDE + GAP), x > SIDE);
        if column >= SIDE {
            return Color::splat(0.5);
        }
        let place = |pixel: u32| 6.0 * ((pixel as f32 + 0.5) / SIDE as f32 - 0.5) * ALPHA;
        let normal = Vec3::new(place(column), place(y), 1.0).normalize();
        let density = if ours {
            Ggx { alpha: ALPHA }.density(normal)
        } else {
            naive::density(ALPHA, normal.z)
        };
        let part = density / largest;
        // Blue to white; orange for what is no number, or more than there can be.
        if !(part <= 1.0 + 1e-3) {
            return Color::new(0.9, 0.3, 0.05);
        }
        Color::new(part, part, part.sqrt())
    })
}
