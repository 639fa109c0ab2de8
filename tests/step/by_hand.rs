//! Small logs, put together by hand.

use raystep::step::{
    Address, Cursor, Interest, Level, Move, Quantity, StepLog, StepWords, Value, headline,
};
use raystep::{Event, Settings, StrategyName};

use crate::worked_solution::ranges::traced;
use crate::worked_solution::{light, records, scene};

/// The tree as an outline: each step indented below the one that holds it, with its events, its level and its title.
fn outline(log: &StepLog) -> Vec<String> {
    let mut lines = Vec::new();
    let mut waiting: Vec<usize> = log.sections().rev().collect();
    while let Some(number) = waiting.pop() {
        let step = log.step(number);
        let depth = log.above(number).count();
        let events = match step.events.len() {
            1 => step.events.start.to_string(),
            _ => format!("{}-{}", step.events.start, step.events.end - 1),
        };
        let indent = "  ".repeat(depth);
        lines.push(format!(
            "{indent}{events} {} {}",
            step.level,
            headline(log, number)
        ));
        waiting.extend(step.children.clone().rev());
    }
    lines
}

/// One pixel on paper: the eye ray hits M, passes "ball" and "far" and runs beside the wall; a shadow ray to the lamp, and a
/// reflected ray that hits the ball behind the eye, with a shadow ray of its own. max_depth is 2: the ball is dull.
#[test]
fn the_paper_pixel_has_the_steps_that_are_counted_by_hand() {
    let scene = scene();
    let records = records(&scene);
    let settings = Settings::default();
    let log = StepLog::new(&scene, &settings, &records);
    let expected = [
        "0-31 section Pixel (0, 0)",
        "  0 term window point",
        "  1-30 ray Ray 0: eye ray, depth 1: hit",
        "    1 term start of ray 0",
        "    2-3 test M: sphere: hit",
        "      2 term M: sphere: hit",
        "      3 term nearest hit: M",
        "    4 test ball: sphere: rejected, behind",
        "    5 test wall: polygon: rejected, parallel",
        "    6 test far: sphere: rejected, no root",
        "    7-12 ray Ray 1: shadow ray to light \"lamp\", spawned by ray 0, depth 2: reaches light",
        "      7 term start of ray 1",
        "      8 test M: sphere: rejected, below epsilon",
        "      9 test ball: sphere: rejected, beyond nearest",
        "      10 test wall: polygon: rejected, parallel",
        "      11 test far: sphere: rejected, no root",
        "      12 term end of ray 1: reaches light",
        "    13 term light \"lamp\": visible",
        "    14 term shade of M",
        "    15-29 ray Ray 2: reflected ray, spawned by ray 0, depth 2: hit",
        "      15 term start of ray 2",
        "      16 test M: sphere: rejected, below epsilon",
        "      17-18 test ball: sphere: hit",
    ];
    let found = outline(&log);
    assert_eq!(found[..expected.len()], expected, "{found:#?}");
    assert_eq!(found.last().unwrap(), "  31 term colour of the pixel");
}

#[test]
fn over_into_and_out_lead_where_a_debugger_would() {
    let scene = scene();
    let records = records(&scene);
    let settings = Settings::default();
    let log = StepLog::new(&scene, &settings, &records);
    let mut here = Cursor::at_start(&log).unwrap();
    let mut go = |by: Move| {
        here = here.moved(&log, by)?;
        let events = &log.step(here.here).events;
        Some([events.start, events.end - 1])
    };
    // into the pixel, over its window point to the ray, into that
    assert_eq!(go(Move::Over), None);
    assert_eq!(go(Move::Into), Some([0, 0]));
    assert_eq!(go(Move::Over), Some([1, 30]));
    assert_eq!(go(Move::Into), Some([1, 1]));
    assert_eq!(go(Move::Over), Some([2, 3]));
    assert_eq!(go(Move::Over), Some([4, 4]));
    assert_eq!(go(Move::Over), Some([5, 5]));
    assert_eq!(go(Move::Over), Some([6, 6]));
    // a ray that was spawned is one step
    assert_eq!(go(Move::Over), Some([7, 12]));
    assert_eq!(go(Move::Over), Some([13, 13]));
    assert_eq!(go(Move::Over), Some([14, 14]));
    assert_eq!(go(Move::Over), Some([15, 29]));
    assert_eq!(go(Move::Over), Some([30, 30]));
    // and behind the end of the ray comes the colour of the pixel
    assert_eq!(go(Move::Over), Some([31, 31]));
    assert_eq!(go(Move::Over), None);
    assert_eq!(go(Move::Back), Some([30, 30]));
    assert_eq!(go(Move::Out), Some([1, 30]));
    assert_eq!(go(Move::First), Some([0, 0]));
    assert_eq!(go(Move::Last), Some([31, 31]));
}

#[test]
fn what_a_step_changed_is_told_as_old_and_new() {
    let scene = scene();
    let records = records(&scene);
    let settings = Settings::default();
    let log = StepLog::new(&scene, &settings, &records);
    let told = |event: usize| -> Vec<String> {
        let changes = log.changes(log.landing(event));
        changes.iter().map(|change| change.text(&scene)).collect()
    };
    assert_eq!(told(1), ["open rays: none → 0"]);
    assert_eq!(told(2), ["nearest hit: none → M at t = 4"]);
    assert_eq!(told(4), [""; 0]);
    assert_eq!(told(7), ["open rays: 0 → 0, 1"]);
    assert_eq!(told(13), ["light \"lamp\": none → (0.5, 0.5, 0.25)"]);
    assert_eq!(
        told(14),
        [
            "ambient: none → (0.25, 0.25, 0)",
            "sum over the visible lights: none → (0.5, 0.5, 0.25)",
            "reflection: none → 0.5"
        ]
    );
    // the end of the reflected ray brings the ball's colour
    assert_eq!(
        told(29),
        ["open rays: 0, 2 → 0", "I_reflected: none → (0.5, 0, 0)"]
    );
    assert_eq!(told(31), ["colour of the pixel: none → (1, 0.75, 0.25)"]);
}

#[test]
fn an_address_is_the_step_of_the_log_and_opens_the_innermost_step_that_holds_it() {
    let scene = scene();
    let records = records(&scene);
    let settings = Settings::default();
    let log = StepLog::new(&scene, &settings, &records);
    let event = log.event_at("14".parse().unwrap()).unwrap();
    let leaf = log.step(log.leaf(event));
    assert!(leaf.is_leaf() && matches!(records[leaf.lead].event, Event::Shade(_)));
    assert_eq!(Address::of(&log, event).to_string(), "14");
    let error = |text: &str| {
        let address: Address = text.parse().unwrap();
        log.event_at(address).unwrap_err().to_string()
    };
    assert_eq!(error("32"), "there is no step 32: the last one is 31");
    assert_eq!(
        error("#path3:1"),
        "there is no step #path3:1: this log has no such section"
    );

    let scene = light::built(light::SCENE);
    let settings = light::settings(raystep::Transport::Forward);
    let records = light::records(&scene, &settings, [1, 1]);
    let log = StepLog::new(&scene, &settings, &records);
    for (event, record) in records.iter().enumerate() {
        let address = Address::of(&log, event);
        assert_eq!(log.event_at(address), Ok(event));
        assert_eq!(
            address.to_string().starts_with("#path"),
            record.path.is_some()
        );
    }
}

/// The grid of the design's scene has 3 × 1 × 3 cells; the eye ray of pixel (80, 60) begins in [1, 0, 2], which lists the floor,
/// and A is hit in [1, 0, 1].
#[test]
fn a_cell_holds_the_tests_of_its_list_and_a_mailbox_saves_one() {
    let scene = crate::trace_log::built(crate::trace_log::EXAMPLE);
    let settings = Settings {
        strategy: StrategyName::Grid,
        ..Settings::default()
    };
    let records = traced(&scene, &settings, [80, 60]);
    let log = StepLog::new(&scene, &settings, &records);
    let of_ray = |line: &&String| line.starts_with("    ") && !line.starts_with("      ");
    let found = outline(&log);
    let ray = found
        .iter()
        .position(|line| line.contains("Ray 0"))
        .unwrap();
    let of_ray: Vec<&str> = found[ray..]
        .iter()
        .filter(of_ray)
        .map(|line| line.trim())
        .collect();
    let names: Vec<&str> = of_ray
        .iter()
        .map(|line| line.split_once(' ').unwrap().1)
        .take(5)
        .collect();
    assert_eq!(
        names,
        [
            "term start of ray 0",
            "term grid",
            "place cell [1, 0, 2]",
            "place cell [1, 0, 1]",
            "term end of the traversal"
        ]
    );
    let is_second = |line: &String| line.contains("place cell [1, 0, 1]");
    let second = found.iter().position(is_second).unwrap();
    let inside: Vec<&str> = found[second + 1..]
        .iter()
        .take_while(|line| line.starts_with("      "))
        .filter(|line| !line.starts_with("        "))
        .map(|line| line.trim().split_once(' ').unwrap().1)
        .collect();
    assert_eq!(
        inside,
        [
            "term cell [1, 0, 1]",
            "test A: sphere: hit",
            "test B: ellipsoid: rejected, no root",
            "test C: box: rejected, empty",
            "test mailbox of floor: not tested again"
        ]
    );
    // who left the mark in the mailbox: the floor's test in the first cell
    let mailbox = records
        .iter()
        .position(|r| matches!(r.event, Event::Mailbox { .. }))
        .unwrap();
    let setter = log.who_set(log.landing(mailbox), None).unwrap();
    assert_eq!(setter.quantity, Quantity::Mailboxes);
    assert!(matches!(
        records[setter.event].event,
        Event::PlaneTest { .. }
    ));
    let Value::Objects(objects) = setter.value else {
        panic!("{:?}", setter.value);
    };
    assert_eq!(
        objects.iter().map(|object| object.0).collect::<Vec<_>>(),
        [0, 1, 2, 3]
    );
    assert!(log.interests().contains(&(mailbox, Interest::Mailbox)));
}

/// The same pixel by the heap: the root is node 0, A lies in leaf 5, below nodes 1 and 4, whose bounds the ray enters at
/// z = 1, 5 before the eye; the floor is leaf 2, the box leaf 3 and the ellipsoid leaf 6.
#[test]
fn the_heap_has_the_nodes_that_wait_and_each_node_is_a_place() {
    let scene = crate::trace_log::built(crate::trace_log::EXAMPLE);
    let settings = Settings {
        strategy: StrategyName::Heap,
        ..Settings::default()
    };
    let mut records = traced(&scene, &settings, [80, 60]);
    records.retain(|record| record.pixel.is_some());
    let log = StepLog::new(&scene, &settings, &records);
    let section = log.sections().next().unwrap();
    let ray = log.step(section).children.clone().nth(1).unwrap();
    let steps = log.step(ray).children.clone().take_while(|&step| {
        let lead = &records[log.step(step).lead];
        lead.ray == Some(0)
    });
    let told: Vec<(String, Vec<String>)> = steps
        .map(|step| {
            let changes = log.changes(step);
            let changes = changes.iter().filter(|change| {
                matches!(
                    change.quantity,
                    Quantity::Waiting | Quantity::Node | Quantity::Nearest
                )
            });
            let changes = changes.map(|change| change.text(&scene)).collect();
            (headline(&log, step), changes)
        })
        .collect();
    let names: Vec<&str> = told.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(
        names,
        [
            "start of ray 0",
            "S, T of each slab",
            "bounding volume of node 0: hit",
            "node 0: entered",
            "node 1: entered",
            "node 4: entered",
            "node 5: entered",
        ]
    );
    let changes: Vec<&[String]> = told.iter().map(|(_, changes)| changes.as_slice()).collect();
    assert_eq!(changes[2], ["waiting nodes: none → 0 at t = 0"]);
    // node 0 comes out and node 1 goes in
    assert_eq!(
        changes[3],
        [
            "node: none → 0",
            "waiting nodes: 0 at t = 0 → 1 at t = 5.00005"
        ]
    );
    assert_eq!(
        changes[5],
        [
            "node: 1 → 4",
            "waiting nodes: 4 at t = 5.00005 → 5 at t = 5.00005"
        ]
    );
    assert_eq!(
        changes[6],
        [
            "nearest hit: none → A at t = 5.00028",
            "node: 4 → 5",
            "waiting nodes: 5 at t = 5.00005 → none"
        ]
    );
}

#[test]
fn siblings_of_one_kind_and_verdict_are_one_step_with_their_reasons() {
    // five balls beside the ray, one behind the eye, then one that is hit, then two more beside it
    let ball = |x: f64, z: f64| {
        format!(
            r#"{{"name":"ball {x} {z}","material":"m","shape":{{"sphere":{{"center":[{x},0,{z}],"radius":0.5}}}}}}"#
        )
    };
    let balls = [
        ball(3.0, -5.0),
        ball(4.0, -5.0),
        ball(5.0, -5.0),
        ball(0.0, 5.0),
        ball(6.0, -5.0),
        ball(0.0, -5.0),
        ball(7.0, -5.0),
        ball(8.0, -5.0),
    ];
    let scene = light::built(&format!(
        r#"{{"camera":{{"look_at":{{"cop":[0,0,0],"target":[0,0,-1],"up":[0,1,0],"fov_degrees":40}},"pixels":[1,1]}},
        "materials":{{"m":{{"colour":[1,1,1]}}}},"objects":[{}]}}"#,
        balls.join(",")
    ));
    let settings = Settings::default();
    let records = traced(&scene, &settings, [0, 0]);
    let log = StepLog::new(&scene, &settings, &records);
    let found = outline(&log);
    assert!(
        found.contains(&"    2-6 test 5 spheres missed: 4 no root, 1 behind".into()),
        "{found:#?}"
    );
    assert!(
        found.contains(&"    7-8 test ball 0 -5: sphere: hit".into()),
        "{found:#?}"
    );
    // two are not many
    assert!(
        found.contains(&"    9 test ball 7 -5: sphere: rejected, no root".into()),
        "{found:#?}"
    );
    let fold = log.above(log.leaf(2)).next().unwrap();
    assert!(log.step(fold).is_fold());
    assert!(StepWords::new(&log).of(&log, fold).is_empty());
    // into the fold: its first ball, and over to the next
    let inside = Cursor::at(&log, fold).moved(&log, Move::Into).unwrap();
    assert_eq!(log.step(inside.here).events, 2..3);
    let next = inside.moved(&log, Move::Over).unwrap();
    assert_eq!(log.step(next.here).events, 3..4);
    // a level keeps it closed
    let closed = next.at_level(&log, Level::Test);
    assert_eq!(closed.here, fold);
}
