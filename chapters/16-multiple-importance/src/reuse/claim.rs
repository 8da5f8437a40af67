//! A vertex that several pixels could have found, and what each of them gets of it.

use common::film::Color;
use common::tally::Tally;
use path_tracing::bsdf::Bsdf;
use path_tracing::space::Space;
use path_tracing::vertex::Vertex;
use ray_casting::shape::Hit;
use shadows::visibility::{End, visible};

use super::REUSED_PATHS;

/// How a vertex is divided among the pixels that see it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Division {
    /// By the densities with which they would have found it.
    #[default]
    Balance,
    /// Each takes it as if it were its own, and divides by their number. It is wrong: where a pixel
    /// could not have found the vertex the others' shares miss, and next to the vertex there is no
    /// limit to what it counts.
    Even,
}

/// The first vertex of a pixel's path.
pub(super) struct First<'a, B> {
    /// The pixel's place in its block.
    pub(super) place: usize,
    pub(super) vertex: Vertex<'a, B>,
}

/// The second vertex of a pixel's path: light comes from there.
pub(super) struct Source {
    /// The place of the pixel that found it.
    pub(super) place: usize,
    pub(super) hit: Hit,
    /// The side from which it was seen: the sign is that of the cosine.
    pub(super) side: f32,
    /// What it sends to all directions of this side.
    pub(super) radiance: Color,
    /// What that counts for the pixel that found it, were it alone.
    pub(super) throughput: Color,
}

/// A pixel that sees a source.
struct Claim {
    place: usize,
    /// What becomes of the source's radiance: scattering function times cosine.
    part: Color,
    /// Cosine at the source over squared distance: steradians in a unit of area.
    geometry: f64,
    /// With which it would have found the source, in a unit of area.
    density: f64,
}

impl Source {
    // ANCHOR: divide
    /// Gives each pixel that sees the source what it counts there.
    pub(super) fn divide<B: Bsdf, T: Tally>(
        &self,
        space: &Space,
        firsts: &[First<B>],
        division: Division,
        colors: &mut [Color],
        tally: &mut T,
    ) {
        let claims: Vec<Claim> =
            firsts.iter().filter_map(|first| self.claim(space, first, tally)).collect();
        let Some(own) = claims.iter().find(|claim| claim.place == self.place) else {
            // Too near or too far to be measured: it stays with the pixel that found it.
            colors[self.place] += self.throughput * self.radiance;
            return;
        };
        let total = match division {
            Division::Balance => claims.iter().map(|claim| claim.density).sum(),
            Division::Even => own.density * firsts.len() as f64,
        };
        tally.count(REUSED_PATHS, claims.len() as u64 - 1);
        for claim in &claims {
            let weight = (claim.geometry / total) as f32;
            colors[claim.place] += self.radiance * claim.part * weight;
        }
    }
    // ANCHOR_END: divide

    // ANCHOR: claim
    /// What one pixel has of the source; `None` if its first vertex doesn't see it.
    fn claim<B: Bsdf, T: Tally>(
        &self,
        space: &Space,
        first: &First<B>,
        tally: &mut T,
    ) -> Option<Claim> {
        let First { place, ref vertex } = *first;
        let way = self.hit.point.as_dvec3() - vertex.hit().point.as_dvec3();
        let squared = way.length_squared();
        let direction = (way / squared.sqrt()).as_vec3();
        let cosine = -direction.dot(self.hit.geometric);
        // Seen from the other side it has another radiance. NaN is on neither side.
        if !(cosine * self.side > 0.0) {
            return None;
        }
        let incoming = vertex.frame.to_local(direction);
        let pdf = vertex.bsdf.pdf(vertex.outgoing, incoming);
        let part = vertex.bsdf.eval(vertex.outgoing, incoming) * incoming.z.abs();
        if !pdf.is_normal() || part == Color::ZERO {
            return None;
        }
        // Its own path has been there.
        let sees =
            place == self.place || visible(space, End::On(vertex.hit()), End::On(&self.hit), tally);
        let geometry = f64::from(cosine.abs()) / squared;
        sees.then(|| Claim { place, part, geometry, density: f64::from(pdf) * geometry })
    }
    // ANCHOR_END: claim
}
