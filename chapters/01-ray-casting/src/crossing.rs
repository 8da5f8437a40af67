//! Where a line goes into a surface and out of it.

/// Where a line crosses a surface twice, in lengths of its direction; either may be negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The smaller distance: into the sphere.
    pub enter: f32,
    /// The larger distance: out of it.
    pub leave: f32,
}

impl Crossing {
    /// The crossing at these two distances, in whichever order; None when they are not numbers, as
    /// for a line that touches the sphere in the ray's own origin.
    pub fn sorted(first: f32, second: f32) -> Option<Self> {
        if first <= second {
            Some(Self { enter: first, leave: second })
        } else if second < first {
            Some(Self { enter: second, leave: first })
        } else {
            None
        }
    }

    // ANCHOR: first
    /// The first of the two distances with `0 < t < t_max`.
    pub fn first(&self, t_max: f32) -> Option<f32> {
        [self.enter, self.leave].into_iter().find(|&t| 0.0 < t && t < t_max)
    }
    // ANCHOR_END: first
}
