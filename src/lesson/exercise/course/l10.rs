//! Lesson 10: bounding volumes.

use glam::DVec3;

use crate::explain::Part;
use crate::figure::{SketchForm, SketchMark};
use crate::geometry::{AxisBox, Inside, PARALLEL, Ray, SlabInterval, SlabRay, Sphere, TRange};
use crate::lesson::exercise::course::shared::{arrow, mark, said_ray};
use crate::lesson::exercise::value::{number, vector};
use crate::lesson::exercise::{About, Answer, Case, Exercise, Form, See, Task, Value};
use crate::mistake::Wrong;
use crate::trace::{BoundVerdict, Kind};

pub(super) static ALL: [&dyn Exercise; 7] = [
    &SPHERE_AROUND,
    &SLAB_OF,
    &SLAB_RAY,
    &SLAB_INTERVAL,
    &INTERVAL,
    &BOUND_VERDICT,
    &UNION,
];

const fn see(strategy: &'static str, kind: Kind, at: u32) -> See {
    See::Step {
        scene: "10-bounds/slabs.json",
        pixel: [20, 15],
        strategy,
        at,
        kind,
    }
}

fn sphere_around(around: &AxisBox) -> Sphere {
    Sphere {
        center: around.min.midpoint(around.max),
        radius: 0.5 * around.size().length(),
    }
}

/// The outline of a box as it is seen along z.
fn box_mark(around: &AxisBox) -> SketchMark {
    let (low, high) = (around.min, around.max);
    let corners = vec![
        low,
        DVec3::new(high.x, low.y, low.z),
        DVec3::new(high.x, high.y, low.z),
        DVec3::new(low.x, high.y, low.z),
    ];
    mark(SketchForm::Outline(corners), "box")
}

/// The smallest sphere around a box.
pub static SPHERE_AROUND: Task<AxisBox, fn(&AxisBox) -> Sphere> = Task {
    about: About {
        lesson: 10,
        name: "sphere_around",
        title: "the smallest sphere around a box",
        signature: "pub fn sphere_around(around: &AxisBox) -> Sphere",
        parts: &[Part::Bound],
        uses: &[Part::Coefficients],
        mistakes: &[],
        see: see("bounds", Kind::BoundTest, 2),
        hints: [
            "All corners are equally far from the middle of the box.",
            "centre = (min + max)/2, r = |max − min|/2",
            "Sphere { center: around.min.midpoint(around.max), radius: 0.5 * (around.max - around.min).length() }",
        ],
        take_away: "A sphere is quick to test, but around a long box most of it is empty: wasted tests.",
        next: "the figure 10-bounds/volumes, then l10_slab_of",
    },
    cases: |seeds| {
        let case = |note: &str, min: [f64; 3], max: [f64; 3]| {
            Case::new(
                note,
                AxisBox {
                    min: min.into(),
                    max: max.into(),
                },
            )
        };
        let mut cases = vec![
            case("a cube around the origin", [-1.0; 3], [1.0; 3]),
            case("a cube beside the origin", [2.0, 2.0, 2.0], [4.0, 4.0, 4.0]),
            case(
                "a long box: the corners are further away than the faces",
                [0.0; 3],
                [10.0, 1.0, 1.0],
            ),
            case("a flat box", [-3.0, 0.0, -4.0], [3.0, 0.0, 4.0]),
            case(
                "negative coordinates",
                [-5.0, -4.0, -3.0],
                [-1.0, -2.0, -1.0],
            ),
        ];
        let mut seeded = seeds.stream(10);
        while cases.len() < 20 {
            let around = AxisBox::around([seeded.point(5.0), seeded.point(5.0)]);
            cases.push(Case::new("a seeded box", around));
        }
        cases
    },
    given: |around| format!("min = {}, max = {}", vector(around.min), vector(around.max)),
    answer: |student, around, _| {
        let Sphere { center, radius } = student(around);
        vec![
            (Part::Bound, "centre", center.into()),
            (Part::Bound, "r", radius.into()),
        ]
    },
    own: sphere_around,
    mistaken: |_, _| None,
    forms: &[],
    scenery: |around| vec![box_mark(around)],
    marks: Some(|_, answer| match &answer[..] {
        [(_, _, Value::Vector(center)), (_, _, Value::Number(radius))] => {
            vec![mark(SketchForm::Circle(*center, *radius), "")]
        }
        _ => Vec::new(),
    }),
};

/// The vertices of an object, and the normal of a slab.
#[derive(Clone, Debug)]
pub struct Object {
    points: Vec<DVec3>,
    n: DVec3,
}

fn slab_of(points: &[DVec3], n: DVec3) -> [f64; 2] {
    let d = points.iter().map(|point| -n.dot(*point));
    d.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], d| {
        [low.min(d), high.max(d)]
    })
}

fn of_slab([d_min, d_max]: [f64; 2]) -> Answer {
    vec![
        (Part::Bound, "D_min", d_min.into()),
        (Part::Bound, "D_max", d_max.into()),
    ]
}

/// A slab around an object.
pub static SLAB_OF: Task<Object, fn(&[DVec3], DVec3) -> [f64; 2]> = Task {
    about: About {
        lesson: 10,
        name: "slab_of",
        title: "D_min and D_max of the slab around an object",
        signature: "pub fn slab_of(vertices: &[DVec3], n: DVec3) -> [f64; 2]",
        parts: &[Part::Bound],
        uses: &[Part::Plane],
        mistakes: &[],
        see: see("hierarchy", Kind::SlabTest, 5),
        hints: [
            "Through each vertex runs a plane A·x + B·y + C·z + D = 0 with the slab's normal. What is its D?",
            "D = −n·v of each vertex v; D_min is the smallest and D_max the largest of them.",
            "vertices.iter().map(|v| -n.dot(*v)), and fold with min and max.",
        ],
        take_away: "A larger D is a plane further back along the normal: D_min belongs to the furthest vertex.",
        next: "the figure 10-bounds/slabs, then l10_slab_ray",
    },
    cases: |seeds| {
        let case = |note: &str, points: &[[f64; 3]], n: [f64; 3]| {
            let points = points.iter().map(|point| DVec3::from(*point)).collect();
            Case::new(
                note,
                Object {
                    points,
                    n: n.into(),
                },
            )
        };
        let triangle = [[1.0, 0.0, 0.0], [3.0, 0.0, 0.0], [2.0, 2.0, 0.0]];
        let mut cases = vec![
            case("across x", &triangle, [1.0, 0.0, 0.0]),
            case("across y", &triangle, [0.0, 1.0, 0.0]),
            case(
                "the object is flat along the normal: D_min = D_max",
                &triangle,
                [0.0, 0.0, 1.0],
            ),
            case("a slanted normal", &triangle, [0.6, 0.8, 0.0]),
            case(
                "the turned normal exchanges and turns both",
                &triangle,
                [-1.0, 0.0, 0.0],
            ),
        ];
        let mut seeded = seeds.stream(110);
        while cases.len() < 25 {
            let points: Vec<[f64; 3]> = (0..5).map(|_| seeded.point(4.0).to_array()).collect();
            cases.push(case(
                "five seeded vertices",
                &points,
                seeded.direction().to_array(),
            ));
        }
        cases
    },
    given: |case| {
        let points: Vec<String> = case.points.iter().map(|point| vector(*point)).collect();
        format!("n = {}, vertices {}", vector(case.n), points.join(" "))
    },
    answer: |student, case, _| of_slab(student(&case.points, case.n)),
    own: slab_of,
    mistaken: |_, _| None,
    forms: &[Form {
        is: |case, yours| {
            let [d_min, d_max] = slab_of(&case.points, case.n);
            let along = of_slab([-d_max, -d_min]);
            yours
                .iter()
                .zip(&along)
                .all(|(yours, along)| yours.2.is_same(&along.2))
        },
        note: "these are the smallest and the largest n·v; the planes are n·v + D = 0, so D = −n·v",
    }],
    scenery: |case| {
        let mut marks = vec![mark(SketchForm::Outline(case.points.clone()), "")];
        marks.push(arrow(case.points[0], case.n, "n"));
        marks
    },
    marks: Some(|case, answer| {
        let d = answer
            .iter()
            .filter_map(|(_, name, value)| Some((name, value.number()?)));
        d.map(|(name, d)| mark(SketchForm::Dot(-d * case.n), name))
            .collect()
    }),
};

/// A ray, and the normal of a slab.
#[derive(Clone, Copy, Debug)]
pub struct RayNormal {
    ray: Ray,
    n: DVec3,
}

fn of_slab_ray(line: SlabRay) -> Answer {
    // a ray that is parallel within rounding has a T of some 10²⁰⁰ or ∞ of either sign
    let is_parallel = PARALLEL < line.t_scale.abs();
    let t_scale = if is_parallel {
        Value::word("infinite: parallel")
    } else {
        line.t_scale.into()
    };
    vec![
        (Part::SlabRay, "S", line.s.into()),
        (Part::SlabRay, "T", t_scale),
    ]
}

/// S and T, once for each ray.
pub static SLAB_RAY: Task<RayNormal, fn(&Ray, DVec3) -> SlabRay> = Task {
    about: About {
        lesson: 10,
        name: "slab_ray",
        title: "S and T of a ray and a direction of slabs",
        signature: "pub fn slab_ray(ray: &Ray, normal: DVec3) -> SlabRay",
        parts: &[Part::SlabRay],
        uses: &[Part::Plane, Part::PlaneT],
        mistakes: &[],
        see: see("hierarchy", Kind::SlabRay, 2),
        hints: [
            "Look at equation (v): which parts of it do not depend on D, and so are the same for all slabs with this normal?",
            "S = A·x₀ + B·y₀ + C·z₀, T = −1/(A·Δx + B·Δy + C·Δz); then t = (S + D)·T",
            "SlabRay { s: normal.dot(ray.origin), t_scale: -1.0 / normal.dot(ray.direction) }",
        ],
        take_away: "S and T are computed once for a ray; each slab of any object then costs an addition and a product.",
        next: "l10_slab_interval",
    },
    cases: |seeds| {
        let case = |note: &str, origin: [f64; 3], direction: [f64; 3], n: [f64; 3]| {
            Case::new(
                note,
                RayNormal {
                    ray: Ray::new(origin.into(), direction.into()),
                    n: n.into(),
                },
            )
        };
        let x = [1.0, 0.0, 0.0];
        let mut cases = vec![
            case(
                "the ray runs along the normal",
                [3.0, 1.0, 1.0],
                [1.0, 0.0, 0.0],
                x,
            ),
            case(
                "the ray runs against the normal",
                [3.0, 1.0, 1.0],
                [-1.0, 0.0, 0.0],
                x,
            ),
            case("aslant", [2.0, 0.0, 0.0], [0.6, 0.8, 0.0], x),
            case(
                "a slanted normal",
                [2.0, 1.0, 0.0],
                [1.0, 0.0, 0.0],
                [0.6, 0.8, 0.0],
            ),
            case(
                "the ray is parallel to the slab: T is infinite",
                [2.0, 1.0, 0.0],
                [0.0, 1.0, 0.0],
                x,
            ),
        ];
        let mut seeded = seeds.stream(1010);
        while cases.len() < 25 {
            let [direction, n] = [seeded.direction(), seeded.direction()];
            if 0.05 < direction.dot(n).abs() {
                cases.push(case(
                    "a seeded ray and normal",
                    seeded.point(5.0).to_array(),
                    direction.to_array(),
                    n.to_array(),
                ));
            }
        }
        cases
    },
    given: |case| format!("{}, (A, B, C) = {}", said_ray(&case.ray), vector(case.n)),
    answer: |student, case, _| of_slab_ray(student(&case.ray, case.n)),
    own: SlabRay::new,
    mistaken: |_, _| None,
    forms: &[Form {
        is: |case, yours| {
            let [s, along] = [case.n.dot(case.ray.origin), case.n.dot(case.ray.direction)];
            yours == &of_slab_ray(SlabRay { s, t_scale: -along })
        },
        note: "this T belongs to t = (S + D)/T; here T = −1/(A·Δx + B·Δy + C·Δz), and t = (S + D)·T",
    }],
    scenery: |case| {
        vec![
            arrow(case.ray.origin, case.ray.direction, "Δ"),
            arrow(case.ray.origin, case.n, "n"),
        ]
    },
    marks: None,
};

/// S and T of a ray, and D of a slab.
#[derive(Clone, Copy, Debug)]
pub struct LineSlab {
    line: SlabRay,
    d_min: f64,
    d_max: f64,
}

fn of_interval(interval: SlabInterval) -> Answer {
    let (near, far) = match interval {
        SlabInterval::Between { near, far } => (near.into(), far.into()),
        SlabInterval::ParallelInside => (
            Value::word("parallel, inside: every t"),
            Value::word("every t"),
        ),
        SlabInterval::ParallelOutside => {
            (Value::word("parallel, outside: no t"), Value::word("no t"))
        }
    };
    vec![(Part::NearFar, "near", near), (Part::NearFar, "far", far)]
}

/// near and far of a slab.
pub static SLAB_INTERVAL: Task<LineSlab, fn(&SlabRay, f64, f64) -> SlabInterval> = Task {
    about: About {
        lesson: 10,
        name: "slab_interval",
        title: "near and far of one slab",
        signature: "pub fn slab_interval(line: &SlabRay, d_min: f64, d_max: f64) -> SlabInterval",
        parts: &[Part::NearFar],
        uses: &[Part::SlabRay],
        mistakes: &["divides by zero", "no swap"],
        see: see("hierarchy", Kind::SlabTest, 5),
        hints: [
            "Each plane of the slab gives a t. Which one is near depends on which way the ray runs. And if it is parallel?",
            "t = (S + D)·T for D_min and D_max, the smaller is near. T infinite: every t if S + D_min ≤ 0 ≤ S + D_max, else none.",
            "if line.t_scale.is_infinite() { inside or outside } else { let a = (line.s + d_min) * line.t_scale; … near: a.min(b), far: a.max(b) }",
        ],
        take_away: "Parallel is its own case, before any product: 0·∞ is no number.",
        next: "the figure 10-bounds/intervals, then l10_interval",
    },
    cases: |seeds| {
        let case = |note: &str, origin: f64, direction: f64, [d_min, d_max]: [f64; 2]| {
            let ray = Ray::new(DVec3::X * origin, DVec3::new(direction, 1.0, 0.0));
            let line = SlabRay::new(&ray, DVec3::X);
            Case::new(note, LineSlab { line, d_min, d_max })
        };
        // 1 ≤ x ≤ 3 is D from −3 to −1
        let slab = [-3.0, -1.0];
        let mut cases = vec![
            case("the ray runs towards the slab", 0.0, 0.5, slab),
            case(
                "the ray runs the other way: near and far change places",
                6.0,
                -0.5,
                slab,
            ),
            case(
                "the ray starts in the slab: near is negative",
                2.0,
                0.5,
                slab,
            ),
            case("the slab lies behind: both are negative", 6.0, 0.5, slab),
            case("the ray is parallel, inside the slab", 2.0, 0.0, slab),
            case("the ray is parallel, outside of the slab", 5.0, 0.0, slab),
            case("the ray is parallel, on the other side", 0.0, 0.0, slab),
            case(
                "the ray is parallel, in the face of the slab: that counts as inside",
                1.0,
                0.0,
                slab,
            ),
        ];
        let mut seeded = seeds.stream(1011);
        while cases.len() < 40 {
            let low = seeded.within(-5.0, 5.0);
            let direction = seeded.within(-2.0, 2.0);
            if 0.05 < direction.abs() {
                cases.push(case(
                    "a seeded slab",
                    seeded.within(-9.0, 9.0),
                    direction,
                    [low, low + seeded.within(0.1, 4.0)],
                ));
            }
        }
        cases
    },
    given: |case| {
        format!(
            "S = {}, T = {}, D_min = {}, D_max = {}",
            number(case.line.s, 6),
            number(case.line.t_scale, 6),
            number(case.d_min, 6),
            number(case.d_max, 6)
        )
    },
    answer: |student, case, _| of_interval(student(&case.line, case.d_min, case.d_max)),
    own: SlabRay::interval,
    mistaken: |wrong, case| match wrong {
        Wrong::SlabInterval(wrong) => Some(of_interval(wrong(&case.line, case.d_min, case.d_max))),
        _ => None,
    },
    forms: &[],
    scenery: |_| Vec::new(),
    marks: None,
};

/// What is left of a ray inside the slabs so far, and one more slab.
#[derive(Clone, Copy, Debug)]
pub struct OneMore {
    so_far: Inside,
    slab: SlabInterval,
}

fn of_inside(inside: Inside) -> Answer {
    let [near, far] = if inside.is_empty() || inside.near.is_nan() {
        ["empty", "empty"].map(Value::word)
    } else {
        [inside.near, inside.far].map(Value::Number)
    };
    vec![
        (Part::Interval, "max near", near),
        (Part::Interval, "min far", far),
    ]
}

fn said_interval(slab: SlabInterval) -> String {
    match slab {
        SlabInterval::Between { near, far } => {
            format!("near {}, far {}", number(near, 6), number(far, 6))
        }
        SlabInterval::ParallelInside => "parallel, inside".into(),
        SlabInterval::ParallelOutside => "parallel, outside".into(),
    }
}

/// The interval inside all slabs, slab by slab.
pub static INTERVAL: Task<OneMore, fn(Inside, SlabInterval) -> Inside> = Task {
    about: About {
        lesson: 10,
        name: "interval",
        title: "what is left of the interval inside one more slab",
        signature: "pub fn interval(so_far: Inside, slab: SlabInterval) -> Inside",
        parts: &[Part::Interval],
        uses: &[Part::NearFar],
        mistakes: &["running interval thrown away"],
        see: see("hierarchy", Kind::SlabTest, 5),
        hints: [
            "The ray is inside all slabs from where it entered the last of them to where it leaves the first of them.",
            "near = max(near, nearᵢ), far = min(far, farᵢ); parallel inside changes nothing, parallel outside leaves nothing.",
            "Inside { near: so_far.near.max(near), far: so_far.far.min(far) }; so_far; Inside::NOWHERE",
        ],
        take_away: "The largest near and the smallest far decide; the interval is empty where they have crossed.",
        next: "the figure 10-bounds/null, then l10_bound_verdict",
    },
    cases: |seeds| {
        let case = |note: &str, [near, far]: [f64; 2], slab: SlabInterval| {
            Case::new(
                note,
                OneMore {
                    so_far: Inside { near, far },
                    slab,
                },
            )
        };
        let between = |near, far| SlabInterval::Between { near, far };
        let mut cases = vec![
            Case::new(
                "the first slab",
                OneMore {
                    so_far: Inside::EVERYWHERE,
                    slab: between(2.0, 6.0),
                },
            ),
            case(
                "the second slab begins later and ends later",
                [2.0, 6.0],
                between(3.0, 9.0),
            ),
            case(
                "the second slab holds the interval: nothing changes",
                [2.0, 6.0],
                between(1.0, 9.0),
            ),
            case(
                "the second slab lies inside the interval",
                [2.0, 6.0],
                between(3.0, 4.0),
            ),
            case(
                "the second slab begins where the first has ended: empty",
                [2.0, 6.0],
                between(7.0, 9.0),
            ),
            case(
                "parallel, inside the slab",
                [2.0, 6.0],
                SlabInterval::ParallelInside,
            ),
            case(
                "parallel, outside of the slab: empty",
                [2.0, 6.0],
                SlabInterval::ParallelOutside,
            ),
            case("they touch at one t", [2.0, 6.0], between(6.0, 9.0)),
        ];
        let mut seeded = seeds.stream(1012);
        while cases.len() < 30 {
            let [near, low] = [seeded.within(-5.0, 5.0), seeded.within(-5.0, 5.0)];
            let ends = [near, near + seeded.within(0.1, 6.0)];
            cases.push(case(
                "a seeded slab",
                ends,
                between(low, low + seeded.within(0.1, 6.0)),
            ));
        }
        cases
    },
    given: |case| {
        let Inside { near, far } = case.so_far;
        format!(
            "so far from {} to {}; {}",
            number(near, 6),
            number(far, 6),
            said_interval(case.slab)
        )
    },
    answer: |student, case, _| of_inside(student(case.so_far, case.slab)),
    own: Inside::and,
    mistaken: |wrong, case| match wrong {
        Wrong::SlabsSoFar(wrong) => Some(of_inside(wrong(case.so_far, case.slab))),
        _ => None,
    },
    forms: &[],
    scenery: |_| Vec::new(),
    marks: None,
};

/// Where a ray is inside a volume, and which t count.
#[derive(Clone, Copy, Debug)]
pub struct Bounded {
    inside: Option<[f64; 2]>,
    range: TRange,
}

fn of_verdict(verdict: BoundVerdict) -> Answer {
    let word = match verdict {
        BoundVerdict::Hit => "hit",
        BoundVerdict::Missed => "missed",
        BoundVerdict::Behind => "behind the origin",
        BoundVerdict::Beyond => "beyond the nearest hit",
    };
    vec![(Part::Bound, "", Value::word(word))]
}

/// Whether what is inside a volume must be tested.
pub static BOUND_VERDICT: Task<Bounded, fn(Option<[f64; 2]>, TRange) -> BoundVerdict> = Task {
    about: About {
        lesson: 10,
        name: "bound_verdict",
        title: "whether what is inside a bounding volume must be tested",
        signature: "pub fn bound_verdict(inside: Option<[f64; 2]>, range: TRange) -> BoundVerdict",
        parts: &[Part::Bound],
        uses: &[Part::Interval, Part::Choice],
        mistakes: &["near < 0 is a miss"],
        see: see("bounds", Kind::BoundTest, 2),
        hints: [
            "A volume that the ray starts in must be tested. Which of near and far says that it lies behind?",
            "None: missed. far < range.min: behind. range.max < near: beyond. Else: hit. Equality counts as hit.",
            "match inside { None => Missed, Some([_, far]) if far < range.min => Behind, Some([near, _]) if range.max < near => Beyond, Some(_) => Hit }",
        ],
        take_away: "A hit with the volume is no hit with the object, and a negative near means that the ray starts inside.",
        next: "l10_union",
    },
    cases: |seeds| {
        let case = |note: &str, inside: Option<[f64; 2]>, [min, max]: [f64; 2]| {
            Case::new(
                note,
                Bounded {
                    inside,
                    range: TRange { min, max },
                },
            )
        };
        let ahead = [0.0, f64::INFINITY];
        let mut cases = vec![
            case("the volume lies ahead", Some([1.0, 2.0]), ahead),
            case("the ray passes by", None, ahead),
            case(
                "the ray starts inside the volume: near is negative",
                Some([-1.0, 2.0]),
                ahead,
            ),
            case("the volume lies behind", Some([-2.0, -1.0]), ahead),
            case(
                "the nearest hit so far lies before the volume",
                Some([4.0, 6.0]),
                [0.0, 3.0],
            ),
            case(
                "the nearest hit so far lies inside the volume",
                Some([2.0, 6.0]),
                [0.0, 3.0],
            ),
            case(
                "the volume begins at the nearest hit: equality counts",
                Some([3.0, 6.0]),
                [0.0, 3.0],
            ),
        ];
        let mut seeded = seeds.stream(1013);
        while cases.len() < 25 {
            let near = seeded.within(-5.0, 5.0);
            let ends = [near, near + seeded.within(0.1, 4.0)];
            cases.push(case(
                "a seeded volume",
                Some(ends),
                [0.0, seeded.within(1.0, 6.0)],
            ));
        }
        cases
    },
    given: |case| {
        let inside = case.inside.map_or("nowhere inside".into(), |[near, far]| {
            format!("near {}, far {}", number(near, 6), number(far, 6))
        });
        format!(
            "{inside}, t from {} to {}",
            number(case.range.min, 6),
            number(case.range.max, 6)
        )
    },
    answer: |student, case, _| of_verdict(student(case.inside, case.range)),
    own: BoundVerdict::of,
    mistaken: |wrong, case| match wrong {
        Wrong::Bound(wrong) => Some(of_verdict(wrong(case.inside, case.range))),
        _ => None,
    },
    forms: &[],
    scenery: |_| Vec::new(),
    marks: None,
};

/// D_min and D_max of each slab, of two bounds.
#[derive(Clone, Debug)]
pub struct TwoBounds {
    one: Vec<[f64; 2]>,
    other: Vec<[f64; 2]>,
}

fn union(one: &[[f64; 2]], other: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let pairs = one.iter().zip(other);
    pairs
        .map(|(a, b)| [a[0].min(b[0]), a[1].max(b[1])])
        .collect()
}

fn of_union(bound: &[[f64; 2]]) -> Answer {
    let [low, high] =
        [0, 1].map(|end| Value::Numbers(bound.iter().map(|slab| slab[end]).collect()));
    vec![
        (Part::Bound, "D_min of each slab", low),
        (Part::Bound, "D_max of each slab", high),
    ]
}

/// The bound of two bounds.
pub static UNION: Task<TwoBounds, fn(&[[f64; 2]], &[[f64; 2]]) -> Vec<[f64; 2]>> = Task {
    about: About {
        lesson: 10,
        name: "union",
        title: "the bounding volume of two bounding volumes, slab by slab",
        signature: "pub fn union(one: &[[f64; 2]], other: &[[f64; 2]]) -> Vec<[f64; 2]>",
        parts: &[Part::Bound],
        uses: &[Part::Bound],
        mistakes: &[],
        see: See::Figure("10-bounds/merge"),
        hints: [
            "In each slab both volumes must have room.",
            "D_min is the smaller of both D_min, D_max the larger of both D_max, for each slab.",
            "one.iter().zip(other).map(|(a, b)| [a[0].min(b[0]), a[1].max(b[1])]).collect()",
        ],
        take_away: "Slabs of the same directions are joined number by number, without looking at the objects again.",
        next: "the figure 10-bounds/merge, then lesson 11",
    },
    cases: |seeds| {
        let case = |note: &str, one: &[[f64; 2]], other: &[[f64; 2]]| {
            Case::new(
                note,
                TwoBounds {
                    one: one.to_vec(),
                    other: other.to_vec(),
                },
            )
        };
        let mut cases = vec![
            case(
                "two volumes side by side",
                &[[0.0, 1.0], [0.0, 1.0], [0.0, 1.0]],
                &[[2.0, 3.0], [0.0, 1.0], [0.0, 1.0]],
            ),
            case(
                "one volume inside the other",
                &[[0.0, 9.0], [0.0, 9.0], [0.0, 9.0]],
                &[[2.0, 3.0], [4.0, 5.0], [1.0, 2.0]],
            ),
            case(
                "the second volume lies lower",
                &[[0.0, 1.0], [0.0, 1.0], [0.0, 1.0]],
                &[[-3.0, -2.0], [-3.0, -2.0], [0.0, 1.0]],
            ),
            case(
                "they overlap",
                &[[0.0, 4.0], [0.0, 4.0], [0.0, 4.0]],
                &[[3.0, 6.0], [-1.0, 2.0], [1.0, 5.0]],
            ),
            case("seven slabs", &[[0.0, 1.0]; 7], &[[0.5, 2.0]; 7]),
        ];
        let mut seeded = seeds.stream(1014);
        while cases.len() < 20 {
            let mut slabs = || -> Vec<[f64; 2]> {
                let mut slab = || {
                    let low = seeded.within(-5.0, 5.0);
                    [low, low + seeded.within(0.1, 4.0)]
                };
                (0..3).map(|_| slab()).collect()
            };
            let (one, other) = (slabs(), slabs());
            cases.push(case("two seeded volumes", &one, &other));
        }
        cases
    },
    given: |case| {
        let said = |bound: &[[f64; 2]]| {
            let slabs: Vec<String> = bound
                .iter()
                .map(|[low, high]| format!("[{}, {}]", number(*low, 4), number(*high, 4)))
                .collect();
            slabs.join(" ")
        };
        format!("{} and {}", said(&case.one), said(&case.other))
    },
    answer: |student, case, _| of_union(&student(&case.one, &case.other)),
    own: union,
    mistaken: |_, _| None,
    forms: &[],
    scenery: |_| Vec::new(),
    marks: None,
};
