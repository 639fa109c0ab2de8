//! Lesson 1: the pinhole camera.

use glam::DVec3;

use crate::explain::Part;
use crate::figure::{SketchForm, SketchMark};
use crate::geometry::Ray;
use crate::lesson::exercise::course::shared::{arrow, mark};
use crate::lesson::exercise::value::{number, vector};
use crate::lesson::exercise::{
    About, Answer, Case, Exercise, Form, See, Seeds, Task, Value, answer,
};
use crate::mistake::Wrong;
use crate::scene::Camera;
use crate::trace::Kind;
use crate::tracer::simple::{Own, Parts};

pub(super) static ALL: [&dyn Exercise; 2] = [&WINDOW_POINT, &EYE_RAY];

/// A camera and a place on its window, counted in pixels.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    camera: Camera,
    x: f64,
    y: f64,
}

/// A window of 4 × 2 pixels with sides of 1, around the line along −z and 1 ahead of the eye.
const STRAIGHT: Camera = Camera {
    cop: DVec3::ZERO,
    to_corner: DVec3::new(-2.0, -1.0, -1.0),
    right: DVec3::new(4.0, 0.0, 0.0),
    up: DVec3::new(0.0, 2.0, 0.0),
    pixels: [4, 2],
};

/// A window that stands aslant and beside the line of sight, of pixels that are no squares.
const ASLANT: Camera = Camera {
    cop: DVec3::new(1.0, 2.0, 8.0),
    to_corner: DVec3::new(-1.0, -2.0, -4.0),
    right: DVec3::new(3.0, 0.0, 1.0),
    up: DVec3::new(0.0, 2.0, -1.0),
    pixels: [6, 5],
};

fn cases(seeds: &Seeds) -> Vec<Case<Place>> {
    let centre = |note: &str, camera: Camera, [column, row]: [u32; 2]| {
        let [x, y] = [column, row].map(|of| f64::from(of) + 0.5);
        Case::new(note, Place { camera, x, y })
    };
    let mut cases = vec![
        centre(
            "the centre of pixel (0, 0), at the top left",
            STRAIGHT,
            [0, 0],
        ),
        centre(
            "the centre of the last pixel, at the bottom right",
            STRAIGHT,
            [3, 1],
        ),
        centre("the centre of a pixel of the upper row", STRAIGHT, [2, 0]),
        Case::new(
            "the top left corner of the window",
            Place {
                camera: STRAIGHT,
                x: 0.0,
                y: 0.0,
            },
        ),
        Case::new(
            "the middle of the window",
            Place {
                camera: STRAIGHT,
                x: 2.0,
                y: 1.0,
            },
        ),
        centre(
            "the window stands aslant, and the eye is not in the origin",
            ASLANT,
            [1, 0],
        ),
        centre("the window stands aslant, the last row", ASLANT, [2, 4]),
    ];
    let mut seeded = seeds.stream(1);
    while cases.len() < 40 {
        let camera = Camera {
            cop: seeded.point(5.0),
            to_corner: DVec3::new(-1.0, -1.0, -2.0) + seeded.point(0.3),
            right: DVec3::new(2.5, 0.0, 0.0) + seeded.point(0.3),
            up: DVec3::new(0.0, 1.5, 0.0) + seeded.point(0.3),
            pixels: [5 + seeded.below(20), 25 + seeded.below(9)],
        };
        let pixel = camera.pixels.map(|side| seeded.below(side));
        cases.push(centre("a seeded window", camera, pixel));
    }
    cases
}

fn given(case: &Place) -> String {
    let Camera {
        to_corner,
        right,
        up,
        pixels: [width, height],
        ..
    } = case.camera;
    format!(
        "{width} × {height} pixels, corner − COP = {}, right = {}, up = {}, x = {}, y = {}",
        vector(to_corner),
        vector(right),
        vector(up),
        number(case.x, 6),
        number(case.y, 6)
    )
}

/// The window as it is seen from the COP.
fn scenery(case: &Place) -> Vec<SketchMark> {
    let Camera {
        to_corner,
        right,
        up,
        ..
    } = case.camera;
    let corners = vec![
        to_corner,
        to_corner + right,
        to_corner + right + up,
        to_corner + up,
    ];
    vec![
        mark(SketchForm::Outline(corners), "corner"),
        mark(SketchForm::Dot(to_corner + up), "top left"),
    ]
}

fn of_point(point: DVec3) -> Answer {
    answer(Part::WindowPoint, point)
}

/// The point of the window that belongs to a place in pixels.
pub static WINDOW_POINT: Task<Place, fn(&Camera, f64, f64) -> DVec3> = Task {
    about: About {
        lesson: 1,
        name: "window_point",
        title: "the point of the window that belongs to a pixel",
        signature: "pub fn window_point(camera: &Camera, x: f64, y: f64) -> DVec3",
        parts: &[Part::WindowPoint],
        uses: &[],
        mistakes: &[
            "row from below",
            "u and v swapped",
            "w turned",
            "no ½",
            "n − 1",
            "aspect twice",
            "tan of the whole angle",
            "degrees for radians",
        ],
        see: See::Step {
            scene: "01-pinhole/balls.json",
            pixel: [6, 2],
            strategy: "",
            at: 0,
            kind: Kind::Pixel,
        },
        hints: [
            "x counts columns from the left edge and y rows from the top edge, but the window's corner is its lower left one.",
            "P − COP = (corner − COP) + (x/width)·right + (1 − y/height)·up",
            "camera.to_corner + (x / width) * camera.right + (1.0 - y / height) * camera.up",
        ],
        take_away: "Rows are counted from the top, and the centre of pixel (x, y) is at (x + ½, y + ½).",
        next: "l01_eye_ray",
    },
    cases,
    given,
    answer: |student, case, _| of_point(student(&case.camera, case.x, case.y)),
    own: |camera, x, y| Own.window_point(camera, x, y),
    mistaken: |wrong, case| match wrong {
        Wrong::WindowPoint(wrong) => Some(of_point(wrong(&case.camera, case.x, case.y))),
        _ => None,
    },
    forms: &[],
    scenery,
    marks: Some(|_, answer| {
        let dots = answer.iter().filter_map(|(_, _, value)| value.vector());
        dots.map(|point| mark(SketchForm::Dot(point), "P"))
            .collect()
    }),
};

fn of_ray(ray: &Ray) -> Answer {
    vec![
        (Part::WindowPoint, "o", ray.origin.into()),
        (Part::Direction, "Δ", ray.direction.into()),
    ]
}

/// The ray from the COP through a point of the window.
pub static EYE_RAY: Task<Place, fn(&Camera, DVec3) -> Ray> = Task {
    about: About {
        lesson: 1,
        name: "eye_ray",
        title: "the ray from the eye through a point of the window",
        signature: "pub fn eye_ray(camera: &Camera, to_window: DVec3) -> Ray",
        parts: &[Part::Direction],
        uses: &[Part::WindowPoint],
        mistakes: &[],
        see: See::Step {
            scene: "01-pinhole/balls.json",
            pixel: [6, 2],
            strategy: "",
            at: 1,
            kind: Kind::Ray,
        },
        hints: [
            "Where does the ray start, and towards which point does it run? Its direction has unit length.",
            "o = COP, Δ = (P − COP)/|P − COP|; to_window is P − COP.",
            "Ray::new(camera.cop, to_window / to_window.length())",
        ],
        take_away: "With |Δ| = 1, t is a distance from the eye; the window lies at t = |P − COP| and not at 1.",
        next: "lesson 2",
    },
    cases,
    given: |case| {
        let Place { camera, x, y } = case;
        format!(
            "COP = {}, P − COP = {}",
            vector(camera.cop),
            vector(camera.to_window(*x, *y))
        )
    },
    answer: |student, case, _| {
        let to_window = case.camera.to_window(case.x, case.y);
        of_ray(&student(&case.camera, to_window))
    },
    own: |camera, to_window| Own.eye_ray(camera, to_window),
    mistaken: |_, _| None,
    forms: &[Form {
        is: |case, yours| {
            let to_window = case.camera.to_window(case.x, case.y);
            let along = yours.last().and_then(|(_, _, value)| value.vector());
            let along = along.and_then(DVec3::try_normalize);
            along.is_some_and(|unit| Value::from(unit).is_same(&to_window.normalize().into()))
        },
        note: "Δ runs the right way; here it has unit length, so that t is a distance",
    }],
    scenery: |case| {
        let Camera {
            cop,
            to_corner,
            right,
            up,
            ..
        } = case.camera;
        let corner = cop + to_corner;
        let corners = vec![corner, corner + right, corner + right + up, corner + up];
        vec![
            mark(SketchForm::Outline(corners), "window"),
            mark(SketchForm::Dot(cop), "COP"),
        ]
    },
    marks: Some(|_, answer| {
        match answer
            .iter()
            .filter_map(|(_, _, value)| value.vector())
            .collect::<Vec<_>>()[..]
        {
            [origin, direction] => vec![arrow(origin, direction, "Δ")],
            _ => Vec::new(),
        }
    }),
};
