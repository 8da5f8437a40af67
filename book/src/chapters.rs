//! The chapters the book can run, in their order.

use common::chapter::Entry;

/// Every chapter; a new one is added at the end.
pub static CHAPTERS: &[&Entry] = &[
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

/// The chapter that a reader calls `name`: "1", "01", "01-ray-casting" or "ray-casting".
pub fn find<'a>(chapters: &'a [&'a Entry], name: &str) -> Option<&'a Entry> {
    let number = name.parse::<u32>().ok();
    chapters.iter().copied().find(|entry| {
        let (digits, package) = entry.id.split_once('-').unwrap_or(("", entry.id));
        entry.id == name || package == name || (number.is_some() && digits.parse().ok() == number)
    })
}

/// The packages' names in one line, for messages.
pub fn names(chapters: &[&Entry]) -> String {
    chapters.iter().map(|entry| entry.package()).collect::<Vec<_>>().join(", ")
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
