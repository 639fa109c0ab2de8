//! Lesson 9: what ray tracing costs, and the ray turned into the z axis.

use glam::DVec3;

use crate::explain::Part;
use crate::figure::SketchForm;
use crate::geometry::{Alignment, Ray};
use crate::lesson::exercise::course::shared::{mark, ray_mark, said_ray};
use crate::lesson::exercise::value::number;
use crate::lesson::exercise::{About, Answer, Case, Exercise, Form, See, Task, Value};
use crate::trace::Kind;

pub(super) static ALL: [&dyn Exercise; 3] = [&COST, &ALIGN, &Z_SORT];

/// A picture, as it is counted.
#[derive(Clone, Copy, Debug)]
pub struct Counted {
    pixels: [u64; 2],
    objects: u64,
    lit: u64,
    lights: u64,
}

const fn cost(pixels: [u64; 2], objects: u64, lit: u64, lights: u64) -> u64 {
    (pixels[0] * pixels[1] + lit * lights) * objects
}

fn of_tests(tests: u64) -> Answer {
    // below 2⁵³
    vec![(Part::Nearest, "tests", Value::Number(tests as f64))]
}

/// How many tests a picture takes.
pub static COST: Task<Counted, fn([u64; 2], u64, u64, u64) -> u64> = Task {
    about: About {
        lesson: 9,
        name: "cost",
        title: "how many tests a picture takes if every ray is tested against every object",
        signature: "pub fn cost(pixels: [u64; 2], objects: u64, hits: u64, lights: u64) -> u64",
        parts: &[Part::Nearest],
        uses: &[Part::Nearest, Part::Visibility],
        mistakes: &[],
        see: See::Figure("09-cost/strategies"),
        hints: [
            "Count the rays first: an eye ray for each pixel, and a shadow ray to each light from each point that an eye ray hits.",
            "tests = (width·height + hits·lights)·objects",
            "(pixels[0] * pixels[1] + hits * lights) * objects",
        ],
        take_away: "A picture of 1024 × 1024 pixels with 100 objects takes 100 million tests: most of the time goes here.",
        next: "the figure 09-cost/strategies, then l09_align",
    },
    cases: |seeds| {
        let case = |note: &str, pixels: [u64; 2], objects: u64, lit: u64, lights: u64| {
            Case::new(
                note,
                Counted {
                    pixels,
                    objects,
                    lit,
                    lights,
                },
            )
        };
        let mut cases = vec![
            case(
                "the slides' example: eye rays alone",
                [1024, 1024],
                100,
                0,
                1,
            ),
            case(
                "half of the pixels hit something, with one light",
                [100, 100],
                10,
                5000,
                1,
            ),
            case(
                "three lights: three shadow rays from each point",
                [100, 100],
                10,
                5000,
                3,
            ),
            case("no light: no shadow rays", [100, 50], 10, 5000, 0),
            case("no objects: no tests", [100, 50], 0, 0, 2),
        ];
        let mut seeded = seeds.stream(9);
        while cases.len() < 15 {
            let mut below = |end| u64::from(seeded.below(end));
            let pixels = [1 + below(2000), 1 + below(2000)];
            cases.push(case(
                "a seeded picture",
                pixels,
                below(500),
                below(1000),
                below(5),
            ));
        }
        cases
    },
    given: |case| {
        let [width, height] = case.pixels;
        format!(
            "{width} × {height} pixels, {} objects, {} points hit, {} lights",
            case.objects, case.lit, case.lights
        )
    },
    answer: |student, case, _| of_tests(student(case.pixels, case.objects, case.lit, case.lights)),
    own: cost,
    mistaken: |_, _| None,
    forms: &[Form {
        is: |case, yours| yours == &of_tests(case.pixels[0] * case.pixels[1] * case.objects),
        note: "the tests of the shadow rays count as well",
    }],
    scenery: |_| Vec::new(),
    marks: None,
};

/// What the frame does to points, whatever its x and y are.
fn of_frame(frame: &Alignment, ray: &Ray) -> Answer {
    let beside = ray.at(2.0) + DVec3::new(1.0, -2.0, 0.5);
    let turned = frame.point(beside);
    vec![
        (Part::Alignment, "o′", frame.point(ray.origin).into()),
        (
            Part::Alignment,
            "(o + 5Δ)′",
            frame.point(ray.at(5.0)).into(),
        ),
        (
            Part::AlignedPoint,
            "|p′| of a point beside",
            turned.length().into(),
        ),
        (Part::AlignedPoint, "p′ back", frame.back(turned).into()),
        (
            Part::Alignment,
            "right-handed",
            Value::is(0.0 < frame.x.cross(frame.y).dot(frame.z)),
        ),
    ]
}

/// The frame in which a ray is the z axis.
pub static ALIGN: Task<Ray, fn(&Ray) -> Alignment> = Task {
    about: About {
        lesson: 9,
        name: "align",
        title: "the frame in which a unit ray is the z axis",
        signature: "pub fn align(ray: &Ray) -> Alignment",
        parts: &[Part::Alignment, Part::AlignedPoint],
        uses: &[Part::Ray, Part::Direction],
        mistakes: &[],
        see: See::Step {
            scene: "10-bounds/alignment.json",
            pixel: [16, 12],
            strategy: "z-aligned",
            at: 2,
            kind: Kind::Align,
        },
        hints: [
            "The third row of the rotation is Δ itself. The other two are unit vectors across it and across each other; which ones does not matter.",
            "Take an axis e that is not along Δ: x = e × Δ brought to unit length, y = Δ × x, z = Δ.",
            "let x = e.cross(ray.direction).normalize(); Alignment { origin: ray.origin, x, y: ray.direction.cross(x), z: ray.direction }",
        ],
        take_away: "A rotation keeps lengths, so z in the frame is t; and its inverse is its transpose.",
        next: "l09_z_sort",
    },
    cases: |seeds| {
        let case = |note: &str, origin: [f64; 3], direction: [f64; 3]| {
            Case::new(note, Ray::new(origin.into(), direction.into()))
        };
        let mut cases = vec![
            case("the ray is the z axis already", [0.0; 3], [0.0, 0.0, 1.0]),
            case(
                "the ray starts beside the origin",
                [1.0, 2.0, 3.0],
                [0.0, 0.0, 1.0],
            ),
            case("the ray runs along x", [0.0; 3], [1.0, 0.0, 0.0]),
            case("the ray runs along y", [0.0; 3], [0.0, 1.0, 0.0]),
            case("the ray runs along −z", [0.0, 0.0, 5.0], [0.0, 0.0, -1.0]),
            case("a slanted ray", [1.0, 0.0, 0.0], [0.6, 0.0, 0.8]),
        ];
        let mut seeded = seeds.stream(99);
        cases.extend((0..20).map(|_| {
            Case::new(
                "a seeded ray",
                Ray::new(seeded.point(5.0), seeded.direction()),
            )
        }));
        cases
    },
    given: said_ray,
    answer: |student, ray, _| of_frame(&student(ray), ray),
    own: Alignment::of,
    mistaken: |_, _| None,
    forms: &[],
    scenery: |ray| ray_mark(ray, 5.0),
    marks: None,
};

/// A frame, and the z of the hits with each object in it.
#[derive(Clone, Debug)]
pub struct Hits {
    ray: Ray,
    z: Vec<f64>,
}

fn z_sort(frame: &Alignment, z: &[f64]) -> Option<(usize, DVec3)> {
    let ahead = z.iter().enumerate().filter(|(_, z)| 0.0 < **z);
    let (object, z) = ahead.min_by(|one, other| one.1.total_cmp(other.1))?;
    Some((object, frame.back(DVec3::new(0.0, 0.0, *z))))
}

fn of_z_sort(nearest: Option<(usize, DVec3)>) -> Answer {
    let (object, point) = nearest.unzip();
    vec![
        (
            Part::ZSort,
            "object",
            object.map_or_else(
                || Value::word("none"),
                |number| Value::word(number.to_string()),
            ),
        ),
        (
            Part::AlignedPoint,
            "p in the world",
            point.map_or_else(|| Value::word("none"), Value::Vector),
        ),
    ]
}

/// The nearest of the hits in the frame, and back into the world.
pub static Z_SORT: Task<Hits, fn(&Alignment, &[f64]) -> Option<(usize, DVec3)>> = Task {
    about: About {
        lesson: 9,
        name: "z_sort",
        title: "the nearest hit by its z, and its point in the world",
        signature: "pub fn z_sort(frame: &Alignment, z: &[f64]) -> Option<(usize, DVec3)>",
        parts: &[Part::ZSort, Part::AlignedPoint],
        uses: &[Part::Alignment, Part::AlignedPoint, Part::Nearest],
        mistakes: &[],
        see: See::Step {
            scene: "10-bounds/alignment.json",
            pixel: [16, 12],
            strategy: "z-aligned",
            at: 17,
            kind: Kind::ZSort,
        },
        hints: [
            "In the frame each hit is at (0, 0, z). Which z are in front of the origin, and which of them is the smallest?",
            "The smallest z above 0; its point is o + z·(the frame's z), and x and y are 0.",
            "frame.origin + z * frame.z, of the smallest z with 0.0 < z",
        ],
        take_away: "In the frame a search for the nearest hit is a sort by one number; then the point is transformed back.",
        next: "the figure 10-bounds/alignment, then lesson 10",
    },
    cases: |seeds| {
        let case = |note: &str, direction: [f64; 3], z: &[f64]| {
            let ray = Ray::new(DVec3::new(1.0, 2.0, 3.0), direction.into());
            Case::new(note, Hits { ray, z: z.to_vec() })
        };
        let slant = [0.6, 0.0, 0.8];
        let mut cases = vec![
            case("one hit", slant, &[5.0]),
            case("the nearest is the last", slant, &[9.0, 7.0, 5.0]),
            case("the nearest is in the middle", slant, &[9.0, 5.0, 7.0]),
            case("a hit behind the origin", slant, &[-1.0, 5.0, 7.0]),
            case("all hits behind the origin", slant, &[-1.0, -5.0]),
            case("no hit", slant, &[]),
        ];
        let mut seeded = seeds.stream(999);
        while cases.len() < 25 {
            let z: Vec<f64> = (0..6).map(|_| seeded.within(-3.0, 9.0)).collect();
            cases.push(case("six seeded hits", seeded.direction().to_array(), &z));
        }
        cases
    },
    given: |case| {
        let z: Vec<String> = case.z.iter().map(|z| number(*z, 4)).collect();
        format!(
            "{}, z = {}",
            said_ray(&case.ray),
            if z.is_empty() {
                "none".into()
            } else {
                z.join(", ")
            }
        )
    },
    answer: |student, case, _| of_z_sort(student(&Alignment::of(&case.ray), &case.z)),
    own: z_sort,
    mistaken: |_, _| None,
    forms: &[],
    scenery: |case| ray_mark(&case.ray, 9.0),
    marks: Some(|_, answer| {
        let points = answer.iter().filter_map(|(_, _, value)| value.vector());
        points
            .map(|point| mark(SketchForm::Dot(point), "p"))
            .collect()
    }),
};
