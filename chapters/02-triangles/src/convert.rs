//! From a mesh file's arrays to a [`Mesh`].

use std::collections::HashMap;

use common::obj::{Model, Triangle};
use glam::Vec2;

use crate::mesh::Mesh;
use crate::smooth::vertex_normals;
use crate::surface::geometric_normal;

/// Where the normals of a mesh come from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "native", derive(clap::ValueEnum))]
pub enum Normals {
    /// The scene's own: a file's, if it has any; the built-in meshes have smooth ones.
    #[default]
    Given,
    /// Computed: each vertex gets the mean of its triangles.
    Smooth,
    /// None: each triangle is flat.
    Flat,
}

/// The mesh of a file.
///
/// A file numbers positions, normals and texture coordinates apart; a mesh has one number for all
/// three. So a position with two normals becomes two vertices, at the same place to the bit.
pub fn mesh_of(model: &Model, normals: Normals) -> Mesh {
    let given = normals == Normals::Given && model.triangles.iter().any(|it| it.normals.is_some());
    let uvs = model.triangles.iter().any(|it| it.uvs.is_some());
    let mut vertices = Vertices { given, uvs, model, known: HashMap::new(), mesh: Mesh::default() };
    for (number, triangle) in (0..).zip(&model.triangles) {
        let corners = [0, 1, 2].map(|corner| vertices.vertex(triangle, number, corner));
        vertices.mesh.triangles.push(corners);
    }
    let mut mesh = vertices.mesh;
    if normals == Normals::Smooth {
        mesh.normals = vertex_normals(&mesh.positions, &mesh.triangles);
    }
    mesh
}

/// What makes two corners the same vertex.
#[derive(PartialEq, Eq, Hash)]
struct Key {
    position: u32,
    normal: Option<u32>,
    uv: Option<u32>,
    /// The triangle, where the vertex belongs to it alone.
    triangle: Option<u32>,
}

/// The vertices found so far.
struct Vertices<'a> {
    /// Whether the normals are the file's.
    given: bool,
    /// Whether there are texture coordinates.
    uvs: bool,
    model: &'a Model,
    known: HashMap<Key, u32>,
    mesh: Mesh,
}

impl Vertices<'_> {
    /// The number of the vertex at a corner of the triangle, a new one if there is none like it.
    fn vertex(&mut self, triangle: &Triangle, number: u32, corner: usize) -> u32 {
        let normal = if self.given { triangle.normals.map(|at| at[corner]) } else { None };
        let key = Key {
            position: triangle.positions[corner],
            normal,
            uv: triangle.uvs.map(|at| at[corner]),
            triangle: (self.given && normal.is_none()).then_some(number),
        };
        let (model, mesh) = (self.model, &mut self.mesh);
        let next = mesh.positions.len() as u32;
        *self.known.entry(key).or_insert_with_key(|key| {
            mesh.positions.push(model.positions[key.position as usize]);
            if self.given {
                let own = || {
                    let places = triangle.positions.map(|at| model.positions[at as usize]);
                    geometric_normal(&places).unwrap_or(glam::Vec3::Y)
                };
                mesh.normals.push(normal.map_or_else(own, |at| model.normals[at as usize]));
            }
            if self.uvs {
                mesh.uvs.push(key.uv.map_or(Vec2::ZERO, |at| model.uvs[at as usize]));
            }
            next
        })
    }
}

#[cfg(test)]
mod tests {
    use common::obj::{Model, parse};
    use glam::Vec3;

    use super::{Normals, mesh_of};

    fn model(text: &str) -> Model {
        parse("test.obj", text.as_bytes(), |_| Err("not here".to_owned())).expect("it is sound")
    }

    const PLACES: &str = "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 1\nvn 0 0 1\nvn 0 1 1\nvt 0 0\nvt 1 0\n";

    #[test]
    fn without_normals_a_position_is_a_vertex() {
        let model = model(&format!("{PLACES}f 1 2 3\nf 1 3 4"));
        let flat = mesh_of(&model, Normals::Given);
        assert_eq!((flat.positions.len(), flat.normals.len(), flat.uvs.len()), (4, 0, 0));
        assert_eq!(flat.triangles, [[0, 1, 2], [0, 2, 3]]);
        assert_eq!(mesh_of(&model, Normals::Smooth).normals.len(), 4);
    }

    #[test]
    fn a_position_with_two_normals_becomes_two_vertices() {
        let model = model(&format!("{PLACES}f 1//1 2//1 3//1\nf 1//2 3//1 4//2"));
        let mesh = mesh_of(&model, Normals::Given);
        assert_eq!(mesh.triangles, [[0, 1, 2], [3, 2, 4]]);
        assert_eq!(mesh.positions[0], mesh.positions[3]);
        assert_eq!(mesh.normals[3], Vec3::new(0.0, 1.0, 1.0).normalize());
        assert_eq!(mesh_of(&model, Normals::Smooth).positions.len(), 4);
    }

    #[test]
    fn a_face_without_normals_among_others_stays_flat() {
        let model = model(&format!("{PLACES}f 1/1/2 2/2/2 3/1/2\nf 1 3 4"));
        let mesh = mesh_of(&model, Normals::Given);
        assert_eq!(mesh.triangles, [[0, 1, 2], [3, 4, 5]]);
        assert_eq!(mesh.uvs.len(), 6);
        assert_eq!(mesh.normals[3], mesh.normals[5]);
        assert!((mesh.normals[3] - Vec3::new(3.0, -2.0, 6.0) / 7.0).length() < 1e-6);
    }
}
