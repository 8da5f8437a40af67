//! A small scene of matte triangles, in tables that many paths read at once.

use common::film::Color;
use glam::Vec3;
use light_sampling::lights::Lights;
use path_tracing::lambert::Lambert;
use path_tracing::part::Emission;
use path_tracing::space::Piece;
use path_tracing::world::World;
use triangles::bundle::{RAYS, Vectors};
use triangles::few::{Few, MOST};
use triangles::surface::geometric_normal;

use super::column::Column;
use super::lamps::Lamps;

/// A scene of a few matte triangles.
#[derive(Clone, Debug)]
pub(super) struct Room {
    /// Where they are.
    pub(super) few: Few,
    /// Those that are looked at.
    pub(super) lamps: Lamps,
    corners: [Column; 3],
    pub(super) normal: Column,
    pub(super) reflectance: Column,
    pub(super) radiance: Column,
    both_sides: [bool; MOST],
    /// Whether it glows and is never looked at, so that its light counts wherever a path meets it.
    stray: [bool; MOST],
}

impl Room {
    /// The scene, if it is of a few triangles and nothing else.
    pub(super) fn new(world: &World<Lambert>, lights: &Lights) -> Option<Self> {
        let pieces = (0..world.space.len()).map(|piece| match world.space.piece(piece)? {
            (Piece::Triangle(corners), owner) => Some((corners, owner)),
            (Piece::Ball(_), _) => None,
        });
        let pieces: Vec<([Vec3; 3], u32)> = pieces.collect::<Option<_>>()?;
        let triangles: Vec<[Vec3; 3]> = pieces.iter().map(|(corners, _owner)| *corners).collect();
        if triangles.len() > MOST {
            return None;
        }
        let mut room = Self {
            few: Few::new(&triangles)?,
            lamps: Lamps::new(lights)?,
            corners: [Column::ZERO, Column::ZERO, Column::ZERO],
            normal: Column::ZERO,
            reflectance: Column::ZERO,
            radiance: Column::ZERO,
            both_sides: [false; MOST],
            stray: [false; MOST],
        };
        for (place, (corners, owner)) in pieces.into_iter().enumerate() {
            let surface = &world.surfaces[owner as usize];
            room.set(place, corners, surface.bsdf.reflectance, surface.emission);
            room.stray[place] = surface.emission.glows() && !lights.can_choose(place as u32);
        }
        Some(room)
    }

    fn set(&mut self, place: usize, corners: [Vec3; 3], reflectance: Color, emission: Emission) {
        // One without an area is never met.
        let normal = geometric_normal(&corners).unwrap_or(Vec3::Z);
        for (column, corner) in self.corners.iter_mut().zip(corners) {
            column.set(place, corner);
        }
        self.normal.set(place, normal);
        self.reflectance.set(place, reflectance);
        self.radiance.set(place, emission.radiance);
        self.both_sides[place] = emission.both_sides;
    }

    /// The corners of a triangle for each path.
    #[inline(always)]
    pub(super) fn corners(&self, places: &[u32; RAYS]) -> [Vectors; 3] {
        let [a, b, c] = &self.corners;
        [a.of(places), b.of(places), c.of(places)]
    }

    /// The light it sends out.
    #[inline(always)]
    pub(super) fn emission(&self, triangle: u32) -> Emission {
        let both_sides = self.both_sides[triangle as usize % MOST];
        Emission { radiance: self.radiance.at(triangle), both_sides }
    }

    /// Whether it glows and is never looked at.
    #[inline(always)]
    pub(super) fn is_stray(&self, triangle: u32) -> bool {
        self.stray[triangle as usize % MOST]
    }
}
