//! Measured experiments as a table for people and as CSV for programs.

use std::fmt;

use super::Plot;

/// Milliseconds for one run: the median of the rounds and their range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Time {
    /// The middle round.
    pub median: f64,
    /// The fastest round.
    pub low: f64,
    /// The slowest round.
    pub high: f64,
}

/// One measured method.
#[derive(Clone, Debug)]
pub struct Row {
    /// The method's name.
    pub label: String,
    /// The curve it belongs to.
    pub series: &'static str,
    /// Its place on the size axis.
    pub size: f64,
    /// Units of work in one run.
    pub work: u64,
    /// Error in the table's metric.
    pub error: f64,
    /// Milliseconds for one run.
    pub time: Time,
}

impl Row {
    /// Nanoseconds for one unit of work.
    pub fn nanoseconds(&self) -> f64 {
        self.time.median * 1e6 / self.work as f64
    }

    /// 1/(error² · seconds): how much accuracy a second buys. Infinite for a method without error.
    pub fn efficiency(&self) -> f64 {
        1.0 / (self.error * self.error * self.time.median * 1e-3)
    }
}

/// A measured experiment; prints as a table.
#[derive(Clone, Debug)]
pub struct Table {
    /// A short name for files.
    pub name: &'static str,
    /// What is compared.
    pub title: &'static str,
    /// What is counted.
    pub work_unit: &'static str,
    /// How the error is measured.
    pub error_metric: &'static str,
    /// What the plot shows.
    pub plot: Plot,
    /// One row a method.
    pub rows: Vec<Row>,
    /// One sentence about what was measured, or nothing.
    pub note: String,
}

/// The first line of a [`csv`] file.
const HEADINGS: &str = "experiment,label,work,work_unit,milliseconds,milliseconds_low,\
    milliseconds_high,nanoseconds_per_unit,error,error_metric,efficiency";

/// All rows of the tables, one line each, under one line of headings (RFC 4180).
pub fn csv(tables: &[Table]) -> String {
    let mut text = format!("{HEADINGS}\n");
    for table in tables {
        for row in &table.rows {
            let Time { median, low, high } = row.time;
            text += &format!(
                "{},{},{},{},{median:.6},{low:.6},{high:.6},{:.3},{:e},{},{:e}\n",
                table.name,
                quoted(&row.label),
                row.work,
                quoted(table.work_unit),
                row.nanoseconds(),
                row.error,
                quoted(table.error_metric),
                row.efficiency(),
            );
        }
    }
    text
}

/// A CSV field that may hold commas and quotes.
fn quoted(field: &str) -> String {
    format!("\"{}\"", field.replace('"', "\"\""))
}

impl fmt::Display for Table {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        writeln!(out, "{}", self.title)?;
        writeln!(out, "work: {}; error: {}", self.work_unit, self.error_metric)?;
        let width = self.rows.iter().map(|row| row.label.chars().count()).max().unwrap_or(0);
        writeln!(
            out,
            "{:width$} {:>12} {:>10}  {:>19} {:>9} {:>10} {:>11}",
            "method", "work", "ms", "(spread)", "ns/unit", "error", "1/(MSE s)"
        )?;
        for row in &self.rows {
            let spread = format!("({:.3} to {:.3})", row.time.low, row.time.high);
            writeln!(
                out,
                "{:width$} {:>12} {:>10.3}  {spread:>19} {:>9.2} {:>10} {:>11}",
                row.label,
                row.work,
                row.time.median,
                row.nanoseconds(),
                short(row.error),
                short(row.efficiency()),
            )?;
        }
        if self.note.is_empty() { Ok(()) } else { writeln!(out, "{}", self.note) }
    }
}

/// A number in a narrow column.
fn short(value: f64) -> String {
    match value {
        0.0 => "0".into(),
        value if value.is_infinite() => "no error".into(),
        value => format!("{value:.2e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::{Plot, Row, Table, Time, csv};

    fn table() -> Table {
        let time = Time { median: 2.0, low: 1.5, high: 4.0 };
        let row = |label: &str, error| Row {
            label: label.into(),
            series: "all",
            size: 1.0,
            work: 1000,
            error,
            time,
        };
        Table {
            name: "roots",
            title: "Roots of a quadratic",
            work_unit: "rays",
            error_metric: "RMS error",
            plot: Plot::ErrorOverTime("error"),
            rows: vec![row("naive, f32", 0.5), row("f64", 0.0)],
            note: String::new(),
        }
    }

    #[test]
    fn efficiency_and_nanoseconds_by_hand() {
        let row = &table().rows[0];
        assert_eq!(row.nanoseconds(), 2000.0);
        assert_eq!(row.efficiency(), 1.0 / (0.25 * 0.002));
    }

    #[test]
    fn csv_keeps_commas_inside_their_field() {
        let text = csv(&[table()]);
        let first = text.lines().nth(1).expect("a row");
        assert!(first.starts_with("roots,\"naive, f32\",1000,\"rays\",2.000000,"), "{first}");
    }

    #[test]
    fn a_method_without_error_says_so() {
        assert!(table().to_string().contains("no error"));
    }
}
