//! Under the sky.

use common::chapter::Failure;
use common::film::Color;
use glam::Vec3;
use triangles::scene::MeshScene;

use crate::model::Model;
use crate::part::{Form, Part};
use crate::smooth::Smooth;

/// The radiance of the sky.
const SKY: Color = Color::new(0.7, 0.8, 1.0);

/// The report's bunny on a floor, under a bright sky. Its triangles are flat here.
pub(super) fn bunny() -> Result<Model<Smooth>, Failure> {
    let MeshScene { mesh, view, .. } = MeshScene::named("bunny")?;
    let corners = mesh.all_corners();
    let points = || corners.iter().flatten().copied();
    let (low, high) = (points().fold(Vec3::MAX, Vec3::min), points().fold(Vec3::MIN, Vec3::max));
    let middle = (low + high) / 2.0;
    let floor = [[-20.0, 20.0], [20.0, 20.0], [20.0, -20.0], [-20.0, -20.0]];
    let floor = floor.map(|[x, z]| Vec3::new(middle.x + x, low.y, middle.z + z));
    let parts = vec![
        Part::dark(Form::Triangles(corners), Smooth::matte(0.7, 0.5, 0.3)),
        Part::dark(Form::quad(floor), Smooth::matte(0.5, 0.5, 0.5)),
    ];
    Ok(Model::new(parts, SKY, view))
}
