//! Criterion's statistics for the same trees, meshes and rays as the table of `cargo run --release`.
//!
//! ```text
//! cargo bench
//! ```

use std::hint::black_box;

use bvh_peers::rays::{Limited, Workload};
use bvh_peers::rivals::{Obvhs, Ours, Rival, Svenstaro};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

const MESHES: [&str; 2] = ["bunny", "sphere:70000"];

fn all(criterion: &mut Criterion) {
    for name in MESHES {
        let workload = match Workload::named(name, 160) {
            Ok(workload) => workload,
            Err(failure) => panic!("{name}: {failure}"),
        };
        building(criterion, &workload);
        tracing(criterion, &workload);
    }
}

fn building(criterion: &mut Criterion, workload: &Workload) {
    let mut group = criterion.benchmark_group(format!("build {}", workload.name));
    group.sample_size(10).throughput(Throughput::Elements(workload.corners.len() as u64));
    let corners = &workload.corners;
    group.bench_function(Ours::NAME, |bencher| bencher.iter(|| Ours::build(corners)));
    group.bench_function(Obvhs::NAME, |bencher| bencher.iter(|| Obvhs::build(corners)));
    group.bench_function(Svenstaro::NAME, |bencher| bencher.iter(|| Svenstaro::build(corners)));
    group.finish();
}

fn tracing(criterion: &mut Criterion, workload: &Workload) {
    let corners = &workload.corners;
    let (ours, obvhs) = (Ours::build(corners), Obvhs::build(corners));
    let other = Svenstaro::build(corners);
    for (set, rays) in workload.sets() {
        let mut group = criterion.benchmark_group(format!("{set} {}", workload.name));
        group.sample_size(20).throughput(Throughput::Elements(rays.len() as u64));
        let any = set == "shadow";
        group.bench_with_input(BenchmarkId::from_parameter(Ours::NAME), rays, |bencher, rays| {
            bencher.iter(|| trace(&ours, rays, any));
        });
        group.bench_with_input(BenchmarkId::from_parameter(Obvhs::NAME), rays, |bencher, rays| {
            bencher.iter(|| trace(&obvhs, rays, any));
        });
        group.bench_with_input(
            BenchmarkId::from_parameter(Svenstaro::NAME),
            rays,
            |bencher, rays| bencher.iter(|| trace(&other, rays, any)),
        );
        group.finish();
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

criterion_group!(benches, all);
criterion_main!(benches);
