//! The chapters the book can run, in their order.

use blinn_phong::command::LitScenes;
use common::chapter::Entry;
use object_order::command::ObjectOrder;
use ray_casting::command::RayCasting;
use shadows::command::Shadows;
use triangles::command::Triangles;
use whitted::command::Whitted;

/// Every chapter; a new one is added at the end.
pub const CHAPTERS: &[Entry] = &[
    Entry::of::<RayCasting>(),
    Entry::of::<Triangles>(),
    Entry::of::<ObjectOrder>(),
    Entry::of::<LitScenes>(),
    Entry::of::<Shadows>(),
    Entry::of::<Whitted>(),
];

/// The chapter that a reader calls `name`: "1", "01", "01-ray-casting" or "ray-casting".
pub fn find<'a>(chapters: &'a [Entry], name: &str) -> Option<&'a Entry> {
    let number = name.parse::<u32>().ok();
    chapters.iter().find(|entry| {
        let (digits, package) = entry.id.split_once('-').unwrap_or(("", entry.id));
        entry.id == name || package == name || (number.is_some() && digits.parse().ok() == number)
    })
}

/// The packages' names in one line, for messages.
pub fn names(chapters: &[Entry]) -> String {
    chapters.iter().map(Entry::package).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::find;
    use crate::fake::CHAPTERS;

    #[test]
    fn a_chapter_answers_to_four_names() {
        for name in ["7", "07", "07-fake", "fake"] {
            assert!(find(CHAPTERS, name).is_some_and(|entry| entry.id == "07-fake"), "{name}");
        }
        for name in ["", "8", "-7", "fak", "07-"] {
            assert!(find(CHAPTERS, name).is_none(), "{name}");
        }
    }
}
