//! The ray (i): what t measures.

use crate::geometry::Ray;
use crate::mistake::{Mistake, Wrong};

pub(super) const MISTAKES: &[Mistake] = &[Mistake {
    name: "t kept after normalising",
    sentence: "The direction gets unit length, but t = 1 is still taken for the point of the window.",
    spoils: "t",
    wrong: Wrong::Normalised(t_kept_after_normalising),
}];

fn t_kept_after_normalising(ray: &Ray) -> Option<(Ray, f64)> {
    let (unit, _) = ray.normalised()?;
    Some((unit, 1.0))
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    #[test]
    fn the_window_lies_at_the_length_of_the_direction_and_not_at_1() {
        // √(3² + 4²) = 5
        let slanted = Ray::new(DVec3::ZERO, DVec3::new(3.0, 0.0, -4.0));
        let unit = Ray::new(DVec3::ZERO, DVec3::new(0.6, 0.0, -0.8));
        assert_eq!(slanted.normalised(), Some((unit, 5.0)));
        assert_eq!(t_kept_after_normalising(&slanted), Some((unit, 1.0)));
        let straight = Ray::new(DVec3::ZERO, DVec3::NEG_Z);
        assert_eq!(straight.normalised(), t_kept_after_normalising(&straight));
    }
}
