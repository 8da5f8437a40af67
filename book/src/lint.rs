//! What a page may not do. Each rule keeps a reader from being misled.

use std::collections::BTreeSet;
use std::path::Path;

use common::chapter::Entry;

use crate::chapters;
use crate::directive::{Directive, Directives, Kind};
use crate::expand;
use crate::html;
use crate::include::Include;
use crate::math;
use crate::outline::{Fence, Outline};
use crate::page::Page;
use crate::trouble::Problem;

/// A page, read.
#[derive(Debug)]
pub struct Read {
    /// Its source.
    pub page: Page,
    /// What is to be replaced in it.
    pub directives: Directives,
    /// Its fences, formulas, pictures and links.
    pub outline: Outline,
}

/// Reads a page and gathers what is wrong with it, as far as can be told without running a command.
pub fn read(page: Page, text: &Path, chapters: &[&Entry], problems: &mut Vec<Problem>) -> Read {
    let directives = crate::directive::scan(&page, problems);
    let outline = Outline::of(&page.text);
    let read = Read { page, directives, outline };
    for fence in &read.outline.fences {
        read.check_fence(fence, chapters, problems);
    }
    for directive in &read.directives.found {
        if let Err(message) = read.check_directive(directive, text) {
            problems.push(read.page.problem(directive.range.start, message));
        }
    }
    read.check_formulas(problems);
    for &offset in &read.outline.wordless {
        let message = "a picture without words; say what it shows: ![what it shows](file.png)";
        problems.push(read.page.problem(offset, message));
    }
    read
}

impl Read {
    /// Blocks of code say what they are, and Rust is included, never pasted.
    fn check_fence(&self, fence: &Fence, chapters: &[&Entry], problems: &mut Vec<Problem>) {
        let at = fence.range.start;
        let Some(label) = &fence.label else {
            let message = "a block of code without a label; begin it with ```text, ```sh or \
                 ```rust";
            problems.push(self.page.problem(at, message));
            return;
        };
        let pasted = |line: &str| !line.trim().is_empty() && !line.trim().starts_with("{{#include");
        if label == "rust" && fence.body.lines().any(pasted) {
            let message = "Rust that is pasted goes stale; mark it with an anchor in the chapter's \
                 source and show it with {{#include ../../chapters/...:anchor}}";
            problems.push(self.page.problem(at, message));
        }
        if label == "sh" {
            for package in packages(&fence.body) {
                if !is_package(package, chapters) {
                    let names = chapters::names(chapters);
                    let message = format!("there is no package '{package}'; chapters are: {names}");
                    problems.push(self.page.problem(at, message));
                }
            }
        }
    }

    fn check_directive(&self, directive: &Directive, text: &Path) -> Result<(), String> {
        let Directive { range, kind, arguments, texts } = directive;
        let in_fence = self.outline.fences.iter().any(|fence| contains(&fence.range, range.start));
        let in_code = self.outline.codes.iter().any(|code| contains(code, range.start));
        match kind {
            Kind::Include if !in_fence => {
                return Err("an include stands inside a labelled fence, such as ```rust".into());
            }
            Kind::Include => drop(self.included(arguments, text)?),
            _ if in_fence || in_code => {
                return Err("a directive in code; write \\{{# to show the braces".into());
            }
            kind if kind.is_block() && !self.stands_alone(directive) => {
                return Err("this directive makes a block: give it a line of its own, with an \
                     empty line before and after"
                    .into());
            }
            _ => {}
        }
        if kind.needs_text() {
            let caption = texts.first().map(String::as_str).unwrap_or_default();
            if html::plain(caption).is_empty() {
                return Err("a picture without words; say what it shows after a bar: \
                     {{#render ... | what it shows}}"
                    .into());
            }
            for text in texts {
                html::caption(text)?;
            }
        }
        // What needs no command is tried at once, before anybody waits for figures.
        match kind {
            Kind::Diagram => drop(expand::diagram(directive, text)?),
            Kind::Value => drop(expand::query(directive)?),
            _ => {}
        }
        Ok(())
    }

    /// The lines an include shows, and the file they are from.
    pub fn included(&self, argument: &str, text: &Path) -> Result<String, String> {
        let include = Include::parse(argument);
        let folder = text.join(self.page.path.parent().unwrap_or(Path::new("")));
        let path = folder.join(include.path);
        let file = std::fs::read_to_string(&path)
            .map_err(|error| format!("{} can't be included: {error}", include.path))?;
        include.lines(&file)
    }

    fn stands_alone(&self, directive: &Directive) -> bool {
        let line = self.page.line_range(directive.range.start);
        let before = self.page.text[..line.start].trim_end_matches([' ', '\t']);
        let after = self.page.text[line.end..].trim_start_matches([' ', '\t']);
        let alone = self.page.text[line].trim().len() == directive.range.len();
        let free_before = before.is_empty() || before.ends_with("\n\n");
        let free_after = after.trim().is_empty() || after.starts_with("\n\n");
        alone && free_before && free_after
    }

    /// Formulas can be read, and no directive is in one.
    fn check_formulas(&self, problems: &mut Vec<Problem>) {
        let in_directive = |offset: usize| {
            self.directives.found.iter().any(|directive| contains(&directive.range, offset))
        };
        for &offset in &self.outline.stray_dollars {
            if !in_directive(offset) {
                problems.push(self.page.problem(offset, html::STRAY_DOLLAR));
            }
        }
        for formula in &self.outline.formulas {
            let start = formula.range.start;
            if in_directive(start) {
                continue;
            }
            let inside = |directive: &Directive| contains(&formula.range, directive.range.start);
            if self.directives.found.iter().any(inside) {
                let message = "a directive in a formula; end the formula before it";
                problems.push(self.page.problem(start, message));
            } else if let Err(message) = math::mathml(&formula.latex, formula.display) {
                problems.push(self.page.problem(start, message));
            }
        }
    }
}

fn contains(range: &std::ops::Range<usize>, offset: usize) -> bool {
    range.contains(&offset)
}

/// The packages named after `-p` in cargo's command lines.
fn packages(shell: &str) -> impl Iterator<Item = &str> {
    let cargo_lines = shell.lines().filter(|line| line.trim_start().starts_with("cargo "));
    cargo_lines.flat_map(|line| {
        let cargo = line.split(" -- ").next().unwrap_or(line);
        let words: Vec<&str> = cargo.split_whitespace().collect();
        let named = words.windows(2).filter(|pair| matches!(pair[0], "-p" | "--package"));
        named.map(|pair| pair[1]).collect::<Vec<_>>()
    })
}

fn is_package(name: &str, chapters: &[&Entry]) -> bool {
    matches!(name, "book" | "common" | "tests")
        || chapters.iter().any(|entry| entry.package() == name)
}

/// Pages that SUMMARY.md does not name and drawings that no page shows.
pub fn unused(text: &Path, pages: &[Read]) -> Vec<Problem> {
    let named: BTreeSet<&Path> = pages.iter().map(|read| read.page.path.as_path()).collect();
    let directives = pages.iter().flat_map(|read| &read.directives.found);
    let drawings: BTreeSet<&str> = directives
        .filter(|directive| directive.kind == Kind::Diagram)
        .map(|directive| directive.arguments.as_str())
        .collect();
    let problem = |path: &Path, message: &str| Problem {
        page: format!("book/text/{}", path.display()),
        line: 0,
        message: message.into(),
    };
    let mut problems = Vec::new();
    for path in crate::watch::files(text) {
        let Ok(path) = path.strip_prefix(text) else { continue };
        let ending = path.extension().and_then(|ending| ending.to_str());
        let stem = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
        if ending == Some("md") && stem != "SUMMARY" && !named.contains(path) {
            problems.push(problem(path, "no line of SUMMARY.md leads to this page; add one"));
        }
        if path.starts_with("diagrams") && ending == Some("svg") && !drawings.contains(stem) {
            problems.push(problem(path, "no page shows this diagram; show it or remove it"));
        }
    }
    problems
}

#[cfg(test)]
mod tests;
