//! Lesson 1: the pinhole camera.
//!
//! - window point: the point P of the window at which the pixel's ray passes it
//! - direction: the unit vector Δ of the ray from the centre of projection (COP) through P

use glam::DVec3;
use raystep::geometry::Ray;
use raystep::scene::Camera;

/// The point P of the window at a place counted in pixels from the top left corner, relative to the COP: P − COP.
///
/// The window begins in its lower left corner: `camera.to_corner` is that corner less the COP. `camera.right` is its lower
/// edge and `camera.up` its left edge. `camera.pixels` is [width, height]. The centre of pixel (2, 1) is at x = 2.5, y = 1.5:
/// the caller has added the ½.
pub fn window_point(camera: &Camera, x: f64, y: f64) -> DVec3 {
    // BEGIN SOLUTION
    let [width, height] = camera.pixels.map(f64::from);
    camera.to_corner + (x / width) * camera.right + (1.0 - y / height) * camera.up
    // END SOLUTION
}

/// The ray from the COP (`camera.cop`) through a point of the window, of unit length. `to_window` is P − COP.
///
/// `Ray::new(origin, direction)` makes a ray; `v.length()` is the length of a vector.
pub fn eye_ray(camera: &Camera, to_window: DVec3) -> Ray {
    // BEGIN SOLUTION
    Ray::new(camera.cop, to_window / to_window.length())
    // END SOLUTION
}
