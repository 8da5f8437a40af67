//! Mistakes with several shapes and with a new one: exercises 1.3 and 1.4.

use common::exercise::Mistake;
use common::film::Film;
use glam::Vec3;
use ray_casting::ray::Ray;
use ray_casting::sphere::Sphere;

use crate::cases::{Disk, Heap};
use crate::solutions::hit_sphere;

/// The spheres that are hit, and where.
fn hits(spheres: &[Sphere], ray: &Ray) -> Vec<(usize, f32)> {
    let hit = |(index, sphere)| Some((index, hit_sphere(sphere, ray)?));
    spheres.iter().enumerate().filter_map(hit).collect()
}

pub(crate) fn of_first_seen() -> Vec<Mistake<Heap, Film>> {
    vec![
        Mistake {
            name: "the first in the list",
            diagnosis: "You stop at the first sphere that is hit. One later in the list may be \
                        nearer: see 'The nearest hit'.",
            answer: |heap| heap.picture(|spheres, ray| hits(spheres, ray).first().map(|hit| hit.0)),
        },
        Mistake {
            name: "the last in the list",
            diagnosis: "Each hit overwrites the one before, nearer or not. Keep the smallest t so \
                        far, and the sphere it belongs to: see 'The nearest hit'.",
            answer: |heap| heap.picture(|spheres, ray| hits(spheres, ray).last().map(|hit| hit.0)),
        },
        Mistake {
            name: "the farthest",
            diagnosis: "You keep the largest t. The smallest is what the eye sees: see 'The nearest \
                        hit'.",
            answer: |heap| {
                heap.picture(|spheres, ray| {
                    let hits = hits(spheres, ray);
                    hits.into_iter().max_by(|a, b| a.1.total_cmp(&b.1)).map(|hit| hit.0)
                })
            },
        },
        Mistake {
            name: "the nearest centre",
            diagnosis: "You compare the distances of centres. A large sphere's surface may be near \
                        though its centre is far: compare the t of the hits. See 'The nearest hit'.",
            answer: |heap| {
                heap.picture(|spheres, ray| {
                    let away = |index: usize| (spheres[index].center - ray.origin).length();
                    let hits = hits(spheres, ray).into_iter().map(|hit| hit.0);
                    hits.min_by(|&a, &b| away(a).total_cmp(&away(b)))
                })
            },
        },
        Mistake {
            name: "spheres behind the eye",
            diagnosis: "A sphere behind the eye wins with its negative t. Only t above 0 is on the \
                        ray: see 'A ray'.",
            answer: |heap| {
                heap.picture(|spheres, ray| {
                    let hit = |(index, sphere): (usize, &Sphere)| {
                        Some((index, sphere.crossing(ray)?.enter))
                    };
                    let hits = spheres.iter().enumerate().filter_map(hit);
                    hits.min_by(|a, b| a.1.total_cmp(&b.1)).map(|hit| hit.0)
                })
            },
        },
    ]
}

/// The distance to the disk's plane, and the hit's place seen from the centre.
fn plane(disk: &Disk) -> (f32, Vec3) {
    let Disk { center, normal, ray, .. } = disk;
    let t = (*center - ray.origin).dot(*normal) / ray.direction.dot(*normal);
    (t, ray.at(t) - *center)
}

pub(crate) fn of_hit_disk() -> Vec<Mistake<Disk, Option<f32>>> {
    vec![
        Mistake {
            name: "parallel below 1e-8",
            diagnosis: "You call the ray parallel when a product is below some small number. Both \
                        vectors of that product may be short: test nothing but t itself. See \
                        'Planes and quads'.",
            answer: |disk| {
                let (t, place) = plane(disk);
                let parallel = disk.ray.direction.dot(disk.normal).abs() < 1e-8;
                (!parallel && t > 0.0 && place.length() <= disk.radius).then_some(t)
            },
        },
        Mistake {
            name: "the front only",
            diagnosis: "A ray from behind hits the disk too: the sign of d·n says which side it \
                        comes from, not whether it hits. See 'Planes and quads'.",
            answer: |disk| {
                let (t, place) = plane(disk);
                let front = disk.ray.direction.dot(disk.normal) < 0.0;
                (front && t > 0.0 && place.length() <= disk.radius).then_some(t)
            },
        },
        Mistake {
            name: "a squared distance against a radius",
            diagnosis: "You compare the squared distance from the centre with the radius. Square \
                        both or none.",
            answer: |disk| {
                let (t, place) = plane(disk);
                (t > 0.0 && place.length_squared() <= disk.radius).then_some(t)
            },
        },
        Mistake {
            name: "hits behind the origin",
            diagnosis: "You return a negative t. That point is on the line, but not on the ray: see \
                        'A ray'.",
            answer: |disk| {
                let (t, place) = plane(disk);
                (place.length() <= disk.radius).then_some(t)
            },
        },
        Mistake {
            name: "no edge",
            diagnosis: "You found the plane, which has no end. The hit must also lie within the \
                        radius of the centre: see 'Planes and quads'.",
            answer: |disk| {
                let (t, _) = plane(disk);
                (t > 0.0 && t < f32::INFINITY).then_some(t)
            },
        },
    ]
}
