//! Lesson 6: the polygon.

use glam::{DVec2, DVec3};

use crate::explain::Part;
use crate::figure::{SketchForm, SketchMark};
use crate::geometry::{Axis, Polygon, Ray, Sides, TRange};
use crate::lesson::exercise::course::shared::{mark, points_at, ray_mark, said_range, said_ray};
use crate::lesson::exercise::seeded::Seeded;
use crate::lesson::exercise::value::{number, vector};
use crate::lesson::exercise::{About, Answer, Case, Exercise, See, Seeds, Task, Value, answer};
use crate::mistake::Wrong;
use crate::trace::Kind;
use crate::tracer::simple::{Own, Parts};

pub(super) static ALL: [&dyn Exercise; 4] = [&PLANE_T, &DROPPED_AXIS, &CROSSINGS, &INSIDE];

const fn see(at: u32, kind: Kind) -> See {
    See::Step {
        scene: "06-polygon/scene.json",
        pixel: [32, 24],
        strategy: "",
        at,
        kind,
    }
}

/// A polygon, a ray, and which t count.
#[derive(Clone, Debug)]
pub struct PolygonRay {
    polygon: Polygon,
    ray: Ray,
    range: TRange,
}

impl PolygonRay {
    /// The t of the plane, whichever counts.
    fn t(&self) -> f64 {
        let plane = self.polygon.plane();
        -plane.distance(self.ray.origin) / plane.normal.dot(self.ray.direction)
    }
}

fn case(
    note: &str,
    vertices: &[[f64; 3]],
    origin: [f64; 3],
    direction: [f64; 3],
) -> Case<PolygonRay> {
    let vertices: Vec<DVec3> = vertices.iter().map(|v| DVec3::from(*v)).collect();
    let polygon = Polygon::new(vertices, None).unwrap_or_else(|error| unreachable!("{error}"));
    let ray = Ray::new(origin.into(), direction.into());
    Case::new(
        note,
        PolygonRay {
            polygon,
            ray,
            range: TRange::FORWARD,
        },
    )
}

/// A triangle at z = 5.
const TRIANGLE: [[f64; 3]; 3] = [[0.0, 0.0, 5.0], [4.0, 0.0, 5.0], [0.0, 4.0, 5.0]];
/// A floor at y = −1, with its front above.
const FLOOR: [[f64; 3]; 4] = [
    [-4.0, -1.0, -4.0],
    [-4.0, -1.0, 4.0],
    [4.0, -1.0, 4.0],
    [4.0, -1.0, -4.0],
];
/// The letter L, at z = −2.
const CONCAVE: [[f64; 3]; 6] = [
    [0.0, 0.0, -2.0],
    [4.0, 0.0, -2.0],
    [4.0, 1.0, -2.0],
    [1.0, 1.0, -2.0],
    [1.0, 4.0, -2.0],
    [0.0, 4.0, -2.0],
];
/// Two peaks with a valley between them, at z = 0; the valley is as high as p′.
const PEAKS: [[f64; 3]; 5] = [
    [0.0, 0.0, 0.0],
    [8.0, 0.0, 0.0],
    [6.0, 4.0, 0.0],
    [4.0, 2.0, 0.0],
    [2.0, 4.0, 0.0],
];
/// A square that stands on a corner, at z = 0.
const RHOMBUS: [[f64; 3]; 4] = [
    [0.0, -2.0, 0.0],
    [2.0, 0.0, 0.0],
    [0.0, 2.0, 0.0],
    [-2.0, 0.0, 0.0],
];
/// The letter U, at z = 0: p′ is as high as the floor of its gap.
const GAP: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [6.0, 0.0, 0.0],
    [6.0, 4.0, 0.0],
    [4.0, 4.0, 0.0],
    [4.0, 2.0, 0.0],
    [2.0, 2.0, 0.0],
    [2.0, 4.0, 0.0],
    [0.0, 4.0, 0.0],
];

fn seeded_polygons(count: usize, mut seeded: Seeded, note: &str) -> Vec<Case<PolygonRay>> {
    let mut cases = Vec::new();
    while cases.len() < count {
        let [center, u] = [seeded.point(4.0), seeded.direction()];
        let Some(v) = u.cross(seeded.direction()).try_normalize() else {
            continue;
        };
        let corners: Vec<DVec3> = [[-2.0, -1.0], [2.0, -1.5], [1.0, 2.0], [-1.5, 1.5]]
            .iter()
            .map(|[a, b]| center + *a * u + *b * v)
            .collect();
        let Ok(polygon) = Polygon::new(corners, None) else {
            continue;
        };
        let target = center + seeded.within(-3.0, 3.0) * u + seeded.within(-3.0, 3.0) * v;
        let origin = seeded.point(9.0);
        let Some(direction) = (target - origin).try_normalize() else {
            continue;
        };
        let new = PolygonRay {
            polygon,
            ray: Ray::new(origin, direction),
            range: TRange::FORWARD,
        };
        // clear of a flat ray, and of the edges
        let is_steep = 0.1 < new.polygon.plane().normal.dot(direction).abs();
        if is_steep && 0.02 < clearance(&new) {
            cases.push(Case::new(note, new));
        }
    }
    cases
}

/// How far the point on the plane is from the nearest edge, before it is projected.
fn clearance(case: &PolygonRay) -> f64 {
    let p = case.ray.at(case.t());
    let corners: Vec<DVec3> = case.polygon.vertices().collect();
    let next = corners.iter().cycle().skip(1);
    let distances = corners.iter().zip(next).map(|(a, b)| {
        let share = ((p - *a).dot(*b - *a) / (*b - *a).length_squared()).clamp(0.0, 1.0);
        p.distance(a.lerp(*b, share))
    });
    distances.fold(f64::INFINITY, f64::min)
}

fn given(case: &PolygonRay) -> String {
    let plane = case.polygon.plane();
    format!(
        "(A, B, C) = {}, D = {}, {}{}",
        vector(plane.normal),
        number(plane.d, 6),
        said_ray(&case.ray),
        said_range(case.range)
    )
}

fn scenery(case: &PolygonRay) -> Vec<SketchMark> {
    let mut marks = vec![mark(
        SketchForm::Outline(case.polygon.vertices().collect()),
        "polygon",
    )];
    let t = case.t();
    let length = if t.is_finite() { t.abs() + 1.0 } else { 6.0 };
    marks.extend(ray_mark(&case.ray, length));
    marks
}

fn of_plane_t(t: Option<f64>) -> Answer {
    answer(Part::PlaneT, Value::number_or(t, "no hit"))
}

/// t of the polygon's plane, with the parallel cases.
pub static PLANE_T: Task<PolygonRay, fn(&Polygon, &Ray, TRange, Sides) -> Option<f64>> = Task {
    about: About {
        lesson: 6,
        name: "plane_t",
        title: "t of the plane (v), with the parallel cases",
        signature: "pub fn plane_t(polygon: &Polygon, ray: &Ray, range: TRange, _sides: Sides) -> Option<f64>",
        parts: &[Part::Plane, Part::PlaneT],
        uses: &[Part::Ray, Part::Choice],
        mistakes: &["no parallel case", "negative t kept", "sign of D"],
        see: see(2, Kind::PlaneTest),
        hints: [
            "Put the ray (i) into the plane (iv) and solve for t. When can you not divide? Which t do not count?",
            "t = −(A·x₀ + B·y₀ + C·z₀ + D) / (A·Δx + B·Δy + C·Δz) … (v); no hit where the denominator is 0, or t is not in the range.",
            "if denominator.abs() <= 1e-12 { return None; } let t = -numerator / denominator; (0.0 < t && range.min <= t && t <= range.max).then_some(t)",
        ],
        take_away: "Parallel rays are sorted out before the division; a plane behind the origin has a negative t.",
        next: "the figure 06-polygon/parallel, then l06_dropped_axis",
    },
    cases: |seeds| {
        let mut cases = vec![
            case(
                "the ray hits the plane at a right angle",
                &TRIANGLE,
                [1.0, 1.0, 0.0],
                [0.0, 0.0, 1.0],
            ),
            case(
                "the ray hits the plane aslant",
                &FLOOR,
                [0.0, 2.0, 0.0],
                [0.8, -0.6, 0.0],
            ),
            case(
                "the plane passes through the origin: D = 0",
                &[[0.0, 0.0, 0.0], [0.0, 0.0, 2.0], [2.0, 0.0, 0.0]],
                [0.0, 3.0, 0.0],
                [0.8, -0.6, 0.0],
            ),
            case(
                "the ray comes from the back",
                &TRIANGLE,
                [1.0, 1.0, 9.0],
                [0.0, 0.0, -1.0],
            ),
            case(
                "the plane lies behind the origin",
                &TRIANGLE,
                [1.0, 1.0, 0.0],
                [0.0, 0.0, -1.0],
            ),
            case(
                "the ray is parallel, beside the plane",
                &FLOOR,
                [0.0, 2.0, 0.0],
                [1.0, 0.0, 0.0],
            ),
            case(
                "the ray is parallel, on the other side of the plane",
                &FLOOR,
                [0.0, -3.0, 0.0],
                [1.0, 0.0, 0.0],
            ),
            case(
                "the ray runs in the plane",
                &FLOOR,
                [0.0, -1.0, 0.0],
                [1.0, 0.0, 0.0],
            ),
        ];
        let mut limited = case(
            "the plane lies beyond the range",
            &TRIANGLE,
            [1.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
        );
        limited.input.range.max = 4.0;
        cases.push(limited);
        cases.extend(seeded_polygons(
            30,
            seeds.stream(6),
            "a seeded polygon and ray",
        ));
        cases
    },
    given,
    answer: |student, case, _| {
        of_plane_t(student(&case.polygon, &case.ray, case.range, Sides::Both))
    },
    own: |polygon, ray, range, sides| Own.plane_t(polygon, ray, range, sides),
    mistaken: |wrong, case| match wrong {
        Wrong::PlaneT(wrong) => Some(of_plane_t(wrong(
            &case.polygon,
            &case.ray,
            case.range,
            Sides::Both,
        ))),
        _ => None,
    },
    forms: &[],
    scenery,
    marks: Some(|case, answer| {
        let t: Vec<f64> = answer
            .iter()
            .filter_map(|(_, _, value)| value.number())
            .collect();
        points_at(&case.ray, &t)
    }),
};

fn of_axis(axis: Axis) -> Answer {
    let name = match axis {
        Axis::X => "x",
        Axis::Y => "y",
        Axis::Z => "z",
    };
    answer(Part::Axis, Value::word(name))
}

/// The coordinate that the projection drops.
pub static DROPPED_AXIS: Task<DVec3, fn(DVec3) -> Axis> = Task {
    about: About {
        lesson: 6,
        name: "dropped_axis",
        title: "the axis whose coordinate is dropped",
        signature: "pub fn dropped_axis(normal: DVec3) -> Axis",
        parts: &[Part::Axis],
        uses: &[Part::Plane],
        mistakes: &["axis of the smallest coefficient"],
        see: see(8, Kind::PolygonTest),
        hints: [
            "Along which axis must you look to see the polygon as large as possible?",
            "The axis of the coefficient A, B or C with the largest absolute value.",
            "Compare |A|, |B| and |C|: with normal.abs(), and then Axis::X, Axis::Y or Axis::Z.",
        ],
        take_away: "Seen along the axis of the largest coefficient, the outline is never thin.",
        next: "the figure 06-polygon/badly-chosen, then l06_crossings",
    },
    cases: |seeds| {
        let case = |note: &str, normal: [f64; 3]| Case::new(note, DVec3::from(normal));
        let mut cases = vec![
            case("a floor: the normal is the y axis", [0.0, 1.0, 0.0]),
            case("a wall: the normal is the z axis", [0.0, 0.0, 1.0]),
            case("a side wall: the normal is the x axis", [1.0, 0.0, 0.0]),
            case("a negative coefficient is the largest", [0.48, -0.8, 0.36]),
            case("two negative coefficients", [-0.6, 0.0, -0.8]),
        ];
        let mut seeded = seeds.stream(66);
        while cases.len() < 30 {
            let normal = seeded.direction();
            let mut sizes = normal.abs().to_array();
            sizes.sort_by(f64::total_cmp);
            if 0.05 < sizes[2] - sizes[1] {
                cases.push(Case::new("a seeded normal", normal));
            }
        }
        cases
    },
    given: |normal| format!("(A, B, C) = {}", vector(*normal)),
    answer: |student, normal, _| of_axis(student(*normal)),
    own: Axis::of_largest,
    mistaken: |wrong, normal| match wrong {
        Wrong::DroppedAxis(wrong) => Some(of_axis(wrong(*normal))),
        _ => None,
    },
    forms: &[],
    scenery: |normal| vec![mark(SketchForm::Arrow(DVec3::ZERO, *normal), "N")],
    marks: Some(|_, answer| {
        let axis = |word: &Value| match word {
            Value::Word(word) if word == "x" => Some((DVec3::X, "x")),
            Value::Word(word) if word == "y" => Some((DVec3::Y, "y")),
            Value::Word(word) if word == "z" => Some((DVec3::Z, "z")),
            _ => None,
        };
        let axes = answer.iter().filter_map(|(_, _, value)| axis(value));
        axes.map(|(axis, name)| mark(SketchForm::Arrow(DVec3::ZERO, axis), name))
            .collect()
    }),
};

/// Polygons across z, hit from the front along −z: then p′ is (x, y) of the ray.
fn flat_cases(seeds: &Seeds) -> Vec<Case<PolygonRay>> {
    let at = |note: &str, vertices: &[[f64; 3]], [x, y]: [f64; 2]| {
        case(note, vertices, [x, y, 9.0], [0.0, 0.0, -1.0])
    };
    let mut cases = vec![
        at("p′ lies inside a triangle", &TRIANGLE, [1.0, 1.0]),
        at(
            "p′ lies beside the triangle: no edge is crossed",
            &TRIANGLE,
            [5.0, 1.0],
        ),
        at(
            "p′ lies outside, and two edges are crossed",
            &TRIANGLE,
            [-1.0, 1.0],
        ),
        at("a concave outline, p′ in the notch", &CONCAVE, [2.0, 2.0]),
        at(
            "a concave outline, p′ in its upper arm",
            &CONCAVE,
            [0.5, 2.0],
        ),
        at(
            "p′ is as high as a vertex in which one edge ends and one begins: it counts once",
            &RHOMBUS,
            [0.5, 0.0],
        ),
        at("p′ is as high as a vertex, outside", &RHOMBUS, [-3.0, 0.0]),
        at(
            "p′ is as high as the bottom of a valley, inside to the left of it",
            &PEAKS,
            [1.5, 2.0],
        ),
        at(
            "p′ is as high as the top vertex, and outside",
            &RHOMBUS,
            [-1.0, 2.0],
        ),
        at(
            "p′ is as high as a level edge, inside to the left of it",
            &GAP,
            [1.0, 2.0],
        ),
        at(
            "p′ is as high as a level edge, outside to the left of it",
            &GAP,
            [-1.0, 2.0],
        ),
        at(
            "p′ is as high as the lower edge, outside to the left of it",
            &GAP,
            [-1.0, 0.0],
        ),
    ];
    let mut seeded = seeds.stream(666);
    while cases.len() < 50 {
        let [x, y] = [seeded.within(-1.0, 8.0), seeded.within(-1.0, 5.0)];
        let vertices: &[[f64; 3]] = if seeded.number() < 0.5 { &PEAKS } else { &GAP };
        let new = at("a seeded point", vertices, [x, y]);
        if 0.02 < clearance(&new.input) {
            cases.push(new);
        }
    }
    cases
}

fn of_crossings(count: usize) -> Answer {
    answer(Part::Crossings, Value::Parity(count as u64))
}

/// How many edges cross the half-line from p′ to the right?
fn crossings(outline: &[DVec2], p: DVec2) -> usize {
    let next = outline.iter().cycle().skip(1);
    let edges = outline.iter().zip(next);
    let crosses = |(from, to): &(&DVec2, &DVec2)| {
        (p.y < from.y) != (p.y < to.y) && {
            let share = (p.y - from.y) / (to.y - from.y);
            p.x < from.x + share * (to.x - from.x)
        }
    };
    edges.filter(crosses).count()
}

fn projected(case: &PolygonRay) -> DVec2 {
    case.polygon.dropped().drop_from(case.ray.at(case.t()))
}

/// The edges that cross the half-line.
pub static CROSSINGS: Task<PolygonRay, fn(&[DVec2], DVec2) -> usize> = Task {
    about: About {
        lesson: 6,
        name: "crossings",
        title: "how many edges cross the half-line from p′",
        signature: "pub fn crossings(outline: &[DVec2], p: DVec2) -> usize",
        parts: &[Part::Projection, Part::Crossings],
        uses: &[Part::Axis, Part::PlaneT],
        mistakes: &["vertex twice", "≤ at both ends"],
        see: see(3, Kind::Edge),
        hints: [
            "An edge counts if its ends lie on different sides of the line through p′ and it passes p′ on the right. Which end of an edge belongs to which side?",
            "The ends are on different sides if (p.y < from.y) ≠ (p.y < to.y); the edge is at from.x + (p.y − from.y)/(to.y − from.y)·(to.x − from.x).",
            "if (p.y < from.y) != (p.y < to.y) { let x = from.x + (p.y - from.y) / (to.y - from.y) * (to.x - from.x); if p.x < x { count += 1; } }",
        ],
        take_away: "With < at one end and ≤ at the other, a vertex counts once and a level edge never.",
        next: "l06_inside",
    },
    cases: flat_cases,
    given: |case| {
        let corners: Vec<String> = case
            .polygon
            .outline()
            .iter()
            .map(|p| format!("({}, {})", number(p.x, 4), number(p.y, 4)))
            .collect();
        let p = projected(case);
        format!(
            "p′ = ({}, {}), outline {}",
            number(p.x, 6),
            number(p.y, 6),
            corners.join(" ")
        )
    },
    answer: |student, case, _| of_crossings(student(case.polygon.outline(), projected(case))),
    own: crossings,
    mistaken: |wrong, case| match wrong {
        Wrong::Inside(wrong) => Some(of_crossings(usize::from(wrong(
            &case.polygon,
            &case.ray,
            case.t(),
        )))),
        _ => None,
    },
    forms: &[],
    scenery: |case| {
        let flat = |p: &DVec2| DVec3::new(p.x, p.y, 0.0);
        let outline: Vec<DVec3> = case.polygon.outline().iter().map(flat).collect();
        let right = outline.iter().map(|p| p.x).fold(0.0, f64::max) + 1.0;
        let p = flat(&projected(case));
        vec![
            mark(SketchForm::Outline(outline), ""),
            mark(
                SketchForm::Line(p, DVec3::new(right, p.y, 0.0)),
                "half-line",
            ),
            mark(SketchForm::Dot(p), "p′"),
        ]
    },
    marks: Some(|_, _| Vec::new()),
};

fn of_inside(is_inside: bool) -> Answer {
    answer(
        Part::InsideOut,
        Value::word(if is_inside { "inside" } else { "outside" }),
    )
}

/// Whether the point at t lies inside the polygon.
pub static INSIDE: Task<PolygonRay, fn(&Polygon, &Ray, f64) -> bool> = Task {
    about: About {
        lesson: 6,
        name: "inside",
        title: "whether the point on the plane lies inside the polygon",
        signature: "pub fn inside(polygon: &Polygon, ray: &Ray, t: f64) -> bool",
        parts: &[Part::PlanePoint, Part::InsideOut],
        uses: &[Part::Ray, Part::Axis, Part::Projection, Part::Crossings],
        mistakes: &[
            "axis of the smallest coefficient",
            "vertex twice",
            "≤ at both ends",
        ],
        see: see(8, Kind::PolygonTest),
        hints: [
            "First the point p on the plane, then its projection p′, then count.",
            "p = o + t·Δ; p′ is p without the coordinate of the dropped axis; an odd number of crossings means inside.",
            "crossings(polygon.outline(), polygon.dropped().drop_from(ray.at(t))) % 2 == 1",
        ],
        take_away: "Point in polygon is a question in the plane: drop a coordinate, then count.",
        next: "lesson 7, and your own picture",
    },
    cases: |seeds| {
        let mut cases = vec![
            case(
                "a polygon across z, inside",
                &TRIANGLE,
                [1.0, 1.0, 0.0],
                [0.0, 0.0, 1.0],
            ),
            case(
                "a floor: another coordinate is dropped",
                &FLOOR,
                [1.0, 2.0, 1.0],
                [0.0, -1.0, 0.0],
            ),
            case(
                "a floor, outside",
                &FLOOR,
                [9.0, 2.0, 1.0],
                [0.0, -1.0, 0.0],
            ),
            case(
                "a side wall",
                &[
                    [3.0, 0.0, 0.0],
                    [3.0, 2.0, 0.0],
                    [3.0, 2.0, 2.0],
                    [3.0, 0.0, 2.0],
                ],
                [0.0, 0.5, 0.25],
                [1.0, 0.0, 0.0],
            ),
        ];
        cases.extend(flat_cases(seeds));
        cases.extend(seeded_polygons(
            40,
            seeds.stream(6666),
            "a seeded polygon, aslant",
        ));
        cases
    },
    given: |case| {
        let corners: Vec<_> = case.polygon.vertices().map(vector).collect();
        format!(
            "p = {}, vertices {}",
            vector(case.ray.at(case.t())),
            corners.join(" ")
        )
    },
    answer: |student, case, _| of_inside(student(&case.polygon, &case.ray, case.t())),
    own: |polygon, ray, t| Own.inside(polygon, ray, t),
    mistaken: |wrong, case| match wrong {
        Wrong::Inside(_) | Wrong::DroppedAxis(_) => {
            Some(of_inside(wrong.inside(&case.polygon, &case.ray, case.t())))
        }
        _ => None,
    },
    forms: &[],
    scenery: |case| {
        vec![
            mark(SketchForm::Outline(case.polygon.vertices().collect()), ""),
            mark(SketchForm::Dot(case.ray.at(case.t())), "p"),
        ]
    },
    marks: Some(|_, _| Vec::new()),
};
