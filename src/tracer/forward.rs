//! Forward ray tracing: photons leave the lights, and those that pass the window into the eye make the picture.
//!
//! The eye is a disc around the COP, parallel to the window: a pinhole, of aperture 0, is never met. A photon on
//! its way into the disc is seen where its line passes the window, which is where the picture is sharp. What a
//! pixel gets is the mean radiance over the disc and over the pixel's area:
//!
//! L = Σ power / (G · π·r² · area of the pixel),  G = cos²θ / d²
//!
//! with d and θ between the points at which the photon passes the two parallel planes.

use std::f64::consts::PI;

use glam::DVec3;

use crate::scene::Camera;
use crate::trace::{Arrival, Event, LightOptions, Recorder};
use crate::tracer::walk::{Leg, Watcher};

/// The eye, which sees photons pass.
pub(super) struct Eye<'a> {
    camera: &'a Camera,
    radius: f64,
    normal: DVec3,
    /// What it has seen of the path that is followed.
    pub(super) arrivals: Vec<Arrival>,
}

impl<'a> Eye<'a> {
    pub(super) fn new(camera: &'a Camera, options: &LightOptions) -> Self {
        Self {
            camera,
            radius: options.aperture_radius(camera),
            normal: camera.window_normal(),
            arrivals: Vec::new(),
        }
    }

    /// The photon on this leg, if it passes the window into the eye.
    fn arrival(&self, leg: &Leg) -> Option<Arrival> {
        // where it meets the plane of the disc: before anything else
        let direction = leg.ray.direction;
        let to_plane = self.normal.dot(self.camera.cop - leg.ray.origin);
        let t = to_plane / self.normal.dot(direction);
        if !(0.0 < t && t < leg.end) {
            return None;
        }
        let beside = leg.ray.at(t) - self.camera.cop;
        if self.radius * self.radius < beside.length_squared() {
            return None;
        }
        // back along its line
        let crossing = self.camera.window_crossing(beside, -direction)?;
        let geometry = crossing.cosine * crossing.cosine / (crossing.t * crossing.t);
        let areas = PI * self.radius * self.radius * self.camera.pixel_area();
        Some(Arrival {
            pixel: crossing.pixel,
            window: crossing.point,
            aperture: self.camera.cop + beside,
            power: leg.power,
            geometry,
            radiance: leg.power / (geometry * areas),
        })
    }
}

impl Watcher for Eye<'_> {
    fn leg<R: Recorder>(&mut self, leg: &Leg, recorder: &mut R) {
        // no transport shows the lamp itself, nor its mirror image: a point has no area
        let arrival = if leg.is_scattered {
            self.arrival(leg)
        } else {
            None
        };
        if let Some(arrival) = arrival {
            recorder.note(|| Event::Arrival(arrival));
            self.arrivals.push(arrival);
        }
    }
}
