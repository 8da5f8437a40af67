//! Takes the fingerprint of every chapter's sources while they are compiled, so that the cache of
//! figures knows which code made them, and not which code lies on the disk by now.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::{Path, PathBuf};

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=build.rs");
    let mut hasher = DefaultHasher::new();
    add_sources(Path::new("../common/src"), &mut hasher)?;
    // A chapter builds on all before it: one hasher goes through them and is read after each.
    let mut fingerprints = Vec::new();
    for chapter in entries(Path::new("../chapters"))? {
        add_sources(&chapter.join("src"), &mut hasher)?;
        let id = chapter.file_name().unwrap_or_default().to_string_lossy();
        fingerprints.push(format!("{id}={:016x}", hasher.finish()));
    }
    println!("cargo::rustc-env=SOURCE_FINGERPRINTS={}", fingerprints.join(" "));
    Ok(())
}

/// Adds every file below `folder`, in the order of their names.
fn add_sources(folder: &Path, hasher: &mut DefaultHasher) -> io::Result<()> {
    for path in entries(folder)? {
        // What a reader writes as an answer to an exercise is in no figure.
        let answers = path.file_stem().is_some_and(|name| name == "exercises");
        if path.is_dir() {
            add_sources(&path, hasher)?;
        } else if !answers {
            println!("cargo::rerun-if-changed={}", path.display());
            path.to_string_lossy().hash(hasher);
            std::fs::read(&path)?.hash(hasher);
        }
    }
    Ok(())
}

/// What is in `folder`, sorted; nothing if it isn't there.
fn entries(folder: &Path) -> io::Result<Vec<PathBuf>> {
    if !folder.is_dir() {
        return Ok(Vec::new());
    }
    let found = std::fs::read_dir(folder)?.map(|entry| entry.map(|entry| entry.path()));
    let mut paths = found.collect::<io::Result<Vec<PathBuf>>>()?;
    paths.sort();
    Ok(paths)
}
