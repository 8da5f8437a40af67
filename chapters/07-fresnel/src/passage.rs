//! The next thing on a ray's way that light notices: a surface, or an interface of two media.
//!
//! A surface of glass that has the same medium before it and behind is none. Such a surface lies
//! inside a body of higher rank, or has an index equal to its surroundings'. The ray goes on as if
//! nothing were there: the same ray, its origin and direction unchanged to the bit.

use blinn_phong::object::Object;
use blinn_phong::scene::Scene;
use common::tally::Tally;
use ray_casting::ray::Ray;
use ray_casting::shape::{Hit, Nearest};
use shadows::spawn::spawn;

use crate::glass::{Glass, Surface};
use crate::index::Index;
use crate::inside::Inside;
use crate::interface::Interface;

// ANCHOR: met
/// What a ray meets.
#[derive(Debug)]
pub enum Met<'a> {
    /// A surface that light doesn't enter.
    Surface {
        /// Where.
        hit: Hit,
        /// What it is made of.
        surface: &'a Surface,
        /// The bodies that the ray is in.
        inside: Inside,
    },
    /// Two media.
    Interface {
        /// Where, with the errors of all the surfaces that are crossed at once.
        hit: Hit,
        /// Which.
        interface: Interface,
        /// The bodies on this side, and beyond.
        sides: [Inside; 2],
    },
}
// ANCHOR_END: met

/// How many surfaces that are no interfaces a ray passes at most.
const MOST_PASSED: u32 = 256;

/// The smallest cosine that a distance from a plane is divided by to make one along the ray.
const GRAZING: f32 = 1.0 / 1024.0;

// ANCHOR: next
/// The first thing on the ray's way that light notices. The ray is inside of `inside`.
pub fn next<'a, T: Tally>(
    scene: &'a Scene<Surface>,
    ray: &Ray,
    mut inside: Inside,
    tally: &mut T,
) -> Option<Met<'a>> {
    let mut after = 0.0;
    for _ in 0..MOST_PASSED {
        let found = beyond(scene, ray, after, tally)?;
        if found.object.material.glass().is_none() {
            let surface = &found.object.material;
            return Some(Met::Surface { hit: found.hit, surface, inside });
        }
        let event = Event::at(scene, ray, after, found, tally);
        if let Some(surface) = event.opaque {
            return Some(Met::Surface { hit: event.hit, surface, inside });
        }
        let sides = event.sides(inside);
        let [near, far] = sides.map(|inside| index(scene, inside));
        let interface = Interface::new(near, far);
        if !interface.is_none() {
            return Some(Met::Interface { hit: event.hit, interface, sides });
        }
        // Nothing to see here.
        inside = sides[1];
        after = event.last.max(after.next_up());
    }
    None
}
// ANCHOR_END: next

/// The index of the medium inside of `inside`.
pub fn index(scene: &Scene<Surface>, inside: Inside) -> Index {
    inside.index(|body| glass(scene, body))
}

fn glass(scene: &Scene<Surface>, body: u32) -> Option<Glass> {
    scene.objects.get(body as usize).and_then(|object| object.material.glass()).copied()
}

// ANCHOR: event
/// What happens at one point of a ray: all surfaces that lie there, within their rounding errors.
struct Event<'a> {
    hit: Hit,
    /// Where along the ray the last of them is.
    last: f32,
    /// The bodies whose surfaces they are.
    crossed: Inside,
    /// Those of them that the ray goes into.
    entered: Inside,
    /// A surface among them that ends the ray.
    opaque: Option<&'a Surface>,
}

impl<'a> Event<'a> {
    /// The event at the surface that was found.
    ///
    /// The next ray starts beside the surface by more than its rounding error, and so beyond any
    /// other surface that lies within it: a liquid that touches its glass. What is leapt over has to
    /// be counted here.
    fn at<T: Tally>(
        scene: &'a Scene<Surface>,
        ray: &Ray,
        after: f32,
        found: Nearest<'a, Object<Surface>>,
        tally: &mut T,
    ) -> Self {
        let Nearest { hit, index, object } = found;
        let nothing = Inside::default();
        let mut event = Self { hit, last: hit.t, crossed: nothing, entered: nothing, opaque: None };
        event.add(ray, index, object, &hit);

        // Twice the error of the first surface, and as much again for the second, of which it is
        // not known yet: from a distance to the plane to one along the ray.
        let least = GRAZING * ray.direction.length();
        let slope = ray.direction.dot(hit.geometric).abs().max(least);
        let limit = hit.t + 4.0 * hit.geometric.abs().dot(hit.error) / slope;
        let mut others = scene.objects.iter().enumerate().filter(|other| other.0 != index);
        while event.opaque.is_none()
            && let Some((other, object)) = others.next()
        {
            if let Some(second) = after_of(object, ray, after, limit, tally) {
                event.hit.error += second.error;
                event.add(ray, other, object, &second);
            }
        }
        event
    }
    // ANCHOR_END: event

    fn add(&mut self, ray: &Ray, index: usize, object: &'a Object<Surface>, hit: &Hit) {
        self.last = self.last.max(hit.t);
        if object.material.glass().is_none() {
            self.hit = *hit;
            self.opaque = Some(&object.material);
            return;
        }
        let body = index as u32;
        self.crossed = self.crossed.with(body);
        if ray.direction.dot(hit.geometric) < 0.0 {
            self.entered = self.entered.with(body);
        }
    }

    // ANCHOR: sides
    /// The bodies on this side and beyond, for a ray that is inside of `inside`.
    ///
    /// What the ray remembers counts for more than what it meets. Entering a body that it is in, or
    /// leaving one that it is not in, is meeting once more a surface that it has left by less than
    /// a rounding error; both sides are the same then, and it goes on.
    fn sides(&self, inside: Inside) -> [Inside; 2] {
        let beyond = self.crossed.bodies().iter().fold(inside, |beyond, &body| {
            let entered = self.entered.bodies().contains(&body);
            if entered { beyond.with(body) } else { beyond.without(body) }
        });
        [inside, beyond]
    }
    // ANCHOR_END: sides
}

// ANCHOR: beyond
/// What the ray meets first at a distance above `after`.
fn beyond<'a, T: Tally>(
    scene: &'a Scene<Surface>,
    ray: &Ray,
    after: f32,
    tally: &mut T,
) -> Option<Nearest<'a, Object<Surface>>> {
    if after == 0.0 {
        return scene.nearest(ray, tally);
    }
    let mut nearest: Option<Nearest<Object<Surface>>> = None;
    for (index, object) in scene.objects.iter().enumerate() {
        let limit = nearest.as_ref().map_or(f32::INFINITY, |nearest| nearest.hit.t);
        let hit = after_of(object, ray, after, limit, tally);
        nearest = hit.map(|hit| Nearest { hit, index, object }).or(nearest);
    }
    nearest
}

/// The object's first hit with `after < t < limit`.
///
/// Only an object that was passed already is asked from another origin than the ray's own, so what
/// lies behind has the hits it would have without that object, to the bit.
fn after_of<T: Tally>(
    object: &Object<Surface>,
    ray: &Ray,
    after: f32,
    limit: f32,
    tally: &mut T,
) -> Option<Hit> {
    let mut hit = ask(object, ray, limit, tally)?;
    let mut passed = 0;
    while hit.t <= after {
        passed += 1;
        if passed == MOST_PASSED {
            return None;
        }
        let start = Ray { origin: spawn(&hit, ray.direction), ..*ray };
        let found = ask(object, &start, limit - hit.t, tally)?;
        hit = Hit { t: hit.t + found.t, ..found };
    }
    Some(hit)
}
// ANCHOR_END: beyond

fn ask<T: Tally>(object: &Object<Surface>, ray: &Ray, limit: f32, tally: &mut T) -> Option<Hit> {
    match tally.counts() {
        Some(counts) => object.shape.hit_counted(ray, limit, counts),
        None => object.shape.hit(ray, limit),
    }
}
