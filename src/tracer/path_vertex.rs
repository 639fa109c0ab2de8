//! The vertices of a path, kept for lines to be drawn between them.

use std::f64::consts::PI;

use glam::DVec3;

use crate::trace::{PhotonFate, Recorder};
use crate::tracer::surface::Surface;
use crate::tracer::walk::Watcher;

/// A vertex of a path: the light, the eye, or a surface that was met.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vertex {
    pub(super) point: DVec3,
    /// On the side that the path comes from; zero for the light and the eye, which have none.
    pub(super) normal: DVec3,
    /// What arrives: watts, or the weight of a path from the eye.
    pub(super) carries: DVec3,
    /// colour·diffuse; for the light and the eye unused.
    pub(super) albedo: DVec3,
    /// ε for rays that start or end here.
    pub(super) epsilon: f64,
    /// The path goes on from here in the one direction of a mirror or of glass.
    pub(super) is_specular: bool,
}

impl Vertex {
    /// The light, or the eye.
    pub(super) fn end(point: DVec3, carries: DVec3) -> Self {
        Self {
            point,
            normal: DVec3::ZERO,
            carries,
            albedo: DVec3::ONE,
            epsilon: 0.0,
            is_specular: false,
        }
    }

    /// cos θ between the normal and a unit direction away from the surface; 1 where there is no normal.
    pub(super) fn cosine(&self, direction: DVec3) -> f64 {
        if self.normal == DVec3::ZERO {
            1.0
        } else {
            self.normal.dot(direction)
        }
    }

    /// φ of a surface: the chance that a path goes on diffusely, per steradian and cosine.
    pub(super) fn density(&self) -> f64 {
        self.albedo.max_element() / PI
    }

    /// Can a line end here?
    pub(super) fn can_connect(&self) -> bool {
        self.albedo != DVec3::ZERO
    }
}

/// The vertices of the path that is followed.
#[derive(Debug, Default)]
pub(super) struct Vertices(pub(super) Vec<Vertex>);

impl Watcher for Vertices {
    fn met<R: Recorder>(&mut self, surface: &Surface<'_>, _: u32, power: DVec3, _: &mut R) {
        self.0.push(Vertex {
            point: surface.point,
            normal: surface.across,
            carries: power,
            albedo: surface.albedo(),
            epsilon: surface.epsilon,
            is_specular: false,
        });
    }

    fn goes_on(&mut self, fate: PhotonFate) {
        if let Some(last) = self.0.last_mut() {
            last.is_specular = matches!(fate, PhotonFate::Mirrored | PhotonFate::Refracted);
        }
    }
}
