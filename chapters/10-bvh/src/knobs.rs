//! This chapter's own options.

use clap::Args;
use common::chapter::Failure;
use ray_casting::knobs::Aim;
use triangles::convert::Normals;

use crate::build::Recipe;
use crate::choice::{AccelChoice, Traversal, ViewChoice};
use crate::split::Split;

/// The options of this chapter alone.
#[derive(Clone, Debug, Default, Args)]
pub struct Knobs {
    /// How the triangle that a ray hits first is found
    #[arg(long, value_enum, default_value_t)]
    pub accel: AccelChoice,
    /// How the tree's nodes are cut in two [default: sah]
    #[arg(long, value_enum)]
    pub split: Option<Split>,
    /// The most triangles in a leaf of the tree [default: 4]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=64))]
    pub leaf: Option<u8>,
    /// How rays go through the tree [default: ordered]
    #[arg(long, value_enum)]
    pub traversal: Option<Traversal>,
    /// What the picture shows
    #[arg(long, value_enum, default_value_t)]
    pub view: ViewChoice,
    /// Where the normals come from [default: given]
    #[arg(long, value_enum)]
    pub normals: Option<Normals>,
    /// Where to look from.
    #[command(flatten)]
    pub aim: Aim,
}

impl Knobs {
    /// How the tree is to be built.
    pub fn recipe(&self) -> Recipe {
        let Recipe { split, leaf, together } = Recipe::TRIANGLES;
        Recipe {
            split: self.split.unwrap_or(split),
            leaf: self.leaf.map_or(leaf, usize::from),
            together,
        }
    }

    /// Refuses options that would change nothing.
    ///
    /// # Errors
    /// An option of the tree without a tree, or of one view with another.
    pub fn check(&self) -> Result<(), Failure> {
        let of_tree = self.split.is_some() || self.leaf.is_some() || self.traversal.is_some();
        let wrong = |text: &str| Err(Failure::Usage(text.into()));
        match (self.accel, self.view) {
            (accel, _) if of_tree && accel != AccelChoice::Bvh => {
                wrong("--split, --leaf and --traversal are for --accel bvh")
            }
            (_, ViewChoice::Lit) if of_tree || self.normals.is_some() => wrong(
                "--split, --leaf, --traversal and --normals are for the other views: \
                 add --view normals, depth or work",
            ),
            (accel, ViewChoice::Cut) if accel != AccelChoice::Bvh => {
                wrong("--view cut shows the boxes of --accel bvh")
            }
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{AccelChoice, Knobs, Split, ViewChoice};

    #[test]
    fn options_that_would_change_nothing_are_refused() {
        let tree = Knobs { split: Some(Split::Median), ..Knobs::default() };
        assert!(tree.check().is_err(), "a lit picture takes the default tree");
        assert!(Knobs { view: ViewChoice::Work, ..tree.clone() }.check().is_ok());
        let (accel, view) = (AccelChoice::Kd, ViewChoice::Work);
        assert!(Knobs { accel, view, ..tree }.check().is_err());
        assert!(Knobs { accel, view, leaf: Some(2), ..Knobs::default() }.check().is_err());
        assert!(Knobs { accel, view: ViewChoice::Cut, ..Knobs::default() }.check().is_err());
        assert!(Knobs::default().check().is_ok());
    }
}
