//! Glass and polish from MTL records.

use blinn_phong::material::BlinnPhong;
use common::film::Color;
use common::obj::Material;
use whitted::material::Mirrored;
use whitted::mtl::mirror;

use crate::glass::{Glass, Surface};
use crate::index::{Index, NoIndex};

/// A material whose index of refraction is none.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("material {material}: Ni: {why}")]
pub struct BadIndex {
    /// The material's name.
    pub material: String,
    /// What is wrong.
    pub why: NoIndex,
}

// ANCHOR: surface
/// What an object of this record is made of, `material` being what chapter 4 makes of it.
///
/// Illumination models 4, 6, 7 and 9 are glass with the index `Ni`, and so is whatever has a `d`
/// below 1: it all goes through, or is reflected as Fresnel says. Model 5 is polished: what it
/// mirrors grows with the angle.
///
/// # Errors
/// An `Ni` that no light can have.
pub fn surface(record: &Material, material: BlinnPhong) -> Result<Surface, BadIndex> {
    let mirrored = Mirrored { surface: material, mirror: mirror(record) };
    let clear = record.dissolve < 1.0 || matches!(record.illumination, 4 | 6 | 7 | 9);
    if clear {
        let index = Index::new(record.index_of_refraction)
            .map_err(|why| BadIndex { material: record.name.clone(), why })?;
        return Ok(Surface::Glass(Glass::new(index)));
    }
    let polished = record.illumination == 5 && mirrored.mirror != Color::ZERO;
    Ok(if polished { Surface::Polished(mirrored) } else { Surface::Opaque(mirrored) })
}
// ANCHOR_END: surface

#[cfg(test)]
mod tests {
    use blinn_phong::mtl::UNNAMED;
    use common::film::Color;
    use common::obj::{Material, parse};

    use super::surface;
    use crate::glass::{Glass, Surface};
    use crate::index::Index;

    fn record(mtl: &str) -> Material {
        let obj = b"mtllib a.mtl\nusemtl m\nv 0 0 0\nv 2 0 0\nv 0 3 0\nf 1 2 3\n";
        let mtl = format!("newmtl m\n{mtl}");
        let model = parse("a.obj", obj, |_| Ok(mtl.as_bytes().to_vec())).expect("it is sound");
        model.materials[0].clone()
    }

    #[test]
    fn the_illumination_model_chooses() {
        let of = |illum: u8| {
            let record = record(&format!("Ks 0.25 0.5 0.75\nNi 1.33\nillum {illum}\n"));
            surface(&record, UNNAMED).expect("an index")
        };
        for illum in [4, 6, 7, 9] {
            assert_eq!(of(illum), Surface::Glass(Glass::new(Index::WATER)), "{illum}");
        }
        let Surface::Polished(mirrored) = of(5) else { panic!("it is polished") };
        assert_eq!(mirrored.mirror, Color::new(0.25, 0.5, 0.75));
        for illum in [0, 1, 2, 3, 8] {
            let Surface::Opaque(mirrored) = of(illum) else { panic!("{illum} is opaque") };
            assert_eq!(mirrored.reflects(), illum >= 3);
        }
    }

    #[test]
    fn what_is_not_wholly_there_is_glass() {
        assert!(
            surface(&record("d 0.5\nNi 2.42\n"), UNNAMED)
                .is_ok_and(|surface| { surface == Surface::Glass(Glass::new(Index::DIAMOND)) })
        );
        let message = surface(&record("illum 7\nNi 1e30\n"), UNNAMED).expect_err("too much");
        assert!(message.to_string().starts_with("material m: Ni: an index"), "{message}");
    }
}
