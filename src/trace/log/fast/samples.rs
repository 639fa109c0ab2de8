//! Records for the tests: of every kind, and with numbers of every length.

use glam::DVec3;

use crate::geometry::{EdgeTest, QuadraticTest, Root, Roots};
use crate::scene::{Loaded, NoFiles, PrimitiveId, Scene, load_bytes};
use crate::trace::event::place::KindPlace;
use crate::trace::{Event, Kind, PixelColour, Record};

/// A sphere, a mesh and a light.
pub(in crate::trace::log) fn scene() -> Scene {
    let text = r#"{
      "camera": { "look_at": { "cop": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0],
                               "fov_degrees": 40 }, "pixels": [1, 1] },
      "lights": [ { "name": "lämp", "position": [0, 5, 5], "colour": [1, 1, 1] } ],
      "materials": { "red": { "colour": [1, 0, 0], "diffuse": 0.5 } },
      "objects": [
        { "name": "ball", "material": "red",
          "shape": { "sphere": { "center": [0, 0, 0], "radius": 1 } } },
        { "name": "roof", "material": "red", "shape": { "mesh": { "faces": [
          { "vertices": [[-1, 2, 1], [1, 2, 1], [1, 2, -1]] } ] } } } ]
    }"#;
    let loaded = load_bytes("scene.json", text.as_bytes(), &NoFiles);
    loaded.and_then(Loaded::build).unwrap()
}

/// A blank event of every kind, and some with numbers in them.
pub(in crate::trace::log) fn records() -> Vec<Record> {
    let root = |t| Root {
        t,
        ..Root::default()
    };
    let sphere = Event::SphereTest {
        object: PrimitiveId(0),
        test: QuadraticTest {
            a: 1.0,
            b: -0.125,
            c: 1e-9,
            discriminant: 0.1 + 0.2,
            roots: Roots::Two {
                near: root(-1.0 / 3.0),
                far: root(-0.0),
            },
        },
    };
    let edge = Event::Edge {
        object: PrimitiveId(1),
        edge: EdgeTest {
            index: 12,
            side: -1e-300,
            ..Default::default()
        },
    };
    let colour = Event::PixelColour(PixelColour {
        raw: DVec3::new(0.5, 10.0, 1e22),
        ..Default::default()
    });
    let mut records: Vec<Record> = Kind::ALL.map(placed).into();
    records.extend([sphere, edge, colour].map(|event| Record {
        pixel: Some([123, 4567]),
        step: 98765,
        ray: Some(3),
        event,
        ..Record::blank(Kind::Ray)
    }));
    records
}

/// A blank record in a pixel, unless it is of building or of a path of light.
fn placed(kind: Kind) -> Record {
    let (pixel, path) = match kind.place() {
        KindPlace::Building => (None, None),
        KindPlace::Path => (None, Some(0)),
        KindPlace::Pixel | KindPlace::Either => (Some([0, 0]), None),
    };
    Record {
        pixel,
        path,
        ..Record::blank(kind)
    }
}
