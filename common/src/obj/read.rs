//! Reading a mesh from the disk.

use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::Path;

use super::error::{ObjError, Problem};
use super::{Model, parse};

/// The most bytes read of a mesh, so that a mistaken path cannot fill the memory.
const MAX_BYTES: u64 = 256 << 20;

/// The most bytes read of a material file.
const MAX_MATERIAL_BYTES: u64 = 16 << 20;

/// Loads the OBJ file at `path`, and the MTL files it names from the folder it is in.
///
/// # Errors
/// As for [`parse`], and where the file is missing, a folder, unreadable, or larger than 256 MiB.
/// An MTL file that cannot be read, or is larger than 16 MiB, is a warning in the model.
pub fn load(path: &Path) -> Result<Model, ObjError> {
    let file = path.display().to_string();
    let bytes = read(path, MAX_BYTES).map_err(|problem| problem.of(&file))?;
    parse(&file, &bytes, |name| {
        read(&path.with_file_name("").join(name), MAX_MATERIAL_BYTES)
            .map_err(|problem| problem.to_string())
    })
}

/// All bytes of a file that has at most `limit`. Its length is looked at first, and the reading is
/// bounded as well, because a device has no length.
fn read(path: &Path, limit: u64) -> Result<Vec<u8>, Problem> {
    let failed = |error: std::io::Error| match error.kind() {
        ErrorKind::NotFound => Problem::Missing,
        ErrorKind::IsADirectory => Problem::Directory,
        _ => Problem::Unreadable(error.to_string()),
    };
    let file = File::open(path).map_err(failed)?;
    let about = file.metadata().map_err(failed)?;
    if about.is_dir() {
        return Err(Problem::Directory);
    }
    if about.len() > limit {
        return Err(Problem::TooLarge { limit });
    }

    let mut bytes = Vec::new();
    file.take(limit + 1).read_to_end(&mut bytes).map_err(failed)?;
    if bytes.len() as u64 > limit {
        return Err(Problem::TooLarge { limit });
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_file_and_a_folder_are_named() {
        let folder = tempfile::tempdir().unwrap();
        let missing = load(&folder.path().join("none.obj")).unwrap_err();
        assert_eq!((missing.problem.clone(), missing.line), (Problem::Missing, None));
        assert!(missing.to_string().contains("none.obj: there is no such file"), "{missing}");
        assert_eq!(load(folder.path()).unwrap_err().problem, Problem::Directory);
    }

    #[test]
    fn a_long_file_is_refused_unread() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("long.obj");
        // A hole in the file system: long, and no bytes on the disk.
        File::create(&path).unwrap().set_len(MAX_BYTES + 1).unwrap();
        let error = load(&path).unwrap_err();
        assert_eq!(error.problem, Problem::TooLarge { limit: MAX_BYTES });
        assert!(error.to_string().contains("256 MiB"), "{error}");
        File::create(&path).unwrap().set_len(7_001).unwrap();
        assert_eq!(read(&path, 7_000), Err(Problem::TooLarge { limit: 7_000 }));
        assert_eq!(read(&path, 7_001).map(|bytes| bytes.len()), Ok(7_001));
    }

    #[cfg(unix)]
    #[test]
    fn a_device_without_a_length_is_bounded_too() {
        let endless = Path::new("/dev/zero");
        assert_eq!(read(endless, 1_000), Err(Problem::TooLarge { limit: 1_000 }));
    }

    #[test]
    fn material_files_are_found_beside_the_mesh() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.obj");
        std::fs::write(&path, "mtllib a b.mtl\nusemtl m\nv 0 0 0\nv 2 0 0\nv 0 3 0\nf 1 2 3")
            .unwrap();
        std::fs::write(folder.path().join("a b.mtl"), "newmtl m\nKd 0.5 nan 0").unwrap();
        let error = load(&path).unwrap_err().to_string();
        assert!(error.contains("a b.mtl:2: `nan`"), "{error}");
        std::fs::write(folder.path().join("a b.mtl"), "newmtl m\nKd 0.5 0 0").unwrap();
        let model = load(&path).unwrap();
        assert_eq!(model.materials[0].diffuse.x, 0.5);
        assert_eq!(model.warnings, [""; 0]);
    }
}
