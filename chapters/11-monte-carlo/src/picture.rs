//! Points, drawn as dots in six squares.

use common::film::Color;
use common::render::{Rendering, Settings, render_counted};
use common::tally::Tally;
use glam::Vec2;

use crate::command::SAMPLES;
use crate::points::Points;
use crate::warp::{disk, hemisphere, triangle};

/// Squares beside each other, and below.
const COLUMNS: usize = 3;
const ROWS: usize = 2;

/// A dot's radius in a square of side 1, for 256 points.
const RADIUS: f32 = 0.011;

/// What is around the points of a square.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Outline {
    Square,
    Disk,
    Triangle,
}

/// One square: its points, each coordinate in [0, 1], x to the right and y up.
struct Panel {
    points: Vec<Vec2>,
    outline: Outline,
}

/// Six squares with points.
pub struct Panels {
    /// Row by row from the top left.
    panels: Vec<Panel>,
    radius: f32,
}

/// From the square to the place of the points.
type Warp = fn(Vec2) -> Vec2;

/// From a disk around 0 to the square.
fn beside(point: Vec2) -> Vec2 {
    0.5 * point + 0.5
}

impl Panels {
    /// Random, stratified and Sobol points; below, the same in the disk.
    pub fn of_points(count: u32, seed: u64) -> Self {
        let panel = |points: Points, outline, warp: Warp| Panel {
            points: (0..count).map(|index| warp(points.at(index, count, seed))).collect(),
            outline,
        };
        let square = Points::ALL.map(|points| panel(points, Outline::Square, |u| u));
        let round = |points| panel(points, Outline::Disk, |u| beside(disk::concentric(u)));
        Self::new(square.into_iter().chain(Points::ALL.map(round)).collect(), count)
    }

    /// The same points as they are, in the disk by radius and angle, in the disk by squares; in a
    /// triangle; and on the hemisphere seen from above, uniform and by the cosine.
    pub fn of_warps(points: Points, count: u32, seed: u64) -> Self {
        let warps: [(Outline, Warp); COLUMNS * ROWS] = [
            (Outline::Square, |u| u),
            (Outline::Disk, |u| beside(disk::polar(u))),
            (Outline::Disk, |u| beside(disk::concentric(u))),
            (Outline::Triangle, |u| triangle::barycentric(u).truncate()),
            (Outline::Disk, |u| beside(hemisphere::uniform(u).truncate())),
            (Outline::Disk, |u| beside(hemisphere::cosine(u).truncate())),
        ];
        let panel = |(outline, warp): (Outline, Warp)| Panel {
            points: (0..count).map(|index| warp(points.at(index, count, seed))).collect(),
            outline,
        };
        Self::new(warps.into_iter().map(panel).collect(), count)
    }

    fn new(panels: Vec<Panel>, count: u32) -> Self {
        Self { panels, radius: RADIUS * (256.0 / count as f32).sqrt().clamp(0.25, 2.0) }
    }

    /// The picture. No ray is followed for it.
    pub fn draw<T: Tally>(&self, settings: &Settings) -> Rendering<T> {
        let size = Vec2::new(settings.width as f32, settings.height as f32);
        let mut rendering: Rendering<T> = render_counted(settings, |pixel, sampler, _tally| {
            let place = pixel.position(sampler) / size * Vec2::new(COLUMNS as f32, ROWS as f32);
            let column = (place.x as usize).min(COLUMNS - 1);
            let row = (place.y as usize).min(ROWS - 1);
            let within = place - Vec2::new(column as f32, row as f32);
            // A margin, and y up.
            let within = (Vec2::new(within.x, 1.0 - within.y) - 0.5) / 0.9 + 0.5;
            self.panels[row * COLUMNS + column].color(within, self.radius)
        });
        let points: usize = self.panels.iter().map(|panel| panel.points.len()).sum();
        rendering.tally.count(SAMPLES, points as u64);
        rendering
    }
}

impl Panel {
    /// A dot is dark blue, the place around them pale, and what is outside is white.
    fn color(&self, place: Vec2, radius: f32) -> Color {
        let near = |point: &Vec2| point.distance_squared(place) < radius * radius;
        if self.points.iter().any(near) {
            Color::new(0.01, 0.06, 0.45)
        } else if self.outline.contains(place) {
            Color::new(0.85, 0.9, 0.96)
        } else {
            Color::ONE
        }
    }
}

impl Outline {
    fn contains(self, place: Vec2) -> bool {
        match self {
            Self::Square => place.min_element() >= 0.0 && place.max_element() <= 1.0,
            Self::Disk => place.distance_squared(Vec2::splat(0.5)) <= 0.25,
            Self::Triangle => place.min_element() >= 0.0 && place.x + place.y <= 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::render::Settings;
    use common::tally::Counts;

    use super::Panels;
    use crate::command::SAMPLES;
    use crate::points::Points;

    #[test]
    fn dots_are_where_points_are() {
        let settings = Settings { width: 300, height: 200, ..Settings::default() };
        let all = [Panels::of_points(64, 1), Panels::of_warps(Points::Random, 64, 1)];
        for panels in all {
            let rendering = panels.draw::<Counts>(&settings);
            assert_eq!(rendering.tally.of(SAMPLES), 6 * 64);
            let dark = rendering.film.pixels.iter().filter(|pixel| pixel.x < 0.1).count();
            // 384 dots of radius 0.022 in squares of 90 pixels are 4700 pixels, less what overlaps.
            assert!((3000..4800).contains(&dark), "{dark}");
            assert_eq!(rendering.film.pixel(0, 0), Color::ONE);
        }
    }
}
