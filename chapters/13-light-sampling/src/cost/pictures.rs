//! Whole pictures: how light is looked for, against the means of another program.

use std::hint::black_box;
use std::rc::Rc;

use common::cost::{Experiment, Method, Plot, Row, Table};
use common::film::Film;
use common::plan::{Plan, Simulate};
use common::render::Settings;
use common::tally::Off;
use path_tracing::command::SKILLS;
use path_tracing::shot::Shot;
use path_tracing::smooth::Smooth;
use path_tracing::stage::Stage;
use path_tracing::strategy::{ByDirection, Lighting, Never};

use crate::by_light::ByLight;
use crate::lamp::Way;
use crate::lights::{Choice, Lights};
use crate::scenes::named;

/// Pixels along a side of the picture, and of each of its tiles: those of the reference.
const SIDE: u32 = 32;
const TILE: u32 = 8;
/// Pictures whose errors are averaged, each of a seed of its own.
const SEEDS: u64 = 6;
/// More bounces change less than a hundred-thousandth of the light.
const DEPTH: u32 = 40;
const METRIC: &str = "RMS of the tiles' relative errors against 65,536 samples by Mitsuba 3, themselves \
    within 0.4 %";

/// A scene, and the means of its tiles.
struct Sight {
    stage: Stage<Smooth>,
    reference: Vec<f64>,
}

/// How light is looked for; `None` is by chance.
#[derive(Clone, Copy)]
struct How {
    way: Option<Way>,
    choice: Choice,
    spp: u32,
}

impl Sight {
    /// None if the scene can't be built, which a test of the scenes would tell.
    fn new(name: &str, reference: &str) -> Option<Rc<Self>> {
        let stage = Stage::new(&named(name, 0.5).ok()?).ok()?;
        let sight = Self { stage, reference: means(reference) };
        Some(Rc::new(sight))
    }

    fn draw(&self, how: How, seed: u64) -> Film {
        let Some(way) = how.way else { return self.shot(ByDirection, how.spp, seed) };
        let lights = Lights::new(&self.stage.space, &self.stage.surfaces, how.choice, way);
        self.shot(ByLight { lights: &lights }, how.spp, seed)
    }

    fn shot<L: Lighting + Copy>(&self, lighting: L, spp: u32, seed: u64) -> Film {
        let shot = Shot { camera: &self.stage.camera, lighting, ending: Never, depth: DEPTH };
        let plan = Plan::new(&self.stage.calls, SKILLS, Simulate::Needed);
        let settings = Settings { width: SIDE, height: SIDE, spp, seed, ..Settings::default() };
        let world = self.stage.world();
        match world.narrowed(Smooth::lambert) {
            Some(matte) => shot.draw::<_, Off>(&matte, &plan, &settings).film,
            None => shot.draw::<_, Off>(&world, &plan, &settings).film,
        }
    }

    fn error(&self, how: How) -> f64 {
        let films = (1..=SEEDS).map(|seed| self.draw(how, seed));
        let squares = films.flat_map(|film| {
            let pairs = tiles(&film).into_iter().zip(&self.reference);
            let errors = pairs.map(|(found, right)| (found / right - 1.0) * (found / right - 1.0));
            errors.collect::<Vec<f64>>()
        });
        let count = SEEDS as f64 * self.reference.len() as f64;
        (squares.sum::<f64>() / count).sqrt()
    }

    fn method(self: &Rc<Self>, series: &'static str, how: How) -> Method<'static> {
        let sight = Rc::clone(self);
        Method {
            label: format!("{series}, samples: {}", how.spp),
            series,
            size: f64::from(how.spp),
            work: 1,
            error: self.error(how),
            run: Box::new(move || drop(black_box(sight.draw(how, 1)))),
        }
    }
}

/// The means of red, green and blue of each tile, of the lines that aren't comments.
fn means(csv: &str) -> Vec<f64> {
    let lines = csv.lines().filter(|line| line.starts_with(|first: char| first.is_ascii_digit()));
    lines.flat_map(|line| line.split(',').skip(2).take(3)).flat_map(str::parse).collect()
}

/// The same of a picture, in the same order.
fn tiles(film: &Film) -> Vec<f64> {
    let across = SIDE / TILE;
    let mean = |tile: u32, channel: usize| {
        let (left, top) = (tile % across * TILE, tile / across * TILE);
        let pixels = (0..TILE * TILE).map(|at| film.pixel(left + at % TILE, top + at / TILE));
        pixels.map(|pixel| f64::from(pixel[channel])).sum::<f64>() / f64::from(TILE * TILE)
    };
    (0..across * across).flat_map(|tile| (0..3).map(move |channel| mean(tile, channel))).collect()
}

const CHANCE: &str = "by chance";
const AREA: &str = "at lamps";

/// The Cornell box with and without looking for its lamp.
pub(super) fn looking() -> Option<Experiment<'static>> {
    let reference = include_str!("../../../../tests/reference/cornell.csv");
    let sight = Sight::new("cornell", reference)?;
    let rows = |series, way| {
        [4, 16, 64].map(|spp| sight.method(series, How { way, choice: Choice::Power, spp }))
    };
    Some(Experiment {
        name: "looking",
        title: "The Cornell box, 32x32: light found by chance, or looked for at the lamp",
        work_unit: "pictures",
        error_metric: METRIC,
        plot: Plot::Convergence("relative error of a tile"),
        methods: rows(CHANCE, None).into_iter().chain(rows(AREA, Some(Way::Area))).collect(),
        note: gain,
    })
}

/// How much faster the same error is reached.
fn gain(table: &Table) -> String {
    let last = |series: &str| table.rows.iter().rfind(|row| row.series == series);
    let (Some(chance), Some(area)) = (last(CHANCE), last(AREA)) else { return String::new() };
    format!(
        "A second spent on looking at the lamp buys {:.0} times as much accuracy, 1 / (error² time), as \
         one spent on chance.",
        area.efficiency() / chance.efficiency()
    )
}

/// A ball of light: points of its area, or of what is seen of it.
pub(super) fn ball() -> Option<Experiment<'static>> {
    let reference = include_str!("../../../../tests/reference/sphere-light.csv");
    let sight = Sight::new("sphere-light", reference)?;
    let row =
        |series, way| sight.method(series, How { way: Some(way), choice: Choice::Power, spp: 16 });
    Some(Experiment {
        name: "ball",
        title: "A ball of light in the box, 32x32: how its points are chosen",
        work_unit: "pictures",
        error_metric: METRIC,
        plot: Plot::ErrorOverTime("relative error of a tile"),
        methods: vec![row("by area", Way::Area), row("by solid angle", Way::SolidAngle)],
        note: |table| compared(table, "by solid angle", "by area"),
    })
}

/// Sixty-four lamps: which is looked at.
pub(super) fn choosing() -> Option<Experiment<'static>> {
    let reference = include_str!("../../../../tests/reference/many-lights.csv");
    let sight = Sight::new("many-lights", reference)?;
    let rows = |series, choice| {
        [4, 16].map(|spp| sight.method(series, How { way: Some(Way::Area), choice, spp }))
    };
    let methods = rows("alike", Choice::Uniform).into_iter().chain(rows("by power", Choice::Power));
    Some(Experiment {
        name: "choosing",
        title: "64 lamps in the box, 32x32: which is looked at",
        work_unit: "pictures",
        error_metric: METRIC,
        plot: Plot::Convergence("relative error of a tile"),
        methods: methods.collect(),
        note: |table| compared(table, "by power", "alike"),
    })
}

/// The errors and times of the last rows of two series.
fn compared(table: &Table, one: &str, other: &str) -> String {
    let last = |series: &str| table.rows.iter().rfind(|row| row.series == series);
    let (Some(new), Some(old)) = (last(one), last(other)) else { return String::new() };
    let ratio = |of: fn(&Row) -> f64| common::cost::change(of(new) / of(old));
    format!(
        "Against '{other}', '{one}' has {} error and takes {} time.",
        ratio(|row| row.error),
        ratio(Row::nanoseconds)
    )
}

#[cfg(test)]
mod tests {
    use super::{AREA, Choice, How, Sight, looking, means};
    use crate::lamp::Way;

    #[test]
    fn lines_of_numbers_are_tiles() {
        let csv = "# a comment\ntile_x,tile_y,r,g,b,e,e,e\n0,0,1.5,2,3,9,9,9\n1,0,4,5,6,9,9,9\n";
        assert_eq!(means(csv), [1.5, 2.0, 3.0, 4.0, 5.0, 6.0]);
    }

    /// Another program, other formulas: the same picture.
    #[test]
    fn the_other_program_s_pictures_are_ours() {
        let folder = [
            ("cornell", include_str!("../../../../tests/reference/cornell.csv")),
            ("sphere-light", include_str!("../../../../tests/reference/sphere-light.csv")),
            ("many-lights", include_str!("../../../../tests/reference/many-lights.csv")),
        ];
        for (name, reference) in folder {
            let sight = Sight::new(name, reference).expect("a scene");
            for way in [Way::Area, Way::SolidAngle] {
                let error = sight.error(How { way: Some(way), choice: Choice::Power, spp: 128 });
                // By area, half the points of a ball are on its back.
                let noise = if (name, way) == ("sphere-light", Way::Area) { 0.05 } else { 0.025 };
                assert!(error < noise, "{name}, {way:?}: {error}");
            }
        }
    }

    #[test]
    fn looking_helps() {
        let methods = looking().expect("a scene").methods;
        let error = |series| methods.iter().rfind(|row| row.series == series).map(|row| row.error);
        assert!(error(AREA) < error(super::CHANCE).map(|error| 0.5 * error));
    }
}
