//! Chapter 15: rough metal and rough glass.
//!
//! Between the mirror and the matte wall lies nearly everything. A rough surface is made of facets,
//! each a mirror or a pane of glass that is too small to be seen; how they lie says how the whole
//! looks. It builds on [`path_tracing`], whose [`Bsdf`](path_tracing::bsdf::Bsdf) its materials are,
//! and on [`fresnel`].
//!
//! ```text
//! cargo run --release -p microfacets
//! cargo run --release -p microfacets -- --scene rough-metals --roughness 0.1
//! cargo run --release -p microfacets -- --scene lost-light
//! cargo run --release -p microfacets -- cost
//! cargo run --release -p microfacets -- hard
//! ```
//!
//! | module | idea |
//! |---|---|
//! | [`ggx`] | how facets lie, which are hidden, and which are seen |
//! | [`facets`] | which are both seen and lit, and which one a path meets |
//! | [`conductor`] | rough metal |
//! | [`dielectric`], `passage` | rough glass |
//! | [`rough`], [`finish`] | the rough materials, and all materials so far |
//! | [`albedo`] | how much light comes back |
//! | [`naive`] | the textbook's formulas, which fail |
//! | [`hard`] | inputs on which the naive formulas fail and ours don't |
//! | `cost` | what accuracy costs in time |
//! | `scenes`, `knobs`, `command` | the program, its scenes and options |
//! | [`exercises`] | yours to write |

pub mod albedo;
pub mod conductor;
pub mod dielectric;
pub mod exercises;
pub mod facets;
pub mod finish;
pub mod ggx;
pub mod hard;
pub mod naive;
mod passage;
pub mod rough;

#[cfg(feature = "native")]
pub mod command;
#[cfg(feature = "native")]
pub mod cost;
#[cfg(feature = "native")]
pub mod knobs;
#[cfg(feature = "native")]
pub mod scenes;

#[cfg(test)]
mod tests;
