//! The slab as a picture: what becomes of rays that enter it at a grazing angle.

use common::film::{Color, Film};
use glam::{DVec3, Vec3};

use super::slabs::{away, through_naive, through_ours};
use crate::index::Index;

const SIDE: u32 = 300;
const GAP: u32 = 8;

/// From left to right the cosine at which rays enter grows from 10⁻⁵ to 0.003; each row is another
/// direction along the surface. Black is trapped, red left by more than 10⁻⁵ elsewhere, and pale
/// blue as it came. The textbook's formula on the left, ours on the right.
pub(super) fn picture() -> Film {
    let normal = Vec3::new(0.36, 0.48, 0.8);
    let [right, up] = [DVec3::new(0.8, -0.6, 0.0), DVec3::new(0.48, 0.64, -0.6)];
    Film::from_fn(2 * SIDE + GAP, SIDE, |x, y| {
        let (column, ours) = (x % (SIDE + GAP), x > SIDE);
        if column >= SIDE {
            return Color::splat(0.5);
        }
        let cosine = f64::from(column + 1) * 1e-5;
        let turn = (f64::from(y) + 0.5) / f64::from(SIDE);
        let across = (turn * right + (1.0 - turn) * up).normalize();
        let direction = (1.0 - cosine * cosine).sqrt() * across - cosine * normal.as_dvec3();
        let direction = direction.as_vec3();
        let through = if ours { through_ours } else { through_naive };
        match through(Index::GLASS, direction, normal) {
            None => Color::ZERO,
            Some(outside) if away(direction, outside) => Color::new(0.8, 0.25, 0.1),
            Some(_) => Color::new(0.55, 0.7, 0.85),
        }
    })
}
