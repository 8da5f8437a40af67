//! Object order: for each triangle, the pixels it covers.

use common::film::Mean;
use common::render::bands::render_bands;
use common::render::{Pixel, Rendering, Settings};
use common::sampler::Sampler;
use common::tally::Tally;

use crate::fragment::Shade;
use crate::raster::Band;
use crate::rasterizer::{BAND_ROWS, Rasterizer, pixels};
use crate::samples::{Centres, Samples, Scattered};

// ANCHOR: render
/// The picture whose samples `shade` colours, triangle by triangle.
///
/// Threads share the work by bands of rows, so each z-buffer has one owner, and every pixel meets
/// the triangles in the same order whatever the number of threads.
pub fn render<T: Tally>(
    rasterizer: &Rasterizer,
    settings: &Settings,
    shade: &Shade<T>,
) -> Rendering<T> {
    render_bands(settings, BAND_ROWS, |rows, tally: &mut T| {
        let mut means = vec![Mean::default(); settings.width as usize * rows.len()];
        let mut shade_all = |samples: &dyn Samples, band: &Band, tally: &mut T| {
            for (mean, pixel) in means.iter_mut().zip(pixels(settings.width, rows.clone())) {
                let offset = samples.offset(pixel);
                let fragment = rasterizer.fragment(band, pixel, offset);
                mean.add(shade(pixel, offset, fragment, tally));
            }
        };
        let number = rows.start / BAND_ROWS;
        if settings.spp == 1 {
            let band = rasterizer.band(number, &Centres, tally);
            shade_all(&Centres, &band, tally);
            return Some(means);
        }
        for index in 0..settings.spp {
            // Very many samples must not make Ctrl-C wait for them.
            if settings.watch.stop() {
                return None;
            }
            let sampler = |pixel| sampler_of(settings, pixel, index);
            let samples = Scattered::new(settings.width, rows.clone(), sampler);
            let band = rasterizer.band(number, &samples, tally);
            shade_all(&samples, &band, tally);
        }
        Some(means)
    })
}
// ANCHOR_END: render

/// The random numbers of a sample: those that `common::render` gives a closure.
fn sampler_of(settings: &Settings, Pixel { x, y }: Pixel, index: u32) -> Sampler {
    let number = u64::from(y) * u64::from(settings.width) + u64::from(x);
    Sampler::new(settings.seed, number, index, settings.spp)
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::render::{Pixel, Rendering, Settings};
    use common::tally::{Counts, Tally};
    use glam::Vec3;
    use ray_casting::camera::{Camera, View};
    use triangles::bumpy;

    use super::render;
    use crate::fixed::Fixed;
    use crate::fragment::Fragment;
    use crate::image;
    use crate::rasterizer::Rasterizer;
    use crate::setup::CLIP_TESTS;

    fn camera() -> Camera {
        let view = View {
            eye: Vec3::new(0.6, 1.2, 3.2),
            target: Vec3::new(0.1, 0.0, 0.0),
            up: Vec3::Y,
            vertical_fov: 42.0,
        };
        Camera::new(&view, 75, 52).expect("a good view")
    }

    fn color(_: Pixel, _: Fixed, fragment: Option<Fragment>, _: &mut Counts) -> Color {
        fragment.map_or(Color::ZERO, |it| it.barycentric * it.depth)
    }

    fn drawn<const CLIP: bool>(threads: usize, spp: u32) -> Rendering<Counts> {
        let settings = Settings { width: 75, height: 52, spp, threads, ..Settings::default() };
        let (mesh, mut setup) = (bumpy::sphere(700), Counts::default());
        let rasterizer = Rasterizer::new::<CLIP, Counts>(&mesh, &camera(), &mut setup);
        let mut rendering = render(&rasterizer, &settings, &color);
        rendering.tally.merge(&setup);
        rendering
    }

    #[test]
    fn any_number_of_threads_gives_the_same_bits_and_counts() {
        for spp in [1, 3] {
            let one = drawn::<false>(1, spp);
            for threads in [2, 3, 7] {
                let many = drawn::<false>(threads, spp);
                assert_eq!((many.film.hash(), &many.tally), (one.film.hash(), &one.tally));
            }
        }
    }

    #[test]
    fn clipping_that_is_not_needed_changes_no_bit_and_left_out_does_no_work() {
        let (needed, all) = (drawn::<false>(0, 1), drawn::<true>(0, 1));
        assert_eq!(needed.film.hash(), all.film.hash());
        assert_eq!((needed.tally.of(CLIP_TESTS), all.tally.of(CLIP_TESTS)), (0, 700));
    }

    #[test]
    fn many_samples_are_those_of_the_rays() {
        let settings = Settings { width: 75, height: 52, spp: 5, ..Settings::default() };
        let corners = bumpy::sphere(700).all_corners();
        let rays = image::render(&corners, &camera(), &settings, &color);
        let found = drawn::<false>(0, 5).film;
        // A pixel on the silhouette may differ: a sample near an edge may go either way.
        let differ = |(one, other): (&Color, &Color)| (*one - *other).length() > 1e-3;
        let pairs = found.pixels.iter().zip(&rays.film.pixels);
        let differing = pairs.filter(|&pair| differ(pair)).count();
        assert!(differing < 8, "{differing} of 3,900 pixels");
    }
}
