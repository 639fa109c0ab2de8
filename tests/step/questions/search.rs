//! Bounds, nodes and cells: from the planes of slabs, from what went into the heap, from the walls of cells.

use glam::DVec3;
use raystep::Event;
use raystep::trace::{GridEnter, QueueAction, RaySlab};

use super::Asked;

/// Near and far of each slab of the step, from its planes: t at which n·p + D is 0.
pub(super) fn slabs(asked: &Asked) -> Vec<Option<[f64; 2]>> {
    let ray = asked.ray();
    let normal = |slab: u32| {
        let lines = asked.on_ray.iter().filter_map(|event| match event {
            Event::SlabRay(RaySlab { slab, normal, .. }) => Some((*slab, *normal)),
            _ => None,
        });
        lines
            .into_iter()
            .find(|(known, _)| *known == slab)
            .unwrap()
            .1
    };
    let tests = asked.events.iter().filter_map(|record| match record.event {
        Event::SlabTest(test) => Some(test.step),
        _ => None,
    });
    tests
        .map(|step| {
            let normal = normal(step.slab);
            let steepness = normal.dot(ray.direction);
            let ts = [step.d_min, step.d_max].map(|d| -(normal.dot(ray.origin) + d) / steepness);
            (steepness != 0.0).then(|| [ts[0].min(ts[1]), ts[0].max(ts[1])])
        })
        .collect()
}

pub(super) fn slab_that_ends(asked: &Asked) -> String {
    let slabs = slabs(asked);
    let last = slabs.len() - 1;
    let Some([near, far]) = slabs[last] else {
        return format!("slab {last}: the ray is parallel to it and outside");
    };
    let before = || (0..last).filter_map(|slab| Some((slab, slabs[slab]?)));
    // before the last slab every far is beyond every near
    let crossed = before().any(|(_, [near, _])| before().any(|(_, [_, far])| far < near));
    assert!(!crossed, "ended before");
    let least = before().min_by(|a, b| a.1[1].total_cmp(&b.1[1])).unwrap();
    let most = before().max_by(|a, b| a.1[0].total_cmp(&b.1[0])).unwrap();
    if least.1[1] < near {
        // of equal ones the first is named
        let of = before().find(|slab| slab.1[1] == least.1[1]).unwrap().0;
        return format!("slab {last}: its near is above far of slab {of}");
    }
    assert!(far < most.1[0]);
    let of = before().find(|slab| slab.1[0] == most.1[0]).unwrap().0;
    format!("slab {last}: its far is below near of slab {of}")
}

pub(super) fn bound(asked: &Asked) -> String {
    let own = slabs(asked);
    let test = asked.events.iter().find_map(|record| match record.event {
        Event::BoundTest(test) => Some(test),
        _ => None,
    });
    let test = test.unwrap();
    let [near, far] = if own.is_empty() {
        test.inside.unwrap()
    } else {
        let of = own.iter().flatten();
        of.fold([f64::NEG_INFINITY, f64::INFINITY], |[near, far], slab| {
            [near.max(slab[0]), far.min(slab[1])]
        })
    };
    let range = asked.range();
    let is_somewhere = |t: f64| near <= t && t <= far && range.min <= t && t <= range.max;
    let ends = [near, far, range.min, range.max];
    let text = if far < near {
        "the ray misses it"
    } else if ends.into_iter().any(is_somewhere) {
        "it is hit, and what is inside is tested"
    } else if far < range.min {
        "it lies behind the origin"
    } else {
        "it begins beyond the last t that counts"
    };
    text.into()
}

/// By what went into the heap and came out of it.
pub(super) fn next_node(asked: &Asked) -> String {
    let mut waiting: Vec<(f64, u32)> = Vec::new();
    for event in asked.before() {
        if let Event::Queue(step) = event {
            match step.action {
                QueueAction::Push => waiting.push((step.key, step.node)),
                QueueAction::Pop | QueueAction::Stop => {
                    waiting.retain(|(_, node)| *node != step.node);
                }
            }
        }
    }
    let next = waiting.into_iter().min_by(|a, b| a.0.total_cmp(&b.0));
    format!("node {}", next.unwrap().1)
}

pub(super) fn pruned(asked: &Asked) -> String {
    let near = asked.events.iter().find_map(|record| match record.event {
        Event::Node(visit) => visit.near,
        _ => None,
    });
    if asked.range().max < near.unwrap() {
        "it is pruned: nothing in it can be nearer".into()
    } else {
        "it is entered: it may hold a nearer hit".into()
    }
}

pub(super) fn grid(asked: &Asked) -> GridEnter {
    let enter = asked.on_ray.iter().rev().find_map(|event| match event {
        Event::GridEnter(enter) => Some(*enter),
        _ => None,
    });
    enter.unwrap()
}

/// The lower and the upper corner of a cell.
pub(super) fn corners_of(enter: &GridEnter, cell: [u32; 3]) -> [DVec3; 2] {
    let n = DVec3::from(enter.resolution.map(f64::from));
    let size = (enter.around.max - enter.around.min) / n;
    let low = DVec3::from(cell.map(f64::from));
    [low, low + DVec3::ONE].map(|at| enter.around.min + at * size)
}

/// By the walls of the cell.
pub(super) fn next_plane(asked: &Asked) -> String {
    let cell = asked.events.iter().find_map(|record| match record.event {
        Event::Cell(cell) => Some(cell.step.cell),
        _ => None,
    });
    let [low, high] = corners_of(&grid(asked), cell.unwrap());
    let ray = asked.ray();
    let t = [0, 1, 2].map(|axis| {
        let wall = if ray.direction[axis] < 0.0 {
            low[axis]
        } else {
            high[axis]
        };
        if ray.direction[axis] == 0.0 {
            f64::INFINITY
        } else {
            (wall - ray.origin[axis]) / ray.direction[axis]
        }
    });
    let first = t.into_iter().fold(f64::INFINITY, f64::min);
    let crossed: Vec<&str> = ["x", "y", "z"]
        .into_iter()
        .zip(t)
        .filter(|&(_, t)| (t - first).abs() <= 1e-7 * first.abs().max(1e-3))
        .map(|(name, _)| name)
        .collect();
    match crossed.as_slice() {
        [one] => format!("the one across {one}"),
        [one, two] => format!("those across {one} and {two} at once"),
        _ => "those across x, y and z at once".into(),
    }
}

pub(super) fn mailbox(asked: &Asked) -> String {
    let Event::Listed { object } = asked.events[0].event else {
        panic!("{:?}", asked.events[0]);
    };
    let was_tested = asked.before().iter().any(|event| match event {
        Event::SphereTest { object: of, .. }
        | Event::EllipsoidTest { object: of, .. }
        | Event::ConeTest { object: of, .. }
        | Event::BoxTest { object: of, .. }
        | Event::PlaneTest { object: of, .. } => *of == object,
        _ => false,
    });
    if was_tested {
        "no: its mailbox has the number of this ray".into()
    } else {
        "yes: its mailbox does not have the number of this ray".into()
    }
}

/// By whether the point of the hit lies in the cell.
pub(super) fn final_hit(asked: &Asked) -> String {
    let Event::Nearest(hit) = asked.events[0].event else {
        panic!("{:?}", asked.events[0]);
    };
    let cell = asked.on_ray.iter().rev().find_map(|event| match event {
        Event::Cell(cell) => Some(cell.step.cell),
        _ => None,
    });
    let enter = grid(asked);
    let [low, high] = corners_of(&enter, cell.unwrap());
    let room = 1e-7 * (enter.around.max - enter.around.min).length();
    let p = asked.ray().at(hit.t);
    let is_inside = (low - room).cmple(p).all() && p.cmple(high + room).all();
    if is_inside {
        "the walk ends after the list of this cell".into()
    } else {
        "the walk goes on: a later cell may have a nearer hit".into()
    }
}
