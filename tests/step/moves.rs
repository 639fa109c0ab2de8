//! The tables of the moves lead where the cursor goes.

use raystep::page::{FILTER_KEYS, PackedPixel};
use raystep::step::{Asked, Cursor, Filter, Level, Move, StepLog};
use raystep::trace::{LineSink, LogNames, Sink};
use serde_json::{Value, json};

use super::{each_of_few, each_random};
use crate::cli::inspect::{steps_of, sums, unpacked};

#[test]
fn the_tables_lead_where_the_cursor_goes() {
    let mut compared = 0;
    let mut check = |name: &str, log: &StepLog| {
        let moves = log.moves();
        let targets = log.targets();
        assert_eq!(moves.from.len(), log.steps().len(), "{name}");
        let every = (log.steps().len() / 60).max(1);
        for (step, from) in moves.from.iter().enumerate().step_by(every) {
            let here = Cursor::at(log, step);
            assert_eq!(moves.grains[from.grain], here.grain, "{name}: {step}");
            // a move away from the grain leads to a step with the grain of its siblings
            let jump = |to: Option<usize>| to.map(|to| Cursor::at(log, to));
            for (to, wanted) in [
                (from.into, here.moved(log, Move::Into)),
                (from.out, here.moved(log, Move::Out)),
                (from.next_leaf, here.moved(log, Move::NextLeaf)),
                (from.previous_leaf, here.moved(log, Move::PreviousLeaf)),
                (from.next_target, here.next_of(log, &targets)),
                (from.previous_target, here.previous_of(log, &targets)),
            ] {
                assert_eq!(jump(to), wanted, "{name}: {step}");
            }
            // along every grain that holds the step
            for (grain, walk) in moves.grains.iter().zip(&moves.walks) {
                let Some(place) = walk.iter().position(|&known| known == step) else {
                    continue;
                };
                let here = Cursor {
                    here: step,
                    grain: *grain,
                };
                let at = |place: Option<usize>| {
                    let here = *walk.get(place?)?;
                    Some(Cursor {
                        here,
                        grain: *grain,
                    })
                };
                for (to, by) in [
                    (at(Some(place + 1)), Move::Over),
                    (at(place.checked_sub(1)), Move::Back),
                    (at(Some(0)), Move::First),
                    (at(walk.len().checked_sub(1)), Move::Last),
                ] {
                    assert_eq!(to, here.moved(log, by), "{name}: {step} {by:?}");
                    compared += 1;
                }
            }
            // a level: the ray or the section around it, or the step of its grain that holds the first event
            for (place, level) in Level::ALL.into_iter().enumerate() {
                let around = match level {
                    Level::Section => from.section,
                    Level::Ray => from.ray,
                    _ => None,
                };
                let there = jump(around).unwrap_or_else(|| {
                    let walk = &moves.walks[moves.levels[place]];
                    let start = log.step(step).events.start;
                    let holds = |&known: &&usize| log.step(*known).events.contains(&start);
                    Cursor {
                        here: *walk.iter().find(holds).unwrap(),
                        grain: moves.grains[moves.levels[place]],
                    }
                });
                assert_eq!(there, here.at_level(log, level), "{name}: {step} {level}");
            }
        }
    };
    each_of_few(&mut check);
    each_random(&mut check);
    assert!(40_000 < compared, "{compared} moves");
}

#[test]
fn what_each_event_changed_is_what_its_leaf_changed() {
    let mut compared = 0;
    let mut check = |name: &str, log: &StepLog| {
        let changes = log.changes_by_event();
        assert_eq!(changes.len(), log.records.len(), "{name}");
        let every = (changes.len() / 60).max(1);
        for (event, changed) in changes.iter().enumerate().step_by(every) {
            assert_eq!(*changed, log.changes(log.leaf(event)), "{name}: {event}");
            compared += changed.len();
        }
    };
    each_of_few(&mut check);
    each_random(&mut check);
    assert!(3000 < compared, "{compared} changes");
}

/// What a page looks up: the tables of its steps are the cursor's moves too.
#[test]
fn the_data_of_a_page_lead_where_the_cursor_goes() {
    let mut compared = 0;
    each_random(|name, log| {
        let packed = PackedPixel::new(log, [0, 0], &[]);
        let mut parts = packed.parts.iter().map(|part| unpacked(part));
        let head = parts.next().unwrap();
        let steps: Vec<Value> = parts.flat_map(|part| steps_of(&part)).collect();
        assert_eq!(steps.len(), log.steps().len(), "{name}");
        let targets = log.targets();
        let moves = log.moves();
        let walks = head["walks"].as_array().unwrap().iter();
        let walks: Vec<Value> = walks.map(sums).collect();
        assert_eq!(json!(walks), json!(moves.walks), "{name}");
        let grain = |place: &Value| moves.grains[place.as_u64().unwrap() as usize];
        for (step, data) in steps.iter().enumerate().step_by(1 + steps.len() / 50) {
            let here = Cursor::at(log, step);
            let place = |to: Option<Cursor>| json!(to.map(|to| to.here));
            for (key, to) in [
                ("out", here.moved(log, Move::Out)),
                ("into", here.moved(log, Move::Into)),
                ("leaf", here.moved(log, Move::NextLeaf)),
                ("leafBack", here.moved(log, Move::PreviousLeaf)),
                ("target", here.next_of(log, &targets)),
                ("targetBack", here.previous_of(log, &targets)),
            ] {
                assert_eq!(data[key], place(to), "{name}: {step} {key}");
            }
            assert_eq!(grain(&data["grain"]), here.grain, "{name}: {step}");
            for (number, level) in Level::ALL.into_iter().enumerate() {
                let there = here.at_level(log, level);
                let [to, of_level] = [0, 1].map(|of| &data["levels"][number][of]);
                assert_eq!(*to, json!(there.here), "{name}: {step} {level}");
                assert_eq!(grain(of_level), there.grain, "{name}: {step} {level}");
            }
            let setter = log.who_set(step, None);
            let who = setter.map(|setter| (log.landing(setter.event), setter.text(log)));
            assert_eq!(data["who"], json!(who), "{name}: {step}");
            compared += 1;
        }
        let leaves: Vec<usize> = (0..log.records.len())
            .map(|event| log.leaf(event))
            .collect();
        assert_eq!(sums(&head["leaves"]), json!(leaves), "{name}");
        check_filter(name, log, &head);
        check_asked(name, log, &head);
    });
    assert!(3000 < compared, "{compared} steps");
}

/// What a filter looks at: each value of the log's lines under its key, and the steps that an event stands for.
fn check_filter(name: &str, log: &StepLog, head: &Value) {
    let names = LogNames::new(log.scene);
    let mut sink = LineSink::new(&names);
    for record in log.records {
        assert!(sink.record(record).is_continue());
    }
    let lines: Vec<Value> = String::from_utf8(sink.lines)
        .unwrap()
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let filter = &head["filter"];
    let columns = filter["columns"].as_array().unwrap();
    for key in FILTER_KEYS {
        let column = columns.iter().find(|column| column["key"] == key);
        let places = column.map(|column| sums(&column["places"]));
        for (event, line) in lines.iter().enumerate() {
            let held = column.map_or("", |column| {
                let place = places.as_ref().unwrap()[event].as_u64().unwrap();
                column["values"][place as usize].as_str().unwrap()
            });
            let expected = match &line[key] {
                Value::Null => String::new(),
                Value::String(text) => text.clone(),
                other => other.to_string().replace(['[', ']'], ""),
            };
            assert_eq!(held, expected, "{name}: {event} {key}");
        }
    }
    let all = |steps: &[i64], key: &str| -> Vec<i64> {
        let by = filter[key].as_array().unwrap().iter();
        by.zip(steps)
            .map(|(by, leaf)| by.as_i64().unwrap() + leaf)
            .collect()
    };
    let leaves: Vec<i64> = (0..lines.len())
        .map(|event| i64::try_from(log.leaf(event)).unwrap())
        .collect();
    let landing: Vec<i64> = (0..lines.len())
        .map(|event| i64::try_from(log.landing(event)).unwrap())
        .collect();
    assert_eq!(all(&leaves, "landing"), landing, "{name}");
    // a kind alone names the steps that its events lead
    let led = all(&leaves, "led");
    for kind in ["sphere_test", "node", "cell", "light_term"] {
        let filter = Filter::new(&[format!("kind={kind}")]).unwrap();
        let mut expected = filter.targets(log);
        let of_kind = lines
            .iter()
            .zip(&led)
            .filter(|(line, _)| line["kind"] == kind);
        let mut found: Vec<usize> = of_kind.map(|(_, step)| *step as usize).collect();
        expected.sort_unstable();
        found.sort_unstable();
        found.dedup();
        assert_eq!(found, expected, "{name}: {kind}");
    }
}

/// The words after `w`: each that is set somewhere, with the names of what it stands for.
fn check_asked(name: &str, log: &StepLog, head: &Value) {
    let asked = head["asked"].as_array().unwrap();
    for word in Asked::words() {
        let last = log.steps().len() - 1;
        let set = (0..log.steps().len())
            .step_by(1 + last / 20)
            .find_map(|step| {
                let setter = log.who_set(step, Asked::named(word))?;
                Some(setter.quantity.name(log.scene))
            });
        let held = asked.iter().find(|held| held[0] == word);
        if let Some(quantity) = set {
            let names = held.unwrap()[1].as_array().unwrap();
            assert!(names.contains(&json!(quantity)), "{name}: {word} {names:?}");
        }
    }
}
