//! The check of an OBJ text, before the parser sees it.
//!
//! `tobj` says what is wrong with a file but not where, and takes NaN for a number. So each line is
//! checked here first, and what is sound goes on to `tobj` as plain `v`, `vt`, `vn` and `f` lines.

use std::collections::HashMap;

use super::error::{ObjError, Problem, shown};
use super::lines::{Statement, Statements};
use super::warnings::{Tally, Warnings};
use super::words::{Counts, Has, corner, enough, number};

/// The most triangles a mesh may have. It bounds the memory, at some hundred bytes a triangle.
pub(super) const MAX_TRIANGLES: usize = 4_000_000;

/// The most corners a face may have. It bounds the time, which for the worst polygons grows faster
/// than the square of their corners.
pub(super) const MAX_CORNERS: usize = 1_024;

/// The most materials a file, OBJ or MTL, may name.
pub(super) const MAX_MATERIALS: usize = 10_000;

/// The most material files a mesh may name; the rest are not looked for.
pub(super) const MAX_LIBRARIES: usize = 64;

/// A name and the line that first used it.
#[derive(Debug)]
pub(super) struct Named {
    pub(super) name: String,
    pub(super) line: u32,
}

/// What is known of a face beside its corners.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    pub(super) line: u32,
    pub(super) corners: u32,
    pub(super) has: Has,
    /// An index into [`Scan::materials`].
    pub(super) material: Option<u32>,
}

/// A checked OBJ text.
#[derive(Debug)]
pub(super) struct Scan {
    /// The text for the parser: one object, no comments, no names.
    pub(super) clean: Vec<u8>,
    /// The faces of `clean`, in order.
    pub(super) faces: Vec<Face>,
    /// The material files named.
    pub(super) libraries: Vec<Named>,
    /// The material names used.
    pub(super) materials: Vec<Named>,
}

/// Checks the OBJ text `bytes`; errors and warnings name `file`.
pub(super) fn scan(file: &str, bytes: &[u8], warnings: &mut Warnings) -> Result<Scan, ObjError> {
    if bytes.trim_ascii().is_empty() {
        return Err(Problem::Empty.of(file));
    }
    let mut scanner = Scanner::default();
    for statement in Statements::new(file, bytes) {
        let statement = statement?;
        scanner.take(&statement).map_err(|problem| problem.at(file, statement.line))?;
    }
    scanner.unknown.warn(file, "lines begin with a word unknown here and are left out", warnings);
    if scanner.faces.is_empty() {
        return Err(Problem::NoFaces.of(file));
    }
    Ok(Scan {
        clean: scanner.clean,
        faces: scanner.faces,
        libraries: scanner.libraries,
        materials: scanner.materials,
    })
}

#[derive(Default)]
struct Scanner {
    clean: Vec<u8>,
    counts: Counts,
    faces: Vec<Face>,
    triangles: usize,
    libraries: Vec<Named>,
    materials: Vec<Named>,
    material_ids: HashMap<String, u32>,
    material: Option<u32>,
    unknown: Tally,
}

impl Scanner {
    fn take(&mut self, statement: &Statement<'_>) -> Result<(), Problem> {
        let words: Vec<&str> = statement.words().collect();
        match statement.keyword() {
            "v" => self.position(&words)?,
            "vt" => self.uv(&words)?,
            "vn" => self.normal(&words)?,
            "f" | "fo" => self.face(statement.line, &words)?,
            "mtllib" => self.library(statement),
            "usemtl" => self.use_material(statement)?,
            // Names, smoothing and display hints change no triangle; points and lines are none.
            "o" | "g" | "s" | "mg" | "p" | "l" | "vp" | "usemap" | "maplib" | "lod" | "bevel"
            | "c_interp" | "d_interp" | "shadow_obj" | "trace_obj" => {}
            _ => self.unknown.add(statement.line),
        }
        Ok(())
    }

    /// `v x y z`, `v x y z w` (a weight that divides) or `v x y z r g b` (a colour, left out).
    fn position(&mut self, words: &[&str]) -> Result<(), Problem> {
        enough("v", words, 3)?;
        let numbers = numbers(words)?;
        let kept = if let [x, y, z, w] = numbers[..] {
            if w == 0.0 || ![x / w, y / w, z / w].iter().all(|value| value.is_finite()) {
                return Err(Problem::BadWeight(shown(words[3])));
            }
            4
        } else {
            3
        };
        self.emit("v", &words[..kept]);
        self.counts.positions += 1;
        Ok(())
    }

    /// `vt u`, `vt u v` or `vt u v w`; v is 0 where it is missing, w is left out.
    fn uv(&mut self, words: &[&str]) -> Result<(), Problem> {
        enough("vt", words, 1)?;
        numbers(words)?;
        self.emit("vt", &[words[0], words.get(1).unwrap_or(&"0")]);
        self.counts.uvs += 1;
        Ok(())
    }

    fn normal(&mut self, words: &[&str]) -> Result<(), Problem> {
        enough("vn", words, 3)?;
        numbers(words)?;
        self.emit("vn", &words[..3]);
        self.counts.normals += 1;
        Ok(())
    }

    fn face(&mut self, line: u32, words: &[&str]) -> Result<(), Problem> {
        if words.len() < 3 {
            return Err(Problem::TooFewCorners(words.len()));
        }
        if words.len() > MAX_CORNERS {
            return Err(Problem::TooManyCorners { limit: MAX_CORNERS });
        }
        self.triangles += words.len() - 2;
        if self.triangles > MAX_TRIANGLES {
            return Err(Problem::TooManyTriangles { limit: MAX_TRIANGLES });
        }

        // A face has texture coordinates or normals only where all its corners have them.
        let mut has = Has { uv: true, normal: true };
        for word in words {
            let corner = corner(word, self.counts)?;
            has = Has { uv: has.uv && corner.uv, normal: has.normal && corner.normal };
        }
        self.emit("f", words);
        let corners = words.len() as u32;
        self.faces.push(Face { line, corners, has, material: self.material });
        Ok(())
    }

    fn library(&mut self, statement: &Statement<'_>) {
        let name = statement.rest();
        let known = self.libraries.iter().any(|library| library.name == name);
        if !known && !name.is_empty() && self.libraries.len() < MAX_LIBRARIES {
            self.libraries.push(Named { name: name.to_owned(), line: statement.line });
        }
    }

    fn use_material(&mut self, statement: &Statement<'_>) -> Result<(), Problem> {
        let name = statement.rest();
        if name.is_empty() {
            self.material = None;
            return Ok(());
        }
        let next = self.materials.len() as u32;
        let id = *self.material_ids.entry(name.to_owned()).or_insert(next);
        if id == next && self.materials.len() == MAX_MATERIALS {
            return Err(Problem::TooManyMaterials { limit: MAX_MATERIALS });
        }
        if id == next {
            self.materials.push(Named { name: name.to_owned(), line: statement.line });
        }
        self.material = Some(id);
        Ok(())
    }

    /// Passes a checked statement on.
    fn emit(&mut self, keyword: &str, words: &[&str]) {
        self.clean.extend_from_slice(keyword.as_bytes());
        for word in words {
            self.clean.push(b' ');
            self.clean.extend_from_slice(word.as_bytes());
        }
        self.clean.push(b'\n');
    }
}

fn numbers(words: &[&str]) -> Result<Vec<f32>, Problem> {
    words.iter().map(|word| number(word)).collect()
}
