//! Jobs: the command lines that a page's directives need run.

use common::chapter::Entry;

use crate::chapters;
use crate::directive::{Directive, Kind};

/// One command line of a chapter, and what is kept of it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Job {
    /// The chapter's package.
    pub package: String,
    /// What a reader types after `--`.
    pub arguments: Vec<String>,
    /// What is kept.
    pub keep: Keep,
}

/// What is kept of a command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Keep {
    /// Its JSON and its picture.
    Json,
    /// What it prints, and its picture.
    Text,
    /// Its measured tables and their plots.
    Cost,
    /// What it says when it refuses its work, as it must.
    Refusal,
}

impl Job {
    /// The job for the words of a command, such as "ray-casting --size 320x240".
    pub fn parse(words: &str, keep: Keep, chapters: &[&Entry]) -> Result<Self, String> {
        let mut words = words.split_whitespace().map(str::to_string);
        let package = words.next().unwrap_or_default();
        if !chapters.iter().any(|entry| entry.package() == package) {
            let names = chapters::names(chapters);
            return Err(format!("there is no chapter '{package}'; there are: {names}"));
        }
        let arguments: Vec<String> = words.collect();
        let ours = ["--json", "--out", "--quiet"];
        if let Some(word) = arguments.iter().find(|word| ours.contains(&word.as_str())) {
            return Err(format!("leave out {word}: the book adds what it needs"));
        }
        Ok(Self { package, arguments, keep })
    }

    /// The words of the command, as a page has them.
    pub fn words(&self) -> String {
        let words = std::iter::once(&self.package).chain(&self.arguments);
        words.map(String::as_str).collect::<Vec<_>>().join(" ")
    }

    /// The command line that a reader types.
    pub fn typed(&self) -> String {
        let dashes = if self.arguments.is_empty() { "" } else { " -- " };
        format!("cargo run --release -p {}{dashes}{}", self.package, self.arguments.join(" "))
    }

    /// The subcommand, if it is not a render.
    pub fn subcommand(&self) -> Option<&str> {
        self.arguments.first().map(String::as_str).filter(|word| !word.starts_with('-'))
    }
}

/// The jobs that a directive needs done, in the order it shows them.
pub fn of(directive: &Directive, chapters: &[&Entry]) -> Result<Vec<Job>, String> {
    let arguments = directive.arguments.as_str();
    let first = arguments.split_whitespace().next().unwrap_or_default();
    let one = |words: &str, keep| Job::parse(words, keep, chapters).map(|job| vec![job]);
    let each = |subcommand: &str, keep| match first {
        "all" => chapters
            .iter()
            .map(|entry| Job::parse(&format!("{} {subcommand}", entry.package()), keep, chapters))
            .collect(),
        package => one(&format!("{package} {subcommand}"), keep),
    };
    match directive.kind {
        Kind::Include | Kind::Diagram => Ok(Vec::new()),
        Kind::Render => {
            let job = Job::parse(arguments, Keep::Json, chapters)?;
            match job.subcommand() {
                Some(word) => Err(format!("'{word}' draws nothing; see the directive '{word}'")),
                None => Ok(vec![job]),
            }
        }
        Kind::Value => {
            let words = arguments.split_once("->").map_or(arguments, |(words, _path)| words);
            let job = Job::parse(words, Keep::Json, chapters)?;
            let keep = if job.subcommand() == Some("cost") { Keep::Cost } else { Keep::Json };
            Ok(vec![Job { keep, ..job }])
        }
        Kind::Output => {
            let job = Job::parse(arguments, Keep::Text, chapters)?;
            // The table a page prints is the one it plots, not a second measurement.
            let keep = if job.arguments == ["cost"] { Keep::Cost } else { Keep::Text };
            Ok(vec![Job { keep, ..job }])
        }
        Kind::Refused => one(arguments, Keep::Refusal),
        Kind::Cost => each("cost", Keep::Cost),
        Kind::Hard | Kind::HardPicture => each("hard", Keep::Json),
    }
}

#[cfg(test)]
mod tests {
    use super::{Job, Keep, of};
    use crate::directive::scan;
    use crate::fake::CHAPTERS;
    use crate::page::Page;

    fn jobs(text: &str) -> Result<Vec<Job>, String> {
        let page = Page { path: "page.md".into(), text: text.into() };
        of(&scan(&page, &mut Vec::new()).found[0], CHAPTERS)
    }

    fn job(arguments: &[&str], keep: Keep) -> Result<Vec<Job>, String> {
        let arguments = arguments.iter().map(ToString::to_string).collect();
        Ok(vec![Job { package: "fake".into(), arguments, keep }])
    }

    #[test]
    fn directives_share_jobs() {
        let render = jobs("{{#render fake --size 2x1 | a}}");
        assert_eq!(render, job(&["--size", "2x1"], Keep::Json));
        assert_eq!(jobs("{{#value fake --size 2x1 -> width}}"), render);
        assert_eq!(jobs("{{#hard fake FA-01}}"), jobs("{{#value fake hard -> FA-01 / trials}}"));
        assert_eq!(jobs("{{#hard all}}"), jobs("{{#hard-picture fake | a}}"));
        assert_eq!(jobs("{{#cost fake sums}}"), jobs("{{#output fake cost}}"));
        assert_eq!(jobs("{{#refused fake --size 0x0}}"), job(&["--size", "0x0"], Keep::Refusal));
    }

    #[test]
    fn a_reader_types_the_whole_command_line() {
        let typed = |words| Job::parse(words, Keep::Json, CHAPTERS).map(|job| job.typed());
        assert_eq!(typed("fake").as_deref(), Ok("cargo run --release -p fake"));
        let long = "cargo run --release -p fake -- --size 2x1";
        assert_eq!(typed("fake --size 2x1").as_deref(), Ok(long));
    }

    #[test]
    fn what_no_chapter_can_run_is_refused() {
        assert!(jobs("{{#render fakes | a}}").is_err_and(|why| why.contains("there are: fake")));
        assert!(jobs("{{#render fake hard | a}}").is_err_and(|why| why.contains("draws nothing")));
        assert!(jobs("{{#output fake --quiet}}").is_err_and(|why| why.contains("leave out")));
        assert!(jobs("{{#cost}}").is_err());
    }
}
