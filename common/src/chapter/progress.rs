//! The progress bar, and Ctrl-C while a picture is made.

use std::io::IsTerminal;

use indicatif::{ProgressBar, ProgressStyle};

use crate::interrupt;
use crate::render::Watch;

/// Shows progress on a terminal, and stops the work when Ctrl-C was pressed.
pub(super) struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// A bar for `pixels` pixels; hidden when `quiet` or when standard error is no terminal.
    pub(super) fn new(pixels: u64, quiet: bool) -> Self {
        let hidden = quiet || !std::io::stderr().is_terminal();
        let bar = if hidden { ProgressBar::hidden() } else { ProgressBar::new(pixels) };
        if let Ok(style) = ProgressStyle::with_template(TEMPLATE) {
            bar.set_style(style);
        }
        Self { bar }
    }

    /// Takes the bar off the screen.
    pub(super) fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

const TEMPLATE: &str = "{wide_bar} {percent:>3} %  {elapsed} gone, {eta} to go";

impl Watch for Progress {
    fn done(&self, pixels: u64) {
        self.bar.inc(pixels);
    }

    fn stop(&self) -> bool {
        interrupt::asked()
    }
}
