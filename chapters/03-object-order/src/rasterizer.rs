//! A mesh ready to be drawn, band by band, and what its z-buffers hold.

use std::ops::Range;

use common::render::Pixel;
use common::tally::Tally;
use glam::{DVec2, DVec3, Vec3};
use ray_casting::camera::Camera;
use triangles::mesh::Mesh;

use crate::edge::covers;
use crate::fixed::{Fixed, STEPS};
use crate::fragment::Fragment;
use crate::interpolate::Interpolation;
use crate::project::{FilmPoint, Projection};
use crate::raster::Band;
use crate::samples::{Centres, Samples, exact_position};
use crate::setup::{Piece, Prepared, prepare};
use crate::zbuffer::{NOTHING, ZBuffer, nearness};

/// Rows that are drawn at a time: their z-buffer then stays in a processor's nearest cache.
pub const BAND_ROWS: u32 = 16;

/// A mesh that is ready to be drawn, band by band.
#[derive(Clone, Debug)]
pub struct Rasterizer<'a> {
    mesh: &'a Mesh,
    width: u32,
    height: u32,
    prepared: Prepared,
    /// For each band the pieces that reach into it, in order.
    bins: Vec<Vec<u32>>,
}

impl<'a> Rasterizer<'a> {
    /// Brings `mesh` onto the camera's film of `width` by `height` pixels. `CLIP` as in
    /// [`prepare`].
    pub fn new<const CLIP: bool, T: Tally>(mesh: &'a Mesh, camera: &Camera, tally: &mut T) -> Self {
        let size = camera.size();
        let (width, height) = (size.x as u32, size.y as u32);
        let projection = Projection::new(camera);
        let prepared = prepare::<CLIP, T>(mesh, &projection, [width, height], tally);
        let mut bins = vec![Vec::new(); height.div_ceil(BAND_ROWS) as usize];
        for (index, piece) in (0..).zip(&prepared.pieces) {
            let last = piece.rows.end.div_ceil(BAND_ROWS);
            for band in piece.rows.start / BAND_ROWS..last {
                bins[band as usize].push(index);
            }
        }
        Self { mesh, width, height, prepared, bins }
    }

    // ANCHOR: band
    /// Draws every triangle that reaches into the rows of one band.
    pub fn band<T: Tally>(&self, number: u32, samples: &impl Samples, tally: &mut T) -> Band {
        let top = number * BAND_ROWS;
        let rows = top..(top + BAND_ROWS).min(self.height);
        // Without a volume there are no pieces, and nothing is near.
        let near = self.prepared.volume.map_or(0.0, |volume| volume.near);
        let mut band = Band::new(self.width, rows, near);
        for &piece in &self.bins[number as usize] {
            band.draw(&self.prepared.pieces[piece as usize], samples, tally);
        }
        band
    }
    // ANCHOR_END: band

    // ANCHOR: fragment
    /// What the z-buffer holds at a sample.
    pub fn fragment(&self, band: &Band, pixel: Pixel, offset: Fixed) -> Option<Fragment> {
        let index = band.index(pixel);
        let triangle = band.buffer.triangles[index];
        if triangle == NOTHING {
            return None;
        }
        let depth = (band.near / f64::from(band.buffer.nearness[index])) as f32;
        self.surface(triangle, depth, exact_position(pixel, offset))
    }

    fn surface(&self, triangle: u32, depth: f32, sample: DVec2) -> Option<Fragment> {
        let surface = Interpolation::new(self.corners(triangle))?.surface(sample);
        Some(Fragment { triangle, depth, barycentric: inside(surface.barycentric) })
    }
    // ANCHOR_END: fragment

    /// The corners of a triangle on the film.
    pub fn corners(&self, triangle: u32) -> [FilmPoint; 3] {
        let vertices = &self.prepared.vertices;
        self.mesh.triangles[triangle as usize].map(|vertex| vertices[vertex as usize])
    }

    /// The numbers of the triangles that cover one sample, in order, without a z-buffer.
    pub fn covering(&self, pixel: Pixel, offset: Fixed) -> impl Iterator<Item = u32> {
        self.pieces_at(pixel, offset).map(|piece| piece.triangle)
    }

    /// What one sample sees, without a z-buffer: the same answer as [`Rasterizer::fragment`].
    pub fn at(&self, pixel: Pixel, offset: Fixed) -> Option<Fragment> {
        let (near, sample) = (self.prepared.volume?.near, exact_position(pixel, offset));
        let mut nearest = ZBuffer::new(1);
        for piece in self.pieces_at(pixel, offset) {
            nearest.offer(0, piece.triangle, nearness(near, piece.inverse_depth(sample)));
        }
        let triangle = nearest.triangles[0];
        let depth = (near / f64::from(nearest.nearness[0])) as f32;
        (triangle != NOTHING).then(|| self.surface(triangle, depth, sample)).flatten()
    }

    fn pieces_at(&self, pixel: Pixel, offset: Fixed) -> impl Iterator<Item = &Piece> {
        let corner = Fixed { x: pixel.x as i32 * STEPS, y: pixel.y as i32 * STEPS };
        let sample = Fixed { x: corner.x + offset.x, y: corner.y + offset.y };
        self.prepared.pieces.iter().filter(move |piece| covers(&piece.edges, sample))
    }

    /// What each pixel's centre sees, row by row.
    pub fn fragments<T: Tally>(&self, tally: &mut T) -> Vec<Option<Fragment>> {
        let mut fragments = Vec::with_capacity(self.width as usize * self.height as usize);
        for number in 0..self.bins.len() as u32 {
            let band = self.band(number, &Centres, tally);
            fragments.extend(
                pixels(self.width, band.rows.clone())
                    .map(|pixel| self.fragment(&band, pixel, Centres.offset(pixel))),
            );
        }
        fragments
    }
}

/// The nearest shares that are none negative: a covered sample may lie a hair outside.
fn inside(barycentric: DVec3) -> Vec3 {
    let shares = barycentric.max(DVec3::ZERO);
    (shares / (shares.x + shares.y + shares.z)).as_vec3()
}

/// The pixels of some rows, row by row.
pub fn pixels(width: u32, rows: Range<u32>) -> impl Iterator<Item = Pixel> {
    rows.flat_map(move |y| (0..width).map(move |x| Pixel { x, y }))
}
