//! The command without a subcommand: make the scene, draw it, write the file, say what was done.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Instant;

use clap::Args;
use serde_json::{Map, Value, json};

use super::progress::Progress;
use super::{Chapter, Failure};
use crate::args::{RenderArgs, Size, TallyChoice};
use crate::film::{Film, exr, png};
use crate::plan::Plan;
use crate::render::{Rendering, Settings};
use crate::tally::{Counts, Event, Off, Tally};
use crate::{files, interrupt};

/// Draws a picture as the command line says.
pub(super) fn run<C: Chapter>(
    args: &RenderArgs,
    knobs: &C::Knobs,
    out: &mut dyn Write,
) -> Result<ExitCode, Failure>
where
    C::Knobs: Args,
{
    let target = Target::new(args.out.clone().unwrap_or_else(|| default_path(C::ID, "png")))?;
    check_size::<C>(args.size)?;
    let name = args.scene.as_deref().unwrap_or(C::DEFAULTS.scene);
    let start = Instant::now();
    let scene = C::build(name, knobs)?;
    let build_seconds = start.elapsed().as_secs_f64();
    if !args.quiet {
        for warning in C::warnings(&scene) {
            writeln!(std::io::stderr(), "warning: {warning}")?;
        }
    }
    let plan = Plan::new(&C::calls(&scene, knobs), C::SKILLS, args.simulate);
    let talkative = !args.quiet && !args.json;
    if talkative {
        write!(out, "{name}: {plan}")?;
        out.flush()?;
    }
    let made = match args.tally {
        TallyChoice::On => draw::<C, Counts>(args, &scene, &plan, knobs, counters::<C>),
        TallyChoice::Off => draw::<C, Off>(args, &scene, &plan, knobs, |_off| Map::new()),
    };
    target.write(&made.film)?;
    let summary = Summary { chapter: C::ID, scene: name, build_seconds, plan, made };
    if args.json {
        writeln!(out, "{}", summary.json())?;
    } else if talkative {
        summary.print(&target.path, out)?;
    }
    out.flush()?;
    if summary.made.complete { Ok(ExitCode::SUCCESS) } else { stopped(&target.path) }
}

/// Refuses a picture whose side is longer than the chapter can draw.
fn check_size<C: Chapter>(size: Option<Size>) -> Result<(), Failure> {
    match size.map_or(0, |size| size.width.max(size.height)) {
        side if side > C::LONGEST_SIDE => Err(Failure::Usage(format!(
            "a side of {side} pixels is too long here; the longest is {} (option --size)",
            C::LONGEST_SIDE
        ))),
        _ => Ok(()),
    }
}

/// A drawn picture with all that is said about it.
struct Made {
    film: Film,
    complete: bool,
    counters: Map<String, Value>,
    seconds: f64,
    settings: Settings,
}

fn draw<C: Chapter, T: Tally>(
    args: &RenderArgs,
    scene: &C::Scene,
    plan: &Plan,
    knobs: &C::Knobs,
    counters: fn(&T) -> Map<String, Value>,
) -> Made {
    let defaults = Size { width: C::DEFAULTS.width, height: C::DEFAULTS.height };
    let Size { width, height } = args.size.unwrap_or(defaults);
    let quiet = args.quiet || args.json;
    let progress = Arc::new(Progress::new(u64::from(width) * u64::from(height), quiet));
    let settings = Settings {
        width,
        height,
        spp: args.spp.unwrap_or(C::DEFAULTS.spp),
        seed: args.seed,
        threads: args.threads.map_or_else(processors, usize::from),
        watch: progress.clone(),
    };
    let start = Instant::now();
    let Rendering { film, tally, complete } = C::draw::<T>(scene, plan, &settings, knobs);
    let seconds = start.elapsed().as_secs_f64();
    progress.finish();
    Made { film, complete, counters: counters(&tally), seconds, settings }
}

/// The chapter's counters by name, zeros too.
fn counters<C: Chapter>(counts: &Counts) -> Map<String, Value> {
    let entry = |event: &Event| (event.name().to_string(), Value::from(counts.of(*event)));
    C::EVENTS.iter().map(entry).collect()
}

fn processors() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// Where a program puts what it makes when nothing else is said.
pub fn default_path(id: &str, ending: &str) -> PathBuf {
    Path::new("out").join(format!("{id}.{ending}"))
}

/// All that a render says.
struct Summary<'a> {
    chapter: &'static str,
    scene: &'a str,
    build_seconds: f64,
    plan: Plan,
    made: Made,
}

impl Summary<'_> {
    fn json(&self) -> Value {
        let Settings { width, height, spp, seed, threads, .. } = self.made.settings;
        json!({
            "chapter": self.chapter,
            "scene": self.scene,
            "width": width,
            "height": height,
            "spp": spp,
            "seed": seed,
            "threads": threads,
            "seconds": self.made.seconds,
            "build_seconds": self.build_seconds,
            "hash": format!("{:016x}", self.made.film.hash()),
            "counters": self.made.counters,
            "plan": self.plan,
            "nonfinite": self.made.film.nonfinite,
        })
    }

    fn print(&self, path: &Path, out: &mut dyn Write) -> Result<(), Failure> {
        for (name, count) in &self.made.counters {
            let count = grouped(count.as_u64().unwrap_or(0));
            writeln!(out, "{count:>18} {}", name.replace('_', " "))?;
        }
        let Film { nonfinite, .. } = self.made.film;
        if nonfinite > 0 {
            writeln!(out, "{:>18} samples were NaN or infinite and left out", grouped(nonfinite))?;
        }
        let hash = self.made.film.hash();
        let seconds = self.made.seconds;
        writeln!(out, "{seconds:.3} s, hash {hash:016x}, written to {}", path.display())?;
        Ok(())
    }
}

/// A number with a comma at each thousand.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let first = digits.len() % 3;
    let mut text = digits[..first].to_string();
    for start in (first..digits.len()).step_by(3) {
        if !text.is_empty() {
            text.push(',');
        }
        text += &digits[start..start + 3];
    }
    text
}

/// Says that Ctrl-C ended the work early, and gives the exit code for it.
fn stopped(path: &Path) -> Result<ExitCode, Failure> {
    let path = path.display();
    let message = format!("stopped by Ctrl-C; what was finished is in {path}, the rest is black");
    writeln!(std::io::stderr(), "{message}")?;
    Ok(ExitCode::from(interrupt::EXIT_CODE))
}

/// A file a picture can be written to.
pub struct Target {
    path: PathBuf,
    encode: fn(&Film) -> Result<Vec<u8>, image::ImageError>,
}

impl Target {
    /// The file at `path`, whose ending says the format. Fails at once, and not after a long
    /// render, when nothing can be written there.
    pub fn new(path: PathBuf) -> Result<Self, Failure> {
        let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_lowercase);
        let encode = match ending.as_deref() {
            Some("png") => png::encode,
            Some("exr") => exr::encode,
            _ => {
                let path = path.display();
                let message = format!("'{path}' must end in .png or .exr (option --out)");
                return Err(Failure::Usage(message));
            }
        };
        files::check_writable(&path).map_err(|error| Failure::writing(&path, &error))?;
        Ok(Self { path, encode })
    }

    /// Writes the film, whole or not at all.
    pub fn write(&self, film: &Film) -> Result<(), Failure> {
        let failed = |error: &std::io::Error| Failure::writing(&self.path, error);
        let bytes = (self.encode)(film).map_err(|error| failed(&std::io::Error::other(error)))?;
        files::write_atomically(&self.path, &bytes).map_err(|error| failed(&error))
    }
}

#[cfg(test)]
mod tests {
    use super::{Target, grouped};
    use crate::chapter::Failure;

    #[test]
    fn thousands_are_set_apart() {
        assert_eq!(grouped(7), "7");
        assert_eq!(grouped(123), "123");
        assert_eq!(grouped(1_234), "1,234");
        assert_eq!(grouped(4_513_689_600), "4,513,689,600");
    }

    #[test]
    fn an_unknown_format_is_a_wrong_command_line() {
        let refused = Target::new("picture.gif".into());
        assert!(
            matches!(refused, Err(Failure::Usage(message)) if message.contains(".png or .exr"))
        );
    }
}
