//! The answers, from the records.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufReader;

use raystep::trace::{NodeVerdict, Verdict, Why};
use raystep::{Event, LogReader, Record, Scene};
use serde_json::{Value, json};

use super::Rows;
use crate::cli::run::Folder;

/// One table for each question, in the order of the page.
pub(super) struct Answers(pub(super) Vec<Rows>);

/// A log that the page makes.
struct Log {
    name: &'static str,
    scene: Scene,
    records: Vec<Record>,
}

impl Log {
    #[track_caller]
    fn read(folder: &Folder, name: &'static str) -> Self {
        let file = BufReader::new(File::open(folder.path(name)).unwrap());
        let reader = LogReader::open(name, file).unwrap();
        Self {
            name,
            scene: reader.scene().clone(),
            records: reader.map(Result::unwrap).collect(),
        }
    }
}

impl Answers {
    #[track_caller]
    pub(super) fn of(folder: &Folder) -> Self {
        let [grid, tree] = ["grid.jsonl", "tree.jsonl"].map(|name| Log::read(folder, name));
        let both = [&grid, &tree];
        Self(vec![
            tests_by_ray(both),
            rejected(both),
            cells(&grid),
            pruned(&tree),
            nearest(&tree),
        ])
    }
}

/// Counts rows that are alike.
fn counted(rows: impl Iterator<Item = Vec<Value>>) -> Rows {
    let mut counts: BTreeMap<String, (Vec<Value>, u32)> = BTreeMap::new();
    for row in rows {
        let entry = counts.entry(json!(row).to_string());
        entry.or_insert((row, 0)).1 += 1;
    }
    let with_count = |(mut row, count): (Vec<Value>, u32)| {
        row.push(count.into());
        row
    };
    counts.into_values().map(with_count).collect()
}

fn tests_by_ray(logs: [&Log; 2]) -> Rows {
    let tests = logs.into_iter().flat_map(|log| {
        let tests = log
            .records
            .iter()
            .filter(|record| record.event.verdict().is_some());
        tests.map(|test| {
            vec![
                json!(log.name),
                json!(test.ray),
                json!(test.event.kind().name()),
            ]
        })
    });
    counted(tests)
}

fn rejected(logs: [&Log; 2]) -> Rows {
    let rejected = logs.into_iter().flat_map(|log| {
        let row = |record: &Record| {
            let (verdict, why) = record.event.verdict()?;
            assert_eq!(verdict == Verdict::Rejected, why.is_some());
            let kind = record.event.kind().name();
            Some(vec![json!(log.name), json!(kind), json!(word(why?))])
        };
        log.records.iter().filter_map(row)
    });
    counted(rejected)
}

/// `BeyondNearest` is "beyond_nearest" in a log.
fn word(why: Why) -> String {
    let mut word = String::new();
    for letter in format!("{why:?}").chars() {
        if letter.is_uppercase() && !word.is_empty() {
            word.push('_');
        }
        word.extend(letter.to_lowercase());
    }
    word
}

fn cells(log: &Log) -> Rows {
    let row = |record: &Record| match record.event {
        Event::Cell(visit) if record.ray == Some(0) => Some(vec![
            json!(record.step),
            json!(visit.step.cell),
            json!(visit.step.t_in),
            json!(visit.step.t_out),
            json!(visit.listed),
        ]),
        _ => None,
    };
    log.records.iter().filter_map(row).collect()
}

fn pruned(log: &Log) -> Rows {
    let mut nearest = BTreeMap::new();
    let mut rows = Vec::new();
    for record in &log.records {
        match record.event {
            Event::Nearest(hit) => {
                nearest.insert(record.ray, hit.t);
            }
            Event::Node(visit) if visit.verdict == NodeVerdict::Pruned => rows.push(vec![
                json!(record.ray),
                json!(record.step),
                json!(visit.node),
                json!(visit.near),
                json!(nearest.get(&record.ray)),
            ]),
            _ => {}
        }
    }
    rows
}

fn nearest(log: &Log) -> Rows {
    let mut before = BTreeMap::new();
    let mut rows = Vec::new();
    for record in &log.records {
        if let Event::Nearest(hit) = record.event {
            let less = before.insert(record.ray, hit.t).map(|t: f64| t - hit.t);
            rows.push(vec![
                json!(record.ray),
                json!(record.step),
                json!(log.scene.name_of(hit.object).0),
                json!(hit.t),
                json!(less),
            ]);
        }
    }
    rows
}
