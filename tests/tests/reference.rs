//! Our pictures against those of a renderer that shares no line with ours.
//!
//! Each tile of each reference is a mean with its standard error, and so is ours, from pictures of
//! independent seeds. A z-test compares them, and the whole picture's mean: 17 means in three colours.
//! All tests of a scene together raise a false alarm once in a thousand times ([`SIGNIFICANCE`],
//! shared out after Šidák). What they can see is tested, too: our own means, made 2 % brighter, must
//! be found out.

use common::chapter::Entry;
use common::film::{Color, exr};
use common::stats::estimate::Estimate;
use common::stats::running::Running;
use common::stats::sidak;
use tests::chapters::{CHAPTERS, print};
use tests::reference::{SIZE, TILES, tiles};

/// How often the tests of one scene would reject a right picture.
const SIGNIFICANCE: f64 = 0.001;

/// Pictures of ours. Their spread is known to 9 % then, and its quotient is nearly normal.
const SEEDS: u64 = 64;

/// A picture's tiles, row by row, and last the whole of it; three colours each.
type Means = Vec<[Estimate; 3]>;

/// A chapter by its package's name.
fn chapter(package: &str) -> &'static Entry {
    let found = CHAPTERS.iter().find(|chapter| chapter.package() == package);
    found.unwrap_or_else(|| panic!("there is no chapter {package}"))
}

/// The tiles of one of our pictures, and the mean of them all.
fn drawn(package: &str, arguments: &str, seed: u64) -> Vec<Color> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("picture.exr");
    let out = path.display();
    let line = format!("{arguments} --size {SIZE}x{SIZE} --seed {seed} --quiet --out {out}");
    print(chapter(package), &line);
    let film = exr::decode(&std::fs::read(&path).expect("it was written")).expect("an EXR file");
    let mut means = film.tile_means(TILES, TILES);
    means.push(means.iter().sum::<Color>() / means.len() as f32);
    means
}

/// What our pictures of [`SEEDS`] seeds say.
fn ours(package: &str, arguments: &str) -> Means {
    let mut running = vec![[Running::default(); 3]; (TILES * TILES + 1) as usize];
    for seed in 1..=SEEDS {
        for (running, mean) in running.iter_mut().zip(drawn(package, arguments, seed)) {
            for (running, part) in running.iter_mut().zip(mean.to_array()) {
                running.add(f64::from(part));
            }
        }
    }
    let estimates = |it: [Running; 3]| it.map(|it| Estimate::of(&it).expect("several seeds"));
    running.into_iter().map(estimates).collect()
}

/// What the reference says.
fn theirs(scene: &str) -> Means {
    let tiles = tiles(scene).expect("it is part of the project");
    let mut means: Means = tiles.iter().map(|tile| tile.mean).collect();
    let count = means.len() as f64;
    // The tiles' errors don't know of each other.
    means.push([0, 1, 2].map(|color| {
        let parts = || tiles.iter().map(|tile| tile.mean[color]);
        let square = |part: Estimate| part.standard_error * part.standard_error;
        let squares: f64 = parts().map(square).sum();
        let mean = parts().map(|part| part.mean).sum::<f64>() / count;
        Estimate { mean, standard_error: squares.sqrt() / count }
    }));
    means
}

/// The first mean that two pictures can't agree about, in words.
fn disagreement(ours: &Means, theirs: &Means) -> Option<String> {
    let each = sidak(SIGNIFICANCE, 3 * ours.len() as u32);
    for (place, (ours, theirs)) in ours.iter().zip(theirs).enumerate() {
        for color in 0..3 {
            let (one, other) = (ours[color], theirs[color]);
            if !one.agrees(&other, each) {
                return Some(format!(
                    "tile {place}, colour {color}: ours {one:?}, theirs {other:?}"
                ));
            }
        }
    }
    None
}

/// The same picture with its light changed by a factor.
fn scaled(means: &Means, factor: f64) -> Means {
    let scaled = |it: &Estimate| Estimate {
        mean: factor * it.mean,
        standard_error: factor * it.standard_error,
    };
    means.iter().map(|mean| [0, 1, 2].map(|color| scaled(&mean[color]))).collect()
}

/// Holds what a chapter draws against the scene's reference.
fn check(scene: &str, package: &str, arguments: &str) {
    let ours = ours(package, &format!("--scene {scene} {arguments}"));
    let theirs = theirs(scene);
    assert_eq!(disagreement(&ours, &theirs), None, "{scene} by {package}");
    for planted in [0.98, 1.02] {
        let found = disagreement(&scaled(&ours, planted), &theirs);
        assert!(found.is_some(), "{scene}: a factor of {planted} was not found");
    }
}

#[test]
fn the_cornell_box() {
    check("cornell", "russian-roulette", "--spp 16");
}

#[test]
fn the_cornell_box_found_by_directions_alone() {
    check("cornell", "path-tracing", "--spp 64 --depth 64");
}

#[test]
fn the_cornell_box_by_paths_that_neighbours_share() {
    check("cornell", "multiple-importance", "--spp 4 --reuse 4");
}

#[test]
fn a_mirror_and_glass() {
    check("cornell-glass", "russian-roulette", "--spp 64");
}

#[test]
fn a_ball_that_glows() {
    check("sphere-light", "russian-roulette", "--spp 16 --lighting solid-angle");
}

#[test]
fn many_lamps() {
    check("many-lights", "russian-roulette", "--spp 32");
}

#[test]
fn a_mesh_under_the_sky() {
    check("bunny", "russian-roulette", "--spp 16");
}

#[test]
fn rough_metals() {
    check("rough-metals", "multiple-importance", "--spp 32");
}
