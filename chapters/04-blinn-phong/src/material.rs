//! What a surface is made of, as Blinn and Phong see it.

use common::film::Color;

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
