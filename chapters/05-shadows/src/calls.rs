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
