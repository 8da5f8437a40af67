//! Sixteen paths side by side, each at a bounce of its own.

use common::film::Color;
use common::sampler::{Purpose, Sampler, Samplers};
use common::tally::Tally;
use glam::{Vec2, Vec3};
use monte_carlo::warp::{disk, hemisphere};
use path_tracing::random::{DIRECTION, Random};
use path_tracing::strategy::Ending;
use path_tracing::tracer::{BOUNCES, LONGEST_PATH};
use path_tracing::vertex::leaving;
use ray_casting::ray::Ray;
use triangles::bundle::{Bundle, Floats, RAYS, Vectors};
use triangles::few::{MOST, Sheared};

use super::column::is_some;
use super::fresh::Fresh;
use super::room::Room;
use super::sights::Sights;
use super::vertices::Vertices;
use super::waiting::{Sight, Waiting};

/// What is the same for all paths.
pub(super) struct Tracer<'a, E> {
    pub(super) room: &'a Room,
    pub(super) ending: E,
    pub(super) depth: u32,
}

/// Sixteen paths. One that ends makes room for another, so all are busy as long as there are any.
pub(super) struct Paths {
    /// Whether there is a path.
    pub(super) used: [bool; RAYS],
    /// The sample it is for.
    sample: [usize; RAYS],
    samplers: Samplers<RAYS>,
    pub(super) bounce: [u32; RAYS],
    origin: Vectors,
    pub(super) direction: Vectors,
    pub(super) throughput: Vectors,
    sheared: Sheared,
}

impl Paths {
    /// No path yet.
    pub(super) fn new() -> Self {
        Self {
            used: [false; RAYS],
            sample: [0; RAYS],
            samplers: Samplers::splat(Sampler::new(0, 0, 0, 1)),
            bounce: [0; RAYS],
            origin: Vectors::ZERO,
            direction: Vectors::ZERO,
            throughput: Vectors::ZERO,
            sheared: [Vectors::ZERO; MOST],
        }
    }

    /// Starts a path at the eye: number `number` of the fresh ones.
    #[inline(always)]
    pub(super) fn start(&mut self, path: usize, sample: usize, fresh: &Fresh, number: usize) {
        self.used[path] = true;
        self.sample[path] = sample;
        self.samplers.set(path, fresh.samplers.at(number));
        self.bounce[path] = 0;
        self.origin.set(path, fresh.origin.at(number));
        self.direction.set(path, fresh.direction.at(number));
        self.throughput.set(path, Color::ONE);
    }

    /// Follows each path to the next surface. Those that end there are no longer used.
    #[inline(always)]
    pub(super) fn step<E: Ending, T: Tally>(
        &mut self,
        tracer: &Tracer<E>,
        waiting: &mut Waiting,
        colors: &mut [Color],
        tally: &mut T,
    ) {
        let few = &tracer.room.few;
        let rays = Bundle::new(&self.origin, &self.direction, &self.used);
        let nearest = few.nearest(&rays, &mut self.sheared);
        let vertices = Vertices::new(self, tracer, &nearest);
        vertices.count(self, tracer, tally);
        self.meet_lamps(tracer.room, &vertices, waiting, colors);

        let sights = Sights::new(self, tracer.room, &vertices);
        sights.wait(&self.sample, waiting, tally);
        while waiting.is_full() {
            waiting.ask(few, colors, tally);
        }
        self.turn(tracer, &vertices);
        self.count(tally);
    }

    /// The light of lamps that the paths came upon: seen by the eye, or never looked at. What is found
    /// later waits until all that was found before has been added.
    #[inline(always)]
    fn meet_lamps(
        &self,
        room: &Room,
        vertices: &Vertices,
        waiting: &mut Waiting,
        colors: &mut [Color],
    ) {
        let mut light = Vectors::ZERO;
        for path in 0..RAYS {
            let triangle = vertices.triangle[path];
            let counts = vertices.met[path] & ((self.bounce[path] == 0) | room.is_stray(triangle));
            let emitted = room.emission(triangle).towards(vertices.height[path]);
            let found = if counts { self.throughput.at(path) * emitted } else { Color::ZERO };
            light.set(path, found);
        }
        for path in 0..RAYS {
            let (sample, light) = (self.sample[path], light.at(path));
            if !is_some(light) {
                continue;
            }
            if self.bounce[path] == 0 {
                colors[sample] += light;
            } else {
                waiting.push(Sight { sample, origin: Vec3::ZERO, way: Vec3::ZERO, light });
            }
        }
    }

    /// How each path goes on.
    #[inline(always)]
    fn turn<E: Ending>(&mut self, tracer: &Tracer<E>, vertices: &Vertices) {
        let up = self.directions();
        let (mut survives, mut factor) = ([false; RAYS], [0.0; RAYS]);
        for path in 0..RAYS {
            let throughput = self.throughput.at(path) * vertices.reflectance.at(path);
            let bounce = self.bounce[path] + 1;
            let random = self.random(path);
            let counts = tracer.ending.factor(throughput, bounce, &random);
            survives[path] = counts.is_some();
            factor[path] = counts.unwrap_or(0.0);
        }
        for path in 0..RAYS {
            let weight = vertices.reflectance.at(path);
            let throughput = self.throughput.at(path) * weight * factor[path];
            let up = up.at(path);
            let incoming = up.with_z(up.z.copysign(vertices.height[path]));
            let ray = leaving(&vertices.hit(path), &vertices.frame(path), incoming);
            let carries = survives[path] & is_some(throughput);
            let goes_on = vertices.spreads[path] & carries & ray.is_some();
            let ray = ray.unwrap_or(Ray { origin: Vec3::ZERO, direction: Vec3::ZERO });
            self.used[path] = goes_on;
            self.bounce[path] += u32::from(goes_on);
            self.origin.set(path, ray.origin);
            self.direction.set(path, ray.direction);
            self.throughput.set(path, throughput);
        }
    }

    /// Directions as dense as the cosine, for surfaces whose normal is z.
    #[inline(always)]
    fn directions(&self) -> Vectors {
        let u = self.pairs(DIRECTION);
        let (mut radius, mut angle) = ([0.0; RAYS], [0.0; RAYS]);
        for path in 0..RAYS {
            let u = Vec2::new(u[0][path], u[1][path]);
            (radius[path], angle[path]) = disk::radius_and_angle(u);
        }
        let (mut x, mut y) = ([0.0; RAYS], [0.0; RAYS]);
        for path in 0..RAYS {
            let direction = disk::direction(angle[path]);
            (x[path], y[path]) = (direction.x, direction.y);
        }
        Vectors::of(|path| hemisphere::raised(radius[path] * Vec2::new(x[path], y[path])))
    }

    /// Two numbers for each path and one purpose.
    #[inline(always)]
    pub(super) fn pairs(&self, purpose: Purpose) -> [Floats; 2] {
        let mut pairs = [[0.0; RAYS]; 2];
        for path in 0..RAYS {
            let pair = self.random(path).pair(purpose);
            (pairs[0][path], pairs[1][path]) = (pair.x, pair.y);
        }
        pairs
    }

    /// The random numbers of a path at the surface it has come to.
    #[inline(always)]
    fn random(&self, path: usize) -> Random {
        Random::at(&self.samplers.at(path), self.bounce[path] + 1)
    }

    /// Counts the paths that go on.
    #[inline(always)]
    fn count<T: Tally>(&self, tally: &mut T) {
        let Some(counts) = tally.counts() else { return };
        let (mut bounces, mut longest) = (0, 0);
        for path in 0..RAYS {
            bounces += u64::from(self.used[path]);
            longest = self.bounce[path].max(longest);
        }
        counts.count(BOUNCES, bounces);
        counts.count(LONGEST_PATH, u64::from(longest));
    }
}
