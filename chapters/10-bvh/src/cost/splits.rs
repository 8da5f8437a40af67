//! What a better tree costs to build, and what it saves.

use std::hint::black_box;

use common::cost::{Experiment, Method, Plot, no_note};
use glam::Vec3;
use partitions::cost::sight::{ERROR, Sight};

use crate::build::Recipe;
use crate::packed::PackedBvh;
use crate::plain::PlainBvh;
use crate::split::Split;

/// The trees compared: their names and how they are built.
const TREES: [(&str, Split, usize); 6] = [
    ("midpoint, leaf 4", Split::Midpoint, 4),
    ("median, leaf 4", Split::Median, 4),
    ("sah, leaf 1", Split::Sah, 1),
    ("sah, leaf 4", Split::Sah, 4),
    ("sah, leaf 8", Split::Sah, 8),
    ("sah, leaf 16", Split::Sah, 16),
];

fn recipes() -> impl Iterator<Item = (&'static str, Recipe)> {
    TREES.into_iter().map(|(name, split, leaf)| (name, Recipe { split, leaf, ..Recipe::TRIANGLES }))
}

/// Tracing: what is asked and how long it takes.
pub(super) fn tracing(corners: &[[Vec3; 3]]) -> Experiment<'static> {
    let sight = Sight::bunny(corners.to_vec());
    let methods = recipes().map(|(name, recipe)| {
        let tree = PackedBvh::new(corners, &recipe);
        let work = sight.work(&tree);
        sight.method(tree, name, name.into(), 1.0, work)
    });
    Experiment {
        name: "tracing",
        title: "Rays through trees that were split in different ways",
        work_unit: "nodes and triangles asked",
        error_metric: ERROR,
        plot: Plot::ErrorOverTime("wrong hits"),
        methods: methods.collect(),
        note: no_note,
    }
}

/// Building: how long it takes, and how good the tree is.
pub(super) fn building(corners: &[[Vec3; 3]]) -> Experiment<'static> {
    let method = |(name, recipe): (&'static str, Recipe)| {
        let tree = PlainBvh::new(corners, &recipe);
        let corners = corners.to_vec();
        Method {
            label: name.into(),
            series: name,
            size: 1.0,
            work: tree.stored().len() as u64,
            error: tree.tree().expected_work(recipe.together),
            run: Box::new(move || drop(black_box(PackedBvh::new(&corners, &recipe)))),
        }
    };
    Experiment {
        name: "building",
        title: "Trees: time to build against the work they promise",
        work_unit: "triangles",
        error_metric: "work to be expected for a ray that meets the root (surface area heuristic)",
        plot: Plot::ErrorOverTime("work expected a ray"),
        methods: recipes().map(method).collect(),
        note: no_note,
    }
}
