//! Words for what no mistake explains.

use std::fmt::Debug;

use super::outcome::{Outcome, Panic};

/// An input or answer as the reader sees it: Rust's own notation, cut when very long.
pub fn debug<T: Debug>(value: &T) -> String {
    const LONGEST: usize = 600;
    let text = format!("{value:?}");
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{} ... ({} characters)", &text[..end], text.chars().count()),
        None => text,
    }
}

/// The exercise whose untouched stub is all that was met.
pub(super) fn untouched<Answer>(outcomes: &[Outcome<Answer>]) -> Option<&str> {
    let Some(Outcome::Panicked(first)) = outcomes.first() else { return None };
    outcomes.iter().all(is_stub).then(|| first.stub()).flatten()
}

/// Whether this is an untouched stub.
pub(super) fn is_stub<Answer>(outcome: &Outcome<Answer>) -> bool {
    matches!(outcome, Outcome::Panicked(panic) if panic.stub().is_some())
}

/// What to say of a first difference that no known mistake explains.
pub(super) fn unrecognised<Answer>(yours: Option<&Outcome<Answer>>) -> String {
    match yours {
        Some(Outcome::Answered(_)) => {
            "This is none of the mistakes the check knows. Do the first case that differs by \
             hand, with your code beside it."
                .to_string()
        }
        Some(Outcome::Panicked(panic)) => panicked(panic),
        Some(Outcome::Late(limit)) => format!(
            "Your code was too slow: no answer to one case in {} s. Look for a loop that \
             never ends.",
            limit.as_secs()
        ),
        None => "Your code gave no answer.".to_string(),
    }
}

fn panicked(panic: &Panic) -> String {
    let place = panic.place.as_ref().map(|place| format!(" at {place}")).unwrap_or_default();
    match panic.stub() {
        Some(number) => {
            format!("Some cases still reach the stub of exercise {number}{place}.")
        }
        None => format!("Your code panicked{place}: {}.", panic.message),
    }
}
