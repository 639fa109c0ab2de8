//! The tables of the moves lead where the cursor goes.

use raystep::step::{Cursor, Level, Move, StepLog};

use super::{each_of_few, each_random};

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
