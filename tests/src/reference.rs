//! Reference pictures that another renderer made: `tests/reference/README.md` says how.

use std::fs;
use std::path::PathBuf;

use common::stats::estimate::Estimate;

use crate::program::workspace;

/// The scenes that have a reference picture.
pub const SCENES: [&str; 6] =
    ["cornell", "cornell-glass", "sphere-light", "many-lights", "bunny", "rough-metals"];

/// Pixels across and down a reference picture.
pub const SIZE: u32 = 32;

/// Tiles across and down; each has 8 by 8 pixels.
pub const TILES: u32 = 4;

/// A tile of a reference picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tile {
    /// Its column and row, from the top left.
    pub place: [u32; 2],
    /// The mean radiance over its pixels, in linear red, green and blue.
    pub mean: [Estimate; 3],
}

/// The tiles of a scene's reference picture, row by row, as `Film::tile_means` has them.
///
/// # Errors
/// A scene without a readable table of tiles, by the table's path and line.
pub fn tiles(scene: &str) -> Result<Vec<Tile>, String> {
    let path = file(scene, "csv");
    let named = |error: String| format!("{}: {error}", path.display());
    let text = fs::read_to_string(&path).map_err(|error| named(error.to_string()))?;
    parse(&text).map_err(named)
}

/// The path of a scene's reference: `exr` is the picture, `csv` the table of its tiles.
pub fn file(scene: &str, extension: &str) -> PathBuf {
    workspace().join("tests/reference").join(format!("{scene}.{extension}"))
}

/// The tiles in a table's text: comments, a line of headings, and a line for each tile.
fn parse(text: &str) -> Result<Vec<Tile>, String> {
    let lines = (1..).zip(text.lines()).filter(|(_number, line)| !line.starts_with('#'));
    lines.skip(1).map(|(number, line)| tile(line).ok_or(format!("line {number}: {line}"))).collect()
}

/// The tile of one line: column, row, three means, and their three standard errors.
fn tile(line: &str) -> Option<Tile> {
    let parts: Vec<f64> = line.split(',').map(str::parse).collect::<Result<_, _>>().ok()?;
    let [column, row, r, g, b, r_error, g_error, b_error] = *parts.as_slice() else { return None };
    let estimate = |mean, standard_error| Estimate { mean, standard_error };
    let mean = [estimate(r, r_error), estimate(g, g_error), estimate(b, b_error)];
    Some(Tile { place: [column as u32, row as u32], mean })
}

#[cfg(test)]
mod tests {
    use std::fs;

    use common::film::exr;
    use common::stats::estimate::Estimate;

    use super::{SCENES, SIZE, TILES, Tile, file, parse, tiles};

    #[test]
    fn a_table_by_hand() {
        let text = "# from nowhere\ntile_x,tile_y,r,...\n3,1,0.5,2,1e-3,0.25,1,1e-4\n";
        let means = [(0.5, 0.25), (2.0, 1.0), (1e-3, 1e-4)];
        let mean = means.map(|(mean, standard_error)| Estimate { mean, standard_error });
        assert_eq!(parse(text), Ok(vec![Tile { place: [3, 1], mean }]));
        let short = parse("headings\n0,0,1,1,1,0,0,0\n1,0,1,1,1,0,0\n");
        assert_eq!(short, Err("line 3: 1,0,1,1,1,0,0".to_owned()));
    }

    #[test]
    fn the_tables_are_whole_and_precise() {
        for scene in SCENES {
            let tiles = tiles(scene).expect("it is part of the project");
            let places: Vec<[u32; 2]> = tiles.iter().map(|tile| tile.place).collect();
            let grid = (0..TILES).flat_map(|row| (0..TILES).map(move |column| [column, row]));
            assert!(grid.eq(places), "{scene}");
            for Estimate { mean, standard_error } in tiles.iter().flat_map(|tile| tile.mean) {
                let relative = standard_error / mean;
                assert!(relative > 0.0 && relative < 0.005, "{scene}: {mean} {standard_error}");
            }
        }
    }

    #[test]
    fn the_tables_are_those_of_the_pictures() {
        for scene in SCENES {
            let bytes = fs::read(file(scene, "exr")).expect("it is part of the project");
            let film = exr::decode(&bytes).expect("an EXR file");
            assert_eq!([film.width, film.height], [SIZE; 2]);
            let tiles = tiles(scene).expect("it is part of the project");
            for (tile, shown) in tiles.iter().zip(film.tile_means(TILES, TILES)) {
                for (estimate, shown) in tile.mean.iter().zip(shown.to_array()) {
                    let apart = (estimate.mean / f64::from(shown) - 1.0).abs();
                    assert!(apart < 1e-5, "{scene}: {tile:?} {shown}");
                }
            }
        }
    }
}
