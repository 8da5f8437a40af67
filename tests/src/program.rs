//! The chapters' real programs, built as they are for a reader.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;

/// The folder of the whole project.
pub fn workspace() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the tests lie in the workspace")
}

/// A chapter's program, optimized as for `cargo run --release`. All are built if need be.
pub fn program(package: &str) -> PathBuf {
    static BUILT: OnceLock<PathBuf> = OnceLock::new();
    BUILT.get_or_init(build).join(package)
}

/// Builds all programs but the book's and gives the folder they are in.
fn build() -> PathBuf {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    let mut command = Command::new(cargo);
    command.current_dir(workspace()).args(["build", "--quiet", "--release", "--bins"]);
    for chapter in crate::chapters::CHAPTERS {
        command.args(["-p", chapter.package()]);
    }
    assert!(command.status().expect("cargo runs").success(), "{command:?}");
    target_folder().join("release")
}

/// `target`, from the place of this test's own program: `target/debug/deps/…`.
fn target_folder() -> PathBuf {
    let own = std::env::current_exe().expect("a test knows where it is");
    own.ancestors().nth(3).expect("it lies three folders deep").to_path_buf()
}

/// Runs a program in a folder of its own; nothing comes in on standard input.
pub fn run(program: &Path, folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(program);
    command.current_dir(folder).args(arguments).stdin(Stdio::null());
    command.output().expect("the program starts")
}
