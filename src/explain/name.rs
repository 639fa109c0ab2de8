//! What things are called in the text: objects, lights, rays.

use crate::explain::printable;
use crate::scene::{PrimitiveId, Scene};
use crate::trace::{Purpose, RayStart};

/// A primitive: the name of its object, and in a mesh the number of the face.
pub(crate) fn primitive_name(scene: &Scene, id: PrimitiveId) -> String {
    match scene.name_of(id) {
        (name, None) => printable(name),
        (name, Some(face)) => format!("{} face {face}", printable(name)),
    }
}

/// A light: `light "lamp"`.
pub(crate) fn light_title(scene: &Scene, light: u32) -> String {
    let light = scene.lights.get(light as usize);
    light.map_or("a light".into(), |light| {
        format!("light \"{}\"", printable(&light.name))
    })
}

/// A ray by its number, its purpose and the ray that spawned it; by its number alone, if its start was left out of the log.
pub(crate) fn ray_title(
    scene: &Scene,
    id: u32,
    parent: Option<u32>,
    start: Option<&RayStart>,
) -> String {
    let Some(start) = start else {
        return format!("Ray {id}");
    };
    let what = match start.purpose {
        Purpose::Eye => "eye ray".into(),
        Purpose::Shadow => match start.light {
            Some(light) => format!("shadow ray to {}", light_title(scene, light)),
            None => "shadow ray".into(),
        },
        Purpose::Reflected => "reflected ray".into(),
        Purpose::Refracted => "refracted ray".into(),
        Purpose::Scattered => "scattered ray".into(),
        Purpose::Light => match start.light {
            Some(light) => format!("light ray from {}", light_title(scene, light)),
            None => "light ray, the path continues".into(),
        },
        Purpose::Connection => "connecting ray from x′ to x".into(),
    };
    let of = parent.map_or(String::new(), |parent| format!(", spawned by ray {parent}"));
    format!("Ray {id}: {what}{of}, depth {}", start.depth)
}
