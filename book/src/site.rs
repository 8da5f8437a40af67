//! Builds the book: pages, figures, HTML, and only then the exchange for the old one.

use std::path::PathBuf;

use common::chapter::Entry;
use mdbook_driver::MDBook;
use mdbook_driver::book::Chapter;
use mdbook_driver::config::Config;

use crate::cache::Cache;
use crate::expand::{PICTURES, Sources, expand};
use crate::figures::{self, Asked, Figures};
use crate::lint::{self, Read};
use crate::page::Page;
use crate::places::Places;
use crate::trouble::{Problem, Trouble};
use crate::{job, links};

/// The pages of the book, and what its chapters made for them.
struct Manuscript {
    book: MDBook,
    pages: Vec<Read>,
    figures: Figures,
}

/// Makes all figures.
pub fn make_figures(places: &Places, chapters: &[&Entry]) -> Result<usize, Trouble> {
    prepare(places, chapters).map(|manuscript| manuscript.figures.len())
}

/// Builds the whole book; gives its first page. The book that was there before stays until the new
/// one is without a problem.
pub fn build(places: &Places, chapters: &[&Entry]) -> Result<PathBuf, Trouble> {
    let mut manuscript = prepare(places, chapters)?;
    fill(&mut manuscript, places, chapters)?;
    let draft = Draft::of(&manuscript, places)?;
    refuse(links::check(&places.draft, &manuscript.pages))?;
    draft.publish(places)
}

/// Reads and checks the pages and makes their figures.
fn prepare(places: &Places, chapters: &[&Entry]) -> Result<Manuscript, Trouble> {
    let book = load(places)?;
    let mut problems = Vec::new();
    let pages: Vec<Read> = book
        .book
        .chapters()
        .filter_map(page)
        .map(|page| lint::read(page, &places.text, chapters, &mut problems))
        .collect();
    problems.extend(lint::unused(&places.text, &pages));
    let asked = asked(&pages, chapters, &mut problems);
    refuse(problems)?;
    let cache = Cache::new(&places.cache, &places.root.join("assets"));
    let mut failed = Vec::new();
    let figures = figures::make(&asked, chapters, &cache, &mut failed)?;
    refuse(failed)?;
    Ok(Manuscript { book, pages, figures })
}

fn load(places: &Places) -> Result<MDBook, Trouble> {
    let settings = places.book.join("book.toml");
    let broken = |what: &str, error: mdbook_driver::errors::Error| {
        Trouble::Work(format!("{what}: {error:#}"))
    };
    let mut config =
        Config::from_disk(&settings).map_err(|error| broken("book/book.toml", error))?;
    config.build.build_dir = places.draft.clone();
    MDBook::load_with_config(&places.book, config)
        .map_err(|error| broken("book/text/SUMMARY.md", error))
}

fn page(chapter: &Chapter) -> Option<Page> {
    Some(Page { path: chapter.path.clone()?, text: chapter.content.clone() })
}

/// Every job the pages need, with the first place that needs it.
fn asked(pages: &[Read], chapters: &[&Entry], problems: &mut Vec<Problem>) -> Asked {
    let mut asked = Asked::new();
    for read in pages {
        for directive in &read.directives.found {
            let at = directive.range.start;
            match job::of(directive, chapters) {
                Ok(jobs) => jobs.into_iter().for_each(|job| {
                    asked.entry(job).or_insert_with(|| read.page.problem(at, ""));
                }),
                Err(message) => problems.push(read.page.problem(at, message)),
            }
        }
    }
    asked
}

/// Puts files and figures into the pages.
fn fill(manuscript: &mut Manuscript, places: &Places, chapters: &[&Entry]) -> Result<(), Trouble> {
    let Manuscript { book, pages, figures } = manuscript;
    let sources = Sources { text: &places.text, chapters, figures };
    let mut problems = Vec::new();
    book.book.for_each_chapter_mut(|chapter| {
        let read = pages.iter().find(|read| chapter.path.as_ref() == Some(&read.page.path));
        if let Some(read) = read {
            chapter.content = expand(read, sources, &mut problems);
        }
    });
    refuse(problems)
}

fn refuse(mut problems: Vec<Problem>) -> Result<(), Trouble> {
    problems.sort();
    problems.dedup();
    if problems.is_empty() { Ok(()) } else { Err(Trouble::Problems(problems)) }
}

/// The new book, beside the old one; goes away if it is not published.
struct Draft(PathBuf);

impl Draft {
    fn of(manuscript: &Manuscript, places: &Places) -> Result<Self, Trouble> {
        let draft = Self(places.draft.clone());
        manuscript.book.build().map_err(|error| {
            Trouble::Work(format!("mdBook could not make the pages: {error:#}"))
        })?;
        let folder = draft.0.join(PICTURES);
        let fail = |error| Trouble::with(&folder, &error);
        std::fs::create_dir_all(&folder).map_err(fail)?;
        for made in manuscript.figures.values() {
            if let Some(picture) = &made.picture {
                std::fs::copy(picture, folder.join(&made.file)).map_err(fail)?;
            }
        }
        Ok(draft)
    }

    /// Takes the old book's place.
    fn publish(self, places: &Places) -> Result<PathBuf, Trouble> {
        let fail = |error| Trouble::with(&places.site, &error);
        if places.site.exists() {
            std::fs::remove_dir_all(&places.site).map_err(fail)?;
        }
        std::fs::rename(&self.0, &places.site).map_err(fail)?;
        Ok(places.site.join("index.html"))
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        // It has been renamed when all went well.
        let _gone = std::fs::remove_dir_all(&self.0);
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::build;
    use crate::fake::CHAPTERS;
    use crate::places::Places;
    use crate::trouble::Trouble;

    fn workspace(page: &str) -> (tempfile::TempDir, Places) {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let places = Places::at(folder.path());
        std::fs::create_dir_all(&places.text).expect("it can be made");
        let write =
            |path: &Path, text: &str| std::fs::write(path, text).expect("it can be written");
        write(&places.book.join("book.toml"), include_str!("../book.toml"));
        write(&places.book.join("first-light.css"), "");
        write(&places.text.join("SUMMARY.md"), "# Summary\n\n[One](one.md)\n");
        write(&places.text.join("one.md"), page);
        (folder, places)
    }

    #[test]
    fn a_book_has_its_pages_and_pictures() {
        let page = "# One\n\n{{#render fake | It $x$}}\n\nSee [above](#one).\n";
        let (_folder, places) = workspace(page);
        let index = build(&places, CHAPTERS).expect("nothing is wrong with it");
        let html = std::fs::read_to_string(index).expect("it is there");
        assert!(html.contains("<math") && html.contains("src=\"figures/fake-"), "{html}");
        let pictures = std::fs::read_dir(places.site.join("figures")).expect("a folder");
        assert_eq!(pictures.count(), 1);
        assert!(!places.draft.exists());
    }

    #[test]
    fn a_wrong_page_leaves_the_old_book_alone() {
        let (_folder, places) = workspace("# One\n");
        let index = build(&places, CHAPTERS).expect("nothing is wrong with it");
        for (page, told) in [
            ("# One\n\n[two](two.md)\n", "one.md:3: the link 'two.md' leads nowhere"),
            ("# One\n\n[x](#two)\n", "one.md:3: the link '#two' leads to no heading"),
            ("# One\n\n{{#render fake --size 0x0 | a}}\n", "one.md:3: `cargo run"),
            ("# One\n\n{{#render fakes | a}}\n", "one.md:3: there is no chapter 'fakes'"),
        ] {
            std::fs::write(places.text.join("one.md"), page).expect("it can be written");
            let Err(Trouble::Problems(problems)) = build(&places, CHAPTERS) else {
                panic!("it was built: {page}");
            };
            assert!(problems[0].to_string().contains(told), "{}", problems[0]);
            assert!(index.is_file() && !places.draft.exists());
        }
    }

    #[test]
    fn a_page_that_is_not_there_is_named() {
        let (_folder, places) = workspace("# One\n");
        std::fs::remove_file(places.text.join("one.md")).expect("it is there");
        let told = build(&places, CHAPTERS).expect_err("a page is missing").to_string();
        assert!(told.contains("SUMMARY.md") && told.contains("one.md"), "{told}");
    }
}
