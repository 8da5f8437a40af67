//! Values that a page takes out of what a command printed: `counters / camera_rays`.

use serde_json::Value;

use crate::html::escape;
use crate::number::Format;

/// Which value, or which quotient of two, and how to write it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Query {
    path: Vec<String>,
    per: Option<Vec<String>>,
    format: Format,
}

impl Query {
    /// Reads `path` or `path per path`, and a format.
    pub fn parse(text: &str, format: Option<&str>) -> Result<Self, String> {
        let steps = |text: &str| -> Vec<String> {
            text.split('/').map(str::trim).filter(|step| !step.is_empty()).map(Into::into).collect()
        };
        let (path, per) = match text.split_once(" per ") {
            Some((path, per)) => (steps(path), Some(steps(per))),
            None => (steps(text), None),
        };
        if path.is_empty() || per.as_ref().is_some_and(Vec::is_empty) {
            return Err("a value is written COMMAND -> PATH, such as \
                 `ray-casting --size 320x240 -> counters / camera_rays`"
                .into());
        }
        // A short second path means a neighbour of the first value.
        let per = per.map(|per| match path.len().checked_sub(per.len()) {
            Some(missing) => path[..missing].iter().cloned().chain(per).collect(),
            None => per,
        });
        Ok(Self { path, per, format: format.map_or(Ok(Format::Default), Format::parse)? })
    }

    /// The value in `root`, as HTML.
    pub fn answer(&self, root: &Value) -> Result<String, String> {
        let value = lookup(root, &self.path)?;
        match (&self.per, value) {
            (None, Value::String(text)) => Ok(escape(text)),
            (None, Value::Bool(flag)) => Ok(flag.to_string()),
            (None, value) => Ok(self.format.write(number(value, &self.path)?)),
            (Some(per), value) => {
                let divisor = number(lookup(root, per)?, per)?;
                Ok(self.format.write(number(value, &self.path)? / divisor))
            }
        }
    }
}

fn number(value: &Value, path: &[String]) -> Result<f64, String> {
    value.as_f64().ok_or_else(|| format!("'{}' is {value}, not a number", path.join(" / ")))
}

/// Goes down by keys of objects; in a list by position or by an entry's own name.
fn lookup<'a>(root: &'a Value, path: &[String]) -> Result<&'a Value, String> {
    let mut value = root;
    for step in path {
        let next = match value {
            Value::Object(map) => map.get(step),
            Value::Array(list) => match step.parse::<usize>() {
                Ok(index) => list.get(index),
                Err(_) => list.iter().find(|entry| is_called(entry, step)),
            },
            _ => None,
        };
        value = next.ok_or_else(|| {
            format!("there is no '{step}' of '{}'; there is: {}", path.join(" / "), names(value))
        })?;
    }
    Ok(value)
}

const NAME_KEYS: [&str; 3] = ["id", "name", "effect"];

fn is_called(entry: &Value, name: &str) -> bool {
    entry == name || NAME_KEYS.iter().any(|key| entry.get(key).is_some_and(|value| value == name))
}

/// What could have been asked of `value`.
fn names(value: &Value) -> String {
    match value {
        Value::Object(map) => map.keys().cloned().collect::<Vec<_>>().join(", "),
        Value::Array(list) => {
            let name = |entry: &Value| NAME_KEYS.iter().find_map(|key| entry.get(key)).cloned();
            let names = list.iter().map(|entry| match name(entry).unwrap_or(entry.clone()) {
                Value::String(name) => name,
                other => other.to_string(),
            });
            names.collect::<Vec<_>>().join(", ")
        }
        other => format!("only {other}"),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::Query;

    fn ledger() -> Value {
        json!([{"id": "RC-01", "trials": 4000, "naive_failures": 130, "input": "a < b"}])
    }

    fn answer(path: &str, format: Option<&str>) -> Result<String, String> {
        Query::parse(path, format)?.answer(&ledger())
    }

    #[test]
    fn values_are_found_by_name() {
        assert_eq!(answer("RC-01 / trials", None).as_deref(), Ok("4,000"));
        assert_eq!(answer("/RC-01/trials", Some("plain")).as_deref(), Ok("4000"));
        assert_eq!(answer("RC-01 / input", None).as_deref(), Ok("a &lt; b"));
    }

    #[test]
    fn a_quotient_may_name_a_neighbour_in_short() {
        let percent = Some("percent");
        let short = answer("RC-01 / naive_failures per trials", percent);
        assert_eq!(short.as_deref(), Ok("3.2 %"));
        assert_eq!(answer("RC-01 / naive_failures per RC-01 / trials", percent), short);
    }

    #[test]
    fn what_is_not_there_is_refused_with_what_is() {
        let wrong = answer("RC-02 / trials", None);
        assert!(wrong.is_err_and(|why| why.contains("'RC-02'") && why.contains("there is: RC-01")));
        assert!(answer("RC-01 / trial", None).is_err_and(|why| why.contains("naive_failures")));
        assert!(answer("RC-01 / input per trials", None).is_err());
        assert!(answer("", None).is_err());
    }
}
