//! Small pieces of HTML.

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use crate::math::{self, Display};
use crate::outline::stray_dollars;

/// What to say of a dollar that no formula owns.
pub const STRAY_DOLLAR: &str = "a dollar that begins no formula that can be read: close its \
     braces and end it with a dollar, or write \\$ for the sign";

/// Text with the characters that mean something in HTML written out.
pub fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            other => escaped.push(other),
        }
    }
    escaped
}

/// A caption in Markdown as HTML, its formulas as MathML. Fails on a formula that can't be read.
pub fn caption(markdown: &str) -> Result<String, String> {
    let mut events = Vec::new();
    for (event, range) in Parser::new_ext(markdown, Options::ENABLE_MATH).into_offset_iter() {
        if matches!(event, Event::Text(_)) && !stray_dollars(markdown, range).is_empty() {
            return Err(STRAY_DOLLAR.into());
        }
        events.push(match event {
            Event::InlineMath(latex) => {
                Event::InlineHtml(math::mathml(&latex, Display::Inline)?.into())
            }
            Event::DisplayMath(latex) => {
                Event::InlineHtml(math::mathml(&latex, Display::Block)?.into())
            }
            Event::Start(Tag::Paragraph) | Event::End(TagEnd::Paragraph) => continue,
            other => other,
        });
    }
    let mut html = String::new();
    pulldown_cmark::html::push_html(&mut html, events.into_iter());
    Ok(html.trim().to_string())
}

/// A caption without its markup, for those who can't see the picture.
pub fn plain(markdown: &str) -> String {
    let mut text = String::new();
    for event in Parser::new_ext(markdown, Options::ENABLE_MATH) {
        match event {
            Event::Text(words) | Event::Code(words) => text.push_str(&words),
            Event::InlineMath(latex) | Event::DisplayMath(latex) => text.push_str(&latex),
            Event::SoftBreak | Event::HardBreak => text.push(' '),
            _ => {}
        }
    }
    text.trim().to_string()
}

/// A table with a head; cells hold HTML, and `numbers` says which columns hold numbers.
pub fn table(head: &[String], rows: &[Vec<String>], numbers: &[bool]) -> String {
    let row = |tag: &str, cells: &[String]| {
        let cells = cells.iter().zip(numbers).map(|(cell, number)| {
            let class = if *number { " class=\"number\"" } else { "" };
            format!("<{tag}{class}>{cell}</{tag}>")
        });
        format!("<tr>{}</tr>", cells.collect::<String>())
    };
    let body: Vec<String> = rows.iter().map(|cells| row("td", cells)).collect();
    let (head, body) = (row("th", head), body.join("\n"));
    format!(
        "<div class=\"table-wrapper\"><table>\n<thead>{head}</thead>\n<tbody>\n{body}\n</tbody>\n\
         </table></div>"
    )
}

/// A drawing to be set into a page: its size follows the page, and it says what it shows.
pub fn inline_svg(svg: &str, says: &str) -> Result<String, String> {
    let start = svg.find("<svg").ok_or("it has no <svg> element")?;
    let head_end = start + svg[start..].find('>').ok_or("its <svg> element has no end")?;
    let head = &svg[start + "<svg".len()..head_end];
    let view_box = attribute(head, "viewBox").ok_or("its <svg> element has no viewBox")?;
    let width = view_box.split_whitespace().nth(2).ok_or("its viewBox has no width")?;
    for forbidden in ["<script", "<style", "<foreignObject"] {
        if svg.contains(forbidden) {
            return Err(format!("it has a {forbidden}> element, which would reach beyond it"));
        }
    }
    // The drawing's own defaults stay; its size and its names are ours to give.
    let ours = ["xmlns", "viewBox", "width", "height", "role", "style", "aria-label"];
    let kept: String = attributes(head)
        .filter(|(name, _)| !ours.contains(name))
        .map(|(name, value)| format!(" {name}=\"{value}\""))
        .collect();
    let says = escape(says);
    // A blank line would end the block of HTML that the drawing is in.
    let body: Vec<&str> =
        svg[head_end + 1..].lines().filter(|line| !line.trim().is_empty()).collect();
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{view_box}\"{kept} role=\"img\" \
         aria-label=\"{says}\" style=\"max-width:{width}px\">\n<title>{says}</title>\n{}",
        body.join("\n")
    ))
}

/// The value of an attribute in the text of a tag.
pub fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    attributes(tag).find(|(found, _)| *found == name).map(|(_, value)| value)
}

/// The attributes with a quoted value in the text of a tag, by name.
fn attributes(tag: &str) -> impl Iterator<Item = (&str, &str)> {
    let mut rest = tag;
    std::iter::from_fn(move || {
        let (before, after) = rest.split_once('=')?;
        let name = before.split_whitespace().last().unwrap_or_default();
        let after = after.trim_start();
        let quote = after.chars().next().filter(|quote| matches!(quote, '"' | '\''))?;
        let (value, after) = after[1..].split_once(quote)?;
        rest = after;
        Some((name, value))
    })
}

#[cfg(test)]
mod tests {
    use super::{attribute, caption, inline_svg, plain};

    #[test]
    fn a_caption_is_markdown_with_formulas() {
        let html = caption("*Two* `a<b` at $t = 2$").expect("it can be read");
        assert!(html.starts_with("<em>Two</em> <code>a&lt;b</code> at <math"), "{html}");
        assert_eq!(plain("*Two* `a<b` at $t = 2$"), "Two a<b at t = 2");
        assert!(caption("$\\frac{1$").is_err() && caption("$\\nosuch$").is_err());
    }

    #[test]
    fn attributes_are_found_by_their_whole_name() {
        let tag = r#"img data-alt="no" alt = 'a "b"' src="x""#;
        assert_eq!(attribute(tag, "alt"), Some("a \"b\""));
        assert_eq!(attribute(tag, "src"), Some("x"));
        assert_eq!(attribute(tag, "href"), None);
    }

    #[test]
    fn a_drawing_gets_words_and_loses_its_size() {
        let drawing =
            "<?xml?>\n<svg width=\"9\" fill='none' viewBox=\"0 0 90 20\">\n\n<g/>\n</svg>\n";
        let inlined = inline_svg(drawing, "a & b").expect("it is a drawing");
        assert!(inlined.contains("aria-label=\"a &amp; b\"") && inlined.contains("max-width:90px"));
        assert!(inlined.contains("fill=\"none\"") && !inlined.contains("width=\"9\""));
        assert!(!inlined.contains("\n\n") && !inlined.contains("?xml"));
        assert!(inline_svg("<svg width=\"9\"></svg>", "no viewBox").is_err());
        assert!(inline_svg("<svg viewBox=\"0 0 1 1\"><style/></svg>", "style").is_err());
    }
}
