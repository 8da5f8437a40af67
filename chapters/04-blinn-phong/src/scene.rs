//! A scene: objects, lamps, and where it is seen from.

use common::film::Color;
use common::tally::Tally;
use ray_casting::camera::View;
use ray_casting::ray::Ray;
use ray_casting::shape::{self, Nearest};

use crate::light::Light;
use crate::object::Object;

// ANCHOR: scene
/// Objects with materials `M`, and the light that falls on them.
pub struct Scene<M> {
    /// What there is to see.
    pub objects: Vec<Object<M>>,
    /// The lamps.
    pub lights: Vec<Light>,
    /// Light that comes from everywhere alike, in the unit of what a lamp sends to a surface.
    pub ambient: Color,
    /// The radiance behind everything.
    pub background: Color,
    /// Where it is seen from.
    pub view: View,
}
// ANCHOR_END: scene

impl<M> Scene<M> {
    /// What the ray meets first.
    pub fn nearest<T: Tally>(&self, ray: &Ray, tally: &mut T) -> Option<Nearest<'_, Object<M>>> {
        shape::nearest(&self.objects, ray, tally)
    }

    /// The same scene of other materials: what a later chapter makes of an earlier one's scene.
    pub fn map<N>(self, mut material: impl FnMut(usize, M) -> N) -> Scene<N> {
        let Self { objects, lights, ambient, background, view } = self;
        let objects = objects.into_iter().enumerate().map(|(index, object)| Object {
            shape: object.shape,
            material: material(index, object.material),
        });
        Scene { objects: objects.collect(), lights, ambient, background, view }
    }
}
