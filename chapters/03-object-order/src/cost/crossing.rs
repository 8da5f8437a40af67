//! Where two curves of a plot cross.

use common::cost::{Row, Table};

/// What the plot says about when the series `first` is faster than the series `second`.
pub(super) fn sentence(table: &Table, first: &str, second: &str) -> String {
    let ratios = ratios(&table.rows, first, second);
    if let Some(size) = crossing(&ratios) {
        let sizes = table.name;
        return format!(
            "The curves cross near {size:.0} {sizes}: below that {second} is faster, above it \
             {first}."
        );
    }
    let faster = ratios.iter().map(|ratio| 1.0 / ratio.ratio);
    let least = faster.clone().fold(f64::INFINITY, f64::min);
    let most = faster.fold(0.0, f64::max);
    format!("The curves do not cross: {first} is {least:.0} to {most:.0} times as fast here.")
}

/// A size, and how many times as long the first series takes as the second.
#[derive(Clone, Copy)]
struct Ratio {
    size: f64,
    ratio: f64,
}

/// The sizes that both series have.
fn ratios(rows: &[Row], first: &str, second: &str) -> Vec<Ratio> {
    let of = |series: &str, size: f64| {
        let row = rows.iter().find(|row| row.series == series && row.size == size);
        row.map(|row| row.time.median)
    };
    let sizes = rows.iter().filter(|row| row.series == first).map(|row| row.size);
    sizes
        .filter_map(|size| Some(Ratio { size, ratio: of(first, size)? / of(second, size)? }))
        .collect()
}

/// The size at which two series take equally long, on straight lines between the points of a plot
/// whose axes are both logarithmic. None when they don't cross.
fn crossing(ratios: &[Ratio]) -> Option<f64> {
    ratios.windows(2).find_map(|pair| bisect(pair[0], pair[1]))
}

/// Where the ratio becomes 1. Half way on logarithmic axes is the geometric mean, so square roots
/// are all it takes.
fn bisect(mut low: Ratio, mut high: Ratio) -> Option<f64> {
    if (low.ratio < 1.0) == (high.ratio < 1.0) {
        return None;
    }
    for _ in 0..40 {
        let size = (low.size * high.size).sqrt();
        let middle = Ratio { size, ratio: (low.ratio * high.ratio).sqrt() };
        let same_side = (middle.ratio < 1.0) == (low.ratio < 1.0);
        *(if same_side { &mut low } else { &mut high }) = middle;
    }
    Some(low.size)
}

#[cfg(test)]
mod tests {
    use common::cost::{Row, Time};

    use super::{crossing, ratios};

    fn row(series: &'static str, size: f64, median: f64) -> Row {
        let time = Time { median, low: median, high: median };
        Row { label: series.into(), series, size, work: 1, error: 0.0, time }
    }

    #[test]
    fn curves_cross_where_they_should() {
        // 8 milliseconds whatever the size, against half a millisecond for each: 16.
        let rows = [
            row("flat", 1.0, 8.0),
            row("steep", 1.0, 0.5),
            row("flat", 64.0, 8.0),
            row("steep", 64.0, 32.0),
        ];
        let found = crossing(&ratios(&rows, "flat", "steep")).expect("they cross");
        assert!((found - 16.0).abs() < 1e-6, "{found}");
        assert_eq!(crossing(&ratios(&rows[..3], "flat", "steep")), None);
    }
}
