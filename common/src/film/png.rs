//! A film as PNG: 8 bits a channel, sRGB.

use std::io::Cursor;

use image::{ImageError, ImageFormat, RgbImage};

use super::{Film, srgb};

/// The bytes of a PNG file that shows `film`, clamped to what a display can show.
pub fn encode(film: &Film) -> Result<Vec<u8>, ImageError> {
    let picture = RgbImage::from_fn(film.width, film.height, |x, y| {
        image::Rgb(film.pixel(x, y).to_array().map(srgb::encode_byte))
    });
    let mut bytes = Cursor::new(Vec::new());
    picture.write_to(&mut bytes, ImageFormat::Png)?;
    Ok(bytes.into_inner())
}
