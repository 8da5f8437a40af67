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
        let index = self.of_piece[piece as usize];
        let lamp = self.lamps.get(index as usize)?;
        Some((lamp, self.table.as_ref()?.probability(index as usize)))
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
