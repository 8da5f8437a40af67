//! The material files that a mesh names.

use std::collections::HashMap;
use std::path::Path;

use super::error::{ObjError, shown};
use super::material::{Material, materials as materials_of};
use super::scan::{MAX_LIBRARIES, Named, Scan};
use super::warnings::Warnings;

/// Reads the MTL files the text names. One that cannot be had is a warning.
pub(super) fn load_materials(
    name: &str,
    scan: &Scan,
    mut material_file: impl FnMut(&str) -> Result<Vec<u8>, String>,
    warnings: &mut Warnings,
) -> Result<Vec<Material>, ObjError> {
    let mut materials = Vec::new();
    for library in &scan.libraries {
        // One name with blanks in it, or else several names: the format allows both.
        let whole =
            material_file(&library.name).map(|bytes| vec![(library.name.as_str(), Ok(bytes))]);
        let files = whole.unwrap_or_else(|reason| {
            let words: Vec<&str> = library.name.split_whitespace().take(MAX_LIBRARIES).collect();
            match words[..] {
                [] | [_] => vec![(&library.name, Err(reason))],
                _ => words.into_iter().map(|word| (word, material_file(word))).collect(),
            }
        });

        for (file, bytes) in files {
            match bytes {
                Ok(bytes) => {
                    let file = Path::new(name).with_file_name("").join(file);
                    let file = file.display().to_string();
                    materials.extend(materials_of(&file, &bytes, warnings)?);
                }
                Err(reason) => {
                    let shown = shown(file);
                    let text = format!("the material file `{shown}` is left out: {reason}");
                    warnings.add(name, library.line, &text);
                }
            }
        }
    }
    Ok(materials)
}

/// Where each material name the text uses is in `materials`. One that is nowhere is a warning.
pub(super) fn find_materials(
    name: &str,
    scan: &Scan,
    materials: &[Material],
    warnings: &mut Warnings,
) -> Vec<Option<u32>> {
    let known: HashMap<&str, u32> =
        materials.iter().map(|material| material.name.as_str()).zip(0..).collect();
    let find = |used: &Named| {
        let found = known.get(used.name.as_str()).copied();
        if found.is_none() {
            let shown = shown(&used.name);
            let text = format!("no material file defines `{shown}`; its faces get none");
            warnings.add(name, used.line, &text);
        }
        found
    };
    scan.materials.iter().map(find).collect()
}
