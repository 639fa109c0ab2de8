//! The vertices of a path, kept for lines to be drawn between them.

use std::f64::consts::PI;

use glam::DVec3;

use crate::trace::{PhotonVerdict, Recorder};
use crate::tracer::light::walk::Watcher;
use crate::tracer::surface::Surface;

/// A vertex of a path: the light, the eye, or a surface that was hit.
#[derive(Clone, Copy, Debug)]
pub(in crate::tracer) struct Vertex {
    pub(in crate::tracer) point: DVec3,
    /// On the side that the path comes from; zero for the light and the eye, which have none.
    pub(in crate::tracer) normal: DVec3,
    /// What arrives: watts, or the weight of a path from the eye.
    pub(in crate::tracer) carries: DVec3,
    /// colour·diffuse; for the light and the eye unused.
    pub(in crate::tracer) albedo: DVec3,
    /// ε for rays that start or end here.
    pub(in crate::tracer) epsilon: f64,
    /// The path goes on from here in the one direction of a mirror or of glass.
    pub(in crate::tracer) is_specular: bool,
}

impl Vertex {
    /// The light, or the eye.
    pub(in crate::tracer) fn end(point: DVec3, carries: DVec3) -> Self {
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
    pub(in crate::tracer) fn cosine(&self, direction: DVec3) -> f64 {
        if self.normal == DVec3::ZERO {
            1.0
        } else {
            self.normal.dot(direction)
        }
    }

    /// φ of a surface: the chance that a path goes on diffusely, per steradian and cosine.
    pub(in crate::tracer) fn density(&self) -> f64 {
        self.albedo.max_element() / PI
    }

    /// Can a line end here?
    pub(in crate::tracer) fn can_connect(&self) -> bool {
        self.albedo != DVec3::ZERO
    }
}

/// The vertices of the path that is followed.
#[derive(Debug, Default)]
pub(in crate::tracer) struct Vertices(pub(in crate::tracer) Vec<Vertex>);

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

    fn goes_on(&mut self, verdict: PhotonVerdict) {
        if let Some(last) = self.0.last_mut() {
            last.is_specular =
                matches!(verdict, PhotonVerdict::Mirrored | PhotonVerdict::Refracted);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_end_has_no_normal_and_can_be_connected_from_any_side() {
        let end = Vertex::end(DVec3::X, DVec3::ONE);
        assert_eq!(end.cosine(DVec3::new(0.6, 0.0, 0.8)), 1.0);
        assert!(end.can_connect() && !end.is_specular);
        assert_eq!(end.epsilon, 0.0);
    }

    #[test]
    fn a_surface_has_the_cosine_of_its_normal_and_the_density_of_its_brightest_channel() {
        let surface = Vertex {
            normal: DVec3::Y,
            albedo: DVec3::new(0.25, 0.5, 0.0),
            ..Vertex::end(DVec3::X, DVec3::ONE)
        };
        assert_eq!(surface.cosine(DVec3::new(0.6, 0.8, 0.0)), 0.8);
        assert_eq!(surface.density(), 0.5 / PI);
        assert!(surface.can_connect());
        let black = Vertex {
            albedo: DVec3::ZERO,
            ..surface
        };
        assert!(!black.can_connect());
    }

    #[test]
    fn a_vertex_is_specular_if_the_path_goes_on_by_a_mirror_or_through_glass() {
        let mut vertices = Vertices(vec![Vertex::end(DVec3::X, DVec3::ONE)]);
        for (verdict, is_specular) in [
            (PhotonVerdict::Mirrored, true),
            (PhotonVerdict::Diffused, false),
            (PhotonVerdict::Refracted, true),
            (PhotonVerdict::Absorbed, false),
        ] {
            vertices.goes_on(verdict);
            assert_eq!(vertices.0[0].is_specular, is_specular, "{verdict:?}");
        }
    }
}
