//! A scene as it is described: things, a sky, and where it is seen from.

use common::film::Color;
use ray_casting::camera::View;

use crate::part::Part;

// ANCHOR: model
/// Things of materials `M`, and the light around them.
#[derive(Clone, Debug)]
pub struct Model<M> {
    /// What there is.
    pub parts: Vec<Part<M>>,
    /// The radiance from all around.
    pub sky: Color,
    /// Where it is seen from.
    pub view: View,
    /// What the user should be told of its file.
    pub warnings: Vec<String>,
}
// ANCHOR_END: model

impl<M> Model<M> {
    /// These things under this sky, seen from there.
    pub fn new(parts: Vec<Part<M>>, sky: Color, view: View) -> Self {
        Self { parts, sky, view, warnings: Vec::new() }
    }

    /// The same scene of other materials: what a later chapter makes of this one's.
    pub fn map<N>(self, material: impl Fn(M) -> N) -> Model<N> {
        let parts = self.parts.into_iter().map(|part| part.map(&material)).collect();
        Model { parts, sky: self.sky, view: self.view, warnings: self.warnings }
    }
}

#[cfg(test)]
mod tests {
    use common::film::Color;

    use crate::furnace;

    #[test]
    fn other_materials_in_the_same_place() {
        let model = furnace::shell(0.5);
        let named = model.clone().map(|material| material.lambert().map(|it| it.reflectance.x));
        assert_eq!(
            named.parts.iter().map(|it| it.material).collect::<Vec<_>>(),
            [Some(0.5), Some(0.0)]
        );
        assert_eq!(named.parts[1].form, model.parts[1].form);
        assert_eq!(named.parts[1].emission.radiance, Color::ONE);
        assert_eq!((named.sky, named.view.eye), (model.sky, model.view.eye));
    }
}
