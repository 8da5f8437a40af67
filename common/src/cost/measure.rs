//! The clock: methods take turns, and the median counts.

use std::time::Instant;

use super::{Experiment, Row, Table, Time};

/// Runs every method once to warm up, then `rounds` times in turn, and keeps the medians.
pub fn measure(mut experiment: Experiment, rounds: usize) -> Table {
    let mut times = vec![Vec::with_capacity(rounds); experiment.methods.len()];
    for round in 0..=rounds {
        for (method, times) in experiment.methods.iter_mut().zip(&mut times) {
            let start = Instant::now();
            (method.run)();
            if round > 0 {
                times.push(start.elapsed().as_secs_f64() * 1e3);
            }
        }
    }
    let rows = experiment.methods.into_iter().zip(times).map(|(method, times)| Row {
        label: method.label,
        series: method.series,
        size: method.size,
        work: method.work,
        error: method.error,
        time: summary(times),
    });
    let mut table = Table {
        name: experiment.name,
        title: experiment.title,
        work_unit: experiment.work_unit,
        error_metric: experiment.error_metric,
        plot: experiment.plot,
        rows: rows.collect(),
        note: String::new(),
    };
    table.note = (experiment.note)(&table);
    table
}

/// The median and the range of at least one time.
fn summary(mut times: Vec<f64>) -> Time {
    times.sort_by(f64::total_cmp);
    match times[..] {
        [] => Time { median: 0.0, low: 0.0, high: 0.0 },
        [low, .., high] => Time { median: times[times.len() / 2], low, high },
        [only] => Time { median: only, low: only, high: only },
    }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;

    use super::{measure, summary};
    use crate::cost::{Experiment, Method, Plot, no_note};

    #[test]
    fn the_median_of_an_odd_number_of_rounds() {
        let time = summary(vec![9.0, 1.0, 4.0]);
        assert_eq!((time.low, time.median, time.high), (1.0, 4.0, 9.0));
    }

    #[test]
    fn methods_take_turns_after_a_warm_up() {
        let log = RefCell::new(String::new());
        let method = |label: &'static str| Method {
            label: label.into(),
            series: label,
            size: 0.0,
            work: 1,
            error: 0.0,
            run: Box::new(|| *log.borrow_mut() += label),
        };
        let experiment = Experiment {
            name: "turns",
            title: "Turns",
            work_unit: "runs",
            error_metric: "none",
            plot: Plot::ErrorOverTime("error"),
            methods: vec![method("a"), method("b")],
            note: no_note,
        };
        assert_eq!(measure(experiment, 3).rows.len(), 2);
        assert_eq!(*log.borrow(), "abababab");
    }
}
