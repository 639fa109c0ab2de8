//! Does a cone touch a cell?

use glam::DVec3;

use crate::geometry::Cone;

/// Does the solid cone, its ends closed, touch the box? `false` only if a plane is found between them.
///
/// A plane with normal n lies between two convex solids A and B if every point of A − B is in front of it:
/// min n·(a − b) > 0. E. Gilbert's algorithm (1966) looks for it by going towards the point of A − B that is
/// closest to 0: from a point v of A − B to the closest point of the segment from v to w, where w is the
/// furthest of A − B against v. As soon as v·w > 0, v is such a normal.
pub(super) fn cone_touches(cone: &Cone, min: DVec3, max: DVec3) -> bool {
    /// It comes closer with each step, and slowly where they nearly touch; a cell too many does no harm.
    const STEPS: usize = 64;
    let furthest =
        |n: DVec3| furthest_of_cone(cone, n) - DVec3::select(n.cmplt(DVec3::ZERO), max, min);
    let mut v = 0.5 * (cone.base() + cone.apex()) - 0.5 * (min + max);
    for _ in 0..STEPS {
        let w = furthest(-v);
        if 0.0 < v.dot(w) {
            return false;
        }
        let step = w - v;
        let length2 = step.length_squared();
        let share = (-v.dot(step) / length2).clamp(0.0, 1.0);
        let closer = v + share * step;
        let is_closer = closer.length_squared() < v.length_squared();
        if !is_closer {
            // 0 is reached, or nothing is gained
            return true;
        }
        v = closer;
    }
    true
}

/// The point of the solid cone that is furthest along n: on one of its two rims.
fn furthest_of_cone(cone: &Cone, n: DVec3) -> DVec3 {
    let outwards = (n - n.dot(cone.axis()) * cone.axis()).normalize_or_zero();
    let [base, apex] = cone.radii();
    let on_base = cone.base() + base * outwards;
    let on_apex = cone.apex() + apex * outwards;
    if n.dot(on_base) < n.dot(on_apex) {
        on_apex
    } else {
        on_base
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(min: [f64; 3], max: [f64; 3], expected: bool) {
        // radius 5 at y = 0, tip at y = 10
        let cone = Cone::new(DVec3::ZERO, 5.0, DVec3::new(0.0, 10.0, 0.0), 0.0).unwrap();
        assert_eq!(cone_touches(&cone, min.into(), max.into()), expected);
    }

    #[test]
    fn a_box_inside_or_around_the_cone_or_through_its_side_touches_it() {
        check([-0.1, 1.0, -0.1], [0.1, 1.2, 0.1], true);
        check([-9.0; 3], [11.0; 3], true);
        // at y = 5 the radius is 2.5
        check([2.4, 5.0, -0.1], [9.0, 6.0, 0.1], true);
        check([-0.1, 9.9, -0.1], [0.1, 12.0, 0.1], true);
    }

    #[test]
    fn a_box_in_the_corner_of_the_cone_s_box_does_not_touch_it() {
        check([4.0, 8.0, 4.0], [5.0, 10.0, 5.0], false);
        check([2.6, 5.0, -0.1], [9.0, 6.0, 0.1], false);
        // beside the base, within the square around it: 4·√2 = 5.66
        check([4.0, 0.0, 4.0], [5.0, 1.0, 5.0], false);
        check([-5.0, -2.0, -5.0], [5.0, -0.1, 5.0], false);
        check([-0.1, 10.1, -0.1], [0.1, 12.0, 0.1], false);
    }
}
