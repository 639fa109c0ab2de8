//! Small scenes for unit tests.

use crate::scene::{NoFiles, Scene, load_bytes};

/// The scene of a JSON text.
#[track_caller]
pub(crate) fn scene_from(json: &str) -> Scene {
    let loaded = load_bytes("scene.json", json.as_bytes(), &NoFiles);
    loaded.unwrap().build().unwrap()
}

/// A scene of these shapes, in a material that is white and diffuse. The eye is in the origin and looks along −z through a
/// window of 2 × 2 pixels, whose sides are 1 long and which lies 1 ahead.
#[track_caller]
pub(crate) fn scene_of(shapes: &[String]) -> Scene {
    let object = |(number, shape): (usize, &String)| {
        format!(r#"{{"name":"{number}","material":"white","shape":{shape}}}"#)
    };
    let objects: Vec<_> = shapes.iter().enumerate().map(object).collect();
    scene_from(&format!(
        r#"{{"camera":{{"window":{{"cop":[0,0,0],"corner":[-1,-1,-1],"right":[2,0,0],"up":[0,2,0]}},
        "pixels":[2,2]}},"materials":{{"white":{{"colour":[1,1,1],"diffuse":1}}}},"objects":[{}]}}"#,
        objects.join(",")
    ))
}

/// A sphere, as a scene file has it.
pub(crate) fn sphere(center: [f64; 3], radius: f64) -> String {
    format!(r#"{{"sphere":{{"center":{center:?},"radius":{radius:?}}}}}"#)
}

/// A box, as a scene file has it.
pub(crate) fn solid(min: [f64; 3], max: [f64; 3]) -> String {
    format!(r#"{{"box":{{"min":{min:?},"max":{max:?}}}}}"#)
}

/// A cube with sides of 1 whose corner with the smallest coordinates is at (x, 0, 0).
pub(crate) fn cube_at(x: f64) -> String {
    solid([x, 0.0, 0.0], [x + 1.0, 1.0, 1.0])
}

/// A polygon, as a scene file has it.
pub(crate) fn polygon(vertices: &[[f64; 3]]) -> String {
    format!(r#"{{"polygon":{{"vertices":{vertices:?}}}}}"#)
}

/// A scene of one pixel: the eye is in the origin and looks along −z through the middle of a window with sides of 2, which lies
/// 1 ahead. `rest` is the scene file's other keys.
#[track_caller]
pub(crate) fn one_pixel(rest: &str) -> Scene {
    scene_from(&format!(
        r#"{{"camera":{{"window":{{"cop":[0,0,0],"corner":[-1,-1,-1],"right":[2,0,0],"up":[0,2,0]}},
        "pixels":[1,1]}},{rest}}}"#
    ))
}

/// An object with a name and a material.
pub(crate) fn object(name: &str, material: &str, shape: &str) -> String {
    format!(r#"{{"name":"{name}","material":"{material}","shape":{shape}}}"#)
}

/// A large square across z, which faces the origin.
pub(crate) fn wall(z: f64) -> String {
    let mut corners = [
        [-90.0, -90.0, z],
        [90.0, -90.0, z],
        [90.0, 90.0, z],
        [-90.0, 90.0, z],
    ];
    if 0.0 < z {
        corners.reverse();
    }
    polygon(&corners)
}
