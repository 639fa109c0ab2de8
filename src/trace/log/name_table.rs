//! The numbers that belong to the names of a scene.

use std::collections::HashMap;

use smol_str::SmolStr;

use crate::scene::{PrimitiveId, Scene};

/// The objects and lights of a scene by their names.
#[derive(Debug)]
pub(super) struct NameTable {
    pub(super) objects: HashMap<SmolStr, NamedObject>,
    pub(super) lights: HashMap<String, u32>,
}

/// An object's place in the scene, and its primitives.
#[derive(Clone, Copy, Debug)]
pub(super) struct NamedObject {
    pub(super) place: u32,
    first: u32,
    count: u32,
    is_mesh: bool,
}

impl NameTable {
    /// The names of this scene.
    pub(super) fn new(scene: &Scene) -> Self {
        let objects = (0..).zip(&scene.objects).map(|(place, object)| {
            let named = NamedObject {
                place,
                first: object.first.0,
                count: object.count,
                is_mesh: object.is_mesh,
            };
            (object.name.clone(), named)
        });
        let lights = scene.lights.iter().zip(0..);
        Self {
            objects: objects.collect(),
            lights: lights
                .map(|(light, number)| (light.name.clone(), number))
                .collect(),
        }
    }
}

impl NamedObject {
    /// The primitive: a mesh has one for each face, and what is no mesh has no faces.
    #[inline]
    pub(super) fn primitive(self, face: Option<u32>) -> Option<PrimitiveId> {
        match face {
            Some(face) if self.is_mesh && face < self.count => Some(PrimitiveId(self.first + face)),
            None if !self.is_mesh => Some(PrimitiveId(self.first)),
            _ => None,
        }
    }
}
