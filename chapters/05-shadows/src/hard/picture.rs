//! Five cures side by side: as it is, small, and far away.

use blinn_phong::scenes::brute_force;
use common::film::{Color, Film};
use common::plan::{Plan, Simulate};
use common::render::Settings;
use common::tally::Off;

use crate::calls;
use crate::command::SKILLS;
use crate::offset::Offset;
use crate::picture::Picture;
use crate::scenes::named;

const WIDTH: u32 = 160;
const HEIGHT: u32 = 120;
const GAP: u32 = 4;
const SCENES: [&str; 3] = ["three-lamps", "small", "far"];

/// A row a scene, a column a cure: none, fixed, normal, integer, bound.
pub fn picture() -> Option<Film> {
    let films: Option<Vec<Vec<Film>>> = SCENES.iter().map(|name| row(name)).collect();
    let films = films?;
    let width = Offset::ALL.len() as u32 * (WIDTH + GAP) - GAP;
    let height = SCENES.len() as u32 * (HEIGHT + GAP) - GAP;
    Some(Film::from_fn(width, height, |x, y| {
        let (column, row) = (x / (WIDTH + GAP), y / (HEIGHT + GAP));
        let (x, y) = (x % (WIDTH + GAP), y % (HEIGHT + GAP));
        if x < WIDTH && y < HEIGHT {
            films[row as usize][column as usize].pixel(x, y)
        } else {
            Color::ONE
        }
    }))
}

/// The scene by each cure.
fn row(name: &str) -> Option<Vec<Film>> {
    let stage = named(name, brute_force).ok()?;
    let plan = Plan::new(&calls::of_scene(&stage.scene, &stage.calls), SKILLS, Simulate::Needed);
    let settings = Settings { width: WIDTH, height: HEIGHT, ..Settings::default() };
    let camera = stage.camera.with_film(WIDTH, HEIGHT);
    let film = |offset| {
        let picture = Picture { scene: &stage.scene, camera, offset };
        picture.draw::<Off>(&settings, &plan).film
    };
    Some(Offset::ALL.map(film).into())
}
