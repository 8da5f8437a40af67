//! A picture as a test asks for one: by the chapter's own options, without a file.

use clap::{Args, Command, FromArgMatches};

use super::{Chapter, Failure};
use crate::plan::{Plan, Simulate};
use crate::render::{Rendering, Settings};
use crate::tally::Counts;

/// What is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Asked<'a> {
    /// The scene's name, or its file.
    pub scene: &'a str,
    /// The chapter's own options as they are typed, without what all chapters have.
    pub options: &'a str,
    /// The effects to simulate.
    pub simulate: Simulate,
}

impl<'a> Asked<'a> {
    /// What a scene calls for and no more, with no option said.
    pub fn of(scene: &'a str) -> Self {
        Self { scene, options: "", simulate: Simulate::Needed }
    }

    /// The picture that chapter `C` draws.
    ///
    /// # Errors
    /// As the chapter's program: options and scenes that can't be.
    pub fn draw<C: Chapter>(&self, settings: &Settings) -> Result<Rendering<Counts>, Failure> {
        let knobs = knobs::<C>(self.options)?;
        let scene = C::build(self.scene, &knobs)?;
        let plan = Plan::new(&C::calls(&scene, &knobs), C::SKILLS, self.simulate);
        Ok(C::draw(&scene, &plan, settings, &knobs))
    }
}

/// The options of chapter `C`, as they are typed.
///
/// # Errors
/// Options that the chapter doesn't have, and values that can't be.
pub fn knobs<C: Chapter>(options: &str) -> Result<C::Knobs, Failure> {
    let command = C::Knobs::augment_args(Command::new(C::ID).no_binary_name(true));
    let matches = command.try_get_matches_from(options.split_whitespace())?;
    Ok(C::Knobs::from_arg_matches(&matches)?)
}
