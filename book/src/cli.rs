//! The command line of the book.

use std::ffi::OsString;
use std::io::Write;

use clap::{Parser, Subcommand};
use common::chapter::Entry;

use crate::places::Places;
use crate::trouble::Trouble;
use crate::{exercises, serve, site};

/// First Light: a book you run.
///
/// Builds the book with every picture, table and plot made by the chapters' own code, on this
/// machine, into out/book.
#[derive(Debug, Parser)]
#[command(name = "book")]
pub struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Build the book, show it on 127.0.0.1, and build it again when a page changes
    Serve {
        /// The port to listen on
        #[arg(long, value_name = "N", default_value_t = 3000)]
        port: u16,
    },
    /// Say how far each exercise is, and which is the next
    Exercises {
        /// A chapter, such as 1, 01-ray-casting or ray-casting, or one of its exercises, such as
        /// 1.2; all if not said
        #[arg(value_name = "NN")]
        chapter: Option<String>,
    },
    /// Make the figures only
    Figures,
}

/// Runs a command line (the program's name included).
pub fn run(
    arguments: impl Iterator<Item = OsString>,
    chapters: &[&Entry],
    out: &mut dyn Write,
) -> Result<(), Trouble> {
    let cli = Cli::try_parse_from(arguments)?;
    let places = Places::find()?;
    // Scenes that are files are named from the workspace's folder, as a reader does.
    std::env::set_current_dir(&places.root).map_err(|error| Trouble::with(&places.root, &error))?;
    match cli.command {
        None => {
            let index = site::build(&places, chapters)?;
            writeln!(out, "The book is ready. Open {} in a browser.", index.display())?;
        }
        Some(Command::Serve { port }) => serve::run(&places, chapters, port, out)?,
        Some(Command::Exercises { chapter }) => {
            exercises::run(&places, chapters, chapter.as_deref(), out)?;
        }
        Some(Command::Figures) => {
            let count = site::make_figures(&places, chapters)?;
            let folder = places.cache.display();
            writeln!(out, "All {count} figures of the book are made and kept in {folder}.")?;
        }
    }
    out.flush()?;
    Ok(())
}
