//! Same seed, same bits: for any number of threads, either build profile, and with or without the
//! effects a scene doesn't call for.

use serde_json::Value;
use tests::chapters::{CHAPTERS, render};
use tests::program::{program, run};

/// More than one tile, more than one sample, and no multiple of anything.
const SMALL: &str = "--size 67x45 --spp 3 --seed 9";

#[test]
fn threads_do_not_change_a_bit_or_a_counter() {
    for chapter in &CHAPTERS {
        let with = |threads| render(chapter, &format!("{SMALL} --threads {threads}"));
        let one = with(1);
        for threads in [2, 3, 7] {
            let many = with(threads);
            assert_eq!(one["hash"], many["hash"], "{} with {threads} threads", chapter.id);
            assert_eq!(one["counters"], many["counters"], "{}", chapter.id);
        }
    }
}

#[test]
fn the_seed_does_change_bits() {
    for chapter in &CHAPTERS {
        let with = |seed| render(chapter, &format!("--size 67x45 --spp 3 --seed {seed}"));
        assert_ne!(with(1)["hash"], with(2)["hash"], "{}", chapter.id);
    }
}

#[test]
fn simulating_more_than_needed_changes_no_bit() {
    for chapter in &CHAPTERS {
        let with = |effects| render(chapter, &format!("{SMALL} --simulate {effects}"));
        assert_eq!(with("needed")["hash"], with("all")["hash"], "{}", chapter.id);
    }
}

#[test]
fn counting_changes_no_bit() {
    for chapter in &CHAPTERS {
        let with = |tally| render(chapter, &format!("{SMALL} --tally {tally}"));
        assert_eq!(with("on")["hash"], with("off")["hash"], "{}", chapter.id);
    }
}

#[test]
fn no_sample_is_nan_or_infinite() {
    for chapter in &CHAPTERS {
        assert_eq!(render(chapter, SMALL)["nonfinite"], 0, "{}", chapter.id);
    }
}

/// The chapters inside this test, in the tests' build profile, against the programs a reader runs.
#[test]
fn debug_and_release_agree() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for chapter in &CHAPTERS {
        let line = format!("{SMALL} --json --out release.exr");
        let arguments: Vec<&str> = line.split(' ').collect();
        let output = run(&program(chapter.package()), folder.path(), &arguments);
        let json: Value = serde_json::from_slice(&output.stdout).expect("one JSON object");
        assert_eq!(render(chapter, SMALL)["hash"], json["hash"], "{}", chapter.id);
    }
}
