//! What holds across chapters, and how to ask it: the list of chapters, their real programs, and
//! their command lines run inside the test; and reference pictures that another renderer made.

pub mod chapters;
pub mod program;
pub mod reference;
