//! Words to numbers and to indices, refused with the reason.

use super::error::{Problem, shown};

/// The number that `word` spells.
///
/// # Errors
/// Not a number, or not finite: Rust parses `nan`, `inf` and `1e400` (as infinity) without complaint
/// (HARD CASE TR-13).
pub(super) fn number(word: &str) -> Result<f32, Problem> {
    match word.parse::<f32>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(Problem::NotFinite(shown(word))),
        Err(_) => Err(Problem::NotNumber(shown(word))),
    }
}

/// Refuses a statement with fewer than `needed` numbers.
pub(super) fn enough(keyword: &str, words: &[&str], needed: usize) -> Result<(), Problem> {
    if words.len() >= needed {
        return Ok(());
    }
    Err(Problem::TooFewNumbers { keyword: shown(keyword), needed, found: words.len() })
}

/// How many of each kind the file has defined so far.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Counts {
    pub(super) positions: u32,
    pub(super) uvs: u32,
    pub(super) normals: u32,
}

/// Which of the optional indices a corner, or every corner of a face, has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Has {
    pub(super) uv: bool,
    pub(super) normal: bool,
}

/// Checks one corner of a face: `v`, `v/vt`, `v//vn` or `v/vt/vn`, each index in range.
pub(super) fn corner(word: &str, counts: Counts) -> Result<Has, Problem> {
    let mut parts = word.split('/');
    let position = parts.next().unwrap_or_default();
    let uv = parts.next().unwrap_or_default();
    let normal = parts.next().unwrap_or_default();
    if parts.next().is_some() || position.is_empty() {
        return Err(Problem::BadCorner(shown(word)));
    }

    index(word, position, "position", counts.positions)?;
    let has = Has { uv: !uv.is_empty(), normal: !normal.is_empty() };
    if has.uv {
        index(word, uv, "texture coordinate", counts.uvs)?;
    }
    if has.normal {
        index(word, normal, "normal", counts.normals)?;
    }
    Ok(has)
}

/// Checks one index: from 1 to `count`, or from -1 (the last one) to -`count`.
fn index(corner: &str, word: &str, kind: &'static str, count: u32) -> Result<(), Problem> {
    let index: i64 = word.parse().map_err(|_| Problem::BadCorner(shown(corner)))?;
    if index == 0 {
        return Err(Problem::ZeroIndex(shown(corner)));
    }
    if index.unsigned_abs() > u64::from(count) {
        return Err(Problem::OutOfRange { kind, index, count });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_finite_or_refused() {
        assert_eq!(number("-1.5e2"), Ok(-150.0));
        assert_eq!(number("1e-400"), Ok(0.0));
        for word in ["nan", "NaN", "inf", "-Infinity", "1e400", "3.5e38"] {
            assert_eq!(number(word), Err(Problem::NotFinite(word.to_owned())));
        }
        for word in ["", "x", "1,5", "0x10", "1_000"] {
            assert_eq!(number(word), Err(Problem::NotNumber(word.to_owned())));
        }
    }

    #[test]
    fn corners_reach_from_one_to_the_count_in_both_directions() {
        let counts = Counts { positions: 7, uvs: 3, normals: 2 };
        for word in ["1", "7", "-7", "7/3", "1/", "2//2", "-1/-3/-2", "+4"] {
            assert!(corner(word, counts).is_ok(), "{word}");
        }
        for word in ["0", "-0", "8", "-8", "1/4", "1/0", "1//3", "1//-3", "/1", "", "1/1/1/1"] {
            assert!(corner(word, counts).is_err(), "{word}");
        }
        for word in ["1.0", "x", "99999999999999999999", "-9223372036854775808"] {
            assert!(corner(word, counts).is_err(), "{word}");
        }
        assert_eq!(corner("5//2", counts), Ok(Has { uv: false, normal: true }));
    }
}
