//! The faces of a parsed mesh to the triangles of a model.

use glam::Vec3;

use super::error::{ObjError, Problem};
use super::polygon::Splitter;
use super::scan::Face;
use super::warnings::{Tally, Warnings};
use super::{Model, Triangle};

/// Cuts the faces of `mesh` into the triangles of `model`. `faces` knows what `tobj` does not: the
/// line of each, and whether its texture coordinates and normals are real (`tobj` makes up what is
/// missing).
pub(super) fn add_triangles(
    name: &str,
    model: &mut Model,
    mesh: &tobj::Mesh,
    faces: &[Face],
    found: &[Option<u32>],
    warnings: &mut Warnings,
) -> Result<(), ObjError> {
    let mut splitter = Splitter::new();
    let mut corners = Vec::new();
    let (mut flat, mut partial, mut dark) = (Tally::default(), Tally::default(), Tally::default());
    let mut start = 0;
    for face in faces {
        let range = start..start + face.corners as usize;
        start = range.end;
        let positions = &mesh.indices[range.clone()];
        let uvs = face.has.uv.then(|| &mesh.texcoord_indices[range.clone()]);
        let mut normals = face.has.normal.then(|| &mesh.normal_indices[range.clone()]);
        if normals.is_some_and(|at| at.iter().any(|&at| model.normals[at as usize] == Vec3::ZERO)) {
            normals = None;
            dark.add(face.line);
        }

        corners.clear();
        corners.extend(positions.iter().map(|&at| model.positions[at as usize]));
        let split = splitter.split(&corners);
        match (split.triangles.is_empty(), split.complete) {
            (true, _) => flat.add(face.line),
            (false, false) => partial.add(face.line),
            (false, true) => {}
        }
        model.triangles.extend(split.triangles.iter().map(|triangle| {
            let pick = |indices: &[u32]| triangle.map(|corner| indices[corner as usize]);
            Triangle {
                positions: pick(positions),
                normals: normals.map(pick),
                uvs: uvs.map(pick),
                material: face.material.and_then(|material| found[material as usize]),
            }
        }));
    }

    flat.warn(name, "faces have no area and are left out", warnings);
    partial.warn(name, "faces cross themselves; parts of them are left out", warnings);
    dark.warn(name, "faces have a normal of length zero; their normals are left out", warnings);
    match (model.triangles.is_empty(), flat.first()) {
        (true, Some(line)) => Err(Problem::NoArea.at(name, line)),
        _ => Ok(()),
    }
}
