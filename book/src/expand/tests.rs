//! A page with every directive, filled by a chapter that draws nothing.

use std::path::Path;

use super::{Sources, expand};
use crate::cache::Cache;
use crate::fake::CHAPTERS;
use crate::figures::{self, Asked};
use crate::page::Page;
use crate::trouble::Problem;
use crate::{job, lint};

/// The page filled in, and its problems.
fn filled(folder: &Path, text: &str) -> (String, Vec<Problem>) {
    let mut problems = Vec::new();
    let page = Page { path: "page.md".into(), text: text.into() };
    let read = lint::read(page, folder, CHAPTERS, &mut problems);
    let mut asked = Asked::new();
    for directive in &read.directives.found {
        for job in job::of(directive, CHAPTERS).unwrap_or_default() {
            asked.entry(job).or_insert(read.page.problem(directive.range.start, ""));
        }
    }
    let cache = Cache::new(&folder.join("cache"), folder);
    let figures = figures::make(&asked, CHAPTERS, &cache, &mut problems).expect("they are made");
    let sources = Sources { text: folder, chapters: CHAPTERS, figures: &figures };
    let text = expand(&read, sources, &mut problems);
    (text, problems)
}

fn shown(text: &str) -> String {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (text, problems) = filled(folder.path(), text);
    assert_eq!(problems, [], "{text}");
    text
}

fn refused(text: &str, words: &str) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (_, problems) = filled(folder.path(), text);
    let told = problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n");
    assert!(told.contains(words), "{told}");
}

#[test]
fn a_picture_has_a_caption_and_its_command() {
    let text = shown("{{#render fake --size 640x480 | Of *two* $x$ | Two x}}\n");
    assert!(text.contains("alt=\"Two x\"") && text.contains("Of <em>two</em> <math"), "{text}");
    assert!(text.contains("<code>cargo run --release -p fake -- --size 640x480</code>"));
    assert!(shown("{{#hard-picture fake | Gaps}}\n").contains("alt=\"Gaps\""));
}

#[test]
fn values_come_from_commands() {
    assert_eq!(shown("{{#value fake -> counters / rays}} rays\n"), "307,200 rays\n");
    let table =
        "| a |\n|---|\n| {{#value fake hard -> FA-01 / naive_failures per trials \\| percent}} |\n";
    assert!(shown(table).contains("| 3.2 % |"));
    assert_eq!(shown("{{#value fake cost -> sums / naive, f32 / work}}"), "100");
    refused("{{#value fake -> counters / spheres}}", "there is: rays");
    refused("{{#value fake}}", "COMMAND -> PATH");
}

#[test]
fn tables_of_costs_and_hard_cases() {
    assert!(shown("{{#cost all}}").contains("Sums &amp; more"));
    assert!(shown("{{#cost fake sums}}").contains("<svg"));
    refused("{{#cost fake quotients}}", "there are: sums");
    let ledger = shown("{{#hard fake FA-01}}");
    assert!(ledger.contains("a &lt; b") && ledger.contains("<td class=\"number\">4,000</td>"));
    refused("{{#hard fake FA-02}}", "no hard case 'FA-02'; there are: FA-01");
}

#[test]
fn printed_text_stands_under_its_command() {
    let text = shown("{{#output fake}}");
    assert!(text.contains("-p fake</p>") && text.contains("written to out/07-fake.png"), "{text}");
    assert!(shown("{{#refused fake --size 0x0}}").contains("error: a picture needs"));
    assert!(shown("{{#output fake cost}}").contains("naive, f32"));
    refused("{{#refused fake}}", "should be refused");
}

#[test]
fn code_and_diagrams_come_from_files() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::create_dir(folder.path().join("diagrams")).expect("it can be made");
    let write = |name: &str, text: &str| {
        std::fs::write(folder.path().join(name), text).expect("it can be written");
    };
    write("a.rs", "// ANCHOR: a\n    let x = \"$y$\";\n// ANCHOR_END: a\n");
    write("diagrams/eye.svg", "<svg viewBox=\"0 0 9 9\"><path/></svg>");
    let page = "```rust\n{{#include a.rs:a}}\n```\n\n{{#diagram eye | An eye | It *sees*}}\n";
    let (text, problems) = filled(folder.path(), page);
    assert_eq!(problems, []);
    assert!(text.starts_with("<p class=\"listing\">a.rs</p>\n\n```rust\nlet x = \"$y$\";\n```"));
    assert!(text.contains("<title>An eye</title>") && text.contains("It <em>sees</em>"), "{text}");
    refused("{{#diagram ear | An ear}}", "book/text/diagrams/ear.svg");
}

#[test]
fn formulas_become_mathml_and_escaped_braces_stay() {
    let text = shown("Of $a_i b_i$ in `\\{{#value x}}`, not `$c$`.\n");
    assert!(text.contains("<math") && !text.contains("$a"), "{text}");
    assert!(text.ends_with("in `{{#value x}}`, not `$c$`.\n"), "{text}");
}
