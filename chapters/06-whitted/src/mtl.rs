//! Mirrors from MTL records.

use common::film::Color;
use common::obj::Material;
use triangles::calls::{is_mirror, is_rough};

// ANCHOR: mirror
/// What a material of this record mirrors: its `Ks`, if its illumination model is 3 or more and it
/// isn't rough. A mirror that returned more than it gets would have no end, so 1 is the most.
pub fn mirror(record: &Material) -> Color {
    let mirrors = is_mirror(record) && !is_rough(record);
    if mirrors { record.specular.min(Color::ONE) } else { Color::ZERO }
}
// ANCHOR_END: mirror

/// What to tell the user of a record whose mirror was made to return less than it asks for.
pub fn warning(record: &Material) -> Option<String> {
    let Material { name, specular, .. } = record;
    let too_much = mirror(record).cmplt(*specular).any() && mirror(record) != Color::ZERO;
    too_much.then(|| {
        let most = specular.max_element();
        format!("material {name}: Ks is {most}, and a mirror returns at most 1; 1 is used")
    })
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::obj::{Material, parse};

    use super::{mirror, warning};

    fn record(mtl: &str) -> Material {
        let obj = b"mtllib a.mtl\nusemtl m\nv 0 0 0\nv 2 0 0\nv 0 3 0\nf 1 2 3\n";
        let mtl = format!("newmtl m\n{mtl}");
        let model = parse("a.obj", obj, |_| Ok(mtl.as_bytes().to_vec())).expect("it is sound");
        model.materials[0].clone()
    }

    #[test]
    fn ks_mirrors_from_illumination_3_on() {
        let ks = Color::new(0.25, 0.5, 0.75);
        for illum in 0..=9 {
            let expected = if illum >= 3 { ks } else { Color::ZERO };
            let record = record(&format!("Ks 0.25 0.5 0.75\nillum {illum}\n"));
            assert_eq!((mirror(&record), warning(&record)), (expected, None), "illum {illum}");
        }
        assert_eq!(mirror(&record("Ks 0.25 0.5 0.75\nillum 3\nPr 0.4\n")), Color::ZERO);
    }

    #[test]
    fn nothing_returns_more_than_it_gets() {
        let bright = record("Ks 0.5 7 1\nillum 3\n");
        assert_eq!(mirror(&bright), Color::new(0.5, 1.0, 1.0));
        assert!(warning(&bright).is_some_and(|text| text.contains("material m: Ks is 7")));
        assert_eq!(warning(&record("Ks 0.5 7 1\nillum 2\n")), None, "a highlight may");
    }
}
