//! Formulas: LaTeX as MathML, made while the book is built, so that no page needs a script.

use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};

/// Whether a formula stands in a sentence or by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Display {
    /// In a sentence.
    Inline,
    /// In the middle of a line of its own.
    Block,
}

/// A formula as MathML that can stand in Markdown. Fails if it can't be read.
pub fn mathml(latex: &str, display: Display) -> Result<String, String> {
    let storage = Storage::new();
    let mut events = Vec::new();
    for event in Parser::new(latex, &storage) {
        let why = |error| format!("the formula `{latex}` can't be read: {}", first_line(&error));
        events.push(event.map_err(why)?);
    }
    let display_mode = match display {
        Display::Inline => DisplayMode::Inline,
        Display::Block => DisplayMode::Block,
    };
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    let mut html = String::new();
    let events = events.into_iter().map(Ok::<_, std::convert::Infallible>);
    push_mathml(&mut html, events, config).map_err(|error| error.to_string())?;
    Ok(guarded(&spaces_outside(html)))
}

/// Moves the space before a function out of its script: the parser writes it inside, where it takes
/// the place of the base, and `\cos^n` after a product loses its exponent.
fn spaces_outside(mut html: String) -> String {
    const SPACE: &str = "<mspace width=\"0.1667em\" />";
    for script in ["<msup>", "<msub>", "<msubsup>"] {
        html = html.replace(&format!("{script}{SPACE}"), &format!("{SPACE}{script}"));
    }
    html
}

/// The reason without the picture of the place that follows it.
fn first_line(error: &impl ToString) -> String {
    error.to_string().lines().next().unwrap_or_default().to_string()
}

/// HTML whose text Markdown leaves alone: outside the tags, letters with a meaning are written out.
fn guarded(html: &str) -> String {
    let mut text = String::with_capacity(html.len());
    let mut in_tag = false;
    for letter in html.chars() {
        match letter {
            '<' => in_tag = true,
            '>' => in_tag = false,
            _ => {}
        }
        match letter {
            '\n' => text.push(' '),
            '*' | '_' | '`' | '[' | ']' | '\\' | '|' | '~' | '!' | '\'' | '"' | '.' | '-'
                if !in_tag =>
            {
                text += &format!("&#{};", u32::from(letter));
            }
            other => text.push(other),
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{Display, mathml};

    #[test]
    fn a_formula_becomes_mathml() {
        let inline = mathml("t^2 * x", Display::Inline).expect("it can be read");
        assert!(inline.starts_with("<math display=\"inline\""), "{inline}");
        assert!(!inline.contains('*'), "Markdown would read emphasis: {inline}");
        let block = mathml("\\frac{-b \\pm \\sqrt{b^2 - 4 a c}}{2 a}", Display::Block);
        assert!(
            block.is_ok_and(|html| html.contains("display=\"block\"") && html.contains("<mfrac"))
        );
    }

    #[test]
    fn a_script_keeps_its_base_after_a_space() {
        let power = mathml("x \\cos^n t", Display::Inline).expect("it can be read");
        assert!(power.contains("<msup><mi>cos</mi><mi>n</mi></msup>"), "{power}");
        let logarithm = mathml("2^{n \\log_2 c}", Display::Inline).expect("it can be read");
        assert!(logarithm.contains("<msub><mi>log</mi><mn>2</mn></msub>"), "{logarithm}");
    }

    #[test]
    fn a_formula_that_cannot_be_read_is_refused() {
        for wrong in ["\\frac{1", "\\nosuchcommand", "a_b_c", "{"] {
            assert!(
                mathml(wrong, Display::Inline).is_err_and(|why| why.contains(wrong)),
                "{wrong}"
            );
        }
    }
}
