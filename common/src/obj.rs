//! Meshes and their materials: OBJ and MTL files to plain arrays.
//!
//! The `tobj` crate does the parsing. Around it: a check of each line first, so that an error names
//! the file, the line, the reason and what to do; polygons cut into triangles, concave ones
//! included; and only finite numbers and indices in range behind [`parse`], whatever the bytes.
//!
//! ```
//! let text = b"v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nf 1 2 3 4\n";
//! let model = common::obj::parse("quad.obj", text, |_| Err("no materials here".to_owned()))?;
//! assert_eq!(model.triangles.len(), 2);
//! # Ok::<(), common::obj::ObjError>(())
//! ```

mod error;
mod faces;
mod library;
mod lines;
mod material;
pub mod nasty;
mod polygon;
#[cfg(feature = "native")]
mod read;
mod scan;
mod warnings;
mod words;

use std::path::Path;

use glam::{DVec3, Vec2, Vec3};

pub use error::{ObjError, Problem};
pub use material::Material;
#[cfg(feature = "native")]
pub use read::load;

use faces::add_triangles;
use library::{find_materials, load_materials};
use scan::scan;
use warnings::Warnings;

/// A mesh as plain arrays. Every number is finite and every index in range.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// The file's name without folder and ending.
    pub name: String,
    /// The positions that faces use, in the order of their first use.
    pub positions: Vec<Vec3>,
    /// The normals that faces use, made unit length. One that had no length stays zero, and no
    /// triangle uses it. Empty if the file gives none.
    pub normals: Vec<Vec3>,
    /// The texture coordinates that faces use. Empty if the file gives none.
    pub uvs: Vec<Vec2>,
    /// The faces cut into triangles, in the order and winding of the file. None has an area of
    /// exactly zero. There is at least one.
    pub triangles: Vec<Triangle>,
    /// All materials of the MTL files, used or not.
    pub materials: Vec<Material>,
    /// What the user should be told: each names a file and a line.
    pub warnings: Vec<String>,
}

/// Three corners, as indices into the arrays of the [`Model`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// Into [`Model::positions`].
    pub positions: [u32; 3],
    /// Into [`Model::normals`], if all corners of the face have a normal.
    pub normals: Option<[u32; 3]>,
    /// Into [`Model::uvs`], if all corners of the face have texture coordinates.
    pub uvs: Option<[u32; 3]>,
    /// Into [`Model::materials`], if the face has a material and the material was found.
    pub material: Option<u32>,
}

/// Parses the OBJ text `obj`. `name` is what errors call the file. `material_file` is asked for the
/// bytes of each MTL file by the name that stands in the text; the reason it gives for not having
/// them becomes a warning.
///
/// # Errors
/// Text that is no mesh, with the line; MTL text that is no material, with its file and line. Groups,
/// smoothing and the like are read over. Faces without area are left out and counted in a warning.
pub fn parse(
    name: &str,
    obj: &[u8],
    material_file: impl FnMut(&str) -> Result<Vec<u8>, String>,
) -> Result<Model, ObjError> {
    let mut warnings = Warnings::default();
    let scan = scan(name, obj, &mut warnings)?;
    let materials = load_materials(name, &scan, material_file, &mut warnings)?;
    let found = find_materials(name, &scan, &materials, &mut warnings);

    let options =
        tobj::LoadOptions { ignore_lines: true, ignore_points: true, ..Default::default() };
    let no_materials = |_: &Path| Err(tobj::LoadError::OpenFileFailed);
    let (mut models, _) = tobj::load_obj_buf(&mut scan.clean.as_slice(), &options, no_materials)
        .map_err(|error| Problem::Parser(error.to_string()).of(name))?;
    let mesh = models.pop().ok_or(Problem::NoFaces.of(name))?.mesh;

    // The slices below rely on it, whatever a later version of the parser does.
    let corners: usize = scan.faces.iter().map(|face| face.corners as usize).sum();
    let has = |some: bool, indices: &[u32]| !some || indices.len() == corners;
    let sound = has(true, &mesh.indices)
        && has(scan.faces.iter().any(|face| face.has.uv), &mesh.texcoord_indices)
        && has(scan.faces.iter().any(|face| face.has.normal), &mesh.normal_indices);
    if !sound {
        return Err(Problem::Parser("it lost a corner".to_owned()).of(name));
    }

    let stem = Path::new(name).file_stem().unwrap_or_default();
    let mut model = Model {
        name: stem.to_string_lossy().into_owned(),
        positions: mesh.positions.as_chunks().0.iter().copied().map(Vec3::from).collect(),
        normals: mesh.normals.as_chunks().0.iter().copied().map(unit).collect(),
        uvs: mesh.texcoords.as_chunks().0.iter().copied().map(Vec2::from).collect(),
        materials,
        ..Model::default()
    };
    add_triangles(name, &mut model, &mesh, &scan.faces, &found, &mut warnings)?;
    model.warnings = warnings.into_texts(name);
    Ok(model)
}

/// A vector's direction, or zero if it has none. In f64, where no f32 vector's length vanishes or
/// overflows.
fn unit(vector: [f32; 3]) -> Vec3 {
    Vec3::from(vector).as_dvec3().try_normalize().unwrap_or(DVec3::ZERO).as_vec3()
}

#[cfg(test)]
mod tests;
