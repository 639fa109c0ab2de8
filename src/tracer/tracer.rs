//! What traces rays: the scene, the strategy, the kind of ray tracing, and what the paths of light have left.
//!
//! Each kind of ray tracing adds its own methods, in a file of its own.

use crate::scene::Scene;
use crate::strategy::{Hit, Strategy};
use crate::trace::{RayStart, Transport};
use crate::tracer::light::light_pass::LightPass;
use crate::tracer::ray_limit::MAX_RAYS;
use crate::tracer::surface::Surface;

/// Traces rays through a scene.
#[derive(Clone, Copy, Debug)]
pub struct Tracer<'a, S> {
    /// The scene: camera, lights, materials and objects.
    pub scene: &'a Scene,
    /// Which objects a ray is tested against.
    pub strategy: &'a S,
    /// Which rays are cast.
    pub transport: Transport,
    /// What the paths of light have left, where the transport follows any.
    pub light: Option<&'a LightPass>,
    /// How many rays may be traced for a pixel; through the corners, from each of them.
    pub max_rays: u64,
}

impl<'a, S: Strategy> Tracer<'a, S> {
    /// A tracer that follows no light from the lamps.
    pub fn new(scene: &'a Scene, strategy: &'a S, transport: Transport) -> Self {
        Self {
            scene,
            strategy,
            transport,
            light: None,
            max_rays: MAX_RAYS,
        }
    }

    /// The same, over what paths of light have left.
    #[must_use]
    pub fn with_light(self, light: Option<&'a LightPass>) -> Self {
        Self { light, ..self }
    }

    /// The same, with another limit of the rays that may be traced for a pixel.
    #[must_use]
    pub fn with_max_rays(self, max_rays: u64) -> Self {
        Self { max_rays, ..self }
    }

    /// The surface that a ray has hit.
    pub(in crate::tracer) fn surface(&self, start: &RayStart, hit: Hit) -> Surface<'_> {
        let point = start.ray.at(hit.t);
        let normals = self.scene.primitive(hit.object).shape.normals(point);
        Surface::new(self.scene, &start.ray, start.depth, hit, normals)
    }
}
