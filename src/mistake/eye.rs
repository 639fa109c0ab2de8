//! The eye ray: which point of the window belongs to a pixel.

use glam::DVec3;

use crate::mistake::{Mistake, Wrong};
use crate::scene::Camera;

pub(super) const MISTAKES: &[Mistake] = &[
    Mistake {
        name: "row from below",
        sentence: "Rows are counted from the lower edge of the window, so the picture is upside down.",
        spoils: "point of the window",
        wrong: Wrong::WindowPoint(row_from_below),
    },
    Mistake {
        name: "u and v swapped",
        sentence: "The column is counted along the window's height and the row along its width.",
        spoils: "point of the window",
        wrong: Wrong::WindowPoint(u_and_v_swapped),
    },
    Mistake {
        name: "w turned",
        sentence: "The window lies behind the eye, so the picture shows what is behind.",
        spoils: "point of the window",
        wrong: Wrong::WindowPoint(w_turned),
    },
    Mistake {
        name: "no ½",
        sentence: "The ray passes through the corner of the pixel and not through its centre.",
        spoils: "point of the window",
        wrong: Wrong::WindowPoint(no_half),
    },
    Mistake {
        name: "n − 1",
        sentence: "The number of the pixel is divided by n − 1 and not by n, so the picture is stretched.",
        spoils: "point of the window",
        wrong: Wrong::WindowPoint(n_minus_1),
    },
    Mistake {
        name: "aspect twice",
        sentence: "The horizontal distance from the middle is multiplied by width/height, although the window has that ratio already.",
        spoils: "point of the window",
        wrong: Wrong::WindowPoint(aspect_twice),
    },
    Mistake {
        name: "tan of the whole angle",
        sentence: "The height of the window is 2·tan(fov) and not 2·tan(fov/2), so the picture shows too much.",
        spoils: "point of the window",
        wrong: Wrong::WindowPoint(tan_of_the_whole_angle),
    },
    Mistake {
        name: "degrees for radians",
        sentence: "The tangent is given the angle in degrees, although it takes radians.",
        spoils: "point of the window",
        wrong: Wrong::WindowPoint(degrees_for_radians),
    },
];

fn size(camera: &Camera) -> [f64; 2] {
    camera.pixels.map(f64::from)
}

fn row_from_below(camera: &Camera, x: f64, y: f64) -> DVec3 {
    let [_, height] = size(camera);
    camera.to_window(x, height - y)
}

fn u_and_v_swapped(camera: &Camera, x: f64, y: f64) -> DVec3 {
    let [width, height] = size(camera);
    camera.to_window(y * width / height, x * height / width)
}

fn w_turned(camera: &Camera, x: f64, y: f64) -> DVec3 {
    let to_window = camera.to_window(x, y);
    let w = camera.window_normal();
    to_window - 2.0 * to_window.dot(w) * w
}

fn no_half(camera: &Camera, x: f64, y: f64) -> DVec3 {
    camera.to_window(x - 0.5, y - 0.5)
}

/// Of a picture of one column or row that one stays.
fn n_minus_1(camera: &Camera, x: f64, y: f64) -> DVec3 {
    let [width, height] = size(camera);
    let stretched = |at: f64, n: f64| if 1.0 < n { at * n / (n - 1.0) } else { at };
    camera.to_window(stretched(x, width), stretched(y, height))
}

fn aspect_twice(camera: &Camera, x: f64, y: f64) -> DVec3 {
    let [width, height] = size(camera);
    let middle = 0.5 * width;
    camera.to_window(middle + (x - middle) * width / height, y)
}

/// The window from its middle, with half its height at a distance of 1 computed from half the view angle in another way.
///
/// A window with its middle on the line of sight has tan(fov/2) = ½·height/distance.
fn scaled(camera: &Camera, [x, y]: [f64; 2], half_height: fn(f64) -> f64) -> DVec3 {
    let [width, height] = size(camera);
    let middle = camera.to_window(0.5 * width, 0.5 * height);
    let right = 0.5 * camera.up.length() / middle.length();
    let factor = half_height(libm::atan(right)) / right;
    middle + factor * (camera.to_window(x, y) - middle)
}

fn tan_of_the_whole_angle(camera: &Camera, x: f64, y: f64) -> DVec3 {
    scaled(camera, [x, y], |half| libm::tan(2.0 * half))
}

fn degrees_for_radians(camera: &Camera, x: f64, y: f64) -> DVec3 {
    scaled(camera, [x, y], |half| libm::tan(half.to_degrees()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A window of width × 2 pixels with sides of 1, around the line along −z and 1 ahead of the eye: the top left corner is
    /// at (−width/2, 1, −1).
    fn of(window_point: fn(&Camera, f64, f64) -> DVec3, width: u32, [x, y]: [f64; 2]) -> [f64; 3] {
        let right = f64::from(width);
        let camera = Camera {
            cop: DVec3::ZERO,
            to_corner: DVec3::new(-0.5 * right, -1.0, -1.0),
            right: DVec3::new(right, 0.0, 0.0),
            up: DVec3::new(0.0, 2.0, 0.0),
            pixels: [width, 2],
        };
        window_point(&camera, x, y).to_array()
    }

    fn right(camera: &Camera, x: f64, y: f64) -> DVec3 {
        camera.to_window(x, y)
    }

    #[test]
    fn each_mistake_moves_the_centre_of_the_upper_left_pixel() {
        let centre = [0.5, 0.5];
        assert_eq!(of(right, 2, centre), [-0.5, 0.5, -1.0]);
        assert_eq!(of(row_from_below, 2, centre), [-0.5, -0.5, -1.0]);
        assert_eq!(of(w_turned, 2, centre), [-0.5, 0.5, 1.0]);
        assert_eq!(of(no_half, 2, centre), [-1.0, 1.0, -1.0]);
        // ½·2/1 = 1 of 2 columns and rows: the middle of the window
        assert_eq!(of(n_minus_1, 2, centre), [0.0, 0.0, -1.0]);
        // the pixel below
        assert_eq!(of(right, 2, [0.5, 1.5]), [-0.5, -0.5, -1.0]);
        assert_eq!(of(u_and_v_swapped, 2, [0.5, 1.5]), [0.5, 0.5, -1.0]);
        // the last of four columns, 1½ from the middle, and twice that
        assert_eq!(of(right, 4, [3.5, 0.5]), [1.5, 0.5, -1.0]);
        assert_eq!(of(aspect_twice, 4, [3.5, 0.5]), [3.0, 0.5, -1.0]);
    }

    #[test]
    fn an_angle_taken_wrongly_makes_the_window_larger_around_its_middle() {
        // half the height is 1 at a distance of 3: fov/2 = atan(1/3), and tan(fov) = 2·(1/3)/(1 − 1/9) = 3/4
        let camera = Camera {
            cop: DVec3::ZERO,
            to_corner: DVec3::new(-2.0, -1.0, -3.0),
            right: DVec3::new(4.0, 0.0, 0.0),
            up: DVec3::new(0.0, 2.0, 0.0),
            pixels: [4, 2],
        };
        let off = |wrong: fn(&Camera, f64, f64) -> DVec3, x, y, expected: [f64; 3]| {
            let off = (wrong(&camera, x, y) - DVec3::from(expected)).length();
            // some roundings of numbers up to 10
            assert!(off <= 1e-13, "{off}");
        };
        off(right, 4.0, 0.0, [2.0, 1.0, -3.0]);
        off(tan_of_the_whole_angle, 4.0, 0.0, [4.5, 2.25, -3.0]);
        // fov/2 is 18.434 948 822 922 01 degrees, and the tangent of that many radians −0.440 119 632 680 586
        let factor = -0.440_119_632_680_586 * 3.0;
        off(degrees_for_radians, 4.0, 0.0, [2.0 * factor, factor, -3.0]);
        for wrong in [tan_of_the_whole_angle, degrees_for_radians] {
            off(wrong, 2.0, 1.0, [0.0, 0.0, -3.0]);
        }
    }

    #[test]
    fn each_but_the_two_that_always_move_it_has_a_place_that_stays() {
        // the middle row, the diagonal, the corner, the middle column
        for (wrong, place) in [
            (row_from_below as fn(&Camera, f64, f64) -> DVec3, [0.5, 1.0]),
            (u_and_v_swapped, [0.5, 0.5]),
            (n_minus_1, [0.0, 0.0]),
            (aspect_twice, [1.0, 0.5]),
        ] {
            assert_eq!(of(wrong, 2, place), of(right, 2, place));
        }
        // in a square picture the ratio is 1
        assert_eq!(of(aspect_twice, 2, [1.5, 0.5]), of(right, 2, [1.5, 0.5]));
        // column and row stay; or both move by half a pixel
        let [u, v, _] = of(w_turned, 2, [1.5, 0.5]);
        assert_eq!([u, v, -1.0], of(right, 2, [1.5, 0.5]));
        assert_eq!(of(no_half, 2, [1.5, 0.5]), of(right, 2, [1.0, 0.0]));
    }
}
