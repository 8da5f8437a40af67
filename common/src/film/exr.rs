//! A film as OpenEXR: the linear `f32` pixels themselves, nothing clamped.

use std::io::Cursor;

use image::{ImageBuffer, ImageError, ImageFormat, Rgb32FImage};

use super::{Color, Film};

/// The bytes of an OpenEXR file that holds the film's linear pixels, bit for bit.
pub fn encode(film: &Film) -> Result<Vec<u8>, ImageError> {
    let picture: Rgb32FImage = ImageBuffer::from_fn(film.width, film.height, |x, y| {
        image::Rgb(film.pixel(x, y).to_array())
    });
    let mut bytes = Cursor::new(Vec::new());
    picture.write_to(&mut bytes, ImageFormat::OpenExr)?;
    Ok(bytes.into_inner())
}

/// The film in the bytes of an OpenEXR file.
pub fn decode(bytes: &[u8]) -> Result<Film, ImageError> {
    let picture = image::load_from_memory_with_format(bytes, ImageFormat::OpenExr)?.into_rgb32f();
    Ok(Film::from_fn(picture.width(), picture.height(), |x, y| {
        Color::from_array(picture.get_pixel(x, y).0)
    }))
}

#[cfg(test)]
mod tests {
    use super::{Color, Film, decode, encode};

    #[test]
    fn the_file_holds_the_films_own_bits() {
        let film = Film::from_fn(7, 5, |x, y| Color::new(1e-30, x as f32 * 1e9, -(y as f32) / 3.0));
        let bytes = encode(&film).expect("an in-memory file can be written");
        assert_eq!(decode(&bytes).expect("and read back").hash(), film.hash());
    }
}
