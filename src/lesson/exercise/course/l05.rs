//! Lesson 5: shading.

use glam::DVec3;

use crate::explain::Part;
use crate::figure::{SketchForm, SketchMark};
use crate::geometry::{Polygon, Ray, Sphere, TRange};
use crate::lesson::exercise::course::shared::{arrow, mark, said_range, said_ray, scene};
use crate::lesson::exercise::value::{number, vector};
use crate::lesson::exercise::{About, Answer, Case, Exercise, Form, See, Task, Value, answer};
use crate::mistake::Wrong;
use crate::scene::{Emission, Light, Material, Normals, PhongTerm, Scene, Shape};
use crate::trace::Kind;
use crate::tracer::simple::{Own, Parts};
use crate::tracer::{Surface, start_epsilon};

pub(super) static ALL: [&dyn Exercise; 5] = [&NORMALS, &LIGHT_TERM, &EPSILON, &BLOCKED, &SHADE];

/// The scene of the lesson, and the pixel that shows it.
const fn see(kind: Kind, at: u32) -> See {
    See::Step {
        scene: "05-shading/scene.json",
        pixel: [0, 0],
        strategy: "",
        at,
        kind,
    }
}

/// A surface and a point of it.
#[derive(Clone, Debug)]
pub struct ShapePoint {
    shape: Shape,
    point: DVec3,
}

fn on_sphere(note: &str, center: DVec3, radius: f64, towards: DVec3) -> Case<ShapePoint> {
    let shape = Shape::Sphere(Sphere { center, radius });
    Case::new(
        note,
        ShapePoint {
            shape,
            point: center + radius * towards,
        },
    )
}

/// The point is in the middle of the first three vertices.
fn on_polygon(note: &str, vertices: Vec<DVec3>) -> Option<Case<ShapePoint>> {
    let point = (vertices[0] + vertices[1] + vertices[2]) / 3.0;
    let shape = Shape::Polygon(Polygon::new(vertices, None).ok()?);
    Some(Case::new(note, ShapePoint { shape, point }))
}

fn of_normals(normals: Normals) -> Answer {
    vec![
        (Part::Normal, "N", normals.geometric.into()),
        (Part::Normal, "N to shade with", normals.shading.into()),
    ]
}

/// The normals of spheres and polygons.
pub static NORMALS: Task<ShapePoint, fn(&Shape, DVec3) -> Normals> = Task {
    about: About {
        lesson: 5,
        name: "normals",
        title: "the unit normal at a point",
        signature: "pub fn normals(shape: &Shape, point: DVec3) -> Normals",
        parts: &[Part::Normal],
        uses: &[Part::Ray, Part::Choice],
        mistakes: &[
            "p instead of p − c",
            "not divided by r",
            "cross product turned",
        ],
        see: see(Kind::Shade, 8),
        hints: [
            "Of a sphere: from where to where does the normal run, and how long is that vector? Of a polygon: two edges give a vector across both.",
            "Sphere: N = (p − c)/r. Polygon: (v₁ − v₀) × (v₂ − v₀), brought to unit length.",
            "(point - sphere.center) / sphere.radius; (v[1] - v[0]).cross(v[2] - v[0]).normalize()",
        ],
        take_away: "A normal has unit length, and a × b = −(b × a): the order of the edges says which side is the front.",
        next: "l05_light_term",
    },
    cases: |seeds| {
        let at = DVec3::new;
        let corners = |of: [[f64; 3]; 3]| of.map(DVec3::from).to_vec();
        let mut cases = vec![
            on_sphere(
                "a sphere of radius 1 around the origin",
                DVec3::ZERO,
                1.0,
                DVec3::X,
            ),
            on_sphere("the radius is 2", DVec3::ZERO, 2.0, DVec3::Y),
            on_sphere(
                "the centre is not the origin",
                at(3.0, 0.0, -4.0),
                1.0,
                DVec3::NEG_X,
            ),
            on_sphere(
                "a small sphere far from the origin",
                at(3.0, 7.0, -4.0),
                0.5,
                at(0.6, 0.0, 0.8),
            ),
        ];
        cases.extend(on_polygon(
            "a floor, whose front is above",
            corners([[0.0, 0.0, 0.0], [0.0, 0.0, 3.0], [2.0, 0.0, 0.0]]),
        ));
        cases.extend(on_polygon(
            "the same floor with its vertices the other way round",
            corners([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 3.0]]),
        ));
        let square = [
            [0.0, 0.0, 5.0],
            [2.0, 0.0, 5.0],
            [2.0, 2.0, 5.0],
            [0.0, 2.0, 5.0],
        ];
        cases.extend(on_polygon("a square", square.map(DVec3::from).to_vec()));
        let mut seeded = seeds.stream(5);
        while cases.len() < 40 {
            cases.push(on_sphere(
                "a seeded sphere",
                seeded.point(5.0),
                seeded.within(0.3, 3.0),
                seeded.direction(),
            ));
            let vertices = vec![seeded.point(4.0), seeded.point(4.0), seeded.point(4.0)];
            let area = (vertices[1] - vertices[0])
                .cross(vertices[2] - vertices[0])
                .length();
            if 0.5 < area {
                cases.extend(on_polygon("a seeded triangle", vertices));
            }
        }
        cases
    },
    given: |case| match &case.shape {
        Shape::Sphere(sphere) => format!(
            "sphere: c = {}, r = {}, p = {}",
            vector(sphere.center),
            number(sphere.radius, 6),
            vector(case.point)
        ),
        Shape::Polygon(polygon) => {
            let vertices: Vec<_> = polygon.vertices().map(vector).collect();
            format!("polygon: {}", vertices.join(", "))
        }
        _ => String::new(),
    },
    answer: |student, case, _| of_normals(student(&case.shape, case.point)),
    own: |shape, point| Own.normals(shape, point),
    mistaken: |wrong, case| match wrong {
        Wrong::Normals(wrong) => Some(of_normals(wrong(&case.shape, case.point))),
        _ => None,
    },
    forms: &[],
    scenery: |case| match &case.shape {
        Shape::Sphere(sphere) => vec![
            mark(SketchForm::Circle(sphere.center, sphere.radius), "c"),
            mark(SketchForm::Dot(case.point), "p"),
        ],
        Shape::Polygon(polygon) => vec![mark(
            SketchForm::Outline(polygon.vertices().collect()),
            "v₀",
        )],
        _ => Vec::new(),
    },
    marks: Some(|case, answer| {
        let normals = answer
            .iter()
            .take(1)
            .filter_map(|(_, _, value)| value.vector());
        normals
            .map(|normal| arrow(case.point, normal, "N"))
            .collect()
    }),
};

/// A light, a material, a point with its normal, and the viewer.
#[derive(Clone, Debug)]
pub struct Lit {
    light: Light,
    material: Material,
    point: DVec3,
    normal: DVec3,
    to_viewer: DVec3,
}

const SHINY: Material = Material {
    colour: [0.8, 0.4, 0.2],
    diffuse: 0.7,
    specular: 0.3,
    shininess: 10.0,
    reflection: 0.0,
    transmission: 0.0,
    index: 1.0,
};

fn lit(note: &str, light: [f64; 3], point: DVec3, normal: DVec3, to_viewer: DVec3) -> Case<Lit> {
    let light = Light {
        name: "lamp".into(),
        position: light.into(),
        emission: Emission::Colour(DVec3::new(1.0, 0.9, 0.8)),
    };
    Case::new(
        note,
        Lit {
            light,
            material: SHINY,
            point,
            normal,
            to_viewer,
        },
    )
}

fn of_term(term: PhongTerm) -> Answer {
    vec![
        (Part::ToLight, "L", term.to_light.into()),
        (Part::ToLight, "distance", term.distance.into()),
        (Part::ToLight, "N·L", term.n_dot_l.into()),
        (Part::Diffuse, "", term.diffuse.into()),
        (Part::Specular, "", term.specular.into()),
    ]
}

/// The specular term with the vector H between L and V, after J. Blinn (1977).
fn half_vector(case: &Lit) -> DVec3 {
    let to_light = (case.light.position - case.point).normalize_or_zero();
    let half = (to_light + case.to_viewer).normalize_or_zero();
    match case.light.emission {
        Emission::Colour(light) if 0.0 < case.normal.dot(to_light) => {
            let highlight = libm::pow(case.normal.dot(half).max(0.0), case.material.shininess);
            light * (case.material.specular * highlight)
        }
        _ => DVec3::ZERO,
    }
}

/// The diffuse and the specular term of a light.
pub static LIGHT_TERM: Task<Lit, fn(&Light, &Material, DVec3, DVec3, DVec3) -> PhongTerm> = Task {
    about: About {
        lesson: 5,
        name: "light_term",
        title: "the diffuse and the specular term of one light",
        signature: "pub fn light_term(light: &Light, material: &Material, point: DVec3, normal: DVec3, to_viewer: DVec3) -> PhongTerm",
        parts: &[Part::ToLight, Part::Diffuse, Part::Specular],
        uses: &[Part::Normal],
        mistakes: &[
            "L from light to point",
            "only the sum clamped",
            "R made of V",
        ],
        see: see(Kind::LightTerm, 7),
        hints: [
            "L runs from the point to the light, V from the point to the viewer, and R is L mirrored at N. Where N·L ≤ 0 the light is behind.",
            "R = 2(N·L)N − L; diffuse: light·colour·diffuse·(N·L); specular: light·specular·max(0, R·V)^shininess; both are 0 where N·L ≤ 0.",
            "let mirrored = 2.0 * n_dot_l * normal - to_light; the highlight is mirrored.dot(to_viewer).max(0.0) to the power of material.shininess",
        ],
        take_away: "Each term is cut off at 0 on its own; a light behind the surface gives neither.",
        next: "l05_epsilon",
    },
    cases: |seeds| {
        let (o, up) = (DVec3::ZERO, DVec3::Y);
        let slant = DVec3::new(0.6, 0.8, 0.0);
        let mut cases = vec![
            lit(
                "the light stands right above the point",
                [0.0, 4.0, 0.0],
                o,
                up,
                slant,
            ),
            lit(
                "the light stands aslant, the viewer where it is mirrored to",
                [-3.0, 4.0, 0.0],
                o,
                up,
                slant,
            ),
            lit(
                "the viewer is where the light is: R·V is below 1",
                [3.0, 4.0, 0.0],
                o,
                up,
                slant,
            ),
            lit(
                "the point is not the origin",
                [1.0, 6.0, 3.0],
                DVec3::new(1.0, 2.0, 0.0),
                up,
                up,
            ),
            lit(
                "the light stands behind the surface: both terms are 0",
                [1.0, -4.0, 0.0],
                o,
                up,
                slant,
            ),
            lit(
                "just behind the surface, where R·V is large: both terms are 0",
                [-4.0, -0.5, 0.0],
                o,
                up,
                DVec3::new(0.96, 0.28, 0.0),
            ),
            lit(
                "R·V is negative: no highlight",
                [4.0, 1.0, 0.0],
                o,
                up,
                DVec3::new(0.96, 0.28, 0.0),
            ),
        ];
        let mut seeded = seeds.stream(55);
        while cases.len() < 40 {
            let (normal, to_viewer) = (seeded.direction(), seeded.direction());
            let new = lit(
                "a seeded point",
                seeded.point(6.0).to_array(),
                seeded.point(3.0),
                normal,
                to_viewer,
            );
            let to_light = new.input.light.position - new.input.point;
            // clear of the plane of the surface, and seen from its side
            if 0.1 < normal.dot(to_viewer) && 0.1 < normal.dot(to_light).abs() {
                cases.push(new);
            }
        }
        cases
    },
    given: |case| {
        format!(
            "light at {}, p = {}, N = {}, V = {}",
            vector(case.light.position),
            vector(case.point),
            vector(case.normal),
            vector(case.to_viewer)
        )
    },
    answer: |student, case, _| {
        of_term(student(
            &case.light,
            &case.material,
            case.point,
            case.normal,
            case.to_viewer,
        ))
    },
    own: Light::phong,
    mistaken: |wrong, case| match wrong {
        Wrong::LightTerm(wrong) => Some(of_term(wrong(
            &case.light,
            &case.material,
            case.point,
            case.normal,
            case.to_viewer,
        ))),
        _ => None,
    },
    forms: &[Form {
        is: |case, yours| {
            let right =
                of_term(
                    case.light
                        .phong(&case.material, case.point, case.normal, case.to_viewer),
                );
            let half = half_vector(case);
            let pairs = yours.iter().zip(&right);
            pairs.into_iter().all(|(yours, right)| {
                yours.2.is_same(&right.2)
                    || (yours.0 == Part::Specular && yours.2.is_same(&half.into()))
            })
        },
        note: "this is Blinn's N·H, with H between L and V; here it is Phong's R·V",
    }],
    scenery: |case| {
        vec![
            mark(SketchForm::Dot(case.point), "p"),
            mark(SketchForm::Dot(case.light.position), "light"),
            arrow(case.point, case.normal, "N"),
            arrow(case.point, case.to_viewer, "V"),
        ]
    },
    marks: Some(|case, answer| {
        let to_light = answer.first().and_then(|(_, _, value)| value.vector());
        to_light
            .map(|along| arrow(case.point, along, "L"))
            .into_iter()
            .collect()
    }),
};

/// A point, the t of the ray that hit it, and the size of the surface.
#[derive(Clone, Copy, Debug)]
pub struct PointAndT {
    point: DVec3,
    t: f64,
    reach: f64,
}

/// The smallest t that counts for a ray that starts on a surface.
pub static EPSILON: Task<PointAndT, fn(DVec3, f64, f64) -> f64> = Task {
    about: About {
        lesson: 5,
        name: "epsilon",
        title: "ε, the smallest t of a ray that starts on a surface",
        signature: "pub fn epsilon(point: DVec3, t: f64, reach: f64) -> f64",
        parts: &[Part::Point],
        uses: &[Part::Ray],
        mistakes: &["ε not scaled"],
        see: see(Kind::Shade, 8),
        hints: [
            "A computed point is off the surface by rounding, which grows with the numbers that it was computed from.",
            "ε = max(10⁻⁹ · max(|x|, |y|, |z|, t), 10⁻¹³ · reach)",
            "let numbers = point.abs().max_element().max(t); (1e-9 * numbers).max(1e-13 * reach)",
        ],
        take_away: "ε grows with the scene: a fixed one is too small for large scenes (acne) or too large for small ones.",
        next: "l05_blocked",
    },
    cases: |seeds| {
        let case = |note: &str, point: [f64; 3], t: f64, reach: f64| {
            let point = point.into();
            // in billionths, so that a small ε can be compared
            Case::new(note, PointAndT { point, t, reach })
        };
        let mut cases = vec![
            case(
                "a coordinate is the largest number",
                [3.0, -4.0, 2.0],
                1.0,
                1.0,
            ),
            case("t is the largest number", [3.0, -4.0, 2.0], 10.0, 1.0),
            case("a small scene", [0.001, 0.002, 0.0], 0.003, 0.002),
            case("a large scene", [1e6, 0.0, -2e6], 3e6, 2e6),
            case("the surface is a huge sphere", [3.0, -4.0, 2.0], 1.0, 1e9),
        ];
        let mut seeded = seeds.stream(555);
        while cases.len() < 25 {
            cases.push(case(
                "seeded",
                seeded.point(50.0).to_array(),
                seeded.within(0.0, 99.0),
                seeded.within(1.0, 1e6),
            ));
        }
        cases
    },
    given: |case| {
        format!(
            "p = {}, t = {}, reach = {}",
            vector(case.point),
            number(case.t, 6),
            number(case.reach, 6)
        )
    },
    answer: |student, case, _| {
        let epsilon = student(case.point, case.t, case.reach);
        vec![(Part::Point, "ε in billionths", Value::Number(epsilon * 1e9))]
    },
    own: start_epsilon,
    mistaken: |wrong, case| match wrong {
        Wrong::StartEpsilon(wrong) => {
            let epsilon = wrong(case.point, case.t, case.reach);
            Some(vec![(
                Part::Point,
                "ε in billionths",
                Value::Number(epsilon * 1e9),
            )])
        }
        _ => None,
    },
    forms: &[],
    scenery: |_| Vec::new(),
    marks: None,
};

/// A scene and a shadow ray in it.
#[derive(Clone, Debug)]
pub struct ShadowRay {
    scene: Scene,
    ray: Ray,
    range: TRange,
}

/// A floor, two lamps and balls; the eye looks down on it.
fn with_balls(balls: &[([f64; 3], f64)], more: &str) -> Scene {
    let balls = balls.iter().enumerate().map(|(name, (center, radius))| {
        format!(r#",{{"name":"ball {name}","material":"m","shape":{{"sphere":{{"center":{center:?},"radius":{radius:?}}}}}}}"#)
    });
    scene(&format!(
        r#"{{"camera":{{"look_at":{{"cop":[0,2,12],"target":[0,0,0],"up":[0,1,0],"fov_degrees":40}},"pixels":[4,4]}},
        "ambient":[0.1,0.2,0.3],
        "lights":[{{"name":"first","position":[0,8,0],"colour":[0.6,0.6,0.6]}},{{"name":"second","position":[6,8,0],"colour":[0.3,0.3,0.4]}}],
        "materials":{{"m":{{"colour":[0.8,0.6,0.4],"diffuse":0.7,"specular":0.3,"shininess":20}}{more}}},
        "objects":[{{"name":"floor","material":"m","shape":{{"polygon":{{"vertices":[[-9,0,-9],[-9,0,9],[9,0,9],[9,0,-9]]}}}}}}{}]}}"#,
        balls.collect::<String>()
    ))
}

fn shadow_ray(note: &str, scene: &Scene, from: DVec3, light: usize) -> Case<ShadowRay> {
    let to_light = scene.lights[light].position - from;
    let distance = to_light.length();
    Case::new(
        note,
        ShadowRay {
            scene: scene.clone(),
            ray: Ray::new(from, to_light / distance),
            range: TRange {
                min: 1e-8,
                max: distance * (1.0 - 1e-9),
            },
        },
    )
}

fn of_blocked(is_blocked: bool) -> Answer {
    vec![(Part::Visibility, "blocked", Value::is(is_blocked))]
}

/// Whether a light is hidden.
pub static BLOCKED: Task<ShadowRay, fn(&Scene, &Ray, TRange) -> bool> = Task {
    about: About {
        lesson: 5,
        name: "blocked",
        title: "whether anything stands between the point and the light",
        signature: "pub fn blocked(scene: &Scene, ray: &Ray, range: TRange) -> bool",
        parts: &[Part::Visibility],
        uses: &[Part::Nearest, Part::Point],
        mistakes: &[
            "no ε",
            "ε in t of an unnormalised ray",
            "any hit counts",
            "from the eye",
            "first light only",
            "no shadow ray",
        ],
        see: See::Step {
            scene: "02-simple-tracer/scene.json",
            pixel: [30, 21],
            strategy: "",
            at: 10,
            kind: Kind::LightTerm,
        },
        hints: [
            "A single object that is hit in the range is enough; which one is nearest does not matter. The range begins at ε and ends before the light.",
            "blocked = there is an object with a hit t, range.min ≤ t ≤ range.max.",
            "scene.primitives.iter().any(|primitive| hit(primitive, ray, range).is_some())",
        ],
        take_away: "The shadow ray starts on a surface and ends at the light: both ends of its range matter.",
        next: "l05_shade",
    },
    cases: |seeds| {
        let above = with_balls(&[([0.0, 4.0, 0.0], 1.0)], "");
        let beyond = with_balls(&[([0.0, 11.0, 0.0], 1.0)], "");
        let beside = with_balls(&[([3.0, 4.0, 0.0], 0.5)], "");
        let origin = DVec3::ZERO;
        // a point of the ball that is off it by rounding: 2⁻⁴⁹ inside
        let on_ball = DVec3::new(0.0, 5.0 - 2f64.powi(-49), 0.0);
        let mut leaf = with_balls(&[], "");
        // a second floor, 40 billionths above the first one
        leaf.primitives.push(leaf.primitives[0].clone());
        let above_floor = [[-9.0, -9.0], [-9.0, 9.0], [9.0, 9.0], [9.0, -9.0]];
        let corners = above_floor.map(|[x, z]| DVec3::new(x, 4e-8, z)).to_vec();
        if let Ok(polygon) = Polygon::new(corners, None) {
            leaf.primitives[1].shape = Shape::Polygon(polygon);
        }
        let at_eye = with_balls(&[([0.0, 3.0, 11.0], 1.5)], "");
        let mut cases = vec![
            shadow_ray("nothing stands between", &with_balls(&[], ""), origin, 0),
            shadow_ray(
                "a ball stands between the point and the light",
                &above,
                origin,
                0,
            ),
            shadow_ray(
                "a ball stands beside the ray",
                &above,
                DVec3::new(4.0, 0.0, 0.0),
                1,
            ),
            shadow_ray("a ball stands beyond the light", &beyond, origin, 0),
            shadow_ray(
                "the point lies on the ball, which does not block itself",
                &above,
                on_ball,
                0,
            ),
            shadow_ray("the second light is blocked", &beside, origin, 1),
            shadow_ray(
                "a leaf lies just above the floor, further away than ε",
                &leaf,
                origin,
                0,
            ),
            shadow_ray(
                "a ball stands in front of the eye, but not of the point",
                &at_eye,
                origin,
                0,
            ),
            shadow_ray(
                "behind the ball, seen from the second light",
                &above,
                DVec3::new(-6.0, 0.0, 0.0),
                1,
            ),
        ];
        let mut seeded = seeds.stream(5555);
        while cases.len() < 40 {
            let balls: Vec<_> = (0..4)
                .map(|_| {
                    let center = seeded.point(5.0) + DVec3::Y * 6.0;
                    (center.to_array(), seeded.within(0.4, 1.2))
                })
                .collect();
            let from = DVec3::new(seeded.within(-5.0, 5.0), 0.0, seeded.within(-5.0, 5.0));
            let light = seeded.below(2) as usize;
            let scene = with_balls(&balls, "");
            cases.push(shadow_ray("four seeded balls", &scene, from, light));
        }
        cases
    },
    given: |case| {
        let count = case.scene.primitives.len();
        format!(
            "{count} objects, {}{}",
            said_ray(&case.ray),
            said_range(case.range)
        )
    },
    answer: |student, case, _| of_blocked(student(&case.scene, &case.ray, case.range)),
    own: |scene, ray, range| Own.blocked(scene, ray, range),
    mistaken: |wrong, case| {
        Some(of_blocked(wrong.blocked(
            &case.scene,
            &case.ray,
            case.range,
        )))
    },
    forms: &[],
    scenery: |case| {
        let mut marks = balls(&case.scene);
        marks.push(mark(
            SketchForm::Line(case.ray.origin, case.ray.at(case.range.max)),
            "light",
        ));
        marks.push(mark(SketchForm::Dot(case.ray.origin), "p"));
        marks
    },
    marks: Some(|_, _| Vec::new()),
};

fn balls(scene: &Scene) -> Vec<SketchMark> {
    let shapes = scene.primitives.iter().zip(&scene.objects);
    let balls = shapes.filter_map(|(primitive, object)| match &primitive.shape {
        Shape::Sphere(sphere) => Some(mark(
            SketchForm::Circle(sphere.center, sphere.radius),
            &object.name,
        )),
        _ => None,
    });
    balls.collect()
}

/// A scene and a ray that hits something in it.
#[derive(Clone, Debug)]
pub struct Seen {
    pub(super) scene: Scene,
    pub(super) ray: Ray,
}

/// What a function of a surface gives where a ray hits the scene.
pub(super) fn at_surface<T>(case: &Seen, of: impl Fn(&Surface<'_>) -> T) -> Option<T> {
    let hit = Own.nearest(&case.scene, &case.ray, TRange::FORWARD)?;
    let normals = Own.normals(&case.scene.primitive(hit.object).shape, case.ray.at(hit.t));
    Some(of(&Surface::new(&case.scene, &case.ray, 1, hit, normals)))
}

pub(super) fn of_colour(colour: Option<DVec3>) -> Answer {
    answer(Part::RayColour, colour.unwrap_or_default())
}

/// The colour of a surface without mirrors and glass.
pub static SHADE: Task<Seen, fn(&Scene, &Surface<'_>) -> DVec3> = Task {
    about: About {
        lesson: 5,
        name: "shade",
        title: "the colour of a point: ambient, and the terms of all visible lights",
        signature: "pub fn shade(scene: &Scene, surface: &Surface<'_>) -> DVec3",
        parts: &[Part::Ambient, Part::LightSum, Part::RayColour],
        uses: &[
            Part::Normal,
            Part::ToLight,
            Part::Diffuse,
            Part::Specular,
            Part::Visibility,
            Part::Point,
        ],
        mistakes: &["ambient in the loop", "offset to the wrong side"],
        see: see(Kind::Shade, 8),
        hints: [
            "What is added once, and what once for each light? Which lights add nothing?",
            "I = ambient·colour + Σ over visible lights of (diffuse + specular)",
            "let mut sum = scene.ambient * colour; then for each light: if 0.0 < term.n_dot_l && !blocked(scene, &ray, range) { sum += term.diffuse + term.specular; }",
        ],
        take_away: "Ambient light has no lamp: it is added once, before the loop over the lights.",
        next: "lesson 6, and your own picture",
    },
    cases: |seeds| {
        let one = with_balls(&[([0.0, 4.0, 0.0], 1.0)], "");
        let down = |note: &str, scene: &Scene, to: [f64; 3]| {
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
        let mut dark = one.clone();
        dark.lights.clear();
        let mut cases = vec![
            down("no light: the ambient term alone", &dark, [0.0; 3]),
            down("both lights are visible", &one, [-4.0, 0.0, 0.0]),
            down(
                "the first light is blocked by a ball",
                &one,
                [0.0, 0.0, 0.0],
            ),
            down(
                "the second light is blocked by a ball",
                &one,
                [-6.0, 0.0, 0.0],
            ),
            down(
                "a point of the ball that faces one light only",
                &one,
                [0.0, 4.0, 0.0],
            ),
        ];
        let mut seeded = seeds.stream(55555);
        while cases.len() < 30 {
            cases.push(down(
                "a seeded point of the floor",
                &one,
                [seeded.within(-5.0, 5.0), 0.0, seeded.within(-5.0, 3.0)],
            ));
        }
        cases
    },
    given: |case| {
        format!(
            "{} lights, {}",
            case.scene.lights.len(),
            said_ray(&case.ray)
        )
    },
    answer: |student, case, _| of_colour(at_surface(case, |surface| student(&case.scene, surface))),
    own: |scene, surface| Own.shade(scene, surface),
    mistaken: |wrong, case| match wrong {
        Wrong::Shade(_) | Wrong::LeavesFrom(_) => Some(of_colour(at_surface(case, |surface| {
            wrong.shade(&case.scene, surface)
        }))),
        _ => None,
    },
    forms: &[],
    scenery: |_| Vec::new(),
    marks: Some(crate::lesson::exercise::course::shared::channels),
};
