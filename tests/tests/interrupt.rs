//! Ctrl-C saves what is finished, says so, and exits 130.

use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};
use std::time::Duration;

use tests::chapters::CHAPTERS;
use tests::program::program;

#[test]
fn ctrl_c_saves_what_is_finished() {
    for chapter in &CHAPTERS {
        let folder = tempfile::tempdir().expect("a temporary folder");
        // Far more samples than anybody waits for.
        let line = ["--size", "640x480", "--spp", "1000000", "--out", "half.exr"];
        let mut child = Command::new(program(chapter.package()))
            .args(line)
            .current_dir(folder.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        // The plan is printed before the first pixel.
        let mut plan = String::new();
        let mut lines = BufReader::new(child.stdout.take().expect("it was piped"));
        lines.read_line(&mut plan).expect("the program says something");
        std::thread::sleep(Duration::from_millis(200));
        let pid = child.id().to_string();
        let sent = Command::new("kill").args(["-INT", &pid]).status().expect("there is a kill");
        assert!(sent.success());
        let mut rest = String::new();
        while lines.read_line(&mut rest).is_ok_and(|read| read > 0) {}
        let output = child.wait_with_output().expect("it ends");
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(130), "{}: {message}", chapter.id);
        assert!(message.contains("Ctrl-C") && message.contains("half.exr"), "{message}");
        let bytes = std::fs::read(folder.path().join("half.exr")).expect("it was saved");
        let film = common::film::exr::decode(&bytes).expect("and is whole");
        assert_eq!((film.width, film.height), (640, 480));
    }
}
