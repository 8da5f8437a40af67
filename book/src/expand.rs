//! Puts what files and commands gave into a page.

use std::ops::Range;
use std::path::Path;

use common::chapter::Entry;
use serde::Deserialize;
use serde_json::Value;

use crate::cache::Made;
use crate::cost::{self, Sheet};
use crate::directive::{Directive, Kind};
use crate::figures::Figures;
use crate::html;
use crate::job::{self, Job, Keep};
use crate::lint::Read;
use crate::math;
use crate::number::Format;
use crate::trouble::Problem;
use crate::value::Query;

/// What pages are filled from.
#[derive(Clone, Copy)]
pub struct Sources<'a> {
    /// The folder of the pages.
    pub text: &'a Path,
    /// All chapters.
    pub chapters: &'a [&'a Entry],
    /// What their commands made.
    pub figures: &'a Figures,
}

/// The folder of the pictures in the finished book.
pub const PICTURES: &str = "figures";

/// The Markdown of a page for mdBook, all directives and formulas replaced; `problems` gets the
/// directives that can't be.
pub fn expand(read: &Read, sources: Sources, problems: &mut Vec<Problem>) -> String {
    let mut changes: Vec<(Range<usize>, String)> = Vec::new();
    for directive in &read.directives.found {
        match replacement(read, directive, sources) {
            Ok(text) => changes.push((directive.range.clone(), text)),
            Err(message) => problems.push(read.page.problem(directive.range.start, message)),
        }
    }
    let taken = changes.clone();
    for formula in &read.outline.formulas {
        let in_directive = taken.iter().any(|(range, _)| range.contains(&formula.range.start));
        if let (false, Ok(text)) = (in_directive, math::mathml(&formula.latex, formula.display)) {
            changes.push((formula.range.clone(), text));
        }
    }
    changes.extend(read.directives.escapes.iter().map(|&at| (at..at + 1, String::new())));
    changes.extend(headings(read));
    apply(&read.page.text, changes)
}

/// The name of the file above each listing.
fn headings(read: &Read) -> impl Iterator<Item = (Range<usize>, String)> {
    read.outline.fences.iter().filter_map(|fence| {
        let line = fence.body.lines().find(|line| !line.trim().is_empty())?;
        let argument = line.trim().strip_prefix("{{#include ")?.split([':', '}']).next()?;
        let path = argument.trim_start_matches("../");
        let start = fence.range.start;
        Some((start..start, format!("<p class=\"listing\">{}</p>\n\n", html::escape(path))))
    })
}

/// The text with each range replaced; ranges don't overlap.
fn apply(text: &str, mut changes: Vec<(Range<usize>, String)>) -> String {
    changes.sort_by_key(|(range, _)| (range.start, range.end));
    let mut result = String::with_capacity(text.len() * 2);
    let mut from = 0;
    for (range, new) in changes {
        result += &text[from..range.start];
        result += &new;
        from = range.end;
    }
    result + &text[from..]
}

fn replacement(read: &Read, directive: &Directive, sources: Sources) -> Result<String, String> {
    let jobs = job::of(directive, sources.chapters)?;
    let made = |job: &Job| {
        sources.figures.get(job).ok_or_else(|| format!("`{}` made nothing", job.typed()))
    };
    let each = |show: &dyn Fn(&Job, &Made) -> Result<String, String>| {
        let shown: Result<Vec<String>, String> =
            jobs.iter().map(|job| show(job, made(job)?)).collect();
        shown.map(|shown| shown.join("\n\n"))
    };
    match directive.kind {
        Kind::Include => read.included(&directive.arguments, sources.text),
        Kind::Diagram => diagram(directive, sources.text),
        Kind::Render | Kind::HardPicture => {
            each(&|job, made| picture(directive, job, made, &read.page.to_top()))
        }
        Kind::Output | Kind::Refused => each(&printed),
        Kind::Value => each(&|job, made| value(directive, job, made)),
        Kind::Cost => each(&|job, made| costs(directive, job, made)),
        Kind::Hard => {
            let ledgers: Result<Vec<Ledger>, String> =
                jobs.iter().map(|job| Ledger::of(job, made(job)?)).collect();
            hard(directive, &ledgers?)
        }
    }
}

/// A picture with its caption and the command that makes it.
fn picture(directive: &Directive, job: &Job, made: &Made, to_top: &str) -> Result<String, String> {
    if made.picture.is_none() {
        return Err(format!("`{}` writes no picture", job.typed()));
    }
    let caption = directive.texts.first().map(String::as_str).unwrap_or_default();
    let alt = html::escape(&html::plain(directive.texts.get(1).map_or(caption, String::as_str)));
    let (caption, command) = (html::caption(caption)?, html::escape(&job.typed()));
    Ok(format!(
        "<figure>\n<img src=\"{to_top}{PICTURES}/{}\" alt=\"{alt}\">\n<figcaption>{caption}\
         <br><code>{command}</code></figcaption>\n</figure>",
        made.file
    ))
}

/// What a command prints, under the command itself.
fn printed(job: &Job, made: &Made) -> Result<String, String> {
    let text = match job.keep {
        Keep::Cost => {
            sheets(made)?.into_iter().map(|sheet| sheet.printed).collect::<Vec<_>>().join("\n")
        }
        _ => made.text.clone(),
    };
    let text = html::escape(text.trim_end());
    // A blank line would end the block of HTML, so each is written as a letter.
    let text = text.replace("\n\n", "\n&#10;").replace("\n\n", "\n&#10;");
    let command = html::escape(&job.typed());
    Ok(format!(
        "<div class=\"output\">\n<p class=\"listing\">{command}</p>\n<pre><code \
         class=\"language-text nohighlight\">{text}</code></pre>\n</div>"
    ))
}

/// Which value a directive asks for.
pub fn query(directive: &Directive) -> Result<Query, String> {
    let path = directive.arguments.split_once("->").map_or("", |(_words, path)| path);
    Query::parse(path, directive.texts.first().map(String::as_str))
}

fn value(directive: &Directive, job: &Job, made: &Made) -> Result<String, String> {
    let query = query(directive)?;
    let root = match job.keep {
        Keep::Cost => cost::values(&sheets(made)?),
        _ => serde_json::from_str(&made.text)
            .map_err(|error| format!("`{}` printed no JSON: {error}", job.typed()))?,
    };
    query.answer(&root)
}

fn sheets(made: &Made) -> Result<Vec<Sheet>, String> {
    serde_json::from_str(&made.text).map_err(|error| {
        format!("the kept figure can't be read: {error}; delete the folder out/cache")
    })
}

/// A chapter's experiments, or the one that is named.
fn costs(directive: &Directive, job: &Job, made: &Made) -> Result<String, String> {
    let wanted = directive.arguments.split_whitespace().nth(1);
    let all = sheets(made)?;
    let names = all.iter().map(|sheet| sheet.name.clone()).collect::<Vec<_>>().join(", ");
    let chosen = all.iter().filter(|sheet| wanted.is_none_or(|name| sheet.name == name));
    let shown: Result<Vec<String>, String> = chosen.map(|sheet| sheet.html(&job.typed())).collect();
    match (shown?, wanted) {
        (shown, Some(name)) if shown.is_empty() => {
            Err(format!("there is no experiment '{name}'; there are: {names}"))
        }
        (shown, _) => Ok(shown.join("\n\n")),
    }
}

/// A chapter's part of the ledger.
struct Ledger {
    command: String,
    rows: Vec<Row>,
}

/// A row of `hard --json`.
#[derive(Deserialize)]
struct Row {
    id: String,
    chapter: String,
    input: String,
    trials: f64,
    naive_failures: f64,
    robust_failures: f64,
}

impl Ledger {
    fn of(job: &Job, made: &Made) -> Result<Self, String> {
        let command = job.typed();
        let rows = serde_json::from_str::<Value>(&made.text).and_then(serde_json::from_value);
        let rows = rows.map_err(|error| format!("`{command}` printed no ledger: {error}"))?;
        Ok(Self { command, rows })
    }
}

/// Rows of the ledger as one table, and the commands that print them.
fn hard(directive: &Directive, ledgers: &[Ledger]) -> Result<String, String> {
    let wanted: Vec<&str> = directive.arguments.split_whitespace().skip(1).collect();
    let all = || ledgers.iter().flat_map(|ledger| &ledger.rows);
    if let Some(id) = wanted.iter().find(|id| all().all(|row| row.id != **id)) {
        let ids = all().map(|row| row.id.clone()).collect::<Vec<_>>().join(", ");
        return Err(format!("there is no hard case '{id}'; there are: {ids}"));
    }
    let count = |value| Format::Default.write(value);
    let rows: Vec<Vec<String>> = all()
        .filter(|row| wanted.is_empty() || wanted.contains(&row.id.as_str()))
        .map(|row| {
            let mut cells = vec![row.id.clone(), html::escape(&row.input), count(row.trials)];
            cells.extend([count(row.naive_failures), count(row.robust_failures)]);
            if ledgers.len() > 1 {
                cells.insert(1, html::escape(&row.chapter));
            }
            cells
        })
        .collect();
    let mut head = vec!["case", "input", "trials", "naive fails", "robust fails"];
    let mut numbers = vec![false, false, true, true, true];
    if ledgers.len() > 1 {
        head.insert(1, "chapter");
        numbers.insert(1, false);
    }
    let head: Vec<String> = head.into_iter().map(Into::into).collect();
    let commands: Vec<String> = ledgers
        .iter()
        .map(|ledger| format!("<code>{}</code>", html::escape(&ledger.command)))
        .collect();
    let (table, commands) = (html::table(&head, &rows, &numbers), commands.join("<br>"));
    Ok(format!("<figure class=\"hard\">\n{table}\n<figcaption>{commands}</figcaption>\n</figure>"))
}

/// A drawing from `book/text/diagrams`, and its caption if it has one.
pub fn diagram(directive: &Directive, text: &Path) -> Result<String, String> {
    let name = &directive.arguments;
    let path = text.join("diagrams").join(format!("{name}.svg"));
    let shown = format!("book/text/diagrams/{name}.svg");
    let svg = std::fs::read_to_string(path).map_err(|error| format!("{shown}: {error}"))?;
    let says = html::plain(directive.texts.first().map(String::as_str).unwrap_or_default());
    let svg = html::inline_svg(&svg, &says).map_err(|why| format!("{shown}: {why}"))?;
    let caption = match directive.texts.get(1) {
        Some(caption) => format!("\n<figcaption>{}</figcaption>", html::caption(caption)?),
        None => String::new(),
    };
    Ok(format!("<figure class=\"diagram\">\n{svg}{caption}\n</figure>"))
}

#[cfg(test)]
mod tests;
