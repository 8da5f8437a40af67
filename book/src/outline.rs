//! What Markdown makes of a page: its fences, formulas, pictures and links, with their places.

use std::ops::Range;

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag};

use crate::html::attribute;
use crate::math::Display;

/// The parts of a page that the book's rules are about.
#[derive(Debug, Default)]
pub struct Outline {
    /// Blocks of code.
    pub fences: Vec<Fence>,
    /// Code within a sentence.
    pub codes: Vec<Range<usize>>,
    /// Formulas.
    pub formulas: Vec<Formula>,
    /// Links and the files of pictures.
    pub links: Vec<Link>,
    /// Pictures without words for those who can't see them.
    pub wordless: Vec<usize>,
    /// Dollars that belong to no formula and are not escaped.
    pub stray_dollars: Vec<usize>,
}

/// A block of code.
#[derive(Debug)]
pub struct Fence {
    /// Its bytes in the page, fences included.
    pub range: Range<usize>,
    /// What it is labelled with; nothing for an indented block.
    pub label: Option<String>,
    /// The code.
    pub body: String,
}

/// A formula.
#[derive(Debug)]
pub struct Formula {
    /// Its bytes in the page, dollars included.
    pub range: Range<usize>,
    /// LaTeX.
    pub latex: String,
    /// Where it stands.
    pub display: Display,
}

/// A link.
#[derive(Debug)]
pub struct Link {
    /// Where it begins in the page.
    pub offset: usize,
    /// Where it leads, as the page has it.
    pub target: String,
}

impl Outline {
    /// Reads a page with the extensions that mdBook reads it with, and formulas.
    pub fn of(text: &str) -> Self {
        let options = Options::ENABLE_TABLES
            | Options::ENABLE_FOOTNOTES
            | Options::ENABLE_STRIKETHROUGH
            | Options::ENABLE_TASKLISTS
            | Options::ENABLE_HEADING_ATTRIBUTES
            | Options::ENABLE_DEFINITION_LIST
            | Options::ENABLE_GFM
            | Options::ENABLE_MATH;
        let mut outline = Self::default();
        let mut in_fence = false;
        let mut alts: Vec<(usize, bool)> = Vec::new();
        for (event, range) in Parser::new_ext(text, options).into_offset_iter() {
            if let Event::Text(words) | Event::Code(words) = &event {
                alts.iter_mut().for_each(|(_, says)| *says |= !words.trim().is_empty());
            }
            match event {
                Event::Start(Tag::CodeBlock(kind)) => {
                    in_fence = true;
                    outline.fences.push(Fence { range, label: label(&kind), body: String::new() });
                }
                Event::End(pulldown_cmark::TagEnd::CodeBlock) => in_fence = false,
                Event::Text(words) if in_fence => {
                    if let Some(fence) = outline.fences.last_mut() {
                        fence.body += &words;
                    }
                }
                Event::Text(_) => outline.stray_dollars.extend(stray_dollars(text, range)),
                Event::Code(_) => outline.codes.push(range),
                Event::InlineMath(latex) => outline.formula(range, &latex, Display::Inline),
                Event::DisplayMath(latex) => outline.formula(range, &latex, Display::Block),
                Event::Start(Tag::Link { dest_url, .. }) => outline.link(range.start, &dest_url),
                Event::Start(Tag::Image { dest_url, .. }) => {
                    outline.link(range.start, &dest_url);
                    alts.push((range.start, false));
                }
                Event::End(pulldown_cmark::TagEnd::Image) => {
                    outline.wordless.extend(alts.pop().filter(|(_, says)| !says).map(|(at, _)| at));
                }
                Event::Html(html) | Event::InlineHtml(html) => outline.html(range.start, &html),
                _ => {}
            }
        }
        outline
    }

    fn formula(&mut self, range: Range<usize>, latex: &str, display: Display) {
        self.formulas.push(Formula { range, latex: latex.into(), display });
    }

    fn link(&mut self, offset: usize, target: &str) {
        self.links.push(Link { offset, target: target.into() });
    }

    /// Links and pictures written in HTML.
    fn html(&mut self, offset: usize, html: &str) {
        for (start, _) in html.match_indices('<') {
            let tag = html[start + 1..].split('>').next().unwrap_or_default();
            for name in ["href", "src"] {
                if let Some(target) = attribute(tag, name) {
                    self.link(offset + start, target);
                }
            }
            let is_picture = tag.starts_with("img") && tag[3..].starts_with([' ', '\n', '/']);
            if is_picture && attribute(tag, "alt").is_none_or(|words| words.trim().is_empty()) {
                self.wordless.push(offset + start);
            }
        }
    }
}

/// The dollars in a piece of plain text that no backslash stands before: Markdown takes a formula
/// with unbalanced braces for text and says nothing.
pub fn stray_dollars(text: &str, range: Range<usize>) -> Vec<usize> {
    let dollars = text[range.clone()].match_indices('$').map(|(at, _)| range.start + at);
    dollars.filter(|&at| !text[..at].ends_with('\\')).collect()
}

/// The first word after a fence's backticks, or nothing.
fn label(kind: &CodeBlockKind) -> Option<String> {
    let CodeBlockKind::Fenced(info) = kind else { return None };
    info.split([' ', ',', '\t']).find(|word| !word.is_empty()).map(Into::into)
}

#[cfg(test)]
mod tests {
    use super::Outline;

    #[test]
    fn formulas_are_found_but_not_in_code() {
        let outline = Outline::of("Of $a$ and `$b$`:\n\n$$c$$\n\n```text\n$d$\n```\nno \\$e\\$\n");
        let found: Vec<&str> = outline.formulas.iter().map(|one| one.latex.as_str()).collect();
        assert_eq!(found, ["a", "c"]);
        assert_eq!(outline.codes.len(), 1);
    }

    #[test]
    fn links_and_pictures_are_found_in_markdown_and_html() {
        let text =
            "[a](b.md#c) ![](d.png)\n\n<a href=\"e.md\">e</a> <img src='f.png'>\n\n![x](g)\n";
        let outline = Outline::of(text);
        let targets: Vec<&str> = outline.links.iter().map(|link| link.target.as_str()).collect();
        assert_eq!(targets, ["b.md#c", "d.png", "e.md", "f.png", "g"]);
        assert_eq!(outline.wordless.len(), 2);
    }

    #[test]
    fn fences_have_labels_and_bodies() {
        let outline = Outline::of("```rust,ignore\na\nb\n```\n\n```\nc\n```\n");
        assert_eq!(outline.fences[0].label.as_deref(), Some("rust"));
        assert_eq!(outline.fences[0].body, "a\nb\n");
        assert_eq!(outline.fences[1].label, None);
    }
}
