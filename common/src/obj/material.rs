//! MTL materials: the record as plain numbers, and the check of the text.

use super::error::{ObjError, Problem, shown};
use super::lines::{Statement, Statements};
use super::scan::MAX_MATERIALS;
use super::warnings::{Tally, Warnings};
use super::words::{enough, number};
use crate::film::Color;

/// A material as its MTL file describes it. Colours are linear RGB. A statement the file leaves out
/// asks for no effect, so its default is the value that has none.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The name after `newmtl`.
    pub name: String,
    /// `Ka`: what it reflects of ambient light. Default black.
    pub ambient: Color,
    /// `Kd`: what it reflects diffusely. Default 0.8, as in Wavefront's description of the format.
    pub diffuse: Color,
    /// `Ks`: what it reflects as a mirror does, sharply or in a highlight. Default black.
    pub specular: Color,
    /// `Ke`: radiance it emits. Default black; each component 0 or more.
    pub emission: Color,
    /// `Ns`: the exponent of the highlight, 0 or more. Default 0.
    pub shininess: f32,
    /// `Ni`: index of refraction, at least 0.001. Default 1, as of air.
    pub index_of_refraction: f32,
    /// `Pr`: microfacet roughness from 0 to 1, of the physically based extension of MTL.
    pub roughness: Option<f32>,
    /// `illum`: the illumination model, 0 to 10: 1 diffuse, 2 with highlights, 3 with reflection, 4
    /// to 7 with refraction or Fresnel reflection. Default 2 where `Ks` is not black, else 1.
    pub illumination: u8,
    /// `d`, or one less `Tr`: 1 is solid, 0 is not there. Default 1.
    pub dissolve: f32,
}

/// The materials of the MTL text `bytes`, in its order; errors and warnings name `file`.
pub(super) fn materials(
    file: &str,
    bytes: &[u8],
    warnings: &mut Warnings,
) -> Result<Vec<Material>, ObjError> {
    let mut clean = Vec::new();
    let mut maps = Tally::default();
    let mut named = 0;
    for statement in Statements::new(file, bytes) {
        let statement = statement?;
        if is_map(statement.keyword()) {
            maps.add(statement.line);
        }
        check(&statement, &mut named, &mut clean)
            .map_err(|problem| problem.at(file, statement.line))?;
    }
    maps.warn(file, "texture statements are left out; plain colours are used", warnings);
    let (records, _) = tobj::load_mtl_buf(&mut clean.as_slice())
        .map_err(|error| Problem::Parser(error.to_string()).of(file))?;
    Ok(records.into_iter().map(Material::from).collect())
}

fn is_map(keyword: &str) -> bool {
    keyword.starts_with("map_") || ["bump", "disp", "decal", "refl", "norm"].contains(&keyword)
}

/// Checks a statement and passes it on to `clean` if it is one we use.
fn check(statement: &Statement<'_>, named: &mut usize, clean: &mut Vec<u8>) -> Result<(), Problem> {
    let keyword = statement.keyword();
    if keyword == "newmtl" {
        if statement.rest().is_empty() {
            return Err(Problem::NoMaterialName);
        }
        *named += 1;
        if *named > MAX_MATERIALS {
            return Err(Problem::TooManyMaterials { limit: MAX_MATERIALS });
        }
        clean.extend_from_slice(format!("newmtl {}\n", statement.rest()).as_bytes());
        return Ok(());
    }
    let Some(takes) = takes(keyword) else { return Ok(()) };
    if *named == 0 {
        return Err(Problem::BeforeMaterial(shown(keyword)));
    }

    let words: Vec<&str> = statement.words().collect();
    enough(keyword, &words, takes.numbers)?;
    let words = &words[..takes.numbers];
    for word in words {
        let value = number(word)?;
        let whole = !takes.whole || word.parse::<u8>().is_ok();
        if value < takes.low || value > takes.high || !whole {
            return Err(Problem::OutsideRange {
                keyword: shown(keyword),
                word: shown(word),
                range: takes.range,
            });
        }
    }
    clean.extend_from_slice(format!("{keyword} {}\n", words.join(" ")).as_bytes());
    Ok(())
}

/// What a statement takes: how many numbers, and from where to where.
struct Takes {
    numbers: usize,
    low: f32,
    high: f32,
    whole: bool,
    range: &'static str,
}

fn takes(keyword: &str) -> Option<Takes> {
    let numbers = |numbers, low, high, range| Takes { numbers, low, high, whole: false, range };
    Some(match keyword {
        "Ka" | "Kd" | "Ks" | "Ke" => numbers(3, 0.0, f32::MAX, "three numbers, none negative"),
        "Ns" => numbers(1, 0.0, f32::MAX, "a number that is not negative"),
        "Ni" => numbers(1, 0.001, f32::MAX, "a number of at least 0.001"),
        "d" | "Tr" | "Pr" => numbers(1, 0.0, 1.0, "a number from 0 to 1"),
        "illum" => Takes { whole: true, ..numbers(1, 0.0, 10.0, "a whole number from 0 to 10") },
        _ => return None,
    })
}

impl From<tobj::Material> for Material {
    fn from(record: tobj::Material) -> Self {
        // `Pr` and `Tr` are not among the parser's own; it hands them on as checked text.
        let extra = |keyword| record.unknown_param.get(keyword)?.parse::<f32>().ok();
        let color = |found: Option<[f32; 3]>| Color::from(found.unwrap_or_default());
        let specular = color(record.specular);
        let default_illumination = if specular == Color::ZERO { 1 } else { 2 };
        Self {
            ambient: color(record.ambient),
            diffuse: record.diffuse.map_or(Color::splat(0.8), Color::from),
            specular,
            emission: color(record.emissive),
            shininess: record.shininess.unwrap_or(0.0),
            index_of_refraction: record.optical_density.unwrap_or(1.0),
            roughness: extra("Pr"),
            illumination: record.illumination_model.unwrap_or(default_illumination),
            dissolve: record.dissolve.or(extra("Tr").map(|clear| 1.0 - clear)).unwrap_or(1.0),
            name: record.name,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Vec<Material>, ObjError> {
        materials("paint.mtl", text.as_bytes(), &mut Warnings::default())
    }

    #[test]
    fn every_statement_reaches_its_field() {
        let text = "# a comment\nnewmtl old glass #2\nKa 0.1 0.2 0.3\r\n\tKd .4 .5 .6 # grey\n\
            Ks 0.7 0.8 0.9\nKe 3 5 7\nNs 96.5\nNi 1.52\nPr 0.25\nillum 7\nTr 0.125\nmap_Kd a.png\n";
        let expected = Material {
            name: "old glass #2".to_owned(),
            ambient: Color::new(0.1, 0.2, 0.3),
            diffuse: Color::new(0.4, 0.5, 0.6),
            specular: Color::new(0.7, 0.8, 0.9),
            emission: Color::new(3.0, 5.0, 7.0),
            shininess: 96.5,
            index_of_refraction: 1.52,
            roughness: Some(0.25),
            illumination: 7,
            dissolve: 0.875,
        };
        assert_eq!(read(text), Ok(vec![expected]));
    }

    #[test]
    fn what_is_left_out_asks_for_nothing() {
        let found = read("newmtl plain\nnewmtl shiny\nKs 0.3 0 0\nd 0.5\nTr 0.9").unwrap();
        let plain = Material {
            name: "plain".to_owned(),
            ambient: Color::ZERO,
            diffuse: Color::splat(0.8),
            specular: Color::ZERO,
            emission: Color::ZERO,
            shininess: 0.0,
            index_of_refraction: 1.0,
            roughness: None,
            illumination: 1,
            dissolve: 1.0,
        };
        assert_eq!(found[0], plain);
        assert_eq!((found[1].illumination, found[1].dissolve), (2, 0.5));
    }

    #[test]
    fn textures_are_named_in_a_warning() {
        let mut warnings = Warnings::default();
        materials("a.mtl", b"newmtl m\nKd 1 1 1\nmap_Kd x.png\nbump y.png", &mut warnings).unwrap();
        let texts = warnings.into_texts("a.obj");
        assert_eq!(texts.len(), 1);
        assert!(texts[0].starts_with("a.mtl:3: 2 texture"), "{texts:?}");
    }
}
