//! Runs the chapters' command lines inside this program and keeps what they make.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::process::ExitCode;
use std::time::Instant;

use common::chapter::{Entry, Failure};
use common::interrupt;

use crate::cache::{Cache, Made, Workplace};
use crate::cost;
use crate::job::{Job, Keep};
use crate::trouble::{Problem, Trouble, say};

/// What each job made.
pub type Figures = BTreeMap<Job, Made>;

/// A job, and the problem of the place that asks for it, should it fail.
pub type Asked = BTreeMap<Job, Problem>;

/// Makes every figure that isn't kept from before; `problems` gets those that fail.
pub fn make(
    asked: &Asked,
    chapters: &[&Entry],
    cache: &Cache,
    problems: &mut Vec<Problem>,
) -> Result<Figures, Trouble> {
    let entries = asked.keys().filter_map(|job| entry(job, chapters).map(|entry| (job, entry)));
    let mut figures = Figures::new();
    let mut missing = Vec::new();
    for (job, entry) in entries.clone() {
        match cache.get(job, entry) {
            Some(made) => drop(figures.insert(job.clone(), made)),
            None => missing.push((job, entry)),
        }
    }
    if !missing.is_empty() {
        let (count, kept) = (missing.len(), figures.len());
        say(format_args!("{count} figures to make; {kept} are kept from before in out/cache"));
    }
    for (index, (job, entry)) in missing.iter().enumerate() {
        let start = Instant::now();
        say(format_args!("[{}/{}] {}", index + 1, missing.len(), job.words()));
        let workplace = cache.workplace()?;
        let made = run(job, entry, &workplace);
        if interrupt::asked() {
            return Err(Trouble::Interrupted);
        }
        match made {
            Ok(text) => {
                figures.insert((*job).clone(), cache.keep(job, entry, &workplace, &text)?);
            }
            Err(message) => {
                let message = format!("`{}` failed: {message}", job.typed());
                problems.push(Problem { message, ..asked[*job].clone() });
            }
        }
        let seconds = start.elapsed().as_secs_f64();
        if seconds > 1.0 {
            say(format_args!("       took {seconds:.1} s"));
        }
    }
    cache.drop_others(entries)?;
    Ok(figures)
}

/// The chapter that runs a job.
pub fn entry<'a>(job: &Job, chapters: &'a [&'a Entry]) -> Option<&'a Entry> {
    chapters.iter().copied().find(|entry| entry.package() == job.package)
}

/// Does one job; gives the text to keep.
fn run(job: &Job, entry: &Entry, workplace: &Workplace) -> Result<String, String> {
    match job.keep {
        Keep::Cost => {
            let sheets = cost::measure((entry.cost)())?;
            serde_json::to_string(&sheets).map_err(|error| error.to_string())
        }
        Keep::Json => command(job, entry, workplace, &["--json"]),
        Keep::Text => {
            let text = command(job, entry, workplace, &[])?;
            let picture = workplace.picture().display().to_string();
            let suffix = job.subcommand().map_or(String::new(), |word| format!("-{word}"));
            Ok(text.replace(&picture, &format!("out/{}{suffix}.png", entry.id)))
        }
        Keep::Refusal => refusal(job, entry, workplace),
    }
}

fn command(
    job: &Job,
    entry: &Entry,
    workplace: &Workplace,
    more: &[&str],
) -> Result<String, String> {
    let (result, printed) = call(job, entry, workplace, more);
    match result {
        Ok(ExitCode::SUCCESS) => Ok(printed),
        Ok(code) => Err(format!("it ended with {code:?}")),
        // The parser hands over help as if it were an error.
        Err(Failure::CommandLine(error)) if error.exit_code() == 0 => Ok(error.to_string()),
        Err(failure) => Err(failure.to_string().trim().to_string()),
    }
}

/// What the command says when it refuses, as its own `main` would print it.
fn refusal(job: &Job, entry: &Entry, workplace: &Workplace) -> Result<String, String> {
    match call(job, entry, workplace, &[]).0 {
        Ok(_) => Err("it should be refused, and it was not".into()),
        Err(Failure::CommandLine(error)) if error.exit_code() == 0 => {
            Err("it should be refused, and it printed help".into())
        }
        Err(Failure::CommandLine(error)) => Ok(error.to_string()),
        Err(failure) => Ok(format!("error: {failure}")),
    }
}

/// Runs the command line with the picture in `workplace`; gives how it ended and what it printed.
fn call(
    job: &Job,
    entry: &Entry,
    workplace: &Workplace,
    more: &[&str],
) -> (Result<ExitCode, Failure>, String) {
    let own = job.arguments.iter().map(OsString::from);
    let place = [OsString::from("--out"), workplace.picture().into()];
    let arguments: Vec<OsString> =
        own.chain(more.iter().map(OsString::from)).chain(place).collect();
    let mut printed = Vec::new();
    let result = (entry.run)(&arguments, &mut printed);
    (result, String::from_utf8_lossy(&printed).into_owned())
}

#[cfg(test)]
mod tests {
    use super::{Asked, make};
    use crate::cache::Cache;
    use crate::fake::CHAPTERS;
    use crate::job::{Job, Keep};
    use crate::trouble::Problem;

    fn made(words: &str, keep: Keep) -> (Option<String>, Vec<Problem>) {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let cache = Cache::new(&folder.path().join("cache"), folder.path());
        let job = Job::parse(words, keep, CHAPTERS).expect("it is a job");
        let problem = Problem { page: "page.md".into(), line: 3, message: String::new() };
        let asked = Asked::from([(job.clone(), problem)]);
        let mut problems = Vec::new();
        let figures = make(&asked, CHAPTERS, &cache, &mut problems).expect("the cache works");
        (figures.get(&job).map(|made| made.text.clone()), problems)
    }

    #[test]
    fn a_command_gives_json_text_or_its_refusal() {
        let (json, _) = made("fake", Keep::Json);
        assert!(json.is_some_and(|json| json.contains("307200")));
        let (text, _) = made("fake", Keep::Text);
        assert_eq!(text.as_deref(), Some("0.1 s, written to out/07-fake.png\n"));
        let (refusal, problems) = made("fake --size 0x0", Keep::Refusal);
        assert!(refusal.is_some_and(|text| text.starts_with("error: a picture needs")));
        assert_eq!(problems, []);
    }

    #[test]
    fn a_figure_whose_command_fails_is_a_problem_of_its_page() {
        let (nothing, problems) = made("fake --size 0x0", Keep::Json);
        assert_eq!((nothing, problems.len()), (None, 1));
        let told = problems[0].to_string();
        assert!(told.starts_with("page.md:3: `cargo run --release -p fake -- --size 0x0` failed"));
        let (nothing, problems) = made("fake", Keep::Refusal);
        assert!(nothing.is_none() && problems[0].message.contains("should be refused"));
    }
}
