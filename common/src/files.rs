//! Writing files so that none is ever half there.

use std::io::{self, Write};
use std::path::Path;

/// Writes `bytes` to a temporary file beside `path` and renames it: whoever reads `path` sees the
/// old file or the whole new one. Missing parent folders are made.
///
/// A path that is there but is no ordinary file, such as `/dev/null`, is written in place.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> io::Result<()> {
    if is_device(path) {
        return std::fs::OpenOptions::new().write(true).open(path)?.write_all(bytes);
    }
    let mut file = temporary_beside(path)?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    let file = file.persist(path).map_err(|error| error.error)?;
    readable_by_all(&file)
}

/// Fails if [`write_atomically`] would fail for reasons that can be seen beforehand, so that nobody
/// waits an hour for a picture that can't be kept.
pub fn check_writable(path: &Path) -> io::Result<()> {
    if is_device(path) { Ok(()) } else { temporary_beside(path).map(drop) }
}

fn is_device(path: &Path) -> bool {
    path.exists() && !path.is_file() && !path.is_dir()
}

/// An empty file in the folder of `path`, which goes away again unless it is renamed.
fn temporary_beside(path: &Path) -> io::Result<tempfile::NamedTempFile> {
    if path.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder"));
    }
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    std::fs::create_dir_all(folder)?;
    tempfile::NamedTempFile::new_in(folder)
}

/// A temporary file is private to its owner; a picture is not.
#[cfg(unix)]
fn readable_by_all(file: &std::fs::File) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    file.set_permissions(std::fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn readable_by_all(_file: &std::fs::File) -> io::Result<()> {
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::write_atomically;

    #[test]
    fn a_file_is_replaced_whole_and_leaves_nothing_beside_it() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("deep/er/file.txt");
        write_atomically(&path, b"first, longer").expect("the folders are made");
        write_atomically(&path, b"second").expect("and the file replaced");
        assert_eq!(std::fs::read(&path).expect("it is there"), b"second");
        let beside = std::fs::read_dir(path.parent().expect("it has one")).expect("a folder");
        assert_eq!(beside.count(), 1);
    }

    #[test]
    fn a_folder_is_refused() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        assert!(write_atomically(folder.path(), b"x").is_err());
    }
}
