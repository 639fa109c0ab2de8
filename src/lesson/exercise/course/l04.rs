//! Lesson 4: the sphere.

use crate::explain::Part;
use crate::figure::{SketchForm, SketchMark};
use crate::geometry::{Ray, Roots, Sides, Sphere, TRange};
use crate::lesson::exercise::course::shared::{mark, points_at, ray_mark, said_range, said_ray};
use crate::lesson::exercise::value::{number, vector};
use crate::lesson::exercise::{
    About, Answer, Case, Exercise, Form, See, Seeds, Task, Value, answer,
};
use crate::mistake::Wrong;
use crate::trace::Kind;
use crate::tracer::simple::{Own, Parts};

pub(super) static ALL: [&'static dyn Exercise; 3] = [&COEFFICIENTS, &ROOTS, &ROOT_THAT_COUNTS];

/// A sphere, a ray, and which t count.
#[derive(Clone, Copy, Debug)]
pub struct SphereRay {
    sphere: Sphere,
    ray: Ray,
    range: TRange,
}

fn case(
    note: &str,
    center: [f64; 3],
    radius: f64,
    origin: [f64; 3],
    direction: [f64; 3],
) -> Case<SphereRay> {
    let sphere = Sphere {
        center: center.into(),
        radius,
    };
    let ray = Ray::new(origin.into(), direction.into());
    Case::new(
        note,
        SphereRay {
            sphere,
            ray,
            range: TRange::FORWARD,
        },
    )
}

/// The same sphere and ray for all three exercises.
fn cases(seeds: &Seeds) -> Vec<Case<SphereRay>> {
    let mut cases = vec![
        case(
            "the sphere lies ahead",
            [0.0, 1.0, 0.0],
            1.0,
            [0.0, 1.0, 6.0],
            [0.0, 0.0, -1.0],
        ),
        case(
            "the ray passes the centre at a distance",
            [1.0, 2.0, -3.0],
            2.0,
            [0.0, 1.0, 6.0],
            [0.0, 0.0, -1.0],
        ),
        case(
            "Δ does not have unit length",
            [0.0, 1.0, 0.0],
            1.0,
            [0.0, 1.0, 6.0],
            [0.0, 0.0, -2.0],
        ),
        case(
            "the ray passes by",
            [0.0, 5.0, 0.0],
            1.0,
            [0.0, 1.0, 6.0],
            [0.0, 0.0, -1.0],
        ),
        case(
            "the ray grazes the sphere",
            [0.0, 0.0, 0.0],
            1.0,
            [-3.0, 1.0, 0.0],
            [1.0, 0.0, 0.0],
        ),
        case(
            "the ray starts inside the sphere",
            [0.0, 0.0, 0.0],
            2.0,
            [1.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
        ),
        case(
            "the sphere lies behind the origin",
            [0.0, 0.0, 9.0],
            1.0,
            [0.0, 0.0, 0.0],
            [0.0, 0.0, -1.0],
        ),
        case(
            "the ray starts in the centre",
            [2.0, 2.0, 2.0],
            3.0,
            [2.0, 2.0, 2.0],
            [0.0, 1.0, 0.0],
        ),
    ];
    let mut seeded = seeds.stream(4);
    while cases.len() < 60 {
        let center = seeded.point(5.0);
        let radius = seeded.within(0.5, 3.0);
        let origin = seeded.point(9.0);
        let target = center + seeded.point(1.2 * radius);
        let direction = (target - origin) * seeded.within(0.1, 0.9);
        let new = case(
            "a seeded sphere and ray",
            center.into(),
            radius,
            origin.into(),
            direction.into(),
        );
        let test = new
            .input
            .sphere
            .test(&new.input.ray, TRange::FORWARD, Sides::Both);
        // far from a graze, and from an origin on the surface
        if 0.01 < test.discriminant.abs() && 0.01 < test.c.abs() {
            cases.push(new);
        }
    }
    cases
}

/// With ranges that a ray of the tracer has.
fn cases_with_ranges(seeds: &Seeds) -> Vec<Case<SphereRay>> {
    let mut cases = cases(seeds);
    let mut ranged = |note: &str, origin: [f64; 3], direction: [f64; 3], [min, max]: [f64; 2]| {
        let mut new = case(note, [0.0; 3], 1.0, origin, direction);
        new.input.range = TRange { min, max };
        cases.insert(8, new);
    };
    ranged(
        "the ray starts on the surface and runs outwards: its root below ε does not count",
        [0.0, 0.0, 1.0],
        [0.0, 0.0, 1.0],
        [1e-9, f64::INFINITY],
    );
    ranged(
        "the ray starts on the surface and runs inwards: the root below ε does not count",
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
        [1e-9, f64::INFINITY],
    );
    ranged(
        "another object was hit at t = 3, before this sphere",
        [0.0, 0.0, 6.0],
        [0.0, 0.0, -1.0],
        [0.0, 3.0],
    );
    ranged(
        "the range ends between the two roots",
        [0.0, 0.0, 6.0],
        [0.0, 0.0, -1.0],
        [0.0, 6.0],
    );
    ranged(
        "t of the root is the end of the range, which counts",
        [0.0, 0.0, 6.0],
        [0.0, 0.0, -1.0],
        [0.0, 5.0],
    );
    cases
}

fn given(case: &SphereRay) -> String {
    let Sphere { center, radius } = case.sphere;
    format!(
        "centre {}, r = {}, {}{}",
        vector(center),
        number(radius, 6),
        said_ray(&case.ray),
        said_range(case.range)
    )
}

fn scenery(case: &SphereRay) -> Vec<SketchMark> {
    let Sphere { center, radius } = case.sphere;
    let reach = (center - case.ray.origin).length() + 1.5 * radius;
    let mut marks = vec![mark(SketchForm::Circle(center, radius), "c")];
    marks.extend(ray_mark(&case.ray, reach));
    marks
}

fn coefficients(sphere: &Sphere, ray: &Ray) -> [f64; 3] {
    let test = sphere.test(ray, TRange::FORWARD, Sides::Both);
    [test.a, test.b, test.c]
}

fn of_coefficients([a, b, c]: [f64; 3]) -> Answer {
    vec![
        (Part::Coefficients, "a", a.into()),
        (Part::Coefficients, "b", b.into()),
        (Part::Coefficients, "c", c.into()),
    ]
}

/// The coefficients of the quadratic (iii).
pub static COEFFICIENTS: Task<SphereRay, fn(&Sphere, &Ray) -> [f64; 3]> = Task {
    about: About {
        lesson: 4,
        name: "coefficients",
        title: "a, b and c of the quadratic (iii)",
        signature: "pub fn coefficients(sphere: &Sphere, ray: &Ray) -> [f64; 3]",
        parts: &[Part::Frame, Part::Coefficients],
        uses: &[Part::Ray],
        mistakes: &["c − o without the turned sign"],
        see: See::Step {
            scene: "04-sphere/scene.json",
            pixel: [80, 60],
            strategy: "",
            at: 2,
            kind: Kind::SphereTest,
        },
        hints: [
            "Put the point o + t·Δ of the ray into the equation (ii) of the sphere, and sort by powers of t.",
            "a = Δ·Δ, b = 2·Δ·(o − centre), c = |o − centre|² − r².",
            "let from_center = ray.origin - sphere.center; then b is 2.0 * ray.direction.dot(from_center).",
        ],
        take_away: "a is 1 for a unit ray, b is negative where the ray comes nearer, and c is negative inside the sphere.",
        next: "l04_roots",
    },
    cases,
    given,
    answer: |student, case, _| of_coefficients(student(&case.sphere, &case.ray)),
    own: coefficients,
    mistaken: |wrong, case| match wrong {
        Wrong::SphereTest(wrong) => {
            let test = wrong(&case.sphere, &case.ray, TRange::FORWARD, Sides::Both);
            Some(of_coefficients([test.a, test.b, test.c]))
        }
        _ => None,
    },
    forms: &[Form {
        is: |case, yours| {
            let [a, b, c] = coefficients(&case.sphere, &case.ray);
            let half = of_coefficients([a, 0.5 * b, c]);
            yours
                .iter()
                .zip(&half)
                .all(|(yours, half)| yours.2.is_same(&half.2))
        },
        note: "half of b belongs to b′² − ac; here b has its factor 2, as in b² − 4ac",
    }],
    scenery,
    marks: None,
};

fn roots(a: f64, b: f64, c: f64) -> Vec<f64> {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return Vec::new();
    }
    if discriminant == 0.0 {
        return vec![-b / (2.0 * a)];
    }
    let root = discriminant.sqrt();
    vec![(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)]
}

fn of_roots(roots: Vec<f64>) -> Answer {
    answer(Part::Roots, Value::Numbers(roots))
}

/// The roots of the quadratic (iii).
pub static ROOTS: Task<SphereRay, fn(f64, f64, f64) -> Vec<f64>> = Task {
    about: About {
        lesson: 4,
        name: "roots",
        title: "the roots of a·t² + b·t + c = 0",
        signature: "pub fn roots(a: f64, b: f64, c: f64) -> Vec<f64>",
        parts: &[Part::Discriminant, Part::Roots],
        uses: &[Part::Coefficients],
        mistakes: &[
            "graze is two hits",
            "half b in the full formula",
            "c − o without the turned sign",
        ],
        see: See::Step {
            scene: "04-sphere/roots.json",
            pixel: [38, 15],
            strategy: "",
            at: 2,
            kind: Kind::SphereTest,
        },
        hints: [
            "The sign of the discriminant says how many roots there are: none, one or two.",
            "t = (−b ± √(b² − 4ac)) / 2a. Of a discriminant of 0 both are the same: one root.",
            "if discriminant < 0.0 { return vec![]; } and a case for discriminant == 0.0 before the one with two roots, the smaller first.",
        ],
        take_away: "A ray that grazes the sphere touches it in one point: one root, not two.",
        next: "l04_root_that_counts",
    },
    cases,
    given: |case| {
        let [a, b, c] = coefficients(&case.sphere, &case.ray).map(|x| number(x, 6));
        format!("a = {a}, b = {b}, c = {c}")
    },
    answer: |student, case, _| {
        let [a, b, c] = coefficients(&case.sphere, &case.ray);
        of_roots(student(a, b, c))
    },
    own: roots,
    mistaken: |wrong, case| match wrong {
        Wrong::SphereTest(wrong) => {
            let test = wrong(&case.sphere, &case.ray, TRange::FORWARD, Sides::Both);
            let roots = match test.roots {
                Roots::None => Vec::new(),
                Roots::Graze(root) | Roots::Linear(root) => vec![root.t],
                Roots::Two { near, far } => vec![near.t, far.t],
            };
            Some(of_roots(roots))
        }
        _ => None,
    },
    forms: &[Form {
        is: |case, yours| {
            let [a, b, c] = coefficients(&case.sphere, &case.ray);
            let mut turned = roots(a, b, c);
            turned.reverse();
            yours[0].2.is_same(&Value::Numbers(turned))
        },
        note: "the smaller root stands first",
    }],
    scenery,
    marks: Some(|case, answer| match &answer[..] {
        [(_, _, Value::Numbers(t))] => points_at(&case.ray, t),
        _ => Vec::new(),
    }),
};

fn of_choice(t: Option<f64>) -> Answer {
    answer(Part::Choice, Value::number_or(t, "no hit"))
}

/// The root that counts.
pub static ROOT_THAT_COUNTS: Task<SphereRay, fn(&Sphere, &Ray, TRange, Sides) -> Option<f64>> =
    Task {
        about: About {
            lesson: 4,
            name: "root_that_counts",
            title: "the root that counts",
            signature: "pub fn root_that_counts(sphere: &Sphere, ray: &Ray, range: TRange, _sides: Sides) -> Option<f64>",
            parts: &[Part::Choice],
            uses: &[Part::Coefficients, Part::Discriminant, Part::Roots],
            mistakes: &[
                "first root always",
                "largest root",
                "inside is a miss",
                "half b in the full formula",
                "c − o without the turned sign",
            ],
            see: See::Step {
                scene: "04-sphere/inside.json",
                pixel: [20, 15],
                strategy: "",
                at: 2,
                kind: Kind::SphereTest,
            },
            hints: [
                "Which roots lie in front of the origin? Think of a ray that starts inside the sphere.",
                "A root counts if 0 < t and range.min ≤ t ≤ range.max. Of two that count take the smaller one.",
                "roots(a, b, c).into_iter().find(|&t| 0.0 < t && range.min <= t && t <= range.max)",
            ],
            take_away: "From inside the far root is the hit; behind the origin there is none.",
            next: "the figure 04-sphere/inside, and your own picture",
        },
        cases: cases_with_ranges,
        given,
        answer: |student, case, _| {
            of_choice(student(&case.sphere, &case.ray, case.range, Sides::Both))
        },
        own: |sphere, ray, range, sides| Own.root(sphere, ray, range, sides),
        mistaken: |wrong, case| match wrong {
            Wrong::SphereTest(_) | Wrong::Root(_) => Some(of_choice(wrong.root(
                &case.sphere,
                &case.ray,
                case.range,
                Sides::Both,
            ))),
            _ => None,
        },
        forms: &[],
        scenery,
        marks: Some(|case, answer| match &answer[..] {
            [(_, _, Value::Number(t))] => points_at(&case.ray, &[*t]),
            _ => Vec::new(),
        }),
    };

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    #[test]
    fn the_cases_by_hand_are_what_their_notes_say() {
        let roots_of = |note: &str| {
            let cases = cases(&Seeds::PUBLIC);
            let case = cases.iter().find(|case| case.note.contains(note)).unwrap();
            let [a, b, c] = coefficients(&case.input.sphere, &case.input.ray);
            roots(a, b, c)
        };
        // 6 ± 1; in lengths of 2; none; 3; 1 + 2 on either side; behind; 3 to either side
        assert_eq!(roots_of("ahead"), [5.0, 7.0]);
        assert_eq!(roots_of("unit length"), [2.5, 3.5]);
        assert_eq!(roots_of("passes by"), [] as [f64; 0]);
        assert_eq!(roots_of("grazes"), [3.0]);
        assert_eq!(roots_of("inside"), [-3.0, 1.0]);
        assert_eq!(roots_of("behind"), [-10.0, -8.0]);
        assert_eq!(roots_of("in the centre"), [-3.0, 3.0]);
        let ahead = DVec3::new(0.0, 1.0, 1.0);
        assert_eq!(cases(&Seeds::PUBLIC)[0].input.ray.at(5.0), ahead);
    }
}
