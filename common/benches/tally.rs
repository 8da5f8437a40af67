//! Counting costs nothing when it is off: one loop with [`Off`], with [`Counts`], and without any
//! tally in its source. `cargo bench -p common`

use std::hint::black_box;

use common::tally::{Counts, Event, Off, Tally};
use criterion::{Criterion, criterion_group, criterion_main};

const STEPS: Event = Event::new(0, 0, "steps");

fn bare(numbers: &[f32]) -> f32 {
    let mut sum = 0.0;
    for &number in numbers {
        if number > 0.5 {
            sum += number * number;
        }
    }
    sum
}

fn tallied<T: Tally>(numbers: &[f32], tally: &mut T) -> f32 {
    let mut sum = 0.0;
    for &number in numbers {
        tally.count(STEPS, 1);
        if number > 0.5 {
            sum += number * number;
        }
    }
    sum
}

fn compare(criterion: &mut Criterion) {
    let numbers: Vec<f32> = (0..4096u16).map(|number| f32::from(number) / 4096.0).collect();
    let mut group = criterion.benchmark_group("4096 steps");
    group.bench_function("no tally in the source", |b| b.iter(|| bare(black_box(&numbers))));
    group.bench_function("tally off", |b| b.iter(|| tallied(black_box(&numbers), &mut Off)));
    let mut counts = Counts::default();
    group.bench_function("tally on", |b| b.iter(|| tallied(black_box(&numbers), &mut counts)));
    group.finish();
}

criterion_group!(benches, compare);
criterion_main!(benches);
