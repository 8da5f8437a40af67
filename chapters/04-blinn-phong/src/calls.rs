//! The effects a lit scene calls for.

use common::film::Color;
use common::plan::{Call, Effect};

use crate::material::BlinnPhong;
use crate::scene::Scene;

// ANCHOR: of_scene
/// What the scene's own data call for, then what of `others` the data can't show.
pub fn of_scene(scene: &Scene<BlinnPhong>, others: &[Call]) -> Vec<Call> {
    let objects = scene.objects.len();
    let shading = shading(scene);
    let textured = scene.objects.iter().any(|object| object.material.is_textured());
    let own = [
        (objects > 0, Effect::PrimaryVisibility, format!("it has {}", counted(objects, "object"))),
        (shading.is_some(), Effect::LocalShading, shading.clone().unwrap_or_default()),
        (textured && shading.is_some(), Effect::Textures, "a paint is a checkerboard".into()),
        (lamps(scene) > 0, Effect::HardShadows, "its lamps have no extent".into()),
    ];
    let mut calls: Vec<Call> = Vec::new();
    for (asked, effect, because) in &own {
        if *asked {
            calls.push(Call { effect: *effect, because: because.clone() });
        }
    }
    let unknown = |call: &&Call| own.iter().all(|(_, effect, _)| *effect != call.effect);
    calls.extend(others.iter().filter(unknown).cloned());
    calls
}
// ANCHOR_END: of_scene

/// What light there is for surfaces to return, in words; None when there is none.
fn shading(scene: &Scene<BlinnPhong>) -> Option<String> {
    let ambient = scene.ambient != Color::ZERO
        && scene.objects.iter().any(|object| !object.material.ambient.is_black());
    match (lamps(scene), ambient) {
        (0, false) => None,
        (0, true) => Some("there is ambient light".into()),
        (1, _) => Some("1 lamp lights it".into()),
        (lamps, _) => Some(format!("{lamps} lamps light it")),
    }
}

/// How many lamps light something: those that are on, if any surface returns their light.
fn lamps(scene: &Scene<BlinnPhong>) -> usize {
    let returns = |material: &BlinnPhong| !material.diffuse.is_black() || material.has_highlight();
    let seen = scene.objects.iter().any(|object| returns(&object.material));
    if seen { scene.lights.iter().filter(|light| light.is_on()).count() } else { 0 }
}

fn counted(count: usize, what: &str) -> String {
    if count == 1 { format!("1 {what}") } else { format!("{count} {what}s") }
}

#[cfg(test)]
mod tests {
    use common::film::Color;
    use common::plan::{Call, Effect};
    use glam::Vec3;
    use ray_casting::camera::View;
    use ray_casting::sphere::Sphere;

    use super::of_scene;
    use crate::light::Light;
    use crate::material::BlinnPhong;
    use crate::object::Object;
    use crate::paint::Paint;
    use crate::scene::Scene;

    const VIEW: View =
        View { eye: Vec3::ZERO, target: Vec3::NEG_Z, up: Vec3::Y, vertical_fov: 50.0 };

    fn scene(color: Color, lights: &[Light], ambient: f32) -> Scene<BlinnPhong> {
        let shape = Box::new(Sphere { center: Vec3::NEG_Z * 5.0, radius: 1.5 });
        Scene {
            objects: vec![Object { shape, material: BlinnPhong::matte(Paint::Plain(color)) }],
            lights: lights.to_vec(),
            ambient: Color::splat(ambient),
            background: Color::ZERO,
            view: VIEW,
        }
    }

    fn because(scene: &Scene<BlinnPhong>, effect: Effect) -> Option<String> {
        let calls = of_scene(scene, &[]);
        calls.into_iter().find(|call| call.effect == effect).map(|call| call.because)
    }

    #[test]
    fn no_light_no_shading() {
        let lamp = Light::steady(Vec3::Y, Color::ONE);
        let off = Light::steady(Vec3::Y, Color::ZERO);
        let grey = Color::splat(0.5);
        let shading = |scene| because(&scene, Effect::LocalShading);
        assert_eq!(shading(scene(grey, &[], 0.0)), None);
        assert_eq!(shading(scene(grey, &[off], 0.0)), None);
        assert_eq!(shading(scene(Color::ZERO, &[lamp], 0.7)), None);
        assert_eq!(shading(scene(grey, &[off, lamp], 0.0)).as_deref(), Some("1 lamp lights it"));
        let ambient = shading(scene(grey, &[], 0.7));
        assert_eq!(ambient.as_deref(), Some("there is ambient light"));
        assert_eq!(because(&scene(grey, &[], 0.7), Effect::HardShadows), None);
    }

    #[test]
    fn others_are_kept_unless_the_data_decide() {
        let call = |effect| Call { effect, because: "somebody said so".into() };
        let others = [call(Effect::Refraction), call(Effect::LocalShading), call(Effect::Textures)];
        let calls = of_scene(&scene(Color::ONE, &[], 0.0), &others);
        let effects: Vec<Effect> = calls.iter().map(|call| call.effect).collect();
        assert_eq!(effects, [Effect::PrimaryVisibility, Effect::Refraction]);
    }
}
