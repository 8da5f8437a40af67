//! Whether a scene calls for shadows.

use blinn_phong::material::BlinnPhong;
use blinn_phong::scene::Scene;
use common::plan::{Call, Effect};

// ANCHOR: casts_shadows
/// Whether anything can be in the way of a lamp's light: another object, or an object's own other
/// side. One ball seen from outside has none that faces the lamp and is dark.
pub fn casts_shadows(scene: &Scene<BlinnPhong>) -> bool {
    match &scene.objects[..] {
        [] => false,
        [alone] => alone.shape.hides_itself(scene.view.eye),
        _ => true,
    }
}
// ANCHOR_END: casts_shadows

/// What the scene calls for: `calls`, but for shadows that nothing casts.
pub fn of_scene(scene: &Scene<BlinnPhong>, calls: &[Call]) -> Vec<Call> {
    let kept = |call: &&Call| call.effect != Effect::HardShadows || casts_shadows(scene);
    calls.iter().filter(kept).cloned().collect()
}

#[cfg(test)]
mod tests {
    use blinn_phong::scenes::{Stage, brute_force};
    use glam::Vec3;

    use super::casts_shadows;
    use crate::scenes::named;

    fn stage(name: &str) -> Stage {
        named(name, brute_force).expect("it is built in")
    }

    #[test]
    fn one_ball_casts_no_shadow_unless_it_is_around_the_eye() {
        let mut alone = stage("alone").scene;
        assert!(!casts_shadows(&alone));
        alone.view.eye = Vec3::new(-1.1, 1.2, -0.4);
        assert!(casts_shadows(&alone));
        assert!(!casts_shadows(&stage("empty").scene));
    }

    #[test]
    fn two_things_or_a_mesh_can_cast_some() {
        for name in ["three-lamps", "whitted", "two-lamps", "sphere:60"] {
            assert!(casts_shadows(&stage(name).scene), "{name}");
        }
    }
}
