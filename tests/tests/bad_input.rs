//! What bad input gets: one clear message, exit code 1 or 2, no panic, no partial file, and no more
//! memory than there is a limit for. Every row runs the real program.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use common::chapter::Entry;
use tests::chapters::CHAPTERS;
use tests::program::{program, run};

/// A command line that must be refused.
struct Row {
    /// Arguments; the table's files lie in the current folder.
    line: &'static str,
    /// The exit code: 1 the work failed, 2 the command line was wrong.
    code: i32,
    /// What the message must say, the file and the line among it.
    says: &'static [&'static str],
}

const fn row(line: &'static str, code: i32, says: &'static [&'static str]) -> Row {
    Row { line, code, says }
}

/// Wrong in every chapter.
const COMMON: [Row; 17] = [
    row("--size 0x0", 2, &["--size", "at least one pixel"]),
    row("--size 640", 2, &["--size", "640x480"]),
    row("--size 99999999x99999999", 2, &["--size", "67108864"]),
    row("--size -1x5", 2, &["--size"]),
    row("--spp 0", 2, &["--spp"]),
    row("--spp 99999999999", 2, &["--spp"]),
    row("--threads 0", 2, &["--threads"]),
    row("--threads 1000000", 2, &["--threads"]),
    row("--seed nan", 2, &["--seed"]),
    row("--scene no-such-scene", 2, &["no-such-scene", "Scenes:"]),
    row("--scene ../../nowhere", 2, &["nowhere", "Scenes:"]),
    row("--simulate some", 2, &["--simulate", "needed"]),
    row("--no-such-option", 2, &["--no-such-option"]),
    row("--size 8x8 --out picture.gif", 2, &["picture.gif", ".png or .exr"]),
    row("--size 8x8 --out empty.obj/picture.png", 1, &["empty.obj/picture.png", "--out"]),
    row("cost --out plot.png", 2, &["plot.png", ".svg"]),
    row("hard --trials 0", 2, &["--trials"]),
];

/// Wrong in every chapter that reads meshes.
const MESHES: [Row; 22] = [
    row("--scene missing.obj", 1, &["missing.obj"]),
    row("--scene folder.obj", 1, &["folder.obj", "folder"]),
    row("--scene empty.obj", 1, &["empty.obj"]),
    row("--scene binary.obj", 1, &["binary.obj"]),
    row("--scene truncated.obj", 1, &["truncated.obj", "3"]),
    row("--scene nan.obj", 1, &["nan.obj", "2"]),
    row("--scene inf.obj", 1, &["inf.obj", "2"]),
    row("--scene 1e400.obj", 1, &["1e400.obj", "2"]),
    row("--scene zero-index.obj", 1, &["zero-index.obj", "4"]),
    row("--scene far-index.obj", 1, &["far-index.obj", "4"]),
    row("--scene negative-index.obj", 1, &["negative-index.obj", "4"]),
    row("--scene two-corners.obj", 1, &["two-corners.obj", "4"]),
    row("--scene no-faces.obj", 1, &["no-faces.obj"]),
    row("--scene huge.obj", 1, &["huge.obj"]),
    row("--scene long-line.obj", 1, &["long-line.obj"]),
    row("--scene bad-mtl.obj", 1, &["nonsense.mtl", "2"]),
    row("--scene nan-mtl.obj", 1, &["nan.mtl", "2"]),
    row("--scene sphere:0", 2, &["sphere:0"]),
    row("--scene sphere:-3", 2, &["sphere:-3"]),
    row("--scene sphere:many", 2, &["sphere:many"]),
    row("--scene sphere:99999999999999999999", 2, &["sphere:99999999999999999999"]),
    row("--scene sphere:4000000000", 2, &["sphere:4000000000"]),
];

/// Wrong where there are lamps and materials.
const LIT: [Row; 12] = [
    row("--sun 0,0,0", 2, &["no light", "direction", "not all of them 0"]),
    row("--sun inf,0,0", 2, &["--sun", "finite"]),
    row("--lamp 1,2", 2, &["--lamp", "three finite numbers"]),
    row("--lamp 0,nan,0", 2, &["--lamp"]),
    row("--lamp 0,5,0 --falloff 0,0,0", 2, &["no light", "fall-off", "not all of them 0"]),
    row("--lamp 0,5,0 --falloff 1,-2,0", 2, &["no light", "fall-off", "from 0 up"]),
    row("--falloff 0,0,1", 2, &["--lamp"]),
    row("--shininess -1", 2, &["--shininess", "from 0"]),
    row("--ambient 1e400", 2, &["--ambient", "from 0"]),
    row("--model gouraud", 2, &["--model", "blinn-phong"]),
    row("--scene bright-mtl.obj", 1, &["bright-mtl.obj", "material sun", "Ks", "1e38"]),
    row("--scene negative-mtl.obj", 1, &["negative.mtl", "2"]),
];

/// Wrong where there are shadows.
const SHADED: [Row; 5] = [
    row("--offset epsilon", 2, &["--offset", "bound"]),
    row("--sun 0,0,0", 2, &["no light", "direction", "not all of them 0"]),
    row("--lamp 1,2", 2, &["--lamp", "three finite numbers"]),
    row("--lamp 0,1e400,0", 2, &["--lamp"]),
    row("--scene small --eye 1,1,1 --look-at 1,1,1", 2, &["no picture", "two different points"]),
];

/// Wrong where rays are followed from mirror to mirror.
const MIRRORS: [Row; 9] = [
    row("--depth -1", 2, &["--depth"]),
    row("--depth nan", 2, &["--depth"]),
    row("--depth 1000001", 2, &["--depth", "1000000"]),
    row("--cutoff nan", 2, &["--cutoff", "from 0 to below 1"]),
    row("--cutoff -1", 2, &["--cutoff", "from 0 to below 1"]),
    row("--cutoff 2", 2, &["--cutoff", "from 0 to below 1"]),
    row("--cutoff 1", 2, &["--cutoff", "from 0 to below 1"]),
    row("--trace magic", 2, &["--trace", "recursion"]),
    row("--trace recursion --depth 1000000", 2, &["stack", "--trace loop"]),
];

/// Wrong where there is glass.
const GLASS: [Row; 12] = [
    row("--index 0", 2, &["--index", "from 0.001 to 1000", "0 is not"]),
    row("--index -1.5", 2, &["--index", "from 0.001 to 1000"]),
    row("--index nan", 2, &["--index", "from 0.001 to 1000"]),
    row("--index inf", 2, &["--index", "from 0.001 to 1000"]),
    row("--index 1e400", 2, &["--index", "from 0.001 to 1000"]),
    row("--index glass", 2, &["--index", "a number"]),
    row("--fresnel magic", 2, &["--fresnel", "schlick"]),
    row("--branch three", 2, &["--branch", "both"]),
    row("--depth -1", 2, &["--depth"]),
    row("--cutoff 1", 2, &["--cutoff", "from 0 to below 1"]),
    row("--scene dense-mtl.obj", 1, &["dense-mtl.obj", "material star", "Ni", "1000"]),
    row("--scene no-index-mtl.obj", 1, &["no-index.mtl", "2", "Ni"]),
];

/// Wrong where paths are followed.
const PATHS: [Row; 6] = [
    row("--depth -1", 2, &["--depth", "from 0 to 100000"]),
    row("--depth 4294967295", 2, &["--depth", "from 0 to 100000"]),
    row("--albedo 1.5", 2, &["--albedo", "from 0 to 1"]),
    row("--albedo nan", 2, &["--albedo", "from 0 to 1"]),
    row("--scene white-mtl.obj", 1, &["white-mtl.obj", "material chalk", "from 0 to 1"]),
    row("--scene nan-mtl.obj", 1, &["nan.mtl", "2"]),
];

/// Wrong in one of the chapters that follow paths.
const OWN_PATHS: [(&str, Row); 9] = [
    ("light-sampling", row("--lighting magic", 2, &["--lighting", "solid-angle"])),
    ("light-sampling", row("--lamps brightest", 2, &["--lamps", "power"])),
    ("russian-roulette", row("--roulette 0", 2, &["--roulette"])),
    ("russian-roulette", row("--roulette nan", 2, &["--roulette"])),
    ("russian-roulette", row("--survival 2", 2, &["--survival"])),
    ("russian-roulette", row("--threshold -1", 2, &["--threshold"])),
    ("microfacets", row("--roughness 1.5", 2, &["--roughness"])),
    ("microfacets", row("--roughness nan", 2, &["--roughness"])),
    ("multiple-importance", row("--heuristic magic", 2, &["--heuristic", "balance"])),
];

/// The files of the table. `huge.obj` is 1 TiB of nothing that takes no place on the disk.
fn files(folder: &Path) {
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 2 0\n";
    let texts: [(&str, String); 28] = [
        ("empty.obj", String::new()),
        ("truncated.obj", "v 0 0 0\nv 1 0 0\nv 0 2".into()),
        ("nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 2 0\nf 1 2 3\n".into()),
        ("inf.obj", "v 0 0 0\nv 1 -inf 0\nv 0 2 0\nf 1 2 3\n".into()),
        ("1e400.obj", "v 0 0 0\nv 1 1e400 0\nv 0 2 0\nf 1 2 3\n".into()),
        ("zero-index.obj", format!("{triangle}f 0 1 2\n")),
        ("far-index.obj", format!("{triangle}f 1 2 4\n")),
        ("negative-index.obj", format!("{triangle}f -1 -2 -4\n")),
        ("two-corners.obj", format!("{triangle}f 1 2\n")),
        ("no-faces.obj", triangle.into()),
        ("long-line.obj", "v ".repeat(50_000_000)),
        ("bad-mtl.obj", format!("mtllib nonsense.mtl\n{triangle}f 1 2 3\n")),
        ("nonsense.mtl", "newmtl odd\nKd red green blue\n".into()),
        ("nan-mtl.obj", format!("mtllib nan.mtl\n{triangle}f 1 2 3\n")),
        ("nan.mtl", "newmtl odd\nKd 0.5 nan 0.5\n".into()),
        ("bright-mtl.obj", format!("mtllib bright.mtl\n{triangle}usemtl sun\nf 1 2 3\n")),
        ("bright.mtl", "newmtl sun\nillum 2\nKd 1 1 1\nKs 1e38 0 0\nNs 5\n".into()),
        ("negative-mtl.obj", format!("mtllib negative.mtl\n{triangle}f 1 2 3\n")),
        ("negative.mtl", "newmtl odd\nKs 0.5 -1 0.5\n".into()),
        ("white-mtl.obj", format!("mtllib white.mtl\n{triangle}usemtl chalk\nf 1 2 3\n")),
        ("white.mtl", "newmtl chalk\nKd 1.5 1 1\n".into()),
        ("dense-mtl.obj", format!("mtllib dense.mtl\n{triangle}usemtl star\nf 1 2 3\n")),
        ("dense.mtl", "newmtl star\nillum 7\nNi 1e30\n".into()),
        ("no-index-mtl.obj", format!("mtllib no-index.mtl\n{triangle}f 1 2 3\n")),
        ("no-index.mtl", "newmtl odd\nNi 0\n".into()),
        ("pentagon.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n".into()),
        ("no-mtl.obj", format!("mtllib gone.mtl\nusemtl gold\n{triangle}f 1 2 3\n")),
        ("negative-good.obj", format!("{triangle}f -3 -2 -1\n")),
    ];
    for (name, text) in texts {
        fs::write(folder.join(name), text).expect("a temporary folder takes files");
    }
    let bytes: Vec<u8> = (0..4096u32).map(|index| (index * 37 % 256) as u8).collect();
    fs::write(folder.join("binary.obj"), bytes).expect("and bytes");
    fs::create_dir(folder.join("folder.obj")).expect("and folders");
    let huge = fs::File::create(folder.join("huge.obj")).expect("and a sparse file");
    huge.set_len(1 << 40).expect("of any length");
}

fn refuse(package: &str, row: &Row, folder: &Path) {
    let before = listing(folder);
    // 2 GiB of addresses are plenty for a refusal.
    let line = format!("ulimit -v 2097152; exec \"$0\" {}", row.line);
    let shell = program(package);
    let output = run(Path::new("sh"), folder, &["-c", &line, &shell.to_string_lossy()]);
    let message = String::from_utf8_lossy(&output.stderr);
    let context = format!("{package} {}: {message}", row.line);
    assert_eq!(output.status.code(), Some(row.code), "{context}");
    assert!(row.says.iter().all(|word| message.contains(word)), "{:?} in {context}", row.says);
    assert!(!message.contains("panicked"), "{context}");
    assert_eq!(listing(folder), before, "{context}: a file was left behind");
}

/// All files below a folder.
fn listing(folder: &Path) -> Vec<String> {
    let mut names = Vec::new();
    for entry in fs::read_dir(folder).expect("it is a folder") {
        let path = entry.expect("that can be read").path();
        names.push(path.display().to_string());
        if path.is_dir() {
            names.extend(listing(&path));
        }
    }
    names.sort();
    names.retain(|name| !name.ends_with("/out"));
    names
}

/// The chapters that draw meshes.
fn with_meshes() -> impl Iterator<Item = &'static Entry> {
    let without = ["ray-casting", "monte-carlo"];
    CHAPTERS.into_iter().filter(move |chapter| !without.contains(&chapter.package()))
}

#[test]
fn every_chapter_refuses_what_is_wrong_everywhere() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    files(folder.path());
    for chapter in &CHAPTERS {
        for row in &COMMON {
            refuse(chapter.package(), row, folder.path());
        }
    }
}

#[test]
fn every_chapter_with_meshes_refuses_bad_ones() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    files(folder.path());
    for chapter in with_meshes() {
        for row in &MESHES {
            refuse(chapter.package(), row, folder.path());
        }
    }
}

#[test]
fn lamps_and_materials_that_can_t_be_are_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    files(folder.path());
    for row in &LIT {
        refuse("blinn-phong", row, folder.path());
    }
    for row in &SHADED {
        refuse("shadows", row, folder.path());
    }
}

#[test]
fn depths_and_cutoffs_that_cannot_be_are_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for row in &MIRRORS {
        refuse("whitted", row, folder.path());
    }
}

#[test]
fn glass_that_cannot_be_is_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    files(folder.path());
    for row in &GLASS {
        refuse("fresnel", row, folder.path());
    }
}

#[test]
fn paths_that_cannot_be_are_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    files(folder.path());
    for chapter in &CHAPTERS[11..] {
        for row in &PATHS {
            refuse(chapter.package(), row, folder.path());
        }
    }
    for (package, row) in &OWN_PATHS {
        refuse(package, row, folder.path());
    }
}

/// The control: a depth of a million, and none, are drawn.
#[test]
fn any_depth_is_drawn() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for line in ["--depth 0", "--depth 1000000", "--trace recursion --depth 500"] {
        let line = format!("--scene facing-mirrors --size 16x12 --out deep.png {line}");
        let arguments: Vec<&str> = line.split(' ').collect();
        let output = run(&program("whitted"), folder.path(), &arguments);
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{line}: {message}");
    }
}

/// The control of the table above: files that look odd and are right.
#[test]
fn odd_meshes_that_are_right_are_drawn() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    files(folder.path());
    for chapter in with_meshes() {
        for scene in ["pentagon.obj", "negative-good.obj", "no-mtl.obj"] {
            let line = ["--scene", scene, "--size", "16x12", "--out", "odd.png"];
            let output = run(&program(chapter.package()), folder.path(), &line);
            let message = String::from_utf8_lossy(&output.stderr);
            assert_eq!(output.status.code(), Some(0), "{scene}: {message}");
            assert_eq!(message.contains("gone.mtl"), scene == "no-mtl.obj", "{scene}: {message}");
            let quiet = run(
                &program(chapter.package()),
                folder.path(),
                &[&line[..], &["--quiet"]].concat(),
            );
            assert!(quiet.stdout.is_empty() && quiet.stderr.is_empty(), "{scene}: {quiet:?}");
        }
    }
}

#[test]
fn a_full_disk_is_told() {
    for chapter in &CHAPTERS {
        let folder = tempfile::tempdir().expect("a temporary folder");
        std::os::unix::fs::symlink("/dev/full", folder.path().join("full.png")).expect("a link");
        let line = ["--size", "16x12", "--out", "full.png"];
        let output = run(&program(chapter.package()), folder.path(), &line);
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{message}");
        assert!(message.contains("full.png") && !message.contains("panicked"), "{message}");
    }
}

/// Runs a program whose standard output nobody reads: the reading end is closed before it starts, so
/// not even its first line can slip through.
fn unread(package: &str, arguments: &[&str], folder: &Path) -> Output {
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    let mut command = Command::new(program(package));
    command.args(arguments).current_dir(folder).stdin(Stdio::null());
    let child = command.stdout(writer).stderr(Stdio::piped()).spawn().expect("the program starts");
    child.wait_with_output().expect("and ends")
}

#[test]
fn a_closed_pipe_is_told_and_is_no_panic() {
    for chapter in &CHAPTERS {
        let folder = tempfile::tempdir().expect("a temporary folder");
        for line in [&["--size", "16x12"][..], &["hard", "--trials", "10"], &["--help"]] {
            let output = unread(chapter.package(), line, folder.path());
            let message = String::from_utf8_lossy(&output.stderr);
            assert_eq!(output.status.code(), Some(1), "{line:?}: {message}");
            assert!(!message.contains("panicked"), "{line:?}: {message}");
        }
    }
}
