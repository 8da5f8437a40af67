//! What the exercises ask, and the right answers in `f64`.

use common::film::{Color, Film};
use glam::{DVec3, Vec2, Vec3};
use ray_casting::ray::Ray;
use ray_casting::sphere::Sphere;

#[derive(Debug)]
pub(super) struct Pixel {
    pub(super) x: u32,
    pub(super) y: u32,
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) vertical_fov: f32,
    /// The tangent of half the angle, known in closed form.
    tangent: f64,
}

pub(super) fn pixels() -> Vec<Pixel> {
    let lenses = [(90.0, 1.0), (60.0, 1.0 / 3f64.sqrt()), (53.130_104, 0.5), (120.0, 3f64.sqrt())];
    let pixel = |(x, y, width, height), (vertical_fov, tangent)| Pixel {
        x,
        y,
        width,
        height,
        vertical_fov,
        tangent,
    };
    let places = [(0, 0, 4, 2), (3, 1, 4, 2), (1, 6, 5, 7), (630, 17, 640, 480), (0, 0, 1, 1)];
    places.into_iter().flat_map(|place| lenses.map(|lens| pixel(place, lens))).collect()
}

impl Pixel {
    pub(super) fn direction(&self) -> Vec3 {
        let (width, height) = (f64::from(self.width), f64::from(self.height));
        let x = (2.0 * f64::from(self.x) + 1.0 - width) / height * self.tangent;
        let y = (height - 2.0 * f64::from(self.y) - 1.0) / height * self.tangent;
        DVec3::new(x, y, -1.0).normalize().as_vec3()
    }
}

#[derive(Debug)]
pub(super) struct Aim {
    pub(super) sphere: Sphere,
    pub(super) ray: Ray,
}

pub(super) fn spheres() -> Vec<Aim> {
    let sphere = Sphere { center: Vec3::new(1.0, 2.0, -7.0), radius: 2.0 };
    let aim = |origin: [f32; 3], direction: [f32; 3]| Aim {
        sphere,
        ray: Ray { origin: origin.into(), direction: direction.into() },
    };
    vec![
        aim([1.0, 2.0, 1.0], [0.0, 0.0, -1.0]),
        aim([1.0, 3.0, 1.0], [0.0, 0.0, -1.0]),
        aim([1.0, 5.0, 1.0], [0.0, 0.0, -1.0]),
        aim([0.0, 0.0, 0.0], [0.5, 1.5, -3.5]),
        aim([1.5, 2.5, -6.5], [0.6, 0.0, 0.8]),
        aim([1.0, 2.0, -20.0], [0.0, 0.0, -1.0]),
        aim([1.0, 2.0, 1.0], [0.0, 0.0, 1.0]),
        aim([-4.0, 3.0, -6.0], [3.0, -0.25, -0.5]),
        aim([1.0, 2.0, -7.0], [0.0, 0.25, 0.0]),
    ]
}

impl Aim {
    pub(super) fn distance(&self) -> Option<f32> {
        distance(&self.sphere, &self.ray).map(|t| t as f32)
    }
}

/// The textbook's formula with enough digits that it can do no harm here.
fn distance(sphere: &Sphere, ray: &Ray) -> Option<f64> {
    let (d, radius) = (ray.direction.as_dvec3(), f64::from(sphere.radius));
    let f = ray.origin.as_dvec3() - sphere.center.as_dvec3();
    let (a, h) = (d.dot(d), f.dot(d));
    let root = (h * h - a * (f.dot(f) - radius * radius)).sqrt();
    [(-h - root) / a, (-h + root) / a].into_iter().find(|&t| t > 0.0)
}

/// Spheres one behind the other.
#[derive(Debug)]
pub(super) struct Heap(Vec<Sphere>);

pub(super) fn heaps() -> Vec<Heap> {
    let sphere =
        |x: f32, y: f32, z: f32, radius: f32| Sphere { center: Vec3::new(x, y, z), radius };
    let (large, small) = (sphere(-1.0, 0.0, -12.0, 4.0), sphere(1.5, -0.5, -7.0, 1.2));
    let (near, behind) = (sphere(0.5, 1.0, -4.0, 0.6), sphere(0.0, 0.0, 9.0, 5.0));
    vec![
        Heap(vec![large, small, near]),
        Heap(vec![near, small, large]),
        Heap(vec![behind, large, near]),
        // A large sphere whose surface is nearer than the small one's, and its centre farther.
        Heap(vec![sphere(2.0, 0.0, -8.0, 0.8), sphere(-1.0, 0.0, -10.0, 5.5)]),
    ]
}

impl Heap {
    /// Each sphere in a colour of its own, before black.
    pub(super) fn picture(&self, first: fn(&[Sphere], &Ray) -> Option<usize>) -> Film {
        let colors = [Color::X, Color::Y, Color::Z];
        Film::from_fn(120, 90, |x, y| {
            let film = Vec3::new(x as f32 - 59.5, 44.5 - y as f32, -60.0);
            let ray = Ray { origin: Vec3::ZERO, direction: film.normalize() };
            first(&self.0, &ray).map_or(Color::ZERO, |index| colors[index])
        })
    }
}

pub(super) fn first_seen(spheres: &[Sphere], ray: &Ray) -> Option<usize> {
    let hits = spheres.iter().map(|sphere| distance(sphere, ray)).enumerate();
    let hits = hits.filter_map(|(index, t)| Some((index, t?)));
    hits.min_by(|first, second| first.1.total_cmp(&second.1)).map(|(index, _)| index)
}

#[derive(Debug)]
pub(super) struct Disk {
    pub(super) center: Vec3,
    pub(super) normal: Vec3,
    pub(super) radius: f32,
    pub(super) ray: Ray,
}

pub(super) fn disks() -> Vec<Disk> {
    let center = Vec3::new(1.0, -2.0, -5.0);
    let disk = |normal: [f32; 3], radius: f32, origin: [f32; 3], direction: [f32; 3]| Disk {
        center,
        normal: normal.into(),
        radius,
        ray: Ray { origin: origin.into(), direction: direction.into() },
    };
    vec![
        disk([0.0, 1.0, 0.0], 2.0, [1.5, 3.0, -5.0], [0.0, -1.0, 0.0]),
        disk([0.0, 1.0, 0.0], 2.0, [2.8, 3.0, -5.0], [0.0, -1.0, 0.0]),
        disk([0.0, 1.0, 0.0], 0.5, [1.6, 3.0, -5.0], [0.0, -1.0, 0.0]),
        disk([0.0, 1.0, 0.0], 2.0, [3.5, 3.0, -5.0], [0.0, -1.0, 0.0]),
        disk([0.0, 1.0, 0.0], 2.0, [1.0, -6.0, -5.0], [0.0, 0.5, 0.0]),
        disk([0.0, 1.0, 0.0], 2.0, [1.0, 3.0, -5.0], [0.0, 1.0, 0.0]),
        disk([0.0, 1.0, 0.0], 2.0, [-4.0, -2.0, -5.0], [1.0, 0.0, 0.0]),
        disk([0.0, 2e-5, 0.0], 2.0, [1.5, 3.0, -5.0], [0.0, -1e-5, 0.0]),
        disk([1.0, 2.0, 2.0], 3.0, [0.0, 0.0, 0.0], [0.4, -0.6, -1.7]),
    ]
}

impl Disk {
    pub(super) fn distance(&self) -> Option<f32> {
        let (center, normal) = (self.center.as_dvec3(), self.normal.as_dvec3());
        let (origin, direction) = (self.ray.origin.as_dvec3(), self.ray.direction.as_dvec3());
        let t = (center - origin).dot(normal) / direction.dot(normal);
        let inside = (origin + t * direction - center).length() <= f64::from(self.radius);
        (t > 0.0 && inside).then_some(t as f32)
    }
}

#[derive(Debug)]
pub(super) struct Quadratic {
    pub(super) a: f32,
    pub(super) h: f32,
    pub(super) c: f32,
}

pub(super) fn quadratics() -> Vec<Quadratic> {
    [
        (1.0, -2.5, 6.0),
        (2.0, 3.5, 6.0),
        (1.0, 0.0, -9.0),
        (1.0, 1.0, 5.0),
        (1.0, -3.0, 9.0),
        (1.0, -5000.0, 3.0),
        (0.5, 5000.0, 3.0),
        (1.0, -5000.0, -3.0),
        (3.0, 5000.0, -3.0),
    ]
    .map(|(a, h, c)| Quadratic { a, h, c })
    .into()
}

impl Quadratic {
    pub(super) fn roots(&self) -> Option<[f32; 2]> {
        let (a, h, c) = (f64::from(self.a), f64::from(self.h), f64::from(self.c));
        let root = (h * h - a * c).sqrt();
        let roots = [((-h - root) / a) as f32, ((-h + root) / a) as f32];
        (!root.is_nan()).then_some(roots)
    }
}

#[derive(Debug)]
pub(super) struct Seen {
    pub(super) position: Vec2,
    pub(super) size: Vec2,
    pub(super) scale: f32,
    pub(super) eye: Vec3,
    pub(super) target: Vec3,
}

pub(super) fn views() -> Vec<Seen> {
    let eyes = [
        // The report's own two: at the origin, and the bunny's.
        (Vec3::ZERO, Vec3::NEG_Z),
        (Vec3::new(-1.0, 5.0, 10.0), Vec3::new(-1.0, 5.0, 9.0)),
        (Vec3::new(3.0, 4.0, 2.0), Vec3::new(0.0, 1.0, -5.0)),
        (Vec3::new(-2.0, 0.5, -3.0), Vec3::new(4.0, 6.0, 1.0)),
    ];
    let positions = [Vec2::new(320.0, 240.0), Vec2::new(0.5, 0.5), Vec2::new(500.5, 400.5)];
    let size = Vec2::new(640.0, 480.0);
    let seen =
        |(eye, target)| positions.map(|position| Seen { position, size, scale: 0.7, eye, target });
    eyes.into_iter().flat_map(seen).collect()
}

impl Seen {
    pub(super) fn direction(&self) -> Vec3 {
        let (position, size) = (self.position.as_dvec2(), self.size.as_dvec2());
        let forward = (self.target.as_dvec3() - self.eye.as_dvec3()).normalize();
        let right = forward.cross(DVec3::Y).normalize();
        let up = right.cross(forward);
        let offset = (2.0 * position - size) / size.y * f64::from(self.scale);
        (forward + offset.x * right - offset.y * up).normalize().as_vec3()
    }
}
