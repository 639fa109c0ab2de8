//! ε: the ray that starts on a surface.

use glam::DVec3;

use crate::geometry::{Ray, TRange};
use crate::mistake::{Mistake, Wrong};
use crate::scene::Primitive;
use crate::tracer::EPSILON;
use crate::tracer::simple::{Own, Parts};

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
];

fn no_epsilon(primitive: &Primitive, ray: &Ray, range: TRange) -> Option<f64> {
    let from_zero = TRange { min: 0.0, ..range };
    Own.hit(primitive, ray, from_zero)
}

fn not_scaled(_point: DVec3, _t: f64, _reach: f64) -> f64 {
    EPSILON
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::{scene_of, sphere};
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
}
