//! Lesson 11: hierarchies.

use std::collections::BinaryHeap;

use glam::DVec3;

use crate::explain::Part;
use crate::figure::{SketchForm, SketchMark};
use crate::geometry::{AxisBox, Ray, TRange};
use crate::lesson::exercise::course::l02::{SceneRay, marks, of_hit, said, scenery};
use crate::lesson::exercise::course::shared::{mark, shapes};
use crate::lesson::exercise::supplied::{Below, Tree};
use crate::lesson::exercise::value::number;
use crate::lesson::exercise::{
    About, Answer, Case, Exercise, Form, See, Seeds, Silent, Task, Value,
};
use crate::mistake::Wrong;
use crate::scene::PrimitiveId;
use crate::strategy::Hit;
use crate::trace::Kind;
use crate::tracer::simple::Parts;

pub(super) static ALL: [&dyn Exercise; 3] = [&HIER_TRAVERSE, &HEAP, &SPLIT_COST];

/// What a traversal gives: an object by its number, and its t.
type Found = Option<(usize, f64)>;

fn spheres(places: &[([f64; 3], f64)]) -> Vec<String> {
    let of = |(name, (center, radius)): (char, &([f64; 3], f64))| {
        format!(
            r#"{{"name":"{name}","material":"m","shape":{{"sphere":{{"center":{center:?},"radius":{radius:?}}}}}}}"#
        )
    };
    ('A'..).zip(places).map(of).collect()
}

fn cases(seeds: &Seeds) -> Vec<Case<SceneRay>> {
    let case = |note: &str, places: &[([f64; 3], f64)], direction: [f64; 3]| {
        let ray = Ray::new(DVec3::ZERO, direction.into());
        Case::new(
            note,
            SceneRay {
                scene: shapes(&spheres(places)),
                ray,
                range: TRange::FORWARD,
            },
        )
    };
    let z = |z: f64| [0.0, 0.0, z];
    let ahead = [0.0, 0.0, -1.0];
    let mut cases = vec![
        case(
            "the ray misses the root",
            &[([5.0, 0.0, -5.0], 1.0), ([5.0, 0.0, -9.0], 1.0)],
            ahead,
        ),
        case(
            "the nearest object is in the first leaf",
            &[
                (z(-4.0), 1.0),
                (z(-8.0), 1.0),
                (z(-12.0), 1.0),
                (z(-16.0), 1.0),
            ],
            ahead,
        ),
        case(
            "the far leaf is the first child",
            &[
                (z(-16.0), 1.0),
                (z(-12.0), 1.0),
                (z(-8.0), 1.0),
                (z(-4.0), 1.0),
            ],
            ahead,
        ),
        case(
            "the box of a ball is hit, but not the ball",
            &[([0.9, 0.9, -4.0], 1.0), (z(-9.0), 1.0)],
            ahead,
        ),
        case(
            "boxes overlap: the nearer box has the farther hit",
            &[
                ([0.0, 1.9, -6.0], 2.0),
                (z(-6.0), 1.0),
                ([4.0, 4.0, -3.0], 0.5),
            ],
            ahead,
        ),
        case(
            "a child lies behind the origin",
            &[(z(5.0), 1.0), (z(9.0), 1.0), (z(-5.0), 1.0), (z(-9.0), 1.0)],
            ahead,
        ),
        case(
            "the ray starts in the box of the root",
            &[(z(5.0), 1.0), (z(-6.0), 1.0), (z(-3.0), 1.0)],
            ahead,
        ),
        case("one object", &[(z(-4.0), 1.0)], ahead),
    ];
    let mut seeded = seeds.stream(11);
    while cases.len() < 40 {
        let places: Vec<_> = (0..9)
            .map(|_| (seeded.point(5.0).to_array(), seeded.within(0.4, 1.6)))
            .collect();
        let origin = seeded.direction() * 12.0;
        let target = seeded.point(3.0);
        let ray = Ray::new(origin, (target - origin).normalize());
        let scene = shapes(&spheres(&places));
        cases.push(Case::new(
            "nine seeded spheres",
            SceneRay {
                scene,
                ray,
                range: TRange::FORWARD,
            },
        ));
    }
    cases
}

fn hit_of(found: Found) -> Option<Hit> {
    found.map(|(object, t)| Hit {
        object: PrimitiveId(object as u32),
        t,
    })
}

fn boxes(case: &SceneRay) -> Vec<SketchMark> {
    let tree = Tree::new(&case.scene, &Silent);
    let outline = |around: &AxisBox| {
        let (low, high) = (around.min, around.max);
        let corners = [
            low,
            DVec3::new(high.x, low.y, low.z),
            DVec3::new(high.x, low.y, high.z),
            DVec3::new(low.x, low.y, high.z),
        ];
        mark(SketchForm::Outline(corners.to_vec()), "")
    };
    let mut marks: Vec<SketchMark> = tree.boxes().map(outline).collect();
    marks.extend(scenery(case));
    marks
}

fn orphan(tree: &Tree<'_>) -> Value {
    let none = "none";
    tree.noted().orphan.map_or_else(
        || Value::word(none),
        |node| Value::word(format!("node {node}")),
    )
}

/// Depth first.
fn hier_traverse(tree: &Tree<'_>, ray: &Ray) -> Found {
    let mut nearest: Found = None;
    let mut waiting = vec![0];
    while let Some(node) = waiting.pop() {
        let max = nearest.map_or(f64::INFINITY, |(_, t)| t);
        let range = TRange { min: 0.0, max };
        if tree.near(node, ray, range).is_none() {
            continue;
        }
        match tree.below(node) {
            Below::Children(children) => waiting.extend(children.iter().rev()),
            Below::Objects(objects) => {
                for &object in objects {
                    let closer = |t: &f64| nearest.is_none_or(|(_, nearest)| *t < nearest);
                    if let Some(t) = tree.hit(object, ray, range).filter(closer) {
                        nearest = Some((object, t));
                    }
                }
            }
        }
    }
    nearest
}

fn of_traverse(case: &SceneRay, orphan: Value, hit: Option<Hit>) -> Answer {
    let mut answer = vec![(Part::Node, "nodes tested below a missed one", orphan)];
    answer.extend(of_hit(&case.scene, hit));
    answer
}

/// The traversal of a hierarchy, depth first.
pub static HIER_TRAVERSE: Task<SceneRay, fn(&Tree<'_>, &Ray) -> Found> = Task {
    about: About {
        lesson: 11,
        name: "hier_traverse",
        title: "HIER_traverse: the nearest object of a hierarchy",
        signature: "pub fn hier_traverse(tree: &Tree<'_>, ray: &Ray) -> Option<(usize, f64)>",
        parts: &[Part::Node, Part::Nearest],
        uses: &[Part::Bound, Part::Nearest],
        mistakes: &[
            "stops at the first leaf",
            "last hit wins",
            "one child only",
            "t of the box taken as the hit",
        ],
        see: See::Step {
            scene: "11-hierarchy/scene.json",
            pixel: [26, 15],
            strategy: "hierarchy",
            at: 9,
            kind: Kind::Node,
        },
        hints: [
            "If the ray misses a node, everything below it is missed. If it hits, all children must be asked: which of them has the nearest object is not known yet.",
            "traverse(node): if the box is missed return; for a leaf test its objects and keep the nearest; else traverse each child.",
            "if tree.near(node, ray, range).is_none() { return; } match tree.below(node) { Below::Children(c) => each traversed, Below::Objects(o) => for each: tree.hit(…), kept if t < nearest }",
        ],
        take_away: "The first hit is not the nearest, and a hit with a box is no hit: both children may matter.",
        next: "the figure 11-hierarchy/pruned, then l11_heap",
    },
    cases,
    given: said,
    answer: |student, case, watch| {
        let tree = Tree::new(&case.scene, watch);
        let found = student(&tree, &case.ray);
        of_traverse(case, orphan(&tree), hit_of(found))
    },
    own: hier_traverse,
    mistaken: |wrong, case| match wrong {
        Wrong::Nearest(_) | Wrong::Hit(_) => {
            let hit = wrong.nearest(&case.scene, &case.ray, case.range);
            Some(of_traverse(case, Value::word("none"), hit))
        }
        _ => None,
    },
    forms: &[],
    scenery: boxes,
    marks: Some(|case, answer| marks(&case.ray, answer)),
};

/// A node that waits, the nearest first.
#[derive(PartialEq)]
struct Waiting {
    near: f64,
    node: usize,
}

impl Eq for Waiting {}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Waiting {
    /// The largest is popped: turned round.
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        other.near.total_cmp(&self.near)
    }
}

fn heap(tree: &Tree<'_>, ray: &Ray) -> Found {
    let mut nearest: Found = None;
    let mut waiting = BinaryHeap::new();
    let root = tree.near(0, ray, TRange::FORWARD);
    waiting.extend(root.map(|near| Waiting { near, node: 0 }));
    while let Some(Waiting { near, node }) = waiting.pop() {
        let max = nearest.map_or(f64::INFINITY, |(_, t)| t);
        if max < near {
            break;
        }
        match tree.below(node) {
            Below::Children(children) => {
                for &node in children {
                    let near = tree.near(node, ray, TRange::FORWARD.up_to(max));
                    waiting.extend(near.map(|near| Waiting { near, node }));
                }
            }
            Below::Objects(objects) => {
                for &object in objects {
                    let closer = |t: &f64| nearest.is_none_or(|(_, nearest)| *t < nearest);
                    if let Some(t) = tree.hit(object, ray, TRange::FORWARD).filter(closer) {
                        nearest = Some((object, t));
                    }
                }
            }
        }
    }
    nearest
}

/// The heap: the nearest node next.
pub static HEAP: Task<SceneRay, fn(&Tree<'_>, &Ray) -> Found> = Task {
    about: About {
        lesson: 11,
        name: "heap",
        title: "the heap: always the nearest node next",
        signature: "pub fn heap(tree: &Tree<'_>, ray: &Ray) -> Option<(usize, f64)>",
        parts: &[Part::Heap, Part::Nearest],
        uses: &[Part::Bound, Part::Node],
        mistakes: &[
            "stops at the first leaf",
            "last hit wins",
            "one child only",
            "t of the box taken as the hit",
        ],
        see: See::Step {
            scene: "11-hierarchy/crowd.json",
            pixel: [20, 15],
            strategy: "heap",
            at: 9,
            kind: Kind::Queue,
        },
        hints: [
            "All nodes that the ray hits wait in one list. Which one is opened next, and when does the search end?",
            "Pop the node with the smallest near. If that is beyond the nearest hit, the search ends. Open it: push the children that are hit, or test the objects.",
            "let next = the smallest near of waiting; if nearest t < near { break; } match tree.below(node) { … waiting.push((near, child)) … }",
        ],
        take_away: "Once the nearest waiting node begins behind the hit, nothing that waits can be nearer.",
        next: "the figure 11-hierarchy/heap, then l11_split_cost",
    },
    cases,
    given: said,
    answer: |student, case, watch| {
        let tree = Tree::new(&case.scene, watch);
        let found = student(&tree, &case.ray);
        let mut answer = vec![(Part::Heap, "nodes opened", opened(&tree, &case.ray))];
        answer.extend(of_hit(&case.scene, hit_of(found)));
        answer
    },
    own: heap,
    mistaken: |wrong, case| match wrong {
        Wrong::Nearest(_) | Wrong::Hit(_) => {
            // the nodes that it would open are not known: those of the right search
            let tree = Tree::new(&case.scene, &Silent);
            let _ = heap(&tree, &case.ray);
            let mut answer = vec![(Part::Heap, "nodes opened", opened(&tree, &case.ray))];
            answer.extend(of_hit(
                &case.scene,
                wrong.nearest(&case.scene, &case.ray, case.range),
            ));
            Some(answer)
        }
        _ => None,
    },
    forms: &[],
    scenery: boxes,
    marks: Some(|case, answer| marks(&case.ray, answer)),
};

/// The near of each node that was opened, in order: of two nodes that begin at the same t either may be the first.
fn opened(tree: &Tree<'_>, ray: &Ray) -> Value {
    let boxes: Vec<&AxisBox> = tree.boxes().collect();
    let nears = tree.noted().opened.into_iter().map(|node| {
        let near = boxes[node]
            .inside(ray)
            .map_or(f64::INFINITY, |[near, _]| near);
        near.max(0.0)
    });
    Value::Numbers(nears.collect())
}

/// A node, and the halves into which it is cut.
#[derive(Clone, Copy, Debug)]
pub struct Cut {
    node_cost: f64,
    area: f64,
    halves: [(f64, usize); 2],
}

fn split_cost(node_cost: f64, area: f64, halves: [(f64, usize); 2]) -> f64 {
    let [first, second] = halves.map(|(area, count)| area * count as f64);
    node_cost + (first + second) / area
}

fn of_cost(cost: f64) -> Answer {
    vec![(Part::Building, "cost", cost.into())]
}

/// What a cut costs by the surface-area heuristic.
pub static SPLIT_COST: Task<Cut, fn(f64, f64, [(f64, usize); 2]) -> f64> = Task {
    about: About {
        lesson: 11,
        name: "split_cost",
        title: "the surface-area cost of a cut",
        signature: "pub fn split_cost(node_cost: f64, area: f64, halves: [(f64, usize); 2]) -> f64",
        parts: &[Part::Building],
        uses: &[Part::Bound],
        mistakes: &[],
        see: See::Figure("11-hierarchy/tree"),
        hints: [
            "How likely does a ray that hits the node also hit a half, and how many objects does it test there?",
            "cost = node_cost + (A₁·n₁ + A₂·n₂)/A, in tests of objects",
            "node_cost + (halves[0].0 * halves[0].1 as f64 + halves[1].0 * halves[1].1 as f64) / area",
        ],
        take_away: "A good cut puts many objects into little area: a ray seldom comes there.",
        next: "lesson 12",
    },
    cases: |seeds| {
        let case = |note: &str, node_cost: f64, area: f64, halves: [(f64, usize); 2]| {
            Case::new(
                note,
                Cut {
                    node_cost,
                    area,
                    halves,
                },
            )
        };
        let mut cases = vec![
            case("two equal halves", 1.0, 10.0, [(6.0, 4), (6.0, 4)]),
            case(
                "many objects in little area",
                1.0,
                10.0,
                [(2.0, 7), (9.0, 1)],
            ),
            case(
                "few objects in little area",
                1.0,
                10.0,
                [(2.0, 1), (9.0, 7)],
            ),
            case("a node costs 1.5 tests", 1.5, 8.0, [(4.0, 2), (6.0, 3)]),
            case(
                "an empty half costs nothing",
                1.0,
                10.0,
                [(0.0, 0), (10.0, 8)],
            ),
        ];
        let mut seeded = seeds.stream(1111);
        while cases.len() < 20 {
            let area = seeded.within(5.0, 20.0);
            let mut half = || (seeded.within(0.1, 1.0) * area, seeded.below(50) as usize);
            let halves = [half(), half()];
            cases.push(case("a seeded cut", 1.5, area, halves));
        }
        cases
    },
    given: |case| {
        let [(first, one), (second, other)] = case.halves;
        format!(
            "node_cost {}, A = {}, A₁ = {} with {one} objects, A₂ = {} with {other}",
            number(case.node_cost, 4),
            number(case.area, 6),
            number(first, 6),
            number(second, 6)
        )
    },
    answer: |student, case, _| of_cost(student(case.node_cost, case.area, case.halves)),
    own: split_cost,
    mistaken: |_, _| None,
    forms: &[Form {
        is: |case, yours| {
            let whole = split_cost(case.node_cost, case.area, case.halves) * case.area;
            let sum = whole + case.node_cost * (1.0 - case.area);
            yours
                .first()
                .is_some_and(|(_, _, value)| value.is_same(&sum.into()))
        },
        note: "the sum of area times objects is divided by the area of the node",
    }],
    scenery: |_| Vec::new(),
    marks: None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tracer::simple::Own;

    #[test]
    fn both_searches_find_what_testing_every_object_finds() {
        let mut hits = 0;
        for case in cases(&Seeds::PUBLIC) {
            let SceneRay { scene, ray, range } = &case.input;
            let expected = Own.nearest(scene, ray, *range);
            for search in [hier_traverse, heap] {
                let found = hit_of(search(&Tree::new(scene, &Silent), ray));
                assert_eq!(found, expected, "{}", case.note);
            }
            hits += u32::from(expected.is_some());
        }
        assert!(15 < hits, "{hits}");
    }

    #[test]
    fn the_heap_opens_the_nearer_child_and_none_behind_the_hit() {
        let scene = shapes(&spheres(&[
            ([0.0, 0.0, -16.0], 1.0),
            ([0.0, 0.0, -12.0], 1.0),
            ([0.0, 0.0, -8.0], 1.0),
            ([0.0, 0.0, -4.0], 1.0),
        ]));
        let tree = Tree::new(&scene, &Silent);
        let found = heap(&tree, &Ray::new(DVec3::ZERO, DVec3::NEG_Z));
        assert_eq!(found, Some((3, 3.0)));
        // the root, its second half (4 in numbers of nodes), and the second object of that
        assert_eq!(tree.noted().opened, [0, 4, 6]);
        assert_eq!(tree.noted().orphan, None);
    }
}
