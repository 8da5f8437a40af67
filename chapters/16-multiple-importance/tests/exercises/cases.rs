//! What the exercises are asked, and independent answers.

use common::sampler::Stream;
use common::stats::estimate::Estimate;
use common::stats::running::Running;
use glam::{Vec2, Vec3};
use monte_carlo::warp::cap::Cap;
use multiple_importance::place::Place;
use path_tracing::vertex::Departure;

/// Two densities of one sample.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    pub(super) own: f32,
    pub(super) other: f32,
}

impl Pair {
    /// In `f64`, which has room for squares of `f32`.
    pub(super) fn power(&self) -> f32 {
        let [own, other] = [self.own, self.other].map(f64::from);
        let [own, other] = [own * own, other * other];
        if own > 0.0 { (own / (own + other)) as f32 } else { 0.0 }
    }
}

pub(super) fn pairs() -> Vec<Pair> {
    let plain =
        [(3.0, 1.0), (1.0, 3.0), (2.0, 2.0), (0.5, 0.1), (1.0, 0.0), (0.0, 1.0), (0.0, 0.0)];
    let extreme =
        [(1e20, 1e20), (1e20, 3e20), (3e38, 1.0), (1e-23, 1e-23), (1e-30, 2e-30), (1e-30, 1e30)];
    plain.into_iter().chain(extreme).map(|(own, other)| Pair { own, other }).collect()
}

/// A place to be estimated.
#[derive(Clone, Copy, Debug)]
pub(super) struct Site {
    pub(super) place: Place,
    seed: u64,
}

/// What came of many estimates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    mean: Estimate,
    spread: Spread,
}

/// The standard deviation of one estimate, in units of the right value.
#[derive(Clone, Copy, Debug)]
enum Spread {
    /// That of a good estimator lies below this.
    Below(f64),
    /// It was measured.
    Measured(f64),
}

impl Found {
    /// Whether the means can be the same, and both spreads are below `most`, or neither.
    pub(super) fn agree(&self, other: &Self, most: f64) -> bool {
        // A right answer is refused once in 10⁶ cases; the seeds are fixed.
        let same_mean = self.mean.agrees(&other.mean, 1e-6);
        same_mean && self.spread.is_below(most) == other.spread.is_below(most)
    }
}

impl Spread {
    fn is_below(self, most: f64) -> bool {
        match self {
            Self::Below(bound) => bound <= most,
            Self::Measured(spread) => spread < most,
        }
    }
}

const SAMPLES: u64 = 20_000;

impl Site {
    /// The closed form, and the spread that a good estimator stays below.
    pub(super) fn exact(&self, most: f64) -> Found {
        Found { mean: Estimate::exact(self.place.exact()), spread: Spread::Below(most) }
    }

    fn found(&self, estimate: impl Fn(&mut Stream) -> f32) -> Found {
        let one = |trial| f64::from(estimate(&mut Stream::of_trial(self.seed, trial)));
        let samples: Running = (0..SAMPLES).map(one).collect();
        let mean = Estimate::of(&samples).unwrap_or(Estimate::exact(f64::NAN));
        let deviation = samples.variance().unwrap_or(0.0).sqrt();
        Found { mean, spread: Spread::Measured(deviation / self.place.exact()) }
    }

    /// Many estimates from one direction of each strategy.
    pub(super) fn of_each(&self, estimate: impl Fn(&Place, Vec2, Vec2) -> f32) -> Found {
        self.found(|stream| {
            let [light, direction] = [stream.uniform2(), stream.uniform2()];
            estimate(&self.place, light, direction)
        })
    }

    /// Many estimates from one direction of either.
    pub(super) fn of_one(&self, estimate: impl Fn(&Place, f32, Vec2) -> f32) -> Found {
        self.found(|stream| {
            let chance = stream.uniform();
            estimate(&self.place, chance, stream.uniform2())
        })
    }
}

pub(super) fn sites() -> Vec<Site> {
    let exponents = [1.0, 10.0, 200.0, 3000.0];
    let heights = [0.0005, 0.02, 0.4];
    let places = exponents.into_iter().flat_map(|exponent| {
        let place = move |height| Place { exponent, lamp: Cap { height }, radiance: 2.0 };
        heights.into_iter().map(place)
    });
    (1650..).zip(places).map(|(seed, place)| Site { place, seed }).collect()
}

/// A path that came upon a lamp.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arrival {
    pub(super) departure: Departure,
    pub(super) light_pdf: f32,
}

impl Arrival {
    pub(super) fn share(&self) -> f32 {
        let [own, other] = [self.departure.pdf, self.light_pdf].map(f64::from);
        if self.departure.is_delta { 1.0 } else { (own / (own + other)) as f32 }
    }
}

pub(super) fn arrivals() -> Vec<Arrival> {
    let all = [
        (3.0, 1.0, false),
        (0.3, 8.0, false),
        (1.0, 3.0, true),
        (0.5, 0.0, true),
        (0.2, 0.0, false),
        (2.0, 2.0, false),
    ];
    let arrival = |(pdf, light_pdf, is_delta)| Arrival {
        departure: Departure { from: Vec3::ZERO, pdf, is_delta },
        light_pdf,
    };
    all.into_iter().map(arrival).collect()
}

/// A point of a lamp, as a surface sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    pub(super) area: f32,
    pub(super) distance: f32,
    pub(super) cosine: f32,
    pub(super) by_direction: f32,
}

impl Point {
    pub(super) fn weight(&self) -> f32 {
        let [area, distance, cosine, by_direction] =
            [self.area, self.distance, self.cosine, self.by_direction].map(f64::from);
        // A piece of area d A is seen in the solid angle d A cos / distance².
        let solid_angle = area * cosine / (distance * distance);
        (1.0 / (1.0 + solid_angle * by_direction)) as f32
    }
}

pub(super) fn points() -> Vec<Point> {
    let all = [
        (0.5, 1.0, 1.0, 2.0),
        (0.5, 2.0, 1.0, 2.0),
        (0.5, 1.0, 0.5, 2.0),
        (3.0, 4.0, 0.25, 0.3),
        (0.01, 0.3, 0.8, 40.0),
    ];
    let point =
        |(area, distance, cosine, by_direction)| Point { area, distance, cosine, by_direction };
    all.into_iter().map(point).collect()
}
