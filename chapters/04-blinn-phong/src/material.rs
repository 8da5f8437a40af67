//! What a surface is made of, as Blinn and Phong see it.

use common::film::Color;
use glam::Vec2;

use crate::paint::Paint;

// ANCHOR: material
/// What a surface returns of the light that reaches it directly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlinnPhong {
    /// k_a: of the light from everywhere.
    pub ambient: Paint,
    /// k_d: of a lamp's light, evenly in all directions.
    pub diffuse: Paint,
    /// k_s: of a lamp's light, around the direction of the mirror.
    pub specular: Color,
    /// n: how narrow the highlight is, 0 or more; at 0 there is none.
    pub shininess: f32,
}
// ANCHOR_END: material

/// The largest part of the light that a material may return, a thousand million times what comes in:
/// no real one does, and sums of what it returns stay far below the end of `f32`.
pub const MOST_RETURNED: f32 = 1e9;

/// A material at one place of the surface, its paints looked up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// k_a there.
    pub ambient: Color,
    /// k_d there.
    pub diffuse: Color,
    /// k_s.
    pub specular: Color,
    /// n.
    pub shininess: f32,
}

impl BlinnPhong {
    /// A material without highlight, that returns `paint` of all light, a lamp's or the ambient.
    pub fn matte(paint: Paint) -> Self {
        Self { ambient: paint, diffuse: paint, specular: Color::ZERO, shininess: 0.0 }
    }

    /// The same with a highlight.
    pub fn glossy(paint: Paint, specular: Color, shininess: f32) -> Self {
        Self { specular, shininess, ..Self::matte(paint) }
    }

    // ANCHOR: at
    /// The material at the place `uv`. With `TEXTURES` false every paint is taken for a plain one.
    #[inline]
    pub fn at<const TEXTURES: bool>(&self, uv: Vec2) -> Surface {
        let color = |paint: &Paint| if TEXTURES { paint.at(uv) } else { paint.plain() };
        Surface {
            ambient: color(&self.ambient),
            diffuse: color(&self.diffuse),
            specular: self.specular,
            shininess: self.shininess,
        }
    }
    // ANCHOR_END: at

    /// Whether its colour varies over the surface.
    pub fn is_textured(&self) -> bool {
        [self.ambient, self.diffuse].iter().any(|paint| matches!(paint, Paint::Checker { .. }))
    }

    /// Whether it has a highlight.
    pub fn has_highlight(&self) -> bool {
        self.shininess > 0.0 && self.specular != Color::ZERO
    }
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use glam::Vec2;

    use super::BlinnPhong;
    use crate::paint::Paint;

    #[test]
    fn a_plain_material_is_the_same_with_textures_and_without() {
        let paint = Paint::Plain(Color::new(0.6, 0.5, 0.1));
        let material = BlinnPhong::glossy(paint, Color::new(0.1, 0.2, 0.3), 7.0);
        assert_eq!(material.at::<true>(Vec2::ONE), material.at::<false>(Vec2::ONE));
        assert!(!material.is_textured() && material.has_highlight());
        assert!(!BlinnPhong::matte(paint).has_highlight());
    }

    #[test]
    fn a_checkerboard_shows_with_textures_only() {
        let colors = [Color::new(0.9, 0.1, 0.0), Color::new(0.2, 0.3, 0.4)];
        let material = BlinnPhong::matte(Paint::Checker { squares: 5.0, colors });
        let place = Vec2::new(0.3, 0.1);
        assert_eq!(material.at::<true>(place).diffuse, colors[1]);
        assert_eq!(material.at::<false>(place).diffuse, colors[0]);
        assert!(material.is_textured());
    }
}
