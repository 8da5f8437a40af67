//! Matte, mirror and glass from MTL records.

use common::film::Color;
use common::obj::Material;
use fresnel::index::{Index, NoIndex};

use crate::bsdf::{MaterialError, check_reflectance};
use crate::glass::Glass;
use crate::lambert::Lambert;
use crate::mirror::Mirror;
use crate::part::Emission;
use crate::smooth::Smooth;

/// A record that is no material.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("material {material}: {statement}: {why}")]
pub struct BadMaterial {
    /// Its name.
    pub material: String,
    /// The statement that is wrong.
    pub statement: &'static str,
    /// What is wrong with it.
    pub why: Why,
}

/// What is wrong with a statement.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Why {
    /// Its reflectance or its light.
    #[error(transparent)]
    Material(#[from] MaterialError),
    /// Its index of refraction.
    #[error(transparent)]
    Index(#[from] NoIndex),
}

// ANCHOR: surface
/// What a record's surface is made of.
///
/// Illumination model 5 is a mirror that reflects `Ks`. Models 4, 6, 7 and 9, and whatever has a `d`
/// below 1, are glass of the index `Ni`. All else is matte and reflects `Kd`.
///
/// # Errors
/// A surface that would reflect more light than it gets, and an index that no light can have.
pub fn surface(record: &Material) -> Result<Smooth, BadMaterial> {
    let bad = |statement, why| BadMaterial { material: record.name.clone(), statement, why };
    let checked = |statement, reflectance: Color| {
        check_reflectance(reflectance).map_err(|error| bad(statement, error.into()))?;
        Ok(reflectance)
    };
    if is_glass(record) {
        let index = Index::new(record.index_of_refraction).map_err(|error| bad("Ni", error.into()));
        return Ok(Smooth::Glass(Glass { index: index? }));
    }
    Ok(if record.illumination == 5 {
        Smooth::Mirror(Mirror { reflectance: checked("Ks", record.specular)? })
    } else {
        Smooth::Lambert(Lambert { reflectance: checked("Kd", record.diffuse)? })
    })
}
// ANCHOR_END: surface

fn is_glass(record: &Material) -> bool {
    record.dissolve < 1.0 || matches!(record.illumination, 4 | 6 | 7 | 9)
}

/// The light it sends out: `Ke`, on both sides, since a file's faces may be turned either way.
///
/// # Errors
/// Light that is no amount of light.
pub fn emission(record: &Material) -> Result<Emission, BadMaterial> {
    let emission = Emission { radiance: record.emission, both_sides: true };
    emission.check().map_err(|error| BadMaterial {
        material: record.name.clone(),
        statement: "Ke",
        why: error.into(),
    })?;
    Ok(emission)
}

/// What to tell the user of a record that asks for more than this chapter's materials have.
pub fn warning(record: &Material) -> Option<String> {
    let left_out = record.illumination != 5 && !is_glass(record) && record.specular != Color::ZERO;
    left_out.then(|| {
        let name = &record.name;
        format!("material {name}: the surface is matte here: its Ks is left out")
    })
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::obj::{Material, parse};
    use fresnel::index::Index;

    use super::{emission, surface, warning};
    use crate::glass::Glass;
    use crate::mirror::Mirror;
    use crate::smooth::Smooth;

    fn record(mtl: &str) -> Material {
        let obj = b"mtllib a.mtl\nusemtl m\nv 0 0 0\nv 2 0 0\nv 0 3 0\nf 1 2 3\n";
        let mtl = format!("newmtl m\n{mtl}");
        let model = parse("a.obj", obj, |_| Ok(mtl.as_bytes().to_vec())).expect("it is sound");
        model.materials[0].clone()
    }

    #[test]
    fn the_illumination_model_chooses() {
        let text = "Kd 0.1 0.2 0.3\nKs 0.25 0.5 0.75\nNi 1.33\n";
        for illum in 0..=10 {
            let record = record(&format!("{text}illum {illum}\n"));
            let expected = match illum {
                5 => Smooth::Mirror(Mirror { reflectance: Color::new(0.25, 0.5, 0.75) }),
                4 | 6 | 7 | 9 => Smooth::Glass(Glass { index: Index::WATER }),
                _ => Smooth::matte(0.1, 0.2, 0.3),
            };
            assert_eq!(surface(&record), Ok(expected), "{illum}");
            assert_eq!(warning(&record).is_some(), !matches!(illum, 4..=7 | 9), "{illum}");
        }
        assert!(matches!(surface(&record("d 0.5\n")), Ok(Smooth::Glass(_))));
        let light = emission(&record("Ke 1 2 3\n")).expect("an amount");
        assert!(light.radiance == Color::new(1.0, 2.0, 3.0) && light.both_sides);
    }

    #[test]
    fn what_would_make_light_is_refused() {
        let told = |mtl: &str| surface(&record(mtl)).expect_err("too much").to_string();
        assert!(told("Kd 0.5 1.5 0.5\n").starts_with("material m: Kd: the reflectance"));
        assert!(told("Ks 2 0 0\nillum 5\n").starts_with("material m: Ks: the reflectance"));
        assert!(told("Ni 1e30\nillum 7\n").starts_with("material m: Ni: an index"));
        assert!(surface(&record("Ks 2 0 0\nillum 2\n")).is_ok(), "a highlight is not read");
        let bright = Material { emission: Color::new(1.0, f32::INFINITY, 0.0), ..record("") };
        let told = emission(&bright).expect_err("infinite").to_string();
        assert!(told.starts_with("material m: Ke: the radiance"), "{told}");
    }
}
