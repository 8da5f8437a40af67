//! All chapters, and what they print when run inside this process.

use std::ffi::OsString;

use common::chapter::Entry;
use serde_json::Value;

/// Every chapter, in the book's order.
pub const CHAPTERS: [Entry; 6] = [
    Entry::of::<ray_casting::command::RayCasting>(),
    Entry::of::<triangles::command::Triangles>(),
    Entry::of::<object_order::command::ObjectOrder>(),
    Entry::of::<blinn_phong::command::LitScenes>(),
    Entry::of::<shadows::command::Shadows>(),
    Entry::of::<whitted::command::Whitted>(),
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
