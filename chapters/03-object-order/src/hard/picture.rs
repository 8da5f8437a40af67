//! The failures as pictures: above, samples on shared edges; below, a floor that goes on behind the
//! eye. Left naive, right robust.

use common::film::{Color, Film};
use glam::{DVec2, Vec2};

use super::coverage::{Fan, SIDE, around, fan, fixed_owners, float_owners};
use super::straddle::clipped_covers;
use crate::fixed::Fixed;
use crate::naive::divided_covers;
use crate::project::FilmPoint;

/// Pixels along a side of each of the four panels, and between them.
const PANEL: u32 = 288;
const GAP: u32 = 16;

/// The four panels.
pub fn picture() -> Film {
    let mut film = Film::new(2 * PANEL + GAP, 2 * PANEL + GAP);
    film.pixels.fill(Color::ONE);
    let right = PANEL + GAP;
    paint_fan(&mut film, 0, float_owners);
    paint_fan(&mut film, right, fixed_owners);
    paint_floor(&mut film, [0, right], divided_covers);
    paint_floor(&mut film, [right, right], clipped_covers);
    film
}

/// Samples on the shared edges, on each panel.
const DOTS: u64 = 700;
/// Where the fan's triangles meet.
const MIDDLE: Vec2 = Vec2::new(25.317_42, 38.901_73);

/// A fan with samples on its edges: one that is owned once is grey, a hole is red, and one that is
/// owned twice is yellow.
fn paint_fan(film: &mut Film, left: u32, owners: fn(&Fan) -> usize) {
    let triangles = around(MIDDLE);
    let shades = [0.50, 0.58, 0.66, 0.74].map(|shade| Color::new(shade, shade, shade + 0.15));
    for y in 0..PANEL {
        for x in 0..PANEL {
            let sample = Vec2::new(x as f32 + 0.5, y as f32 + 0.5) * (SIDE / PANEL as f32);
            let owned = |triangle| fixed_owners(&Fan { triangles: [triangle; 4], sample }) == 4;
            let owner = triangles.iter().position(|&triangle| owned(triangle));
            *film.pixel_mut(left + x, y) = owner.map_or(Color::ONE, |owner| shades[owner]);
        }
    }
    for trial in 0..DOTS {
        let sample = moved(&fan(trial), &triangles);
        let color = match owners(&Fan { triangles, sample }) {
            0 => Color::new(1.0, 0.0, 0.05),
            1 => Color::splat(0.15),
            _ => Color::new(1.0, 0.85, 0.0),
        };
        dot(film, left, sample, color);
    }
}

/// The sample of one fan, moved to the same place along the same edge of another.
fn moved(fan: &Fan, triangles: &[[Vec2; 3]; 4]) -> Vec2 {
    let (from, middle) = (fan.triangles[0][0], triangles[0][0]);
    let toward = fan.sample - from;
    let end = SIDE * Vec2::new(f32::from(toward.x > 0.0), f32::from(toward.y > 0.0));
    middle + toward.length() / (end - from).length() * (end - middle)
}

/// A square of 3 by 3 pixels.
fn dot(film: &mut Film, left: u32, sample: Vec2, color: Color) {
    let corner = (sample * (PANEL as f32 / SIDE)).as_uvec2().min(glam::UVec2::splat(PANEL - 3));
    for (right, down) in (0..3).flat_map(|down| (0..3).map(move |right| (right, down))) {
        *film.pixel_mut(left + corner.x + right, corner.y + down) = color;
    }
}

/// A floor of two triangles, from behind the eye to far away.
fn paint_floor(film: &mut Film, [left, top]: [u32; 2], owns: fn([FilmPoint; 3], Fixed) -> bool) {
    let colors = [Color::new(0.1, 0.35, 0.6), Color::new(0.75, 0.3, 0.05)];
    let [a, b, c, d] = [[-2.5, -1.5], [2.0, -1.5], [3.5, 30.0], [-3.0, 30.0]].map(on_floor);
    for y in 0..PANEL {
        for x in 0..PANEL {
            let sample = Fixed::snap(DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5));
            let owner = [[a, b, c], [a, c, d]].iter().position(|&corners| owns(corners, sample));
            let color = owner.map_or(Color::new(0.75, 0.85, 0.9), |owner| colors[owner]);
            *film.pixel_mut(left + x, top + y) = color;
        }
    }
}

/// A point one unit below the eye, `x` to the right and `w` ahead, seen in a field of view of 90°.
fn on_floor([x, w]: [f64; 2]) -> FilmPoint {
    let half = f64::from(PANEL) / 2.0;
    FilmPoint { x: half * (w + x), y: half * (w + 1.0), w }
}
