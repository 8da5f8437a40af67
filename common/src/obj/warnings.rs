//! What is worth saying about a file that can still be used.

/// How many warnings are kept in words; a hostile file must not make a list as long as itself.
const KEPT: usize = 20;

/// A list of warnings with an end.
#[derive(Debug, Default)]
pub(super) struct Warnings {
    texts: Vec<String>,
    more: usize,
}

impl Warnings {
    /// Adds a warning about `line` of `file`.
    pub(super) fn add(&mut self, file: &str, line: u32, text: &str) {
        if self.texts.len() < KEPT {
            self.texts.push(format!("{file}:{line}: {text}"));
        } else {
            self.more += 1;
        }
    }

    /// The warnings in words, the last one saying how many more there were.
    pub(super) fn into_texts(mut self, file: &str) -> Vec<String> {
        if self.more > 0 {
            self.texts.push(format!("{file}: and {} more warnings", self.more));
        }
        self.texts
    }
}

/// Things of one sort: how many there are and the line of the first.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tally {
    count: u32,
    first: u32,
}

impl Tally {
    /// Counts one at `line`.
    pub(super) fn add(&mut self, line: u32) {
        if self.count == 0 {
            self.first = line;
        }
        self.count += 1;
    }

    /// The line of the first, if there is one.
    pub(super) fn first(self) -> Option<u32> {
        (self.count > 0).then_some(self.first)
    }

    /// One warning for all of them, `what` following the count.
    pub(super) fn warn(self, file: &str, what: &str, warnings: &mut Warnings) {
        if let Some(line) = self.first() {
            warnings.add(file, line, &format!("{} {what} (this line is the first)", self.count));
        }
    }
}
