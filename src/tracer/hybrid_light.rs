//! Hybrid ray tracing with rays to the light: backward, and from each point a ray to each light, as T. Whitted
//! (1980) does. What it meets on the way throws a shadow.

use std::ops::ControlFlow;

use glam::DVec3;

use crate::geometry::{Ray, TRange};
use crate::scene::Light;
use crate::strategy::Strategy;
use crate::trace::{Event, LightTerm, Outcome, Purpose, RayStart, Recorder, Transport, Visibility};
use crate::tracer::Tracer;
use crate::tracer::epsilon::EPSILON;
use crate::tracer::surface::Surface;

impl<S: Strategy> Tracer<'_, S> {
    /// Σ over the lights that reach a point.
    pub(super) fn direct_light<R: Recorder>(
        &self,
        surface: &Surface<'_>,
        recorder: &mut R,
    ) -> ControlFlow<(), DVec3> {
        let mut direct = DVec3::ZERO;
        for (number, light) in (0..).zip(&self.scene.lights) {
            direct += self.light(number, light, surface, recorder)?;
        }
        ControlFlow::Continue(direct)
    }

    /// What one light adds; with a shadow ray, unless the surface faces away from the light.
    fn light<R: Recorder>(
        &self,
        number: u32,
        light: &Light,
        surface: &Surface<'_>,
        recorder: &mut R,
    ) -> ControlFlow<(), DVec3> {
        let to_viewer = -surface.incoming;
        let term = light.phong(surface.material, surface.point, surface.normal, to_viewer);
        let visibility = if term.n_dot_l <= 0.0 {
            Visibility::FacesAway
        } else if self.transport == Transport::Backward {
            Visibility::NotTested
        } else if self.is_blocked(number, surface, term.to_light, term.distance, recorder)? {
            Visibility::Shadowed
        } else {
            Visibility::Visible
        };
        recorder.note(|| {
            Event::LightTerm(LightTerm {
                light: number,
                visibility,
                term,
            })
        });
        ControlFlow::Continue(match visibility {
            Visibility::Visible | Visibility::NotTested => term.diffuse + term.specular,
            Visibility::Shadowed | Visibility::FacesAway => DVec3::ZERO,
        })
    }

    /// Does anything stand between the point and the light? Every object casts a full shadow.
    fn is_blocked<R: Recorder>(
        &self,
        light: u32,
        surface: &Surface<'_>,
        to_light: DVec3,
        distance: f64,
        recorder: &mut R,
    ) -> ControlFlow<(), bool> {
        let start = RayStart {
            ray: Ray::new(surface.point, to_light),
            range: TRange {
                min: surface.epsilon,
                // a light in a surface is not blocked by that surface
                max: distance * (1.0 - EPSILON),
            },
            purpose: Purpose::Shadow,
            depth: surface.depth + 1,
            window_t: None,
            light: Some(light),
        };
        let is_clear = self.is_clear(start, Outcome::ReachesLight, recorder)?;
        ControlFlow::Continue(!is_clear)
    }
}
