//! The vertices of a path: the light, the surfaces that it hits, the eye.

use glam::DVec3;

use crate::explain::worked::context::Context;
use crate::trace::{Event, Item, Photon, Purpose, RayNode};

/// A vertex of a path.
#[derive(Clone, Debug)]
pub(super) struct Vertex {
    /// What it is called.
    pub(super) name: String,
    /// What it is.
    pub(super) place: VertexPlace,
}

/// What a vertex is.
#[derive(Clone, Copy, Debug)]
pub(super) enum VertexPlace {
    /// The light, and the power in W that it gives to the path.
    Light(DVec3),
    /// A surface, and the photon that hit it.
    Surface(Photon),
    /// The eye.
    Eye,
    /// A surface that a filtered log does not have.
    Unknown,
}

impl Vertex {
    /// The photon at a surface.
    pub(super) fn photon(&self) -> Option<&Photon> {
        match &self.place {
            VertexPlace::Surface(photon) => Some(photon),
            _ => None,
        }
    }

    /// What it is called beside its point: ` on floor`, `, the eye`.
    pub(super) fn beside(&self) -> String {
        match self.place {
            VertexPlace::Light(_) | VertexPlace::Eye => format!(", {}", self.name),
            VertexPlace::Surface(_) | VertexPlace::Unknown => format!(" on {}", self.name),
        }
    }
}

/// A vertex of a path of light: 0 is the light, then its surfaces.
pub(super) fn light_vertex(context: &Context, path: u32, number: usize) -> Vertex {
    let known = context.paths.get(&path);
    match number.checked_sub(1) {
        Some(before) => surface_vertex(context, known.and_then(|known| known.met.get(before))),
        None => match known.and_then(|known| known.start) {
            Some(start) => Vertex {
                name: context.light_title(start.light),
                place: VertexPlace::Light(start.power),
            },
            None => Vertex {
                name: "a light".into(),
                place: VertexPlace::Unknown,
            },
        },
    }
}

/// A vertex of a path from the eye, which has hit these surfaces: 0 is the eye.
pub(super) fn eye_vertex(context: &Context, met: &[Photon], number: usize) -> Vertex {
    match number.checked_sub(1) {
        Some(before) => surface_vertex(context, met.get(before)),
        None => Vertex {
            name: "the eye".into(),
            place: VertexPlace::Eye,
        },
    }
}

fn surface_vertex(context: &Context, photon: Option<&Photon>) -> Vertex {
    match photon {
        Some(photon) => Vertex {
            name: context.name(photon.object),
            place: VertexPlace::Surface(*photon),
        },
        None => Vertex {
            name: "a surface".into(),
            place: VertexPlace::Unknown,
        },
    }
}

/// The unit normal of the surface that was hit, on the side of a direction.
pub(super) fn normal_towards(context: &Context, photon: &Photon, direction: DVec3) -> DVec3 {
    let shape = &context.scene.primitive(photon.object).shape;
    let normal = shape.normals(photon.point).geometric;
    if normal.dot(direction) < 0.0 {
        -normal
    } else {
        normal
    }
}

/// The photon at the end of a ray, if Russian roulette decided there how the path continues.
pub(super) fn photon_of(context: &Context, ray: &RayNode) -> Option<Photon> {
    ray.items.iter().find_map(|item| match *item {
        Item::Event(at) => match context.records[at].event {
            Event::Photon(photon) => Some(photon),
            _ => None,
        },
        Item::Ray(_) => None,
    })
}

/// The ray of a path before this one, and the photon at the surface between the two.
pub(super) fn leg_before<'c>(context: &'c Context, place: usize) -> Option<(&'c RayNode, Photon)> {
    let ray = &context.tree.rays[place];
    let start = ray.start?;
    // the rays of a path are siblings; others are children of the ray that spawned them
    if ray.parent.is_some() || start.depth <= 1 || start.purpose == Purpose::Connection {
        return None;
    }
    let before = &context.tree.rays[place.checked_sub(1)?];
    Some((before, photon_of(context, before)?))
}
