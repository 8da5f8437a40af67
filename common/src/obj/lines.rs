//! The statements of a text file: lines without comments, continued lines made one.

use std::borrow::Cow;

use super::error::{ObjError, Problem};

/// One statement and where it begins.
#[derive(Debug, PartialEq)]
pub(super) struct Statement<'a> {
    /// The line of its first word, counted from 1.
    pub(super) line: u32,
    /// The text, trimmed and never empty.
    pub(super) text: Cow<'a, str>,
}

impl Statement<'_> {
    /// The first word.
    pub(super) fn keyword(&self) -> &str {
        self.text.split_whitespace().next().unwrap_or_default()
    }

    /// The words after the keyword, up to a trailing comment.
    pub(super) fn words(&self) -> impl Iterator<Item = &str> {
        let code = self.text.split_once('#').map_or(&*self.text, |(code, _comment)| code);
        code.split_whitespace().skip(1)
    }

    /// All after the keyword, trimmed. Names keep their `#`: 3ds Max writes `Material #25`.
    pub(super) fn rest(&self) -> &str {
        self.text[self.keyword().len()..].trim()
    }
}

/// Walks the statements of `bytes`. Lines end in LF, CRLF or CR; a line that ends in `\` goes on in
/// the next; blank lines and lines that begin with `#` are skipped; a byte order mark is passed over.
pub(super) struct Statements<'a> {
    file: &'a str,
    rest: &'a [u8],
    line: u32,
}

impl<'a> Statements<'a> {
    /// The statements of `bytes`; errors will name `file`.
    pub(super) fn new(file: &'a str, bytes: &'a [u8]) -> Self {
        let rest = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
        Self { file, rest, line: 0 }
    }

    /// The next line as bytes, trimmed, or `None` at the end.
    fn line(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        let end = self.rest.iter().position(|b| matches!(b, b'\n' | b'\r'));
        let end = end.unwrap_or(self.rest.len());
        let (line, rest) = self.rest.split_at(end);
        let ending = if rest.starts_with(b"\r\n") { 2 } else { rest.len().min(1) };
        self.rest = &rest[ending..];
        self.line += 1;
        Some(line.trim_ascii())
    }

    /// The text of the line just read, if it is text. NUL is legal UTF-8 and only binary files have it.
    fn text(&self, line: &'a [u8]) -> Result<&'a str, ObjError> {
        match std::str::from_utf8(line) {
            Ok(text) if !line.contains(&0) => Ok(text),
            _ => Err(Problem::NotText.at(self.file, self.line)),
        }
    }

    /// Appends the lines that continue `first`.
    fn continued(&mut self, first: &'a str) -> Result<Cow<'a, str>, ObjError> {
        let mut text = Cow::Borrowed(first);
        while let Some(head) = text.strip_suffix('\\') {
            let mut whole = head.to_owned();
            if let Some(next) = self.line() {
                whole.push(' ');
                whole.push_str(self.text(next)?);
            }
            text = Cow::Owned(whole);
        }
        Ok(text)
    }
}

impl<'a> Iterator for Statements<'a> {
    type Item = Result<Statement<'a>, ObjError>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            let line = self.line()?;
            // Old exporters wrote comments in the code page of their day. A NUL is no comment.
            if line.is_empty() || (line[0] == b'#' && !line.contains(&0)) {
                continue;
            }
            let start = self.line;
            let text = match self.text(line).and_then(|first| self.continued(first)) {
                Ok(text) => text,
                Err(error) => {
                    self.rest = &[];
                    return Some(Err(error));
                }
            };
            if !text.trim().is_empty() {
                return Some(Ok(Statement { line: start, text }));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen(bytes: &[u8]) -> Vec<(u32, String)> {
        Statements::new("t.obj", bytes)
            .map(|statement| statement.unwrap())
            .map(|statement| (statement.line, statement.text.trim().to_owned()))
            .collect()
    }

    #[test]
    fn every_line_ending_counts_once() {
        let text = b"\xef\xbb\xbfv 1\r\n\r\n# \xe9 \\\nv 2  \rv 3\n\n  v 4";
        let expected = [(1, "v 1"), (4, "v 2"), (5, "v 3"), (7, "v 4")];
        assert_eq!(seen(text), expected.map(|(line, text)| (line, text.to_owned())));
    }

    #[test]
    fn a_continued_line_is_one_statement_at_its_first_line() {
        let text = b"f 1 \\\r\n  2\\\n\\ \n 3\nv 7\\";
        assert_eq!(seen(text), [(1, "f 1  2  3".to_owned()), (5, "v 7".to_owned())]);
    }

    #[test]
    fn names_keep_what_numbers_drop() {
        let text = b"usemtl  Material #25 \nv 1 2 3 # inches";
        let found: Vec<_> = Statements::new("t.obj", text).map(Result::unwrap).collect();
        assert_eq!(found[0].rest(), "Material #25");
        assert_eq!(found[1].words().collect::<Vec<_>>(), ["1", "2", "3"]);
    }

    #[test]
    fn bytes_that_are_not_text_end_the_walk_and_name_the_line() {
        for bad in [&b"v 1\nv \xff 2\nv 3"[..], b"v 1\n#\0\nv 3", b"v 1\nv 2 \\\n\0"] {
            let found: Vec<_> = Statements::new("t.obj", bad).collect();
            let error = found.last().unwrap().as_ref().unwrap_err();
            assert_eq!(error.problem, Problem::NotText);
            assert!(error.line >= Some(2), "{error}");
        }
    }
}
