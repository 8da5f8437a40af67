//! Prints how this chapter's tree compares: medians of rounds in which all take turns.
//!
//! ```text
//! cargo run --release -- [--rounds N] [--width N] [--threads N] [bunny sphere:1000000 FILE.obj ...]
//! ```

use std::hint::black_box;
use std::process::ExitCode;
use std::time::Instant;

use bvh_peers::rays::{Limited, Workload};
use bvh_peers::rivals::{Obvhs, Ours, Rival, Svenstaro};

fn main() -> ExitCode {
    let (mut rounds, mut width, mut threads) = (7, 320, 1);
    let mut names = Vec::new();
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut number = || arguments.next().and_then(|text| text.parse().ok()).unwrap_or(1);
        match argument.as_str() {
            "--rounds" => rounds = number(),
            "--width" => width = number() as u32,
            "--threads" => threads = number(),
            _ => names.push(argument),
        }
    }
    if names.is_empty() {
        names = ["bunny", "sphere:70000", "sphere:1000000"].map(String::from).to_vec();
    }
    // Both build on rayon's threads; one is the fairest.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let Ok(pool) = pool else { return ExitCode::FAILURE };
    for name in names {
        match Workload::named(&name, width) {
            Ok(workload) => pool.install(|| compare(&workload, rounds)),
            Err(failure) => return failure.report(),
        }
    }
    ExitCode::SUCCESS
}

/// One line for building and one for each kind of ray.
fn compare(workload: &Workload, rounds: usize) {
    let corners = &workload.corners;
    println!("{}: {} triangles", workload.name, corners.len());
    let count = corners.len() as f64;
    let built = taking_turns(
        rounds.min(5),
        || drop(black_box(Ours::build(corners))),
        || drop(black_box(Obvhs::build(corners))),
        || drop(black_box(Svenstaro::build(corners))),
    );
    line("build", "triangles", count, built);
    let (ours, obvhs, other) =
        (Ours::build(corners), Obvhs::build(corners), Svenstaro::build(corners));
    let [a, b, c] = [ours.bytes(), obvhs.bytes(), other.bytes()].map(|bytes| bytes as f64 / count);
    println!("  bytes a triangle: {a:.0}, {b:.0}, {c:.0}");
    for (set, rays) in workload.sets() {
        let any = set == "shadow";
        let spent = taking_turns(
            rounds,
            || trace(&ours, rays, any),
            || trace(&obvhs, rays, any),
            || trace(&other, rays, any),
        );
        line(set, "rays", rays.len() as f64, spent);
    }
}

fn trace(tree: &impl Rival, rays: &[Limited], any: bool) {
    for ray in rays {
        if any {
            black_box(tree.any(ray));
        } else {
            black_box(tree.nearest(ray));
        }
    }
}

/// The median seconds of each.
fn taking_turns(
    rounds: usize,
    mut ours: impl FnMut(),
    mut second: impl FnMut(),
    mut third: impl FnMut(),
) -> [f64; 3] {
    let mut times = [const { Vec::new() }; 3];
    for _ in 0..rounds {
        times[0].push(timed(&mut ours));
        times[1].push(timed(&mut second));
        times[2].push(timed(&mut third));
    }
    times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        times[times.len() / 2]
    })
}

fn timed(work: &mut impl FnMut()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64()
}

fn line(what: &str, unit: &str, count: f64, seconds: [f64; 3]) {
    let [ours, obvhs, other] = seconds.map(|seconds| count / seconds * 1e-6);
    println!(
        "  {what:8} million {unit} a second: {} {ours:.2}, {} {obvhs:.2} ({:.2} times), {} {other:.2} ({:.2} times)",
        Ours::NAME,
        Obvhs::NAME,
        ours / obvhs,
        Svenstaro::NAME,
        ours / other,
    );
}
