//! What accuracy costs in time: experiments that hold a method's error against its work and time.
//!
//! Counted work and error are the same on every machine, and tests pin them. Time is measured where
//! the reader is: the methods take turns, several rounds, and the median is shown with its spread,
//! so that a machine whose speed drifts is fair to all of them.

#[cfg(feature = "native")]
mod axis;
#[cfg(feature = "native")]
pub mod chart;
#[cfg(feature = "native")]
mod measure;
mod table;

#[cfg(feature = "native")]
pub use measure::measure;
pub use table::{Row, Table, Time, csv};

/// A choice to be made, and the methods to choose from.
pub struct Experiment<'a> {
    /// A short name for files, such as "sphere-roots".
    pub name: &'static str,
    /// What is compared, as a heading.
    pub title: &'static str,
    /// What is counted, in the plural, such as "rays".
    pub work_unit: &'static str,
    /// How the error is measured and against what, such as "RMS relative error of t against f64".
    pub error_metric: &'static str,
    /// What the plot shows.
    pub plot: Plot,
    /// What is compared.
    pub methods: Vec<Method<'a>>,
    /// One sentence about the measured table, such as where two curves cross; empty for none.
    pub note: fn(&Table) -> String,
}

/// The note of an experiment that needs none.
pub fn no_note(_table: &Table) -> String {
    String::new()
}

/// A ratio of two times as words: "2.6 % less" or "11.9 % more".
pub fn change(ratio: f64) -> String {
    let percent = 100.0 * (ratio - 1.0);
    let word = if percent < 0.0 { "less" } else { "more" };
    format!("{:.1} % {word}", percent.abs())
}

/// What the plot of an experiment shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plot {
    /// A point a method: its error, on an axis with this short label, over the nanoseconds for one
    /// unit of work.
    ErrorOverTime(&'static str),
    /// A curve a series: its error, on an axis with this short label, over the milliseconds of a run,
    /// from few samples to many.
    Convergence(&'static str),
    /// A curve a series: milliseconds over the methods' sizes, whose axis has this label.
    TimeOver(&'static str),
    /// A curve a series: the error over the methods' sizes, such as numbers of samples.
    ErrorOver {
        /// The label of the sizes' axis.
        size: &'static str,
        /// The label of the error's axis.
        error: &'static str,
    },
}

/// One method or setting of an experiment.
pub struct Method<'a> {
    /// Its name in the table, such as "quadratic, f32".
    pub label: String,
    /// The curve it belongs to in a plot over sizes; elsewhere its label again.
    pub series: &'static str,
    /// Its place on the size axis, where the plot has one.
    pub size: f64,
    /// Units of work that one run does.
    pub work: u64,
    /// Its error, in the experiment's metric.
    pub error: f64,
    /// One run. Its result goes to `std::hint::black_box`, or the compiler removes the work.
    pub run: Box<dyn FnMut() + 'a>,
}

/// The part of the experiments that is the same on every machine, as text for a snapshot.
pub fn pinned(experiments: &[Experiment]) -> String {
    let mut text = String::new();
    for experiment in experiments {
        text += &format!("{}: error is {}\n", experiment.name, experiment.error_metric);
        for Method { label, work, error, .. } in &experiment.methods {
            text += &format!("  {label}: {work} {}, error {error:.3e}\n", experiment.work_unit);
        }
    }
    text
}
