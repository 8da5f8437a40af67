//! A lobe and a lamp: a place so simple that its light has a closed form.

use std::f32::consts::TAU;

use glam::{Vec2, Vec3, Vec3Swizzles};
use monte_carlo::warp::cap::Cap;
use monte_carlo::warp::disk;

use crate::heuristic::Heuristic;

// ANCHOR: place
/// A surface that scatters light in a lobe around z, below a lamp that is seen around z.
///
/// What leaves the surface for each unit of radiance from a direction of height z, the cosine
/// included, is (n + 1) / 2π · zⁿ: a matte white surface for n = 1, nearly a mirror for n = 1000.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// n, at least 1.
    pub exponent: f32,
    /// 1 - cos θ of the cap in which the lamp is seen, above 0 and below 1.
    pub lamp: Cap,
    /// The lamp's radiance.
    pub radiance: f32,
}

impl Place {
    /// The light that leaves the surface: radiance · (1 - cosⁿ⁺¹ θ).
    pub fn exact(&self) -> f64 {
        let cosine = 1.0 - f64::from(self.lamp.height);
        f64::from(self.radiance) * (1.0 - libm::pow(cosine, f64::from(self.exponent) + 1.0))
    }

    /// The radiance that comes from a direction.
    pub fn arriving(&self, incoming: Vec3) -> f32 {
        if below_top(incoming) < self.lamp.height { self.radiance } else { 0.0 }
    }

    /// What of it leaves, for each unit and steradian.
    pub fn scattered(&self, incoming: Vec3) -> f32 {
        if incoming.z <= 0.0 {
            return 0.0;
        }
        let power = libm::expf(self.exponent * libm::log1pf(-below_top(incoming)));
        (self.exponent + 1.0) / TAU * power
    }

    /// A direction to the lamp, uniform in its cap.
    pub fn sample_light(&self, u: Vec2) -> Vec3 {
        self.lamp.sample(u)
    }

    /// Its density, per steradian: 0 where there is no lamp.
    pub fn light_pdf(&self, incoming: Vec3) -> f32 {
        let inside = below_top(incoming) < self.lamp.height;
        if inside { 1.0 / self.lamp.solid_angle() } else { 0.0 }
    }

    /// A direction of the lobe: cosⁿ⁺¹ is uniform.
    pub fn sample_direction(&self, u: Vec2) -> Vec3 {
        let height = -libm::expm1f(libm::log1pf(-u.x) / (self.exponent + 1.0));
        let radius = (height * (2.0 - height)).max(0.0).sqrt();
        (radius * disk::direction(TAU * u.y)).extend(1.0 - height)
    }

    /// Its density, per steradian.
    pub fn direction_pdf(&self, incoming: Vec3) -> f32 {
        self.scattered(incoming)
    }
}
// ANCHOR_END: place

/// 1 - z, without its rounding near the top.
fn below_top(incoming: Vec3) -> f32 {
    incoming.xy().length_squared() / (1.0 + incoming.z)
}

// ANCHOR: estimates
impl Place {
    /// An estimate from a direction to the lamp alone.
    pub fn by_light(&self, u: Vec2) -> f32 {
        let incoming = self.sample_light(u);
        self.arriving(incoming) * self.scattered(incoming) * self.lamp.solid_angle()
    }

    /// An estimate from a direction of the lobe alone.
    pub fn by_direction(&self, u: Vec2) -> f32 {
        let incoming = self.sample_direction(u);
        self.arriving(incoming) * self.scattered(incoming) / self.direction_pdf(incoming)
    }

    /// An estimate from one direction of each.
    pub fn combined(&self, rule: Heuristic, [light, direction]: [Vec2; 2]) -> f32 {
        let to_lamp = self.sample_light(light);
        let share = rule.weight(self.light_pdf(to_lamp), self.direction_pdf(to_lamp));
        let of_lobe = self.sample_direction(direction);
        let other = rule.weight(self.direction_pdf(of_lobe), self.light_pdf(of_lobe));
        share * self.by_light(light) + other * self.by_direction(direction)
    }
}
// ANCHOR_END: estimates

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use common::stats::estimate::{Estimate, t_test};
    use common::stats::running::Running;
    use glam::Vec2;
    use monte_carlo::warp::cap::Cap;

    use super::Place;
    use crate::heuristic::Heuristic;
    use crate::naive::{added, averaged};

    fn place(exponent: f32, height: f32) -> Place {
        Place { exponent, lamp: Cap { height }, radiance: 3.0 }
    }

    /// *By hand:* a matte surface under a lamp with cos θ = 0.8 sends 1 - 0.64 of its radiance.
    #[test]
    fn by_hand() {
        assert!((place(1.0, 0.2).exact() - 3.0 * 0.36).abs() < 1e-6);
    }

    fn run(place: &Place, estimate: impl Fn(&Place, [Vec2; 2]) -> f32) -> Running {
        let one = |trial| {
            let mut stream = Stream::of_trial(1600, trial);
            f64::from(estimate(place, [stream.uniform2(), stream.uniform2()]))
        };
        (0..20_000).map(one).collect()
    }

    fn combined(rule: Heuristic) -> impl Fn(&Place, [Vec2; 2]) -> f32 {
        move |place, u| place.combined(rule, u)
    }

    /// Any weights that add up to 1 are right, these two among them; weights that add up to 2, or to
    /// 1 only where both can look, are not.
    #[test]
    fn weights_that_add_up_to_one_are_right_on_average() {
        for exponent in [1.0, 20.0, 300.0] {
            for height in [0.001, 0.05, 0.6] {
                let place = place(exponent, height);
                for rule in [Heuristic::Balance, Heuristic::Power] {
                    let found = t_test(&run(&place, combined(rule)), place.exact());
                    let p_value = found.map_or(1.0, |test| test.p_value);
                    assert!(p_value > 1e-4, "{place:?} {rule:?}: {p_value}");
                }
                let twice = t_test(&run(&place, added), place.exact());
                assert!(twice.is_some_and(|test| test.p_value < 1e-9), "{place:?}");
                let half = t_test(&run(&place, averaged), place.exact());
                assert!(half.is_some_and(|test| test.p_value > 1e-4), "{place:?}");
            }
        }
    }

    /// Veach's bound: balance is at most a square of the mean worse than any other choice of weights.
    /// Power is less than a tenth of that square worse than the better of the two strategies alone,
    /// also where that one has no noise at all.
    #[test]
    fn never_much_worse_than_the_better_one() {
        for exponent in [1.0, 20.0, 300.0, 5000.0] {
            for height in [1e-5, 0.001, 0.05, 0.6] {
                let place = place(exponent, height);
                let by_light = run(&place, |place, [u, _]| place.by_light(u));
                let by_direction = run(&place, |place, [_, u]| place.by_direction(u));
                let variance = |samples: &Running| samples.variance().unwrap_or(0.0);
                let best = variance(&by_light).min(variance(&by_direction));
                let square = place.exact() * place.exact();
                let balance = variance(&run(&place, combined(Heuristic::Balance)));
                let power = variance(&run(&place, combined(Heuristic::Power)));
                assert!(balance <= best + 0.5 * square, "{place:?}: {balance} {best}");
                assert!(power <= 1.2 * best + 0.1 * square, "{place:?}: {power} {best}");
            }
        }
    }

    #[test]
    fn both_strategies_alone_are_right() {
        // Of the sharper lobe one direction in fifty misses the lamp: often enough to be counted.
        for exponent in [1.0, 10.0] {
            let place = place(exponent, 0.3);
            let exact = Estimate::exact(place.exact());
            let by_light = run(&place, |place, [u, _]| place.by_light(u));
            let by_direction = run(&place, |place, [_, u]| place.by_direction(u));
            for samples in [by_light, by_direction] {
                let estimate = Estimate::of(&samples).expect("many");
                assert!(estimate.agrees(&exact, 1e-4), "{estimate:?}");
            }
        }
    }
}
