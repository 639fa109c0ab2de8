//! Forwards and backwards are exact inverses at every level; the leaves are the events in their order.

use std::collections::BTreeSet;
use std::ops::Range;

use raystep::Event;
use raystep::step::{Became, Cursor, Grain, Level, Move, StepLog};

use super::{each_lesson, each_random};

/// What is wrong with the tree itself: each step's children hold its events in their order, and each leaf one event.
fn mistake_of_tree(log: &StepLog) -> Option<String> {
    let mut waiting: Vec<usize> = log.sections().rev().collect();
    let mut next = 0;
    let mut seen = 0;
    while let Some(number) = waiting.pop() {
        seen += 1;
        let step = log.step(number);
        if step.is_leaf() {
            if step.events != (next..next + 1) {
                return Some(format!("event {next} is not the next leaf: {step:?}"));
            }
            if log.leaf(next) != number {
                return Some(format!("event {next} has another leaf"));
            }
            next += 1;
            continue;
        }
        let children = step.children.clone();
        let ranges: Vec<Range<usize>> = children
            .clone()
            .map(|child| log.step(child).events.clone())
            .collect();
        let ends = [ranges.first()?.start, ranges.last()?.end];
        let in_a_row = ranges.windows(2).all(|pair| pair[0].end == pair[1].start);
        if ends != [step.events.start, step.events.end] || !in_a_row {
            return Some(format!("children {ranges:?} of {step:?}"));
        }
        if children
            .clone()
            .any(|child| log.step(child).parent != Some(number))
        {
            return Some(format!("a child of {number} has another parent"));
        }
        if !step.events.contains(&step.lead) {
            return Some(format!("is led by another event: {step:?}"));
        }
        waiting.extend(children.rev());
    }
    let all = (next, seen) == (log.records.len(), log.steps().len());
    (!all).then(|| format!("{next} of {} events, {seen} steps", log.records.len()))
}

/// What is wrong with a walk along a grain, from its first step to its last and back.
fn mistake_of_walk(log: &StepLog, start: Cursor) -> Option<String> {
    let mut here = start.moved(log, Move::First)?;
    if log.step(here.here).events.start != 0 || here.moved(log, Move::Back).is_some() {
        return Some(format!("{:?} begins elsewhere", start.grain));
    }
    let mut forwards = vec![here];
    while let Some(next) = here.moved(log, Move::Over) {
        if next.moved(log, Move::Back) != Some(here) {
            return Some(format!("back from {next:?} is not {here:?}"));
        }
        if log.step(next.here).events.start != log.step(here.here).events.end {
            return Some(format!("events are skipped from {here:?} to {next:?}"));
        }
        here = next;
        forwards.push(here);
    }
    if Some(here) != start.moved(log, Move::Last)
        || log.step(here.here).events.end != log.records.len()
    {
        return Some(format!("{:?} ends elsewhere", start.grain));
    }
    let mut backwards = vec![here];
    while let Some(before) = here.moved(log, Move::Back) {
        here = before;
        backwards.push(here);
    }
    backwards.reverse();
    (forwards != backwards).then(|| format!("{:?}: another way back", start.grain))
}

/// What is wrong with the moves in and out of each step, and from event to event.
fn mistake_of_moves(log: &StepLog, grains: &mut BTreeSet<(usize, Level, bool)>) -> Option<String> {
    for number in 0..log.steps().len() {
        let here = Cursor::at(log, number);
        // the grain of a step's siblings holds the step
        let step = log.step(number);
        let back = here
            .moved(log, Move::Over)
            .map(|next| next.moved(log, Move::Back));
        if back.is_some_and(|back| back != Some(here)) {
            return Some(format!("is not in its own grain: {here:?} {step:?}"));
        }
        let Grain {
            rays,
            level,
            unfolded,
        } = here.grain;
        grains.insert((rays, level, unfolded));
        match here.moved(log, Move::Into) {
            None if !step.is_leaf() => return Some(format!("nothing inside of {step:?}")),
            Some(inside) if inside.moved(log, Move::Out) != Some(here) => {
                return Some(format!("out of {inside:?} is not {here:?}"));
            }
            _ => {}
        }
    }
    let mut leaf = Cursor::at(log, log.leaf(0));
    for event in 1..log.records.len() {
        let next = leaf.moved(log, Move::NextLeaf)?;
        if next.here != log.leaf(event) || next.moved(log, Move::PreviousLeaf) != Some(leaf) {
            return Some(format!("the leaf behind {leaf:?} is {next:?}"));
        }
        leaf = next;
    }
    leaf.moved(log, Move::NextLeaf)
        .map(|_| "a leaf behind the last event".into())
}

fn check(name: &str, log: &StepLog) {
    let fail = |what: String| panic!("{name}: {what}");
    mistake_of_tree(log).map(fail);
    let mut grains = BTreeSet::new();
    mistake_of_moves(log, &mut grains).map(fail);
    let own = grains.into_iter().map(|(rays, level, unfolded)| Grain {
        rays,
        level,
        unfolded,
    });
    let of_levels = Level::ALL.map(Grain::of_level);
    for grain in own.chain(of_levels) {
        let here = log.sections().next().unwrap();
        mistake_of_walk(log, Cursor { here, grain }).map(fail);
    }
    // each event by itself is the log
    let mut here = Cursor {
        here: log.leaf(0),
        grain: Grain::EVENTS,
    };
    let mut events = 1;
    while let Some(next) = here.moved(log, Move::Over) {
        assert_eq!(next.here, log.leaf(events), "{name}");
        events += 1;
        here = next;
    }
    assert_eq!(events, log.records.len(), "{name}");
    // a level is reached from everywhere, and holds the first event of where one stood
    for number in (0..log.steps().len()).step_by(7) {
        for level in Level::ALL {
            let at = Cursor::at(log, number).at_level(log, level);
            let start = log.step(number).events.start;
            assert!(log.step(at.here).events.contains(&start), "{name}: {at:?}");
            let back = at
                .moved(log, Move::Over)
                .map(|next| next.moved(log, Move::Back));
            assert!(back.is_none_or(|back| back == Some(at)), "{name}: {at:?}");
        }
    }
}

#[test]
fn over_and_back_are_exact_inverses_at_every_level_of_every_lesson() {
    let logs = each_lesson(check);
    assert!(1000 < logs, "{logs} logs");
}

#[test]
fn over_and_back_are_exact_inverses_in_random_scenes() {
    let logs = each_random(check);
    assert!(100 < logs, "{logs} logs");
}

/// What decides whether siblings are one step, from the records alone: what they are, and what became of them.
fn sort_of(log: &StepLog, number: usize) -> Option<(Level, &'static str, Option<Became>)> {
    let step = log.step(number);
    let became = step.became.map(|became| match became {
        Became::Tested(verdict, _) => Became::Tested(verdict, None),
        other => other,
    });
    let has_ray = log.records[step.events.clone()]
        .iter()
        .any(|record| matches!(record.event, Event::Ray(_) | Event::RayEnd(_)));
    (!has_ray && step.parent.is_some()).then(|| {
        (
            step.level,
            log.records[step.lead].event.kind().name(),
            became,
        )
    })
}

/// Did a step change what decides or shines: the nearest hit, the waiting nodes, the place, a term?
fn changed(log: &StepLog, number: usize) -> bool {
    use raystep::step::Quantity::{Crossings, Mailboxes, MaxNear, MinFar};
    let level = log.step(number).level;
    log.changes(number)
        .iter()
        .any(|change| match change.quantity {
            Mailboxes => false,
            MaxNear | MinFar | Crossings => level == Level::Term,
            _ => true,
        })
}

#[test]
fn three_siblings_of_one_kind_and_verdict_are_one_step_unless_one_changed_the_state() {
    let (mut folds, mut alone) = (0, 0);
    let mut check = |name: &str, log: &StepLog| {
        for (number, step) in log.steps().iter().enumerate() {
            if step.is_fold() {
                folds += 1;
                let members = step.children.clone();
                assert_eq!(members.len(), step.folded, "{name}");
                assert!(3 <= step.folded, "{name}: {step:?}");
                let sort = sort_of(log, members.start);
                assert!(sort.is_some(), "{name}: {step:?}");
                for member in members {
                    assert_eq!(sort_of(log, member), sort, "{name}: {step:?}");
                    assert!(!changed(log, member), "{name}: {:?}", log.step(member));
                }
                continue;
            }
            // no run is left among the others, but where the parent is that step already
            let children: Vec<usize> = step.children.clone().collect();
            let is_group = matches!(step.level, Level::Place | Level::Test);
            for run in children.windows(3) {
                let sorts: Vec<_> = run.iter().map(|&child| sort_of(log, child)).collect();
                let is_run = sorts.iter().all(|sort| sort.is_some() && *sort == sorts[0]);
                let has_fold = run.iter().any(|&child| log.step(child).is_fold());
                if !is_run || has_fold || run.iter().any(|&child| changed(log, child)) {
                    continue;
                }
                let same = children
                    .iter()
                    .all(|&child| sort_of(log, child) == sorts[0]);
                assert!(is_group && same, "{name}: {run:?} of {number} {step:?}");
                alone += 1;
            }
        }
    };
    super::each_of_few(&mut check);
    each_random(&mut check);
    assert!(
        100 < folds && 100 < alone,
        "{folds} folds, {alone} runs alone"
    );
}
