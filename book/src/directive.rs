//! Directives: `{{#name arguments | text}}`, the places in a page that a command or a file fills.

use std::ops::Range;

use crate::page::Page;
use crate::trouble::Problem;

/// What a directive asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Lines of a file.
    Include,
    /// A picture that a chapter draws.
    Render,
    /// A chapter's measured experiments.
    Cost,
    /// Rows of the ledger of hard cases.
    Hard,
    /// The picture of a failure.
    HardPicture,
    /// One number or word.
    Value,
    /// A drawing from `book/text/diagrams`.
    Diagram,
    /// What a command prints.
    Output,
    /// What a command says that must fail.
    Refused,
}

const NAMES: [(&str, Kind); 9] = [
    ("include", Kind::Include),
    ("render", Kind::Render),
    ("cost", Kind::Cost),
    ("hard", Kind::Hard),
    ("hard-picture", Kind::HardPicture),
    ("value", Kind::Value),
    ("diagram", Kind::Diagram),
    ("output", Kind::Output),
    ("refused", Kind::Refused),
];

impl Kind {
    fn from_name(name: &str) -> Option<Self> {
        NAMES.iter().find(|(known, _)| *known == name).map(|(_, kind)| *kind)
    }

    /// Whether it makes a block of its own, not words in a sentence or lines of a fence.
    pub fn is_block(self) -> bool {
        !matches!(self, Self::Include | Self::Value)
    }

    /// Whether it makes a picture that needs words for those who can't see it.
    pub fn needs_text(self) -> bool {
        matches!(self, Self::Render | Self::HardPicture | Self::Diagram)
    }
}

/// A directive in a page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Directive {
    /// Its bytes in the page, braces included.
    pub range: Range<usize>,
    /// What it asks for.
    pub kind: Kind,
    /// What follows its name.
    pub arguments: String,
    /// What follows the bars: a caption, an alternative text, a format.
    pub texts: Vec<String>,
}

/// All directives of a page.
#[derive(Debug, Default)]
pub struct Directives {
    /// Those to be replaced.
    pub found: Vec<Directive>,
    /// The backslashes before braces that are to be shown and not obeyed.
    pub escapes: Vec<usize>,
}

const OPEN: &str = "{{#";
const CLOSE: &str = "}}";

/// Finds the directives of a page; `problems` gets those that can't be read.
pub fn scan(page: &Page, problems: &mut Vec<Problem>) -> Directives {
    let mut directives = Directives::default();
    let mut from = 0;
    while let Some(start) = page.text[from..].find(OPEN).map(|offset| from + offset) {
        from = start + OPEN.len();
        if page.text[..start].ends_with('\\') {
            directives.escapes.push(start - 1);
            continue;
        }
        match read(page, start) {
            Ok(directive) => {
                from = directive.range.end;
                directives.found.push(directive);
            }
            Err(message) => problems.push(page.problem(start, message)),
        }
    }
    directives
}

fn read(page: &Page, start: usize) -> Result<Directive, String> {
    let line = page.line_range(start);
    let rest = &page.text[start..line.end];
    // A directive alone on its line may hold a formula with `}}` in its caption.
    let alone = page.whole_line(start).trim().starts_with(OPEN)
        && rest.trim_end().ends_with(CLOSE)
        && rest.matches(OPEN).count() == 1;
    let close = if alone { rest.rfind(CLOSE) } else { rest.find(CLOSE) };
    let close = close.ok_or("a directive must end with `}}` on the line where it begins")?;
    let inside = rest[OPEN.len()..close].replace("\\|", "|");
    let mut parts = inside.split(" | ").map(|part| part.trim().to_string());
    let command = parts.next().unwrap_or_default();
    let (name, arguments) = command.split_once(char::is_whitespace).unwrap_or((&command, ""));
    let Some(kind) = Kind::from_name(name) else {
        let known = NAMES.map(|(name, _)| name).join(", ");
        return Err(format!("there is no directive '{name}'; there are: {known}"));
    };
    let range = start..start + close + CLOSE.len();
    Ok(Directive { range, kind, arguments: arguments.trim().into(), texts: parts.collect() })
}

#[cfg(test)]
mod tests {
    use super::{Kind, scan};
    use crate::page::Page;

    fn page(text: &str) -> Page {
        Page { path: "page.md".into(), text: text.into() }
    }

    #[test]
    fn a_directive_has_a_name_arguments_and_texts() {
        let page = page("One {{#value fake hard -> A / b \\| percent}} of two\n");
        let found = scan(&page, &mut Vec::new()).found;
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].kind, Kind::Value);
        assert_eq!(found[0].arguments, "fake hard -> A / b");
        assert_eq!(found[0].texts, ["percent"]);
        assert_eq!(&page.text[found[0].range.end..], " of two\n");
    }

    #[test]
    fn a_caption_may_end_a_formula() {
        let page = page("{{#render fake | where $a_{b_{c}}$ is}}\n");
        assert_eq!(scan(&page, &mut Vec::new()).found[0].texts, ["where $a_{b_{c}}$ is"]);
    }

    #[test]
    fn a_backslash_shows_the_braces() {
        let directives = scan(&page("\\{{#render x}}"), &mut Vec::new());
        assert_eq!((directives.found.len(), directives.escapes), (0, vec![0]));
    }

    #[test]
    fn unknown_and_unclosed_directives_are_problems() {
        let mut problems = Vec::new();
        scan(&page("\n{{#rendr x}}\n{{#value y\n}}\n"), &mut problems);
        assert_eq!(problems.len(), 2);
        assert!(problems[0].to_string().starts_with("book/text/page.md:2: there is no directive"));
        assert_eq!(problems[1].line, 3);
    }
}
