//! What a picture shows of the nearest surface.

use common::film::{Color, Film};
use common::tally::Tally;
use glam::Vec3;
use ray_casting::picture::BACKGROUND;
use triangles::mesh::Mesh;
use triangles::surface;

use crate::fragment::Fragment;
use crate::parity::{IDS_DIFFER, UNJUSTIFIED, Verdict};

/// The direction a surface faces: x, y and z as red, green and blue.
pub fn normal<const SMOOTH: bool>(mesh: &Mesh, fragment: Option<Fragment>) -> Color {
    fragment.map_or(BACKGROUND, |Fragment { triangle, barycentric, .. }| {
        (surface::normal::<SMOOTH>(mesh, triangle as usize, barycentric) + Vec3::ONE) / 2.0
    })
}

/// Depth: white at the nearest vertex of the mesh, nearly black at the farthest, black behind all.
pub fn depth([nearest, farthest]: [f32; 2], fragment: Option<Fragment>) -> Color {
    let Some(Fragment { depth, .. }) = fragment else { return Color::ZERO };
    let share = (farthest - depth) / (farthest - nearest).max(f32::MIN_POSITIVE);
    Color::splat(0.05 + 0.95 * share.clamp(0.0, 1.0))
}

/// A colour for each triangle, unlike its neighbours' colours.
pub fn id(fragment: Option<Fragment>) -> Color {
    fragment.map_or(Color::ZERO, |Fragment { triangle, .. }| {
        // Multiples of the golden ratio spread over a circle without ever meeting (Weyl).
        let [red, green, blue] = [0x9e37_79b9_u32, 0xb529_7a4d, 0x68e3_1da4].map(|step| {
            let turned = (triangle + 1).wrapping_mul(step) >> 24;
            0.1 + 0.9 * turned as f32 / 255.0
        });
        Color::new(red, green, blue)
    })
}

/// Where the two orders differ: grey where they agree, a colour where they don't. Counts both.
pub fn difference<T: Tally>(verdict: Verdict, plain: Color, tally: &mut T) -> Color {
    tally.count(IDS_DIFFER, u64::from(verdict != Verdict::Same));
    tally.count(UNJUSTIFIED, u64::from(verdict == Verdict::Unjustified));
    match verdict {
        Verdict::Same => Color::splat(0.25 * plain.element_sum() / 3.0),
        Verdict::AtAnEdge => VERMILION,
        Verdict::EquallyDeep => BLUE,
        Verdict::BeforeTheNearPlane => GREEN,
        Verdict::Unjustified => MAGENTA,
    }
}

const VERMILION: Color = Color::new(1.0, 0.12, 0.0);
const BLUE: Color = Color::new(0.0, 0.3, 1.0);
const GREEN: Color = Color::new(0.0, 0.6, 0.2);
const MAGENTA: Color = Color::new(1.0, 0.0, 1.0);

/// Draws a square around each pixel that is not grey: one pixel alone is easily overlooked.
pub fn mark(film: &mut Film) {
    let marked = film.clone();
    for y in 0..film.height {
        for x in 0..film.width {
            let color = marked.pixel(x, y);
            if color.min_element() < color.max_element() {
                frame(film, [x, y], color);
            }
        }
    }
}

/// A square frame of 9 by 9 pixels around a pixel, as far as it lies on the film.
fn frame(film: &mut Film, [x, y]: [u32; 2], color: Color) {
    let reach = |middle: u32, size: u32| middle.saturating_sub(4)..(middle + 5).min(size);
    for row in reach(y, film.height) {
        for column in reach(x, film.width) {
            if row.abs_diff(y).max(column.abs_diff(x)) == 4 {
                *film.pixel_mut(column, row) = color;
            }
        }
    }
}
