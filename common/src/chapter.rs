//! What each chapter's program does: draw its picture, show what accuracy costs, run its hard cases.
//!
//! A chapter implements [`Chapter`] in its library; its `main` calls [`main`]. The book runs the same
//! command lines inside its own program through [`Entry`].

mod asked;
mod costs;
mod failure;
mod hards;
mod picture;
mod progress;

use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;

use clap::{ArgMatches, Args, CommandFactory, FromArgMatches};

use crate::args::{Cli, Command};
use crate::cost::Experiment;
use crate::film::Film;
use crate::hard::Case;
use crate::interrupt;
use crate::plan::{Call, Plan, Skill};
use crate::render::{Rendering, Settings};
use crate::tally::{Event, Tally};

pub use asked::{Asked, knobs};
pub use failure::Failure;
pub use picture::{Target, default_path};

/// A chapter of the book, as a program.
pub trait Chapter {
    /// Its number and name, as in its folder: "01-ray-casting".
    const ID: &'static str;
    /// What its picture shows, in one line for `--help`.
    const ABOUT: &'static str;
    /// What it draws when nothing is said.
    const DEFAULTS: Defaults;
    /// Its built-in scenes, for `--help` and for the message about an unknown one.
    const SCENES: &'static [SceneName];
    /// The effects it can simulate.
    const SKILLS: &'static [Skill];
    /// The work it counts.
    const EVENTS: &'static [Event];
    /// The longest side of a picture it can draw, in pixels.
    const LONGEST_SIDE: u32 = u32::MAX;
    /// Subcommands that no other chapter has.
    const COMMANDS: &'static [OwnCommand] = &[];

    /// Its own options.
    type Knobs: Args;
    /// Its idea of a scene.
    type Scene;

    /// Makes the scene called `name`, or reads it from the file `name`.
    fn build(name: &str, knobs: &Self::Knobs) -> Result<Self::Scene, Failure>;

    /// What the reader should be told of the scene's files; nothing when all is well.
    fn warnings(_scene: &Self::Scene) -> &[String] {
        &[]
    }

    /// The effects the scene calls for.
    fn calls(scene: &Self::Scene, knobs: &Self::Knobs) -> Vec<Call>;

    /// Draws the scene.
    fn draw<T: Tally>(
        scene: &Self::Scene,
        plan: &Plan,
        settings: &Settings,
        knobs: &Self::Knobs,
    ) -> Rendering<T>;

    /// Its experiments on accuracy and time.
    fn cost() -> Vec<Experiment<'static>>;

    /// Its hard cases.
    fn hard() -> Vec<Case>;

    /// A picture of a naive formula's failure, where one helps.
    fn hard_picture() -> Option<Film> {
        None
    }
}

/// A subcommand of one chapter alone, beside `cost` and `hard`.
#[derive(Clone, Copy, Debug)]
pub struct OwnCommand {
    /// What to type.
    pub name: &'static str,
    /// What it does, in one line for `--help`.
    pub about: &'static str,
    /// Adds its options: `augment_args` of a type that derives [`Args`].
    pub options: fn(clap::Command) -> clap::Command,
    /// Does it; text goes to the writer.
    pub run: fn(&ArgMatches, &mut dyn Write) -> Result<ExitCode, Failure>,
}

/// What a chapter draws when nothing is said.
#[derive(Clone, Copy, Debug)]
pub struct Defaults {
    /// The scene's name.
    pub scene: &'static str,
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Samples per pixel.
    pub spp: u32,
}

/// A built-in scene.
#[derive(Clone, Copy, Debug)]
pub struct SceneName {
    /// What to type after `--scene`.
    pub name: &'static str,
    /// What it shows.
    pub about: &'static str,
}

/// A chapter's program as plain functions, so that a list can hold all chapters.
///
/// A chapter's library has one as a `static`. So its code is compiled there, and not once more by
/// each program and each test that runs it.
#[derive(Clone, Copy)]
pub struct Entry {
    /// The chapter's number and name: "01-ray-casting".
    pub id: &'static str,
    /// Runs one of its command lines (without the program's name); text goes to the writer.
    pub run: fn(&[OsString], &mut dyn Write) -> Result<ExitCode, Failure>,
    /// Its hard cases.
    pub hard: fn() -> Vec<Case>,
    /// Its experiments.
    pub cost: fn() -> Vec<Experiment<'static>>,
}

impl Entry {
    /// The entry of chapter `C`.
    pub const fn of<C: Chapter>() -> Self {
        Self { id: C::ID, run: run::<C>, hard: C::hard, cost: C::cost }
    }

    /// The package's name: the chapter's without its number.
    pub fn package(&self) -> &'static str {
        self.id.split_once('-').map_or(self.id, |(_number, name)| name)
    }
}

/// The whole program of a chapter, for its `main`.
pub fn main(program: &Entry) -> ExitCode {
    interrupt::listen();
    let arguments: Vec<OsString> = std::env::args_os().skip(1).collect();
    let mut out = std::io::stdout().lock();
    match (program.run)(&arguments, &mut out) {
        Ok(code) => code,
        Err(failure) => failure.report(),
    }
}

/// Runs one command line of chapter `C`.
fn run<C: Chapter>(arguments: &[OsString], out: &mut dyn Write) -> Result<ExitCode, Failure> {
    let name = C::ID.split_once('-').map_or(C::ID, |(_number, name)| name);
    let own =
        C::COMMANDS.iter().map(|own| (own.options)(clap::Command::new(own.name)).about(own.about));
    let command = with_defaults::<C>(Cli::<C::Knobs>::command())
        .name(name)
        .bin_name(name)
        .about(C::ABOUT)
        .subcommands(own)
        .after_help(scene_list(C::SCENES));
    let program = OsString::from(name);
    let matches = command.try_get_matches_from(std::iter::once(&program).chain(arguments))?;
    if let Some((name, matches)) = matches.subcommand()
        && let Some(own) = C::COMMANDS.iter().find(|own| own.name == name)
    {
        return (own.run)(matches, out);
    }
    let cli = Cli::<C::Knobs>::from_arg_matches(&matches)?;
    match cli.command {
        None => picture::run::<C>(&cli.render, &cli.knobs, out),
        Some(Command::Cost(args)) => costs::run::<C>(&args, out),
        Some(Command::Hard(args)) => hards::run::<C>(&args, out),
    }
}

/// Tells `--help` what this chapter does when an option is not given.
fn with_defaults<C: Chapter>(command: clap::Command) -> clap::Command {
    let Defaults { scene, width, height, spp } = C::DEFAULTS;
    let defaults = [
        ("scene", scene.to_string()),
        ("size", format!("{width}x{height}")),
        ("spp", spp.to_string()),
        ("out", default_path(C::ID, "png").display().to_string()),
    ];
    defaults.into_iter().fold(command, |command, (option, default)| {
        command.mut_arg(option, |arg| {
            let help = arg.get_help().map(ToString::to_string).unwrap_or_default();
            arg.help(format!("{help} [default: {default}]"))
        })
    })
}

/// The built-in scenes, one a line.
fn scene_list(scenes: &[SceneName]) -> String {
    let width = scenes.iter().map(|scene| scene.name.len()).max().unwrap_or(0);
    let mut text = String::from("Scenes:\n");
    for SceneName { name, about } in scenes {
        text += &format!("  {name:width$}  {about}\n");
    }
    text
}

/// The failure of a scene name that is neither built in nor a file.
pub fn unknown_scene(name: &str, scenes: &[SceneName]) -> Failure {
    let list = scene_list(scenes);
    Failure::Usage(format!("there is no scene and no file called '{name}'\n\n{list}"))
}
