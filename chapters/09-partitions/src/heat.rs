//! A picture of work: what each ray cost.

use boxes::slab::BOX_TESTS;
use common::film::Color;
use common::render::{Rendering, Settings, render_counted};
use common::tally::{Counts, Event, Tally};
use ray_casting::camera::{CAMERA_RAYS, Camera};
use triangles::brute::TRIANGLE_TESTS;

use crate::accelerator::{Accelerator, CELL_STEPS, NODE_VISITS};

// ANCHOR: work
/// The work of one ray.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Work {
    triangle_tests: u64,
    cell_steps: u64,
    node_visits: u64,
    /// Counted, and not shown: a visit to a node is a test of its box.
    box_tests: u64,
}

impl Tally for Work {
    #[inline]
    fn count(&mut self, event: Event, times: u64) {
        match event {
            TRIANGLE_TESTS => self.triangle_tests += times,
            CELL_STEPS => self.cell_steps += times,
            NODE_VISITS => self.node_visits += times,
            BOX_TESTS => self.box_tests += times,
            _ => {}
        }
    }
    // ANCHOR_END: work

    fn counts(&mut self) -> Option<&mut Counts> {
        None
    }

    fn merge(&mut self, other: &Self) {
        self.triangle_tests += other.triangle_tests;
        self.cell_steps += other.cell_steps;
        self.node_visits += other.node_visits;
        self.box_tests += other.box_tests;
    }
}

/// One ray for each sample of each pixel, coloured by its work.
pub fn draw<T: Tally>(
    accelerator: &impl Accelerator,
    camera: &Camera,
    settings: &Settings,
) -> Rendering<T> {
    render_counted(settings, |pixel, sampler, tally: &mut T| {
        let ray = camera.ray(pixel.position(sampler));
        let mut work = Work::default();
        accelerator.nearest(&ray, f32::INFINITY, &mut work);
        let Work { triangle_tests, cell_steps, node_visits, box_tests } = work;
        tally.count(CAMERA_RAYS, 1);
        tally.count(TRIANGLE_TESTS, triangle_tests);
        tally.count(CELL_STEPS, cell_steps);
        tally.count(NODE_VISITS, node_visits);
        tally.count(BOX_TESTS, box_tests);
        heat(triangle_tests + cell_steps + node_visits)
    })
}

/// The work that is shown as white.
pub const WHITE: u64 = 400;

/// Black for no work, then blue, red, yellow, and white from [`WHITE`] on. By the square root, so
/// that little work can be told from less.
fn heat(work: u64) -> Color {
    const RAMP: [Color; 5] = [
        Color::new(0.0, 0.0, 0.0),
        Color::new(0.02, 0.04, 0.45),
        Color::new(0.75, 0.03, 0.15),
        Color::new(1.0, 0.65, 0.02),
        Color::new(1.0, 1.0, 1.0),
    ];
    let part = (work as f32 / WHITE as f32).sqrt().min(1.0);
    let place = part * (RAMP.len() - 1) as f32;
    let below = (place as usize).min(RAMP.len() - 2);
    RAMP[below].lerp(RAMP[below + 1], place - below as f32)
}

#[cfg(test)]
mod tests {
    use common::film::Color;

    use super::{WHITE, heat};

    #[test]
    fn more_work_is_never_darker() {
        let brightness = |work| heat(work).element_sum();
        assert_eq!((heat(0), heat(WHITE), heat(u64::MAX)), (Color::ZERO, Color::ONE, Color::ONE));
        assert!((0..WHITE).all(|work| brightness(work) <= brightness(work + 1)));
        assert_eq!(heat(WHITE / 4), Color::new(0.75, 0.03, 0.15), "half of the root");
    }
}
