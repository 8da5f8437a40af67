//! One good answer to each exercise.

use std::f32::consts::PI;

use common::film::Color;
use path_tracing::exercises::Tiny;

use crate::cases::{Depth, Ray, Weight};

pub(super) fn weight(&Weight { reflectance, cosine, pdf }: &Weight) -> f32 {
    if cosine > 0.0 && pdf > 0.0 { reflectance / PI * cosine / pdf } else { 0.0 }
}

pub(super) fn furnace(albedo: f32, depth: u32, random: &mut dyn FnMut() -> f32) -> f32 {
    let (mut radiance, mut throughput) = (1.0, 1.0);
    for _ in 0..depth {
        let cosine = random();
        throughput *= albedo / PI * cosine * 2.0 * PI;
        radiance += throughput;
    }
    radiance
}

pub(super) fn tiny_path(tiny: &Tiny, depth: u32, random: &mut dyn FnMut() -> f32) -> f32 {
    let mut throughput = 1.0;
    for _ in 0..depth {
        throughput *= tiny.albedo;
        let chance = random();
        if chance < tiny.lamp_share {
            return throughput * tiny.lamp;
        }
        if chance < tiny.lamp_share + tiny.sky_share {
            return throughput * tiny.sky;
        }
    }
    0.0
}

pub(super) fn camera_light(Ray { met, things, sky }: &Ray) -> Color {
    if !met.happened {
        return *sky;
    }
    things[met.thing].towards(met.outgoing_z)
}

pub(super) fn depth(&Depth { albedo, missing }: &Depth) -> u32 {
    let (mut depth, mut left_out) = (0, albedo);
    while left_out > missing {
        depth += 1;
        left_out *= albedo;
    }
    depth
}
