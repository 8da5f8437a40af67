//! Sixteen rays side by side.
//!
//! There is no vector type here, and no instruction of a certain processor. A loop over [`RAYS`] whose
//! body has no jump and no call is what a compiler turns into vector instructions by itself, as wide as
//! those of the processor it is told to compile for. So `if` stands here only where it picks one of two
//! numbers, `&` stands for `&&`, and every function in such a loop is `inline(always)`.

use glam::Vec3;

/// How many rays go together.
pub const RAYS: usize = 16;

/// A number for each ray.
pub type Floats = [f32; RAYS];

// ANCHOR: vectors
/// A vector for each ray, coordinate by coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vectors {
    pub(crate) x: Floats,
    pub(crate) y: Floats,
    pub(crate) z: Floats,
}
// ANCHOR_END: vectors

impl Vectors {
    /// As many vectors of length 0.
    pub const ZERO: Self = Self { x: [0.0; RAYS], y: [0.0; RAYS], z: [0.0; RAYS] };

    /// The vector of ray number `ray`.
    #[inline(always)]
    pub fn at(&self, ray: usize) -> Vec3 {
        Vec3::new(self.x[ray], self.y[ray], self.z[ray])
    }

    /// Changes the vector of ray number `ray`.
    #[inline(always)]
    pub fn set(&mut self, ray: usize, vector: Vec3) {
        (self.x[ray], self.y[ray], self.z[ray]) = (vector.x, vector.y, vector.z);
    }

    /// The vectors that `vector` says, ray by ray.
    #[inline(always)]
    pub fn of(vector: impl Fn(usize) -> Vec3) -> Self {
        let mut all = Self::ZERO;
        for ray in 0..RAYS {
            all.set(ray, vector(ray));
        }
        all
    }
}

/// Sixteen rays made ready for triangles: what a
/// [`ShearedRay`](crate::watertight::ShearedRay) holds, side by side.
#[derive(Clone, Copy, Debug)]
pub struct Bundle {
    origin: Vectors,
    /// The number of the axis that comes third.
    longest: [u32; RAYS],
    shear: [Floats; 2],
    pub(crate) advance: Floats,
    /// A ray that hits nothing, whatever there is.
    pub(crate) idle: [bool; RAYS],
}

impl Bundle {
    /// Rays from these origins in these directions. Where `used` says no, the ray hits nothing.
    #[inline(always)]
    pub fn new(origin: &Vectors, direction: &Vectors, used: &[bool; RAYS]) -> Self {
        let mut bundle = Self {
            origin: *origin,
            longest: [0; RAYS],
            shear: [[0.0; RAYS]; 2],
            advance: [0.0; RAYS],
            idle: [true; RAYS],
        };
        for ray in 0..RAYS {
            let (origin, direction) = (origin.at(ray), direction.at(ray));
            let longest = longest(direction);
            let turned = to_third(longest, direction);
            let finite = direction.is_finite() & origin.is_finite();
            bundle.longest[ray] = longest;
            bundle.shear[0][ray] = turned.x / turned.z;
            bundle.shear[1][ray] = turned.y / turned.z;
            bundle.advance[ray] = turned.z;
            bundle.idle[ray] = !(used[ray] & finite & (turned.z != 0.0));
        }
        bundle
    }

    /// A corner in the coordinates of all rays.
    #[inline(always)]
    pub(crate) fn shear(&self, corner: Vec3) -> Vectors {
        Vectors::of(|ray| {
            let offset = to_third(self.longest[ray], corner - self.origin.at(ray));
            let x = offset.x - self.shear[0][ray] * offset.z;
            let y = offset.y - self.shear[1][ray] * offset.z;
            Vec3::new(x, y, offset.z)
        })
    }
}

/// The number of the axis along which `direction` goes farthest; as the watertight test has it.
#[inline(always)]
fn longest(direction: Vec3) -> u32 {
    let size = direction.abs();
    let others = if size.y > size.z { 1 } else { 2 };
    if (size.x > size.y) & (size.x > size.z) { 0 } else { others }
}

/// The same vector with coordinate number `axis` last.
#[inline(always)]
fn to_third(axis: u32, Vec3 { x, y, z }: Vec3) -> Vec3 {
    let pick = |of_x, of_y, of_z| {
        let others = if axis == 1 { of_y } else { of_z };
        if axis == 0 { of_x } else { others }
    };
    Vec3::new(pick(y, z, x), pick(z, x, y), pick(x, y, z))
}
