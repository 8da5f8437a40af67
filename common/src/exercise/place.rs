//! Where verdicts and comparison pages are written.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// The variable that names another output folder than `out` at the workspace root; a relative
/// path is meant from that root.
const VARIABLE: &str = "FIRST_LIGHT_OUT";

/// The output folder, for the chapter in `folder`.
pub(super) fn out_folder(folder: &Path) -> PathBuf {
    out_folder_with(folder, std::env::var_os(VARIABLE))
}

fn out_folder_with(folder: &Path, variable: Option<OsString>) -> PathBuf {
    let chosen = variable.filter(|chosen| !chosen.is_empty()).unwrap_or_else(|| "out".into());
    workspace_root(folder).join(chosen)
}

/// The nearest folder at or above `folder` whose `Cargo.toml` declares a workspace; `folder` itself
/// where there is none. A test can't go by its current folder: cargo starts it in the chapter's.
fn workspace_root(folder: &Path) -> &Path {
    let declares = |folder: &&Path| {
        let manifest = std::fs::read_to_string(folder.join("Cargo.toml")).unwrap_or_default();
        manifest.lines().any(|line| line.trim() == "[workspace]")
    };
    folder.ancestors().find(declares).unwrap_or(folder)
}

/// "01-2" for exercise "1.2", so that a folder listing is in the book's order.
pub(super) fn stem(number: &str) -> String {
    let (chapter, exercise) = number.split_once('.').unwrap_or((number, "0"));
    format!("{chapter:0>2}-{exercise}")
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{out_folder_with, stem};

    #[test]
    fn out_is_at_the_workspace_root() {
        let chapter = Path::new(env!("CARGO_MANIFEST_DIR"));
        let root = chapter.parent().expect("common is in the workspace's folder");
        assert_eq!(out_folder_with(chapter, None), root.join("out"));
        assert_eq!(out_folder_with(chapter, Some("".into())), root.join("out"));
        assert_eq!(out_folder_with(chapter, Some("other/out".into())), root.join("other/out"));
        let elsewhere = std::env::temp_dir().join("elsewhere");
        assert_eq!(out_folder_with(chapter, Some(elsewhere.clone().into())), elsewhere);
    }

    #[test]
    fn without_a_workspace_out_is_in_the_folder_itself() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        assert_eq!(out_folder_with(folder.path(), None), folder.path().join("out"));
    }

    #[test]
    fn files_sort_as_the_book_does() {
        assert_eq!(stem("1.2"), "01-2");
        assert_eq!(stem("12.3"), "12-3");
    }
}
