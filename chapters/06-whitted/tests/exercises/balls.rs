//! Exercise 6.3: pictures of balls that mirror one another, and the same in `f64`.

use common::film::{Color, Film};
use common::render::{Settings, render};
use glam::{DVec3, Vec3};
use ray_casting::camera::{Camera, View};
use ray_casting::ray::Ray;
use ray_casting::sphere::Sphere;
use whitted::exercises::Ball;

const WIDTH: u32 = 96;
const HEIGHT: u32 = 72;
const BACKGROUND: Color = Color::new(0.25, 0.4, 0.6);

/// Balls, and how deep to follow.
#[derive(Debug)]
pub(crate) struct Heap {
    balls: Vec<Ball>,
    depth: u32,
}

/// What the reader writes.
pub(crate) type Among = fn(&[Ball], Color, &Ray, u32) -> Color;

pub(crate) fn heaps() -> Vec<Heap> {
    let ball = |x, y, z, radius, light: [f32; 3], mirror: [f32; 3]| Ball {
        sphere: Sphere { center: Vec3::new(x, y, z), radius },
        light: light.into(),
        mirror: mirror.into(),
    };
    let alone = vec![ball(0.2, 0.1, -4.0, 1.2, [0.05, 0.02, 0.0], [0.9, 0.7, 0.5])];
    let heap = vec![
        ball(-1.1, 0.0, -4.5, 1.0, [0.02, 0.03, 0.05], [0.8, 0.85, 0.9]),
        ball(1.0, 0.2, -4.0, 0.9, [0.3, 0.05, 0.05], [0.5, 0.4, 0.4]),
        ball(0.1, -1.2, -3.6, 0.6, [0.05, 0.25, 0.1], [0.6, 0.8, 0.7]),
        ball(0.3, 1.5, -5.0, 0.8, [0.6, 0.5, 0.1], [0.0, 0.0, 0.0]),
    ];
    [(alone, 1), (heap.clone(), 0), (heap.clone(), 1), (heap, 4)]
        .map(|(balls, depth)| Heap { balls, depth })
        .into()
}

impl Heap {
    pub(crate) fn picture(&self, among: Among) -> Film {
        self.draw(|ray| among(&self.balls, BACKGROUND, ray, self.depth))
    }

    pub(crate) fn expected(&self) -> Film {
        self.draw(|ray| {
            let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
            exactly(&self.balls, origin, direction.normalize(), self.depth, None).as_vec3()
        })
    }

    fn draw(&self, radiance: impl Fn(&Ray) -> Color + Sync) -> Film {
        let view = View { eye: Vec3::ZERO, target: Vec3::NEG_Z, up: Vec3::Y, vertical_fov: 60.0 };
        let camera = Camera::new(&view, WIDTH, HEIGHT).expect("an ordinary view");
        let settings = Settings { width: WIDTH, height: HEIGHT, ..Settings::default() };
        render(&settings, |pixel, sampler| radiance(&camera.ray(pixel.position(sampler)))).film
    }
}

/// The radiance in `f64`; a ball can't see itself, so the one that was left is not asked.
fn exactly(
    balls: &[Ball],
    origin: DVec3,
    direction: DVec3,
    depth: u32,
    left: Option<usize>,
) -> DVec3 {
    let distance = |ball: &Ball| {
        let (center, radius) = (ball.sphere.center.as_dvec3(), f64::from(ball.sphere.radius));
        let along = (center - origin).dot(direction);
        let aside = (center - origin).length_squared() - along * along;
        let t = along - (radius * radius - aside).sqrt();
        (t > 0.0).then_some(t)
    };
    let others = balls.iter().enumerate().filter(|(index, _)| Some(*index) != left);
    let hits = others.filter_map(|(index, ball)| Some((index, distance(ball)?)));
    let Some((index, t)) = hits.min_by(|one, other| one.1.total_cmp(&other.1)) else {
        return BACKGROUND.as_dvec3();
    };
    let ball = &balls[index];
    let point = origin + t * direction;
    let normal = (point - ball.sphere.center.as_dvec3()).normalize();
    let mirrored = direction - 2.0 * direction.dot(normal) * normal;
    let rest = match depth {
        0 => DVec3::ZERO,
        depth => exactly(balls, point, mirrored, depth - 1, Some(index)),
    };
    ball.light.as_dvec3() + ball.mirror.as_dvec3() * rest
}

/// Whether all pixels but one in a hundred are alike: at a rim, `f32` may see the other ball.
pub(crate) fn alike(expected: &Film, yours: &Film) -> bool {
    let pairs = expected.pixels.iter().zip(&yours.pixels);
    let differ = |(one, other): &(&Color, &Color)| {
        let both_nan = one.is_nan() && other.is_nan();
        let near = (**one - **other).abs().to_array().iter().all(|part| *part <= 2e-3);
        !(near || both_nan)
    };
    pairs.filter(differ).count() * 100 < expected.pixels.len()
}
