//! Lesson 8: light that travels.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use glam::DVec3;

use crate::explain::Part;
use crate::figure::SketchForm;
use crate::lesson::exercise::course::shared::{arrow, mark};
use crate::lesson::exercise::value::{number, vector};
use crate::lesson::exercise::{About, Answer, Case, Exercise, Form, See, Task, Value, answer};
use crate::trace::geometry_term;

pub(super) static ALL: [&dyn Exercise; 3] = [&DIFFUSE_DIRECTION, &IRRADIANCE, &GEOMETRY_TERM];

/// How many values each of the two numbers takes, evenly spread: no chance is in it, so the average is the same each time.
const STEPS: u32 = 64;
/// Of an average over [`STEPS`]² directions: the edges of a region cut through some 2·[`STEPS`] of the cells.
const WITHIN: f64 = 0.03;

/// A unit direction around a normal, the likelier the closer to it: the disc of the unit circle, lifted to the sphere
/// (Malley's method).
fn diffuse_direction(normal: DVec3, u: f64, v: f64) -> DVec3 {
    let (sine, cosine) = (libm::sin(2.0 * PI * v), libm::cos(2.0 * PI * v));
    let radius = u.sqrt();
    let (across, along) = normal.any_orthonormal_pair();
    radius * cosine * across + radius * sine * along + (1.0 - u).sqrt() * normal
}

/// What all directions have in common, and how they are spread.
fn spread(normal: DVec3, direction: impl Fn(f64, f64) -> DVec3) -> Answer {
    let (across, along) = normal.any_orthonormal_pair();
    let count = f64::from(STEPS * STEPS);
    let (mut longest, mut lowest) = (1.0, f64::INFINITY);
    let (mut cosines, mut near, mut sideways, mut quarter) = (0.0, 0.0, DVec3::ZERO, 0.0);
    for row in 0..STEPS {
        for column in 0..STEPS {
            let [u, v] = [row, column].map(|of| (f64::from(of) + 0.5) / f64::from(STEPS));
            let d = direction(u, v);
            let cosine = d.dot(normal);
            if 1e-9 < (d.length() - 1.0).abs() || d.is_nan() {
                longest = d.length();
            }
            lowest = cosine.min(lowest);
            cosines += cosine / count;
            sideways += (d - cosine * normal) / count;
            near += if FRAC_1_SQRT_2 < cosine {
                1.0 / count
            } else {
                0.0
            };
            let is_in_quarter = 0.0 < d.dot(across) && 0.0 < d.dot(along);
            quarter += if is_in_quarter { 1.0 / count } else { 0.0 };
        }
    }
    let about = |number: f64| Value::About {
        number,
        within: WITHIN,
    };
    vec![
        (Part::Leg, "length", Value::Number(longest)),
        (Part::Leg, "on the side of N", Value::is(0.0 <= lowest)),
        (Part::Leg, "mean of cos θ", about(cosines)),
        (Part::Leg, "share within 45° of N", about(near)),
        (Part::Leg, "mean sideways", about(sideways.length())),
        (Part::Leg, "share in a quarter around N", about(quarter)),
    ]
}

/// A random direction for diffuse light, from two random numbers.
pub static DIFFUSE_DIRECTION: Task<DVec3, fn(DVec3, f64, f64) -> DVec3> = Task {
    about: About {
        lesson: 8,
        name: "diffuse_direction",
        title: "a diffuse direction from two random numbers",
        signature: "pub fn diffuse_direction(normal: DVec3, u: f64, v: f64) -> DVec3",
        parts: &[Part::Leg],
        uses: &[Part::Normal],
        mistakes: &[],
        see: See::Figure("08-transport/forward"),
        hints: [
            "A diffuse surface sends more light along its normal than aslant: pdf cos θ/π. Which point of a disc lies below such a direction?",
            "A point of the unit disc at radius √u and angle 2π·v, lifted to the hemisphere: cos θ = √(1 − u).",
            "let (across, along) = normal.any_orthonormal_pair(); then u.sqrt() * (cos * across + sin * along) + (1.0 - u).sqrt() * normal, with the angle 2.0 * PI * v.",
        ],
        take_away: "Uniform points of the disc, lifted to the hemisphere, have the pdf cos θ/π: Lambert's law.",
        next: "l08_irradiance",
    },
    cases: |seeds| {
        let case = |note: &str, normal: [f64; 3]| Case::new(note, DVec3::from(normal));
        let mut cases = vec![
            case("all directions around the z axis", [0.0, 0.0, 1.0]),
            case("a floor: the normal is the y axis", [0.0, 1.0, 0.0]),
            case("a ceiling: the normal points down", [0.0, -1.0, 0.0]),
            case("the normal is −z", [0.0, 0.0, -1.0]),
            case("a slanted normal", [0.48, 0.6, 0.64]),
        ];
        let mut seeded = seeds.stream(8);
        cases.extend((0..4).map(|_| Case::new("a seeded normal", seeded.direction())));
        cases
    },
    given: |normal| {
        format!(
            "N = {}, u and v in {STEPS} × {STEPS} even steps",
            vector(*normal)
        )
    },
    answer: |student, normal, _| spread(*normal, |u, v| student(*normal, u, v)),
    own: diffuse_direction,
    mistaken: |_, _| None,
    forms: &[Form {
        is: |_, yours| {
            let mean = yours
                .iter()
                .find(|(_, symbol, _)| *symbol == "mean of cos θ");
            let half = Value::About {
                number: 0.5,
                within: WITHIN,
            };
            mean.is_some_and(|(_, _, value)| value.is_same(&half))
        },
        note: "each direction is as likely (mean of cos θ ½); here the pdf is cos θ/π, whose mean is ⅔",
    }],
    scenery: |normal| vec![arrow(DVec3::ZERO, *normal, "N")],
    marks: None,
};

/// Photons around a point: the distance and the power of each, in any order; and how many are gathered.
#[derive(Clone, Debug)]
pub struct Photons {
    photons: Vec<(f64, f64)>,
    k: usize,
}

fn gathered(photons: &[(f64, f64)], k: usize, with_the_last: bool) -> f64 {
    let mut sorted = photons.to_vec();
    sorted.sort_by(|one, other| one.0.total_cmp(&other.0));
    sorted.truncate(k);
    let Some((radius, last)) = sorted.pop() else {
        return 0.0;
    };
    let power: f64 = sorted.iter().map(|(_, power)| power).sum();
    let power = if with_the_last { power + last } else { power };
    power / (PI * radius * radius)
}

/// Irradiance from the k nearest photons.
pub static IRRADIANCE: Task<Photons, fn(&[(f64, f64)], usize) -> f64> = Task {
    about: About {
        lesson: 8,
        name: "irradiance",
        title: "irradiance from the k nearest photons",
        signature: "pub fn irradiance(photons: &[(f64, f64)], k: usize) -> f64",
        parts: &[Part::Gathered, Part::Area, Part::Irradiance],
        uses: &[Part::Leg],
        mistakes: &[],
        see: See::Figure("08-transport/gather"),
        hints: [
            "Which photon says how large the disc is? That one lies on its rim and is not counted.",
            "E = Σ power of the k − 1 nearest / (π·r²), with r the distance of the k-th. Of fewer than k photons all are taken.",
            "sort by distance, truncate(k), pop the last one for its distance, and sum the powers of the others.",
        ],
        take_away: "The photon on the rim made the disc: to count it too would be too much on average, by k/(k − 1).",
        next: "the figure 08-transport/gather, then l08_geometry_term",
    },
    cases: |seeds| {
        let case = |note: &str, photons: &[(f64, f64)], k: usize| {
            Case::new(
                note,
                Photons {
                    photons: photons.to_vec(),
                    k,
                },
            )
        };
        let three = [(1.0, 3.0), (2.0, 6.0), (3.0, 5.0)];
        let mut cases = vec![
            case("k is the number of photons", &three, 3),
            case("only the nearest k count", &three, 2),
            case(
                "the photons are in no order",
                &[(3.0, 5.0), (1.0, 3.0), (2.0, 6.0), (0.5, 1.0)],
                3,
            ),
            case("fewer than k photons are there: all are taken", &three, 10),
            case("no photon: no light", &[], 3),
        ];
        let mut seeded = seeds.stream(88);
        while cases.len() < 25 {
            let photons: Vec<_> = (0..12)
                .map(|_| (seeded.within(0.1, 2.0), seeded.within(0.1, 1.0)))
                .collect();
            cases.push(case(
                "twelve seeded photons",
                &photons,
                3 + seeded.below(8) as usize,
            ));
        }
        cases
    },
    given: |case| {
        let each: Vec<String> = case
            .photons
            .iter()
            .map(|(distance, power)| format!("{} W at {}", number(*power, 3), number(*distance, 3)))
            .collect();
        format!(
            "k = {}: {}",
            case.k,
            if each.is_empty() {
                "no photons".into()
            } else {
                each.join(", ")
            }
        )
    },
    answer: |student, case, _| answer(Part::Irradiance, student(&case.photons, case.k)),
    own: |photons, k| gathered(photons, k, false),
    mistaken: |_, _| None,
    forms: &[Form {
        is: |case, yours| {
            let all = answer(Part::Irradiance, gathered(&case.photons, case.k, true));
            yours
                .iter()
                .zip(&all)
                .all(|(yours, all)| yours.2.is_same(&all.2))
        },
        note: "the k-th photon, on the rim of the disc, is not counted: k − 1 powers",
    }],
    scenery: |_| Vec::new(),
    marks: None,
};

/// Two small surfaces.
#[derive(Clone, Copy, Debug)]
pub struct TwoSurfaces {
    from: DVec3,
    normal_from: DVec3,
    to: DVec3,
    normal_to: DVec3,
}

fn geometry(from: DVec3, normal_from: DVec3, to: DVec3, normal_to: DVec3) -> f64 {
    let along = (to - from).normalize_or_zero();
    let cosines = [normal_from.dot(along), -normal_to.dot(along)];
    geometry_term(from, to, cosines.map(|cosine| cosine.max(0.0)))
}

/// How much of what leaves one small surface arrives at another.
pub static GEOMETRY_TERM: Task<TwoSurfaces, fn(DVec3, DVec3, DVec3, DVec3) -> f64> = Task {
    about: About {
        lesson: 8,
        name: "geometry_term",
        title: "the geometry term between two points",
        signature: "pub fn geometry_term(from: DVec3, normal_from: DVec3, to: DVec3, normal_to: DVec3) -> f64",
        parts: &[Part::GeometryTerm],
        uses: &[Part::Normal],
        mistakes: &[],
        see: See::Figure("08-transport/hybrid-connected"),
        hints: [
            "The light leaves one surface aslant, arrives at the other one aslant, and spreads on its way. Which way does the line run at either end?",
            "G = cos θ · cos θ′ / d²; 0 where one of the surfaces faces away.",
            "let along = (to - from).normalize(); normal_from.dot(along).max(0.0) * (-normal_to.dot(along)).max(0.0) / from.distance_squared(to)",
        ],
        take_away: "Each surface has its own cosine, towards the other one; the square of the distance thins the light.",
        next: "lesson 9",
    },
    cases: |seeds| {
        let case = |note: &str, [from, normal_from, to, normal_to]: [[f64; 3]; 4]| {
            let of = DVec3::from;
            Case::new(
                note,
                TwoSurfaces {
                    from: of(from),
                    normal_from: of(normal_from),
                    to: of(to),
                    normal_to: of(normal_to),
                },
            )
        };
        let (o, up, down) = ([0.0; 3], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]);
        let mut cases = vec![
            case("face to face, 2 apart", [o, up, [0.0, 2.0, 0.0], down]),
            case("aslant at both ends", [o, up, [3.0, 4.0, 0.0], down]),
            case(
                "aslant at one end",
                [o, up, [3.0, 4.0, 0.0], [-0.6, -0.8, 0.0]],
            ),
            case(
                "the second surface faces away",
                [o, up, [0.0, 2.0, 0.0], up],
            ),
            case(
                "the first surface faces away",
                [o, down, [0.0, 2.0, 0.0], down],
            ),
            case(
                "both face away: no light, though both cosines are negative",
                [o, down, [0.0, 2.0, 0.0], up],
            ),
        ];
        let mut seeded = seeds.stream(888);
        while cases.len() < 30 {
            let new = [
                seeded.point(3.0),
                seeded.direction(),
                seeded.point(3.0),
                seeded.direction(),
            ];
            if 0.5 < new[0].distance(new[2]) {
                cases.push(case("two seeded surfaces", new.map(|v| v.to_array())));
            }
        }
        cases
    },
    given: |case| {
        format!(
            "from {} with N = {} to {} with N′ = {}",
            vector(case.from),
            vector(case.normal_from),
            vector(case.to),
            vector(case.normal_to)
        )
    },
    answer: |student, case, _| {
        answer(
            Part::GeometryTerm,
            student(case.from, case.normal_from, case.to, case.normal_to),
        )
    },
    own: geometry,
    mistaken: |_, _| None,
    forms: &[],
    scenery: |case| {
        vec![
            mark(SketchForm::Line(case.from, case.to), ""),
            arrow(case.from, case.normal_from, "N"),
            arrow(case.to, case.normal_to, "N′"),
        ]
    },
    marks: Some(|_, _| Vec::new()),
};
