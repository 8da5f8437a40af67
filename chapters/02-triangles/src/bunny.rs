//! The Stanford bunny.

use common::obj::{ObjError, parse};

use crate::convert::{Normals, mesh_of};
use crate::mesh::Mesh;

const FILE: &[u8] = include_bytes!("../../../assets/bunny.obj");

/// The bunny: 3,674 triangles, closed, about 9.7 units high. Its file has no normals; `Given` means
/// smooth ones.
///
/// # Errors
/// Those of the file's text, which a test knows to be right.
pub fn bunny(normals: Normals) -> Result<Mesh, ObjError> {
    let no_files = |_: &str| Err("the bunny has no materials".to_owned());
    let model = parse("bunny.obj", FILE, no_files)?;
    Ok(mesh_of(&model, if normals == Normals::Given { Normals::Smooth } else { normals }))
}

#[cfg(test)]
mod tests {
    use super::bunny;
    use crate::closed::edges_without_partner;
    use crate::convert::Normals;

    #[test]
    fn it_is_whole() {
        let mesh = bunny(Normals::Given).expect("the file is part of the project");
        assert_eq!((mesh.positions.len(), mesh.triangles.len()), (1839, 3674));
        assert_eq!(edges_without_partner(&mesh.triangles), 0);
        assert_eq!(mesh.normals.len(), 1839);
        assert!(bunny(Normals::Flat).expect("as above").normals.is_empty());
    }
}
