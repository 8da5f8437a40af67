//! How far the reader's exercises are: runs their tests and reads the verdicts.

use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use common::chapter::Entry;
use serde::Deserialize;

use crate::chapters;
use crate::places::Places;
use crate::trouble::{Trouble, say};
use crate::watch;

/// A verdict, as `common::exercise` writes it to `out/exercises/NN-K.json`.
#[derive(Debug, Deserialize)]
struct Verdict {
    number: String,
    title: String,
    section: String,
    status: String,
    mistake: Option<String>,
    diagnosis: Option<String>,
    first: Option<Difference>,
    page: Option<String>,
}

/// The first case that differs.
#[derive(Debug, Deserialize)]
struct Difference {
    case: String,
    expected: String,
    yours: String,
}

/// Judges the exercises of the chapter called `name`, or of all, and says which is the next.
pub fn run(
    places: &Places,
    chapters: &[&Entry],
    name: Option<&str>,
    out: &mut dyn Write,
) -> Result<(), Trouble> {
    let chosen = choose(chapters, name)?;
    let mut next = None;
    for entry in chosen {
        let verdicts = judge(places, entry)?;
        writeln!(out, "{}", entry.id)?;
        for verdict in &verdicts {
            write!(out, "{}", told(verdict))?;
        }
        writeln!(out)?;
        out.flush()?;
        let open = verdicts.into_iter().find(|verdict| verdict.status != "done");
        next = next.or(open.map(|verdict| (entry, verdict)));
    }
    match next {
        Some((entry, verdict)) => writeln!(out, "{}", invitation(places, entry, &verdict))?,
        None => writeln!(out, "All of them are done.")?,
    }
    Ok(())
}

fn choose<'a>(chapters: &'a [&'a Entry], name: Option<&str>) -> Result<Vec<&'a Entry>, Trouble> {
    let Some(name) = name else { return Ok(chapters.to_vec()) };
    // An exercise's number stands for its chapter: all of them are judged in the same run.
    let chapter = match name.split_once('.') {
        Some((chapter, exercise)) if exercise.parse::<u32>().is_ok() => chapter,
        _ => name,
    };
    chapters::find(chapters, chapter).map(|entry| vec![entry]).ok_or_else(|| {
        let list: String = chapters.iter().map(|entry| format!("\n  {}", entry.id)).collect();
        Trouble::Usage(format!("there is no chapter '{name}'; there are:{list}"))
    })
}

/// Runs a chapter's exercise tests; gives their verdicts in the order of their numbers.
fn judge(places: &Places, entry: &Entry) -> Result<Vec<Verdict>, Trouble> {
    let folder = places.root.join("out/exercises");
    for path in verdict_files(&folder, entry) {
        std::fs::remove_file(&path).map_err(|error| Trouble::with(&path, &error))?;
    }
    say(format_args!("judging the exercises of {} ...", entry.id));
    let compiled = cargo(places, entry, &["--quiet", "--no-run"]).status().map_err(no_cargo)?;
    if !compiled.success() {
        let file = answers(entry);
        return Err(Trouble::Work(format!(
            "{} does not compile, so its exercises can't be judged; the compiler's message is \
             above. Mend what it names, most likely {file}, and run this again",
            entry.id
        )));
    }
    let output = cargo(places, entry, &["--quiet"]).output().map_err(no_cargo)?;
    let verdicts = read(&folder, entry)?;
    if verdicts.is_empty() { Err(silent(entry, &output)) } else { Ok(verdicts) }
}

/// `cargo test` of a chapter's exercises, with the cargo that runs this program.
fn cargo(places: &Places, entry: &Entry, options: &[&str]) -> Command {
    let program = std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let mut command = Command::new(program);
    command.current_dir(&places.root).args(["test", "-p", entry.package(), "--test", "exercises"]);
    command.args(options).env_remove("FIRST_LIGHT_OUT");
    command
}

fn no_cargo(error: std::io::Error) -> Trouble {
    Trouble::Work(format!("cargo can't be started: {error}; run this by `cargo exercises`"))
}

fn silent(entry: &Entry, output: &Output) -> Trouble {
    let text = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes));
    let id = entry.id;
    Trouble::Work(format!("the exercises of {id} gave no verdict:\n{}\n{}", text[0], text[1]))
}

/// The verdicts' files of a chapter.
fn verdict_files(folder: &Path, entry: &Entry) -> Vec<PathBuf> {
    let prefix = entry.id.split_once('-').map_or(entry.id, |(number, _name)| number);
    let is_ours = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.starts_with(&format!("{prefix}-")) && name.ends_with(".json")
    };
    watch::files(folder).into_iter().filter(is_ours).collect()
}

fn read(folder: &Path, entry: &Entry) -> Result<Vec<Verdict>, Trouble> {
    let mut verdicts = Vec::new();
    for path in verdict_files(folder, entry) {
        let text = std::fs::read_to_string(&path).map_err(|error| Trouble::with(&path, &error))?;
        let verdict: Verdict = serde_json::from_str(&text).map_err(|error| {
            Trouble::Work(format!("{}: {error}; run this again", path.display()))
        })?;
        verdicts.push(verdict);
    }
    let last = |verdict: &Verdict| {
        verdict.number.rsplit('.').next().and_then(|number| number.parse::<u32>().ok())
    };
    verdicts.sort_by_key(last);
    Ok(verdicts)
}

/// A verdict for people.
fn told(verdict: &Verdict) -> String {
    let Verdict { number, title, status, mistake, diagnosis, first, page, .. } = verdict;
    let mut text = format!("  {number:5} {title:40} {status}");
    if let Some(mistake) = mistake {
        text += &format!(": {mistake}");
    }
    text.push('\n');
    if let Some(diagnosis) = diagnosis {
        text += &wrapped(diagnosis);
    }
    if let Some(Difference { case, expected, yours }) = first {
        text += &format!("        case      {case}\n");
        text += &format!("        expected  {expected}\n");
        text += &format!("        yours     {yours}\n");
    }
    if let Some(page) = page {
        text += &format!("        compare the pictures: {page}\n");
    }
    text
}

/// Sentences in lines of at most 92 letters, indented below the title.
fn wrapped(sentences: &str) -> String {
    let mut text = String::new();
    for paragraph in sentences.lines() {
        let mut line = String::new();
        for word in paragraph.split_whitespace() {
            if line.chars().count() + word.chars().count() > 91 {
                text += &format!("        {}\n", line.trim_end());
                line.clear();
            }
            line += word;
            line.push(' ');
        }
        text += &format!("        {}\n", line.trim_end());
    }
    text
}

/// The file a reader edits.
fn answers(entry: &Entry) -> String {
    format!("chapters/{}/src/exercises.rs", entry.id)
}

/// What to do next, and where.
fn invitation(places: &Places, entry: &Entry, verdict: &Verdict) -> String {
    let Verdict { number, title, section, .. } = verdict;
    let file = answers(entry);
    let source = std::fs::read_to_string(places.root.join(&file)).unwrap_or_default();
    let line = line_of(&source, number).map_or(String::new(), |line| format!(":{line}"));
    let package = entry.package();
    format!(
        "Next: exercise {number}, \"{title}\", in {file}{line}\n\
         The page's section \"{section}\" has what it needs. When you have changed the file, run\n  \
         cargo run --release -- exercises {package}"
    )
}

/// The line of an exercise's stub; of a comment that names it when the stub is gone.
fn line_of(source: &str, number: &str) -> Option<usize> {
    let stub = format!("todo!(\"exercise {number}\")");
    let names = |line: &str| {
        let line = line.to_lowercase();
        let after = line.split_once(&format!("exercise {number}"));
        after.is_some_and(|(_before, rest)| !rest.starts_with(|next: char| next.is_ascii_digit()))
    };
    let position = |test: &dyn Fn(&str) -> bool| source.lines().position(test);
    position(&|line| line.contains(&stub)).or_else(|| position(&names)).map(|index| index + 1)
}

#[cfg(test)]
mod tests {
    use super::{choose, line_of, read, told};
    use crate::fake::CHAPTERS;
    use crate::trouble::Trouble;

    #[test]
    fn an_unknown_chapter_is_a_wrong_command_line() {
        let refused = choose(CHAPTERS, Some("08")).map(|chosen| chosen.len());
        assert!(matches!(refused, Err(Trouble::Usage(list)) if list.contains("07-fake")));
        assert_eq!(choose(CHAPTERS, None).map(|chosen| chosen.len()).ok(), Some(1));
    }

    #[test]
    fn an_exercise_stands_for_its_chapter() {
        assert!(choose(CHAPTERS, Some("7.2")).is_ok_and(|chosen| chosen[0].id == "07-fake"));
        for wrong in ["8.1", "7.", "7.x", ".2", "7.1.2"] {
            assert!(choose(CHAPTERS, Some(wrong)).is_err(), "{wrong}");
        }
    }

    #[test]
    fn verdicts_are_read_in_order_and_told() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let write = |name: &str, number: &str, rest: &str| {
            let text = format!(
                r#"{{"number":"{number}","title":"T","package":"fake","section":"S",{rest}}}"#
            );
            std::fs::write(folder.path().join(name), text).expect("it can be written");
        };
        let quiet = r#""status":"done","mistake":null,"diagnosis":null,"differing":0,"cases":3,
            "first":null,"page":null"#;
        let loud = r#""status":"wrong","mistake":"a sign","diagnosis":"You lost a sign.",
            "differing":1,"cases":3,"page":"out/exercises/07-2.html",
            "first":{"index":0,"case":"C","expected":"1","yours":"-1"}"#;
        write("07-10.json", "7.10", quiet);
        write("07-2.json", "7.2", loud);
        write("08-1.json", "8.1", quiet);
        write("07-2.html", "7.2", quiet);

        let verdicts = read(folder.path(), CHAPTERS[0]).expect("they can be read");
        let numbers: Vec<&str> = verdicts.iter().map(|one| one.number.as_str()).collect();
        assert_eq!(numbers, ["7.2", "7.10"]);
        let text = told(&verdicts[0]);
        for part in ["wrong: a sign", "You lost a sign.", "yours     -1", "07-2.html"] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }

    #[test]
    fn a_stub_is_found_by_its_line() {
        let source = "/// Exercise 1.10: ten\n\n/// Exercise 1.1: one\ntodo!(\"exercise 1.10\")\n";
        assert_eq!(line_of(source, "1.10"), Some(4));
        assert_eq!(line_of(source, "1.1"), Some(3));
        assert_eq!(line_of(source, "1.2"), None);
    }
}
