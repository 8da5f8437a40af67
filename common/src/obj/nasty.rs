//! Nasty mesh files, and what must come of each (HARD CASES TR-13 and TR-14, at the level of files).
//!
//! [`OBJ`] and [`MTL`] are the tables. [`Nasty::robust`] puts a file through [`parse`](super::parse)
//! and says whether the outcome is right; [`Nasty::naive`] does the same for `tobj` alone, the
//! negative control: it takes NaN for a coordinate and cuts a concave polygon as if it were convex.

use glam::Vec3;

use super::parse;

/// A nasty file and what must come of it.
#[derive(Clone, Copy, Debug)]
pub struct Nasty {
    /// What is nasty about it.
    pub what: &'static str,
    /// The text of the file.
    pub text: &'static [u8],
    /// What must come of it.
    pub expected: Expected,
}

/// What must come of a nasty file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Expected {
    /// It is read, into so many triangles of this total area. The triangles of a concave polygon
    /// that was cut wrongly have the right number and too large an area.
    Triangles {
        /// How many.
        count: usize,
        /// The sum of their areas.
        area: f32,
    },
    /// It is refused, with an error that names this line, if any.
    Refused(Option<u32>),
}

use Expected::{Refused, Triangles};

/// Three lines of positions, so that the nasty line of [`OBJ`] is mostly the fourth. The triangle
/// 1 2 3 has an area of 3.
macro_rules! after_positions {
    ($text:literal) => {
        concat!("v 0 0 0\nv 2 0 0\nv 0 3 0\n", $text).as_bytes()
    };
}

const fn nasty(what: &'static str, text: &'static [u8], expected: Expected) -> Nasty {
    Nasty { what, text, expected }
}

/// OBJ files.
pub const OBJ: &[Nasty] = &[
    // What must work.
    nasty("plain", after_positions!("f 1 2 3\n"), Triangles { count: 1, area: 3.0 }),
    nasty("no last newline", after_positions!("f 1 2 3"), Triangles { count: 1, area: 3.0 }),
    nasty("negative indices", after_positions!("f -3 -2 -1"), Triangles { count: 1, area: 3.0 }),
    nasty(
        "v//n",
        after_positions!("vn 0 0 1\nf 1//1 2//1 3//-1"),
        Triangles { count: 1, area: 3.0 },
    ),
    nasty(
        "some corners with uv",
        after_positions!("vt 0 1\nf 1/1 2 3"),
        Triangles { count: 1, area: 3.0 },
    ),
    nasty(
        "trailing blanks",
        after_positions!("f 1 2 3  \t \n \t\n"),
        Triangles { count: 1, area: 3.0 },
    ),
    nasty("trailing comment", after_positions!("f 1 2 3 # 4"), Triangles { count: 1, area: 3.0 }),
    nasty("continued line", after_positions!("f 1 \\\n2 3"), Triangles { count: 1, area: 3.0 }),
    nasty(
        "continued line, CRLF",
        after_positions!("f 1 2\\\r\n 3\r\n"),
        Triangles { count: 1, area: 3.0 },
    ),
    nasty(
        "CRLF",
        b"v 0 0 0\r\nv 2 0 0\r\nv 0 3 0\r\nf 1 2 3\r\n",
        Triangles { count: 1, area: 3.0 },
    ),
    nasty("CR", b"v 0 0 0\rv 2 0 0\rv 0 3 0\rf 1 2 3\r", Triangles { count: 1, area: 3.0 }),
    nasty(
        "byte order mark",
        b"\xef\xbb\xbfv 0 0 0\nv 2 0 0\nv 0 3 0\nf 1 2 3",
        Triangles { count: 1, area: 3.0 },
    ),
    nasty(
        "Latin-1 comment",
        b"# \xe9\nv 0 0 0\nv 2 0 0\nv 0 3 0\nf 1 2 3",
        Triangles { count: 1, area: 3.0 },
    ),
    nasty(
        "groups",
        after_positions!("o a\ng b c\ns 1\nf 1 2 3\ns off\ng\nf 1 3 2"),
        Triangles { count: 2, area: 6.0 },
    ),
    nasty(
        "some positions with colours",
        after_positions!("v 5 5 5 1 0 0\nf 1 2 3"),
        Triangles { count: 1, area: 3.0 },
    ),
    nasty("weight", b"v 0 0 0 2\nv 4 0 0 2\nv 0 6 0 2\nf 1 2 3", Triangles { count: 1, area: 3.0 }),
    nasty(
        "1e-400 is zero",
        b"v 0 0 1e-400\nv 2 0 0\nv 0 3 0\nf 1 2 3",
        Triangles { count: 1, area: 3.0 },
    ),
    nasty(
        "missing MTL",
        after_positions!("mtllib no.mtl\nusemtl m\nf 1 2 3"),
        Triangles { count: 1, area: 3.0 },
    ),
    nasty("convex quad", after_positions!("v 2 3 0\nf 1 2 4 3"), Triangles { count: 2, area: 6.0 }),
    nasty(
        "dart",
        b"v 0 3 0\nv 1 0 0\nv 0 -3 0\nv 4 0 0\nf 1 2 3 4",
        Triangles { count: 2, area: 9.0 },
    ),
    nasty(
        "L, begun outside its kernel",
        b"v 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nf 1 2 3 4 5 6",
        Triangles { count: 4, area: 4.0 },
    ),
    nasty(
        "repeated index beside a sound face",
        after_positions!("f 1 1 2\nf 1 2 3"),
        Triangles { count: 1, area: 3.0 },
    ),
    nasty(
        "three corners on a line beside a sound face",
        after_positions!("v 1 0 0\nf 1 4 2\nf 1 2 3"),
        Triangles { count: 1, area: 3.0 },
    ),
    nasty(
        "quad with a repeated corner",
        after_positions!("f 1 2 3 3"),
        Triangles { count: 1, area: 3.0 },
    ),
    nasty(
        "opposite normals",
        after_positions!("vn 0 0 1\nvn 0 0 -1\nf 1//1 2//2 3//1"),
        Triangles { count: 1, area: 3.0 },
    ),
    nasty(
        "normal of length zero",
        after_positions!("vn 0 0 0\nf 1//1 2//1 3//1"),
        Triangles { count: 1, area: 3.0 },
    ),
    // What must be refused.
    nasty("empty", b"", Refused(None)),
    nasty("blank", b" \r\n\t\n", Refused(None)),
    nasty("positions only", after_positions!(""), Refused(None)),
    nasty("prose", b"It was a dark and stormy night.\n", Refused(None)),
    nasty("binary", b"v 0 0 0\nglTF\x02\x00\x00\x00", Refused(Some(2))),
    nasty("not UTF-8", b"v 0 0 0\nv \xff 0 0\n", Refused(Some(2))),
    nasty("NaN", after_positions!("v 0 nan 1\nf 1 2 4"), Refused(Some(4))),
    nasty("infinity", after_positions!("v 0 -inf 1\nf 1 2 4"), Refused(Some(4))),
    nasty("1e400", after_positions!("v 0 1e400 1\nf 1 2 4"), Refused(Some(4))),
    nasty(
        "NaN in a position no face uses",
        after_positions!("v 0 nan 1\nf 1 2 3"),
        Refused(Some(4)),
    ),
    nasty("NaN normal", after_positions!("vn 0 nan 1\nf 1//1 2//1 3//1"), Refused(Some(4))),
    nasty("infinite uv", after_positions!("vt 0 inf\nf 1/1 2/1 3/1"), Refused(Some(4))),
    nasty("weight zero", after_positions!("v 1 2 3 0\nf 1 2 3"), Refused(Some(4))),
    nasty("weight that overflows", after_positions!("v 1 2 3 1e-40\nf 1 2 4"), Refused(Some(4))),
    nasty("not a number", after_positions!("v 1 two 3\nf 1 2 3"), Refused(Some(4))),
    nasty("decimal comma", after_positions!("v 1,5 2,5 3,5\nf 1 2 3"), Refused(Some(4))),
    nasty("truncated position", after_positions!("f 1 2 3\nv 1 2"), Refused(Some(5))),
    nasty("truncated normal", after_positions!("vn 1\nf 1 2 3"), Refused(Some(4))),
    nasty("truncated face", after_positions!("f 1 2 3\nf 1 2"), Refused(Some(5))),
    nasty("face without corners", after_positions!("f\nf 1 2 3"), Refused(Some(4))),
    nasty("index 0", after_positions!("f 0 1 2"), Refused(Some(4))),
    nasty("index beyond the count", after_positions!("f 1 2 4"), Refused(Some(4))),
    nasty("index beyond the count, from the end", after_positions!("f -4 -2 -1"), Refused(Some(4))),
    nasty("index of 20 digits", after_positions!("f 1 2 99999999999999999999"), Refused(Some(4))),
    nasty("uv index beyond the count", after_positions!("f 1/1 2/1 3/1"), Refused(Some(4))),
    nasty("normal index 0", after_positions!("vn 0 0 1\nf 1//0 2//1 3//1"), Refused(Some(5))),
    nasty("corner of four parts", after_positions!("f 1/1/1/1 2 3"), Refused(Some(4))),
    nasty("corner without a position", after_positions!("vt 0 0\nf /1 2 3"), Refused(Some(5))),
    nasty("index that is no whole number", after_positions!("f 1.0 2.0 3.0"), Refused(Some(4))),
    nasty("error on a continued line", after_positions!("\n\nf 1 \\\n2 \\\n9"), Refused(Some(6))),
    nasty(
        "nothing but degenerate faces",
        after_positions!("v 1 0 0\n# -\nf 1 4 2\nf 1 1 3"),
        Refused(Some(6)),
    ),
];

/// MTL files, for the mesh [`WITH_MATERIAL`].
pub const MTL: &[Nasty] = &[
    nasty("plain", b"newmtl m\nKd 0.1 0.2 0.3\n", Triangles { count: 1, area: 3.0 }),
    nasty("empty", b"", Triangles { count: 1, area: 3.0 }),
    nasty(
        "unknown statements",
        b"newmtl m\nPcr 0\nsharpness x\n",
        Triangles { count: 1, area: 3.0 },
    ),
    nasty("NaN", b"newmtl m\nKd 0.1 nan 0.3\n", Refused(Some(2))),
    nasty("infinity", b"newmtl m\n\nNs inf\n", Refused(Some(3))),
    nasty("1e400", b"newmtl m\nKe 0 1e400 0\n", Refused(Some(2))),
    nasty("negative colour", b"newmtl m\nKs 0.1 0.2 -0.3\n", Refused(Some(2))),
    nasty("negative exponent", b"newmtl m\nNs -1\n", Refused(Some(2))),
    nasty("refraction 0", b"newmtl m\nNi 0\n", Refused(Some(2))),
    nasty("roughness above 1", b"newmtl m\nPr 1.5\n", Refused(Some(2))),
    nasty("dissolve above 1", b"newmtl m\nd 255\n", Refused(Some(2))),
    nasty("fractional model", b"newmtl m\nillum 2.5\n", Refused(Some(2))),
    nasty("model out of range", b"newmtl m\nillum 11\n", Refused(Some(2))),
    nasty("not a number", b"newmtl m\nKd red green blue\n", Refused(Some(2))),
    nasty("two numbers of three", b"newmtl m\nKd 0.1 0.2\n", Refused(Some(2))),
    nasty("no number", b"newmtl m\nNi\n", Refused(Some(2))),
    nasty("no name", b"# paint\nnewmtl\n", Refused(Some(2))),
    nasty("statement before the name", b"Kd 0.1 0.2 0.3\nnewmtl m\n", Refused(Some(1))),
    nasty("binary", b"newmtl m\n\x00\x01\x02", Refused(Some(2))),
];

/// A mesh of one triangle with the material `m` of `m.mtl`.
pub const WITH_MATERIAL: &[u8] = after_positions!("mtllib m.mtl\nusemtl m\nf 1 2 3\n");

impl Nasty {
    /// Whether [`parse`](super::parse) does what it must with this OBJ file.
    pub fn robust(&self) -> bool {
        self.holds("nasty.obj", parse("nasty.obj", self.text, |_| Err("not here".to_owned())))
    }

    /// Whether [`parse`](super::parse) does what it must with this MTL file.
    pub fn robust_material(&self) -> bool {
        self.holds("m.mtl", parse("m.obj", WITH_MATERIAL, |_| Ok(self.text.to_vec())))
    }

    /// Whether `tobj` alone does what it must with this OBJ file, not counting the line that it
    /// cannot name.
    pub fn naive(&self) -> bool {
        let missing = |_: &std::path::Path| Err(tobj::LoadError::OpenFileFailed);
        let loaded = tobj::load_obj_buf(&mut &*self.text, &tobj::GPU_LOAD_OPTIONS, missing);
        match (self.expected, loaded) {
            (Refused(_), loaded) => loaded.is_err(),
            (Triangles { .. }, Err(_)) => false,
            (Triangles { count, area }, Ok((models, _))) => {
                let triangles: Vec<[Vec3; 3]> = models.iter().flat_map(naive_triangles).collect();
                triangles.len() == count && total_area(&triangles) == area
            }
        }
    }

    fn holds(&self, file: &str, parsed: Result<super::Model, super::ObjError>) -> bool {
        match (self.expected, parsed) {
            (Refused(line), Err(error)) => error.line == line && error.file == file,
            (Triangles { count, area }, Ok(model)) => {
                let corner = |at: u32| model.positions[at as usize];
                let triangles: Vec<[Vec3; 3]> =
                    model.triangles.iter().map(|triangle| triangle.positions.map(corner)).collect();
                triangles.len() == count && total_area(&triangles) == area
            }
            _ => false,
        }
    }
}

fn naive_triangles(model: &tobj::Model) -> impl Iterator<Item = [Vec3; 3]> {
    let positions = model.mesh.positions.as_chunks::<3>().0;
    let corner = |at: u32| Vec3::from(positions[at as usize]);
    model.mesh.indices.as_chunks::<3>().0.iter().map(move |triangle| triangle.map(corner))
}

fn total_area(triangles: &[[Vec3; 3]]) -> f32 {
    triangles.iter().map(|[a, b, c]| (b - a).cross(c - a).length() / 2.0).sum()
}
