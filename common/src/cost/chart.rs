//! Tables as plots: SVG with labelled axes, in colours that can be read in light and in dark.

use plotters::prelude::{
    BindKeyPoints, ChartBuilder, Circle, DrawingArea, EmptyElement, IntoDrawingArea, IntoLogRange,
    LineSeries, PathElement, SVGBackend, SeriesLabelPosition,
};
use plotters::style::{BLACK, Color, IntoFont, RGBColor, TRANSPARENT};

use super::axis::Axis;
use super::{Plot, Row, Table};

/// Each series has a colour of its own (Okabe and Ito's palette, told apart by the colour-blind).
/// After the seventh they come round again, with hollow dots.
const PALETTE: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(128, 128, 128),
];

const WIDTH: u32 = 720;
const HEIGHT: u32 = 420;

/// One plot a table, one below the other.
///
/// Lines and words have the colour of the text around the picture, so it can be set into a light
/// or a dark page.
pub fn svg(tables: &[Table]) -> Result<String, ChartError> {
    let mut text = String::new();
    {
        let size = (WIDTH, HEIGHT * tables.len() as u32);
        let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
        for (panel, table) in area.split_evenly((tables.len(), 1)).iter().zip(tables) {
            draw(panel, table).map_err(|error| ChartError(error.to_string()))?;
        }
        // Once, after the last panel: this ends the file.
        area.present().map_err(|error| ChartError(error.to_string()))?;
    }
    Ok(text.replace("#000000", "currentColor"))
}

/// The plot could not be drawn.
#[derive(Debug, thiserror::Error)]
#[error("the plot can't be drawn: {0}")]
pub struct ChartError(String);

type Panel<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;
type DrawError = Box<dyn std::error::Error>;

/// What goes on the axes.
struct Axes {
    x_label: String,
    y_label: String,
    x: fn(&Row) -> f64,
    y: fn(&Row) -> f64,
}

fn axes(table: &Table) -> Axes {
    match table.plot {
        Plot::ErrorOverTime(error) => Axes {
            x_label: format!("nanoseconds per unit ({})", table.work_unit),
            y_label: error.into(),
            x: Row::nanoseconds,
            y: |row| row.error,
        },
        Plot::Convergence(error) => Axes {
            x_label: "milliseconds (median)".into(),
            y_label: error.into(),
            x: |row| row.time.median,
            y: |row| row.error,
        },
        Plot::TimeOver(size) => Axes {
            x_label: size.into(),
            y_label: "milliseconds (median)".into(),
            x: |row| row.size,
            y: |row| row.time.median,
        },
        Plot::ErrorOver { size, error } => Axes {
            x_label: size.into(),
            y_label: error.into(),
            x: |row| row.size,
            y: |row| row.error,
        },
    }
}

fn draw(panel: &Panel, table: &Table) -> Result<(), DrawError> {
    let axes = axes(table);
    let across = Axis::of(table.rows.iter().map(axes.x), 0.1);
    let upwards = Axis::of(table.rows.iter().map(axes.y), 0.07);
    let x_range = across.range.clone().log_scale().with_key_points(across.ticks.clone());
    let y_range = upwards.range.clone().log_scale().with_key_points(upwards.ticks.clone());
    let floor = upwards.range.start;
    let mut chart = ChartBuilder::on(panel)
        .caption(table.title, ("sans-serif", 18).into_font())
        .margin(12)
        // The last label is centred on the frame's end.
        .margin_right(36)
        .x_label_area_size(48)
        .y_label_area_size(84)
        .build_cartesian_2d(x_range, y_range)?;
    chart
        .configure_mesh()
        .x_desc(&axes.x_label)
        .y_desc(&axes.y_label)
        .axis_desc_style(("sans-serif", 14))
        .label_style(("sans-serif", 12))
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.15))
        .x_label_formatter(&|value| across.label(*value))
        .y_label_formatter(&|value| upwards.label(*value))
        .draw()?;
    for (index, series) in series(table).into_iter().enumerate() {
        let color = PALETTE[index % PALETTE.len()];
        // A colour that comes round again is hollow.
        let first = index < PALETTE.len();
        let dot = if first { color.filled() } else { color.stroke_width(2) };
        let points: Vec<(f64, f64)> = table
            .rows
            .iter()
            .filter(|row| name(table, row) == series)
            .map(|row| ((axes.x)(row), (axes.y)(row).max(floor)))
            .collect();
        chart
            .draw_series(LineSeries::new(points.clone(), color.stroke_width(2)))?
            .label(&series)
            .legend(move |place| {
                let line = PathElement::new([(0, 0), (18, 0)], color.stroke_width(1));
                EmptyElement::at(place) + line + Circle::new((9, 0), 4, dot)
            });
        chart.draw_series(points.iter().map(|&point| Circle::new(point, 4, dot)))?;
    }
    chart
        .configure_series_labels()
        .position(legend(table.plot))
        .label_font(("sans-serif", 13))
        .border_style(BLACK.mix(0.3))
        .draw()?;
    Ok(())
}

/// Where the legend covers nothing: curves of time over size rise to the right, those of an error fall.
fn legend(plot: Plot) -> SeriesLabelPosition {
    match plot {
        Plot::ErrorOverTime(_) | Plot::Convergence(_) | Plot::ErrorOver { .. } => {
            SeriesLabelPosition::UpperRight
        }
        Plot::TimeOver(_) => SeriesLabelPosition::UpperLeft,
    }
}

/// The curve a row belongs to.
fn name(table: &Table, row: &Row) -> String {
    match table.plot {
        Plot::ErrorOverTime(_) => row.label.clone(),
        Plot::Convergence(_) | Plot::TimeOver(_) | Plot::ErrorOver { .. } => row.series.into(),
    }
}

/// The names of the curves, in the order they first appear.
fn series(table: &Table) -> Vec<String> {
    let mut names = Vec::new();
    for row in &table.rows {
        let name = name(table, row);
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

#[cfg(test)]
mod tests {
    use super::super::{Plot, Row, Table, Time};
    use super::svg;

    fn table(plot: Plot) -> Table {
        let row = |label: &str, error: f64, median: f64| Row {
            label: label.into(),
            series: "one",
            size: median,
            work: 1000,
            error,
            time: Time { median, low: median, high: median },
        };
        Table {
            name: "test",
            title: "A test",
            work_unit: "tests",
            error_metric: "nothing",
            plot,
            rows: vec![row("fast", 0.0, 3.1), row("slow", 0.25, 4.9)],
            note: String::new(),
        }
    }

    #[test]
    fn several_tables_make_one_whole_picture() {
        let tables = [Plot::ErrorOverTime("error"), Plot::TimeOver("size")].map(table);
        let text = svg(&tables).expect("it can be drawn");
        assert_eq!(text.matches("</svg>").count(), 1);
        assert!(text.trim_end().ends_with("</svg>"), "{text}");
        assert!(text.contains("\n0\n"), "the label of no error: {text}");
    }

    #[test]
    fn an_error_that_falls_with_time_is_a_curve_a_series() {
        let text = svg(&[table(Plot::Convergence("error (RMS)"))]).expect("it can be drawn");
        assert!(text.contains("\nmilliseconds (median)\n"), "{text}");
        assert!(text.contains("\none\n") && !text.contains("\nfast\n"), "one curve: {text}");
    }

    #[test]
    fn an_error_over_sizes_is_a_curve_a_series() {
        let text = svg(&[table(Plot::ErrorOver { size: "samples", error: "error (RMS)" })]);
        let text = text.expect("it can be drawn");
        assert!(text.contains("\nsamples\n") && text.contains("\nerror (RMS)\n"), "{text}");
        assert!(text.contains("\none\n") && !text.contains("\nfast\n"), "one curve: {text}");
    }
}
