//! Image order: for each pixel, the triangles its ray meets. The ray caster of chapters 1 and 2.

use common::render::{Rendering, Settings, render_counted};
use common::tally::Tally;
use glam::{Vec2, Vec3};
use ray_casting::camera::{CAMERA_RAYS, Camera};
use triangles::brute::{TRIANGLE_TESTS, nearest};
use triangles::watertight::ShearedRay;

use crate::fragment::{Fragment, Shade};
use crate::samples::{offset, position};

// ANCHOR: fragment
/// What the ray through a point of the film sees first. `corners` are those of all triangles.
pub fn fragment<T: Tally>(
    corners: &[[Vec3; 3]],
    camera: &Camera,
    position: Vec2,
    tally: &mut T,
) -> Option<Fragment> {
    tally.count(CAMERA_RAYS, 1);
    tally.count(TRIANGLE_TESTS, corners.len() as u64);
    let ray = camera.ray(position);
    let found = nearest::<ShearedRay>(corners, &ray, f32::INFINITY)?;
    // A ray measures distance along itself; depth is along the line of sight.
    let cosine = ray.direction.as_dvec3().dot(camera.frame().forward.as_dvec3());
    let depth = (f64::from(found.hit.t) * cosine) as f32;
    Some(Fragment { triangle: found.index as u32, depth, barycentric: found.hit.barycentric })
}
// ANCHOR_END: fragment

/// What each pixel's centre sees, row by row.
pub fn fragments<T: Tally>(
    corners: &[[Vec3; 3]],
    camera: &Camera,
    tally: &mut T,
) -> Vec<Option<Fragment>> {
    let size = camera.size();
    let (width, height) = (size.x as u32, size.y as u32);
    let centres = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    centres
        .map(|(x, y)| {
            let centre = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
            fragment(corners, camera, centre, tally)
        })
        .collect()
}

// ANCHOR: render
/// The picture whose samples `shade` colours, pixel by pixel.
pub fn render<T: Tally>(
    corners: &[[Vec3; 3]],
    camera: &Camera,
    settings: &Settings,
    shade: &Shade<T>,
) -> Rendering<T> {
    render_counted(settings, |pixel, sampler, tally: &mut T| {
        let offset = offset(sampler);
        let fragment = fragment(corners, camera, position(pixel, offset), tally);
        shade(pixel, offset, fragment, tally)
    })
}
// ANCHOR_END: render
