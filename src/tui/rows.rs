//! The rows of the tree around the step where the reader stands.
//!
//! The steps that hold it are open, and it is itself, and no others: so a row is found from its neighbour, and a log of any length costs what is
//! visible.

use crate::step::StepLog;

/// A row of the tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Row {
    /// The step.
    pub(super) step: usize,
    /// How many steps hold it.
    pub(super) depth: usize,
    /// Are the steps that it holds in the rows below?
    pub(super) is_open: bool,
}

/// So many rows at most, with the step among them, as near to the middle as the ends of the tree allow.
pub(super) fn rows(log: &StepLog, here: usize, height: usize) -> Vec<Row> {
    let open: Vec<usize> = std::iter::once(here).chain(log.above(here)).collect();
    let is_open = |step: usize| open.contains(&step) && !log.step(step).is_leaf();
    let above = std::iter::successors(before(log, here, &is_open), |&row| {
        before(log, row, &is_open)
    });
    let below = std::iter::successors(behind(log, here, &is_open), |&row| {
        behind(log, row, &is_open)
    });
    let room = height.saturating_sub(1);
    let above: Vec<usize> = above.take(room).collect();
    let below: Vec<usize> = below.take(room).collect();
    let count = above
        .len()
        .min((room / 2).max(room.saturating_sub(below.len())));
    let steps = above[..count].iter().rev().copied();
    let steps = steps.chain([here]).chain(below).take(height);
    let row = |step: usize| Row {
        step,
        depth: log.above(step).count(),
        is_open: is_open(step),
    };
    steps.map(row).collect()
}

/// The steps beside one, itself among them.
fn siblings(log: &StepLog, step: usize) -> std::ops::Range<usize> {
    match log.step(step).parent {
        Some(parent) => log.step(parent).children.clone(),
        None => log.sections(),
    }
}

/// The row above.
fn before(log: &StepLog, step: usize, is_open: &dyn Fn(usize) -> bool) -> Option<usize> {
    if step == siblings(log, step).start {
        return log.step(step).parent;
    }
    let mut last = step - 1;
    while is_open(last) {
        last = log.step(last).children.end - 1;
    }
    Some(last)
}

/// The row below.
fn behind(log: &StepLog, step: usize, is_open: &dyn Fn(usize) -> bool) -> Option<usize> {
    if is_open(step) {
        return Some(log.step(step).children.start);
    }
    let with_above = std::iter::once(step).chain(log.above(step));
    with_above
        .map(|step| step + 1..siblings(log, step).end)
        .find_map(|mut rest| rest.next())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::{scene_of, sphere};
    use crate::strategy::Chosen;
    use crate::trace::{Settings, StrategyName};
    use crate::tracer::Tracer;
    use crate::tracer::entry::record_pixel;

    /// All rows from the top, by walking through the whole tree.
    fn all(log: &StepLog, here: usize) -> Vec<usize> {
        fn below(
            log: &StepLog,
            steps: std::ops::Range<usize>,
            open: &[usize],
            all: &mut Vec<usize>,
        ) {
            for step in steps {
                all.push(step);
                if open.contains(&step) {
                    below(log, log.step(step).children.clone(), open, all);
                }
            }
        }
        let open: Vec<usize> = log.above(here).chain([here]).collect();
        let mut all = Vec::new();
        below(log, log.sections(), &open, &mut all);
        all
    }

    #[test]
    fn the_rows_are_a_window_of_the_whole_tree_with_the_step_in_it() {
        let shapes: Vec<String> = (-6..6)
            .map(|x| sphere([f64::from(x), 0.0, -5.0], 0.8))
            .collect();
        let scene = scene_of(&shapes);
        let settings = Settings {
            strategy: StrategyName::Hierarchy,
            building: true,
            ..Settings::default()
        };
        let strategy = Chosen::new(&scene, settings.strategy, &settings.structure).unwrap();
        let tracer = Tracer::new(&scene, &strategy, settings.transport);
        let records = record_pixel(&tracer, [0, 0], settings.through, true, 10_000).unwrap();
        let log = StepLog::new(&scene, &settings, &records);
        assert!(30 < log.steps().len());
        for here in 0..log.steps().len() {
            let all = all(&log, here);
            for height in [1, 2, 5, 12, 1000] {
                let rows = rows(&log, here, height);
                let steps: Vec<usize> = rows.iter().map(|row| row.step).collect();
                assert_eq!(steps.len(), height.min(all.len()), "{here} {height}");
                let first = all.iter().position(|step| *step == steps[0]).unwrap();
                assert_eq!(steps, all[first..first + steps.len()], "{here} {height}");
                assert!(steps.contains(&here));
            }
        }
        // in the middle where there is enough on both sides
        let here = log.leaf(records.len() / 2);
        let place = rows(&log, here, 5).iter().position(|row| row.step == here);
        assert_eq!(place, Some(2));
    }
}
