//! From MTL records to materials.

use common::film::Color;
use common::obj::Material;

use crate::material::{BlinnPhong, MOST_RETURNED};
use crate::paint::Paint;

/// The material of faces that name none: the file format's own default.
pub const UNNAMED: BlinnPhong = BlinnPhong {
    ambient: Paint::Plain(Color::ZERO),
    diffuse: Paint::Plain(Color::splat(0.8)),
    specular: Color::ZERO,
    shininess: 0.0,
};

/// A number in a material that no sum of light can hold.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "material {material}: {statement} is {value:e}; make it at most {MOST_RETURNED:e} \
     (a surface that returns all light has 1)"
)]
pub struct TooBright {
    /// The material's name.
    pub material: String,
    /// The statement, such as "Ks".
    pub statement: &'static str,
    /// The number.
    pub value: f32,
}

// ANCHOR: material
/// The material of an MTL record, by its illumination model: 0 is a constant colour, 1 ambient and
/// diffuse, 2 a highlight as well. The mirrors and glass of 3 to 10 are taken for highlights.
///
/// # Errors
/// A number that is too large to add up with.
pub fn material(record: &Material) -> Result<BlinnPhong, TooBright> {
    check(record)?;
    let (ambient, diffuse) = (Paint::Plain(record.ambient), Paint::Plain(record.diffuse));
    Ok(match record.illumination {
        // Under an ambient light of 1, what a surface returns of it is a constant colour.
        0 => BlinnPhong { ambient: diffuse, ..BlinnPhong::matte(Paint::Plain(Color::ZERO)) },
        1 => BlinnPhong { ambient, ..BlinnPhong::matte(diffuse) },
        _ => {
            BlinnPhong { ambient, ..BlinnPhong::glossy(diffuse, record.specular, record.shininess) }
        }
    })
}
// ANCHOR_END: material

/// Whether nothing of the record is too large.
fn check(record: &Material) -> Result<(), TooBright> {
    let colors = [("Ka", record.ambient), ("Kd", record.diffuse), ("Ks", record.specular)];
    for (statement, color) in colors {
        let value = color.max_element();
        if !(value <= MOST_RETURNED) {
            return Err(TooBright { material: record.name.clone(), statement, value });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::obj::{Material, parse};

    use super::{TooBright, UNNAMED, material};
    use crate::paint::Paint;

    /// The materials of an MTL text, by way of a mesh that uses them.
    fn read(mtl: &str) -> Vec<Material> {
        let obj = b"mtllib a.mtl\nv 0 0 0\nv 2 0 0\nv 0 3 0\nf 1 2 3\n";
        parse("a.obj", obj, |_| Ok(mtl.as_bytes().to_vec())).expect("it is sound").materials
    }

    const NUMBERS: &str = "Ka 0.1 0.2 0.3\nKd 0.4 0.5 0.6\nKs 0.7 0.8 0.9\nNs 12\n";

    #[test]
    fn the_illumination_model_chooses_the_terms() {
        let [ambient, diffuse, specular] =
            [[0.1, 0.2, 0.3], [0.4, 0.5, 0.6], [0.7, 0.8, 0.9]].map(Color::from);
        let of = |illum: u8| {
            let records = read(&format!("newmtl m\n{NUMBERS}illum {illum}\n"));
            material(&records[0]).expect("it is ordinary")
        };
        let constant = of(0);
        assert_eq!(constant.ambient, Paint::Plain(diffuse));
        assert!(constant.diffuse.is_black() && !constant.has_highlight());
        let matte = of(1);
        assert_eq!((matte.ambient, matte.diffuse), (Paint::Plain(ambient), Paint::Plain(diffuse)));
        assert!(!matte.has_highlight());
        let glossy = of(2);
        assert_eq!(
            (glossy.diffuse, glossy.specular, glossy.shininess),
            (matte.diffuse, specular, 12.0)
        );
        assert_eq!(of(5), glossy, "mirrors come later");
    }

    #[test]
    fn a_record_that_says_nothing_is_the_unnamed_material() {
        assert_eq!(material(&read("newmtl m\n")[0]), Ok(UNNAMED));
    }

    #[test]
    fn huge_numbers_are_named() {
        let records = read("newmtl ok\nKs 1e9 0 0\nNs 1e38\nnewmtl sun\nKd 1 1e38 1\n");
        assert!(material(&records[0]).is_ok());
        let error = material(&records[1]).expect_err("it is too bright");
        let expected = TooBright { material: "sun".into(), statement: "Kd", value: 1e38 };
        assert_eq!(error, expected);
        assert!(error.to_string().starts_with("material sun: Kd is 1e38; make it at most 1e9"));
    }
}
