//! Lesson 3: the ray.

use glam::DVec3;

use crate::explain::Part;
use crate::figure::SketchForm;
use crate::geometry::Ray;
use crate::lesson::exercise::course::shared::{arrow, mark, ray_mark, said_ray};
use crate::lesson::exercise::value::number;
use crate::lesson::exercise::{About, Answer, Case, Exercise, See, Seeds, Task, Value, answer};
use crate::mistake::Wrong;
use crate::trace::Kind;

pub(super) static ALL: [&dyn Exercise; 2] = [&POINT_AT_T, &NORMALISED];

fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray {
    Ray::new(origin.into(), direction.into())
}

fn seeded_rays(seeds: &Seeds) -> Vec<Ray> {
    let mut seeded = seeds.stream(3);
    let mut of = || {
        let length = seeded.within(0.1, 7.0);
        Ray::new(seeded.point(5.0), seeded.direction() * length)
    };
    (0..25).map(|_| of()).collect()
}

/// A ray and t.
#[derive(Clone, Copy, Debug)]
pub struct RayAndT {
    ray: Ray,
    t: f64,
}

/// The point of the ray (i).
pub static POINT_AT_T: Task<RayAndT, fn(&Ray, f64) -> DVec3> = Task {
    about: About {
        lesson: 3,
        name: "point_at_t",
        title: "the point at t of the ray (i)",
        signature: "pub fn point_at_t(ray: &Ray, t: f64) -> DVec3",
        parts: &[Part::Ray],
        uses: &[Part::Direction],
        mistakes: &[],
        see: See::Step {
            scene: "03-ray/scene.json",
            pixel: [1, 1],
            strategy: "",
            at: 1,
            kind: Kind::Ray,
        },
        hints: [
            "Start at the origin and go t times the direction.",
            "x = x₀ + t·Δx, y = y₀ + t·Δy, z = z₀ + t·Δz … (i)",
            "ray.origin + t * ray.direction",
        ],
        take_away: "t measures in lengths of Δ; t < 0 lies behind the origin.",
        next: "l03_normalised",
    },
    cases: |seeds| {
        let case = |note: &str, ray: Ray, t: f64| Case::new(note, RayAndT { ray, t });
        let slanted = ray([0.0, 1.0, 6.0], [3.0, 0.0, -4.0]);
        let mut cases = vec![
            case("t = 0 is the origin", slanted, 0.0),
            case(
                "t = 1 is one whole Δ away, whatever its length",
                slanted,
                1.0,
            ),
            case("t between 0 and 1", slanted, 0.25),
            case("a negative t lies behind the origin", slanted, -2.0),
            case(
                "a direction of unit length",
                ray([1.0, 2.0, 3.0], [0.0, 0.0, -1.0]),
                5.0,
            ),
        ];
        let rays = seeded_rays(seeds).into_iter().zip(0..);
        cases.extend(rays.map(|(ray, t)| case("a seeded ray", ray, f64::from(t) - 4.5)));
        cases
    },
    given: |case| format!("{}, t = {}", said_ray(&case.ray), number(case.t, 6)),
    answer: |student, case, _| answer(Part::Ray, student(&case.ray, case.t)),
    own: Ray::at,
    mistaken: |_, _| None,
    forms: &[],
    scenery: |case| ray_mark(&case.ray, case.ray.direction.length()),
    marks: Some(|_, answer| {
        let points = answer.iter().filter_map(|(_, _, value)| value.vector());
        points
            .map(|point| mark(SketchForm::Dot(point), "point"))
            .collect()
    }),
};

fn of_normalised(normalised: Option<(Ray, f64)>) -> Answer {
    let (ray, length) = normalised.unzip();
    let direction = ray.map(|ray| ray.direction);
    vec![
        (
            Part::Direction,
            "Δ",
            direction.map_or_else(|| Value::word("none"), Value::Vector),
        ),
        (
            Part::Ray,
            "o",
            ray.map_or_else(|| Value::word("none"), |ray| ray.origin.into()),
        ),
        (Part::Ray, "t", Value::number_or(length, "none")),
    ]
}

/// The ray with a direction of unit length, and the t at which the former t = 1 lies.
pub static NORMALISED: Task<Ray, fn(&Ray) -> Option<(Ray, f64)>> = Task {
    about: About {
        lesson: 3,
        name: "normalised",
        title: "the ray of unit length, and its t of the former t = 1",
        signature: "pub fn normalised(ray: &Ray) -> Option<(Ray, f64)>",
        parts: &[Part::Direction, Part::Ray],
        uses: &[Part::Ray],
        mistakes: &["t kept after normalising"],
        see: See::Step {
            scene: "03-ray/scene.json",
            pixel: [1, 1],
            strategy: "",
            at: 1,
            kind: Kind::Ray,
        },
        hints: [
            "The point at the former t = 1 stays where it is. How far away is it, now that t is a distance?",
            "Δ/|Δ|, and t = |Δ|. A direction of length 0 cannot be normalised.",
            "Some((Ray::new(ray.origin, ray.direction / length), length)), and None where length is 0.",
        ],
        take_away: "Normalising changes what t measures, and every t that was computed before with it.",
        next: "the figure 03-ray/line-of-t, then lesson 4",
    },
    cases: |seeds| {
        let mut cases = vec![
            Case::new("|Δ| = 5", ray([0.0, 1.0, 6.0], [3.0, 0.0, -4.0])),
            Case::new("|Δ| is 1 already", ray([0.0, 1.0, 6.0], [0.0, 0.0, -1.0])),
            Case::new("|Δ| = ½ is shorter than 1", ray([0.0; 3], [0.0, 0.5, 0.0])),
            Case::new("Δ = 0 has no direction", ray([1.0; 3], [0.0; 3])),
        ];
        cases.extend(
            seeded_rays(seeds)
                .into_iter()
                .map(|ray| Case::new("a seeded ray", ray)),
        );
        cases
    },
    given: said_ray,
    answer: |student, ray, _| of_normalised(student(ray)),
    own: Ray::normalised,
    mistaken: |wrong, ray| match wrong {
        Wrong::Normalised(wrong) => Some(of_normalised(wrong(ray))),
        _ => None,
    },
    forms: &[],
    scenery: |ray| vec![arrow(ray.origin, ray.direction, "Δ")],
    marks: Some(|ray, answer| {
        let mut marks = Vec::new();
        if let Some((_, _, value)) = answer.first() {
            let along = value.vector();
            marks.extend(along.map(|along| arrow(ray.origin, along, "unit")));
        }
        let t = answer.last().and_then(|(_, _, value)| value.number());
        let unit = ray.direction.normalize_or_zero();
        marks.extend(t.map(|t| mark(SketchForm::Dot(ray.origin + t * unit), "t")));
        marks
    }),
};
