//! Lesson 2: the simple ray tracer, the loop of Fig. 15.56.

use crate::explain::Part;
use crate::figure::{SketchForm, SketchMark};
use crate::geometry::{Ray, TRange};
use crate::lesson::exercise::course::shared::{
    mark, points_at, ray_mark, said_range, said_ray, shapes,
};
use crate::lesson::exercise::{About, Answer, Case, Exercise, See, Seeds, Task, Value};
use crate::mistake::Wrong;
use crate::scene::{Scene, Shape};
use crate::strategy::Hit;
use crate::trace::Kind;
use crate::tracer::simple::{Own, Parts};

pub(super) static ALL: [&dyn Exercise; 1] = [&NEAREST];

/// A scene, a ray, and which t count.
#[derive(Clone, Debug)]
pub struct SceneRay {
    pub(super) scene: Scene,
    pub(super) ray: Ray,
    pub(super) range: TRange,
}

/// Spheres of radius 1 in a row along −z, with their names.
fn row(places: &[(&str, f64)]) -> Scene {
    let spheres = places.iter().map(|(name, z)| {
        format!(r#"{{"name":"{name}","material":"m","shape":{{"sphere":{{"center":[0,0,{z:?}],"radius":1}}}}}}"#)
    });
    shapes(&spheres.collect::<Vec<_>>())
}

fn cases(seeds: &Seeds) -> Vec<Case<SceneRay>> {
    let ahead = Ray::new([0.0, 0.0, 0.0].into(), [0.0, 0.0, -1.0].into());
    let of = |note: &str, places: &[(&str, f64)]| {
        Case::new(
            note,
            SceneRay {
                scene: row(places),
                ray: ahead,
                range: TRange::FORWARD,
            },
        )
    };
    let mut cases = vec![
        of("one object is hit", &[("A", -5.0)]),
        of(
            "the nearest object comes first in the scene",
            &[("A", -5.0), ("B", -9.0), ("C", -13.0)],
        ),
        of(
            "the nearest object comes last in the scene",
            &[("A", -13.0), ("B", -9.0), ("C", -5.0)],
        ),
        of(
            "the nearest object is in the middle of the list",
            &[("A", -9.0), ("B", -5.0), ("C", -13.0), ("D", -17.0)],
        ),
        of("no object is hit", &[("A", 5.0), ("B", 9.0)]),
        of(
            "an object behind the eye comes first",
            &[("A", 5.0), ("B", -9.0)],
        ),
        of(
            "two objects are hit at the same t: the first in the scene stays",
            &[("A", -9.0), ("B", -5.0), ("C", -5.0)],
        ),
    ];
    let mut limited = of(
        "an object beyond the range does not count",
        &[("A", -9.0), ("B", -15.0)],
    );
    limited.input.range.max = 3.0;
    cases.push(limited);
    let mut seeded = seeds.stream(2);
    while cases.len() < 40 {
        let spheres: Vec<String> = (0..6)
            .map(|name| {
                let [x, y, z] = seeded.point(4.0).to_array();
                let radius = seeded.within(0.5, 2.0);
                format!(r#"{{"name":"{name}","material":"m","shape":{{"sphere":{{"center":[{x:?},{y:?},{z:?}],"radius":{radius:?}}}}}}}"#)
            })
            .collect();
        let origin = seeded.direction() * 12.0;
        let target = seeded.point(2.0);
        let ray = Ray::new(origin, (target - origin).normalize());
        cases.push(Case::new(
            "six seeded spheres",
            SceneRay {
                scene: shapes(&spheres),
                ray,
                range: TRange::FORWARD,
            },
        ));
    }
    cases
}

pub(super) fn said(case: &SceneRay) -> String {
    let count = case.scene.primitives.len();
    format!(
        "{count} objects, {}{}",
        said_ray(&case.ray),
        said_range(case.range)
    )
}

pub(super) fn scenery(case: &SceneRay) -> Vec<SketchMark> {
    let mut marks = ray_mark(&case.ray, 14.0);
    for (primitive, object) in case.scene.primitives.iter().zip(&case.scene.objects) {
        if let Shape::Sphere(sphere) = &primitive.shape {
            marks.push(mark(
                SketchForm::Circle(sphere.center, sphere.radius),
                &object.name,
            ));
        }
    }
    marks
}

/// The object by its name, and t.
pub(super) fn of_hit(scene: &Scene, hit: Option<Hit>) -> Answer {
    let name = match hit {
        None => "none".into(),
        Some(hit) if hit.object.0 as usize >= scene.primitives.len() => {
            format!("number {} of {}", hit.object.0, scene.primitives.len())
        }
        Some(hit) => scene.name_of(hit.object).0.to_owned(),
    };
    vec![
        (Part::Nearest, "object", Value::word(name)),
        (
            Part::Nearest,
            "t",
            Value::number_or(hit.map(|hit| hit.t), "no hit"),
        ),
    ]
}

pub(super) fn marks(ray: &Ray, answer: &Answer) -> Vec<SketchMark> {
    let t: Vec<f64> = answer
        .iter()
        .filter_map(|(_, _, value)| value.number())
        .collect();
    points_at(ray, &t)
}

/// The nearest object and its name.
pub static NEAREST: Task<SceneRay, fn(&Scene, &Ray, TRange) -> Option<Hit>> = Task {
    about: About {
        lesson: 2,
        name: "nearest",
        title: "the nearest object and its name",
        signature: "pub fn nearest(scene: &Scene, ray: &Ray, range: TRange) -> Option<Hit>",
        parts: &[Part::Nearest],
        uses: &[Part::Direction],
        mistakes: &["stops at the first leaf", "last hit wins", "one child only"],
        see: See::Step {
            scene: "02-simple-tracer/scene.json",
            pixel: [30, 33],
            strategy: "",
            at: 3,
            kind: Kind::Nearest,
        },
        hints: [
            "Keep the closest hit so far while you go through all objects; a hit replaces it only if it is closer.",
            "if object is intersected and is closest considered thus far: record intersection and object name (Fig. 15.56).",
            "if closest.is_none_or(|closest| t < closest.t) { closest = Some(Hit { object, t }); }",
        ],
        take_away: "The first hit that is found is not the nearest: every object must be asked.",
        next: "lesson 3",
    },
    cases,
    given: said,
    answer: |student, case, _| of_hit(&case.scene, student(&case.scene, &case.ray, case.range)),
    own: |scene, ray, range| Own.nearest(scene, ray, range),
    mistaken: |wrong, case| match wrong {
        Wrong::Nearest(wrong) => Some(of_hit(
            &case.scene,
            wrong(&case.scene, &case.ray, case.range),
        )),
        _ => None,
    },
    forms: &[],
    scenery,
    marks: Some(|case, answer| marks(&case.ray, answer)),
};
