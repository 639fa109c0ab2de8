//! A number of a trace by its path: `sphere_test[0].discriminant`, `cell.count`, `counts.tests.sphere_test.tests`.

use serde_json::{Map, Value, json};

use crate::book::html::shortened;
use crate::explain::{counts_json, shown};
use crate::figure::Traced;
use crate::scene::{nearest_name, quoted};
use crate::trace::{Counts, LogNames, Recorder, write_event};

/// How many digits a number has in prose, as in the worked solution.
const DIGITS: u32 = 6;

/// What a path finds, as prose has it.
///
/// # Errors
/// There is no such thing; what is there instead is said.
pub(super) fn value(
    traced: &Traced,
    pixel: Option<[u32; 2]>,
    path: &str,
) -> Result<String, String> {
    let document = document(traced, pixel);
    let mut at = &document;
    let mut so_far = String::new();
    let steps = path
        .split(['.', '['])
        .map(|step| step.trim_end_matches(']'));
    let steps: Vec<&str> = steps.collect();
    for (place, step) in steps.iter().enumerate() {
        let is_last = place + 1 == steps.len();
        if let (Value::Array(list), "count", true) = (at, *step, is_last) {
            return Ok(list.len().to_string());
        }
        at = next(at, step).map_err(|why| {
            if so_far.is_empty() {
                why
            } else {
                format!("in {so_far} {why}")
            }
        })?;
        if step.parse::<usize>().is_ok() {
            so_far = format!("{so_far}[{step}]");
        } else if so_far.is_empty() {
            so_far.push_str(step);
        } else {
            so_far = format!("{so_far}.{step}");
        }
    }
    match at {
        Value::Number(number) => Ok(match number.as_u64() {
            Some(count) => count.to_string(),
            None => shown(number.as_f64().unwrap_or_default(), DIGITS),
        }),
        Value::String(text) => Ok(text.clone()),
        Value::Bool(true) => Ok("yes".into()),
        Value::Bool(false) => Ok("no".into()),
        Value::Array(list) if list.iter().all(Value::is_number) => {
            let numbers = list
                .iter()
                .map(|of| shown(of.as_f64().unwrap_or_default(), DIGITS));
            Ok(format!("({})", numbers.collect::<Vec<_>>().join(", ")))
        }
        Value::Array(list) => Err(format!(
            "{path} is a list of {}\n  choose one, as in {path}[0], or say {path}.count",
            list.len()
        )),
        Value::Object(map) => Err(format!(
            "{path} has several values\n  choose among {}",
            keys(map)
        )),
        Value::Null => Err(format!("{path} has no value")),
    }
}

/// The events of the pixel by kind, as the log has them, and their counts.
fn document(traced: &Traced, pixel: Option<[u32; 2]>) -> Value {
    let names = LogNames::new(&traced.scene);
    let mut document = Map::new();
    let mut counts = Counts::default();
    let of_pixel = traced
        .records
        .iter()
        .filter(|of| of.pixel.is_none() || of.pixel == pixel);
    for record in of_pixel {
        counts.note(|| record.event);
        let mut line = Vec::new();
        write_event(record, &names, &mut line);
        let event: Value = serde_json::from_slice(&line).unwrap_or_default();
        let kind = record.event.kind().name();
        let list = document.entry(kind).or_insert_with(|| json!([]));
        if let Value::Array(list) = list {
            list.push(event);
        }
    }
    document.insert("counts".into(), counts_json(&counts));
    Value::Object(document)
}

fn next<'a>(at: &'a Value, step: &str) -> Result<&'a Value, String> {
    match at {
        Value::Object(map) => map.get(step).ok_or_else(|| {
            let near = nearest_name(step, map.keys().map(String::as_str));
            match near {
                Some(near) => format!("there is no {}\n  did you mean {near}?", quoted(step)),
                None => format!("there is no {}\n  there are {}", quoted(step), keys(map)),
            }
        }),
        Value::Array(list) => {
            let found = step.parse::<usize>().ok().and_then(|place| list.get(place));
            found.ok_or_else(|| match list.len().checked_sub(1) {
                Some(last) => format!(
                    "there is no [{}]\n  the indices are 0 to {last}",
                    shortened(step, 40)
                ),
                None => "the list is empty".into(),
            })
        }
        _ => Err(format!(
            "this value has no parts, so no {}\n  shorten the path",
            quoted(step)
        )),
    }
}

fn keys(map: &Map<String, Value>) -> String {
    let keys: Vec<&str> = map.keys().map(String::as_str).collect();
    keys.join(", ")
}
