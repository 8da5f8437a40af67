//! Chapter 5: whether two points see each other.
//!
//! | module | idea |
//! |---|---|
//! | [`spawn`] | where a ray that leaves a surface has to start |
//! | [`occluder`] | any hit before a limit, instead of the nearest |
//! | [`visibility`] | whether two points see each other, the same from both ends |
//! | [`lighting`] | a surface under several lamps, each of which may be hidden |

pub mod hard;
pub mod lighting;
pub mod naive;
pub mod occluder;
pub mod offset;
pub mod spawn;
pub mod visibility;
