//! What glass is, and what a surface is made of in this chapter.

use whitted::material::Mirrored;

use crate::conductor::Metal;
use crate::index::Index;

// ANCHOR: glass
/// A body that light goes through. It absorbs nothing, and its surface has no light of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glass {
    /// How many times slower light is inside.
    pub index: Index,
    /// Where two bodies overlap there is the one whose rank is higher; of equal rank, the one that
    /// was entered last.
    pub rank: u8,
}
// ANCHOR_END: glass

impl Glass {
    /// Glass of ordinary rank.
    pub fn new(index: Index) -> Self {
        Self { index, rank: 0 }
    }

    /// The same with another rank.
    pub fn ranked(self, rank: u8) -> Self {
        Self { rank, ..self }
    }
}

// ANCHOR: surface
/// What a surface is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surface {
    /// It returns lamps' light, and perhaps mirrors.
    Opaque(Mirrored),
    /// The same, but what it mirrors grows with the angle, by Schlick's approximation.
    Polished(Mirrored),
    /// It reflects, in its own colour, and absorbs the rest.
    Metal(Metal),
    /// It reflects, and lets the rest through.
    Glass(Glass),
}
// ANCHOR_END: surface

impl Surface {
    /// The glass, if it is glass.
    pub fn glass(&self) -> Option<&Glass> {
        match self {
            Self::Glass(glass) => Some(glass),
            Self::Opaque(_) | Self::Polished(_) | Self::Metal(_) => None,
        }
    }
}
