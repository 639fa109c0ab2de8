//! The bounding volume: what its interval says, and what it does not.

use glam::DVec3;

use crate::geometry::{AxisBox, Ray, TRange};
use crate::mistake::{Mistake, Wrong};
use crate::scene::{Primitive, Shape};
use crate::trace::BoundVerdict;
use crate::tracer::simple::{Own, Parts};

pub(super) const MISTAKES: &[Mistake] = &[
    Mistake {
        name: "near < 0 is a miss",
        sentence: "A volume that the ray starts in counts as missed, because near is negative.",
        spoils: "verdict of the bound",
        wrong: Wrong::Bound(near_below_0_is_a_miss),
    },
    Mistake {
        name: "t of the box taken as the hit",
        sentence: "The ray hits the box around an object, and its t is taken for the object's.",
        spoils: "t",
        wrong: Wrong::Hit(t_of_the_box),
    },
];

fn near_below_0_is_a_miss(inside: Option<[f64; 2]>, range: TRange) -> BoundVerdict {
    match inside {
        Some([near, _]) if near < 0.0 => BoundVerdict::Missed,
        _ => BoundVerdict::of(inside, range),
    }
}

/// The box around a sphere or an ellipsoid; every other object is tested itself.
fn t_of_the_box(primitive: &Primitive, ray: &Ray, range: TRange) -> Option<f64> {
    let (center, radii) = match &primitive.shape {
        Shape::Sphere(sphere) => (sphere.center, DVec3::splat(sphere.radius)),
        Shape::Ellipsoid(ellipsoid) => (ellipsoid.center, ellipsoid.radii),
        _ => return Own.hit(primitive, ray, range),
    };
    let around = AxisBox::around([center - radii, center + radii]);
    around.test(ray, range, primitive.sides).roots.chosen()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene::{scene_of, sphere};

    #[test]
    fn a_ray_that_starts_inside_hits_the_volume() {
        let of = |inside| {
            [BoundVerdict::of, near_below_0_is_a_miss]
                .map(|verdict| verdict(Some(inside), TRange::FORWARD))
        };
        assert_eq!(of([-1.0, 2.0]), [BoundVerdict::Hit, BoundVerdict::Missed]);
        assert_eq!(of([1.0, 2.0]), [BoundVerdict::Hit; 2]);
    }

    #[test]
    fn a_box_is_hit_sooner_than_the_ball_in_it_but_in_the_middle() {
        // (1, 1): a ball of radius 2 around z = −5 is hit at 5 − √(4 − 2), its box at 3
        let scene = scene_of(&[sphere([0.0, 0.0, -5.0], 2.0)]);
        let from = |x: f64| {
            let ray = Ray::new(DVec3::new(x, x, 0.0), DVec3::NEG_Z);
            let primitive = &scene.primitives[0];
            [
                Own.hit(primitive, &ray, TRange::FORWARD),
                t_of_the_box(primitive, &ray, TRange::FORWARD),
            ]
        };
        let [ball, around] = from(1.0);
        assert!((ball.unwrap() - (5.0 - 2f64.sqrt())).abs() <= 1e-15);
        assert_eq!(around, Some(3.0));
        assert_eq!(from(0.0), [Some(3.0); 2]);
        // at a corner of the box there is no ball at all
        assert_eq!(from(1.9), [None, Some(3.0)]);
    }
}
