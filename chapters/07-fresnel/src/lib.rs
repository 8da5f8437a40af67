//! Chapter 7: glass and metal, what is reflected and what goes through.
//!
//! Light that meets glass goes two ways. This chapter says which ways, how much goes each way, and
//! what becomes of rays in glass within glass. It builds on [`whitted`], whose loop follows two rays
//! as readily as one, on [`shadows`] and on [`blinn_phong`].
//!
//! ```text
//! cargo run --release -p fresnel
//! cargo run --release -p fresnel -- --scene pool
//! cargo run --release -p fresnel -- --scene curves --index 2.42
//! cargo run --release -p fresnel -- cost
//! cargo run --release -p fresnel -- hard
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`index`] | how many times slower light is in a medium |
//! | [`interface`] | two media, and Snell's law for cosines |
//! | [`bend`] | which way light goes on |
//! | [`dielectric`], [`schlick`] | how much glass reflects: Fresnel's equations, and nearly |
//! | [`conductor`] | how much metal reflects |
//! | [`slab`] | light that goes to and fro between two faces |
//! | [`radiance`] | what happens to radiance on its way into another medium |
//! | [`glass`], [`mtl`] | what surfaces are made of, from scenes and from files |
//! | [`inside`] | the bodies a ray is in, and so in which medium |
//! | [`passage`] | the next thing on a ray's way that light notices |
//! | [`path`] | a ray, and what its path remembers |
//! | [`shade`] | the light of lamps, with glass around |
//! | [`integrator`] | following light through all of it |
//! | [`curves`] | the reflected part over the angle, as a chart |
//! | [`naive`] | the textbook's formulas, which fail |
//! | [`hard`] | inputs on which the naive formulas fail and ours don't |
//! | `cost` | what accuracy costs in time |
//! | `scenes`, `picture`, `knobs`, `command` | the program, its scenes and options |
//! | [`exercises`] | yours to write |

pub mod bend;
pub mod conductor;
pub mod curves;
pub mod dielectric;
pub mod exercises;
pub mod glass;
pub mod hard;
pub mod index;
pub mod inside;
pub mod integrator;
pub mod interface;
pub mod mtl;
pub mod naive;
pub mod passage;
pub mod path;
pub mod radiance;
pub mod schlick;
pub mod shade;
pub mod slab;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
#[cfg(feature = "native")]
pub mod knobs;
#[cfg(feature = "native")]
pub mod picture;
#[cfg(feature = "native")]
pub mod scenes;
