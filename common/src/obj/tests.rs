//! What holds of [`parse`](super::parse) as a whole.

use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

use glam::{Vec2, Vec3};
use proptest::prelude::{Strategy, any, prop_oneof};
use proptest::test_runner::{Config, TestRunner};

use super::nasty::{Expected, MTL, OBJ, WITH_MATERIAL};
use super::{Model, ObjError, parse};

fn read(text: &[u8]) -> Result<Model, ObjError> {
    parse("dir/mesh.obj", text, |name| Err(format!("no {name}")))
}

#[test]
fn every_nasty_mesh_has_its_outcome() {
    for nasty in OBJ {
        let outcome = parse("nasty.obj", nasty.text, |_| Err("not here".to_owned()));
        assert!(nasty.robust(), "{}: {outcome:?}", nasty.what);
    }
    let fooled = OBJ.iter().filter(|nasty| !nasty.naive()).map(|nasty| nasty.what);
    let fooled: Vec<&str> = fooled.collect();
    for trap in
        ["NaN", "infinity", "1e400", "dart", "continued line", "repeated index beside a sound face"]
    {
        assert!(fooled.contains(&trap), "the parser alone is not fooled by {trap}: {fooled:?}");
    }
}

#[test]
fn every_nasty_material_has_its_outcome() {
    for nasty in MTL {
        let outcome = parse("m.obj", WITH_MATERIAL, |_| Ok(nasty.text.to_vec()));
        assert!(nasty.robust_material(), "{}: {outcome:?}", nasty.what);
    }
}

#[test]
fn an_error_is_one_short_line_that_begins_with_file_and_line() {
    for nasty in OBJ {
        let Expected::Refused(line) = nasty.expected else { continue };
        let error = read(nasty.text).unwrap_err().to_string();
        let start =
            line.map_or("dir/mesh.obj: ".to_owned(), |line| format!("dir/mesh.obj:{line}: "));
        assert!(error.starts_with(&start), "{error}");
        assert!(error.len() < 160 && !error.contains(char::is_control), "{error}");
    }
    let long = format!("v 1 2 {}", "\u{7}x".repeat(1_000_000));
    let error = read(long.as_bytes()).unwrap_err().to_string();
    assert!(error.len() < 160 && !error.contains(char::is_control), "{error}");
}

#[test]
fn every_statement_reaches_its_array() {
    let text = b"mtllib paint.mtl\nv 1 2 3\nv 4 0 0\nv 0 5 0\nv 0 0 7\nvt .1 .2\nvt .3 .4 9\nvt .5\n\
        vn 0 0 2\nvn 3 0 4\nusemtl blue\nf 1/1/1 2/2/2 3/3/1\nusemtl\nf 2 3 4\nusemtl red\nf 4//1 3//2 1//1";
    let paint = b"newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1";
    let model = parse("some/mesh.obj", text, |name| {
        assert_eq!(name, "paint.mtl");
        Ok(paint.to_vec())
    });
    let model = model.unwrap();
    assert_eq!(model.name, "mesh");
    assert_eq!(model.warnings, [""; 0]);
    let [first, second, third] = model.triangles[..] else { panic!("{model:?}") };

    let positions = |at: [u32; 3]| at.map(|at| model.positions[at as usize].to_array());
    assert_eq!(positions(first.positions), [[1., 2., 3.], [4., 0., 0.], [0., 5., 0.]]);
    assert_eq!(positions(third.positions), [[0., 0., 7.], [0., 5., 0.], [1., 2., 3.]]);
    let uvs = first.uvs.unwrap().map(|at| model.uvs[at as usize]);
    assert_eq!(uvs, [Vec2::new(0.1, 0.2), Vec2::new(0.3, 0.4), Vec2::new(0.5, 0.0)]);
    let normals = third.normals.unwrap().map(|at| model.normals[at as usize]);
    assert_eq!(normals, [Vec3::Z, Vec3::new(0.6, 0.0, 0.8), Vec3::Z]);
    assert_eq!((second.uvs, second.normals, third.uvs), (None, None, None));
    let names =
        [first, second, third].map(|t| t.material.map(|at| &*model.materials[at as usize].name));
    assert_eq!(names, [Some("blue"), None, Some("red")]);
}

#[test]
fn degenerate_faces_make_one_warning_and_leave_their_neighbours_alone() {
    let sound = "v 0 0 0\nv 2 0 0\nv 0 3 0\nv 1 0 0\n\nf 1 2 3\n";
    let alone = read(sound.as_bytes()).unwrap();
    let both = read(format!("{sound}f 1 1 2\nf 1 4 2\nf 3 3 3 3\n").as_bytes()).unwrap();
    assert_eq!(alone.triangles, both.triangles);
    assert_eq!(
        both.warnings,
        ["dir/mesh.obj:7: 3 faces have no area and are left out (this line is the first)"]
    );
}

#[test]
fn missing_materials_are_warnings_with_their_lines() {
    let text =
        b"v 0 0 0\nv 2 0 0\nv 0 3 0\nmtllib a.mtl b.mtl\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3";
    let model = parse("mesh.obj", text, |name| match name {
        "b.mtl" => Ok(b"newmtl blue".to_vec()),
        _ => Err("there is no such file".to_owned()),
    });
    let model = model.unwrap();
    assert_eq!(model.triangles[0].material, None);
    assert_eq!(model.triangles[1].material, Some(0));
    assert_eq!(model.warnings.len(), 2);
    assert!(model.warnings[0].starts_with("mesh.obj:4: the material file `a.mtl` is left out"));
    assert!(model.warnings[1].starts_with("mesh.obj:5: no material file defines `red`"));
}

#[test]
fn a_flood_of_warnings_is_bounded() {
    let mut text = "v 0 0 0\nv 2 0 0\nv 0 3 0\nf 1 2 3\n".to_owned();
    for k in 0..1_000 {
        text.push_str(&format!("mtllib {k}.mtl\nusemtl {k}\nsurf {k}\n"));
    }
    let warnings = read(text.as_bytes()).unwrap().warnings;
    assert!(warnings.len() < 30, "{warnings:?}");
    assert!(warnings.last().unwrap().ends_with("more warnings"));
}

#[test]
fn sizes_are_bounded() {
    let many = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf{}", " 1 2 3".repeat(400));
    assert!(read(many.as_bytes()).unwrap_err().to_string().contains("more than 1024 corners"));

    let names: String = (0..=10_000).map(|k| format!("newmtl {k}\nusemtl {k}\n")).collect();
    assert!(
        read(names.as_bytes()).unwrap_err().to_string().contains(":20002: there are more than")
    );
    let error = parse("m.obj", WITH_MATERIAL, |_| Ok(names.clone().into_bytes())).unwrap_err();
    assert!(error.to_string().starts_with("m.mtl:20001: there are more than 10000"), "{error}");

    let faces = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{}", "f 1 2 3\n".repeat(4_000_001));
    let error = read(faces.as_bytes()).unwrap_err();
    assert_eq!(
        (error.line, error.to_string().contains("more than 4000000")),
        (Some(4_000_004), true)
    );
}

/// All a caller may rely on, whatever the bytes were.
fn check(outcome: &Result<Model, ObjError>) {
    let Ok(model) = outcome else { return };
    let in_range = |at: [u32; 3], length: usize| at.iter().all(|&at| (at as usize) < length);
    assert!(!model.triangles.is_empty());
    for triangle in &model.triangles {
        assert!(in_range(triangle.positions, model.positions.len()));
        assert!(triangle.uvs.is_none_or(|at| in_range(at, model.uvs.len())));
        assert!(triangle.material.is_none_or(|at| (at as usize) < model.materials.len()));
        if let Some(normals) = triangle.normals {
            assert!(in_range(normals, model.normals.len()));
            assert!(normals.iter().all(|&at| model.normals[at as usize].is_normalized()));
        }
        let [a, b, c] = triangle.positions.map(|at| model.positions[at as usize].as_dvec3());
        assert_ne!((b - a).cross(c - a), glam::DVec3::ZERO);
    }
    assert!(model.positions.iter().chain(&model.normals).all(|vector| vector.is_finite()));
    assert!(model.uvs.iter().all(|uv| uv.is_finite()));
    for material in &model.materials {
        let colors = [material.ambient, material.diffuse, material.specular, material.emission];
        assert!(colors.iter().all(|color| color.is_finite() && color.min_element() >= 0.0));
        assert!(material.index_of_refraction >= 0.001 && material.shininess >= 0.0);
        assert!((0.0..=1.0).contains(&material.dissolve) && material.illumination <= 10);
    }
}

/// A list of words.
fn list<S>(words: &S, count: Range<usize>) -> impl Strategy<Value = Vec<String>> + use<S>
where
    S: Strategy<Value = String> + Clone,
{
    proptest::collection::vec(words.clone(), count)
}

/// Lines of OBJ and MTL, mostly sound, as a careless or a hostile hand would mix them.
fn line() -> impl Strategy<Value = String> {
    let number = prop_oneof![
        40 => (-9i32..9).prop_map(|whole| whole.to_string()),
        10 => (-3e38f32..3e38).prop_map(|value| format!("{value:e}")),
        5 => any::<u32>().prop_map(|bits| f32::from_bits(bits).to_string()),
        1 => prop_oneof!["nan", "1e400", "1e-45", "-0", "", "x", "\\\n", "#"],
    ];
    let index = |count: i32| {
        prop_oneof![
            40 => (1..=count).prop_map(|at| at.to_string()),
            20 => (1..=count).prop_map(|at| format!("-{at}")),
            1 => prop_oneof!["", "0", "9", "-9", "/", "99999999999999999999", "1.5"],
        ]
    };
    let corner = (index(5), index(1), index(2)).prop_flat_map(|(v, t, n)| {
        let forms = [format!("{v}/{t}"), format!("{v}//{n}"), format!("{v}/{t}/{n}"), v];
        (0..forms.len()).prop_map(move |form| forms[form].clone())
    });
    let colour = prop_oneof!["newmtl m\nKd", "usemtl m\n#", "mtllib m\n#", "newmtl m\nKe"];
    let join = |word: &'static str| move |rest: Vec<String>| format!("{word} {}", rest.join(" "));
    prop_oneof![
        6 => list(&number, 3..5).prop_map(join("v")),
        1 => list(&number, 2..8).prop_map(join("v")),
        1 => list(&number, 1..4).prop_map(join("vt")),
        1 => list(&number, 3..4).prop_map(join("vn")),
        1 => (colour, list(&number, 3..4)).prop_map(|(word, rest)| format!("{word} {}", rest.join(" "))),
        6 => list(&corner, 3..9).prop_map(join("f")),
    ]
}

fn cases(cases: u32) -> TestRunner {
    TestRunner::new(Config { cases, failure_persistence: None, ..Config::default() })
}

#[test]
fn no_bytes_make_it_panic() {
    let mut runner = cases(10_000);
    let bytes = proptest::collection::vec(any::<u8>(), 0..300);
    runner
        .run(&(bytes.clone(), bytes), |(obj, mtl)| {
            check(&parse("fuzz.obj", &obj, |_| Ok(mtl.clone())));
            check(&parse("fuzz.obj", WITH_MATERIAL, |_| Ok(mtl.clone())));
            Ok(())
        })
        .unwrap();
}

#[test]
fn no_mixture_of_lines_makes_it_panic() {
    let sound = "v 1 2 3\nv 4 0 0\nv 0 5 0\nv 0 0 7\nv 3 1 0\nvt 0 1\nvn 0 0 1\nvn 1 2 3\n";
    let lines = proptest::collection::vec(line(), 1..10);
    let mut runner = cases(5_000);
    let seen = AtomicUsize::new(0);
    runner
        .run(&lines, |lines| {
            let text = format!("{sound}{}", lines.join("\n"));
            let outcome = parse("fuzz.obj", text.as_bytes(), |_| Ok(text.clone().into_bytes()));
            check(&outcome);
            let outcome = parse("fuzz.obj", text.as_bytes(), |_| Err("none".to_owned()));
            check(&outcome);
            seen.fetch_add(usize::from(outcome.is_ok()), Ordering::Relaxed);
            Ok(())
        })
        .unwrap();
    assert!(seen.into_inner() > 500, "the mixtures are all refused, so little was tested");
}

#[test]
fn no_damage_to_a_sound_file_makes_it_panic() {
    let sound: &[u8] =
        b"mtllib m.mtl\nv 0 0 0\nv 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nvt 0 1\nvn 0 2 1\n\
        usemtl m\nf 1 2 3 4 5 6\nf -1/1/1 -2/-1/-1 1/1/1\nf 6//1 5//1 \\\n4//1 3//1\n";
    let damage = proptest::collection::vec((0..sound.len(), any::<u8>(), 0u8..3), 1..6);
    let mut runner = cases(50_000);
    runner
        .run(&damage, |damage| {
            let mut text = sound.to_vec();
            for (at, byte, how) in damage {
                let at = at.min(text.len() - 1);
                match how {
                    0 => text[at] = byte,
                    1 => text.insert(at, b"0123456789-./ \n\\e"[byte as usize % 17]),
                    _ => text.truncate(at + 1),
                }
            }
            check(&parse("fuzz.obj", &text, |_| Ok(b"newmtl m\nKd 1 0 0".to_vec())));
            Ok(())
        })
        .unwrap();
}

fn asset(name: &str) -> Vec<u8> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/");
    std::fs::read(format!("{folder}{name}")).unwrap()
}

/// The edges that no second triangle passes in the opposite direction, and those passed twice in one.
fn open_edges(model: &Model) -> usize {
    let mut passes = std::collections::HashMap::new();
    for triangle in &model.triangles {
        let [a, b, c] = triangle.positions;
        for edge in [(a, b), (b, c), (c, a)] {
            *passes.entry(edge).or_insert(0) += 1;
        }
    }
    passes.iter().filter(|&(&(a, b), &count)| count != 1 || passes.get(&(b, a)) != Some(&1)).count()
}

/// Six times the volume inside, positive where the triangles wind anticlockwise seen from outside.
fn sixfold_volume(model: &Model) -> f32 {
    let corner = |at: u32| model.positions[at as usize];
    let part = |[a, b, c]: [Vec3; 3]| a.dot(b.cross(c));
    model.triangles.iter().map(|triangle| part(triangle.positions.map(corner))).sum()
}

#[test]
fn the_bunny_is_whole() {
    let mut model = parse("bunny.obj", &asset("bunny.obj"), |_| Err("none".to_owned())).unwrap();
    assert_eq!((model.positions.len(), model.triangles.len()), (1_839, 3_674));
    assert_eq!(model.warnings, [""; 0]);
    assert!(model.triangles.iter().all(|triangle| triangle.normals.is_none()));
    assert_eq!(open_edges(&model), 0);
    assert!(sixfold_volume(&model) > 0.0, "inside out");

    let (low, high) = model
        .positions
        .iter()
        .fold((Vec3::MAX, Vec3::MIN), |(low, high), point| (low.min(*point), high.max(*point)));
    assert!(low.y.abs() < 0.01, "stands at {}", low.y);
    assert!((high.y - low.y - 9.66).abs() < 0.01, "is {} high", high.y - low.y);

    // The test of closedness must be able to fail.
    model.triangles.pop();
    assert_eq!(open_edges(&model), 3);
}

#[test]
fn the_example_scene_shows_what_it_promises() {
    let path = "assets/two-materials.obj";
    let model = parse(path, &asset("two-materials.obj"), |name| Ok(asset(name))).unwrap();
    assert_eq!(model.warnings, [""; 0]);
    let of = |name: &str| {
        let id = model.materials.iter().position(|material| material.name == name).unwrap();
        let wears = |triangle: &&super::Triangle| triangle.material == Some(id as u32);
        (&model.materials[id], model.triangles.iter().filter(wears).copied().collect::<Vec<_>>())
    };
    let ((plaster, matte), (sign, letter)) = (of("plaster"), of("sign"));
    assert_eq!((matte.len(), letter.len(), model.triangles.len()), (2 + 12, 4, 18));
    assert_eq!((plaster.illumination, sign.illumination), (1, 2));
    assert_eq!((sign.shininess, sign.index_of_refraction), (48.0, 1.5));
    assert_eq!(sign.emission, Vec3::new(2.4, 0.9, 0.3));

    // The box is closed, faces outward and holds 1 x 2 x 3; the letter's normals agree with its winding.
    let solid = Model { triangles: matte[2..].to_vec(), ..model.clone() };
    assert_eq!((open_edges(&solid), sixfold_volume(&solid)), (0, 36.0));
    for triangle in letter {
        let [a, b, c] = triangle.positions.map(|at| model.positions[at as usize]);
        assert!((b - a).cross(c - a).z > 0.0);
        assert_eq!(triangle.normals.map(|[at, ..]| model.normals[at as usize]), Some(Vec3::Z));
    }
}
