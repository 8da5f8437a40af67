//! How much is reflected at each angle, as curves.

use common::film::Color;
use common::math;
use common::render::{Rendering, Settings, render_counted};
use common::tally::Tally;
use glam::Vec2;

use crate::dielectric;
use crate::index::Index;
use crate::interface::Interface;
use crate::schlick;

/// A chart for glass in air: to the right the angle from 0 to 90 degrees, up the reflected part from
/// 0 to 1.
#[derive(Clone, Copy, Debug)]
pub struct Curves {
    /// The glass's index.
    pub index: Index,
}

/// The reflected part for the cosine of an angle.
type Part = fn(&Interface, f64) -> f64;

/// Half a curve's width, in parts of the picture's height.
const HALF_WIDTH: f32 = 0.004;

impl Curves {
    /// Fresnel's equations in blue and Schlick's approximation in orange: into glass, and out of it.
    fn curves(&self) -> [(Color, Interface, Part); 4] {
        let into = Interface::new(Index::AIR, self.index);
        let out = into.reversed();
        let (blue, orange) = (Color::new(0.01, 0.06, 0.45), Color::new(0.85, 0.22, 0.0));
        [
            (orange, into, schlick::reflectance),
            (orange, out, schlick::reflectance),
            (blue, into, dielectric::reflectance),
            (blue, out, dielectric::reflectance),
        ]
    }

    /// The chart. No ray is followed for it.
    pub fn draw<T: Tally>(&self, settings: &Settings) -> Rendering<T> {
        let size = Vec2::new(settings.width as f32, settings.height as f32);
        let curves = self.curves();
        render_counted(settings, |pixel, sampler, _tally| {
            let place = pixel.position(sampler) / size;
            let place = Vec2::new(place.x, 1.0 - place.y);
            let aspect = size.x / size.y;
            let paper = grid(place);
            curves.iter().fold(paper, |under, (color, interface, part)| {
                let distance = distance(place, aspect, |angle| {
                    part(interface, f64::from(math::cos(angle))) as f32
                });
                let ink = (1.5 - distance / HALF_WIDTH).clamp(0.0, 1.0);
                under.lerp(*color, ink)
            })
        })
    }
}

/// White paper with a line each ten degrees and each tenth.
fn grid(place: Vec2) -> Color {
    let apart = (place * Vec2::new(9.0, 10.0) + 0.5).fract() - 0.5;
    let on_line = apart.abs().min_element() < 0.02;
    Color::splat(if on_line { 0.8 } else { 1.0 })
}

/// How far a place is from a curve, in heights of the picture, as far as that is near.
fn distance(place: Vec2, aspect: f32, curve: impl Fn(f32) -> f32) -> f32 {
    let point = |number: i32| {
        let beside = number as f32 * HALF_WIDTH / 2.0;
        let x = (place.x + beside / aspect).clamp(0.0, 1.0);
        let angle = x * std::f32::consts::FRAC_PI_2;
        Vec2::new(beside, curve(angle) - place.y)
    };
    // Between points the curve is a line: at the critical angle it is nearly upright.
    let pieces = (-4..4).map(|number| to_line(point(number), point(number + 1)));
    pieces.fold(f32::INFINITY, f32::min)
}

/// How far the origin is from the line between two points.
fn to_line(one: Vec2, other: Vec2) -> f32 {
    let along = other - one;
    let part = -one.dot(along) / along.length_squared().max(f32::MIN_POSITIVE);
    (one + part.clamp(0.0, 1.0) * along).length()
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::render::Settings;
    use common::tally::Off;

    use super::Curves;
    use crate::index::Index;

    #[test]
    fn fresnel_s_curve_is_where_it_is_by_hand() {
        let settings = Settings { width: 300, height: 200, ..Settings::default() };
        let film = Curves { index: Index::GLASS }.draw::<Off>(&settings).film;
        // Straight on 0.04 is reflected, along the surface everything, and beyond 41.8 degrees all
        // of what comes from within.
        let blue = |x: u32, y: u32| film.pixel(x, y).z > 2.0 * film.pixel(x, y).x;
        assert!(blue(1, 191) && blue(298, 0) && blue(200, 0) && blue(139, 60));
        assert!(!blue(1, 150) && !blue(100, 0));
        assert!(film.pixels.contains(&Color::ONE), "there is paper");
    }
}
