//! A page's source, and places in it.

use std::ops::Range;
use std::path::PathBuf;

use crate::trouble::Problem;

/// The source of a page, as it lies in `book/text`.
#[derive(Clone, Debug)]
pub struct Page {
    /// Where it is, below `book/text`: "01-ray-casting.md".
    pub path: PathBuf,
    /// Its Markdown, with directives.
    pub text: String,
}

impl Page {
    /// The line of the byte at `offset`, from 1.
    pub fn line(&self, offset: usize) -> usize {
        1 + self.text[..offset].matches('\n').count()
    }

    /// The text of the whole line around the byte at `offset`, without its end.
    pub fn whole_line(&self, offset: usize) -> &str {
        &self.text[self.line_range(offset)]
    }

    /// The bytes of the line around the byte at `offset`, without its end.
    pub fn line_range(&self, offset: usize) -> Range<usize> {
        let start = self.text[..offset].rfind('\n').map_or(0, |end| end + 1);
        let end = self.text[offset..].find('\n').map_or(self.text.len(), |length| offset + length);
        start..end
    }

    /// Something wrong at the byte at `offset`.
    pub fn problem(&self, offset: usize, message: impl Into<String>) -> Problem {
        Problem { page: self.name(), line: self.line(offset), message: message.into() }
    }

    /// The page's file for messages.
    pub fn name(&self) -> String {
        format!("book/text/{}", self.path.display())
    }

    /// How to reach the top of the book from this page: "" or "../" once a folder.
    pub fn to_top(&self) -> String {
        "../".repeat(self.path.components().count().saturating_sub(1))
    }
}

#[cfg(test)]
mod tests {
    use super::Page;

    #[test]
    fn lines_are_counted_from_one() {
        let page = Page { path: "deep/page.md".into(), text: "one\ntwo\n\nfour".into() };
        assert_eq!((page.line(0), page.line(4), page.line(9)), (1, 2, 4));
        assert_eq!(page.whole_line(5), "two");
        assert_eq!(page.whole_line(12), "four");
        assert_eq!(page.to_top(), "../");
        assert_eq!(page.problem(5, "odd").to_string(), "book/text/deep/page.md:2: odd");
    }
}
