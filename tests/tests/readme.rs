//! Every command the README prints can be typed.

use common::chapter::{Entry, Failure};
use tests::chapters::{CHAPTERS, print};
use tests::program::workspace;

fn readme() -> String {
    std::fs::read_to_string(workspace().join("README.md")).expect("there is a README")
}

/// The command lines of the README, in code blocks and in the table.
fn commands(readme: &str) -> Vec<&str> {
    let words = readme.split(['`', '\n', '|']).map(str::trim);
    words.filter(|word| word.starts_with("cargo ")).collect()
}

/// The front door's commands and the tests' are run by `.ci/run`; the chapters' are run here, small.
#[test]
fn every_command_is_a_command() {
    let readme = readme();
    let commands = commands(&readme);
    assert!(commands.len() >= 5, "{commands:?}");
    for command in commands {
        let known = match command.strip_prefix("cargo run --release -p ") {
            Some(line) => runs(line),
            None => {
                matches!(
                    command.split(" -- ").next(),
                    Some(
                        "cargo run --release" | "cargo test --workspace" | "cargo bench -p common"
                    )
                ) || tests_a_chapter(command)
            }
        };
        assert!(known, "the README says `{command}`");
    }
}

/// Runs a chapter's command line at a small size.
fn runs(line: &str) -> bool {
    let (package, arguments) = line.split_once(" -- ").unwrap_or((line, ""));
    let Some(chapter) = CHAPTERS.iter().find(|chapter| chapter.package() == package) else {
        return false;
    };
    if arguments == "--help" {
        return matches!(
            (chapter.run)(&["--help".into()], &mut Vec::new()),
            Err(Failure::CommandLine(_))
        );
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = folder.path().join(if arguments.starts_with("cost") { "out.svg" } else { "out.png" });
    let small = match arguments.split_whitespace().next() {
        Some("cost") => "--rounds 1",
        Some("hard") => "--trials 1000",
        _ if arguments.contains("--size") => "",
        _ => "--size 32x24",
    };
    !print(chapter, &format!("{arguments} {small} --out {}", out.display())).is_empty()
}

fn tests_a_chapter(command: &str) -> bool {
    CHAPTERS
        .iter()
        .any(|chapter| command == format!("cargo test -p {} --test exercises", chapter.package()))
}

#[test]
fn every_chapter_has_its_row() {
    let readme = readme();
    for chapter in &CHAPTERS {
        let command = format!("`cargo run --release -p {}`", chapter.package());
        assert!(readme.contains(&command), "{command}");
    }
}

/// The options with which `assets/README.md` draws a chapter's picture.
fn drawn_with<'a>(assets: &'a str, chapter: &Entry) -> &'a str {
    let start = format!("cargo run --release -p {} -- ", chapter.package());
    let line = assets.lines().find_map(|line| line.strip_prefix(&start));
    let options = line.and_then(|line| line.split(" --out ").next());
    options.unwrap_or_else(|| panic!("assets/README.md does not draw {}", chapter.id))
}

/// The README's pictures are what the chapters draw today, pixel by pixel.
#[test]
fn the_pictures_are_the_chapters_own() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let assets = std::fs::read_to_string(workspace().join("assets/README.md"));
    let assets = assets.expect("there is a README");
    for chapter in &CHAPTERS {
        let new = folder.path().join("new.png");
        let options = drawn_with(&assets, chapter);
        print(chapter, &format!("{options} --out {}", new.display()));
        let kept = workspace().join(format!("assets/pictures/{}.png", chapter.id));
        let [kept, new] = [kept, new].map(|path| image::open(path).expect("a picture").into_rgb8());
        assert!(kept == new, "make it again: assets/README.md says how ({})", chapter.id);
    }
}
