//! The page that compares two pictures: expected, yours, and their difference.
//!
//! One HTML file that needs nothing beside it: the pictures are inside, and the only script moves
//! the slider that wipes from one picture to the other. It says where the worst pixel is and what
//! both pictures have there. NaN and infinity are counted, and shown in a colour no scene has.

pub mod comparison;

use std::io;
use std::path::{Path, PathBuf};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use image::ImageError;

use crate::files::write_atomically;
use crate::film::{Color, Film, png, srgb};
use comparison::{Comparison, Worst, visible};

/// What is compared, and what is said above it.
#[derive(Clone, Copy, Debug)]
pub struct Page<'a> {
    /// The heading.
    pub title: &'a str,
    /// A sentence or more below it; may be empty.
    pub note: &'a str,
    /// The picture as it should be.
    pub expected: &'a Film,
    /// The picture that is judged.
    pub yours: &'a Film,
}

/// Why there is no page.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A picture could not become a PNG.
    #[error("cannot encode a picture for the comparison page")]
    Encode(#[from] ImageError),
    /// The file could not be written.
    #[error("cannot write {}", path.display())]
    Write {
        /// The page's file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
}

impl Page<'_> {
    /// The page as HTML. Pictures of different sizes are shown, and not subtracted.
    ///
    /// # Errors
    ///
    /// When a picture can't become a PNG.
    pub fn html(&self) -> Result<String, ReportError> {
        let body = match Comparison::of(self.expected, self.yours) {
            Some(comparison) => self.compared(&comparison)?,
            None => self.only_shown()?,
        };
        Ok(include_str!("report/page.html")
            .replace("{{body}}", &body)
            .replace("{{title}}", &escape(self.title))
            .replace("{{note}}", &escape(self.note)))
    }

    /// Writes the page to `path`, whole or not at all.
    ///
    /// # Errors
    ///
    /// As for [`Page::html`], and when the file can't be written.
    pub fn write(&self, path: &Path) -> Result<(), ReportError> {
        let html = self.html()?;
        write_atomically(path, html.as_bytes())
            .map_err(|source| ReportError::Write { path: path.to_path_buf(), source })
    }

    fn compared(&self, comparison: &Comparison) -> Result<String, ReportError> {
        let place = comparison.worst.as_ref();
        let (expected, yours) = (source(self.expected)?, source(self.yours)?);
        let amplified = format!("Difference, {} times", comparison.gain);
        Ok([
            summary(comparison),
            wipe(self.expected, &expected, &yours),
            "<div class=\"row\">".to_string(),
            figure("Expected", self.expected, &expected, place),
            figure("Yours", self.yours, &yours, place),
            figure(&amplified, self.yours, &source(&comparison.difference)?, place),
            "</div>".to_string(),
            place.map(worst_pixel).unwrap_or_default(),
        ]
        .join("\n"))
    }

    fn only_shown(&self) -> Result<String, ReportError> {
        let size = |film: &Film| format!("{} x {}", film.width, film.height);
        Ok([
            format!(
                "<p>The sizes differ: expected {}, yours {}. So there is no difference to \
                 show.</p>\n<div class=\"row\">",
                size(self.expected),
                size(self.yours)
            ),
            figure("Expected", self.expected, &source(self.expected)?, None),
            figure("Yours", self.yours, &source(self.yours)?, None),
            "</div>".to_string(),
        ]
        .join("\n"))
    }
}

/// What the numbers say, before any picture.
fn summary(comparison: &Comparison) -> String {
    let Comparison { differing, pixels, rmse, .. } = comparison;
    let mut lines = vec![match (differing, rmse) {
        (0, _) => "<p>Both pictures are the same to the last bit.</p>".to_string(),
        (_, Some(rmse)) => format!(
            "<p>{differing} of {pixels} pixels differ. Root mean square error over all \
             channels, in linear light: {rmse:.3e}.</p>"
        ),
        (_, None) => format!(
            "<p>{differing} of {pixels} pixels differ. There is no root mean square error: it \
             would be NaN.</p>"
        ),
    }];
    for (whose, count) in [
        ("The expected picture", comparison.nonfinite_expected),
        ("Your picture", comparison.nonfinite_yours),
    ] {
        if count > 0 {
            lines.push(format!(
                "<p>{whose} has pixels that are NaN or infinite: {count}. They are shown in \
                 <span class=\"loud\">magenta</span>.</p>"
            ));
        }
    }
    lines.join("\n")
}

/// Both pictures on top of each other, and the slider that uncovers one.
fn wipe(film: &Film, expected: &str, yours: &str) -> String {
    format!(
        "<figure class=\"wipe\" style=\"width: {width}px\">\n\
         <div class=\"stack\"><img src=\"{yours}\" alt=\"Your picture\">\
         <img class=\"top\" src=\"{expected}\" alt=\"The expected picture, wiped over yours\"></div>\n\
         <input type=\"range\" min=\"0\" max=\"100\" value=\"50\" \
         aria-label=\"How much of the expected picture covers yours, in percent\" \
         oninput=\"this.parentNode.style.setProperty('--cut', this.value + '%')\">\n\
         <figcaption>Expected on the left of the line, yours on the right. Move the \
         slider.</figcaption>\n</figure>",
        width = 2 * shown_width(film)
    )
}

/// A picture with its caption, and a ring around the worst pixel.
fn figure(caption: &str, film: &Film, source: &str, worst: Option<&Worst>) -> String {
    let ring = worst.map(|worst| {
        let percent = |place: u32, size: u32| (f64::from(place) + 0.5) / f64::from(size) * 100.0;
        let (left, top) = (percent(worst.x, film.width), percent(worst.y, film.height));
        format!("<i style=\"left: {left:.3}%; top: {top:.3}%\"></i>")
    });
    let (width, ring) = (shown_width(film), ring.unwrap_or_default());
    format!(
        "<figure style=\"width: {width}px\"><div class=\"stack\">\
         <img src=\"{source}\" alt=\"{caption}\">{ring}</div>\
         <figcaption>{caption}</figcaption></figure>"
    )
}

/// The colours behind the ring.
fn worst_pixel(worst: &Worst) -> String {
    let row = |name: &str, color: Color| {
        let [r, g, b] = color.to_array().map(srgb::encode_byte);
        format!(
            "<tr><th>{name}</th><td><span class=\"swatch\" style=\"background: rgb({r}, {g}, \
             {b})\"></span></td><td>{:?}</td><td>{:?}</td><td>{:?}</td></tr>",
            color.x, color.y, color.z
        )
    };
    format!(
        "<h2>The worst pixel</h2>\n<p>Column {}, row {}, counted from 0 at the top left; the ring \
         is around it. Error: {:?}, the largest difference of a channel.</p>\n\
         <table><tr><th></th><th></th><th>red</th><th>green</th><th>blue</th></tr>\n{}\n{}</table>",
        worst.x,
        worst.y,
        worst.error,
        row("expected", worst.expected),
        row("yours", worst.yours)
    )
}

/// The width a picture is shown at, in CSS pixels: a small one is enlarged by a whole factor.
fn shown_width(film: &Film) -> u32 {
    const COLUMN: u32 = 340;
    film.width * (COLUMN / film.width.max(1)).max(1)
}

/// A film as the address of a picture that is part of the page.
fn source(film: &Film) -> Result<String, ReportError> {
    let bytes = png::encode(&visible(film))?;
    Ok(format!("data:image/png;base64,{}", STANDARD.encode(bytes)))
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::{Page, escape};
    use crate::film::{Color, Film};

    fn ramp(width: u32, height: u32) -> Film {
        Film::from_fn(width, height, |x, y| Color::new(x as f32, y as f32, 1.0) / 8.0)
    }

    fn html(expected: &Film, yours: &Film) -> String {
        Page { title: "a < b", note: "", expected, yours }.html().expect("the films have a size")
    }

    #[test]
    fn a_page_has_all_parts_and_needs_no_other_file() {
        let mut yours = ramp(7, 5);
        yours.pixel_mut(4, 3).y += 0.25;
        let page = html(&ramp(7, 5), &yours);
        assert!(page.contains("Column 4, row 3") && page.contains("Error: 0.25,"));
        assert!(page.contains("1 of 35 pixels differ") && page.contains("Difference, 4 times"));
        assert_eq!(page.matches("data:image/png;base64,").count(), 5);
        assert_eq!(page.matches("<img").count(), page.matches(" alt=\"").count());
        assert!(page.contains("a &lt; b") && !page.contains("{{") && !page.contains("http"));
    }

    #[test]
    fn the_same_picture_is_said_to_be() {
        let page = html(&ramp(7, 5), &ramp(7, 5));
        assert!(page.contains("same to the last bit") && !page.contains("The worst pixel"));
    }

    #[test]
    fn sizes_that_differ_are_reported() {
        let page = html(&ramp(7, 5), &ramp(5, 7));
        assert!(page.contains("expected 7 x 5, yours 5 x 7"));
        assert_eq!(page.matches("data:image/png;base64,").count(), 2);
    }

    #[test]
    fn nan_is_counted_and_is_the_worst() {
        let mut yours = ramp(7, 5);
        yours.pixel_mut(0, 0).x += 0.5;
        yours.pixel_mut(6, 1).z = f32::NAN;
        let page = html(&ramp(7, 5), &yours);
        assert!(
            page.contains("Your picture has pixels that are NaN or infinite: 1.")
                && !page.contains("The expected picture has pixels")
        );
        assert!(page.contains("Column 6, row 1"));
    }

    #[test]
    fn the_file_holds_the_page() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("new/page.html");
        let (expected, yours) = (ramp(7, 5), ramp(7, 5));
        let page = Page { title: "t", note: "n", expected: &expected, yours: &yours };
        page.write(&path).expect("the folder is made");
        assert_eq!(std::fs::read_to_string(&path).ok(), page.html().ok());
        let error = page.write(folder.path()).expect_err("it is a folder");
        assert!(error.to_string().contains("cannot write"));
    }

    #[test]
    fn text_cannot_become_markup() {
        assert_eq!(escape("a<b & \"c\""), "a&lt;b &amp; &quot;c&quot;");
    }
}
