//! The camera: a centre of projection and a window on an arbitrary view plane, divided into pixels.
//!
//! Slides, "Ray Tracing/ Ray Casting" and Fig. 12-1: for each pixel an eye ray is fired from the COP
//! through the pixel's centre into the scene.

use glam::{DVec2, DVec3};

use crate::geometry::Ray;
use crate::scene::check::{checked_point, checked_positive};
use crate::scene::fault::{Fault, MOST_PIXELS, SceneFault};
use crate::scene::file::{CameraFile, LookAt, Window};

/// The eye and the window.
#[doc(alias = "pinhole camera")]
#[doc(alias = "eye point")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The centre of projection, in world coordinates.
    pub cop: DVec3,
    /// From the COP to the window's lower left corner. Kept relative, so that an eye far from the world's
    /// origin still sees as finely as one close to it.
    pub to_corner: DVec3,
    /// The window's lower edge, from the lower left corner to the lower right one.
    pub right: DVec3,
    /// The window's left edge, from the lower left corner to the upper left one.
    pub up: DVec3,
    /// Width and height in pixels.
    pub pixels: [u32; 2],
}

/// Where a line passes the window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WindowCrossing {
    /// Column and row of the pixel, from 0,0 at the top left.
    pub pixel: [u32; 2],
    /// The place in pixels from the window's top left corner.
    pub place: DVec2,
    /// The point, in world coordinates.
    pub point: DVec3,
    /// How far away it is.
    pub t: f64,
    /// cos θ between the line and the window's normal.
    pub cosine: f64,
}

impl Camera {
    /// The camera that a scene file describes.
    ///
    /// # Errors
    /// A window without area, a COP on its plane, a sight without direction, too many pixels or none.
    pub fn new(file: &CameraFile) -> Result<Self, SceneFault> {
        let [width, height] = file.pixels;
        let count = u64::from(width) * u64::from(height);
        if count == 0 || MOST_PIXELS < count {
            return Err(Fault::Pixels { width, height }.at("camera.pixels"));
        }
        match (&file.look_at, &file.window) {
            (Some(look_at), None) => Self::looking_at(look_at, file.pixels),
            (None, Some(window)) => Self::through_window(window, file.pixels),
            (look_at, _) => Err(Fault::OneOf {
                first: "look_at",
                second: "window",
                both: look_at.is_some(),
            }
            .at("camera")),
        }
    }

    /// A window at distance 1 across the line of sight, `fov_degrees` high and as wide as the pixels
    /// ask for.
    fn looking_at(file: &LookAt, pixels: [u32; 2]) -> Result<Self, SceneFault> {
        let cop = checked_point("camera.look_at.cop", file.cop)?;
        let target = checked_point("camera.look_at.target", file.target)?;
        let up = checked_point("camera.look_at.up", file.up)?;
        let degrees = file.fov_degrees;
        if !(0.0 < degrees && degrees < 180.0) {
            return Err(Fault::FieldOfView { degrees }.at("camera.look_at.fov_degrees"));
        }

        let sight = (target - cop).try_normalize();
        let sight = sight.ok_or_else(|| Fault::LooksNowhere.at("camera.look_at.target"))?;
        // beyond this the direction of "right" would be rounding
        const ALONG: f64 = 1e-9;
        let sideways = sight.cross(up.normalize_or_zero());
        if sideways.length() <= ALONG {
            return Err(Fault::UpAlongSight.at("camera.look_at.up"));
        }

        let half_height = libm::tan((0.5 * degrees).to_radians());
        checked_positive(
            "camera.look_at.fov_degrees",
            "the window's height",
            half_height,
        )?;
        let half_width = half_height * f64::from(pixels[0]) / f64::from(pixels[1]);
        let right = sideways.normalize();
        let above = right.cross(sight);
        Ok(Self {
            cop,
            to_corner: sight - half_width * right - half_height * above,
            right: 2.0 * half_width * right,
            up: 2.0 * half_height * above,
            pixels,
        })
    }

    fn through_window(file: &Window, pixels: [u32; 2]) -> Result<Self, SceneFault> {
        let cop = checked_point("camera.window.cop", file.cop)?;
        let camera = Self {
            cop,
            to_corner: checked_point("camera.window.corner", file.corner)? - cop,
            right: checked_point("camera.window.right", file.right)?,
            up: checked_point("camera.window.up", file.up)?,
            pixels,
        };
        // shares of the lengths involved, below which only rounding is left
        const FLAT: f64 = 1e-12;
        let normal = camera.right.cross(camera.up);
        let area = normal.length();
        if area <= FLAT * camera.right.length() * camera.up.length() {
            return Err(Fault::WindowWithoutArea.at("camera.window"));
        }
        let to_corner = camera.to_corner;
        let size = to_corner.length() + camera.right.length() + camera.up.length();
        if normal.dot(to_corner).abs() <= FLAT * area * size {
            return Err(Fault::CopOnWindow.at("camera.window.cop"));
        }
        Ok(camera)
    }

    /// The window's lower left corner.
    pub fn corner(&self) -> DVec3 {
        self.cop + self.to_corner
    }

    /// The point P on the window at a place counted in pixels from the top left corner: the centre of
    /// pixel (x, y) lies at (x + ½, y + ½).
    ///
    /// P = corner + (x/width)·right + (1 − y/height)·up
    pub fn window_point(&self, x: f64, y: f64) -> DVec3 {
        self.cop + self.to_window(x, y)
    }

    /// The eye ray through a place on the window, of unit length, and the t at which it passes the
    /// window (erratum 4).
    pub fn eye_ray(&self, x: f64, y: f64) -> (Ray, f64) {
        self.ray_through(self.to_window(x, y))
    }

    /// The ray from the COP through a point of the window, of unit length, and the t at which it passes that point.
    ///
    /// The point is given relative to the COP, as [`Camera::to_window`] returns it.
    pub fn ray_through(&self, to_window: DVec3) -> (Ray, f64) {
        let through = Ray::new(self.cop, to_window);
        // the window is off the COP by more than rounding, so that the direction has a length
        through.normalised().unwrap_or((through, 1.0))
    }

    /// Where a line passes the window: from a point beside the COP, in this direction.
    ///
    /// `beside` is the point less the COP, `direction` has unit length. `None` if the line runs away from the window
    /// or beside it. The lower and the right edge belong to no pixel.
    pub fn window_crossing(&self, beside: DVec3, direction: DVec3) -> Option<WindowCrossing> {
        // P = beside + t·direction = to_corner + α·right + β·up
        let across = self.right.cross(self.up);
        let t = across.dot(self.to_corner - beside) / across.dot(direction);
        if !(0.0 < t && t < f64::INFINITY) {
            return None;
        }
        let point = beside + t * direction - self.to_corner;
        let alpha = point.cross(self.up).dot(across) / across.length_squared();
        let beta = self.right.cross(point).dot(across) / across.length_squared();
        let [width, height] = self.pixels;
        let place = DVec2::new(alpha * f64::from(width), (1.0 - beta) * f64::from(height));
        let [x, y] = place.to_array();
        let inside = 0.0 <= x && x < f64::from(width) && 0.0 <= y && y < f64::from(height);
        inside.then(|| WindowCrossing {
            pixel: [x as u32, y as u32],
            place,
            point: self.cop + beside + t * direction,
            t,
            cosine: direction.dot(across).abs() / across.length(),
        })
    }

    /// The unit normal of the window's plane.
    pub fn window_normal(&self) -> DVec3 {
        self.right.cross(self.up).normalize()
    }

    /// How large a pixel is on the window, in square units.
    pub fn pixel_area(&self) -> f64 {
        let [width, height] = self.pixels.map(f64::from);
        self.right.cross(self.up).length() / (width * height)
    }

    /// P − COP: the same point, relative to the COP. So an eye far from the world's origin sees as finely as one close
    /// to it.
    pub fn to_window(self, x: f64, y: f64) -> DVec3 {
        let [width, height] = self.pixels.map(f64::from);
        self.to_corner + (x / width) * self.right + (1.0 - y / height) * self.up
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn look_at(pixels: [u32; 2]) -> CameraFile {
        CameraFile {
            look_at: Some(LookAt {
                cop: [0.0, 1.0, 6.0],
                target: [0.0, 1.0, 0.0],
                up: [0.0, 1.0, 0.0],
                fov_degrees: 90.0,
            }),
            window: None,
            pixels,
        }
    }

    #[track_caller]
    fn close(a: DVec3, b: [f64; 3]) {
        assert!((a - DVec3::from(b)).length() <= 1e-15, "{a} {b:?}");
    }

    #[test]
    fn ninety_degrees_make_a_window_of_height_two_at_distance_one() {
        let camera = Camera::new(&look_at([200, 100])).unwrap();
        close(camera.corner(), [-2.0, 0.0, 5.0]);
        close(camera.right, [4.0, 0.0, 0.0]);
        close(camera.up, [0.0, 2.0, 0.0]);
    }

    #[test]
    fn pixel_zero_is_top_left_and_its_centre_is_half_a_pixel_in() {
        let camera = Camera::new(&look_at([4, 2])).unwrap();
        close(camera.window_point(0.5, 0.5), [-1.5, 1.5, 5.0]);
        close(camera.window_point(3.5, 1.5), [1.5, 0.5, 5.0]);
        close(camera.window_point(0.0, 0.0), [-2.0, 2.0, 5.0]);
    }

    #[test]
    fn a_line_crosses_the_window_where_the_eye_ray_through_that_place_does() {
        let mut file = look_at([4, 2]);
        file.pixels = [40, 20];
        let camera = Camera::new(&file).unwrap();
        for [x, y] in [[0.5, 0.5], [39.75, 12.25], [7.0, 19.5]] {
            let (ray, window_t) = camera.eye_ray(x, y);
            let found = camera.window_crossing(DVec3::ZERO, ray.direction).unwrap();
            assert!(
                (found.place - DVec2::new(x, y)).length() <= 1e-12,
                "{found:?}"
            );
            assert!((found.t - window_t).abs() <= 1e-14, "{found:?}");
            assert!(
                camera
                    .window_crossing(DVec3::ZERO, -ray.direction)
                    .is_none()
            );
        }
        // the window is 4 wide and 2 high: a pixel is 0.1 by 0.1
        assert!((camera.pixel_area() - 0.01).abs() <= 1e-15);
        // from beside the COP straight ahead: as far beside the middle, 1.5 pixels to the right and half a one up
        let found = camera.window_crossing(DVec3::new(0.15, 0.05, 0.0), -DVec3::Z);
        assert_eq!(found.unwrap().pixel, [21, 9]);
        assert_eq!(found.unwrap().cosine, 1.0);
    }

    #[test]
    fn a_tilted_off_axis_window_is_taken_as_it_is() {
        let file = CameraFile {
            look_at: None,
            window: Some(Window {
                cop: [0.0; 3],
                corner: [1.0, 0.0, 2.0],
                right: [2.0, 0.0, 2.0],
                up: [0.0, 4.0, 1.0],
            }),
            pixels: [2, 2],
        };
        let camera = Camera::new(&file).unwrap();
        // corner + ¼·right + ¾·up
        close(camera.window_point(0.5, 0.5), [1.5, 3.0, 3.25]);
        // the lower left corner itself: (1, 0, 2), at distance √5
        let (ray, t) = camera.eye_ray(0.0, 2.0);
        assert_eq!(t, 5f64.sqrt());
        close(ray.direction, [1.0 / t, 0.0, 2.0 / t]);
    }

    #[test]
    fn an_eye_far_from_the_origin_sees_as_finely_as_one_close_to_it() {
        let mut file = look_at([4, 2]);
        let near = Camera::new(&file).unwrap();
        let sight = file.look_at.as_mut().unwrap();
        sight.cop[0] = 1e16;
        sight.target[0] = 1e16;
        let far = Camera::new(&file).unwrap();
        assert_eq!(
            far.eye_ray(0.5, 0.5).0.direction,
            near.eye_ray(0.5, 0.5).0.direction
        );
    }

    #[track_caller]
    fn refused(file: &CameraFile, path: &str, fault: Fault) {
        assert_eq!(Camera::new(file), Err(fault.at(path)));
    }

    #[test]
    fn cameras_that_see_nothing_are_refused() {
        let mut file = look_at([0, 10]);
        refused(
            &file,
            "camera.pixels",
            Fault::Pixels {
                width: 0,
                height: 10,
            },
        );
        file.pixels = [1_000_000, 1_000_000];
        let too_many = Fault::Pixels {
            width: 1_000_000,
            height: 1_000_000,
        };
        refused(&file, "camera.pixels", too_many);

        let mut file = look_at([1, 1]);
        file.look_at.as_mut().unwrap().target = [0.0, 1.0, 6.0];
        refused(&file, "camera.look_at.target", Fault::LooksNowhere);
        file.look_at.as_mut().unwrap().target = [0.0, 9.0, 6.0];
        refused(&file, "camera.look_at.up", Fault::UpAlongSight);

        let window = |cop, right| CameraFile {
            look_at: None,
            window: Some(Window {
                cop,
                corner: [0.0, 0.0, 1.0],
                right,
                up: [0.0, 1.0, 0.0],
            }),
            pixels: [1, 1],
        };
        let flat = window([0.0; 3], [0.0, 2.0, 0.0]);
        refused(&flat, "camera.window", Fault::WindowWithoutArea);
        let through_eye = window([5.0, 5.0, 1.0], [1.0, 0.0, 0.0]);
        refused(&through_eye, "camera.window.cop", Fault::CopOnWindow);
    }
}
