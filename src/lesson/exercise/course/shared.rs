//! What the exercises of several lessons share: words and marks of their cases, and small scenes.

use glam::DVec3;

use crate::figure::{SketchForm, SketchMark};
use crate::geometry::{Ray, TRange};
use crate::lesson::exercise::Answer;
use crate::lesson::exercise::value::{number, vector};
use crate::scene::load::files::NoFiles;
use crate::scene::{Scene, load_bytes};

/// A ray in words.
pub(super) fn said_ray(ray: &Ray) -> String {
    format!("o = {}, Δ = {}", vector(ray.origin), vector(ray.direction))
}

/// Which t count, in words; nothing where all in front do.
pub(super) fn said_range(range: TRange) -> String {
    if range == TRange::FORWARD {
        return String::new();
    }
    format!(
        ", t from {} to {}",
        number(range.min, 6),
        number(range.max, 6)
    )
}

pub(super) fn mark(form: SketchForm, name: &str) -> SketchMark {
    SketchMark {
        form,
        name: name.into(),
    }
}

/// A ray as an arrow that is as long as it reaches.
pub(super) fn ray_mark(ray: &Ray, length: f64) -> Vec<SketchMark> {
    let unit = ray.direction.normalize_or_zero();
    vec![
        mark(SketchForm::Dot(ray.origin), "o"),
        mark(
            SketchForm::Arrow(ray.origin, ray.origin + length * unit),
            "Δ",
        ),
    ]
}

/// Points on a ray.
pub(super) fn points_at(ray: &Ray, t: &[f64]) -> Vec<SketchMark> {
    let points = t
        .iter()
        .map(|&t| mark(SketchForm::Dot(ray.at(t)), &format!("t = {}", number(t, 4))));
    points.collect()
}

/// An arrow from a point.
pub(super) fn arrow(from: DVec3, along: DVec3, name: &str) -> SketchMark {
    mark(SketchForm::Arrow(from, from + along), name)
}

/// The scene of a JSON text that stands in this folder.
pub(super) fn scene(json: &str) -> Scene {
    let loaded = load_bytes("scene.json", json.as_bytes(), &NoFiles);
    let scene = loaded.map_err(|error| error.to_string());
    let scene = scene.and_then(|of| of.build().map_err(|error| error.to_string()));
    scene.unwrap_or_else(|error| unreachable!("{error}"))
}

/// A scene of objects in a material that is called m, with a light.
pub(super) fn shapes(objects: &[String]) -> Scene {
    scene(&format!(
        r#"{{"camera":{{"window":{{"cop":[0,0,0],"corner":[-1,-1,-1],"right":[2,0,0],"up":[0,2,0]}},"pixels":[2,2]}},
        "lights":[{{"name":"lamp","position":[4,6,5],"colour":[1,1,1]}}],
        "materials":{{"m":{{"colour":[1,1,1],"diffuse":1}}}},"objects":[{}]}}"#,
        objects.join(",")
    ))
}

/// The three channels of a colour as bars.
pub(super) fn channels<I>(_: &I, answer: &Answer) -> Vec<SketchMark> {
    let colours = answer.iter().filter_map(|(_, _, value)| value.vector());
    let bars = colours.flat_map(|colour| {
        let channels = colour
            .to_array()
            .into_iter()
            .zip(["red", "green", "blue"])
            .zip(0..);
        channels.map(|((value, name), row)| {
            arrow(
                DVec3::new(0.0, -0.2 * f64::from(row), 0.0),
                DVec3::X * value,
                name,
            )
        })
    });
    bars.collect()
}
