//! From a mesh to pieces that can be drawn: project, clip, snap, and make the edge functions.

use std::ops::Range;

use common::tally::{Event, Tally};
use glam::{DVec2, Vec3};
use triangles::mesh::Mesh;

use crate::clip::{Polygon, Volume};
use crate::edge::{Edge, edges};
use crate::fixed::{Fixed, STEPS};
use crate::interpolate::Interpolation;
use crate::project::{FilmPoint, Projection};

/// Triangles brought onto the film.
pub const TRIANGLES_PROJECTED: Event = Event::new(3, 0, "triangles_projected");
/// Triangles held against the planes of the clip volume.
pub const CLIP_TESTS: Event = Event::new(3, 1, "clip_tests");
/// Triangles of which a part was cut away.
pub const TRIANGLES_CLIPPED: Event = Event::new(3, 2, "triangles_clipped");

// ANCHOR: piece
/// A triangle on the film, ready to be drawn. A clipped one may come in several pieces.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// The number of its triangle in the mesh.
    pub triangle: u32,
    /// Its three edge functions.
    pub edges: [Edge; 3],
    /// The pixels it may cover, from left to right.
    pub columns: Range<u32>,
    /// The pixels it may cover, from top to bottom.
    pub rows: Range<u32>,
    /// Depth over the whole triangle.
    pub interpolation: Interpolation,
    /// The least and the largest 1/w of the piece.
    pub inverse_depths: [f64; 2],
}
// ANCHOR_END: piece

impl Piece {
    // ANCHOR: inverse_depth
    /// 1/w at a covered sample (in pixels).
    ///
    /// Snapping lets a sample be covered that lies a hair outside the triangle. The plane of one
    /// seen nearly edge-on is anywhere there, so the piece's own depths are the limits.
    pub fn inverse_depth(&self, sample: DVec2) -> f64 {
        let [least, most] = self.inverse_depths;
        self.interpolation.inverse_depth(sample).clamp(least, most)
    }
    // ANCHOR_END: inverse_depth
}

/// A mesh on the film.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// The vertices, in the mesh's order.
    pub vertices: Vec<FilmPoint>,
    /// What can be drawn, in the order of the triangles.
    pub pieces: Vec<Piece>,
    /// The clip volume; None when all lies behind the eye, and there are no pieces.
    pub volume: Option<Volume>,
}

/// The vertices of `mesh` on the film, and the largest depth among them.
pub fn project(projection: &Projection, positions: &[Vec3]) -> (Vec<FilmPoint>, f64) {
    let vertices: Vec<_> = positions.iter().map(|&point| projection.project(point)).collect();
    let deepest = vertices.iter().map(|vertex| vertex.w).fold(0.0, f64::max);
    (vertices, deepest)
}

/// Brings a mesh onto a film of `width` by `height` pixels.
///
/// `CLIP` says whether triangles are held against the clip volume. Without it, all vertices must
/// lie inside.
pub fn prepare<const CLIP: bool, T: Tally>(
    mesh: &Mesh,
    projection: &Projection,
    size: [u32; 2],
    tally: &mut T,
) -> Prepared {
    let (vertices, deepest) = project(projection, &mesh.positions);
    let volume = Volume::for_depth(deepest);
    let mut pieces = Vec::new();
    if let Some(volume) = volume {
        for (triangle, indices) in (0..).zip(&mesh.triangles) {
            let corners = indices.map(|index| vertices[index as usize]);
            let polygon = left_of::<CLIP, T>(corners, &volume, tally);
            add_pieces(&mut pieces, triangle, corners, &polygon, size);
        }
        tally.count(TRIANGLES_PROJECTED, mesh.triangles.len() as u64);
    }
    Prepared { vertices, pieces, volume }
}

/// What clipping leaves of a triangle.
fn left_of<const CLIP: bool, T: Tally>(
    corners: [FilmPoint; 3],
    volume: &Volume,
    tally: &mut T,
) -> Polygon {
    if !CLIP {
        return Polygon::new(&corners);
    }
    tally.count(CLIP_TESTS, 1);
    if corners.iter().all(|&corner| volume.contains(corner)) {
        return Polygon::new(&corners);
    }
    tally.count(TRIANGLES_CLIPPED, 1);
    volume.clip(corners)
}

// ANCHOR: add_pieces
/// Cuts the polygon that clipping left of a triangle into a fan of pieces.
fn add_pieces(
    pieces: &mut Vec<Piece>,
    triangle: u32,
    corners: [FilmPoint; 3],
    polygon: &Polygon,
    size: [u32; 2],
) {
    let [first, others @ ..] = polygon.corners() else { return };
    let Some(interpolation) = Interpolation::new(corners) else { return };
    for pair in others.windows(2) {
        let fan = [*first, pair[0], pair[1]];
        let snapped = fan.map(|corner| Fixed::snap(corner.divide()));
        let Some(edges) = edges(snapped) else { continue };
        let columns = pixels(snapped.map(|corner| corner.x), size[0]);
        let rows = pixels(snapped.map(|corner| corner.y), size[1]);
        if columns.is_empty() || rows.is_empty() {
            continue;
        }
        let inverse = fan.map(|corner| 1.0 / corner.w);
        let inverse_depths = [
            inverse.into_iter().fold(f64::INFINITY, f64::min),
            inverse.into_iter().fold(0.0, f64::max),
        ];
        pieces.push(Piece { triangle, edges, columns, rows, interpolation, inverse_depths });
    }
}
// ANCHOR_END: add_pieces

/// The pixels of a row or column of `size` pixels that corners at these places may cover.
fn pixels(corners: [i32; 3], size: u32) -> Range<u32> {
    let first = corners.into_iter().fold(i32::MAX, i32::min).div_euclid(STEPS).max(0);
    let last = corners.into_iter().fold(i32::MIN, i32::max).div_euclid(STEPS).min(size as i32 - 1);
    first as u32..(last + 1).max(0) as u32
}
