//! Which files changed.

use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// When the files below some folders were last changed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Snapshot(Vec<(PathBuf, Option<SystemTime>)>);

impl Snapshot {
    /// Looks at all files below `folders`.
    pub fn of(folders: &[PathBuf]) -> Self {
        let paths = folders.iter().flat_map(|folder| files(folder));
        Self(paths.map(|path| (path.clone(), modified(&path))).collect())
    }

    /// The files that are new, gone or changed since `before`.
    pub fn changes(&self, before: &Self) -> Vec<PathBuf> {
        // Nearly always nothing has changed, and this is asked several times a second.
        if self == before {
            return Vec::new();
        }
        let new = self.0.iter().filter(|entry| !before.0.contains(entry));
        let gone = before.0.iter().filter(|(path, _)| self.0.iter().all(|(now, _)| now != path));
        new.chain(gone).map(|(path, _)| path.clone()).collect()
    }
}

fn modified(path: &Path) -> Option<SystemTime> {
    path.metadata().and_then(|data| data.modified()).ok()
}

/// All files below `folder`, sorted; a file is below itself. Hidden ones are left out: editors
/// keep their own things there.
pub fn files(folder: &Path) -> Vec<PathBuf> {
    if folder.is_file() {
        return vec![folder.into()];
    }
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    let hidden = |path: &PathBuf| {
        path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'))
    };
    paths.iter().filter(|path| !hidden(path)).flat_map(|path| files(path)).collect()
}

#[cfg(test)]
mod tests {
    use std::time::{Duration, SystemTime};

    use super::Snapshot;

    #[test]
    fn new_changed_and_lost_files_are_seen() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = |name: &str| folder.path().join(name);
        for name in ["kept", "changed", "lost"] {
            std::fs::write(path(name), name).expect("it can be written");
        }
        let folders = [folder.path().to_path_buf()];
        let before = Snapshot::of(&folders);
        assert!(Snapshot::of(&folders).changes(&before).is_empty());

        std::fs::remove_file(path("lost")).expect("it is there");
        std::fs::write(path("new"), "new").expect("it can be written");
        let file = std::fs::File::options().write(true).open(path("changed")).expect("it is there");
        file.set_modified(SystemTime::now() + Duration::from_secs(9)).expect("it can be set");
        let changes = Snapshot::of(&folders).changes(&before);
        assert_eq!(changes, [path("changed"), path("new"), path("lost")]);
    }
}
