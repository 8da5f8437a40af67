//! Included lines: a file, or the part of it between two anchors.

/// A piece of a file that a page shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Include<'a> {
    /// The file, as the page names it.
    pub path: &'a str,
    /// The anchor, or nothing for the whole file.
    pub anchor: Option<&'a str>,
}

impl<'a> Include<'a> {
    /// Reads `path` or `path:anchor`.
    pub fn parse(argument: &'a str) -> Self {
        match argument.split_once(':') {
            Some((path, anchor)) => Self { path, anchor: Some(anchor) },
            None => Self { path: argument, anchor: None },
        }
    }

    /// The lines of `file` that it shows, without the indentation they share. Fails if there are
    /// none: mdBook would print an empty listing and say nothing.
    pub fn lines(&self, file: &str) -> Result<String, String> {
        let lines = match self.anchor {
            None => file.lines().filter(|line| !is_marker(line)).collect(),
            Some(anchor) => {
                anchored(file, anchor).map_err(|why| format!("{}: {why}", self.path))?
            }
        };
        if lines.iter().all(|line| line.trim().is_empty()) {
            return Err(format!("the include of {} is empty", self.path));
        }
        Ok(outdented(&lines))
    }
}

fn anchored<'a>(file: &'a str, anchor: &str) -> Result<Vec<&'a str>, String> {
    let marks = |line: &&str, word: &str| marker(line, word) == Some(anchor);
    let mut rest = file.lines().skip_while(|line| !marks(line, "ANCHOR:"));
    let word = "// ANCHOR:";
    rest.next().ok_or(format!("there is no anchor '{anchor}'; mark it with `{word} {anchor}`"))?;
    let mut lines = Vec::new();
    for line in rest {
        if marks(&line, "ANCHOR_END:") {
            return Ok(lines);
        }
        if !is_marker(line) {
            lines.push(line);
        }
    }
    Err(format!("the anchor '{anchor}' has no end; mark it with `// ANCHOR_END: {anchor}`"))
}

/// The name after `word` in a line that marks an anchor.
fn marker<'a>(line: &'a str, word: &str) -> Option<&'a str> {
    line.split_once(word).map(|(_before, name)| name.trim())
}

fn is_marker(line: &str) -> bool {
    marker(line, "ANCHOR:").or(marker(line, "ANCHOR_END:")).is_some()
}

/// The lines without the blanks that all of them begin with.
fn outdented(lines: &[&str]) -> String {
    let indent = |line: &&&str| line.len() - line.trim_start().len();
    let shared =
        lines.iter().filter(|line| !line.trim().is_empty()).map(|line| indent(&line)).min();
    let cut = |line: &&str| line.get(shared.unwrap_or(0)..).unwrap_or("").to_string();
    lines.iter().map(cut).collect::<Vec<_>>().join("\n").trim_matches('\n').to_string()
}

#[cfg(test)]
mod tests {
    use super::Include;

    const FILE: &str = "\
fn a() {
    // ANCHOR: outer
    let b = 1;
    // ANCHOR: inner
    if b {
        c();
    }
    // ANCHOR_END: inner
    // ANCHOR_END: outer
}
// ANCHOR: hollow

// ANCHOR_END: hollow
// ANCHOR: endless
";

    fn lines(argument: &str) -> Result<String, String> {
        Include::parse(argument).lines(FILE)
    }

    #[test]
    fn anchors_nest_and_indentation_goes() {
        assert_eq!(lines("a.rs:inner").as_deref(), Ok("if b {\n    c();\n}"));
        assert_eq!(lines("a.rs:outer").as_deref(), Ok("let b = 1;\nif b {\n    c();\n}"));
        assert!(lines("a.rs").is_ok_and(|all| !all.contains("ANCHOR")));
    }

    #[test]
    fn a_missing_anchor_is_refused() {
        assert!(lines("a.rs:inne").is_err_and(|why| why.contains("there is no anchor 'inne'")));
    }

    #[test]
    fn an_empty_or_endless_include_is_refused() {
        assert!(lines("a.rs:hollow").is_err_and(|why| why.contains("is empty")));
        assert!(lines("a.rs:endless").is_err_and(|why| why.contains("has no end")));
    }
}
