//! The mirror direction.

use glam::DVec3;

use crate::geometry::reflect;
use crate::mistake::{Mistake, Wrong};

pub(super) const MISTAKES: &[Mistake] = &[
    Mistake {
        name: "plus 2",
        sentence: "2(Δ·N)N is added instead of subtracted, so the ray goes on into the surface.",
        spoils: "R",
        wrong: Wrong::Reflect(plus_2),
    },
    Mistake {
        name: "N not unit",
        sentence: "N is taken as the plane's equation has it, such as (1, 1, 0), and not divided by its length.",
        spoils: "R",
        wrong: Wrong::Reflect(normal_not_unit),
    },
    Mistake {
        name: "D turned",
        sentence: "The direction of the ray is reversed before it is reflected, so R points the opposite way.",
        spoils: "R",
        wrong: Wrong::Reflect(direction_turned),
    },
];

fn plus_2(direction: DVec3, normal: DVec3) -> DVec3 {
    direction + 2.0 * direction.dot(normal) * normal
}

/// Equations are mostly written with a largest coefficient of 1.
fn normal_not_unit(direction: DVec3, normal: DVec3) -> DVec3 {
    reflect(direction, normal / normal.abs().max_element())
}

fn direction_turned(direction: DVec3, normal: DVec3) -> DVec3 {
    reflect(-direction, normal)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mirror_direction_leaves_the_surface() {
        let down = DVec3::new(3.0, -4.0, 0.0);
        assert_eq!(reflect(down, DVec3::Y), DVec3::new(3.0, 4.0, 0.0));
        // −4 + 2·(−4)
        assert_eq!(plus_2(down, DVec3::Y), DVec3::new(3.0, -12.0, 0.0));
        // along the surface both leave the ray as it is
        assert_eq!(reflect(DVec3::X, DVec3::Y), DVec3::X);
        assert_eq!(plus_2(DVec3::X, DVec3::Y), DVec3::X);
    }

    #[test]
    fn a_normal_that_is_too_long_sends_the_ray_too_far_across() {
        // x + y = 0, N = (1, 1, 0)/√2; straight down becomes straight out
        let (down, slope) = (DVec3::NEG_Y, DVec3::new(1.0, 1.0, 0.0));
        let right = reflect(down, slope.normalize()) - DVec3::X;
        assert!(right.length() <= 1e-15, "{right}");
        // Δ·N = −1: (0, −1, 0) + 2·(1, 1, 0)
        let wrong = normal_not_unit(down, slope.normalize()) - DVec3::new(2.0, 1.0, 0.0);
        assert!(wrong.length() <= 1e-15, "{wrong}");
        // along an axis the largest coefficient is the length
        assert_eq!(normal_not_unit(down, DVec3::Y), reflect(down, DVec3::Y));
    }

    #[test]
    fn a_turned_direction_gives_the_same_line_the_other_way() {
        let down = DVec3::new(3.0, -4.0, 0.0);
        let turned = direction_turned(down, DVec3::Y);
        assert_eq!(turned, DVec3::new(-3.0, -4.0, 0.0));
        assert_eq!(turned.cross(reflect(down, DVec3::Y)), DVec3::ZERO);
    }
}
