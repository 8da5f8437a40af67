//! The program that builds the book.
//!
//! A page in `book/text` is Markdown with directives. [`site`] reads the pages, [`lint`] refuses
//! what would mislead a reader, [`figures`] runs the chapters' command lines and keeps what they
//! made, [`expand`] puts it into the pages, mdBook makes HTML of them, and [`links`] follows every
//! link of the result.
//!
//! | reading a page | making its figures | the commands |
//! |---|---|---|
//! | [`page`], [`directive`], [`include`], [`outline`] | [`job`], [`cache`], [`figures`], [`cost`] | [`cli`], [`site`] |
//! | [`lint`], [`links`], [`trouble`] | [`expand`], [`html`], [`math`], [`number`], [`value`] | [`serve`], [`watch`], [`exercises`] |

pub mod cache;
pub mod chapters;
pub mod cli;
pub mod cost;
pub mod directive;
pub mod exercises;
pub mod expand;
pub mod figures;
pub mod html;
pub mod include;
pub mod job;
pub mod links;
pub mod lint;
pub mod math;
pub mod number;
pub mod outline;
pub mod page;
pub mod places;
pub mod serve;
pub mod site;
pub mod trouble;
pub mod value;
pub mod watch;

#[cfg(test)]
mod fake;
