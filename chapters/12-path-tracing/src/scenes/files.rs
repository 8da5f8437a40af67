//! Meshes of the reader's own.

use common::chapter::Failure;
use common::film::Color;
use common::obj::Material;
use triangles::parts::{self, by_material};
use triangles::scene::MeshScene;

use crate::model::Model;
use crate::mtl;
use crate::part::{Emission, Form, Part};
use crate::smooth::Smooth;

/// The sky over a mesh that doesn't glow: without it the picture would be black.
const GREY: Color = Color::splat(0.5);

/// What faces without a material are made of.
const UNNAMED: Smooth = Smooth::matte(0.8, 0.8, 0.8);

/// The scene of an OBJ file: a thing a material, its faces flat.
///
/// # Errors
/// A file that is no mesh, or whose materials can't be; the message names the file and the material.
pub(super) fn read(name: &str) -> Result<Model<Smooth>, Failure> {
    let MeshScene { mesh, view, mut warnings, materials, material_of, .. } =
        MeshScene::named(name)?;
    let of_part = |part: &parts::Part| {
        let record = part.material.map(|number| &materials[number as usize]);
        let (material, emission) = record.map_or(Ok((UNNAMED, Emission::default())), described)?;
        Ok(Part { form: Form::Triangles(part.mesh.all_corners()), material, emission })
    };
    let parts = by_material(&mesh, &material_of);
    let used = parts.iter().filter_map(|part| materials.get(part.material? as usize));
    warnings.extend(used.filter_map(mtl::warning));
    let parts: Result<Vec<_>, mtl::BadMaterial> = parts.iter().map(of_part).collect();
    let parts = parts.map_err(|error| Failure::Work(format!("{name}: {error}")))?;
    let glows = parts.iter().any(|part| part.emission.glows());
    let sky = if glows { Color::ZERO } else { GREY };
    Ok(Model { warnings, ..Model::new(parts, sky, view) })
}

fn described(record: &Material) -> Result<(Smooth, Emission), mtl::BadMaterial> {
    Ok((mtl::surface(record)?, mtl::emission(record)?))
}

#[cfg(test)]
mod tests {
    use common::chapter::Failure;
    use common::film::Color;

    use super::{GREY, read};
    use crate::smooth::Smooth;

    #[test]
    fn a_file_s_materials_are_read() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/two-materials.obj");
        let scene = read(path).expect("the file is part of the project");
        let parts = &scene.parts;
        assert_eq!(parts.len(), 2);
        let plaster = parts.iter().find(|part| part.material == Smooth::matte(0.72, 0.68, 0.6));
        assert!(plaster.is_some_and(|part| !part.emission.glows()));
        assert!(parts.iter().any(|part| part.emission.radiance == Color::new(2.4, 0.9, 0.3)));
        assert_eq!(scene.sky, Color::ZERO, "it glows by itself");
        assert!(scene.warnings.iter().any(|text| text.contains("material sign")));
    }

    #[test]
    fn a_mesh_that_does_not_glow_has_a_sky() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/bunny.obj");
        let scene = read(path).expect("the file is part of the project");
        assert_eq!(scene.sky, GREY);
        assert!(scene.parts.iter().all(|part| !part.emission.glows()));
    }

    #[test]
    fn a_wrong_file_is_named() {
        let folder = std::env::temp_dir().join(format!("path-tracing-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        let file = folder.join("bright.obj");
        let obj = "mtllib bright.mtl\nusemtl wall\nv 0 0 0\nv 2 0 0\nv 0 3 0\nf 1 2 3\n";
        std::fs::write(&file, obj).expect("a file");
        let path = file.to_str().expect("a plain name").to_owned();
        for (mtl, told) in [("Kd 1.5 0 0", "material wall: Kd"), ("Ke nan 0 0", "bright.mtl")] {
            std::fs::write(folder.join("bright.mtl"), format!("newmtl wall\n{mtl}\n"))
                .expect("one");
            let Err(Failure::Work(text)) = read(&path) else { panic!("{mtl} was taken") };
            assert!(text.contains("bright.") && text.contains(told), "{text}");
        }
        std::fs::remove_dir_all(&folder).expect("it was made above");
        assert!(
            matches!(read("missing.obj"), Err(Failure::Work(text)) if text.contains("missing"))
        );
    }
}
