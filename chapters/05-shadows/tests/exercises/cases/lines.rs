//! Points and lamps among spheres: exercises 5.1 and 5.2.

use blinn_phong::light::Light;
use common::film::Color;
use glam::{DVec3, Vec3};
use ray_casting::sphere::Sphere;

#[derive(Debug)]
pub(crate) struct Line {
    pub(crate) spheres: Vec<Sphere>,
    pub(crate) point: Vec3,
    pub(crate) lamp: Vec3,
}

fn sphere(x: f32, y: f32, z: f32, radius: f32) -> Sphere {
    Sphere { center: Vec3::new(x, y, z), radius }
}

pub(crate) fn lines() -> Vec<Line> {
    let (between, beside) = (sphere(0.2, 3.0, 0.0, 1.0), sphere(4.0, 3.0, 0.0, 1.5));
    let (above, below) = (sphere(0.0, 9.0, 0.0, 1.0), sphere(0.0, -4.0, 0.3, 1.0));
    let line = |spheres: &[Sphere], lamp: [f32; 3]| Line {
        spheres: spheres.to_vec(),
        point: Vec3::ZERO,
        lamp: lamp.into(),
    };
    vec![
        line(&[], [0.0, 6.0, 0.0]),
        line(&[between], [0.0, 6.0, 0.0]),
        line(&[beside], [0.0, 6.0, 0.0]),
        line(&[above], [0.0, 6.0, 0.0]),
        line(&[below], [0.0, 6.0, 0.0]),
        line(&[beside, between], [0.0, 6.0, 0.0]),
        line(&[above, beside, below], [0.0, 6.0, 0.0]),
        line(&[between, above], [0.0, 1.5, 0.0]),
        line(&[sphere(0.1, 0.2, 0.0, 0.1)], [0.1, 0.3, 0.0]),
        // The lamp is inside: from there nothing gets out.
        line(&[beside, sphere(0.0, 6.0, 0.5, 2.0)], [0.0, 6.0, 0.0]),
    ]
}

impl Line {
    pub(crate) fn is_clear(&self) -> bool {
        is_clear(&self.spheres, self.point.as_dvec3(), self.lamp.as_dvec3())
    }
}

/// By the point of the segment that is nearest to each centre, and whether either end is inside.
fn is_clear(spheres: &[Sphere], point: DVec3, lamp: DVec3) -> bool {
    let way = lamp - point;
    spheres.iter().all(|sphere| {
        let center = sphere.center.as_dvec3();
        let nearest = ((center - point).dot(way) / way.dot(way)).clamp(0.0, 1.0);
        (point + nearest * way - center).length() >= f64::from(sphere.radius)
    })
}

#[derive(Debug)]
pub(crate) struct Place {
    pub(crate) spheres: Vec<Sphere>,
    pub(crate) ambient: Color,
    pub(crate) point: Vec3,
    pub(crate) normal: Vec3,
    lamps: Vec<(Vec3, Color)>,
}

pub(crate) fn places() -> Vec<Place> {
    let red = (Vec3::new(0.0, 6.0, 0.0), Color::new(0.9, 0.1, 0.0));
    let blue = (Vec3::new(4.0, 3.0, 0.0), Color::new(0.0, 0.2, 0.8));
    let low = (Vec3::new(2.0, -1.0, 0.5), Color::new(0.3, 0.4, 0.3));
    let (over, aside) = (sphere(0.2, 3.0, 0.0, 1.0), sphere(2.0, 1.5, 0.1, 0.5));
    let place = |spheres: &[Sphere], lamps: &[(Vec3, Color)], normal: [f32; 3]| Place {
        spheres: spheres.to_vec(),
        ambient: Color::new(0.05, 0.06, 0.07),
        point: Vec3::ZERO,
        normal: normal.into(),
        lamps: lamps.to_vec(),
    };
    let up = [0.0, 1.0, 0.0];
    vec![
        place(&[], &[], up),
        place(&[], &[red], up),
        place(&[over], &[red], up),
        place(&[], &[red, blue], up),
        place(&[over], &[red, blue], up),
        place(&[aside], &[red, blue], up),
        place(&[over, aside], &[red, blue], up),
        place(&[], &[red, low], up),
        place(&[over], &[low, blue, red], [0.6, 0.8, 0.0]),
    ]
}

impl Place {
    pub(crate) fn lamps(&self) -> Vec<Light> {
        self.lamps.iter().map(|&(position, color)| Light::steady(position, color)).collect()
    }

    pub(crate) fn light(&self) -> Color {
        let (point, normal) = (self.point.as_dvec3(), self.normal.as_dvec3());
        let lamp = |(position, color): &(Vec3, Color)| {
            let position = position.as_dvec3();
            let cosine = (position - point).normalize().dot(normal);
            let seen = cosine > 0.0 && is_clear(&self.spheres, point, position);
            if seen { color.as_dvec3() * cosine } else { DVec3::ZERO }
        };
        let lamps: DVec3 = self.lamps.iter().map(lamp).sum();
        (self.ambient.as_dvec3() + lamps).as_vec3()
    }
}
