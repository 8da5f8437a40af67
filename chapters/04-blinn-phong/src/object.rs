//! A thing in a scene: a shape, and what it is made of.

use std::borrow::Borrow;

use ray_casting::shape::Shape;

// ANCHOR: object
/// A shape and its material. The shape never learns what a material is, and what a material is the
/// integrator says that understands it.
pub struct Object<M> {
    /// Where it is.
    pub shape: Box<dyn Shape>,
    /// What it is made of.
    pub material: M,
}
// ANCHOR_END: object

impl<M> Borrow<dyn Shape> for Object<M> {
    fn borrow(&self) -> &(dyn Shape + 'static) {
        self.shape.as_ref()
    }
}
