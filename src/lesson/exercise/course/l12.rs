//! Lesson 12: the uniform grid.

use glam::DVec3;

use crate::explain::Part;
use crate::figure::{SketchForm, SketchMark};
use crate::geometry::{AxisBox, Ray, TRange};
use crate::lesson::exercise::course::l02::of_hit;
use crate::lesson::exercise::course::shared::{mark, ray_mark, said_ray, shapes};
use crate::lesson::exercise::supplied::Cells;
use crate::lesson::exercise::value::{number, vector};
use crate::lesson::exercise::{About, Answer, Case, Exercise, See, Silent, Task, Value, Watch};
use crate::mistake::Wrong;
use crate::scene::{PrimitiveId, Scene, Shape};
use crate::strategy::Hit;
use crate::structure::{Across, CellPlanes};
use crate::trace::Kind;

pub(super) static ALL: [&dyn Exercise; 6] = [
    &OBJECT_TO_CELLS,
    &CELL_OF,
    &FIRST_PLANES,
    &NEXT_CELL,
    &WALK_ENDS,
    &WALK,
];

const fn see(kind: Kind, at: u32) -> See {
    See::Step {
        scene: "12-grid/scene.json",
        pixel: [12, 8],
        strategy: "grid",
        at,
        kind,
    }
}

/// A grid of 4 × 4 × 4 cells with sides of 1, from the origin.
const AROUND: AxisBox = AxisBox {
    min: DVec3::ZERO,
    max: DVec3::splat(4.0),
};
/// One of 5 × 2 × 4 cells that are no cubes.
const FLAT: AxisBox = AxisBox {
    min: DVec3::new(-2.0, 1.0, 0.0),
    max: DVec3::new(8.0, 2.0, 6.0),
};

fn cell_value([i, j, k]: [u32; 3]) -> Value {
    Value::word(format!("({i}, {j}, {k})"))
}

fn said_grid(around: &AxisBox, [nx, ny, nz]: [u32; 3]) -> String {
    format!(
        "{nx} × {ny} × {nz} cells from {} to {}",
        vector(around.min),
        vector(around.max)
    )
}

/// The lines of the grid, as it is seen along z.
fn grid_marks(around: &AxisBox, resolution: [u32; 3]) -> Vec<SketchMark> {
    let planes = CellPlanes::new(around, resolution);
    let (low, high) = (around.min, around.max);
    let across_x = planes
        .axis(0)
        .iter()
        .map(|&x| SketchForm::Line(DVec3::new(x, low.y, low.z), DVec3::new(x, high.y, low.z)));
    let across_y = planes
        .axis(1)
        .iter()
        .map(|&y| SketchForm::Line(DVec3::new(low.x, y, low.z), DVec3::new(high.x, y, low.z)));
    across_x
        .chain(across_y)
        .map(|form| mark(form, ""))
        .collect()
}

/// The middle of a cell.
fn middle(around: &AxisBox, resolution: [u32; 3], cell: [u32; 3]) -> DVec3 {
    let planes = CellPlanes::new(around, resolution);
    let of = |axis: usize| {
        let planes = planes.axis(axis);
        let at = (cell[axis] as usize).min(planes.len() - 2);
        f64::midpoint(planes[at], planes[at + 1])
    };
    DVec3::new(of(0), of(1), of(2))
}

/// A grid and the box of an object.
#[derive(Clone, Copy, Debug)]
pub struct Boxed {
    around: AxisBox,
    resolution: [u32; 3],
    object: AxisBox,
}

fn object_to_cells(around: &AxisBox, resolution: [u32; 3], object: &AxisBox) -> [[u32; 3]; 2] {
    let planes = CellPlanes::new(around, resolution);
    let touched = [0, 1, 2].map(|axis| planes.touched(axis, object.along(axis)));
    [
        touched.map(|[first, _]| first),
        touched.map(|[_, last]| last),
    ]
}

/// The cells on whose lists an object is put.
pub static OBJECT_TO_CELLS: Task<Boxed, fn(&AxisBox, [u32; 3], &AxisBox) -> [[u32; 3]; 2]> = Task {
    about: About {
        lesson: 12,
        name: "object_to_cells",
        title: "the first and the last cell that the box of an object touches",
        signature: "pub fn object_to_cells(around: &AxisBox, resolution: [u32; 3], object: &AxisBox) -> [[u32; 3]; 2]",
        parts: &[Part::Building],
        uses: &[Part::Bound],
        mistakes: &[],
        see: See::Figure("12-grid/partition"),
        hints: [
            "Along each axis: how many sides of a cell lies the box's lower and its upper face from the lower face of the grid?",
            "first = ⌊(object.min − min)/side⌋, last = ⌊(object.max − min)/side⌋, with side = (max − min)/n, and not outside of the grid.",
            "let of = |x: f64| ((x - around.min[axis]) / side).clamp(0.0, n - 1.0) as u32; of(object.min[axis]) and of(object.max[axis])",
        ],
        take_away: "An object is listed in every cell that its box touches: the mailbox spares the repeated tests.",
        next: "the figures 12-grid/lists and 12-grid/mailbox, then l12_cell_of",
    },
    cases: |seeds| {
        let case = |note: &str,
                    (around, resolution): (AxisBox, [u32; 3]),
                    min: [f64; 3],
                    max: [f64; 3]| {
            let object = AxisBox {
                min: min.into(),
                max: max.into(),
            };
            Case::new(
                note,
                Boxed {
                    around,
                    resolution,
                    object,
                },
            )
        };
        let (cubes, flat) = ((AROUND, [4; 3]), (FLAT, [5, 2, 4]));
        let mut cases = vec![
            case(
                "an object in one cell",
                cubes,
                [1.2, 2.3, 3.4],
                [1.7, 2.6, 3.9],
            ),
            case(
                "an object in two cells along x",
                cubes,
                [1.2, 2.3, 3.4],
                [2.3, 2.6, 3.9],
            ),
            case("an object in many cells", cubes, [0.5; 3], [3.5; 3]),
            case(
                "cells that are no cubes, and the grid does not start in the origin",
                flat,
                [-1.5, 1.1, 0.1],
                [3.5, 1.3, 2.0],
            ),
            case(
                "the object reaches out of the grid",
                cubes,
                [-1.0, 1.5, 1.5],
                [5.0, 1.6, 1.6],
            ),
        ];
        let mut seeded = seeds.stream(12);
        while cases.len() < 25 {
            let low = seeded.point(1.5) + 2.0;
            let high = low + seeded.point(0.5) + 0.6;
            cases.push(case(
                "a seeded object",
                cubes,
                low.to_array(),
                high.to_array(),
            ));
        }
        cases
    },
    given: |case| {
        format!(
            "{}; object from {} to {}",
            said_grid(&case.around, case.resolution),
            vector(case.object.min),
            vector(case.object.max)
        )
    },
    answer: |student, case, _| {
        let [first, last] = student(&case.around, case.resolution, &case.object);
        vec![
            (Part::Building, "first cell", cell_value(first)),
            (Part::Building, "last cell", cell_value(last)),
        ]
    },
    own: object_to_cells,
    mistaken: |_, _| None,
    forms: &[],
    scenery: |case| {
        let mut marks = grid_marks(&case.around, case.resolution);
        let AxisBox { min, max } = case.object;
        let corners = vec![
            min,
            DVec3::new(max.x, min.y, min.z),
            DVec3::new(max.x, max.y, min.z),
            DVec3::new(min.x, max.y, min.z),
        ];
        marks.push(mark(SketchForm::Outline(corners), "object"));
        marks
    },
    marks: Some(|_, _| Vec::new()),
};

/// A grid and a point.
#[derive(Clone, Copy, Debug)]
pub struct Located {
    around: AxisBox,
    resolution: [u32; 3],
    point: DVec3,
}

fn cell_of(around: &AxisBox, resolution: [u32; 3], point: DVec3) -> [u32; 3] {
    let planes = CellPlanes::new(around, resolution);
    [0, 1, 2].map(|axis| {
        let below = planes
            .axis(axis)
            .partition_point(|plane| *plane <= point[axis]) as u32;
        below.clamp(1, resolution[axis]) - 1
    })
}

/// The cell of a point.
pub static CELL_OF: Task<Located, fn(&AxisBox, [u32; 3], DVec3) -> [u32; 3]> = Task {
    about: About {
        lesson: 12,
        name: "cell_of",
        title: "the cell that a point lies in",
        signature: "pub fn cell_of(around: &AxisBox, resolution: [u32; 3], point: DVec3) -> [u32; 3]",
        parts: &[Part::Grid],
        uses: &[Part::Building],
        mistakes: &[],
        see: see(Kind::GridEnter, 2),
        hints: [
            "How many sides of a cell is the point away from the lower corner of the grid? And a point on the upper face of the grid?",
            "i = ⌊(x − min)/(max − min)·n⌋, at most n − 1.",
            "let share = (point[axis] - around.min[axis]) / around.size()[axis]; ((share * n) as u32).min(resolution[axis] - 1)",
        ],
        take_away: "A cell owns its lower faces; the last one owns its upper face as well.",
        next: "l12_first_planes",
    },
    cases: |seeds| {
        let case = |note: &str, (around, resolution): (AxisBox, [u32; 3]), point: [f64; 3]| {
            Case::new(
                note,
                Located {
                    around,
                    resolution,
                    point: point.into(),
                },
            )
        };
        let (cubes, flat) = ((AROUND, [4; 3]), (FLAT, [5, 2, 4]));
        let mut cases = vec![
            case("a point in the first cell", cubes, [0.5, 0.5, 0.5]),
            case("another number along each axis", cubes, [0.5, 1.5, 2.5]),
            case(
                "a point on a plane between two cells: it belongs to the upper one",
                cubes,
                [2.0, 0.5, 0.5],
            ),
            case(
                "a point on the upper face of the grid: it belongs to the last cell",
                cubes,
                [4.0, 0.5, 0.5],
            ),
            case(
                "cells that are no cubes, and the grid does not start in the origin",
                flat,
                [3.0, 1.75, 2.0],
            ),
        ];
        let mut seeded = seeds.stream(1212);
        while cases.len() < 30 {
            let share = seeded.point(0.5) + 0.5;
            let point = FLAT.min + share * FLAT.size();
            cases.push(case("a seeded point", flat, point.to_array()));
        }
        cases
    },
    given: |case| {
        format!(
            "{}; p = {}",
            said_grid(&case.around, case.resolution),
            vector(case.point)
        )
    },
    answer: |student, case, _| {
        vec![(
            Part::Grid,
            "cell",
            cell_value(student(&case.around, case.resolution, case.point)),
        )]
    },
    own: cell_of,
    mistaken: |_, _| None,
    forms: &[],
    scenery: |case| {
        let mut marks = grid_marks(&case.around, case.resolution);
        marks.push(mark(SketchForm::Dot(case.point), "p"));
        marks
    },
    marks: Some(|_, _| Vec::new()),
};

/// A grid, a ray, and the cell that it is in.
#[derive(Clone, Copy, Debug)]
pub struct InCell {
    around: AxisBox,
    resolution: [u32; 3],
    ray: Ray,
    cell: [u32; 3],
}

/// t of the next plane along each axis, and from one plane to the next.
fn planes_by(case: &InCell, next_plane: impl Fn(u32, f64) -> u32) -> [[f64; 2]; 3] {
    let side = case.around.size() / DVec3::from(case.resolution.map(f64::from));
    [0, 1, 2].map(|axis| {
        let direction = case.ray.direction[axis];
        if direction == 0.0 {
            return [f64::INFINITY; 2];
        }
        let plane =
            case.around.min[axis] + f64::from(next_plane(case.cell[axis], direction)) * side[axis];
        [
            (plane - case.ray.origin[axis]) / direction,
            side[axis] / direction.abs(),
        ]
    })
}

fn next_plane(cell: u32, direction: f64) -> u32 {
    if direction < 0.0 { cell } else { cell + 1 }
}

fn of_planes(planes: [[f64; 2]; 3]) -> Answer {
    let names = [
        ["t across x", "Δt across x"],
        ["t across y", "Δt across y"],
        ["t across z", "Δt across z"],
    ];
    let pairs = planes.into_iter().zip(names);
    let each = pairs.flat_map(|(values, names)| values.into_iter().zip(names));
    each.map(|(value, name)| (Part::NextPlanes, name, Value::Number(value)))
        .collect()
}

fn said_in_cell(case: &InCell) -> String {
    let [i, j, k] = case.cell;
    format!(
        "{}; {}; cell ({i}, {j}, {k})",
        said_grid(&case.around, case.resolution),
        said_ray(&case.ray)
    )
}

fn in_cell_scenery(case: &InCell) -> Vec<SketchMark> {
    let mut marks = grid_marks(&case.around, case.resolution);
    marks.extend(ray_mark(&case.ray, 3.0));
    marks
}

/// The first planes and the steps from plane to plane.
pub static FIRST_PLANES: Task<InCell, fn(&AxisBox, [u32; 3], &Ray, [u32; 3]) -> [[f64; 2]; 3]> =
    Task {
        about: About {
            lesson: 12,
            name: "first_planes",
            title: "t of the next plane along each axis, and Δt from plane to plane",
            signature: "pub fn first_planes(around: &AxisBox, resolution: [u32; 3], ray: &Ray, cell: [u32; 3]) -> [[f64; 2]; 3]",
            parts: &[Part::NextPlanes],
            uses: &[Part::Grid, Part::NearFar, Part::Ray],
            mistakes: &["next plane always +1"],
            see: see(Kind::Cell, 3),
            hints: [
                "Cell i lies between plane i and plane i + 1. Through which of the two does the ray leave? And along an axis in which it does not move?",
                "plane = min + i·side downwards, min + (i + 1)·side upwards; t = (plane − o)/Δ, Δt = side/|Δ|; both ∞ where Δ = 0.",
                "let plane = around.min[axis] + side * f64::from(if direction < 0.0 { cell[axis] } else { cell[axis] + 1 });",
            ],
            take_away: "Downwards the next plane is the lower one of the cell; t only grows, whichever way the ray runs.",
            next: "l12_next_cell",
        },
        cases: |seeds| {
            let case = |note: &str,
                        (around, resolution): (AxisBox, [u32; 3]),
                        origin: [f64; 3],
                        direction: [f64; 3]| {
                let ray = Ray::new(origin.into(), direction.into());
                let cell = cell_of(&around, resolution, ray.origin);
                Case::new(
                    note,
                    InCell {
                        around,
                        resolution,
                        ray,
                        cell,
                    },
                )
            };
            let (cubes, flat) = ((AROUND, [4; 3]), (FLAT, [5, 2, 4]));
            let mut cases = vec![
                case(
                    "upwards along all axes",
                    cubes,
                    [2.5, 2.5, 2.5],
                    [1.0, 0.5, 0.25],
                ),
                case(
                    "downwards along x",
                    cubes,
                    [2.5, 2.5, 2.5],
                    [-1.0, 0.5, 0.25],
                ),
                case(
                    "downwards along all axes",
                    cubes,
                    [2.25, 1.5, 3.5],
                    [-0.5, -1.0, -2.0],
                ),
                case(
                    "along x alone: the planes across y and z are never reached",
                    cubes,
                    [2.5, 2.5, 2.5],
                    [1.0, 0.0, 0.0],
                ),
                case(
                    "cells that are no cubes",
                    flat,
                    [1.0, 1.25, 2.0],
                    [0.5, 0.25, -0.5],
                ),
                case(
                    "Δ is not of unit length",
                    cubes,
                    [0.5, 0.5, 0.5],
                    [4.0, 2.0, 8.0],
                ),
            ];
            let mut seeded = seeds.stream(121);
            while cases.len() < 30 {
                let origin = FLAT.min + (seeded.point(0.45) + 0.5) * FLAT.size();
                let direction = seeded.direction();
                if 0.05 < direction.abs().min_element() {
                    cases.push(case(
                        "a seeded ray",
                        flat,
                        origin.to_array(),
                        direction.to_array(),
                    ));
                }
            }
            cases
        },
        given: said_in_cell,
        answer: |student, case, _| {
            of_planes(student(&case.around, case.resolution, &case.ray, case.cell))
        },
        own: |around, resolution, ray, cell| {
            let case = InCell {
                around: *around,
                resolution,
                ray: *ray,
                cell,
            };
            planes_by(&case, next_plane)
        },
        mistaken: |wrong, case| match wrong {
            Wrong::NextPlane(wrong) => Some(of_planes(planes_by(case, wrong))),
            _ => None,
        },
        forms: &[],
        scenery: in_cell_scenery,
        marks: Some(|case, answer| {
            let t = answer
                .iter()
                .filter(|(_, name, _)| name.starts_with('t'))
                .filter_map(|(_, _, value)| value.number());
            let t: Vec<f64> = t.filter(|t| t.is_finite()).collect();
            crate::lesson::exercise::course::shared::points_at(&case.ray, &t)
        }),
    };

fn is_along(across: Across, axis: usize) -> bool {
    let bits = Across::BY_BITS
        .iter()
        .position(|known| *known == across)
        .unwrap_or(0);
    bits >> axis & 1 == 1
}

/// The planes that are crossed first: one, or several at the same t.
fn smallest(next: [f64; 3]) -> Across {
    let least = next.into_iter().fold(f64::INFINITY, f64::min);
    let bits = (0..3).filter(|&axis| next[axis] == least && least.is_finite());
    Across::BY_BITS[bits.map(|axis| 1 << axis).sum::<usize>()]
}

/// The cell behind the planes, or none outside of the grid.
fn behind(
    cell: [u32; 3],
    across: Across,
    direction: DVec3,
    resolution: [u32; 3],
) -> Option<[u32; 3]> {
    let mut behind = cell;
    for axis in (0..3).filter(|&axis| is_along(across, axis)) {
        behind[axis] = if direction[axis] < 0.0 {
            cell[axis].checked_sub(1)?
        } else {
            let above = cell[axis] + 1;
            (above < resolution[axis]).then_some(above)?
        };
    }
    Some(behind)
}

fn of_next(cell: Option<[u32; 3]>) -> Answer {
    vec![(
        Part::Cell,
        "next cell",
        cell.map_or_else(|| Value::word("outside of the grid"), cell_value),
    )]
}

/// The next cell.
pub static NEXT_CELL: Task<InCell, fn([u32; 3], [f64; 3], DVec3, [u32; 3]) -> Option<[u32; 3]>> =
    Task {
        about: About {
            lesson: 12,
            name: "next_cell",
            title: "the next cell, from the t of the next planes",
            signature: "pub fn next_cell(cell: [u32; 3], next: [f64; 3], direction: DVec3, resolution: [u32; 3]) -> Option<[u32; 3]>",
            parts: &[Part::Cell],
            uses: &[Part::NextPlanes],
            mistakes: &[
                "next plane always +1",
                "steps the largest t",
                "two axes at once",
            ],
            see: see(Kind::Cell, 3),
            hints: [
                "The ray leaves the cell through the plane that it reaches first. Which number of the cell changes, and by how much?",
                "The axis of the smallest t; i − 1 where Δ < 0, else i + 1; None below 0 and from n on.",
                "if direction[axis] < 0.0 { next[axis] = cell[axis].checked_sub(1)?; } else { … if cell[axis] + 1 == resolution[axis] { return None; } }",
            ],
            take_away: "One plane, one step: a line-drawing algorithm leaves out the cells in between.",
            next: "the figure 12-grid/steps, then l12_walk_ends",
        },
        cases: |seeds| {
            let case = |note: &str, origin: [f64; 3], direction: [f64; 3]| {
                let ray = Ray::new(origin.into(), direction.into());
                let cell = cell_of(&AROUND, [4; 3], ray.origin);
                Case::new(
                    note,
                    InCell {
                        around: AROUND,
                        resolution: [4; 3],
                        ray,
                        cell,
                    },
                )
            };
            let mut cases = vec![
                case(
                    "the plane across x is first",
                    [2.5, 2.5, 2.5],
                    [1.0, 0.5, 0.25],
                ),
                case(
                    "the plane across y is first",
                    [1.5, 1.5, 1.5],
                    [0.5, 1.0, 0.25],
                ),
                case(
                    "the plane across z is first, and the ray runs down",
                    [1.5, 1.5, 1.5],
                    [0.5, 0.25, -1.0],
                ),
                case(
                    "the ray runs along x alone",
                    [1.5, 1.5, 1.5],
                    [1.0, 0.0, 0.0],
                ),
                case(
                    "the ray leaves the grid at its upper face",
                    [3.5, 1.5, 1.5],
                    [1.0, 0.25, 0.5],
                ),
                case(
                    "the ray leaves the grid at its lower face",
                    [0.5, 1.5, 1.5],
                    [-1.0, 0.25, 0.5],
                ),
            ];
            let mut seeded = seeds.stream(122);
            while cases.len() < 40 {
                let new = case(
                    "a seeded ray",
                    (seeded.point(1.9) + 2.0).to_array(),
                    seeded.direction().to_array(),
                );
                let mut t = planes_by(&new.input, next_plane).map(|[t, _]| t);
                t.sort_by(f64::total_cmp);
                if 0.01 < t[1] - t[0] {
                    cases.push(new);
                }
            }
            cases
        },
        given: |case| {
            let t = planes_by(case, next_plane).map(|[t, _]| number(t, 6));
            let [i, j, k] = case.cell;
            format!(
                "cell ({i}, {j}, {k}) of 4 × 4 × 4, next = ({}), Δ = {}",
                t.join(", "),
                vector(case.ray.direction)
            )
        },
        answer: |student, case, _| {
            let next = planes_by(case, next_plane).map(|[t, _]| t);
            of_next(student(
                case.cell,
                next,
                case.ray.direction,
                case.resolution,
            ))
        },
        own: |cell, next, direction, resolution| {
            behind(cell, smallest(next), direction, resolution)
        },
        mistaken: |wrong, case| match wrong {
            Wrong::NextPlane(wrong) => {
                let next = planes_by(case, next_plane).map(|[t, _]| t);
                // towards the plane that it takes for the next one
                let towards = [0, 1, 2].map(|axis| {
                    let direction = case.ray.direction[axis];
                    let is_down = wrong(case.cell[axis], direction) == case.cell[axis];
                    if is_down { -1.0 } else { 1.0 }
                });
                let behind = behind(case.cell, smallest(next), towards.into(), case.resolution);
                Some(of_next(behind))
            }
            Wrong::PlanesCrossed(wrong) => {
                let next = planes_by(case, next_plane).map(|[t, _]| t);
                Some(of_next(behind(
                    case.cell,
                    wrong(next),
                    case.ray.direction,
                    case.resolution,
                )))
            }
            _ => None,
        },
        forms: &[],
        scenery: in_cell_scenery,
        marks: Some(|_, _| Vec::new()),
    };

/// t of the nearest hit, and t at which the ray leaves the cell.
#[derive(Clone, Copy, Debug)]
pub struct NearestAndOut {
    nearest: f64,
    t_out: f64,
}

fn walk_ends(nearest: f64, t_out: f64) -> bool {
    nearest <= t_out && nearest.is_finite()
}

fn of_end(ends: bool) -> Answer {
    vec![(Part::WalkEnd, "the walk ends", Value::is(ends))]
}

/// Whether a walk may end.
pub static WALK_ENDS: Task<NearestAndOut, fn(f64, f64) -> bool> = Task {
    about: About {
        lesson: 12,
        name: "walk_ends",
        title: "whether the walk may end after a cell",
        signature: "pub fn walk_ends(nearest: f64, t_out: f64) -> bool",
        parts: &[Part::HitOutside, Part::WalkEnd],
        uses: &[Part::Nearest, Part::Cell],
        mistakes: &["stops at the first cell with a hit", "no end test"],
        see: See::Step {
            scene: "12-grid/later-cell.json",
            pixel: [12, 8],
            strategy: "grid",
            at: 8,
            kind: Kind::HitOutsideCell,
        },
        hints: [
            "An object that is listed here may be hit in a later cell. Can another object be hit before that?",
            "The walk ends if the nearest hit lies in this cell: nearest ≤ t_out.",
            "nearest <= t_out; nearest is ∞ as long as nothing was hit.",
        ],
        take_away: "A hit beyond its cell is kept, and the walk goes on: the next cell may have a nearer one.",
        next: "the figure 12-grid/outside-its-cell, then l12_walk",
    },
    cases: |seeds| {
        let case = |note: &str, nearest: f64, t_out: f64| {
            Case::new(note, NearestAndOut { nearest, t_out })
        };
        let mut cases = vec![
            case("the hit lies in the cell", 5.0, 6.0),
            case("the hit lies beyond the cell", 5.0, 3.0),
            case("nothing was hit so far", f64::INFINITY, 3.0),
            case("a hit far beyond the cell", 100.0, 3.0),
            case("a hit just after the ray came in", 2.1, 3.0),
        ];
        let mut seeded = seeds.stream(123);
        while cases.len() < 20 {
            cases.push(case(
                "seeded",
                seeded.within(0.0, 9.0),
                seeded.within(0.0, 9.0),
            ));
        }
        cases
    },
    given: |case| {
        format!(
            "nearest hit at t = {}, the ray leaves the cell at t = {}",
            number(case.nearest, 6),
            number(case.t_out, 6)
        )
    },
    answer: |student, case, _| of_end(student(case.nearest, case.t_out)),
    own: walk_ends,
    mistaken: |wrong, case| match wrong {
        Wrong::WalkEnds(wrong) => Some(of_end(wrong(case.nearest, case.t_out))),
        _ => None,
    },
    forms: &[],
    scenery: |case| {
        vec![
            mark(
                SketchForm::Line(DVec3::ZERO, DVec3::X * case.t_out),
                "t out",
            ),
            mark(SketchForm::Dot(DVec3::X * case.nearest), "hit"),
        ]
    },
    marks: Some(|_, _| Vec::new()),
};

/// A scene in a grid of 4 × 4 × 4 cells, and a ray.
#[derive(Clone, Debug)]
pub struct Walked {
    scene: Scene,
    ray: Ray,
}

/// The three decisions of a walk.
struct Decisions {
    next_plane: fn(u32, f64) -> u32,
    crossed: fn([f64; 3]) -> Across,
    ends: fn(f64, f64) -> bool,
}

const RIGHT: Decisions = Decisions {
    next_plane,
    crossed: smallest,
    ends: walk_ends,
};

/// The walk, with its decisions; a walk that never ends is cut off.
fn walk_by(cells: &Cells<'_>, ray: &Ray, by: &Decisions) -> Option<(usize, f64)> {
    const MOST: usize = 100;
    let mut nearest: Option<(usize, f64)> = None;
    let mut cell = cells.first(ray)?;
    for _ in 0..MOST {
        for (object, t) in cells.visit(cell, ray) {
            if nearest.is_none_or(|(_, nearest)| t < nearest) {
                nearest = Some((object, t));
            }
        }
        let next = [0, 1, 2].map(|axis| {
            let direction = ray.direction[axis];
            if direction == 0.0 {
                return f64::INFINITY;
            }
            let plane = cells.planes(axis)[(by.next_plane)(cell[axis], direction) as usize];
            (plane - ray.origin[axis]) / direction
        });
        let across = (by.crossed)(next);
        let t_out = (0..3)
            .filter(|&axis| is_along(across, axis))
            .map(|axis| next[axis])
            .fold(f64::INFINITY, f64::min);
        if (by.ends)(nearest.map_or(f64::INFINITY, |(_, t)| t), t_out) {
            break;
        }
        match behind(cell, across, ray.direction, cells.resolution()) {
            Some(behind) => cell = behind,
            None => break,
        }
    }
    nearest
}

/// The walk through given cells, which ends as it should.
fn walk_these(grid: &Cells<'_>, ray: &Ray, cells: &[[u32; 3]]) -> Option<(usize, f64)> {
    let mut nearest: Option<(usize, f64)> = None;
    for &cell in cells {
        for (object, t) in grid.visit(cell, ray) {
            if nearest.is_none_or(|(_, nearest)| t < nearest) {
                nearest = Some((object, t));
            }
        }
        let t_out = grid.leaves(cell, ray);
        if walk_ends(nearest.map_or(f64::INFINITY, |(_, t)| t), t_out) {
            break;
        }
    }
    nearest
}

/// The cells in which the ray is for more than a single t: a walk may also visit those that it only touches.
fn pierced(ray: &Ray, cells: &[[u32; 3]]) -> Value {
    /// Below this a stretch is rounding.
    const TOUCHED: f64 = 1e-9;
    let planes = CellPlanes::new(&AROUND, [4; 3]);
    let is_pierced = |cell: &&[u32; 3]| {
        let corner = |add: u32| {
            let of = |axis: usize| planes.axis(axis)[(cell[axis] + add) as usize];
            DVec3::new(of(0), of(1), of(2))
        };
        let around = AxisBox {
            min: corner(0),
            max: corner(1),
        };
        around
            .inside(ray)
            .is_some_and(|[near, far]| near.max(0.0) + TOUCHED < far)
    };
    let words = cells
        .iter()
        .filter(is_pierced)
        .map(|[i, j, k]| format!("({i}, {j}, {k})"));
    Value::word(words.collect::<Vec<_>>().join(" "))
}

fn of_walk(
    case: &Walked,
    watch: &dyn Watch,
    walk: impl Fn(&Cells<'_>, &Ray) -> Option<(usize, f64)>,
) -> Answer {
    let cells = Cells::new(&case.scene, &AROUND, [4; 3], watch);
    let found = walk(&cells, &case.ray);
    let hit = found.map(|(object, t)| Hit {
        object: PrimitiveId(object as u32),
        t,
    });
    let mut answer = vec![(Part::Cell, "cells", pierced(&case.ray, &cells.visited()))];
    answer.extend(of_hit(&case.scene, hit));
    answer
}

/// The walk through the grid.
pub static WALK: Task<Walked, fn(&Cells<'_>, &Ray) -> Option<(usize, f64)>> = Task {
    about: About {
        lesson: 12,
        name: "walk",
        title: "the walk through the grid, to the nearest object",
        signature: "pub fn walk(cells: &Cells<'_>, ray: &Ray) -> Option<(usize, f64)>",
        parts: &[Part::Cell, Part::WalkEnd, Part::Nearest],
        uses: &[
            Part::Grid,
            Part::NextPlanes,
            Part::Cell,
            Part::HitOutside,
            Part::WalkEnd,
            Part::Nearest,
        ],
        mistakes: &[
            "next plane always +1",
            "steps the largest t",
            "two axes at once",
            "stops at the first cell with a hit",
            "no end test",
            "one cell per column",
        ],
        see: see(Kind::Cell, 3),
        hints: [
            "Visit a cell, keep the nearest hit, ask whether the walk may end, and go to the next cell, until the grid ends.",
            "The t of the next planes come from cells.planes(axis); t_out is the smallest of them; the walk ends if nearest ≤ t_out, or outside of the grid.",
            "loop { for (object, t) in cells.visit(cell, ray) { … } let t_out = …; if walk_ends(nearest, t_out) { return …; } cell = next_cell(cell, next, ray.direction, cells.resolution())?… }",
        ],
        take_away: "The ray visits every cell that it pierces, in order, and stops at the first hit that lies in its cell.",
        next: "the figure 12-grid/walk, and your own picture",
    },
    cases: |seeds| {
        let case = |note: &str,
                    spheres: &[([f64; 3], f64)],
                    origin: [f64; 3],
                    direction: [f64; 3]| {
            let objects = ('A'..).zip(spheres).map(|(name, (center, radius))| {
                format!(r#"{{"name":"{name}","material":"m","shape":{{"sphere":{{"center":{center:?},"radius":{radius:?}}}}}}}"#)
            });
            let scene = shapes(&objects.collect::<Vec<_>>());
            let ray = Ray::new(origin.into(), DVec3::from(direction).normalize());
            Case::new(note, Walked { scene, ray })
        };
        // far from every ray, so that the scene has an object
        let corner = ([0.2, 3.8, 3.8], 0.1);
        let x = [1.0, 0.0, 0.0];
        let mut cases = vec![
            case(
                "along x, and nothing is hit",
                &[corner],
                [-1.0, 0.5, 0.5],
                x,
            ),
            case("along −x", &[corner], [5.0, 0.5, 0.5], [-1.0, 0.0, 0.0]),
            case(
                "aslant through the grid",
                &[corner],
                [-1.0, 0.3, 0.6],
                [1.0, 0.45, 0.3],
            ),
            case(
                "aslant, down along all axes",
                &[corner],
                [4.9, 3.7, 3.4],
                [-1.0, -0.45, -0.35],
            ),
            case(
                "a ball in the third cell: the walk ends there",
                &[corner, ([2.5, 0.5, 0.5], 0.3)],
                [-1.0, 0.5, 0.5],
                x,
            ),
            case(
                "the ray starts in the grid",
                &[corner, ([3.5, 1.5, 1.5], 0.3)],
                [1.5, 1.5, 1.5],
                x,
            ),
            case(
                "a large ball is listed before it is hit, and a small one is nearer",
                &[corner, ([2.6, 2.2, 0.5], 1.7), ([1.3, 0.5, 0.5], 0.2)],
                [-1.0, 0.55, 0.5],
                x,
            ),
            case("the ray passes the grid", &[corner], [-1.0, 9.0, 0.5], x),
            case(
                "through the edge between cells",
                &[corner],
                [-1.0, -1.0, 0.5],
                [1.0, 1.0, 0.0],
            ),
        ];
        let mut seeded = seeds.stream(124);
        while cases.len() < 40 {
            let spheres: Vec<_> = (0..5)
                .map(|_| {
                    (
                        (seeded.point(1.7) + 2.0).to_array(),
                        seeded.within(0.1, 0.6),
                    )
                })
                .collect();
            let target = seeded.point(1.5) + 2.0;
            let origin = target + 6.0 * seeded.direction();
            cases.push(case(
                "five seeded balls",
                &spheres,
                origin.to_array(),
                (target - origin).to_array(),
            ));
        }
        cases
    },
    given: |case| {
        format!(
            "{} objects in 4 × 4 × 4 cells from 0 to 4, {}",
            case.scene.primitives.len(),
            said_ray(&case.ray)
        )
    },
    answer: |student, case, watch| of_walk(case, watch, student),
    own: |cells, ray| walk_by(cells, ray, &RIGHT),
    mistaken: |wrong, case| {
        if let Wrong::CellsVisited(visited) = wrong {
            let cells = visited(&AROUND, [4; 3], &case.ray, TRange::FORWARD);
            return Some(of_walk(case, &Silent, |grid, ray| {
                walk_these(grid, ray, &cells)
            }));
        }
        let by = match wrong {
            Wrong::NextPlane(next_plane) => Decisions {
                next_plane: *next_plane,
                ..RIGHT
            },
            Wrong::PlanesCrossed(crossed) => Decisions {
                crossed: *crossed,
                ..RIGHT
            },
            Wrong::WalkEnds(ends) => Decisions {
                ends: *ends,
                ..RIGHT
            },
            _ => return None,
        };
        Some(of_walk(case, &Silent, |cells, ray| {
            walk_by(cells, ray, &by)
        }))
    },
    forms: &[],
    scenery: |case| {
        let mut marks = grid_marks(&AROUND, [4; 3]);
        marks.extend(ray_mark(&case.ray, 7.0));
        for (primitive, object) in case.scene.primitives.iter().zip(&case.scene.objects) {
            if let Shape::Sphere(sphere) = &primitive.shape {
                marks.push(mark(
                    SketchForm::Circle(sphere.center, sphere.radius),
                    &object.name,
                ));
            }
        }
        marks
    },
    marks: Some(|case, answer| {
        let mut marks = super::l02::marks(&case.ray, answer);
        if let Some((_, _, Value::Word(cells))) = answer.first() {
            let numbers = |cell: &str| {
                let mut each = cell
                    .split(|c: char| !c.is_ascii_digit())
                    .filter_map(|of| of.parse().ok());
                Some([each.next()?, each.next()?, each.next()?])
            };
            let visited = cells.split(") (").filter_map(numbers);
            marks.extend(
                visited.map(|cell| mark(SketchForm::Dot(middle(&AROUND, [4; 3], cell)), "")),
            );
        }
        marks
    }),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::exercise::Seeds;
    use crate::structure::start;

    #[test]
    fn the_walk_visits_the_cells_of_the_crate_s_own_walk() {
        let planes = CellPlanes::new(&AROUND, [4; 3]);
        for case in (WALK.cases)(&Seeds::PUBLIC) {
            let cells = Cells::new(&case.input.scene, &AROUND, [4; 3], &Silent);
            let endless = Decisions {
                ends: |_, _| false,
                ..RIGHT
            };
            let _ = walk_by(&cells, &case.input.ray, &endless);
            let walk = crate::structure::GridWalk::new(&planes, &case.input.ray, TRange::FORWARD);
            let expected: Vec<_> = walk.map(|step| step.cell).collect();
            assert_eq!(cells.visited(), expected, "{}", case.note);
            assert_eq!(
                start(&planes, &case.input.ray, TRange::FORWARD).map(|(cell, _)| cell),
                expected.first().copied()
            );
        }
    }

    #[test]
    fn the_walk_finds_what_testing_every_object_finds() {
        use crate::tracer::simple::{Own, Parts};
        let mut hits = 0;
        for case in (WALK.cases)(&Seeds::PUBLIC) {
            let Walked { scene, ray } = &case.input;
            let cells = Cells::new(scene, &AROUND, [4; 3], &Silent);
            let found = walk_by(&cells, ray, &RIGHT);
            // balls reach out of the grid, and a hit out there is none of the grid's
            let around = AROUND.inside(ray);
            let range = around.map_or(TRange { min: 1.0, max: 0.0 }, |[near, far]| TRange {
                min: near.max(0.0),
                max: far,
            });
            let expected = Own.nearest(scene, ray, range);
            if let Some(expected) = expected {
                let found = found.map(|(_, t)| t);
                assert!(
                    found.is_some_and(|t| t <= expected.t),
                    "{}: {found:?}, {expected:?}",
                    case.note
                );
                hits += 1;
            }
        }
        assert!(8 <= hits, "{hits}");
    }
}
