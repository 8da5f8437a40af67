//! What came of asking for one answer: also when the code panicked.

use std::any::Any;
use std::cell::{Cell, RefCell};
use std::panic::{self, AssertUnwindSafe, PanicHookInfo};
use std::sync::Once;
use std::time::Duration;

/// What came of one case.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome<Answer> {
    /// An answer, right or wrong.
    Answered(Answer),
    /// A panic.
    Panicked(Panic),
    /// Nothing, for this long.
    Late(Duration),
}

/// A panic that was caught.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Panic {
    /// What it said.
    pub message: String,
    /// Its file, line and column, when it happened on the thread that asked.
    pub place: Option<String>,
}

/// How the message of an untouched stub begins: that of `todo!("exercise ...")`.
const STUB: &str = "not yet implemented: exercise ";

impl Panic {
    /// The number of the exercise whose untouched stub this is, such as "1.2".
    pub fn stub(&self) -> Option<&str> {
        self.message.strip_prefix(STUB)
    }
}

/// Asks for the answer to one case. A panic is caught and not printed.
pub fn attempt<Case, Answer>(answer: fn(&Case) -> Answer, case: &Case) -> Outcome<Answer> {
    static HOOK: Once = Once::new();
    HOOK.call_once(install);

    // A caught panic leaves nothing behind: the case is only read, and the answer is gone.
    PLACE.set(None);
    QUIET.set(true);
    let result = panic::catch_unwind(AssertUnwindSafe(|| answer(case)));
    QUIET.set(false);
    match result {
        Ok(answer) => Outcome::Answered(answer),
        Err(payload) => {
            Outcome::Panicked(Panic { message: message(&*payload), place: PLACE.take() })
        }
    }
}

thread_local! {
    static QUIET: Cell<bool> = const { Cell::new(false) };
    static PLACE: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Wraps the panic hook: it says nothing on a thread that is asking for an answer, and nothing of a
/// stub on any thread, because a picture is rendered by a pool. All else is printed as before.
fn install() {
    let before = panic::take_hook();
    panic::set_hook(Box::new(move |info: &PanicHookInfo<'_>| {
        if QUIET.get() {
            PLACE.set(info.location().map(ToString::to_string));
        } else if !message(info.payload()).starts_with(STUB) {
            before(info);
        }
    }));
}

/// The text of a panic; `panic_any` may carry something else.
fn message(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().map(ToString::to_string);
    text.or_else(|| payload.downcast_ref::<String>().cloned())
        .unwrap_or_else(|| "a panic without a message".to_string())
}

#[cfg(test)]
mod tests {
    use super::{Outcome, Panic, attempt};

    fn pick((numbers, index): &(Vec<u32>, usize)) -> u32 {
        numbers[*index]
    }

    #[test]
    fn an_answer_or_the_message_and_the_line() {
        assert_eq!(attempt(pick, &(vec![3, 1, 4], 2)), Outcome::Answered(4));
        let Outcome::Panicked(panic) = attempt(pick, &(vec![3], 2)) else { panic!("it answered") };
        assert_eq!(panic.message, "index out of bounds: the len is 1 but the index is 2");
        assert!(panic.place.is_some_and(|place| place.contains("outcome.rs:")));
    }

    #[test]
    fn a_stub_is_known_by_its_number() {
        fn stub(_: &()) -> u32 {
            todo!("exercise 12.3")
        }
        let Outcome::Panicked(panic) = attempt(stub, &()) else { panic!("it answered") };
        assert_eq!(panic.stub(), Some("12.3"));
        let other = Panic { message: "not yet implemented: later".to_string(), place: None };
        assert_eq!(other.stub(), None);
    }

    #[test]
    fn a_panic_need_not_be_text() {
        let outcome = attempt::<(), ()>(|()| std::panic::panic_any(7), &());
        assert!(matches!(outcome, Outcome::Panicked(panic) if panic.message.contains("without")));
    }
}
