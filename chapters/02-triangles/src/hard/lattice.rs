//! TR-15 and X-07: what exact whole numbers say.

use common::sampler::Stream;
use glam::Vec3;
use ray_casting::ray::Ray;

use super::shapes::{ask, point};
use crate::intersect::TriangleTest;
use crate::naive::MollerTrumbore;
use crate::watertight::{ShearedRay, exact_edge};

/// A vector of whole numbers.
type Whole = [i128; 3];

fn whole(vector: Vec3) -> Whole {
    vector.to_array().map(|coordinate| coordinate as i128)
}

/// Six times the signed volume between three vectors.
fn volume([a, b, c]: [Whole; 3]) -> i128 {
    let minor = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
    a[0] * minor(1, 2) + a[1] * minor(2, 0) + a[2] * minor(0, 1)
}

/// What whole numbers say of a ray and a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Truth {
    Hit,
    Miss,
    /// The ray passes an edge more closely than `f32` can tell.
    TooClose,
}

/// A ray and a triangle on a lattice: all coordinates are whole numbers below 2^21, and so are the
/// differences, so nothing has been rounded yet. The triangle is long along the ray, and the ray
/// passes near an edge.
fn near_an_edge(trial: u64) -> (Ray, [Vec3; 3]) {
    let mut stream = Stream::of_trial(215, trial);
    let origin = (100_000.0 * point(&mut stream)).round();
    let direction = (100_000.0 * point(&mut stream)).round();
    let on_ray = |stream: &mut Stream| origin + stream.between(0.3, 2.0) * direction;
    let width = [3.0, 300.0, 30_000.0][(trial % 3) as usize];
    let corners = [0, 1, 2].map(|_| (on_ray(&mut stream) + width * point(&mut stream)).round());
    (Ray { origin, direction }, corners)
}

/// The exact answer, unless an edge is too close to call: within eight rounding units of the size
/// of what the edge function multiplies.
fn truth(ray: &Ray, corners: &[Vec3; 3]) -> Truth {
    let direction = whole(ray.direction);
    let offsets = corners.map(|corner| whole(corner - ray.origin));
    let [a, b, c] = offsets;
    let volumes = [volume([direction, b, c]), volume([direction, c, a]), volume([direction, a, b])];
    // The volume is the edge function times the direction's longest coordinate.
    let longest = direction.map(i128::abs).into_iter().max().unwrap_or(0) as f64;
    let reach = offsets.iter().flatten().map(|it| it.abs()).max().unwrap_or(0) as f64;
    let across = offsets.iter().map(|offset| off_axis(offset, &direction)).fold(0.0, f64::max);
    let unit = f64::from(f32::EPSILON) / 2.0;
    let doubt = 8.0 * unit * reach * (across + unit * reach) * longest;
    if volumes.iter().any(|&it| (it as f64).abs() <= doubt) {
        return Truth::TooClose;
    }
    let sides = volumes.map(i128::signum);
    let ahead = volumes.iter().sum::<i128>().signum() * volume([a, b, c]).signum() > 0;
    if sides[0] == sides[1] && sides[1] == sides[2] && ahead { Truth::Hit } else { Truth::Miss }
}

/// How far a point is from the ray's line, measured across the direction's longest axis.
fn off_axis(offset: &Whole, direction: &Whole) -> f64 {
    let longest = (0..3).max_by_key(|&axis| direction[axis].abs()).unwrap_or(0);
    let scale = direction[longest] as f64;
    (0..3)
        .map(|axis| (offset[axis] * direction[longest] - offset[longest] * direction[axis]) as f64)
        .fold(0.0, |far: f64, it| far.max((it / scale).abs()))
}

/// TR-15: whether a clear hit is missed, or a clear miss hit.
fn clearly_wrong<Test: TriangleTest>(trial: u64) -> bool {
    let (ray, corners) = near_an_edge(trial);
    let hit = ask::<Test>(&ray, &corners, f32::INFINITY).is_some();
    match truth(&ray, &corners) {
        Truth::Hit => !hit,
        Truth::Miss => hit,
        Truth::TooClose => false,
    }
}

pub(super) fn clear_naive(trial: u64) -> bool {
    clearly_wrong::<MollerTrumbore>(trial)
}

pub(super) fn clear_robust(trial: u64) -> bool {
    clearly_wrong::<ShearedRay>(trial)
}

/// an edge function of two points nearly in line with the ray, whose products agree in all
/// but the last digits. Whole numbers below 2^24 have exact products in 64 bits.
fn edge_function_wrong(trial: u64, edge: fn(Vec3, Vec3) -> f64) -> bool {
    let mut stream = Stream::of_trial(7, trial);
    let mut digits = || (stream.bits() >> 8).max(1 << 22);
    let (a, b) = (digits(), digits());
    let (c, d) = (near(a, trial), near(b, trial / 3));
    let exact = i64::from(a) * i64::from(b) - i64::from(c) * i64::from(d);
    let p = Vec3::new(a as f32, c as f32, 0.0);
    let q = Vec3::new(d as f32, b as f32, 0.0);
    let error = (edge(p, q) - exact as f64).abs();
    !(error <= f64::from(f32::EPSILON) * exact.abs() as f64)
}

/// A neighbour, at most one away.
fn near(digits: u32, trial: u64) -> u32 {
    (digits + (trial % 3) as u32 - 1).min((1 << 24) - 1)
}

pub(super) fn cancel_naive(trial: u64) -> bool {
    edge_function_wrong(trial, |p, q| f64::from(p.x * q.y - p.y * q.x))
}

pub(super) fn cancel_robust(trial: u64) -> bool {
    edge_function_wrong(trial, exact_edge)
}

#[cfg(test)]
mod tests {
    use super::{Truth, near_an_edge, truth};
    use crate::hard::shapes::ask;
    use crate::watertight::ShearedRay;

    #[test]
    fn the_experiment_has_clear_hits_and_clear_misses() {
        let truths: Vec<Truth> = (0..20_000)
            .map(|trial| {
                let (ray, corners) = near_an_edge(trial);
                truth(&ray, &corners)
            })
            .collect();
        let count = |wanted| truths.iter().filter(|&&truth| truth == wanted).count();
        assert!(count(Truth::Hit) > 500 && count(Truth::Miss) > 5_000);
    }

    /// A ray exactly through an edge of a single triangle may go either way: what must hold is that
    /// it hits one of the two triangles there (TR-02).
    #[test]
    fn exactness_at_a_single_edge_is_not_promised() {
        let misses = (0..30_000).filter(|&trial| {
            let (mut ray, [a, b, c]) = near_an_edge(trial);
            ray.direction = ((a + b) / 2.0).round() - ray.origin;
            let even = (a + b) / 2.0 == ((a + b) / 2.0).round();
            even && ask::<ShearedRay>(&ray, &[a, b, c], f32::INFINITY).is_none()
        });
        assert!(misses.count() > 100);
    }
}
