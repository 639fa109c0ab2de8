//! Logs from which somebody left events out: what is there are steps, and nothing panics.

use raystep::step::{Cursor, Grain, Level, Move, StepLog, StepWords, headline};
use raystep::trace::{Kind, Kinds};
use raystep::{Record, Settings};

use crate::seeded::Seeded;
use crate::worked_solution::ranges::{scenes, traced};

fn check(name: &str, log: &StepLog) {
    let Some(start) = Cursor::at_start(log) else {
        assert!(log.records.is_empty());
        return;
    };
    let mut here = Cursor {
        grain: Grain::EVENTS,
        ..start
    };
    here = here.moved(log, Move::First).unwrap();
    let mut events = 1;
    while let Some(next) = here.moved(log, Move::Over) {
        assert_eq!(next.moved(log, Move::Back), Some(here), "{name}");
        here = next;
        events += 1;
    }
    assert_eq!(events, log.records.len(), "{name}");
    let words = StepWords::new(log);
    for number in (0..log.steps().len()).step_by(11) {
        let at = Cursor::at(log, number);
        assert!(
            at.moved(log, Move::Over)
                .is_none_or(|next| next.moved(log, Move::Back) == Some(at))
        );
        assert!(!headline(log, number).is_empty());
        let _ = words.of(log, number);
        let _ = log.changes(number);
        let _ = log.who_set(number, None);
        for level in Level::ALL {
            let _ = at.at_level(log, level);
        }
    }
}

#[test]
fn of_a_log_with_some_kinds_what_is_there_are_its_steps() {
    let mut random = Seeded::new(5);
    let mut logs = 0;
    for (name, scene, pixels) in scenes() {
        for strategy in super::STRATEGIES {
            let settings = Settings {
                strategy,
                ..Settings::default()
            };
            let records = traced(&scene, &settings, pixels[0]);
            let subsets = [
                vec![Kind::SphereTest, Kind::PlaneTest],
                vec![Kind::Nearest, Kind::RayEnd],
                vec![Kind::SlabTest, Kind::Node, Kind::Listed],
                Kind::ALL
                    .into_iter()
                    .filter(|_| random.index(2) == 0)
                    .collect(),
            ];
            for kinds in subsets {
                let only: Vec<String> = kinds.iter().map(|kind| kind.name().into()).collect();
                let kinds = Kinds::of(&kinds);
                let kept: Vec<Record> = records
                    .iter()
                    .filter(|record| kinds.contains(record.event.kind()))
                    .copied()
                    .collect();
                let settings = Settings {
                    only: Some(only),
                    ..settings.clone()
                };
                check(
                    &format!("{name} {strategy:?}"),
                    &StepLog::new(&scene, &settings, &kept),
                );
                logs += 1;
            }
        }
    }
    assert!(200 < logs, "{logs} logs");
}
