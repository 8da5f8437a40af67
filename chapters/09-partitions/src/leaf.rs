//! The one leaf test: whatever brings a ray to some triangles, this asks them.

use common::tally::Tally;
use glam::Vec3;
use ray_casting::ray::Ray;
use triangles::area::has_area;
use triangles::brute::{Found, TRIANGLE_TESTS};
use triangles::intersect::TriangleTest;
use triangles::watertight::ShearedRay;

// ANCHOR: stored
/// A triangle as a leaf holds it: its corners beside its neighbours', and its place in the list it
/// came from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stored {
    /// The corners.
    pub corners: [Vec3; 3],
    /// The place in the list.
    pub index: u32,
}
// ANCHOR_END: stored

// ANCHOR: hittable
/// The triangles that a ray can hit at all, in their order.
///
/// A corner that is NaN or infinite spoils the edge functions of its triangle, and the watertight
/// test rejects it. Left in, it would spoil the box around all the others too (hard case AC-05).
pub fn hittable(triangles: &[[Vec3; 3]]) -> Vec<Stored> {
    let can_be_hit =
        |corners: &[Vec3; 3]| corners.iter().all(|corner| corner.is_finite()) && has_area(corners);
    let numbered = (0..).zip(triangles.iter().copied());
    numbered
        .filter(|(_, corners)| can_be_hit(corners))
        .map(|(index, corners)| Stored { corners, index })
        .collect()
}
// ANCHOR_END: hittable

// ANCHOR: question
/// A question about a ray that is put to one triangle after another.
pub trait Question {
    /// Asks one triangle.
    fn ask(&mut self, triangle: &Stored);

    /// Whether no further triangle can change the answer.
    fn answered(&self) -> bool;

    /// Hits farther away than this are of no interest.
    fn limit(&self) -> f32;

    /// Asks the triangles of a leaf until the question is answered, and counts them.
    #[inline]
    fn ask_all<T: Tally>(&mut self, leaf: &[Stored], tally: &mut T) {
        for triangle in leaf {
            tally.count(TRIANGLE_TESTS, 1);
            self.ask(triangle);
            if self.answered() {
                return;
            }
        }
    }
}
// ANCHOR_END: question

// ANCHOR: nearest
/// "Which triangle does the ray hit first?"
#[derive(Clone, Copy, Debug)]
pub struct NearestHit {
    ray: ShearedRay,
    /// A hit has to be nearer than this.
    bound: f32,
    found: Option<Found>,
}

impl Question for NearestHit {
    /// Asks for what is nearer than the best hit so far, or as near: then the triangle that comes
    /// first in the list has it, whichever was asked first. A triangle that is asked twice gives
    /// the same answer twice, and changes nothing.
    #[inline]
    fn ask(&mut self, triangle: &Stored) {
        let Some(hit) = self.ray.hit(&triangle.corners, self.bound) else { return };
        let index = triangle.index as usize;
        let better = |best: &Found| (hit.t, index) < (best.hit.t, best.index);
        if self.found.as_ref().is_none_or(better) {
            self.found = Some(Found { hit, index });
            self.bound = hit.t.next_up();
        }
    }
    // ANCHOR_END: nearest

    #[inline]
    fn answered(&self) -> bool {
        false
    }

    #[inline]
    fn limit(&self) -> f32 {
        self.bound
    }
}

impl NearestHit {
    /// The question for hits with `0 < t < t_max`. None for a ray that hits nothing whatever there
    /// is: one without a direction, or not finite.
    pub fn new(ray: &Ray, t_max: f32) -> Option<Self> {
        ShearedRay::prepare(ray).map(|ray| Self { ray, bound: t_max, found: None })
    }

    /// The nearest hit among all that were asked.
    pub fn found(&self) -> Option<Found> {
        self.found
    }
}

/// "Does the ray hit anything?"
#[derive(Clone, Copy, Debug)]
pub struct AnyHit {
    ray: ShearedRay,
    bound: f32,
    hit: bool,
}

impl AnyHit {
    /// The question for hits with `0 < t < t_max`; None as for [`NearestHit::new`].
    pub fn new(ray: &Ray, t_max: f32) -> Option<Self> {
        ShearedRay::prepare(ray).map(|ray| Self { ray, bound: t_max, hit: false })
    }
}

impl Question for AnyHit {
    #[inline]
    fn ask(&mut self, triangle: &Stored) {
        self.hit = self.hit || self.ray.hit(&triangle.corners, self.bound).is_some();
    }

    #[inline]
    fn answered(&self) -> bool {
        self.hit
    }

    #[inline]
    fn limit(&self) -> f32 {
        self.bound
    }
}

#[cfg(test)]
mod tests {
    use common::tally::{Counts, Off};
    use glam::Vec3;
    use ray_casting::ray::Ray;
    use triangles::brute::TRIANGLE_TESTS;

    use super::{AnyHit, NearestHit, Question, Stored, hittable};

    const RAY: Ray = Ray { origin: Vec3::new(0.3, 0.2, 5.0), direction: Vec3::new(0.0, 0.0, -2.0) };

    fn at(z: f32, index: u32) -> Stored {
        let corners = [(-1.0, -1.0), (4.0, -1.0), (0.0, 3.0)].map(|(x, y)| Vec3::new(x, y, z));
        Stored { corners, index }
    }

    /// AC-12: the lowest index of those at the same distance, in whichever order they are asked.
    #[test]
    fn of_equal_distances_the_first_in_the_list_wins() {
        let mut leaf = [at(1.0, 4), at(2.0, 7), at(2.0, 3), at(2.0, 9), at(0.0, 1), at(2.0, 3)];
        for _ in 0..leaf.len() {
            let mut question = NearestHit::new(&RAY, f32::INFINITY).expect("an ordinary ray");
            question.ask_all(&leaf, &mut Off);
            let found = question.found().expect("it meets them all");
            assert_eq!((found.index, found.hit.t), (3, 1.5));
            leaf.rotate_left(1);
        }
    }

    #[test]
    fn the_limit_itself_is_out_of_reach() {
        let answer = |t_max| {
            let mut question = NearestHit::new(&RAY, t_max).expect("an ordinary ray");
            question.ask_all(&[at(2.0, 0)], &mut Off);
            question.found().is_some()
        };
        assert!(!answer(1.5) && answer(1.5_f32.next_up()) && !answer(f32::NAN) && !answer(-1.0));
    }

    #[test]
    fn any_hit_will_do_and_the_rest_is_not_asked() {
        let mut counts = Counts::default();
        let mut question = AnyHit::new(&RAY, f32::INFINITY).expect("an ordinary ray");
        question.ask_all(&[at(9.0, 0), at(1.0, 1), at(2.0, 2)], &mut counts);
        assert!(question.answered());
        assert_eq!(counts.of(TRIANGLE_TESTS), 2, "the first is behind the eye");
    }

    #[test]
    fn what_no_ray_can_hit_is_left_out() {
        let good = at(1.0, 0).corners;
        let line = [Vec3::ZERO, Vec3::ONE, 3.0 * Vec3::ONE];
        let mut broken = good;
        broken[1].y = f32::NAN;
        let mut endless = good;
        endless[2].x = f32::NEG_INFINITY;
        let kept = hittable(&[line, good, broken, endless, good]);
        assert_eq!(kept.iter().map(|it| it.index).collect::<Vec<_>>(), [1, 4]);
    }
}
