//! The two choices a path tracer leaves open: how it looks for light, and when it ends a path.

use common::film::Color;
use common::tally::Tally;

use crate::bsdf::Bsdf;
use crate::random::Random;
use crate::space::{Met, Space};
use crate::vertex::{Departure, Vertex};

// ANCHOR: lighting
/// How light is looked for.
pub trait Lighting: Sync {
    /// An estimate of the light that comes to `vertex` straight from lamps and leaves it towards the
    /// eye, from directions chosen for the lamps.
    fn direct<B: Bsdf, T: Tally>(
        &self,
        space: &Space,
        vertex: &Vertex<B>,
        random: &Random,
        tally: &mut T,
    ) -> Color;

    /// The share of a lamp's light that counts where a path came upon the lamp by itself, from 0 to
    /// 1. The rest is what [`Lighting::direct`] has found already.
    fn share(&self, departure: &Departure, met: &Met) -> f32;
}

/// Lamps are found by chance alone.
#[derive(Clone, Copy, Debug)]
pub struct ByDirection;

impl Lighting for ByDirection {
    #[inline]
    fn direct<B: Bsdf, T: Tally>(
        &self,
        _space: &Space,
        _vertex: &Vertex<B>,
        _random: &Random,
        _tally: &mut T,
    ) -> Color {
        Color::ZERO
    }

    #[inline]
    fn share(&self, _departure: &Departure, _met: &Met) -> f32 {
        1.0
    }
}
// ANCHOR_END: lighting

// ANCHOR: ending
/// When a path ends that could go on.
pub trait Ending: Sync {
    /// What the path counts from here on if it goes on, `None` if it ends. `throughput` is what it
    /// carries after `bounce` surfaces, the last one included.
    fn factor(&self, throughput: Color, bounce: u32, random: &Random) -> Option<f32>;
}

/// Paths go on as far as they may.
#[derive(Clone, Copy, Debug)]
pub struct Never;

impl Ending for Never {
    #[inline]
    fn factor(&self, _throughput: Color, _bounce: u32, _random: &Random) -> Option<f32> {
        Some(1.0)
    }
}
// ANCHOR_END: ending

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::tally::Off;
    use glam::Vec3;
    use ray_casting::ray::Ray;

    use super::{ByDirection, Ending, Lighting, Never};
    use crate::furnace;
    use crate::random::Random;
    use crate::stage::Stage;
    use crate::vertex::{Departure, Vertex};

    #[test]
    fn lamps_count_in_full_and_are_not_looked_for() {
        let stage = Stage::new(&furnace::shell(0.5)).expect("sound");
        let ray = Ray { origin: Vec3::new(1.5, 0.0, 0.0), direction: Vec3::X };
        let met = stage.space.nearest(&ray, &mut Off).expect("the wall");
        let vertex = Vertex::new(&ray, &met, &stage.surfaces[0].bsdf);
        let random = Random::of_trial(1, 1);
        let direct = ByDirection.direct(&stage.space, &vertex, &random, &mut Off);
        assert_eq!(direct, Color::ZERO);
        assert_eq!(ByDirection.share(&Departure::from_eye(&ray), &met), 1.0);
        assert_eq!(Never.factor(Color::ZERO, 1000, &random), Some(1.0));
    }
}
