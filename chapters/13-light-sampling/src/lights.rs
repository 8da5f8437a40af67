//! All lamps of a scene, and which of them is looked at.

use common::film::Color;
use common::sampler::Purpose;
use glam::Vec3;
use monte_carlo::table::Table;
use path_tracing::random::Random;
use path_tracing::space::{Met, Space};
use path_tracing::world::Surface;
use ray_casting::shape::Hit;

use crate::lamp::{Lamp, LampPoint, Way};

/// The lamp, and the point of it.
pub const LAMP_POINT: Purpose = Purpose::named("point of a lamp");

// ANCHOR: lights
/// The lamps of a scene, each with the chance that it is the one to be looked at.
#[derive(Clone, Debug)]
pub struct Lights {
    lamps: Vec<Lamp>,
    /// `None` when there is no lamp.
    table: Option<Table>,
    /// For each piece of the scene, its lamp, or [`NONE`].
    of_piece: Vec<u32>,
    way: Way,
}

/// How often each lamp is chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Choice {
    /// As often as its power says.
    #[default]
    Power,
    /// All alike.
    Uniform,
}

/// Light that may come from a lamp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSample {
    /// The point of the lamp, and the direction to it.
    pub point: LampPoint,
    /// The radiance it sends from there.
    pub radiance: Color,
    /// The density with which that direction was chosen among all of all lamps, per steradian.
    pub pdf: f32,
}
// ANCHOR_END: lights

/// The piece is no lamp.
const NONE: u32 = u32::MAX;

impl Lights {
    /// The lamps among the pieces of `space`, whose things are `surfaces`. Lamps without area or
    /// power are left out, and are found by direction alone.
    pub fn new<B>(space: &Space, surfaces: &[Surface<B>], choice: Choice, way: Way) -> Self {
        let mut of_piece = vec![NONE; space.len()];
        let mut lamps = Vec::new();
        for (piece, lamp) in of_piece.iter_mut().enumerate() {
            let Some((shape, owner)) = space.piece(piece) else { continue };
            let emission = surfaces[owner as usize].emission;
            if let Some(found) = Lamp::new(shape, emission).filter(|_| emission.glows()) {
                *lamp = lamps.len() as u32;
                lamps.push(found);
            }
        }
        let weight = |lamp: &Lamp| match choice {
            Choice::Power => lamp.power(),
            Choice::Uniform => 1.0,
        };
        let weights: Vec<f32> = lamps.iter().map(weight).collect();
        Self { table: Table::new(&weights), lamps, of_piece, way }
    }

    // ANCHOR: sample
    /// A direction from which light may come to `from`: a lamp is chosen, then a point of it.
    #[inline]
    pub fn sample(&self, from: Vec3, random: &Random) -> Option<LightSample> {
        let u = random.pair(LAMP_POINT);
        let pick = self.table.as_ref()?.pick(u.x);
        let lamp = &self.lamps[pick.index];
        let point = lamp.point(from, self.way, u.with_x(pick.rest))?;
        let radiance = point.radiance(&lamp.emission);
        let pdf = pick.probability * point.pdf;
        (radiance != Color::ZERO).then_some(LightSample { point, radiance, pdf })
    }
    // ANCHOR_END: sample

    // ANCHOR: pdf
    /// The density with which [`Lights::sample`] chooses the direction from `from` in which a path
    /// came upon `met`, per steradian; 0 for what is no lamp.
    #[inline]
    pub fn pdf(&self, from: Vec3, met: &Met) -> f32 {
        let Some((lamp, probability)) = self.lamp(met.piece) else { return 0.0 };
        let pdf = probability * lamp.pdf(from, self.way, &met.hit);
        if pdf.is_finite() { pdf } else { 0.0 }
    }
    // ANCHOR_END: pdf

    /// Whether the piece is a lamp that can be chosen.
    #[inline]
    pub fn can_choose(&self, piece: u32) -> bool {
        self.lamp(piece).is_some_and(|(_lamp, probability)| probability > 0.0)
    }

    /// The probability that the piece is looked at; `None` for what is no lamp.
    pub fn probability(&self, piece: u32) -> Option<f32> {
        self.lamp(piece).map(|(_lamp, probability)| probability)
    }

    /// The number of the lamp that this piece is.
    #[inline]
    pub fn number(&self, piece: usize) -> Option<usize> {
        self.of_piece.get(piece).filter(|&&lamp| lamp != NONE).map(|&lamp| lamp as usize)
    }

    /// How often each lamp is chosen; `None` when there is no lamp.
    pub fn table(&self) -> Option<&Table> {
        self.table.as_ref()
    }

    /// The lamps.
    pub fn lamps(&self) -> &[Lamp] {
        &self.lamps
    }

    /// How many lamps have too little power to be chosen: less than 2⁻²⁴ of all.
    pub fn left_out(&self) -> usize {
        self.table.as_ref().map_or(0, Table::left_out)
    }

    /// The lamp of a piece, and the probability that it is chosen.
    #[inline]
    fn lamp(&self, piece: u32) -> Option<(&Lamp, f32)> {
        let number = self.number(piece as usize)?;
        Some((self.lamps.get(number)?, self.table.as_ref()?.probability(number)))
    }
}

/// The end of a line of sight that is on a lamp.
impl LightSample {
    /// Where the lamp is.
    #[inline]
    pub fn hit(&self) -> &Hit {
        &self.point.hit
    }
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::stats::running::Running;
    use common::tally::Off;
    use glam::{Vec2, Vec3};
    use path_tracing::part::{Emission, Form, Part};
    use path_tracing::random::Random;
    use path_tracing::scenes::{CEILING_LIGHT, light};
    use path_tracing::smooth::Smooth;
    use path_tracing::space::Space;
    use path_tracing::world::Surface;
    use ray_casting::ray::Ray;

    use super::{Choice, Lights};
    use crate::lamp::Way;

    /// A square of side 2 above (x, 0) that shines down.
    fn square(x: f32, y: f32, radiance: f32) -> Part<Smooth> {
        let corners = [[1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]];
        let form = Form::quad(corners.map(|[dx, dz]| Vec3::new(x + dx, y, dz)));
        Part::glowing(form, Smooth::BLACK, Color::splat(radiance))
    }

    /// Squares of side 2 at heights 3 and 5 that shine down, the second three times as bright, and a
    /// ball between them that shines not at all.
    fn scene() -> (Space, Vec<Surface<Smooth>>) {
        let ball = Part::dark(Form::ball(Vec3::new(20.0, 0.0, 0.0), 0.5), Smooth::BLACK);
        of(vec![square(-2.0, 3.0, 1.0), square(2.0, 5.0, 3.0), ball])
    }

    fn of(parts: Vec<Part<Smooth>>) -> (Space, Vec<Surface<Smooth>>) {
        let surface = |part: &Part<_>| Surface { bsdf: part.material, emission: part.emission };
        (Space::new(&parts), parts.iter().map(surface).collect())
    }

    /// *By hand:* four triangles of area 2; of the power, 1/8 each for the first square's two and 3/8
    /// each for the second's.
    #[test]
    fn each_as_often_as_its_power_says() {
        let (space, surfaces) = scene();
        let probabilities = |choice| {
            let lights = Lights::new(&space, &surfaces, choice, Way::Area);
            [0, 1, 2, 3, 4].map(|piece| lights.probability(piece))
        };
        let right = [Some(0.125), Some(0.125), Some(0.375), Some(0.375), None];
        for (found, right) in probabilities(Choice::Power).into_iter().zip(right) {
            // Whole slots: the last of 2²⁴ goes to either of the two with the most.
            let off = found.zip(right).map_or(0.0, |(found, right)| (found - right).abs());
            assert!(found.is_some() == right.is_some() && off < 1e-6, "{found:?}");
        }
        let alike = [Some(0.25), Some(0.25), Some(0.25), Some(0.25), None];
        assert_eq!(probabilities(Choice::Uniform), alike);
    }

    /// Two lamps that look alike, one a hundred times as bright. *By hand:* chosen alike, an estimate is
    /// 2 or 200 times the same number, so its deviation is 0.98 of its mean.
    #[test]
    fn power_pays_where_one_lamp_outshines_the_others() {
        let (space, surfaces) = of(vec![square(-2.0, 4.0, 1.0), square(2.0, 4.0, 100.0)]);
        let deviation = |choice| {
            let lights = Lights::new(&space, &surfaces, choice, Way::SolidAngle);
            let estimate = |trial| {
                let random = Random::of_trial(1323, trial);
                let sample = lights.sample(Vec3::ZERO, &random).expect("in sight");
                f64::from(sample.radiance.x / sample.pdf)
            };
            let estimates: Running = (0..4000).map(estimate).collect();
            estimates.variance().expect("many").sqrt() / estimates.mean()
        };
        let [alike, by_power] = [Choice::Uniform, Choice::Power].map(deviation);
        assert!((alike - 0.98).abs() < 0.03, "{alike}");
        assert!(by_power < 0.1 * alike, "{by_power} {alike}");
    }

    /// MI-05: the density of what a path meets in the sampled direction is that of the sample.
    #[test]
    fn the_density_of_what_is_met_is_that_of_the_sample() {
        let (space, surfaces) = scene();
        let from = Vec3::new(0.3, 0.1, -0.2);
        for (choice, way) in [(Choice::Power, Way::Area), (Choice::Uniform, Way::SolidAngle)] {
            let lights = Lights::new(&space, &surfaces, choice, way);
            let mut met_again = 0;
            for trial in 0..2000 {
                let random = Random::of_trial(1320, trial);
                let sample = lights.sample(from, &random).expect("in sight");
                let ray = Ray { origin: from, direction: sample.point.direction };
                let met = space.nearest(&ray, &mut Off).expect("the lamp");
                // On the edge between two triangles either may be met.
                met_again += u32::from((lights.pdf(from, &met) / sample.pdf - 1.0).abs() < 1e-4);
            }
            assert!(met_again >= 1998, "{met_again}");
        }
    }

    /// *By hand:* the lamp of the Cornell box is 130 wide and 105 deep, and 548.7 above the floor. Seen
    /// from below its middle, that is chosen with 548.7² / 13650 = 22.06 per steradian.
    #[test]
    fn below_the_lamp_of_the_box() {
        let (space, surfaces) = of(vec![light(CEILING_LIGHT)]);
        let lights = Lights::new(&space, &surfaces, Choice::Power, Way::Area);
        let from = Vec3::new(278.0, 0.0, 279.5);
        // The middle is on the edge that both triangles share.
        let middle =
            lights.lamps()[0].point(from, Way::Area, Vec2::new(0.25, 1.0)).expect("in sight");
        assert!((middle.direction - Vec3::Y).length() < 1e-6, "{middle:?}");
        let pdf = 0.5 * middle.pdf;
        assert!((pdf - 22.06).abs() < 0.005, "{pdf}");
    }

    #[test]
    fn nothing_glows() {
        let (space, surfaces) = of(vec![Part::dark(Form::ball(Vec3::ZERO, 1.0), Smooth::BLACK)]);
        let lights = Lights::new(&space, &surfaces, Choice::Power, Way::Area);
        assert_eq!(lights.sample(3.0 * Vec3::X, &Random::of_trial(1321, 0)), None);
        assert!(lights.lamps().is_empty() && !lights.can_choose(0));
    }

    /// LS-10 and LS-11: lamps that can't be chosen are found by direction, and counted.
    #[test]
    fn lamps_without_area_or_power_are_left_to_chance() {
        let glow = |center, radius, radiance: f32| {
            let emission = Emission { radiance: Color::splat(radiance), both_sides: false };
            Part { form: Form::ball(center, radius), material: Smooth::BLACK, emission }
        };
        let parts = vec![
            glow(Vec3::ZERO, 1.0, 1e30),
            glow(5.0 * Vec3::X, 1.0, 1e-30),
            glow(9.0 * Vec3::X, 0.0, 1.0),
        ];
        let (space, surfaces) = of(parts);
        let lights = Lights::new(&space, &surfaces, Choice::Power, Way::Area);
        assert_eq!([0, 1, 2].map(|piece| lights.can_choose(piece)), [true, false, false]);
        assert_eq!((lights.lamps().len(), lights.left_out()), (2, 1));
        // More light than an f32 has numbers for: no table, and all is left to chance.
        let (space, surfaces) = of(vec![glow(Vec3::ZERO, 1e4, 3e38)]);
        let lights = Lights::new(&space, &surfaces, Choice::Power, Way::Area);
        assert!(!lights.can_choose(0));
        assert_eq!(lights.sample(3e4 * Vec3::X, &Random::of_trial(1322, 0)), None);
    }
}
