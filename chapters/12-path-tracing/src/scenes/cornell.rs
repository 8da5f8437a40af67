//! The Cornell box, as Cornell University measured it and the report has it.

use common::film::Color;
use glam::Vec3;
use ray_casting::camera::View;

use crate::glass::Glass;
use crate::mirror::Mirror;
use crate::model::Model;
use crate::part::{Form, Part};
use crate::smooth::Smooth;
use fresnel::index::Index;

/// The white walls and blocks.
pub const WHITE: Smooth = Smooth::matte(0.725, 0.71, 0.68);
/// The wall on the picture's left.
pub const RED: Smooth = Smooth::matte(0.63, 0.065, 0.05);
/// The wall on its right.
pub const GREEN: Smooth = Smooth::matte(0.14, 0.45, 0.091);

/// The radiance of the lamp: the report's sum of three bands.
pub const CEILING_LIGHT: Color = Color::new(
    8.0 * (0.747 + 0.058) + 15.6 * (0.740 + 0.287) + 18.4 * (0.737 + 0.642),
    8.0 * (0.747 + 0.258) + 15.6 * (0.740 + 0.160) + 18.4 * (0.737 + 0.159),
    8.0 * 0.747 + 15.6 * 0.740 + 18.4 * 0.737,
);

/// Figure 5.6.
pub(super) fn matte() -> Model<Smooth> {
    let mut parts = enclosure();
    parts.push(light(CEILING_LIGHT));
    parts.extend([block(&SHORT, WHITE), block(&TALL, WHITE)]);
    model(parts)
}

/// The same with a mirror for the tall block, and glass for the short one.
pub(super) fn with_glass() -> Model<Smooth> {
    let mut parts = enclosure();
    parts.push(light(CEILING_LIGHT));
    let mirror = Smooth::Mirror(Mirror { reflectance: Color::splat(0.9) });
    let glass = Smooth::Glass(Glass { index: Index::GLASS });
    let ball = Form::ball(Vec3::new(185.0, 90.0, 169.0), 90.0);
    parts.extend([Part::dark(ball, glass), block(&TALL, mirror)]);
    model(parts)
}

/// The same as figure 5.6 with the lamp off.
pub(super) fn dark() -> Model<Smooth> {
    let mut parts = enclosure();
    parts.extend([block(&SHORT, WHITE), block(&TALL, WHITE)]);
    model(parts)
}

fn model(parts: Vec<Part<Smooth>>) -> Model<Smooth> {
    Model::new(parts, Color::ZERO, box_view())
}

/// Where the box is seen from.
pub fn box_view() -> View {
    let eye = Vec3::new(278.0, 273.0, -800.0);
    View { eye, target: eye.with_z(0.0), up: Vec3::Y, vertical_fov: 40.0 }
}

/// Floor, ceiling, back, and the green and the red wall.
pub fn enclosure() -> Vec<Part<Smooth>> {
    let wall = |corners: [[f32; 3]; 4], material| {
        Part::dark(Form::quad(corners.map(Vec3::from_array)), material)
    };
    let [floor_near, floor_far] = [[552.8, 0.0, 0.0], [549.6, 0.0, 559.2]];
    let [top_near, top_far] = [[556.0, 548.8, 0.0], [556.0, 548.8, 559.2]];
    let [right_near, right_far] = [[0.0, 0.0, 0.0], [0.0, 0.0, 559.2]];
    let [right_top_near, right_top_far] = [[0.0, 548.8, 0.0], [0.0, 548.8, 559.2]];
    vec![
        wall([floor_near, right_near, right_far, floor_far], WHITE),
        wall([top_near, top_far, right_top_far, right_top_near], WHITE),
        wall([floor_far, right_far, right_top_far, top_far], WHITE),
        wall([right_far, right_near, right_top_near, right_top_far], GREEN),
        wall([floor_near, floor_far, top_far, top_near], RED),
    ]
}

/// The lamp of this radiance, which shines downwards and reflects nothing.
pub fn light(radiance: Color) -> Part<Smooth> {
    let corners = [[343.0, 227.0], [343.0, 332.0], [213.0, 332.0], [213.0, 227.0]];
    let form = Form::quad(corners.map(|[x, z]| Vec3::new(x, 548.7, z)));
    Part::glowing(form, Smooth::BLACK, radiance)
}

/// A block that stands on the floor: its height, and its top's corners (x, z), clockwise from above.
pub struct Block {
    height: f32,
    top: [[f32; 2]; 4],
}

/// The short block.
pub const SHORT: Block =
    Block { height: 165.0, top: [[130.0, 65.0], [82.0, 225.0], [240.0, 272.0], [290.0, 114.0]] };
/// The tall block.
pub const TALL: Block =
    Block { height: 330.0, top: [[423.0, 247.0], [265.0, 296.0], [314.0, 456.0], [472.0, 406.0]] };

/// The top and the four sides of a block of one material.
pub fn block<M>(block: &Block, material: M) -> Part<M> {
    let at = |corner: usize, y: f32| {
        let [x, z] = block.top[corner % 4];
        Vec3::new(x, y, z)
    };
    let mut triangles = Vec::new();
    let mut face = |[a, b, c, d]: [Vec3; 4]| triangles.extend([[a, b, c], [a, c, d]]);
    face([0, 1, 2, 3].map(|corner| at(corner, block.height)));
    for side in 0..4 {
        let [bottom, top] = [0.0, block.height];
        face([at(side, top), at(side, bottom), at(side + 1, bottom), at(side + 1, top)]);
    }
    Part::dark(Form::Triangles(triangles), material)
}

#[cfg(test)]
mod tests {
    use glam::Vec3;
    use triangles::surface::geometric_normal;

    use super::{CEILING_LIGHT, SHORT, TALL, WHITE, block, light};
    use crate::part::Form;

    #[test]
    fn the_lamp_shines_down() {
        let Form::Triangles(triangles) = light(CEILING_LIGHT).form else { panic!("a quad") };
        for corners in triangles {
            assert_eq!(geometric_normal(&corners), Some(Vec3::NEG_Y));
        }
        assert!((CEILING_LIGHT - Vec3::new(47.8348, 38.5664, 31.0808)).length() < 1e-4);
    }

    #[test]
    fn blocks_have_their_outside_outside() {
        for shape in [SHORT, TALL] {
            let Form::Triangles(triangles) = block(&shape, WHITE).form else { panic!("triangles") };
            let corners: Vec<Vec3> = triangles.iter().flatten().copied().collect();
            let middle = corners.iter().sum::<Vec3>() / corners.len() as f32;
            for triangle in &triangles {
                let normal = geometric_normal(triangle).expect("an area");
                assert!(normal.dot(triangle[0] - middle) > 0.0, "{triangle:?}");
            }
        }
    }
}
