//! All chapters, and what they print when run inside this process.

use std::ffi::OsString;

use common::chapter::Entry;
use serde_json::Value;

/// Every chapter, in the book's order.
pub static CHAPTERS: [&Entry; 16] = [
    &ray_casting::command::PROGRAM,
    &triangles::command::PROGRAM,
    &object_order::command::PROGRAM,
    &blinn_phong::command::PROGRAM,
    &shadows::command::PROGRAM,
    &whitted::command::PROGRAM,
    &fresnel::command::PROGRAM,
    &boxes::command::PROGRAM,
    &partitions::command::PROGRAM,
    &bvh::command::PROGRAM,
    &monte_carlo::command::PROGRAM,
    &path_tracing::command::PROGRAM,
    &light_sampling::command::PROGRAM,
    &russian_roulette::command::PROGRAM,
    &microfacets::command::PROGRAM,
    &multiple_importance::command::PROGRAM,
];

/// What the chapter's command line prints. Panics with the chapter's own message if it fails.
pub fn print(chapter: &Entry, arguments: &str) -> String {
    let arguments: Vec<OsString> = arguments.split_whitespace().map(OsString::from).collect();
    let mut out = Vec::new();
    if let Err(failure) = (chapter.run)(&arguments, &mut out) {
        panic!("{} {arguments:?}: {failure}", chapter.id);
    }
    String::from_utf8(out).expect("programs print UTF-8")
}

/// The JSON object of a render; its picture goes to a temporary folder.
pub fn render(chapter: &Entry, arguments: &str) -> Value {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let picture = folder.path().join("picture.exr");
    let text = print(chapter, &format!("{arguments} --json --out {}", picture.display()));
    serde_json::from_str(&text).expect("one JSON object")
}
