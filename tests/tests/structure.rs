//! The shape of the project: every chapter has its parts, and arrows run from later to earlier.

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};

use tests::chapters::CHAPTERS;
use tests::program::workspace;

/// The chapters' folders, in order.
fn folders() -> Vec<PathBuf> {
    let entries = fs::read_dir(workspace().join("chapters")).expect("there are chapters");
    let mut folders: Vec<PathBuf> =
        entries.map(|entry| entry.expect("a folder can be read").path()).collect();
    folders.sort();
    folders
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn the_list_of_chapters_is_complete_and_in_order() {
    let folders = folders();
    let names: Vec<&str> =
        folders.iter().map(|folder| folder.file_name().unwrap().to_str().unwrap()).collect();
    assert_eq!(names, CHAPTERS.map(|chapter| chapter.id));
}

#[test]
fn every_chapter_has_its_parts_and_a_short_main() {
    const PARTS: [&str; 7] = [
        "src/lib.rs",
        "src/naive.rs",
        "src/exercises.rs",
        "src/main.rs",
        "tests/exercises/main.rs",
        "tests/exercises/solutions.rs",
        "tests/exercises/mistakes.rs",
    ];
    for folder in folders() {
        let missing = PARTS.iter().find(|part| !folder.join(part).exists());
        assert_eq!(missing, None, "{}", folder.display());
        assert!(text(&folder.join("src/main.rs")).lines().count() <= 40, "{}", folder.display());
    }
}

#[test]
fn a_chapter_depends_on_earlier_ones_only() {
    for (index, folder) in folders().iter().enumerate() {
        let manifest = text(&folder.join("Cargo.toml"));
        for later in &CHAPTERS[index..] {
            let dependency = format!("\n{}.workspace", later.package());
            assert!(!manifest.contains(&dependency), "{} on {}", folder.display(), later.id);
        }
    }
}

#[test]
fn every_chapter_has_four_exercises_or_more_each_with_a_test() {
    for folder in folders() {
        let stubs = text(&folder.join("src/exercises.rs")).matches("todo!(\"exercise ").count();
        let gates = text(&folder.join("tests/exercises/main.rs")).matches("#[test]").count();
        assert!(stubs >= 4, "{}: {stubs} stubs", folder.display());
        assert!(gates >= stubs, "{}: {gates} tests for {stubs} stubs", folder.display());
    }
}

#[test]
fn no_two_hard_cases_of_a_chapter_share_a_name() {
    let mut names = HashSet::new();
    let common = common::hard::pixels::CASES;
    let cases = common.into_iter().chain(CHAPTERS.iter().flat_map(|chapter| (chapter.hard)()));
    for case in cases {
        assert!(names.insert((case.chapter, case.id)), "{} is there twice", case.id);
    }
}
