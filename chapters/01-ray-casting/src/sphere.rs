//! The sphere, by a formula that stays right for small ones far away and for huge ones underfoot.

use glam::Vec3;

use crate::crossing::Crossing;
use crate::direction::unit;
use crate::longitude::uv;
use crate::ray::Ray;
use crate::rounding::gamma;
use crate::shape::{Hit, Shape};

/// A sphere. One whose radius is not above 0 is hit by no ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its centre.
    pub center: Vec3,
    /// Its radius, above 0.
    pub radius: f32,
}

impl Sphere {
    // ANCHOR: crossing
    /// Where the ray's line enters and leaves the sphere; None when it misses it.
    ///
    /// The discriminant from the distance between centre and line: Hearn and Baker, "Computer
    /// Graphics with OpenGL" (2004), in the form of Haines, Günther and Akenine-Möller,
    /// "Precision improvements for ray/sphere intersection" (Ray Tracing Gems, chapter 7, 2019).
    pub fn crossing(&self, ray: &Ray) -> Option<Crossing> {
        let (d, r) = (ray.direction, self.radius);
        let f = ray.origin - self.center;
        let a = d.dot(d);
        let b = -f.dot(d);

        // l leads from the centre to the nearest point of the line.
        let l = f + (b / a) * d;
        let distance = l.length();
        let k = self.power(f);
        let square = match k < 0.0 {
            // From inside every line crosses. Here nothing cancels, and nothing can miss.
            true => b * b - a * k,
            false => a * ((r - distance) * (r + distance)),
        };

        // NaN is not above 0 either, so that this turns away all that can't be hit.
        if !(square >= 0.0 && r > 0.0) {
            return None;
        }

        // b and the root have one sign, so that nothing cancels in q.
        let q = b + square.sqrt().copysign(b);
        Crossing::sorted(k / q, q / a)
    }
    // ANCHOR_END: crossing

    // ANCHOR: power
    /// |f|² - r² for a point at `f` from the centre.
    ///
    /// The difference is taken before anything is squared, along the axis that f lies nearest to.
    /// A camera just above a huge sphere is where that matters: one component of f is nearly r.
    fn power(&self, f: Vec3) -> f32 {
        let f = f.abs();
        let (longest, shortest) = (f.max_element(), f.min_element());
        let middle = f.x.min(f.y).max(f.x.max(f.y).min(f.z));
        let rest = middle * middle + shortest * shortest;
        (longest - self.radius) * (longest + self.radius) + rest
    }
    // ANCHOR_END: power

    // ANCHOR: point
    /// The point at distance `t` of the ray, where the surface's normal is `normal`.
    ///
    /// Along the ray it is wrong by about the rounding of `origin` and `t`, and from the centre by
    /// that of `center` and `radius`. The smaller numbers round less.
    fn point(&self, ray: &Ray, t: f32, normal: Vec3) -> Vec3 {
        let along = largest(ray.origin) + t * largest(ray.direction);
        let around = largest(self.center) + self.radius;
        if along < around { ray.at(t) } else { self.center + self.radius * normal }
    }
    // ANCHOR_END: point

    // ANCHOR: error
    /// How far from the surface `point` may be, where the normal is `normal`.
    ///
    /// Its height is measured: (|f| - r)(|f| + r) over a number below the second factor. To measure
    /// it rounds f once and the squares less than twice as far, three roundings of the radius in
    /// all, and whoever asks the sphere again from beside `point` rounds as much once more.
    fn error(&self, point: Vec3, normal: Vec3) -> Vec3 {
        let f = point - self.center;
        let height = self.power(f).abs() / (largest(f) + self.radius);
        (height + gamma(7) * self.radius) * normal.abs()
    }
    // ANCHOR_END: error
}

/// The largest component, whatever its sign.
fn largest(vector: Vec3) -> f32 {
    vector.abs().max_element()
}

// ANCHOR: hit
impl Shape for Sphere {
    fn hit(&self, ray: &Ray, t_max: f32) -> Option<Hit> {
        let t = self.crossing(ray)?.first(t_max)?;
        let outward = (ray.origin - self.center) + t * ray.direction;
        // Of a sphere too small to be seen from so far, rounding may leave nothing.
        let normal = unit(outward).or_else(|| unit(-ray.direction))?;
        let point = self.point(ray, t, normal);
        let error = self.error(point, normal);
        Some(Hit { t, point, error, geometric: normal, normal, uv: uv(normal) })
    }

    fn is_hit(&self, ray: &Ray, t_max: f32) -> bool {
        self.crossing(ray).and_then(|crossing| crossing.first(t_max)).is_some()
    }

    /// Only from inside: from outside, the part that is seen faces away from the rest.
    fn hides_itself(&self, eye: Vec3) -> bool {
        !(self.power(eye - self.center) > 0.0)
    }
}
// ANCHOR_END: hit

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::Vec3;

    use super::Sphere;
    use crate::crossing::Crossing;
    use crate::double;
    use crate::naive::{NaiveSphere, projected_crossing};
    use crate::ray::Ray;
    use crate::shape::Shape;

    const SPHERE: Sphere = Sphere { center: Vec3::new(1.0, 2.0, -7.0), radius: 2.0 };

    fn in_cube(stream: &mut Stream, side: f32) -> Vec3 {
        let mut component = || stream.between(-side, side);
        Vec3::new(component(), component(), component())
    }

    #[test]
    fn a_hit_by_hand() {
        // The page's worked number: f = (0, 1, 8), so l = (0, 1, 0), discriminant 1 * 3.
        let ray = Ray { origin: Vec3::new(1.0, 3.0, 1.0), direction: -Vec3::Z };
        let hit = SPHERE.hit(&ray, f32::INFINITY).expect("a hit");
        assert!((hit.t - (8.0 - 3f32.sqrt())).abs() < 1e-6);
        assert!((hit.point - Vec3::new(1.0, 3.0, 3f32.sqrt() - 7.0)).length() < 1e-6);
        assert!((hit.normal - Vec3::new(0.0, 0.5, 3f32.sqrt() / 2.0)).length() < 1e-6);
    }

    #[test]
    fn a_limit_hides_what_is_behind_it() {
        let ray = Ray { origin: Vec3::new(1.0, 2.0, 0.0), direction: -Vec3::Z };
        assert_eq!(SPHERE.hit(&ray, 5.0).map(|hit| hit.t), None, "0 < t < t_max");
        assert_eq!(SPHERE.hit(&ray, 5.1).map(|hit| hit.t), Some(5.0));
    }

    /// Hard case RC-03: Vieta's formulas, t0 t1 = c / a and t0 + t1 = 2 b / a.
    #[test]
    fn both_roots_at_once() {
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(21, trial);
            let ray =
                Ray { origin: in_cube(&mut stream, 9.0), direction: in_cube(&mut stream, 2.0) };
            let Some(crossing) = SPHERE.crossing(&ray) else { continue };
            let d = ray.direction.as_dvec3();
            let f = ray.origin.as_dvec3() - SPHERE.center.as_dvec3();
            let (a, b, c) = (d.dot(d), -f.dot(d), f.dot(f) - 4.0);
            let (enter, leave) = (f64::from(crossing.enter), f64::from(crossing.leave));
            let size = (f.length() + 2.0) / d.length();
            assert!(enter <= leave);
            assert!((enter + leave - 2.0 * b / a).abs() <= 1e-6 * size, "{ray:?}");
            assert!((enter * leave - c / a).abs() <= 1e-6 * size * size, "{ray:?}");
        }
    }

    /// Hard case RC-04: a direction 2^k times as long makes t 2^k times as small, and no bit else.
    #[test]
    fn the_direction_s_length_divides_t() {
        for (trial, exponent) in (0..20_000).zip((-40..=40).cycle()) {
            let mut stream = Stream::of_trial(22, trial);
            let ray =
                Ray { origin: in_cube(&mut stream, 9.0), direction: in_cube(&mut stream, 2.0) };
            let scale = f32::from_bits(((127 + exponent) as u32) << 23);
            let scaled = Ray { direction: ray.direction * scale, ..ray };
            let t = |ray: &Ray| SPHERE.crossing(ray).map(|crossing| crossing.enter);
            assert_eq!(t(&scaled).map(|t| t * scale), t(&ray), "2^{exponent}");
        }
    }

    /// Hard case RC-02, and its limit: what the input no longer says, no formula can know.
    #[test]
    fn the_ground_to_a_radius_of_ten_million() {
        let ray = Ray::new(Vec3::Y, Vec3::new(0.1, -0.05, 1.0)).expect("a direction");
        let error = |radius: f32, formula: fn(&Sphere, &Ray) -> Option<Crossing>| {
            let sphere = Sphere { center: Vec3::Y * -radius, radius };
            let exact = double::crossing(&sphere, &ray, f64::from(radius)).enter;
            let t = formula(&sphere, &ray).map_or(f64::NAN, |crossing| f64::from(crossing.enter));
            (t - exact).abs() / exact
        };
        for radius in [1e5, 1e6, 1e7] {
            assert!(error(radius, Sphere::crossing) < 1e-4, "{radius}");
        }
        let naive = |sphere: &Sphere, ray: &Ray| NaiveSphere(*sphere).crossing(ray);
        assert!(error(1e7, naive) > 0.1 && error(1e7, projected_crossing) > 0.1);
        assert!(error(1e8, Sphere::crossing) > 0.1, "1 + 10^8 is 10^8 in f32");
    }

    /// Hard case RC-10, the other way round: near a huge sphere the point along the ray is better.
    #[test]
    fn a_point_on_the_ground_is_not_moved_by_the_ground_s_rounding() {
        // It passes through the origin, and its normal there is (0.6, 0.8, 0).
        let sphere = Sphere { center: Vec3::new(-6e5, -8e5, 0.0), radius: 1e6 };
        let ray = Ray::new(Vec3::new(3.0, 2.0, 1.0), Vec3::new(-0.4, -0.5, 0.3)).expect("a ray");
        let hit = sphere.hit(&ray, f32::INFINITY).expect("the ground");
        let point = ray.origin.as_dvec3() + f64::from(hit.t) * ray.direction.as_dvec3();
        assert!((hit.point.as_dvec3() - point).length() < 1e-6);
        let around = sphere.center + sphere.radius * hit.normal;
        assert!((around.as_dvec3() - point).length() > 1e-3, "the other formula");
    }

    /// The height of a hit's point over the sphere, exact to `f64`, and the bound on it.
    fn height_and_bound(sphere: &Sphere, ray: &Ray) -> Option<(f64, f64)> {
        let hit = sphere.hit(ray, f32::INFINITY)?;
        let from_center = (hit.point.as_dvec3() - sphere.center.as_dvec3()).length();
        let bound = hit.geometric.abs().as_dvec3().dot(hit.error.as_dvec3());
        Some(((from_center - f64::from(sphere.radius)).abs(), bound))
    }

    #[test]
    fn the_error_covers_the_point_whichever_way_it_was_made() {
        let mut hits = 0;
        for trial in 0..200_000 {
            let mut stream = Stream::of_trial(24, trial);
            let mut decade = |low, high| common::math::pow(10.0, stream.between(low, high));
            let (radius, away, from) = (decade(-4.0, 7.0), decade(-4.0, 6.0), decade(-8.0, 8.0));
            let center = away * in_cube(&mut stream, 1.0);
            let origin = from * in_cube(&mut stream, 1.0);
            let direction = center + radius * in_cube(&mut stream, 0.6) - origin;
            let found = height_and_bound(&Sphere { center, radius }, &Ray { origin, direction });
            let Some((height, bound)) = found else { continue };
            assert!(height <= bound, "{trial}: {height} {bound}");
            hits += 1;
        }
        assert!(hits > 100_000);
    }

    #[test]
    fn the_error_is_a_few_roundings_of_what_goes_in() {
        for trial in 0..100_000 {
            let mut stream = Stream::of_trial(25, trial);
            let ray =
                Ray { origin: in_cube(&mut stream, 9.0), direction: in_cube(&mut stream, 2.0) };
            let Some((_, bound)) = height_and_bound(&SPHERE, &ray) else { continue };
            let size = f64::from(SPHERE.center.length() + SPHERE.radius);
            assert!(bound <= 10.0 * f64::from(f32::EPSILON) * size, "{trial}: {bound}");
        }
    }

    /// Hard case SH-03: what starts inside can't miss, however flat it runs along the surface.
    #[test]
    fn from_inside_nothing_is_missed() {
        for trial in 0..100_000 {
            let mut stream = Stream::of_trial(26, trial);
            let normal = in_cube(&mut stream, 1.0).normalize_or(Vec3::X);
            let flat = normal.any_orthonormal_vector() - stream.between(0.0, 1e-3) * normal;
            let origin = SPHERE.center + 0.999_999 * SPHERE.radius * normal;
            let crossing = SPHERE.crossing(&Ray { origin, direction: flat });
            assert!(crossing.is_some_and(|it| it.enter <= 0.0 && 0.0 < it.leave), "{trial}");
        }
    }
}
