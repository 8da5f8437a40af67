//! The report's headline (its section 5.2): the bunny with a tree and without.

use std::io::Write;
use std::num::NonZeroU16;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Instant;

use clap::{ArgMatches, Args, FromArgMatches};
use common::args::Size;
use common::chapter::{Failure, OwnCommand, Target, default_path};
use common::film::Film;
use common::interrupt;
use common::plan::{Plan, Simulate};
use common::render::{Rendering, Settings, Watch};
use common::tally::Off;
use partitions::accelerator::{Accelerator, Statistics};
use serde_json::json;
use shadows::calls;
use shadows::command::SKILLS;
use shadows::offset::Offset;
use shadows::picture::Picture;
use shadows::scenes::named;
use triangles::bunny::bunny;
use triangles::convert::Normals;

use crate::choice::AccelChoice;
use crate::packed::PackedBvh;

/// `headline`.
pub const COMMAND: OwnCommand = OwnCommand {
    name: "headline",
    about: "The report's bunny without a tree and with one, and how many times sooner that is",
    options: Options::augment_args,
    run,
};

/// Its options.
#[derive(Clone, Debug, Args)]
struct Options {
    /// Pixels across and down
    #[arg(long, allow_hyphen_values = true, value_name = "WxH", default_value = "1280x960")]
    size: Size,
    /// Threads
    #[arg(long, value_name = "N", default_value = "1")]
    threads: NonZeroU16,
    /// Where the picture goes: a .png or .exr file
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Print one JSON object instead of text
    #[arg(long)]
    json: bool,
}

/// What the report says it took: with its tree, and without.
const REPORT_SECONDS: [f64; 2] = [9.0, 2049.0];

/// One of the two pictures.
struct Drawn {
    build_seconds: f64,
    seconds: f64,
    film: Film,
    complete: bool,
}

/// Stops when Ctrl-C was pressed.
struct Stoppable;

impl Watch for Stoppable {
    fn done(&self, _pixels: u64) {}

    fn stop(&self) -> bool {
        interrupt::asked()
    }
}

fn run(matches: &ArgMatches, out: &mut dyn Write) -> Result<ExitCode, Failure> {
    let options = Options::from_arg_matches(matches)?;
    let path = options.out.clone();
    let path = path.unwrap_or_else(|| default_path("10-bvh-headline", "png"));
    let target = Target::new(path.clone())?;
    let tree = draw(AccelChoice::Bvh, &options)?;
    if !options.json {
        line(out, "bvh", &tree)?;
    }
    let brute = draw(AccelChoice::Brute, &options)?;
    if !(tree.complete && brute.complete) {
        writeln!(std::io::stderr(), "stopped by Ctrl-C; there is nothing to compare")?;
        return Ok(ExitCode::from(interrupt::EXIT_CODE));
    }
    let ratio = brute.seconds / (tree.build_seconds + tree.seconds);
    let [with, without] = REPORT_SECONDS;
    if options.json {
        let Options { size: Size { width, height }, threads, .. } = options;
        let object = json!({
            "width": width, "height": height, "threads": threads,
            "bvh": {
                "build_seconds": tree.build_seconds,
                "seconds": tree.seconds,
                "bytes_per_triangle": bytes_per_triangle()?,
            },
            "brute": { "seconds": brute.seconds },
            "ratio": ratio,
            "report": { "bvh": with, "brute": without, "ratio": without / with },
            "hash": format!("{:016x}", tree.film.hash()),
        });
        writeln!(out, "{object}")?;
    } else {
        line(out, "brute", &brute)?;
        let report = without / with;
        writeln!(out, "{ratio:.0} times sooner with the tree, its building included")?;
        writeln!(out, "the report: {with} s and {without} s, {report:.0} times")?;
        writeln!(out, "the picture is in {}", path.display())?;
    }
    target.write(&tree.film)?;
    match tree.film.hash() == brute.film.hash() {
        true => Ok(ExitCode::SUCCESS),
        false => Err(Failure::Work("the two pictures are not the same".into())),
    }
}

/// What the bunny's tree takes in memory, its triangles included.
fn bytes_per_triangle() -> Result<f64, Failure> {
    let mesh = bunny(Normals::Flat).map_err(|error| Failure::Work(error.to_string()))?;
    let Statistics { bytes, triangles, .. } = PackedBvh::build(mesh.all_corners()).statistics();
    Ok(bytes as f64 / triangles as f64)
}

/// One sample a pixel, two lamps, shadows.
fn draw(accel: AccelChoice, options: &Options) -> Result<Drawn, Failure> {
    let Size { width, height } = options.size;
    let settings = Settings {
        width,
        height,
        threads: usize::from(options.threads.get()),
        watch: Arc::new(Stoppable),
        ..Settings::default()
    };
    let start = Instant::now();
    let stage = named("bunny", accel.shape())?;
    let build_seconds = start.elapsed().as_secs_f64();
    let plan = Plan::new(&calls::of_scene(&stage.scene, &stage.calls), SKILLS, Simulate::Needed);
    let camera = stage.camera.with_film(width, height);
    let picture = Picture { scene: &stage.scene, camera, offset: Offset::Bound };
    let start = Instant::now();
    let Rendering::<Off> { film, complete, .. } = picture.draw(&settings, &plan);
    let seconds = start.elapsed().as_secs_f64();
    Ok(Drawn { build_seconds, seconds, film, complete })
}

fn line(out: &mut dyn Write, name: &str, drawn: &Drawn) -> Result<(), Failure> {
    let Drawn { build_seconds, seconds, film, .. } = drawn;
    let hash = film.hash();
    writeln!(
        out,
        "{name:6} {seconds:9.3} s, after {build_seconds:.3} s for the scene, hash {hash:016x}"
    )?;
    Ok(out.flush()?)
}
