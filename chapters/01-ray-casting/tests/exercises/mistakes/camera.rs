//! Mistakes in cameras: exercises 1.1 and 1.6.

use common::exercise::Mistake;
use common::math;
use glam::Vec3;
use ray_casting::naive::report_ray;

use crate::cases::{Pixel, Seen};

/// The film's point with these deviations from the right formula.
struct Slip {
    /// Where in the pixel.
    centre: f32,
    /// What x is multiplied with besides the tangent.
    aspect: f32,
    /// 1 when y points up.
    up: f32,
    /// The tangent.
    scale: f32,
}

fn film(pixel: &Pixel, slip: Slip) -> Vec3 {
    let x = 2.0 * (pixel.x as f32 + slip.centre) / pixel.width as f32 - 1.0;
    let y = 1.0 - 2.0 * (pixel.y as f32 + slip.centre) / pixel.height as f32;
    Vec3::new(x * slip.aspect * slip.scale, y * slip.up * slip.scale, -1.0)
}

fn right(pixel: &Pixel) -> Slip {
    let scale = math::tan(pixel.vertical_fov.to_radians() / 2.0);
    Slip { centre: 0.5, aspect: pixel.width as f32 / pixel.height as f32, up: 1.0, scale }
}

pub(crate) fn of_pixel_direction() -> Vec<Mistake<Pixel, Vec3>> {
    vec![
        Mistake {
            name: "through the pixel's corner",
            diagnosis: "Your ray goes through the top left corner of the pixel. Its centre is half \
                        a pixel further, at (x + 0.5, y + 0.5): see 'From a pixel to a ray'.",
            answer: |pixel| film(pixel, Slip { centre: 0.0, ..right(pixel) }).normalize(),
        },
        Mistake {
            name: "upside down",
            diagnosis: "Rows are counted from the top, but y points up, so y must fall as the row \
                        grows: see 'From a pixel to a ray'.",
            answer: |pixel| film(pixel, Slip { up: -1.0, ..right(pixel) }).normalize(),
        },
        Mistake {
            name: "stretched",
            diagnosis: "Your film is a square. The field of view gives its height; its width is \
                        width / height times that: see 'From a pixel to a ray'.",
            answer: |pixel| film(pixel, Slip { aspect: 1.0, ..right(pixel) }).normalize(),
        },
        Mistake {
            name: "the tangent of the whole angle",
            diagnosis: "The triangle between the eye, the middle of the film and its top edge has \
                        half the field of view at the eye: see the diagram in 'From a pixel to a \
                        ray'.",
            answer: |pixel| {
                let scale = math::tan(pixel.vertical_fov.to_radians());
                film(pixel, Slip { scale, ..right(pixel) }).normalize()
            },
        },
        Mistake {
            name: "degrees taken for radians",
            diagnosis: "The angle comes in degrees, and the tangent takes radians: to_radians() \
                        converts. See 'From a pixel to a ray'.",
            answer: |pixel| {
                let scale = math::tan(pixel.vertical_fov / 2.0);
                film(pixel, Slip { scale, ..right(pixel) }).normalize()
            },
        },
        Mistake {
            name: "not of length 1",
            diagnosis: "Your vector points the right way, but its length isn't 1. Divide it by its \
                        length: see 'A ray'.",
            answer: |pixel| film(pixel, right(pixel)),
        },
    ]
}

/// A direction from three axes that need not be good ones.
fn along(seen: &Seen, right: Vec3, up: Vec3, forward: Vec3) -> Vec3 {
    let x = (2.0 * seen.position.x - seen.size.x) / seen.size.y * seen.scale;
    let y = (seen.size.y - 2.0 * seen.position.y) / seen.size.y * seen.scale;
    (x * right + y * up + forward).normalize()
}

pub(crate) fn of_look_at_direction() -> Vec<Mistake<Seen, Vec3>> {
    vec![
        Mistake {
            name: "the report's line",
            diagnosis: "You subtract the eye from (x, y, -1), as the report does. That point is \
                        already seen from the eye: it is a direction, and directions don't change \
                        when the eye moves. See 'A camera anywhere'.",
            answer: |seen| report_ray(seen.position, seen.size, seen.eye, seen.scale).direction,
        },
        Mistake {
            name: "the target is ignored",
            diagnosis: "Your camera always looks along -z. Turn (x, y, -1) into the frame that \
                        looks at the target: see 'A camera anywhere'.",
            answer: |seen| along(seen, Vec3::X, Vec3::Y, Vec3::NEG_Z),
        },
        Mistake {
            name: "left and right are swapped",
            diagnosis: "Your picture is mirrored: the cross product of up and forward points left. \
                        Take forward x up. See 'A camera anywhere'.",
            answer: |seen| {
                let forward = (seen.target - seen.eye).normalize();
                let left = Vec3::Y.cross(forward).normalize();
                along(seen, left, forward.cross(left), forward)
            },
        },
        Mistake {
            name: "turned by half a turn",
            diagnosis: "Your picture is upside down and mirrored: the order of a cross product \
                        counts. Right is forward x up, and the camera's up is right x forward. See \
                        'A camera anywhere'.",
            answer: |seen| {
                let forward = (seen.target - seen.eye).normalize();
                let left = Vec3::Y.cross(forward).normalize();
                along(seen, left, left.cross(forward), forward)
            },
        },
        Mistake {
            name: "up is not at right angles",
            diagnosis: "You took +y for the camera's up axis. When the camera looks up or down it \
                        isn't at right angles to the line of sight: take right x forward. See 'A \
                        camera anywhere'.",
            answer: |seen| {
                let forward = (seen.target - seen.eye).normalize();
                along(seen, forward.cross(Vec3::Y).normalize(), Vec3::Y, forward)
            },
        },
        Mistake {
            name: "the cross product isn't of length 1",
            diagnosis: "forward x up is as long as the sine of the angle between them. Scale it to \
                        length 1 before you use it as an axis: see 'A camera anywhere'.",
            answer: |seen| {
                let forward = (seen.target - seen.eye).normalize();
                let right = forward.cross(Vec3::Y);
                along(seen, right, right.cross(forward), forward)
            },
        },
        Mistake {
            name: "looking backwards",
            diagnosis: "Your camera looks from the target to the eye. Forward is target - eye: see \
                        'A camera anywhere'.",
            answer: |seen| {
                let forward = (seen.eye - seen.target).normalize();
                let right = forward.cross(Vec3::Y).normalize();
                along(seen, right, right.cross(forward), forward)
            },
        },
    ]
}
