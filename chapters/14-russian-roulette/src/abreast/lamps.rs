//! Lamps, of which each path chooses one.

use light_sampling::lights::Lights;
use monte_carlo::table::{Pick, slot};
use triangles::bundle::{Floats, RAYS};
use triangles::few::MOST;

/// The lamps that are looked at.
#[derive(Clone, Debug)]
pub(super) struct Lamps {
    /// For each lamp the first slot after its own.
    ends: Vec<u32>,
    /// For each lamp its first slot, how many it has, its place among the triangles, and its area.
    start: [u32; MOST],
    slots: [u32; MOST],
    triangle: [u32; MOST],
    area: [f32; MOST],
}

/// A lamp for each path.
pub(super) struct Chosen {
    /// Its place among the triangles.
    pub(super) triangle: [u32; RAYS],
    /// Its area.
    pub(super) area: [f32; RAYS],
    /// The probability with which it was chosen.
    pub(super) probability: [f32; RAYS],
    /// What is left of the number that chose it.
    pub(super) rest: [f32; RAYS],
}

impl Lamps {
    /// The lamps. `None` if there is none to choose, or more than [`MOST`].
    pub(super) fn new(lights: &Lights) -> Option<Self> {
        let count = lights.lamps().len();
        let table = lights.table().filter(|_| count <= MOST)?;
        let mut lamps = Self {
            ends: Vec::new(),
            start: [0; MOST],
            slots: [1; MOST],
            triangle: [0; MOST],
            area: [0.0; MOST],
        };
        for (lamp, it) in lights.lamps().iter().enumerate() {
            (lamps.start[lamp], lamps.slots[lamp]) = table.slots(lamp);
            lamps.ends.push(lamps.start[lamp] + lamps.slots[lamp]);
            lamps.area[lamp] = it.area();
        }
        for piece in 0..MOST {
            if let Some(lamp) = lights.number(piece) {
                lamps.triangle[lamp] = piece as u32;
            }
        }
        Some(lamps)
    }

    /// The lamps in whose slots the numbers `u` lie.
    #[inline(always)]
    pub(super) fn choose(&self, u: &Floats) -> Chosen {
        let mut lamp = [0; RAYS];
        for &end in &self.ends {
            for path in 0..RAYS {
                lamp[path] += u32::from(end <= slot(u[path]));
            }
        }
        let mut chosen = Chosen {
            triangle: [0; RAYS],
            area: [0.0; RAYS],
            probability: [0.0; RAYS],
            rest: [0.0; RAYS],
        };
        for path in 0..RAYS {
            let lamp = lamp[path] as usize % MOST;
            let pick = Pick::of_slot(lamp, slot(u[path]), self.start[lamp], self.slots[lamp]);
            chosen.triangle[path] = self.triangle[lamp];
            chosen.area[path] = self.area[lamp];
            chosen.probability[path] = pick.probability;
            chosen.rest[path] = pick.rest;
        }
        chosen
    }
}
