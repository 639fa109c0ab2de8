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
use crate::tracer::light::walk::{Leg, Watcher};

/// The eye, which sees photons pass.
pub(in crate::tracer) struct Eye<'a> {
    camera: &'a Camera,
    radius: f64,
    normal: DVec3,
    /// What it has seen of the path that is followed.
    pub(in crate::tracer) arrivals: Vec<Arrival>,
}

impl<'a> Eye<'a> {
    pub(in crate::tracer) fn new(camera: &'a Camera, options: &LightOptions) -> Self {
        Self {
            camera,
            radius: options.aperture_radius(camera),
            normal: camera.window_normal(),
            arrivals: Vec::new(),
        }
    }

    /// The photon on this leg, if it passes the window into the eye.
    fn arrival(&self, leg: &Leg) -> Option<Arrival> {
        // where it hits the plane of the disc: before anything else
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Ray;
    use crate::scene::small_scene::one_pixel;
    use crate::trace::Off;

    /// A photon of 2 watts from a point along a direction, that hits something at `end`.
    fn leg(origin: [f64; 3], direction: [f64; 3], end: f64) -> Leg {
        Leg {
            ray: Ray::new(origin.into(), direction.into()),
            end,
            power: DVec3::splat(2.0),
            is_scattered: true,
        }
    }

    /// What an eye with an aperture of radius ½ in the origin sees of it; its window lies 1 ahead along −z and is 2 × 2 large.
    fn seen(leg: &Leg) -> Option<Arrival> {
        let camera = one_pixel(r#""objects":[]"#).camera;
        let options = LightOptions {
            aperture: Some(0.5),
            ..LightOptions::default()
        };
        let mut eye = Eye::new(&camera, &options);
        eye.leg(leg, &mut Off);
        eye.arrivals.first().copied()
    }

    #[test]
    fn a_photon_straight_into_the_eye_brings_its_power_over_both_areas() {
        let found = seen(&leg([0.0, 0.0, -5.0], [0.0, 0.0, 1.0], f64::INFINITY)).unwrap();
        assert_eq!((found.pixel, found.geometry), ([0, 0], 1.0));
        assert_eq!((found.window, found.aperture), (DVec3::NEG_Z, DVec3::ZERO));
        // 2 watts over G = 1, π/4 of the disc and 4 of the pixel
        assert!((found.radiance - 2.0 / PI).abs().max_element() <= 1e-15);
    }

    #[test]
    fn a_slanted_photon_beside_the_middle_is_seen_where_its_line_passes_the_window() {
        // through (0.2, 0, 0): at t = 5 in the disc, and 1.25 before it at the window; G = 0.8²/1.25²
        let found = seen(&leg([3.2, 0.0, -4.0], [-0.6, 0.0, 0.8], f64::INFINITY)).unwrap();
        assert!((found.aperture - DVec3::new(0.2, 0.0, 0.0)).length() <= 1e-15);
        assert!((found.window - DVec3::new(0.95, 0.0, -1.0)).length() <= 1e-15);
        let geometry = 0.4096;
        assert!((found.geometry - geometry).abs() <= 1e-14);
        assert!((found.radiance.x - 2.0 / (geometry * PI)).abs() <= 1e-14);
        assert_eq!(found.power, DVec3::splat(2.0));
    }

    #[test]
    fn what_passes_the_disc_the_window_or_comes_from_elsewhere_is_not_seen() {
        let straight =
            |x: f64, end: f64| seen(&leg([x, 0.0, -5.0], [0.0, 0.0, 1.0], end)).is_some();
        // the disc's rim belongs to it
        assert!(straight(0.5, f64::INFINITY) && !straight(0.51, f64::INFINITY));
        // it must come as far as the disc: something may stand behind it
        assert!(straight(0.0, 5.1) && !straight(0.0, 5.0) && !straight(0.0, 4.0));
        // away from the eye, and along its plane
        assert!(seen(&leg([0.0, 0.0, -5.0], [0.0, 0.0, -1.0], f64::INFINITY)).is_none());
        assert!(seen(&leg([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0], f64::INFINITY)).is_none());
        // from behind the eye, and too slanted for the window
        assert!(seen(&leg([0.0, 0.0, 5.0], [0.0, 0.0, -1.0], f64::INFINITY)).is_none());
        assert!(seen(&leg([8.0, 0.0, -6.0], [-0.8, 0.0, 0.6], f64::INFINITY)).is_none());
        // straight from the lamp
        let mut from_lamp = leg([0.0, 0.0, -5.0], [0.0, 0.0, 1.0], f64::INFINITY);
        from_lamp.is_scattered = false;
        assert!(seen(&from_lamp).is_none());
    }

    #[test]
    fn the_usual_aperture_is_a_twentieth_of_the_way_to_the_window() {
        let camera = one_pixel(r#""objects":[]"#).camera;
        let eye = Eye::new(&camera, &LightOptions::default());
        assert_eq!(eye.radius, 0.05);
        assert_eq!(eye.normal.abs(), DVec3::Z);
    }

    #[test]
    fn light_that_starts_in_the_disc_itself_has_not_passed_it() {
        assert!(seen(&leg([0.1, 0.0, 0.0], [0.0, 0.0, 1.0], f64::INFINITY)).is_none());
    }

    #[test]
    fn an_eye_away_from_the_origin_sees_the_same() {
        let mut camera = one_pixel(r#""objects":[]"#).camera;
        camera.cop = DVec3::new(1.0, 2.0, 3.0);
        let options = LightOptions {
            aperture: Some(0.5),
            ..LightOptions::default()
        };
        let eye = Eye::new(&camera, &options);
        let straight =
            |x: f64| eye.arrival(&leg([1.0 + x, 2.0, -2.0], [0.0, 0.0, 1.0], f64::INFINITY));
        let found = straight(0.25).unwrap();
        assert_eq!(found.window, DVec3::new(1.25, 2.0, 2.0));
        assert_eq!(found.aperture, DVec3::new(1.25, 2.0, 3.0));
        assert!((found.radiance - 2.0 / PI).abs().max_element() <= 1e-15);
        assert!(straight(0.6).is_none());
    }
}
