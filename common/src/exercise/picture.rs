//! Judging answers that are pictures.

use std::fmt::Debug;
use std::path::Path;

use super::Exercise;
use super::judge::{Failure, Look, PATIENCE, report};
use super::outcome::Outcome;
use super::place::out_folder;
use super::record::Record;
use super::verdict::Difference;
use crate::film::Film;
use crate::report::comparison::{Comparison, Worst};
use crate::report::{Page, ReportError};

impl<Case: Debug + 'static> Exercise<Case, Film> {
    /// As [`Exercise::judge`], for answers that are pictures: writes the comparison page also, to
    /// `out/exercises/<NN-K>.html`.
    ///
    /// # Errors
    ///
    /// As for [`Exercise::judge`].
    pub fn judge_picture(self) -> Result<(), Failure> {
        let out = out_folder(Path::new(self.chapter.folder));
        report(self.judge_in(&out, PATIENCE, PICTURE)?)
    }
}

const PICTURE: Look<Film> = Look { words: describe, picture: Some(|film| film) };

/// Compares the pictures of the first case that differs, or of the first case when none does.
pub(super) fn compare<Answer>(
    record: &mut Record,
    expected: &[Outcome<Answer>],
    yours: &[Outcome<Answer>],
    picture: fn(&Answer) -> &Film,
    file: &Path,
) {
    let index = record.verdict.first.as_ref().map_or(0, |first| first.index);
    let pair = expected.get(index).zip(yours.get(index));
    let Some((Outcome::Answered(expected), Outcome::Answered(yours))) = pair else { return };
    let (expected, yours) = (picture(expected), picture(yours));
    if let Some(first) = &mut record.verdict.first {
        point_at_worst(first, expected, yours);
    }
    let path = file.with_extension("html");
    match write_page(record, expected, yours, &path) {
        Ok(()) => record.page = Some(path.display().to_string()),
        Err(error) => eprintln!("{error}"),
    }
}

/// Adds to the words for both pictures what they have at the worst pixel.
fn point_at_worst(first: &mut Difference, expected: &Film, yours: &Film) {
    let worst = Comparison::of(expected, yours).and_then(|comparison| comparison.worst);
    if let Some(Worst { x, y, expected, yours, .. }) = worst {
        let place = format!("; worst pixel, column {x}, row {y}");
        first.expected += &format!("{place}: {:?}", expected.to_array());
        first.yours += &format!("{place}: {:?}", yours.to_array());
    }
}

fn write_page(
    record: &Record,
    expected: &Film,
    yours: &Film,
    path: &Path,
) -> Result<(), ReportError> {
    let Record { number, title, verdict, .. } = record;
    let diagnosis = verdict.diagnosis.as_deref().unwrap_or_default();
    let case = verdict.first.as_ref().map(|first| format!(" The case: {}", first.case));
    let title = format!("Exercise {number} {title}: {}", verdict.status.words());
    let note = format!("{diagnosis}{}", case.unwrap_or_default());
    Page { title: &title, note: &note, expected, yours }.write(path)
}

fn describe(film: &Film) -> String {
    let mean = film.tile_means(1, 1).first().copied().unwrap_or_default();
    let (width, height) = (film.width, film.height);
    format!("a picture of {width} x {height} with mean ({:?}, {:?}, {:?})", mean.x, mean.y, mean.z)
}

#[cfg(test)]
mod tests {
    use super::super::example::{Case, discriminant, exercise};
    use super::super::judge::PATIENCE;
    use super::super::{Exercise, Mistake, agree};
    use super::PICTURE;
    use crate::film::{Color, Film};

    fn gradient(case: &Case) -> Film {
        Film::from_fn(5, 3, |x, y| Color::new(x as f32, y as f32, case.a) / 8.0)
    }

    fn picture_exercise(yours: fn(&Case) -> Film) -> Exercise<Case, Film> {
        let Exercise { chapter, section, cases, .. } = exercise(discriminant);
        let mistake = |name, answer| Mistake { name, diagnosis: "You did.", answer };
        Exercise {
            chapter,
            number: "12.3",
            title: "A gradient",
            section,
            cases,
            expected: gradient,
            agree: |_, expected, yours| agree::films(expected, yours, 1e-6),
            yours,
            solution: gradient,
            mistakes: vec![
                mistake("black", |_| Film::new(5, 3)),
                mistake("turned", |_| Film::new(3, 5)),
                mistake("white", |_| Film::from_fn(5, 3, |_, _| Color::ONE)),
            ],
        }
    }

    #[test]
    fn a_picture_gets_its_page() {
        let out = tempfile::tempdir().expect("a temporary folder");
        let judged = picture_exercise(|_| Film::new(5, 3)).judge_in(out.path(), PATIENCE, PICTURE);
        let record = judged.expect("the exercise has no flaw");
        assert_eq!(record.verdict.mistake, Some("black"));
        let path = out.path().join("exercises/12-3.html");
        assert_eq!(record.page.as_deref(), path.to_str());
        let page = std::fs::read_to_string(&path).expect("it was written");
        assert!(
            page.contains("Exercise 12.3 A gradient: wrong")
                && page.contains("You did. The case: ")
        );
        let text = format!("{record}");
        assert!(
            text.contains(
                "with mean (0.0, 0.0, 0.0); worst pixel, column 4, row 0: [0.0, 0.0, 0.0]"
            ),
            "{text}"
        );
    }

    #[test]
    fn a_picture_that_panicked_has_no_page() {
        let out = tempfile::tempdir().expect("a temporary folder");
        let judged =
            picture_exercise(|_| todo!("exercise 12.3")).judge_in(out.path(), PATIENCE, PICTURE);
        assert_eq!(judged.expect("the exercise has no flaw").page, None);
        assert!(!out.path().join("exercises/12-3.html").exists());
    }
}
