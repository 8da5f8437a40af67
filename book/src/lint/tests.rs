//! Each rule has a page that must fail, and one like it that must not.

use std::path::Path;

use super::{read, unused};
use crate::fake::CHAPTERS;
use crate::page::Page;
use crate::trouble::Problem;

fn problems_in(folder: &Path, text: &str) -> Vec<Problem> {
    let page = Page { path: "page.md".into(), text: text.into() };
    let mut problems = Vec::new();
    read(page, folder, CHAPTERS, &mut problems);
    problems
}

/// The page has this one problem, on this line.
fn fails(text: &str, line: usize, words: &str) {
    let problems = problems_in(Path::new("."), text);
    assert_eq!(problems.len(), 1, "{text}: {problems:?}");
    assert_eq!(problems[0].line, line, "{text}");
    assert!(problems[0].message.contains(words), "{text}: {}", problems[0]);
}

fn passes(text: &str) {
    assert_eq!(problems_in(Path::new("."), text), [], "{text}");
}

#[test]
fn a_fence_has_a_label() {
    fails("One.\n\n```\nx\n```\n", 3, "without a label");
    fails("One.\n\n    indented\n", 3, "without a label");
    passes("```text\nx\n```\n");
}

#[test]
fn rust_is_not_pasted() {
    fails("```rust\nfn main() {}\n```\n", 1, "pasted");
    fails("```rust,ignore\nfn main() {}\n```\n", 1, "pasted");
}

#[test]
fn an_include_has_a_file_an_anchor_and_lines() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let source = "// ANCHOR: a\nlet x = 1;\n// ANCHOR_END: a\n// ANCHOR: b\n// ANCHOR_END: b\n";
    std::fs::write(folder.path().join("a.rs"), source).expect("it can be written");
    let check = |argument: &str| {
        let text = format!("# One\n\n```rust\n{{{{#include {argument}}}}}\n```\n");
        problems_in(folder.path(), &text).iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    assert_eq!(check("a.rs:a"), [""; 0]);
    for (argument, words) in
        [("b.rs:a", "can't be included"), ("a.rs:c", "no anchor 'c'"), ("a.rs:b", "is empty")]
    {
        let problems = check(argument);
        assert!(problems.len() == 1 && problems[0].contains(words), "{argument}: {problems:?}");
        assert!(problems[0].starts_with("book/text/page.md:4: "), "{problems:?}");
    }
}

#[test]
fn an_include_is_in_a_fence_and_other_directives_are_not() {
    fails("{{#include a.rs}}\n", 1, "inside a labelled fence");
    fails("```text\n{{#value fake -> width}}\n```\n", 2, "a directive in code");
    fails("The `{{#value fake -> width}}`\n", 1, "a directive in code");
    passes("The `\\{{#value fake -> width}}`\n");
}

#[test]
fn a_block_has_a_line_of_its_own() {
    fails("See {{#cost fake}}\n", 1, "a line of its own");
    fails("See\n{{#cost fake}}\n", 2, "a line of its own");
    passes("See\n\n{{#cost fake}}\n\nand {{#value fake -> width}} pixels\n");
}

#[test]
fn a_picture_has_words() {
    fails("![](a.png)\n", 1, "without words");
    fails("One.\n\n<img src=\"a.png\">\n", 3, "without words");
    fails("{{#render fake}}\n", 1, "without words");
    fails("{{#diagram eye |  }}\n", 1, "without words");
    passes("![a](a.png) <img src=\"a.png\" alt=\"a\">\n\n{{#render fake | a}}\n");
}

#[test]
fn a_formula_can_be_read() {
    fails("One.\n\nOf $\\frac{1}$.\n", 3, "can't be read");
    fails("One.\n\nOf $\\frac{1 alone.\n", 3, "a dollar that begins no formula");
    fails("{{#render fake | of $t}}\n", 1, "a dollar that begins no formula");
    fails("{{#render fake | of $\\nosuch$}}\n", 1, "can't be read");
    fails("$$t = {{#value fake -> width}}$$\n", 1, "a directive in a formula");
    passes("Of \\$5, $\\frac{1}{2}$ and `$\\frac{1$`.\n\n{{#render fake | of $t_{a_{b}}$}}\n");
}

#[test]
fn a_command_names_a_package_that_is_there() {
    fails("```sh\ncargo run --release -p fakes -- --size 2x1\n```\n", 1, "no package 'fakes'");
    passes("```sh\ncargo run --release -p fake -- -p x\ncargo test -p common\n```\n");
}

#[test]
fn a_diagram_is_there_and_a_value_has_a_path() {
    fails("One.\n\n{{#diagram ear | An ear}}\n", 3, "book/text/diagrams/ear.svg");
    fails("{{#value fake}} rays\n", 1, "COMMAND -> PATH");
    fails("{{#value fake -> width | 3 digit places}} rays\n", 1, "is no format");
}

#[test]
fn pages_and_diagrams_are_used() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let write = |name: &str| {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().expect("it has one")).expect("it can be made");
        std::fs::write(path, "x").expect("it can be written");
    };
    for name in ["SUMMARY.md", "page.md", "lost.md", "diagrams/a.svg", "diagrams/lost.svg"] {
        write(name);
    }
    let page = Page { path: "page.md".into(), text: "{{#diagram a | an eye}}\n".into() };
    let pages = [read(page, folder.path(), CHAPTERS, &mut Vec::new())];
    let problems = unused(folder.path(), &pages);
    let named: Vec<&str> = problems.iter().map(|problem| problem.page.as_str()).collect();
    assert_eq!(named, ["book/text/diagrams/lost.svg", "book/text/lost.md"]);
}
