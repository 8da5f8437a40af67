//! What the exercises ask, and the right answers in `f64`.

use blinn_phong::exercises::Plain;
use blinn_phong::light::Light;
use common::film::Color;
use common::sampler::Stream;
use glam::{DVec3, Vec2, Vec3};

fn direction(stream: &mut Stream) -> Vec3 {
    let mut component = || stream.between(-1.0, 1.0);
    let vector = Vec3::new(component(), component(), component());
    if vector.length() > 0.1 { vector.normalize() } else { direction(stream) }
}

/// A direction on the normal's side, at least three degrees above the surface.
fn above(stream: &mut Stream, normal: Vec3) -> Vec3 {
    let direction = direction(stream);
    let cosine = direction.dot(normal);
    if cosine.abs() < 0.05 {
        return above(stream, normal);
    }
    direction * cosine.signum()
}

fn color(stream: &mut Stream) -> Color {
    let mut channel = || stream.between(0.1, 1.0);
    Color::new(channel(), channel(), channel())
}

#[derive(Debug)]
pub(super) struct Matte {
    pub(super) diffuse: Color,
    pub(super) normal: Vec3,
    pub(super) toward_light: Vec3,
    pub(super) color: Color,
}

pub(super) fn matte() -> Vec<Matte> {
    let by_hand = Matte {
        diffuse: Color::new(0.5, 0.25, 1.0),
        normal: Vec3::Y,
        toward_light: Vec3::new(0.6, 0.8, 0.0),
        color: Color::new(2.0, 2.0, 1.0),
    };
    let random = (0..60).map(|trial| {
        let mut stream = Stream::of_trial(421, trial);
        Matte {
            diffuse: color(&mut stream),
            normal: direction(&mut stream),
            toward_light: direction(&mut stream),
            color: 3.0 * color(&mut stream),
        }
    });
    // Near the edge of the light f32 and f64 may differ in the sign of the cosine.
    let clear = |case: &Matte| case.normal.dot(case.toward_light).abs() > 0.01;
    std::iter::once(by_hand).chain(random.filter(clear)).collect()
}

impl Matte {
    pub(super) fn returned(&self) -> Color {
        let cosine = self.normal.as_dvec3().dot(self.toward_light.as_dvec3()).max(0.0);
        (cosine * self.color.as_dvec3() * self.diffuse.as_dvec3()).as_vec3()
    }
}

#[derive(Debug)]
pub(super) struct Shiny {
    pub(super) normal: Vec3,
    pub(super) toward_eye: Vec3,
    pub(super) toward_light: Vec3,
    pub(super) shininess: u32,
}

pub(super) fn shiny() -> Vec<Shiny> {
    let random = (0..120).map(|trial| {
        let mut stream = Stream::of_trial(422, trial);
        let normal = direction(&mut stream);
        let (toward_eye, toward_light) = (above(&mut stream, normal), above(&mut stream, normal));
        Shiny { normal, toward_eye, toward_light, shininess: [1, 3, 8, 25][trial as usize % 4] }
    });
    // The lamp straight above, and the eye to the side by 3 : 4 : 5.
    let toward_eye = Vec3::new(0.6, 0.8, 0.0);
    let by_hand = Shiny { normal: Vec3::Y, toward_eye, toward_light: Vec3::Y, shininess: 2 };
    std::iter::once(by_hand).chain(random).collect()
}

fn lobe(cosine: f64, shininess: u32) -> f64 {
    (0..shininess).fold(1.0, |power, _| power * cosine.clamp(0.0, 1.0))
}

impl Shiny {
    pub(super) fn highlights(&self) -> [f32; 2] {
        let [normal, eye, light] =
            [self.normal, self.toward_eye, self.toward_light].map(|it| it.as_dvec3());
        let mirrored = 2.0 * normal.dot(light) * normal - light;
        let half = (eye + light).normalize();
        [mirrored.dot(eye), normal.dot(half)].map(|cosine| lobe(cosine, self.shininess) as f32)
    }
}

#[derive(Debug)]
pub(super) struct Lamp {
    pub(super) position: Vec3,
    pub(super) color: Color,
    pub(super) point: Vec3,
}

pub(super) fn lamps() -> Vec<Lamp> {
    let color = Color::new(50.0, 5.0, 20.0);
    let away = Vec3::new(2.0, -3.0, 6.0);
    let lamp = |point: Vec3, away: Vec3| Lamp { position: point + away, color, point };
    let mut lamps = vec![
        lamp(Vec3::ONE, away),
        lamp(Vec3::new(-1.0, 4.0, 2.0), 0.25 * away),
        lamp(Vec3::new(5.0, 6.0, 7.0), Vec3::ZERO),
    ];
    // Near lamps around the origin, where their places have all their digits.
    let scales = [1e-30, 1e-22, 1e-15, 1e-7, 0.01, 30.0, 1e6, 1e15];
    lamps.extend(scales.map(|scale| lamp(Vec3::ZERO, scale * away)));
    lamps
}

impl Lamp {
    pub(super) fn arriving(&self) -> Option<(Vec3, Color)> {
        let away = self.position.as_dvec3() - self.point.as_dvec3();
        let distance = away.length();
        let color = self.color.as_dvec3() / (1.0 + distance * distance);
        (distance > 0.0).then(|| ((away / distance).as_vec3(), color.as_vec3()))
    }
}

/// A place on a surface, in 1024ths.
#[derive(Debug)]
pub(super) struct Place {
    pub(super) count: u32,
    u: u32,
    v: u32,
}

pub(super) const COLORS: [Color; 2] = [Color::new(0.8, 0.1, 0.2), Color::new(0.3, 0.9, 0.7)];

pub(super) fn places() -> Vec<Place> {
    let places = [(0, 0), (300, 0), (512, 100), (700, 1000), (1023, 30), (1024, 512), (341, 900)];
    let with = |count| places.map(|(u, v)| Place { count, u, v });
    [2, 5, 1, 6].into_iter().flat_map(with).collect()
}

impl Place {
    pub(super) fn uv(&self) -> Vec2 {
        Vec2::new(self.u as f32, self.v as f32) / 1024.0
    }

    pub(super) fn color(&self) -> Color {
        let stripe = (self.u * self.count / 1024).min(self.count - 1);
        COLORS[stripe as usize % 2]
    }
}

/// A material whose exponent is a whole number and a half, so that the right answer needs no power
/// function.
#[derive(Clone, Copy, Debug)]
pub(super) struct Material {
    pub(super) ambient: Color,
    pub(super) diffuse: Color,
    pub(super) specular: Color,
    pub(super) whole: u32,
}

impl Material {
    pub(super) fn plain(&self) -> Plain {
        let Self { ambient, diffuse, specular, whole } = *self;
        Plain { ambient, diffuse, specular, shininess: whole as f32 + 0.5 }
    }
}

#[derive(Debug)]
pub(super) struct Lit {
    pub(super) material: Material,
    pub(super) lights: Vec<Light>,
    pub(super) point: Vec3,
    pub(super) normal: Vec3,
    pub(super) eye: Vec3,
}

pub(super) fn points() -> Vec<Lit> {
    (0..60).filter_map(point).collect()
}

fn point(trial: u64) -> Option<Lit> {
    let mut stream = Stream::of_trial(425, trial);
    let (point, normal) = (3.0 * direction(&mut stream), direction(&mut stream));
    let material = Material {
        ambient: 0.1 * color(&mut stream),
        diffuse: color(&mut stream),
        specular: color(&mut stream),
        whole: [1, 4, 12][trial as usize % 3],
    };
    let eye = point + 4.0 * above(&mut stream, normal);
    let count = 1 + trial / 20;
    let lights: Vec<Light> = (0..count)
        .map(|_| {
            let position = point + stream.between(1.0, 5.0) * direction(&mut stream);
            Light::Point { position, color: color(&mut stream), falloff: [0.5, 0.0, 0.25] }
        })
        .collect();
    // None at the edge of the light, where the last digit decides.
    let clear = lights.iter().filter_map(|light| light.at(point));
    let clear = clear.into_iter().all(|it| it.toward.dot(normal).abs() > 0.02);
    clear.then_some(Lit { material, lights, point, normal, eye })
}

impl Lit {
    pub(super) fn radiance(&self) -> Color {
        let (point, normal) = (self.point.as_dvec3(), self.normal.as_dvec3());
        let eye = (self.eye.as_dvec3() - point).normalize();
        let mut sum = self.material.ambient.as_dvec3();
        for light in &self.lights {
            sum += self.of_lamp(light, point, normal, eye);
        }
        sum.as_vec3()
    }

    fn of_lamp(&self, light: &Light, point: DVec3, normal: DVec3, eye: DVec3) -> DVec3 {
        let &Light::Point { position, color, falloff: [constant, _, quadratic] } = light else {
            return DVec3::ZERO;
        };
        let away = position.as_dvec3() - point;
        let toward = away.normalize();
        let falloff = f64::from(constant) + f64::from(quadratic) * away.length_squared();
        let cosine = normal.dot(toward);
        if cosine <= 0.0 {
            return DVec3::ZERO;
        }
        let half = normal.dot((eye + toward).normalize()).clamp(0.0, 1.0);
        let strength = lobe(half, self.material.whole) * half.sqrt();
        let (diffuse, specular) = (self.material.diffuse, self.material.specular);
        color.as_dvec3() / falloff * (cosine * diffuse.as_dvec3() + strength * specular.as_dvec3())
    }
}
