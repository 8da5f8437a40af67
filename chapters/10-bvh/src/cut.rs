//! A cut through the tree: its boxes, and the triangles in them, where a plane meets them.

use boxes::aabb::Aabb;
use common::film::Color;
use common::render::{Rendering, Settings, render_counted};
use common::tally::Tally;
use glam::{Vec2, Vec3, Vec3Swizzles};

use crate::node::Node;
use crate::plain::PlainBvh;

/// A picture of the plane across z through the middle of a tree.
pub struct Cut<'a> {
    tree: &'a PlainBvh,
    /// The point at the picture's top left corner.
    corner: Vec3,
    /// Units a pixel.
    scale: f32,
}

/// What is drawn on.
const PAPER: Color = Color::splat(0.9);
/// What a box adds to what is in it.
const SHADE: f32 = 0.93;
/// The lines of the boxes, from the root's down; those below the last are drawn like it.
const LINES: [Color; 6] = [
    Color::new(0.02, 0.02, 0.02),
    Color::new(0.0, 0.15, 0.45),
    Color::new(0.7, 0.1, 0.0),
    Color::new(0.0, 0.35, 0.16),
    Color::new(0.6, 0.2, 0.4),
    Color::new(0.75, 0.33, 0.0),
];
/// Levels whose lines are drawn; below they would cover one another.
const LEVELS: usize = 9;
/// Where the plane cuts a triangle.
const EDGE: Color = Color::new(0.0, 0.0, 0.0);

impl<'a> Cut<'a> {
    /// The picture of `tree`, as large as the settings say.
    pub fn new(tree: &'a PlainBvh, settings: &Settings) -> Self {
        let Aabb { min, max } = tree.tree().bounds();
        let film = Vec2::new(settings.width as f32, settings.height as f32);
        let size = (max - min).xy();
        let scale = 1.06 * (size / film).max_element();
        let middle = 0.5 * (min + max);
        let half = 0.5 * scale * film;
        let corner = Vec3::new(middle.x - half.x, middle.y + half.y, middle.z);
        Self { tree, corner, scale }
    }

    /// Draws it. It takes no rays.
    pub fn draw<T: Tally>(&self, settings: &Settings) -> Rendering<T> {
        render_counted(settings, |pixel, sampler, _tally: &mut T| {
            let place = pixel.position(sampler) * self.scale;
            let point = self.corner + Vec3::new(place.x, -place.y, 0.0);
            match self.tree.tree().nodes.first() {
                Some(root) => self.color(root, 0, point, PAPER),
                None => PAPER,
            }
        })
    }

    /// The colour at a point that has `color` from the boxes above this one.
    fn color(&self, node: &Node, level: usize, point: Vec3, color: Color) -> Color {
        let width = if level < LEVELS { (1.6 - 0.15 * level as f32) * self.scale } else { 0.0 };
        let Aabb { min, max } = node.bounds;
        let depth = (point - min).min(max - point);
        if depth.z < 0.0 || depth.xy().min_element() < -0.5 * width {
            return color;
        }
        let line = LINES[level.min(LINES.len() - 1)];
        let on_line = depth.xy().min_element() < 0.5 * width;
        let color = if on_line { line } else { SHADE * color };
        if node.is_leaf() {
            return if self.meets_triangle(node, point) { EDGE } else { color };
        }
        let nodes = &self.tree.tree().nodes;
        node.children()
            .iter()
            .fold(color, |color, &child| self.color(&nodes[child], level + 1, point, color))
    }

    fn meets_triangle(&self, leaf: &Node, point: Vec3) -> bool {
        let near = |corners: &[Vec3; 3]| {
            segment(corners, point.z)
                .is_some_and(|[a, b]| distance(point.xy(), a, b) < 0.8 * self.scale)
        };
        self.tree.stored()[leaf.items()].iter().any(|triangle| near(&triangle.corners))
    }
}

/// Where the plane at this z cuts a triangle.
fn segment(corners: &[Vec3; 3], z: f32) -> Option<[Vec2; 2]> {
    let [a, b, c] = *corners;
    let crossing = |p: Vec3, q: Vec3| {
        let along = (z - p.z) / (q.z - p.z);
        ((p.z < z) != (q.z < z)).then(|| (p + along * (q - p)).xy())
    };
    let mut ends = [(a, b), (b, c), (c, a)].into_iter().filter_map(|(p, q)| crossing(p, q));
    Some([ends.next()?, ends.next()?])
}

/// How far a point is from the line between two others.
fn distance(point: Vec2, a: Vec2, b: Vec2) -> f32 {
    let along = (point - a).dot(b - a) / (b - a).length_squared();
    let along = if along.is_finite() { along.clamp(0.0, 1.0) } else { 0.0 };
    (point - a - along * (b - a)).length()
}

#[cfg(test)]
mod tests {
    use glam::{Vec2, Vec3};

    use super::{distance, segment};

    #[test]
    fn a_plane_cuts_a_triangle_in_a_line() {
        let corners = [Vec3::ZERO, Vec3::new(4.0, 0.0, 2.0), Vec3::new(0.0, 6.0, 2.0)];
        assert_eq!(segment(&corners, 1.0), Some([Vec2::new(2.0, 0.0), Vec2::new(0.0, 3.0)]));
        assert_eq!(segment(&corners, 3.0), None);
    }

    #[test]
    fn distances_from_a_line_and_from_its_ends() {
        let (a, b) = (Vec2::new(1.0, 1.0), Vec2::new(5.0, 1.0));
        assert_eq!(distance(Vec2::new(3.0, 3.5), a, b), 2.5);
        assert_eq!(distance(Vec2::new(8.0, 5.0), a, b), 5.0);
        assert_eq!(distance(Vec2::new(1.0, 3.0), a, a), 2.0);
    }
}
