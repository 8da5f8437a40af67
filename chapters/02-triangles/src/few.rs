//! A few triangles, asked about sixteen rays at once.
//!
//! [`crate::lanes`] asks four triangles about one ray. Where there are many rays and few triangles it is
//! better the other way round: a corner that triangles share is brought into a ray's coordinates once
//! for all of them, and nothing has to be searched. The arithmetic is that of the watertight test,
//! operation by operation, so the answers are the same to the last bit.

use glam::Vec3;

use crate::area::has_area;
use crate::bundle::{Bundle, RAYS, Vectors};
use crate::nearest::{Best, NONE, Nearest};
use crate::watertight::measure;

/// The most triangles, and the most corners: what fits the fastest of the processor's caches.
pub const MOST: usize = 64;

/// A few triangles, and each of their corners once.
#[derive(Clone, Debug)]
pub struct Few {
    corners: Vec<Vec3>,
    /// Of each triangle that can be hit, the places of its corners.
    triangles: Vec<[u32; 3]>,
    /// Its place in the list it came from.
    places: [u32; MOST],
}

/// Room for the corners in the coordinates of all rays. What is in it before doesn't matter.
pub type Sheared = [Vectors; MOST];

/// The triangles that a ray may hit, a bit for each.
type Candidates = [[u32; RAYS]; GROUPS];

/// A bit for each triangle of a group.
const GROUP: usize = u32::BITS as usize;
const GROUPS: usize = MOST / GROUP;

impl Few {
    /// These triangles. `None` if they, or their corners, are more than [`MOST`].
    pub fn new(triangles: &[[Vec3; 3]]) -> Option<Self> {
        let mut few = Self { corners: Vec::new(), triangles: Vec::new(), places: [NONE; MOST] };
        for (place, triangle) in (0..).zip(triangles) {
            let finite = triangle.iter().all(|corner| corner.is_finite());
            if !(finite && has_area(triangle)) {
                continue;
            }
            *few.places.get_mut(few.triangles.len())? = place;
            let corners = triangle.map(|corner| few.corner(corner));
            few.triangles.push(corners);
        }
        (few.corners.len() <= MOST).then_some(few)
    }

    /// The place of this corner, which is added if it is new.
    fn corner(&mut self, corner: Vec3) -> u32 {
        let bits = |vector: Vec3| vector.to_array().map(f32::to_bits);
        let known = self.corners.iter().position(|it| bits(*it) == bits(corner));
        known.unwrap_or_else(|| {
            self.corners.push(corner);
            self.corners.len() - 1
        }) as u32
    }

    /// How many triangles can be hit.
    pub fn len(&self) -> usize {
        self.triangles.len()
    }

    /// Whether nothing can be hit.
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// What each ray hits first; of several at the same distance, the one that comes first in the list.
    #[inline(always)]
    pub fn nearest(&self, bundle: &Bundle, sheared: &mut Sheared) -> Nearest {
        self.best::<false>(bundle, f32::INFINITY, sheared).nearest(&self.places)
    }

    /// Whether each ray hits anything before t = 1.
    #[inline(always)]
    pub fn blocked(&self, bundle: &Bundle, sheared: &mut Sheared) -> [bool; RAYS] {
        self.best::<true>(bundle, 1.0, sheared).is_any()
    }

    /// The best hits before `limit`, which is 1 for `SHORT` rays.
    #[inline(always)]
    fn best<const SHORT: bool>(&self, bundle: &Bundle, limit: f32, sheared: &mut Sheared) -> Best {
        for (sheared, corner) in sheared.iter_mut().zip(&self.corners) {
            *sheared = bundle.shear(*corner);
        }
        let mut best = Best::new(limit);
        let mut candidates = self.candidates::<SHORT>(bundle, sheared);
        for (group, candidates) in candidates.iter_mut().enumerate() {
            while candidates.iter().any(|&left| left != 0) {
                self.ask(group, candidates, bundle, sheared, &mut best);
            }
        }
        best
    }

    // ANCHOR: candidates
    /// What may be hit. Of the rest, `f32` edge functions of different signs prove that it is missed, or
    /// all its corners lie behind the origin, or, for `SHORT` rays, none lies before t = 1.
    #[inline(always)]
    fn candidates<const SHORT: bool>(&self, bundle: &Bundle, sheared: &Sheared) -> Candidates {
        let mut candidates = [[0; RAYS]; GROUPS];
        for (candidates, triangles) in candidates.iter_mut().zip(self.triangles.chunks(GROUP)) {
            for (bit, triangle) in triangles.iter().enumerate() {
                let flag = 1 << bit;
                let corner = |number: usize| &sheared[triangle[number] as usize % MOST];
                let (a, b, c) = (corner(0), corner(1), corner(2));
                for ray in 0..RAYS {
                    let (u, v, w) = (edge(b, c, ray), edge(c, a, ray), edge(a, b, ray));
                    let negative = (u < 0.0) | (v < 0.0) | (w < 0.0);
                    let positive = (u > 0.0) | (v > 0.0) | (w > 0.0);
                    // Exact: only signs change.
                    let advance = bundle.advance[ray];
                    let sign = 1f32.copysign(advance);
                    let (d, e, f) = (a.z[ray] * sign, b.z[ray] * sign, c.z[ray] * sign);
                    let ahead = (d > 0.0) | (e > 0.0) | (f > 0.0);
                    let end = advance.abs();
                    let near = (d < end) | (e < end) | (f < end);
                    let may = !(negative & positive) & ahead & (near | !SHORT) & !bundle.idle[ray];
                    candidates[ray] |= if may { flag } else { 0 };
                }
            }
        }
        candidates
    }
    // ANCHOR_END: candidates

    /// Measures one candidate of each ray that has any, and takes it out.
    #[inline(always)]
    fn ask(
        &self,
        group: usize,
        candidates: &mut [u32; RAYS],
        bundle: &Bundle,
        sheared: &Sheared,
        best: &mut Best,
    ) {
        let mut asked = [NONE; RAYS];
        let mut corners = [Vectors::ZERO; 3];
        for ray in 0..RAYS {
            let left = candidates[ray];
            let triangle = (group * GROUP) as u32 + left.trailing_zeros();
            asked[ray] = if left == 0 { NONE } else { triangle };
            candidates[ray] = left & left.wrapping_sub(1);
        }
        for ray in 0..RAYS {
            let Some(triangle) = self.triangles.get(asked[ray] as usize) else { continue };
            for (corner, place) in corners.iter_mut().zip(triangle) {
                corner.set(ray, sheared[*place as usize % MOST].at(ray));
            }
        }
        for ray in 0..RAYS {
            let corners = [corners[0].at(ray), corners[1].at(ray), corners[2].at(ray)];
            let measured = measure(bundle.advance[ray], corners, best.t[ray]);
            best.take(ray, asked[ray], measured);
        }
    }
}

/// Twice the area that the origin spans with p and q, as the watertight test has it.
#[inline(always)]
fn edge(p: &Vectors, q: &Vectors, ray: usize) -> f32 {
    p.x[ray] * q.y[ray] - p.y[ray] * q.x[ray]
}

#[cfg(test)]
mod tests {
    use common::sampler::Stream;
    use glam::Vec3;
    use ray_casting::ray::Ray;

    use super::{Few, MOST};
    use crate::brute::nearest;
    use crate::bumpy;
    use crate::bundle::{Bundle, RAYS, Vectors};
    use crate::hard::aimed::NEAR;
    use crate::watertight::ShearedRay;

    fn bundle(rays: &[Ray; RAYS]) -> Bundle {
        let origin = Vectors::of(|ray| rays[ray].origin);
        let direction = Vectors::of(|ray| rays[ray].direction);
        Bundle::new(&origin, &direction, &[true; RAYS])
    }

    /// Rays at points near the middle, among them some along an axis and some through corners.
    fn rays(triangles: &[[Vec3; 3]], stream: &mut Stream) -> [Ray; RAYS] {
        std::array::from_fn(|number| {
            let mut point = |side: f32| {
                let mut component = || stream.between(-side, side);
                Vec3::new(component(), component(), component())
            };
            let (origin, target) = (point(3.0), point(0.9));
            let direction = match number % 4 {
                0 => triangles[number % triangles.len()][number % 3] - origin,
                1 => Vec3::AXES[number % 3] * 0.5,
                _ => target - origin,
            };
            Ray { origin, direction }
        })
    }

    #[test]
    fn sixteen_at_once_find_what_one_finds() {
        let ball = bumpy::sphere(60).all_corners();
        let meshes =
            [&ball[..], &NEAR[0].corners[..NEAR[0].corners.len().min(40)], &ball[..33], &ball[..1]];
        let (mut hits, mut sheared) = (0, [Vectors::ZERO; MOST]);
        for trial in 0..4000 {
            let triangles = meshes[trial % meshes.len()];
            let few = Few::new(triangles).expect("few enough");
            let mut stream = Stream::of_trial(216, trial as u64);
            let rays = rays(triangles, &mut stream);
            let bundle = bundle(&rays);
            let (found, blocked) =
                (few.nearest(&bundle, &mut sheared), few.blocked(&bundle, &mut sheared));
            for (number, ray) in rays.iter().enumerate() {
                let expected = nearest::<ShearedRay>(triangles, ray, f32::INFINITY);
                assert_eq!(found.found(number), expected, "{trial} {number}");
                let near = nearest::<ShearedRay>(triangles, ray, 1.0).is_some();
                assert_eq!(blocked[number], near, "{trial} {number}");
                hits += u32::from(near);
            }
        }
        assert!(hits > 5_000, "{hits}");
    }

    #[test]
    fn more_than_a_few_are_refused_and_what_can_t_be_hit_is_left_out() {
        let ball = bumpy::sphere(1000).all_corners();
        assert!(Few::new(&ball).is_none(), "{} triangles", ball.len());
        // Few triangles, but none of them shares a corner.
        let apart = |number: u8| {
            let x = f32::from(number);
            [Vec3::new(x, 0.0, 0.0), Vec3::new(x, 1.0, 0.0), Vec3::new(x, 0.0, 1.0)]
        };
        assert!(Few::new(&(0..21).map(apart).collect::<Vec<_>>()).is_some());
        assert!(Few::new(&(0..22).map(apart).collect::<Vec<_>>()).is_none());
        let line = [Vec3::ZERO, Vec3::X, 2.0 * Vec3::X];
        let few = Few::new(&[line, [Vec3::NAN; 3], apart(2)]).expect("few enough");
        assert_eq!((few.len(), few.is_empty()), (1, false));
        assert!(Few::new(&[]).expect("few enough").is_empty());
    }

    #[test]
    fn rays_that_are_none_hit_nothing() {
        let few = Few::new(&bumpy::sphere(60).all_corners()).expect("few enough");
        let mut sheared = [Vectors::ZERO; MOST];
        let right = Ray { origin: Vec3::new(0.1, 0.2, 3.0), direction: Vec3::new(0.0, 0.0, -9.0) };
        let wrong = [
            Ray { direction: Vec3::ZERO, ..right },
            Ray { direction: Vec3::NAN, ..right },
            Ray { direction: Vec3::X * f32::INFINITY, ..right },
            Ray { origin: Vec3::NAN, ..right },
        ];
        let rays = std::array::from_fn(|number| *wrong.get(number).unwrap_or(&right));
        let bundle = bundle(&rays);
        let (found, blocked) =
            (few.nearest(&bundle, &mut sheared), few.blocked(&bundle, &mut sheared));
        for (number, blocked) in blocked.into_iter().enumerate() {
            let is_right = number >= wrong.len();
            assert_eq!((found.found(number).is_some(), blocked), (is_right, is_right), "{number}");
        }
        let origin = Vectors::of(|_| right.origin);
        let unused = Bundle::new(&origin, &Vectors::of(|_| right.direction), &[false; RAYS]);
        assert_eq!(few.blocked(&unused, &mut sheared), [false; RAYS]);
        assert!((0..RAYS).all(|ray| few.nearest(&unused, &mut sheared).found(ray).is_none()));
    }
}
