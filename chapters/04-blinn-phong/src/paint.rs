//! Colours that vary over a surface.

use common::film::Color;
use glam::Vec2;

// ANCHOR: paint
/// A colour for each place of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Paint {
    /// The same everywhere.
    Plain(Color),
    /// A checkerboard.
    Checker {
        /// Squares from one side of the surface to the other.
        squares: f32,
        /// The colour of the square in the corner where u and v are 0, and that of its neighbours.
        colors: [Color; 2],
    },
}
// ANCHOR_END: paint

impl Paint {
    // ANCHOR: at
    /// The colour at the place `uv`, both coordinates in [0, 1].
    pub fn at(&self, uv: Vec2) -> Color {
        match *self {
            Self::Plain(color) => color,
            Self::Checker { squares, colors } => {
                let square = (uv * squares).floor();
                // The last line of a surface belongs to its last square.
                let square = square.min(Vec2::splat(squares.ceil() - 1.0));
                colors[((square.x + square.y) as i64).rem_euclid(2) as usize]
            }
        }
    }
    // ANCHOR_END: at

    /// The colour where it doesn't vary; of a checkerboard, that of its first square.
    pub fn plain(&self) -> Color {
        match *self {
            Self::Plain(color) => color,
            Self::Checker { colors: [first, _], .. } => first,
        }
    }

    /// The same with every colour passed through `change`.
    pub fn map(self, change: impl Fn(Color) -> Color) -> Self {
        match self {
            Self::Plain(color) => Self::Plain(change(color)),
            Self::Checker { squares, colors } => {
                Self::Checker { squares, colors: colors.map(change) }
            }
        }
    }

    /// Whether nothing of it is lighter than black.
    pub fn is_black(&self) -> bool {
        match *self {
            Self::Plain(color) => color == Color::ZERO,
            Self::Checker { colors, .. } => colors == [Color::ZERO; 2],
        }
    }
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use glam::Vec2;

    use super::Paint;

    const RED: Color = Color::new(0.8, 0.2, 0.1);
    const WHITE: Color = Color::new(0.9, 0.8, 0.7);
    const FLOOR: Paint = Paint::Checker { squares: 5.0, colors: [RED, WHITE] };

    #[test]
    fn five_squares_a_side() {
        let row = |v: f32| [0.1, 0.3, 0.5, 0.7, 0.9].map(|u| FLOOR.at(Vec2::new(u, v)));
        assert_eq!(row(0.1), [RED, WHITE, RED, WHITE, RED]);
        assert_eq!(row(0.3), [WHITE, RED, WHITE, RED, WHITE]);
        assert_eq!(row(0.9), row(0.1));
    }

    #[test]
    fn the_far_edges_belong_to_the_last_squares() {
        let near_end = FLOOR.at(Vec2::new(0.99, 0.5));
        assert_eq!(FLOOR.at(Vec2::new(1.0, 0.5)), near_end);
        assert_eq!(FLOOR.at(Vec2::ONE), FLOOR.at(Vec2::splat(0.99)));
        assert_eq!(FLOOR.at(Vec2::new(0.2, 0.0)), WHITE, "an inner line belongs to the next");
    }

    #[test]
    fn places_that_are_none_have_a_colour_too() {
        for uv in [Vec2::NAN, Vec2::splat(-3.7), Vec2::splat(f32::INFINITY), Vec2::splat(-1e30)] {
            assert!([RED, WHITE].contains(&FLOOR.at(uv)), "{uv}");
        }
    }

    #[test]
    fn black_is_black_whatever_the_pattern() {
        assert!(FLOOR.map(|_| Color::ZERO).is_black() && !FLOOR.is_black());
        assert_eq!(FLOOR.map(|color| 0.5 * color).plain(), 0.5 * RED);
    }
}
