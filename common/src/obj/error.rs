//! What can be wrong with a mesh file, said so that it can be mended.

use std::fmt;

/// Why an OBJ or MTL file was refused: the file, the line where there is one, the reason, and what
/// to do.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub struct ObjError {
    /// The file at fault, as the caller named it.
    pub file: String,
    /// The line at fault, counted from 1. `None` where the file as a whole is at fault. A statement
    /// continued with `\` is at its first line.
    pub line: Option<u32>,
    /// What is wrong.
    pub problem: Problem,
}

impl fmt::Display for ObjError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            Some(line) => write!(out, "{}:{line}: {}", self.file, self.problem),
            None => write!(out, "{}: {}", self.file, self.problem),
        }
    }
}

/// What is wrong with a file or a line of it. The message of each ends with what to do.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Problem {
    /// The path names nothing.
    #[error("there is no such file. Check the path")]
    Missing,
    /// The path names a folder.
    #[error("this is a folder, not a file. Name the .obj file inside it")]
    Directory,
    /// The system refused to read the file.
    #[error("the file cannot be read ({0}). Check its permissions")]
    Unreadable(String),
    /// The file is longer than the reader takes.
    #[error("the file is larger than {} MiB, the most this reader takes. Reduce the mesh", .limit >> 20)]
    TooLarge {
        /// The most bytes a file may have.
        limit: u64,
    },
    /// More triangles than the reader takes.
    #[error(
        "the mesh has more than {limit} triangles, the most this reader takes. Reduce the mesh"
    )]
    TooManyTriangles {
        /// The most triangles a mesh may have.
        limit: usize,
    },
    /// More material names than the reader takes.
    #[error("there are more than {limit} materials, the most this reader takes. Merge some")]
    TooManyMaterials {
        /// The most materials a file may name.
        limit: usize,
    },
    /// The file has no bytes but blanks.
    #[error("the file is empty. Export the mesh again")]
    Empty,
    /// No face statement in the whole file.
    #[error("the file has no faces. Is it an OBJ file? Faces are lines like `f 1 2 3`")]
    NoFaces,
    /// Faces, and none of them with an area.
    #[error("no face has an area, here or below. Check the positions and the faces' indices")]
    NoArea,
    /// Bytes that are not text.
    #[error("this is not text (UTF-8). Is it a binary file? Export the mesh as OBJ text")]
    NotText,
    /// A line with fewer numbers than its statement needs.
    #[error(
        "`{keyword}` needs {needed} numbers and has {found}. The line may be cut short: complete it"
    )]
    TooFewNumbers {
        /// The first word of the line.
        keyword: String,
        /// How many numbers belong there.
        needed: usize,
        /// How many there are.
        found: usize,
    },
    /// A word where a number belongs.
    #[error("`{0}` is not a number. Write one like 0.25 or -1e3")]
    NotNumber(String),
    /// NaN, an infinity, or a number too large for single precision.
    #[error("`{0}` is not a finite number of single precision. Replace it, or delete what uses it")]
    NotFinite(String),
    /// `v x y z w` with a w that cannot divide.
    #[error("the weight `{0}` (fourth number) leaves no finite position. Remove it, or write 1")]
    BadWeight(String),
    /// A face with one or two corners.
    #[error("the face has {0} corners and needs at least 3. Complete the line, or delete it")]
    TooFewCorners(usize),
    /// A face with more corners than the triangulator is given.
    #[error("the face has more than {limit} corners. Triangulate it in the program that made it")]
    TooManyCorners {
        /// The most corners a face may have.
        limit: usize,
    },
    /// A corner that is not `v`, `v/vt`, `v//vn` or `v/vt/vn` in whole numbers.
    #[error("`{0}` is not a corner. Write v, v/vt, v//vn or v/vt/vn, in whole numbers")]
    BadCorner(String),
    /// Index zero.
    #[error("`{0}` has the index 0, but OBJ counts from 1. Add one to each index of the file")]
    ZeroIndex(String),
    /// An index that reaches past what the file has defined so far.
    #[error(
        "{kind} {index} does not exist: {count} are defined above this line. Correct the index"
    )]
    OutOfRange {
        /// What is counted: `position`, `texture coordinate` or `normal`.
        kind: &'static str,
        /// The index as written.
        index: i64,
        /// How many there are.
        count: u32,
    },
    /// An MTL number outside the range of its statement.
    #[error("`{word}` is outside what `{keyword}` takes: {range}. Correct the number")]
    OutsideRange {
        /// The first word of the line.
        keyword: String,
        /// The number as written.
        word: String,
        /// The range in words.
        range: &'static str,
    },
    /// An MTL statement with no `newmtl` above it.
    #[error("`{0}` comes before any `newmtl`. Name the material first")]
    BeforeMaterial(String),
    /// `newmtl` alone.
    #[error("`newmtl` has no name. Write one after it")]
    NoMaterialName,
    /// The text passed our checks, yet the parser refused it.
    #[error("the parser gave up ({0}). Export the mesh again, and tell us of the file")]
    Parser(String),
}

impl Problem {
    /// The error of this problem at `line` of `file`.
    pub(super) fn at(self, file: &str, line: u32) -> ObjError {
        ObjError { file: file.to_owned(), line: Some(line), problem: self }
    }

    /// The error of this problem in `file` as a whole.
    pub(super) fn of(self, file: &str) -> ObjError {
        ObjError { file: file.to_owned(), line: None, problem: self }
    }
}

/// A word as a message shows it: never longer than a few dozen letters, no control characters.
pub(super) fn shown(word: &str) -> String {
    const LONGEST: usize = 40;
    let visible = |c: char| if c.is_control() { '?' } else { c };
    let mut text: String = word.chars().take(LONGEST).map(visible).collect();
    if word.chars().nth(LONGEST).is_some() {
        text.push_str("...");
    }
    text
}
