//! What a page knows of each event to answer a filter, as `/kind=cell object=A` in a terminal: the values of its line that
//! are words, names or whole numbers.

use std::collections::HashMap;

use serde::Serialize;

use crate::page::forms::distances;
use crate::step::StepLog;
use crate::trace::{LogNames, value_of};

/// The keys of the log's lines that a page answers for. A number with a fraction is not among them: a terminal finds it.
pub const FILTER_KEYS: [&str; 24] = [
    "kind",
    "object",
    "ray",
    "verdict",
    "outcome",
    "why",
    "roots",
    "root_verdict",
    "near_verdict",
    "far_verdict",
    "purpose",
    "depth",
    "light",
    "visibility",
    "node",
    "parent",
    "slab",
    "cell",
    "action",
    "end",
    "volume",
    "dropped",
    "part",
    "decided_by",
];

/// What a filter looks at.
#[derive(Debug, Serialize)]
pub(super) struct FilterFace {
    /// The values of a key, by event.
    columns: Vec<Column>,
    /// The step to stand at for an event: the distance from its leaf.
    landing: Vec<isize>,
    /// The largest step that an event leads: the distance from its leaf.
    led: Vec<isize>,
}

#[derive(Debug, Serialize)]
struct Column {
    key: &'static str,
    /// Each value once, without quotation marks and brackets; the first stands for none.
    values: Vec<String>,
    /// The place of each event's value among them: the distance from that of the event before.
    places: Vec<isize>,
}

impl FilterFace {
    pub(super) fn of(log: &StepLog) -> Self {
        let names = LogNames::new(log.scene);
        let column = |key: &'static str| {
            let mut values = vec![String::new()];
            let mut known: HashMap<Vec<u8>, usize> = HashMap::new();
            let mut text = Vec::new();
            let places = log.records.iter().map(|record| {
                if !value_of(record, &names, key, &mut text) {
                    return 0;
                }
                if let Some(place) = known.get(&text) {
                    return *place;
                }
                values.push(bare(&text));
                known.insert(text.clone(), values.len() - 1);
                values.len() - 1
            });
            let places = distances(places);
            Column {
                key,
                values,
                places,
            }
        };
        let columns = FILTER_KEYS.into_iter().map(column);
        let events = 0..log.records.len();
        let from_leaf =
            |event: usize, step: usize| step.cast_signed() - log.leaf(event).cast_signed();
        Self {
            columns: columns.filter(|column| 1 < column.values.len()).collect(),
            landing: events
                .clone()
                .map(|event| from_leaf(event, log.landing(event)))
                .collect(),
            led: events
                .map(|event| from_leaf(event, log.led_by(event)))
                .collect(),
        }
    }
}

/// A value of a line without its quotation marks or brackets.
fn bare(value: &[u8]) -> String {
    if let Ok(text) = serde_json::from_slice::<String>(value) {
        return text;
    }
    let text = String::from_utf8_lossy(value);
    text.trim_start_matches('[').trim_end_matches(']').into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_stands_without_its_quotation_marks_or_brackets() {
        assert_eq!(bare(br#""a \"b\" [c]""#), "a \"b\" [c]");
        assert_eq!(bare(b"[1,0,2]"), "1,0,2");
        assert_eq!(bare(b"7"), "7");
    }
}
