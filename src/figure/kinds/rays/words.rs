//! Rays in words.

use crate::figure::parts::scenery;
use crate::figure::subject::Figure;
use crate::trace::{Event, Purpose, RayNode, RayStart, RayVerdict, Record};

/// What a ray is called.
pub(super) fn name(node: &RayNode) -> &'static str {
    node.start.map_or("ray", |start| of_purpose(start.purpose))
}

/// What a ray is called beside its line.
pub(super) fn of_purpose(purpose: Purpose) -> &'static str {
    match purpose {
        Purpose::Eye => "eye ray",
        Purpose::Shadow => "shadow ray",
        Purpose::Reflected => "reflected ray",
        Purpose::Refracted => "refracted ray",
        Purpose::Scattered => "scattered ray",
        Purpose::Light => "path of light",
        Purpose::Connection => "connecting line",
    }
}

/// The light of a ray, with its name.
fn to_light(figure: &Figure, start: &RayStart) -> String {
    let light = start.light.map(|light| light as usize);
    let lamp = light.and_then(|light| figure.scene.lights.get(light));
    lamp.map_or(String::new(), |light| {
        format!(" \"{}\"", scenery::short(&light.name))
    })
}

/// That a ray leaves.
pub(super) fn of_start(figure: &Figure, node: &RayNode, records: &[Record]) -> String {
    let Some(start) = node.start else {
        return String::new();
    };
    let pixel = records.iter().find_map(|record| match record.event {
        Event::Pixel(_) => record.pixel,
        _ => None,
    });
    match (start.purpose, pixel) {
        (Purpose::Eye, Some([x, y])) => {
            format!("An eye ray leaves the COP through pixel ({x}, {y}) of the window.")
        }
        (Purpose::Eye, None) => "An eye ray leaves the COP.".into(),
        (Purpose::Shadow, _) => format!(
            "From the hit a shadow ray goes to the light{}.",
            to_light(figure, &start)
        ),
        (Purpose::Light, _) => {
            format!(
                "A path of light leaves the light{}.",
                to_light(figure, &start)
            )
        }
        (Purpose::Connection, _) => "A line joins two vertices.".into(),
        (purpose, _) => format!("From the hit a {} goes on.", of_purpose(purpose)),
    }
}

/// Where a ray ends.
pub(super) fn of_end(figure: &Figure, node: &RayNode) -> Option<String> {
    let (start, end) = (node.start?, node.end?);
    let object = end.object.map(|id| scenery::name_of(figure.scene, id));
    let object = object.unwrap_or_default();
    let light = to_light(figure, &start);
    let what = match start.purpose {
        Purpose::Shadow => format!("The shadow ray to light{light}"),
        Purpose::Light => format!("The path from light{light}"),
        purpose => format!("The {}", of_purpose(purpose)),
    };
    Some(match end.verdict {
        RayVerdict::Hit => format!("{what} hits {object}."),
        RayVerdict::Miss => format!("{what} misses all objects."),
        RayVerdict::Blocked => format!("{what} is blocked by {object}: the point is in shadow."),
        RayVerdict::ReachesLight => format!("{what} reaches the light: the point is lit."),
        RayVerdict::DepthLimit => format!("{what} is not traced: the depth limit is reached."),
        RayVerdict::Absorbed => format!("{what} is absorbed by {object}."),
        RayVerdict::CutOff => format!("{what} is cut off at {object}."),
        RayVerdict::Connects => format!("{what} hits no object."),
    })
}
