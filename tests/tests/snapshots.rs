//! Pictures, counters, hard cases and errors as text a reviewer can read.
//!
//! A snapshot is our own output from yesterday, so each stands beside a test with an oracle of its
//! own: the chapters' unit tests, the ledger's negative controls, the tests of determinism.

use std::fmt::Write;

use common::chapter::Entry;
use common::film::exr;
use common::hard::{self, Ledger};
use tests::chapters::{CHAPTERS, print};

/// The picture's tile means, its counters and its plan, for one small render.
fn picture(chapter: &Entry, arguments: &str) -> String {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("picture.exr");
    let line = format!("{arguments} --json --out {}", path.display());
    let json: serde_json::Value =
        serde_json::from_str(&print(chapter, &line)).expect("one JSON object");
    let film = exr::decode(&std::fs::read(path).expect("it was written")).expect("an EXR file");
    let mut text = format!("{} {arguments}\nhash {}\n", chapter.package(), json["hash"]);
    for key in ["counters", "plan", "nonfinite"] {
        let value = serde_json::to_string_pretty(&json[key]).expect("it was JSON");
        writeln!(text, "{key} {value}").expect("a string takes all");
    }
    text += "tile means, 4 by 3:\n";
    for row in film.tile_means(4, 3).chunks(4) {
        let cells: Vec<String> =
            row.iter().map(|mean| format!("({:.4} {:.4} {:.4})", mean.x, mean.y, mean.z)).collect();
        writeln!(text, "  {}", cells.join(" ")).expect("a string takes all");
    }
    text
}

#[test]
fn pictures() {
    for chapter in &CHAPTERS {
        insta::assert_snapshot!(
            format!("{}-picture", chapter.id),
            picture(chapter, "--size 96x72")
        );
    }
}

#[test]
fn ledgers() {
    insta::assert_snapshot!("common-hard", Ledger::of(&hard::pixels::CASES, 1 << 20));
    for chapter in &CHAPTERS {
        let ledger = Ledger::of(&(chapter.hard)(), 1_000_000);
        assert!(ledger.broken().is_empty(), "{}\n{ledger}", chapter.id);
        insta::assert_snapshot!(format!("{}-hard", chapter.id), ledger);
    }
}

#[test]
fn work_and_error_of_every_experiment() {
    for chapter in &CHAPTERS {
        let pinned = common::cost::pinned(&(chapter.cost)());
        insta::assert_snapshot!(format!("{}-cost", chapter.id), pinned);
    }
}
