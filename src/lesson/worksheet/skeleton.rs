//! What of a trace stays if its numbers change a little: which steps there are, what they are about and how they end.

use std::collections::HashMap;

use serde_json::Value;

use crate::lesson::question::TracedPixel;
use crate::trace::{Kind, LogNames, Record, write_event};

/// Keys whose whole numbers say where something is, and not how large it is.
const PLACES: [&str; 10] = [
    "ray",
    "parent",
    "depth",
    "face",
    "cell",
    "node",
    "edge",
    "crossings",
    "slab",
    "size",
];

/// What is cut off or rounded: two such numbers are often equal by chance.
const COARSE: [&str; 3] = ["pixel", "rgb", "clamped"];

/// Numbers are equal that differ by less than two of these: a million roundings of the coordinates of a lesson.
const EQUAL: f64 = 1e-9;

/// A line for each event: its words, flags and places, which quantities it has, and which of the numbers of its ray are 0, 1, or
/// equal to each other.
///
/// Two traces with the same skeleton take the same decisions, so a sentence that is true of one, such as "the eye is inside the
/// sphere" or "the half-line runs exactly through a corner", is true of the other.
pub(super) fn skeleton(traced: &TracedPixel) -> Vec<String> {
    let names = LogNames::new(&traced.scene);
    let mut known = Known::new();
    let of_record = |record: &Record| {
        if record.event.kind() == Kind::Ray {
            known = Known::new();
        }
        let mut line = Vec::new();
        write_event(record, &names, &mut line);
        let event = serde_json::from_slice(&line);
        event.map_or(String::new(), |event| of_event(event, &mut known))
    };
    traced.records.iter().map(of_record).collect()
}

fn of_event(mut event: Value, known: &mut Known) -> String {
    let Some(fields) = event.as_object_mut() else {
        return String::new();
    };
    for (key, value) in fields.iter_mut() {
        if COARSE.contains(&key.as_str()) {
            *value = Value::Null;
        } else if !PLACES.contains(&key.as_str()) {
            without_size(value, known);
        }
    }
    event.to_string()
}

/// In place of a number stands which number of the ray it is equal to, but for the sign.
fn without_size(value: &mut Value, known: &mut Known) {
    match value {
        Value::Number(number) => {
            *value = known.place(number.as_f64().unwrap_or_default()).into();
        }
        Value::Array(items) => items.iter_mut().for_each(|item| without_size(item, known)),
        _ => {}
    }
}

/// The numbers of a ray so far, in steps of what counts as equal.
struct Known(HashMap<i64, usize>);

impl Known {
    /// 0 and 1, which a text may name.
    fn new() -> Self {
        Self([(step(0.0), 0), (step(1.0), 1)].into())
    }

    /// The place of an equal number, or that of a new one.
    fn place(&mut self, number: f64) -> usize {
        let own = step(number);
        let beside = [own, own.saturating_sub(1), own.saturating_add(1)];
        let place = beside.iter().find_map(|step| self.0.get(step));
        let place = place.copied().unwrap_or(self.0.len());
        self.0.insert(own, place);
        place
    }
}

fn step(number: f64) -> i64 {
    (number.abs() / EQUAL).round() as i64
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn sizes_are_free_but_for_0_and_1_and_what_is_equal() {
        let of = |height: f64, corner: f64, why: &str| {
            let mut known = Known::new();
            let polygon = json!({ "projected": [-0.5, height], "why": why });
            let edge = json!({ "from": [1, corner] });
            [polygon, edge].map(|event| of_event(event, &mut known))
        };
        let through_the_corner = of(0.25, 0.25, "outside");
        assert_eq!(of(0.75, 0.75, "outside"), through_the_corner);
        assert_ne!(of(0.75, 0.25, "outside"), through_the_corner);
        assert_ne!(of(0.0, 0.0, "outside"), through_the_corner);
        assert_ne!(of(0.25, 0.25, "behind"), through_the_corner);
        let cell = |k: u32| of_event(json!({ "cell": [1, k] }), &mut Known::new());
        assert_ne!(cell(2), cell(3));
    }
}
