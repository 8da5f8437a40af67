//! A scene as paths see it: where things are, what they are made of, and what shines.

use common::film::Color;

use crate::bsdf::Bsdf;
use crate::part::Emission;
use crate::space::Space;

// ANCHOR: world
/// A scene of materials `B`.
///
/// Geometry doesn't know materials: `space` says that thing number 3 was met, `surfaces` what thing
/// number 3 is.
#[derive(Clone, Debug)]
pub struct World<'a, B> {
    /// Where things are.
    pub space: &'a Space,
    /// What each thing is made of, and what it sends out.
    pub surfaces: Vec<Surface<B>>,
    /// The radiance from all around the scene.
    pub sky: Color,
}

/// A thing's material, and its own light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface<B> {
    /// How it scatters light.
    pub bsdf: B,
    /// The light it sends out.
    pub emission: Emission,
}
// ANCHOR_END: world

// ANCHOR: narrowed
impl<'a, B: Bsdf> World<'a, B> {
    /// The same scene of simpler materials, where every thing has one: `None` where one has not.
    pub fn narrowed<N: Bsdf>(&self, narrow: impl Fn(&B) -> Option<N>) -> Option<World<'a, N>> {
        let surfaces = self.surfaces.iter().map(|surface| {
            let bsdf = narrow(&surface.bsdf)?;
            Some(Surface { bsdf, emission: surface.emission })
        });
        let surfaces: Option<Vec<_>> = surfaces.collect();
        Some(World { space: self.space, surfaces: surfaces?, sky: self.sky })
    }
}
// ANCHOR_END: narrowed

#[cfg(test)]
mod tests {
    use crate::furnace;
    use crate::lambert::Lambert;
    use crate::smooth::Smooth;
    use crate::stage::Stage;

    #[test]
    fn all_must_have_the_simpler_material() {
        let stage = Stage::new(&furnace::shell(0.5)).expect("sound");
        let world = stage.world();
        let matte = world.narrowed(Smooth::lambert).expect("all are matte");
        assert_eq!(matte.surfaces[0].bsdf, Lambert::new(0.5, 0.5, 0.5));
        assert_eq!(matte.surfaces[1].emission, world.surfaces[1].emission);
        let grey = |smooth: &Smooth| smooth.lambert().filter(|it| *it != Lambert::BLACK);
        assert!(world.narrowed(grey).is_none(), "the lamp is black");
    }
}
