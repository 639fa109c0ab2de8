//! ε: the ray that starts on a surface.

use glam::DVec3;

use crate::geometry::{Ray, TRange};
use crate::mistake::{Mistake, Wrong};
use crate::scene::{Primitive, Scene};
use crate::tracer::simple::{Own, Parts};
use crate::tracer::{EPSILON, Surface};

pub(super) const MISTAKES: &[Mistake] = &[
    Mistake {
        name: "no ε",
        sentence: "Each t above 0 counts, so rounding lets a surface hit the rays that start on it.",
        spoils: "t",
        wrong: Wrong::Hit(no_epsilon),
    },
    Mistake {
        name: "ε not scaled",
        sentence: "ε is one billionth for every point, however large its coordinates and their rounding are.",
        spoils: "ε",
        wrong: Wrong::StartEpsilon(not_scaled),
    },
    Mistake {
        name: "ε in t of an unnormalised ray",
        sentence: "The shadow ray is not normalised and reaches the light at t = 1, but ε is still a distance, so objects near the point are skipped.",
        spoils: "ε",
        wrong: Wrong::Blocked(in_t_of_an_unnormalised_ray),
    },
    Mistake {
        name: "offset to the wrong side",
        sentence: "The start of the ray is moved by ε against the normal, below the surface, so the ray hits the surface itself.",
        spoils: "blocked",
        wrong: Wrong::LeavesFrom(offset_to_the_wrong_side),
    },
];

fn no_epsilon(primitive: &Primitive, ray: &Ray, range: TRange) -> Option<f64> {
    let from_zero = TRange { min: 0.0, ..range };
    Own.hit(primitive, ray, from_zero)
}

fn not_scaled(_point: DVec3, _t: f64, _reach: f64) -> f64 {
    EPSILON
}

fn in_t_of_an_unnormalised_ray(scene: &Scene, ray: &Ray, range: TRange) -> bool {
    let to_light = Ray::new(ray.origin, ray.direction * range.max);
    Own.blocked(scene, &to_light, range.up_to(1.0))
}

/// The offset takes the place of the smallest t.
fn offset_to_the_wrong_side(surface: &Surface<'_>) -> (DVec3, f64) {
    (surface.point - surface.epsilon * surface.across, 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::{object, one_pixel, scene_of, sphere, wall};
    use crate::tracer::simple::picture;
    use crate::tracer::start_epsilon;

    #[test]
    fn without_it_a_point_just_below_the_surface_is_hit_by_it_again() {
        // the point is 2⁻⁵⁰ below the surface, and the ray runs outwards
        let scene = scene_of(&[sphere([0.0; 3], 1.0)]);
        let depth = 2f64.powi(-50);
        let out = Ray::new(DVec3::new(0.0, 0.0, 1.0 - depth), DVec3::Z);
        let range = TRange {
            min: 1e-9,
            max: f64::INFINITY,
        };
        let primitive = &scene.primitives[0];
        assert_eq!(Own.hit(primitive, &out, range), None);
        assert_eq!(no_epsilon(primitive, &out, range), Some(depth));
        // inwards both find the other side, 2 away
        let inwards = Ray::new(DVec3::Z, DVec3::NEG_Z);
        assert_eq!(Own.hit(primitive, &inwards, range), Some(2.0));
        assert_eq!(no_epsilon(primitive, &inwards, range), Some(2.0));
    }

    #[test]
    fn a_billionth_is_less_than_a_large_coordinate_s_rounding() {
        let far = DVec3::new(1e9, 0.0, 0.0);
        assert_eq!(start_epsilon(far, 1.0, 1.0), 1.0);
        assert_eq!(not_scaled(far, 1.0, 1.0), 1e-9);
        assert_eq!(start_epsilon(DVec3::X, 1.0, 1.0), 1e-9);
        assert_eq!(not_scaled(DVec3::X, 1.0, 1.0), 1e-9);
    }

    #[test]
    fn the_farther_the_light_the_more_an_epsilon_in_t_skips() {
        // a ball of radius 1 around (0, 0, 3): its first root is 2, its last one 4
        let scene = scene_of(&[sphere([0.0, 0.0, 3.0], 1.0)]);
        let ray = Ray::new(DVec3::ZERO, DVec3::Z);
        let of = |max: f64| {
            let range = TRange { min: 1e-9, max };
            [
                Own.blocked(&scene, &ray, range),
                in_t_of_an_unnormalised_ray(&scene, &ray, range),
            ]
        };
        // at 5·10⁹ the last root is t = 0.8·10⁻⁹ of the way, below ε = 10⁻⁹
        assert_eq!(of(5e9), [true, false]);
        // at 3·10⁹ it is t = 1.33·10⁻⁹
        assert_eq!(
            [of(3e9), of(10.0), of(1.5)],
            [[true; 2], [true; 2], [false; 2]]
        );
    }

    #[test]
    fn from_below_the_surface_every_light_is_blocked_by_it() {
        // L = (0, 3, 4)/5, N = (0, 0, 1): ambient 0.1 + diffuse 0.5·0.8
        let scene = |light: [f64; 3]| {
            one_pixel(&format!(
                r#""ambient":[0.1,0.1,0.1],"materials":{{"m":{{"colour":[1,1,1],"diffuse":0.5}}}},
                "lights":[{{"position":{light:?},"colour":[1,1,1]}}],"objects":[{}]"#,
                object("wall", "m", &wall(-5.0))
            ))
        };
        let wrong = Wrong::LeavesFrom(offset_to_the_wrong_side);
        let shades = |light| {
            let scene = scene(light);
            [
                picture(&scene, &Own).colours[0].x,
                picture(&scene, &wrong).colours[0].x,
            ]
        };
        let [right, dark] = shades([0.0, 3.0, -1.0]);
        assert!((right - 0.5).abs() <= 1e-15, "{right}");
        assert_eq!(dark, 0.1);
        // a light behind the wall brings nothing either way
        assert_eq!(shades([0.0, 3.0, -9.0]), [0.1, 0.1]);
    }
}
