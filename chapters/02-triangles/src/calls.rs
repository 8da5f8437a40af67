//! The effects a mesh and its materials call for.

use common::obj::{Material, Model};
use common::plan::{Call, Effect};

use crate::mesh::Mesh;

/// What the mesh alone calls for.
pub fn of_mesh(mesh: &Mesh) -> Vec<Call> {
    let count = mesh.triangles.len();
    let mut calls = vec![Call {
        effect: Effect::PrimaryVisibility,
        because: format!("it has {count} triangles"),
    }];
    if !mesh.normals.is_empty() {
        let because = "its vertices have normals".to_owned();
        calls.push(Call { effect: Effect::SmoothNormals, because });
    }
    calls
}

/// What the mesh and the materials its triangles use call for.
pub fn of_model(mesh: &Mesh, model: &Model) -> Vec<Call> {
    let mut calls = of_mesh(mesh);
    let mut used = vec![false; model.materials.len()];
    for at in model.triangles.iter().filter_map(|triangle| triangle.material) {
        used[at as usize] = true;
    }
    for (material, _) in model.materials.iter().zip(used).filter(|(_, used)| *used) {
        for (effect, wish) in wishes(material) {
            if !calls.iter().any(|call| call.effect == effect) {
                calls.push(Call { effect, because: format!("material {} {wish}", material.name) });
            }
        }
    }
    calls
}

/// Whether a material asks for mirrors, sharp or rough: its illumination model has them, and they
/// return something.
pub fn is_mirror(material: &Material) -> bool {
    material.illumination >= 3 && material.specular.max_element() > 0.0
}

/// Whether a material asks to be rough, so that what it mirrors is blurred.
pub fn is_rough(material: &Material) -> bool {
    material.roughness.is_some_and(|roughness| roughness > 0.0)
}

/// The effects one material asks for, with what in it asks for them.
fn wishes(material: &Material) -> Vec<(Effect, &'static str)> {
    let mirrors = is_mirror(material);
    let clear = material.dissolve < 1.0 || [4, 6, 7, 9].contains(&material.illumination);
    let rough = is_rough(material);
    [
        (true, Effect::LocalShading, "has a colour (Kd)"),
        (mirrors && !rough, Effect::MirrorReflection, "mirrors (illum 3 or more, Ks)"),
        (mirrors && rough, Effect::GlossyReflection, "mirrors and is rough (Pr)"),
        (clear, Effect::Refraction, "lets light through (d or illum)"),
        (material.emission.max_element() > 0.0, Effect::AreaLights, "glows (Ke)"),
    ]
    .into_iter()
    .filter_map(|(asked, effect, wish)| asked.then_some((effect, wish)))
    .collect()
}
