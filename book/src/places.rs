//! Where things are.

use std::path::{Path, PathBuf};

use crate::trouble::Trouble;

/// The folders the book is made from and made into.
#[derive(Clone, Debug)]
pub struct Places {
    /// The workspace.
    pub root: PathBuf,
    /// The book's crate.
    pub book: PathBuf,
    /// The pages.
    pub text: PathBuf,
    /// The figures that are kept.
    pub cache: PathBuf,
    /// The finished book.
    pub site: PathBuf,
    /// The book while it is made; renamed to `site` when nothing is wrong with it.
    pub draft: PathBuf,
}

impl Places {
    /// The places in the workspace at `root`.
    pub fn at(root: &Path) -> Self {
        Self {
            root: root.into(),
            book: root.join("book"),
            text: root.join("book/text"),
            cache: root.join("out/cache"),
            site: root.join("out/book"),
            draft: root.join("out/book-in-the-making"),
        }
    }

    /// The workspace around the current folder, or else the one this program was compiled in.
    pub fn find() -> Result<Self, Trouble> {
        let current = std::env::current_dir().unwrap_or_default();
        let compiled = Path::new(env!("CARGO_MANIFEST_DIR"));
        let mut around = current.ancestors().chain(compiled.parent());
        let root = around.find(|root| Self::at(root).text.join("SUMMARY.md").is_file());
        root.map(Self::at).ok_or_else(|| {
            let message = "book/text/SUMMARY.md can't be found; run this inside the workspace";
            Trouble::Work(message.into())
        })
    }
}
