//! A chapter's measured experiments as the book keeps and shows them.

use common::cost::{self, Experiment, chart};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};

use crate::html;
use crate::number::significant;

/// Timed rounds, as `cost` has by default.
const ROUNDS: usize = 7;

/// A measured experiment.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Sheet {
    /// Its short name.
    pub name: String,
    title: String,
    work_unit: String,
    error_metric: String,
    note: String,
    rows: Vec<Row>,
    /// The table as the chapter prints it.
    pub printed: String,
    plot: String,
}

/// A measured method; times in milliseconds for one run, and in nanoseconds for a unit of work.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Row {
    label: String,
    work: u64,
    milliseconds: f64,
    fastest: f64,
    slowest: f64,
    nanoseconds: f64,
    error: f64,
    /// 1/(error² · seconds); nothing for a method without error.
    efficiency: Option<f64>,
}

/// Measures experiments, as `cost` does, and draws their plots.
pub fn measure(experiments: Vec<Experiment>) -> Result<Vec<Sheet>, String> {
    experiments.into_iter().map(sheet).collect()
}

fn sheet(experiment: Experiment) -> Result<Sheet, String> {
    let table = cost::measure(experiment, ROUNDS);
    let plot = chart::svg(std::slice::from_ref(&table)).map_err(|error| error.to_string())?;
    let rows = table.rows.iter().map(|row| Row {
        label: row.label.clone(),
        work: row.work,
        milliseconds: row.time.median,
        fastest: row.time.low,
        slowest: row.time.high,
        nanoseconds: row.nanoseconds(),
        error: row.error,
        efficiency: Some(row.efficiency()).filter(|value| value.is_finite()),
    });
    Ok(Sheet {
        name: table.name.into(),
        title: table.title.into(),
        work_unit: table.work_unit.into(),
        error_metric: table.error_metric.into(),
        note: table.note.clone(),
        rows: rows.collect(),
        printed: table.to_string(),
        plot,
    })
}

/// The values a page can take out: experiment, label, column.
pub fn values(sheets: &[Sheet]) -> Value {
    let rows = |sheet: &Sheet| -> Map<String, Value> {
        sheet.rows.iter().map(|row| (row.label.clone(), json!(row))).collect()
    };
    let map: Map<String, Value> =
        sheets.iter().map(|sheet| (sheet.name.clone(), Value::Object(rows(sheet)))).collect();
    Value::Object(map)
}

impl Sheet {
    /// The table, the plot and the note, as HTML.
    pub fn html(&self, command: &str) -> Result<String, String> {
        let Self { title, work_unit, error_metric, note, .. } = self;
        let head = [
            "method".into(),
            html::escape(work_unit),
            "median, ms".into(),
            "spread, ms".into(),
            "ns per unit".into(),
            "error".into(),
            "1/(MSE × s)".into(),
        ];
        let rows: Vec<Vec<String>> = self.rows.iter().map(Row::cells).collect();
        let numbers = [false, true, true, true, true, true, true];
        let plot = html::inline_svg(&self.plot, &format!("Plot: {title}"))?;
        let (title, note) = (html::escape(title), html::escape(note));
        let note = if note.is_empty() { note } else { format!("<p>{note}</p>\n") };
        Ok(format!(
            "<figure class=\"cost\">\n<p><strong>{title}</strong>. Work is counted in {}; error is \
             {}.</p>\n{}\n{plot}\n<figcaption>{note}<code>{}</code></figcaption>\n</figure>",
            html::escape(work_unit),
            html::escape(error_metric),
            html::table(&head, &rows, &numbers),
            html::escape(command),
        ))
    }
}

impl Row {
    fn cells(&self) -> Vec<String> {
        let digits = |value| significant(value, 3);
        vec![
            html::escape(&self.label),
            crate::number::Format::Default.write(self.work as f64),
            digits(self.milliseconds),
            format!("{} to {}", digits(self.fastest), digits(self.slowest)),
            digits(self.nanoseconds),
            digits(self.error),
            self.efficiency.map_or("no error".into(), digits),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::{measure, values};
    use crate::fake::CHAPTERS;

    #[test]
    fn an_experiment_becomes_a_table_and_a_plot() {
        let sheets = measure((CHAPTERS[0].cost)()).expect("it can be plotted");
        let html = sheets[0].html("cargo run --release -p fake -- cost").expect("it can be shown");
        for part in ["Sums &amp; more", "naive, f32", "no error", "<svg", "2 methods.", "-- cost"] {
            assert!(html.contains(part), "{part}: {html}");
        }
        assert!(!html.contains("\n\n"), "a blank line ends a block of HTML");
        assert_eq!(values(&sheets)["sums"]["naive, f32"]["error"], 0.25);
    }
}
