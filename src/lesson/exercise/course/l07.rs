//! Lesson 7: reflection and refraction.

use glam::DVec3;

use crate::explain::Part;
use crate::geometry::{Ray, Refraction, reflect, refract};
use crate::lesson::exercise::course::l05::{Seen, at_surface, of_colour};
use crate::lesson::exercise::course::shared::{arrow, said_ray, scene};
use crate::lesson::exercise::seeded::Seeded;
use crate::lesson::exercise::value::{number, vector};
use crate::lesson::exercise::{About, Answer, Case, Exercise, See, Task, Value};
use crate::mistake::Wrong;
use crate::scene::Scene;
use crate::trace::Kind;
use crate::tracer::Surface;
use crate::tracer::simple::{Own, Parts};

pub(super) static ALL: [&dyn Exercise; 3] = [&REFLECT, &REFRACT, &CHILDREN];

/// A direction, a normal, and both indices.
#[derive(Clone, Copy, Debug)]
pub struct AtSurface {
    direction: DVec3,
    normal: DVec3,
    from: f64,
    to: f64,
}

fn case(
    note: &str,
    direction: [f64; 3],
    normal: [f64; 3],
    [from, to]: [f64; 2],
) -> Case<AtSurface> {
    let (direction, normal) = (direction.into(), normal.into());
    Case::new(
        note,
        AtSurface {
            direction,
            normal,
            from,
            to,
        },
    )
}

fn seeded_cases(mut seeded: Seeded) -> Vec<Case<AtSurface>> {
    let mut cases = Vec::new();
    while cases.len() < 30 {
        let (direction, normal) = (seeded.direction(), seeded.direction());
        let (from, to) = (seeded.within(1.0, 2.0), seeded.within(1.0, 2.0));
        let squared = refract(direction, normal, from, to).cos_refracted_squared;
        if direction.dot(normal) < -0.1 && 0.05 < squared.abs() {
            cases.push(Case::new(
                "a seeded direction",
                AtSurface {
                    direction,
                    normal,
                    from,
                    to,
                },
            ));
        }
    }
    cases
}

/// The mirror direction.
pub static REFLECT: Task<AtSurface, fn(DVec3, DVec3) -> DVec3> = Task {
    about: About {
        lesson: 7,
        name: "reflect",
        title: "the mirror direction",
        signature: "pub fn reflect(direction: DVec3, normal: DVec3) -> DVec3",
        parts: &[Part::Direction],
        uses: &[Part::Normal],
        mistakes: &["plus 2", "D turned", "N not unit"],
        see: See::Step {
            scene: "07-reflection-refraction/mirror.json",
            pixel: [30, 22],
            strategy: "",
            at: 15,
            kind: Kind::Shade,
        },
        hints: [
            "Split Δ into a part along N and a part across it. Which of the two changes?",
            "R = Δ − 2(Δ·N)N",
            "direction - 2.0 * direction.dot(normal) * normal",
        ],
        take_away: "The part along N changes its sign and the part across it stays: the side that N points to does not matter.",
        next: "l07_refract",
    },
    cases: |seeds| {
        let none = [1.0, 1.0];
        let mut cases = vec![
            case(
                "straight down on a floor",
                [0.0, -1.0, 0.0],
                [0.0, 1.0, 0.0],
                none,
            ),
            case("aslant on a floor", [0.6, -0.8, 0.0], [0.0, 1.0, 0.0], none),
            case(
                "a mirror at 45° turns x into y",
                [1.0, 0.0, 0.0],
                [-(0.5f64.sqrt()), 0.5f64.sqrt(), 0.0],
                none,
            ),
            case(
                "N points away from the ray: R is the same",
                [0.6, -0.8, 0.0],
                [0.0, -1.0, 0.0],
                none,
            ),
            case(
                "along the surface nothing changes",
                [1.0, 0.0, 0.0],
                [0.0, 1.0, 0.0],
                none,
            ),
        ];
        cases.extend(seeded_cases(seeds.stream(7)));
        cases
    },
    given: |case| {
        format!(
            "Δ = {}, N = {}",
            vector(case.direction),
            vector(case.normal)
        )
    },
    answer: |student, case, _| {
        vec![(
            Part::Direction,
            "R",
            student(case.direction, case.normal).into(),
        )]
    },
    own: reflect,
    mistaken: |wrong, case| match wrong {
        Wrong::Reflect(wrong) => Some(vec![(
            Part::Direction,
            "R",
            wrong(case.direction, case.normal).into(),
        )]),
        _ => None,
    },
    forms: &[],
    scenery: |case| {
        vec![
            arrow(-case.direction, case.direction, "Δ"),
            arrow(DVec3::ZERO, case.normal, "N"),
        ]
    },
    marks: None,
};

fn of_refraction(refraction: Refraction) -> Answer {
    let direction = refraction.direction.map_or_else(
        || Value::word("none: total internal reflection"),
        Value::Vector,
    );
    vec![
        (
            Part::Snell,
            "n₁/n₂",
            (refraction.index_from / refraction.index_to).into(),
        ),
        (Part::Snell, "cos θ₁", refraction.cos_incident.into()),
        (
            Part::Snell,
            "cos² θ₂",
            refraction.cos_refracted_squared.into(),
        ),
        (Part::Transmitted, "", direction),
    ]
}

/// The refracted direction, or none.
pub static REFRACT: Task<AtSurface, fn(DVec3, DVec3, f64, f64) -> Refraction> = Task {
    about: About {
        lesson: 7,
        name: "refract",
        title: "the refracted direction, or total internal reflection",
        signature: "pub fn refract(direction: DVec3, normal: DVec3, index_from: f64, index_to: f64) -> Refraction",
        parts: &[Part::Snell, Part::Transmitted],
        uses: &[Part::Direction, Part::Normal],
        mistakes: &[
            "ratio never inverted",
            "normal not turned",
            "root of a negative number",
        ],
        see: See::Step {
            scene: "07-reflection-refraction/glass.json",
            pixel: [30, 22],
            strategy: "",
            at: 10,
            kind: Kind::Refraction,
        },
        hints: [
            "From the glass into the air the indices are exchanged. N is on the side that the ray comes from. What does a negative cos²θ₂ mean?",
            "η = n₁/n₂, cos θ₁ = −Δ·N, cos²θ₂ = 1 − η²(1 − cos²θ₁), T = η·Δ + (η·cos θ₁ − cos θ₂)·N; no T where cos²θ₂ < 0.",
            "let direction = (0.0 <= cos_refracted_squared).then(|| eta * direction + (eta * cos_incident - cos_refracted_squared.sqrt()) * normal);",
        ],
        take_away: "Out of the glass the ratio is inverted, and beyond the critical angle no ray leaves.",
        next: "the figure 07-reflection-refraction/total-internal-reflection, then l07_children",
    },
    cases: |seeds| {
        let up = [0.0, 1.0, 0.0];
        let mut cases = vec![
            case("straight into glass", [0.0, -1.0, 0.0], up, [1.0, 1.5]),
            case(
                "aslant into an index of 1.2: sin θ₂ is ½",
                [0.6, -0.8, 0.0],
                up,
                [1.0, 1.2],
            ),
            case(
                "out of glass, below the critical angle",
                [0.28, -0.96, 0.0],
                up,
                [1.5, 1.0],
            ),
            case(
                "out of glass, beyond the critical angle",
                [0.8, -0.6, 0.0],
                up,
                [1.5, 1.0],
            ),
            case(
                "between equal media nothing changes",
                [0.6, -0.8, 0.0],
                up,
                [1.3, 1.3],
            ),
        ];
        cases.extend(seeded_cases(seeds.stream(77)));
        cases
    },
    given: |case| {
        format!(
            "Δ = {}, N = {}, n₁ = {}, n₂ = {}",
            vector(case.direction),
            vector(case.normal),
            number(case.from, 6),
            number(case.to, 6)
        )
    },
    answer: |student, case, _| {
        of_refraction(student(case.direction, case.normal, case.from, case.to))
    },
    own: refract,
    mistaken: |wrong, case| match wrong {
        Wrong::Refract(wrong) => Some(of_refraction(wrong(
            case.direction,
            case.normal,
            case.from,
            case.to,
        ))),
        _ => None,
    },
    forms: &[],
    scenery: |case| {
        vec![
            arrow(-case.direction, case.direction, "Δ"),
            arrow(DVec3::ZERO, case.normal, "N"),
        ]
    },
    marks: Some(|_, answer| {
        let direction = answer.last().and_then(|(_, _, value)| value.vector());
        direction
            .map(|along| arrow(DVec3::ZERO, along, "T"))
            .into_iter()
            .collect()
    }),
};

/// A mirror or glass ball in front of a wall, and a depth limit.
fn ball(material: &str, max_depth: u32) -> Scene {
    scene(&format!(
        r#"{{"camera":{{"look_at":{{"cop":[0,0,9],"target":[0,0,0],"up":[0,1,0],"fov_degrees":40}},"pixels":[4,4]}},
        "background":[0.2,0.4,0.6],"ambient":[0.1,0.1,0.1],"max_depth":{max_depth},
        "lights":[{{"name":"lamp","position":[4,6,5],"colour":[0.8,0.8,0.8]}}],
        "materials":{{"dull":{{"colour":[0.9,0.5,0.1],"diffuse":0.7}},"m":{material}}},
        "objects":[{{"name":"ball","material":"m","shape":{{"sphere":{{"center":[0,0,0],"radius":2}}}}}},
        {{"name":"wall","material":"dull","shape":{{"polygon":{{"vertices":[[-9,-9,-5],[9,-9,-5],[9,9,-5],[-9,9,-5]]}}}}}},
        {{"name":"beside","material":"dull","shape":{{"sphere":{{"center":[4,1,3],"radius":1.5}}}}}}]}}"#
    ))
}

const MIRROR: &str = r#"{"colour":[0.5,0.5,0.5],"diffuse":0.3,"reflection":0.6}"#;
const GLASS: &str =
    r#"{"colour":[1,1,1],"diffuse":0.05,"reflection":0.1,"transmission":0.8,"index":1.5}"#;

/// The weights of the rays that a surface spawns.
pub static CHILDREN: Task<Seen, fn(&Scene, &Surface<'_>) -> DVec3> = Task {
    about: About {
        lesson: 7,
        name: "children",
        title: "the colour with the reflected and the refracted ray",
        signature: "pub fn children(scene: &Scene, surface: &Surface<'_>) -> DVec3",
        parts: &[Part::RayColour],
        uses: &[
            Part::Direction,
            Part::Transmitted,
            Part::Ambient,
            Part::LightSum,
        ],
        mistakes: &[
            "no weight",
            "background at the limit",
            "limit one too high",
            "limit one too low",
        ],
        see: See::Step {
            scene: "07-reflection-refraction/mirror.json",
            pixel: [30, 22],
            strategy: "",
            at: 13,
            kind: Kind::RayEnd,
        },
        hints: [
            "How much of the reflected and of the refracted colour does the surface pass on? What does a ray bring that is deeper than max_depth, and what happens to the transmission under total internal reflection?",
            "I = direct + reflection·I_reflected + transmission·I_refracted; I is black where depth + 1 > max_depth; under total internal reflection the reflected ray has the weight reflection + transmission.",
            "let spawned = |direction| if surface.depth < scene.max_depth { seen(scene, surface, direction) } else { DVec3::ZERO };",
        ],
        take_away: "Each child counts with its coefficient, and the tree of rays ends in black, not in the background.",
        next: "lesson 8, and your own picture",
    },
    cases: |seeds| {
        let at = |note: &str, scene: &Scene, to: [f64; 3]| {
            let cop = scene.camera.cop;
            let ray = Ray::new(cop, (DVec3::from(to) - cop).normalize());
            Case::new(
                note,
                Seen {
                    scene: scene.clone(),
                    ray,
                },
            )
        };
        let mut inside = at(
            "from inside the glass, beyond the critical angle: all light is reflected",
            &ball(GLASS, 3),
            [0.0; 3],
        );
        inside.input.ray = Ray::new(DVec3::new(1.8, 0.0, 0.0), DVec3::new(0.0, 0.0, -1.0));
        let mut cases = vec![
            at(
                "a dull wall spawns no ray",
                &ball(MIRROR, 5),
                [6.0, -4.0, -5.0],
            ),
            at(
                "a mirror that shows the background",
                &ball(MIRROR, 5),
                [0.0, 1.0, 2.0],
            ),
            at(
                "a mirror that shows the ball beside it",
                &ball(MIRROR, 5),
                [1.0, 0.3, 1.7],
            ),
            at("glass: both children", &ball(GLASS, 5), [0.5, 0.5, 1.9]),
            at(
                "a mirror at the depth limit",
                &ball(MIRROR, 1),
                [0.0, 1.0, 2.0],
            ),
            at("glass at the depth limit", &ball(GLASS, 1), [0.5, 0.5, 1.9]),
            inside,
        ];
        let mut seeded = seeds.stream(777);
        while cases.len() < 24 {
            let to = [seeded.within(-1.5, 1.5), seeded.within(-1.0, 1.0), 1.0];
            let material = if cases.len() % 2 == 0 { MIRROR } else { GLASS };
            cases.push(at(
                "a seeded point of the ball",
                &ball(material, 1 + seeded.below(4)),
                to,
            ));
        }
        cases
    },
    given: |case| {
        format!(
            "max_depth {}, {}",
            case.scene.max_depth,
            said_ray(&case.ray)
        )
    },
    answer: |student, case, _| of_colour(at_surface(case, |surface| student(&case.scene, surface))),
    own: |scene, surface| Own.shade(scene, surface),
    mistaken: |wrong, case| match wrong {
        Wrong::Shade(_) => Some(of_colour(at_surface(case, |surface| {
            wrong.shade(&case.scene, surface)
        }))),
        _ => None,
    },
    forms: &[],
    scenery: |_| Vec::new(),
    marks: Some(crate::lesson::exercise::course::shared::channels),
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::exercise::Seeds;

    #[test]
    fn each_name_of_a_case_is_what_the_scene_shows() {
        let cases = (CHILDREN.cases)(&Seeds::PUBLIC);
        let of = |word: &str| {
            let case = cases.iter().find(|case| case.note.contains(word)).unwrap();
            at_surface(&case.input, |surface| {
                let [from, to] = surface.indices();
                (
                    surface.material.reflection,
                    refract(surface.incoming, surface.normal, from, to).direction,
                )
            })
            .unwrap()
        };
        assert_eq!(of("dull").0, 0.0);
        assert_eq!(of("shows the background").0, 0.6);
        assert_eq!(of("from inside"), (0.1, None));
        assert!(of("both children").1.is_some());
    }
}
