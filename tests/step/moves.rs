//! The tables of the moves lead where the cursor goes.

use raystep::page::PackedPixel;
use raystep::step::{Cursor, Level, Move, StepLog};
use serde_json::{Value, json};

use super::{each_of_few, each_random};
use crate::cli::inspect::unpacked;

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
        let steps: Vec<Value> = parts
            .flat_map(|part| part.as_array().unwrap().clone())
            .collect();
        assert_eq!(steps.len(), log.steps().len(), "{name}");
        let targets = log.targets();
        let moves = log.moves();
        assert_eq!(head["walks"], json!(moves.walks), "{name}");
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
        assert_eq!(head["leaves"], json!(leaves), "{name}");
    });
    assert!(3000 < compared, "{compared} steps");
}
