//! Targets: the next one and the one before are inverses; a filter finds what another way of looking finds; who set a value.

use std::collections::BTreeSet;

use raystep::step::{
    Asked, Command, Cursor, Filter, Interest, Quantity, StepLog, Value, commands, same_place,
};
use raystep::trace::{NodeVerdict, RayVerdict, Verdict, Visibility, Why};
use raystep::{Event, Settings, StrategyName, Transport};

use super::{STRATEGIES, each_of_few, each_random};
use crate::worked_solution::ranges::traced;
use crate::worked_solution::{records, scene};

fn filter(text: &str) -> Filter {
    match commands(text).unwrap().remove(0) {
        Command::Filter(Some(filter)) => filter,
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_next_target_and_the_one_before_are_inverses() {
    let mut moves = 0;
    let mut check = |name: &str, log: &StepLog| {
        let targets = log.targets();
        let mut here = Cursor::at_start(log).unwrap();
        assert_eq!(here.previous_of(log, &targets), None, "{name}");
        let mut seen = Vec::new();
        while let Some(next) = here.next_of(log, &targets) {
            let back = next.previous_of(log, &targets).map(|back| back.here);
            assert_eq!(back, seen.last().copied(), "{name}: {next:?}");
            seen.push(next.here);
            here = next;
            moves += 1;
        }
        assert_eq!(seen, targets, "{name}");
    };
    each_of_few(&mut check);
    each_random(&mut check);
    assert!(5000 < moves, "{moves} moves");
}

/// What is of interest, by another rule: over all events of a kind, or the first of each reason on a ray.
#[test]
fn what_is_of_interest_is_what_the_list_says() {
    let mut seen = BTreeSet::new();
    let mut check = |name: &str, log: &StepLog| {
        let mut reasons: BTreeSet<(Option<u32>, Option<u32>, &str)> = BTreeSet::new();
        let mut expected = Vec::new();
        for (at, record) in log.records.iter().enumerate() {
            let is = match &record.event {
                Event::Nearest(_) => "nearest",
                Event::Node(visit) if visit.verdict == NodeVerdict::Pruned => "pruned",
                Event::Cell(cell) if cell.listed != 0 => "cell",
                Event::Mailbox { .. } => "mailbox",
                Event::HitOutsideCell(_) => "outside",
                Event::Refraction(working) if working.direction.is_none() => "total",
                Event::RayEnd(end) if end.verdict == RayVerdict::Blocked => "blocked",
                Event::RayEnd(end) if end.verdict == RayVerdict::DepthLimit => "depth",
                Event::Arrival(_) | Event::Gathered(_) => "light",
                Event::Connection(line) if line.visible => "light",
                Event::PixelColour(_) => "colour",
                event => match event.verdict() {
                    Some((Verdict::Rejected, Some(Why::Empty))) => "empty",
                    Some((Verdict::Rejected, Some(Why::Parallel))) => "parallel",
                    Some((Verdict::Rejected, Some(why)))
                        if reasons.insert((record.path, record.ray, why.word())) =>
                    {
                        "reason"
                    }
                    _ => continue,
                },
            };
            seen.insert(is);
            expected.push(at);
        }
        let found: Vec<usize> = log.interests().iter().map(|&(at, _)| at).collect();
        assert_eq!(found, expected, "{name}");
    };
    each_of_few(&mut check);
    each_random(&mut check);
    // the rest are rare: a small scene for each is in by_hand
    assert!(11 <= seen.len(), "{seen:?}");
}

#[test]
fn a_filter_finds_what_the_records_say() {
    let mut found_any = [0; 4];
    each_of_few(|name, log| {
        let landings = |wanted: &dyn Fn(&Event) -> bool| {
            let events = log.records.iter().enumerate();
            let wanted = events.filter(|(_, record)| wanted(&record.event));
            let steps: BTreeSet<usize> = wanted.map(|(at, _)| log.landing(at)).collect();
            steps
        };
        let same = |text: &str, wanted: BTreeSet<usize>| {
            let found = filter(text).targets(log);
            let set: BTreeSet<usize> = found.iter().copied().collect();
            assert_eq!(set.len(), found.len(), "{name} {text}");
            assert_eq!(set, wanted, "{name} {text}");
            found.len()
        };
        let rejected = |event: &Event| {
            // the log says so of tests, and of a node that is left out
            let of_node =
                matches!(event, Event::Node(visit) if visit.verdict == NodeVerdict::Rejected);
            of_node || matches!(event.verdict(), Some((Verdict::Rejected, _)))
        };
        let by_field = |event: &Event| matches!(event.verdict(), Some((Verdict::Rejected, _)));
        let word = filter("/rejected").targets(log);
        let wanted = landings(&rejected);
        assert!(wanted.is_subset(&word.iter().copied().collect()), "{name}");
        found_any[0] += same("/verdict=rejected", landings(&by_field));
        let parallel = |event: &Event| matches!(event.verdict(), Some((_, Some(Why::Parallel))));
        found_any[1] += same("/why=parallel", landings(&parallel));
        let shadowed = |event: &Event| matches!(event, Event::LightTerm(term) if term.visibility == Visibility::Shadowed);
        found_any[2] += same("/visibility=shadowed", landings(&shadowed));
        // the cells that list the first object
        let object = &log.scene.objects[0].name;
        let cells = filter(&format!("/kind=cell object=\"{object}\"")).targets(log);
        let mut cell = None;
        let mut wanted = BTreeSet::new();
        for (at, record) in log.records.iter().enumerate() {
            match record.event {
                Event::Cell(_) => cell = Some(at),
                Event::Listed { object } if log.scene.primitive(object).object == 0 => {
                    wanted.extend(cell);
                }
                _ => {}
            }
        }
        let leads: BTreeSet<usize> = cells.iter().map(|&step| log.step(step).lead).collect();
        assert_eq!(leads, wanted, "{name}");
        found_any[3] += cells.len();
    });
    assert!(found_any.iter().all(|&found| 10 < found), "{found_any:?}");
}

/// The object that is tested on each ray does not depend on the strategy: the same place is found in each.
#[test]
fn the_same_place_with_another_strategy_is_the_test_of_the_same_object_on_the_same_ray() {
    let scene = crate::trace_log::built(crate::trace_log::EXAMPLE);
    let of = |strategy| {
        let settings = Settings {
            strategy,
            ..Settings::default()
        };
        let records = traced(&scene, &settings, [80, 60]);
        (settings, records)
    };
    let (settings, records) = of(StrategyName::Exhaustive);
    let log = StepLog::new(&scene, &settings, &records);
    let (mut tests, mut rays) = (0, 0);
    for strategy in STRATEGIES {
        let (settings, records) = of(strategy);
        let other = StepLog::new(&scene, &settings, &records);
        for (number, step) in log.steps().iter().enumerate() {
            let found = other.step(same_place(&log, number, &other).unwrap());
            let lead = &log.records[step.lead];
            let found_lead = &other.records[found.lead];
            if let Event::SphereTest { object, .. } = lead.event
                && let Event::SphereTest { object: same, .. } = found_lead.event
            {
                assert_eq!((object, lead.ray), (same, found_lead.ray));
                tests += 1;
            }
            if let Event::Ray(_) = lead.event {
                assert!(matches!(found_lead.event, Event::Ray(_)), "{found_lead:?}");
                assert_eq!(lead.ray, found_lead.ray);
                rays += 1;
            }
        }
    }
    assert!(6 <= tests && 12 <= rays, "{tests} tests, {rays} rays");
}

/// On paper: M is hit at t = 4 in step 2 and becomes the nearest in 3; "far" is tested in step 6.
#[test]
fn who_set_t_is_the_test_that_found_the_nearest_hit() {
    let scene = scene();
    let records = records(&scene);
    let settings = Settings {
        transport: Transport::HybridLight,
        ..Settings::default()
    };
    let log = StepLog::new(&scene, &settings, &records);
    let at = |step: u32| log.landing(step as usize);
    let setter = log.who_set(at(6), Asked::named("t")).unwrap();
    assert_eq!(setter.quantity, Quantity::Nearest);
    assert_eq!(setter.event, 3);
    let Value::Hit(object, t) = setter.value else {
        panic!("{:?}", setter.value);
    };
    assert_eq!((object.0, t), (0, 4.0));
    // before the test that set it, nobody had
    assert_eq!(log.who_set(at(2), Asked::named("t")), None);
    // the colour of the pixel: the eye ray's end set it
    let colour = records.len() - 1;
    let setter = log.who_set(log.landing(colour), None).unwrap();
    assert_eq!(
        (setter.quantity, setter.event),
        (Quantity::EyeColour, colour - 1)
    );
    // and at that end the last term is what the mirror shows
    let setter = log.who_set(log.landing(colour - 1), None).unwrap();
    assert_eq!(setter.quantity, Quantity::Reflected);
    assert!(matches!(records[setter.event].event, Event::RayEnd(_)));
    assert!(log.interests().contains(&(3, Interest::Nearest)));
}
