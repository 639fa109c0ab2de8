//! The names of a scene, as a line has them.

use crate::scene::{PrimitiveId, Scene};

/// The names of a scene as JSON strings, made once.
#[derive(Clone, Debug)]
pub struct LogNames {
    /// For each primitive its object, and for a face of a mesh its number.
    pub(super) primitives: Vec<(u32, Option<u32>)>,
    pub(super) objects: Vec<String>,
    pub(super) lights: Vec<String>,
}

impl LogNames {
    /// The names of this scene.
    pub fn new(scene: &Scene) -> Self {
        let quoted = |name: &str| serde_json::Value::from(name).to_string();
        let ids = (0..scene.primitives.len() as u32).map(PrimitiveId);
        Self {
            primitives: ids
                .map(|id| (scene.primitive(id).object, scene.name_of(id).1))
                .collect(),
            objects: scene.objects.iter().map(|o| quoted(&o.name)).collect(),
            lights: scene.lights.iter().map(|l| quoted(&l.name)).collect(),
        }
    }
}
