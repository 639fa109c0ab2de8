//! Questions to logs, as `tests/questions/README.md` asks them with jq, DuckDB and pandas: each command of that page
//! runs, and answers as the records do. A tool that is not installed is skipped, with a line that says so.

mod answers;
mod page;
mod tools;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use raystep::trace::Region;
use serde_json::Value;

use crate::cli::run::Folder;
use crate::trace_log::strategies::{ways, with_slabs};
use crate::trace_log::{EXAMPLE, MIXED, all_of, built, log};
use answers::Answers;
use page::Page;
use tools::Tool;

/// The rows of a table.
type Rows = Vec<Vec<Value>>;

/// Do these rows say the same as the records, whatever their order?
#[track_caller]
fn check_rows(tool: &str, number: usize, found: &Rows, expected: &Rows) {
    // pandas has one type of number in a column with gaps: 3 is 3.0 there
    let key = |row: &Vec<Value>| {
        let cells = row.iter().map(|value| match value.as_f64() {
            Some(number) => format!("{number:?}"),
            None => value.to_string(),
        });
        cells.collect::<Vec<_>>().join(" ")
    };
    let sorted = |rows: &Rows| {
        let mut rows: Vec<String> = rows.iter().map(key).collect();
        rows.sort();
        rows
    };
    assert_eq!(
        sorted(found),
        sorted(expected),
        "question {number} with {tool}"
    );
}

/// Asks all questions of the page with one tool.
#[track_caller]
fn check(tool: Tool) {
    let Some(tool) = tool.installed() else { return };
    let page = Page::read();
    let folder = Folder::empty();
    page.make_logs(&folder);
    let answers = Answers::of(&folder);
    let rows = tool.ask(&folder, &page);
    assert_eq!(rows.len(), answers.0.len(), "questions");
    for (i, (found, expected)) in rows.iter().zip(&answers.0).enumerate() {
        check_rows(tool.name(), i + 1, found, expected);
    }
}

#[test]
fn jq_answers_every_question_as_the_records_do() {
    check(Tool::Jq);
}

#[test]
fn duckdb_answers_every_question_as_the_records_do() {
    check(Tool::DuckDb);
}

#[test]
fn pandas_answers_every_question_as_the_records_do() {
    check(Tool::Pandas);
}

#[test]
fn no_answer_is_trivial() {
    let folder = Folder::empty();
    Page::read().make_logs(&folder);
    for (i, rows) in Answers::of(&folder).0.iter().enumerate() {
        assert!(4 <= rows.len(), "question {}: {rows:?}", i + 1);
    }
}

/// What a table of a log must have: its columns, and how many lines there are of each kind.
type Shape = (BTreeSet<String>, BTreeMap<String, u64>);

/// The same by the lines themselves.
fn shape(log: &str) -> Shape {
    let mut columns = BTreeSet::new();
    let mut kinds = BTreeMap::new();
    for line in log.lines() {
        let line: Value = serde_json::from_str(line).unwrap();
        columns.extend(line.as_object().unwrap().keys().cloned());
        *kinds
            .entry(line["kind"].as_str().unwrap().into())
            .or_insert(0) += 1;
    }
    (columns, kinds)
}

#[test]
fn duckdb_reads_every_log_alone_and_all_at_once_with_the_call_of_the_page() {
    // logs with many kinds had one column "json" without field_appearance_threshold and map_inference_threshold
    let Some(tool) = Tool::DuckDb.installed() else {
        return;
    };
    let folder = Folder::empty();
    let mailbox = include_str!("../lessons/12-grid/mailbox.json");
    let scenes = [
        ("example", with_slabs(built(EXAMPLE)), [80, 60]),
        ("mixed", with_slabs(built(MIXED)), [4, 3]),
        ("mailbox", with_slabs(built(mailbox)), [3, 3]),
    ];
    let mut shapes = BTreeMap::new();
    for (name, scene, pixel) in &scenes {
        let region = Region {
            from: *pixel,
            to: *pixel,
        };
        for (way, settings) in ways().into_iter().enumerate() {
            for building in [false, true] {
                let settings = raystep::Settings {
                    building,
                    ..settings.clone()
                };
                let bytes = log(scene, &settings, &all_of(region));
                let file = format!("{name}-{way}-{building}.jsonl");
                fs::write(folder.path(&file), &bytes).unwrap();
                shapes.insert(file, shape(std::str::from_utf8(&bytes).unwrap()));
            }
        }
    }
    let mut all = Shape::default();
    for (columns, kinds) in shapes.values() {
        all.0.extend(columns.iter().cloned());
        for (kind, count) in kinds {
            *all.1.entry(kind.clone()).or_insert(0) += count;
        }
    }
    shapes.insert("*.jsonl".into(), all);

    let found = tool.shapes(&folder, &Page::read(), shapes.keys());
    for ((file, expected), found) in shapes.iter().zip(found) {
        assert_eq!(found, *expected, "{file}");
    }
}
