//! Follows every link of the pages in the finished book.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};

use crate::lint::Read;
use crate::trouble::Problem;

/// The links of `pages` that lead nowhere in the book at `site`.
pub fn check(site: &Path, pages: &[Read]) -> Vec<Problem> {
    let mut names = BTreeMap::new();
    let mut problems = Vec::new();
    for read in pages {
        for link in &read.outline.links {
            if let Err(message) = follow(&link.target, &read.page.path, site, &mut names) {
                problems.push(read.page.problem(link.offset, message));
            }
        }
    }
    problems
}

/// The fragments each file has, found once.
type Names = BTreeMap<PathBuf, BTreeSet<String>>;

fn follow(target: &str, page: &Path, site: &Path, names: &mut Names) -> Result<(), String> {
    if let Some((scheme, rest)) = target.split_once(':') {
        return external(scheme, rest)
            .map_err(|why| format!("the link '{target}' can't be right: {why}"));
    }
    let (path, fragment) = match target.split_once('#') {
        Some((path, fragment)) => (path, Some(fragment)),
        None => (target, None),
    };
    let page = page.with_extension("html");
    let file = match path {
        "" => page,
        path => inside(&page.parent().unwrap_or(Path::new("")).join(as_html(path)))
            .ok_or(format!("the link '{target}' leads out of the book; name the file instead"))?,
    };
    let file = site.join(file);
    if !file.is_file() {
        return Err(format!("the link '{target}' leads nowhere: there is no such page or file"));
    }
    let Some(fragment) = fragment else { return Ok(()) };
    let names = names.entry(file.clone()).or_insert_with(|| fragments(&file));
    if names.contains(fragment) {
        return Ok(());
    }
    let there: Vec<&str> = names.iter().map(String::as_str).collect();
    Err(format!("the link '{target}' leads to no heading; the page has: {}", there.join(", ")))
}

/// Only the form of an external link is checked: a build must not need a network.
fn external(scheme: &str, rest: &str) -> Result<(), String> {
    match scheme {
        "http" | "https" => {
            let host = rest.strip_prefix("//").unwrap_or_default().split('/').next();
            let good = host.is_some_and(|host| {
                host.contains('.') && !host.contains("..") && !host.starts_with('.')
            });
            let blank = rest.contains(char::is_whitespace);
            if good && !blank { Ok(()) } else { Err("it names no host".into()) }
        }
        "mailto" if rest.contains('@') => Ok(()),
        other => Err(format!("'{other}' is not http, https or mailto")),
    }
}

/// The file mdBook makes of a page.
fn as_html(path: &str) -> PathBuf {
    let path = Path::new(path);
    if path.extension().is_some_and(|ending| ending == "md") {
        path.with_extension("html")
    } else {
        path.into()
    }
}

/// The path without `..`, or nothing if it leads out of the book.
fn inside(path: &Path) -> Option<PathBuf> {
    let mut inside = PathBuf::new();
    for part in path.components() {
        match part {
            Component::Normal(name) => inside.push(name),
            Component::CurDir => {}
            Component::ParentDir if inside.pop() => {}
            _ => return None,
        }
    }
    Some(inside)
}

/// Every `id` of a page.
fn fragments(file: &Path) -> BTreeSet<String> {
    let html = std::fs::read_to_string(file).unwrap_or_default();
    let main = html.split_once("<main>").map_or(html.as_str(), |(_before, main)| main);
    let main = main.split("</main>").next().unwrap_or(main);
    let ids = main.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next());
    ids.map(Into::into).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::follow;

    fn check(target: &str) -> Result<(), String> {
        let site = tempfile::tempdir().expect("a temporary folder");
        let write = |name: &str, text: &str| {
            std::fs::write(site.path().join(name), text).expect("it can be written");
        };
        write(
            "one.html",
            "<nav id=\"menu\"></nav><main><h2 class=\"x\" id=\"the-eye\"></h2></main>",
        );
        write("two.html", "<main><h2 id=\"the-ear\"></h2></main>");
        write("a.svg", "");
        follow(target, Path::new("one.md"), site.path(), &mut Default::default())
    }

    #[test]
    fn links_that_lead_somewhere() {
        for good in [
            "two.md",
            "./two.md#the-ear",
            "#the-eye",
            "two.html",
            "a.svg",
            "https://www.rust-lang.org/learn",
            "mailto:a@b.org",
        ] {
            assert_eq!(check(good), Ok(()), "{good}");
        }
    }

    #[test]
    fn dead_links_are_refused() {
        for (dead, words) in [
            ("three.md", "no such page"),
            ("two.md#the-eye", "the page has: the-ear"),
            ("#menu", "no heading"),
            ("b.svg", "no such page or file"),
            ("../../common/src/lib.rs", "out of the book"),
            ("/etc/passwd", "out of the book"),
        ] {
            assert!(check(dead).is_err_and(|why| why.contains(words)), "{dead}: {:?}", check(dead));
        }
    }

    #[test]
    fn external_links_need_a_host() {
        for dead in [
            "http://",
            "https:/rust-lang.org",
            "https://a b.org",
            "ftp://a.org",
            "http://localhost",
        ] {
            assert!(check(dead).is_err_and(|why| why.contains("can't be right")), "{dead}");
        }
    }
}
