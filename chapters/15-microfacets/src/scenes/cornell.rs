//! The Cornell box with metal in it.

use common::film::Color;
use fresnel::conductor::Metal;
use glam::Vec3;
use path_tracing::model::Model;
use path_tracing::part::{Form, Part};
use path_tracing::scenes::{CEILING_LIGHT, TALL, block, box_view, enclosure, light};

use crate::finish::Finish;
use crate::rough::Rough;

/// The tall block of gold, and a ball of copper for the short one.
pub(super) fn rough_metals() -> Model<Finish> {
    let mut room = enclosure();
    room.push(light(CEILING_LIGHT));
    let mut parts: Vec<_> = room.into_iter().map(|part| part.map(Finish::from)).collect();
    let ball = Form::ball(Vec3::new(185.0, 90.0, 169.0), 90.0);
    parts.push(Part::dark(ball, Rough::metal(Metal::COPPER, 0.4).into()));
    parts.push(block(&TALL, Rough::metal(Metal::GOLD, 0.2).into()));
    Model::new(parts, Color::ZERO, box_view())
}
