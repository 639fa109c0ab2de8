//! Does a cone touch a cell?

use glam::DVec3;

use crate::geometry::{AxisBox, Cone};

/// Does the solid cone, its ends closed, touch the box? `false` only if a plane is found between them.
///
/// A plane with normal n lies between two convex solids A and B if every point of A − B is in front of it:
/// min n·(a − b) > 0. It is looked for as E. Gilbert does (1966), by going towards the point of A − B that is
/// closest to 0: from a point v of A − B with the furthest w of A − B against v. As soon as v·w > 0, v is such
/// a normal; else the next v is the point closest to 0 of the triangle of v, w and the w before, which comes
/// closer much faster than the segment from v to w alone.
///
/// w is rounded by the coordinates that it is the difference of. A v as short as that rounding is 0, and A and B
/// touch; where A − B has 0 inside, v would shrink further until no square of it is left. Nor does v·w > 0 count
/// within that rounding, for its sign is chance.
pub(in crate::structure) fn cone_touches(cone: &Cone, solid: &AxisBox) -> bool {
    /// A few steps find a plane; where the two nearly touch, a cell too many does no harm.
    const STEPS: usize = 64;
    /// Of |v| and of the coordinates: the rim's point is rounded by its 2 sums and 2 products, by 4ε of the radius
    /// for an axis and a direction that are not quite of unit length and at right angles, and by as much for a
    /// v that is nearly along the axis; w by 1 difference, v·w by 3 products and 2 sums. Some 8ε, doubled.
    const ROUNDING: f64 = 16.0 * f64::EPSILON;
    let AxisBox { min, max } = *solid;
    let [base, apex] = cone.radii();
    let of_cone = cone.base().abs().max(cone.apex().abs()).max_element() + base.max(apex);
    let of_box = min.abs().max(max.abs()).max_element();
    let rounding = ROUNDING * (of_cone + of_box);
    let furthest =
        |n: DVec3| furthest_of_cone(cone, n) - DVec3::select(n.cmplt(DVec3::ZERO), max, min);
    let mut v = 0.5 * (cone.base() + cone.apex()) - 0.5 * (min + max);
    let mut before = v;
    for _ in 0..STEPS {
        let length = v.length();
        if length <= rounding {
            return true;
        }
        let w = furthest(-v);
        if rounding * length < v.dot(w) {
            return false;
        }
        let closer = closest_to_zero([v, w, before]);
        let is_closer = closer.length_squared() < v.length_squared();
        if !is_closer {
            // nothing is gained
            return true;
        }
        (v, before) = (closer, w);
    }
    true
}

/// The point of a triangle that is closest to 0 (C. Ericson 2005, Real-Time Collision Detection, §5.1.5): a
/// corner, a point of an edge, or one inside, by the region that 0 lies in.
fn closest_to_zero([a, b, c]: [DVec3; 3]) -> DVec3 {
    let (ab, ac) = (b - a, c - a);
    let (ab_a, ac_a) = (ab.dot(-a), ac.dot(-a));
    if ab_a <= 0.0 && ac_a <= 0.0 {
        return a;
    }
    let (ab_b, ac_b) = (ab.dot(-b), ac.dot(-b));
    if 0.0 <= ab_b && ac_b <= ab_b {
        return b;
    }
    let (ab_c, ac_c) = (ab.dot(-c), ac.dot(-c));
    if 0.0 <= ac_c && ab_c <= ac_c {
        return c;
    }
    // the areas of the triangles that 0, seen from across, makes with the edges
    let of_c = ab_a * ac_b - ab_b * ac_a;
    if of_c <= 0.0 && 0.0 <= ab_a && ab_b <= 0.0 {
        return a + ab_a / (ab_a - ab_b) * ab;
    }
    let of_b = ab_c * ac_a - ab_a * ac_c;
    if of_b <= 0.0 && 0.0 <= ac_a && ac_c <= 0.0 {
        return a + ac_a / (ac_a - ac_c) * ac;
    }
    let of_a = ab_b * ac_c - ab_c * ac_b;
    let (from_b, from_c) = (ac_b - ab_b, ab_c - ac_c);
    if of_a <= 0.0 && 0.0 <= from_b && 0.0 <= from_c {
        return b + from_b / (from_b + from_c) * (c - b);
    }
    a + (of_b * ab + of_c * ac) / (of_a + of_b + of_c)
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
        let solid = AxisBox {
            min: min.into(),
            max: max.into(),
        };
        assert_eq!(cone_touches(&cone, &solid), expected);
    }

    #[test]
    fn the_closest_point_of_a_triangle_is_a_corner_or_on_an_edge_or_inside() {
        let closest = |corners: [[f64; 3]; 3]| closest_to_zero(corners.map(DVec3::from));
        let inside = [[-1.0, -1.0, 2.0], [3.0, -1.0, 2.0], [-1.0, 3.0, 2.0]];
        assert!((closest(inside) - DVec3::new(0.0, 0.0, 2.0)).length() <= 1e-15);
        let beside_an_edge = [[1.0, -1.0, 0.0], [1.0, 3.0, 0.0], [5.0, 0.0, 0.0]];
        assert_eq!(closest(beside_an_edge), DVec3::X);
        let before_a_corner = [[1.0, 1.0, 0.0], [5.0, 1.0, 0.0], [1.0, 5.0, 0.0]];
        assert_eq!(closest(before_a_corner), DVec3::new(1.0, 1.0, 0.0));
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
    fn a_box_with_a_part_of_the_cone_inside_touches_it_at_any_scale() {
        // the corner (5, 4) of the box is √2 from the axis at (4, 3), of a cylinder of radius 2: v came down to 10⁻¹⁶⁰,
        // of which no square is left, and v·w was above 0
        for power in [-40, -20, -1, 0, 10, 20, 40] {
            let scale = 10f64.powi(power);
            let at = |x: f64, y: f64, z: f64| scale * DVec3::new(x, y, z);
            let [base, apex] = [at(4.0, 3.0, -2.0), at(4.0, 3.0, -5.0)];
            let cylinder = Cone::new(base, 2.0 * scale, apex, 2.0 * scale).unwrap();
            let meets = |min, max| cone_touches(&cylinder, &AxisBox { min, max });
            assert!(meets(at(5.0, 4.0, -5.0), at(6.0, 5.0, -2.0)), "{scale:e}");
            // and (5.5, 4.5) is √4.5 = 2.12 away
            assert!(!meets(at(5.5, 4.5, -5.0), at(6.0, 5.0, -2.0)), "{scale:e}");
        }
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

    #[test]
    fn the_closest_point_of_a_triangle_may_be_any_of_its_corners_and_on_any_of_its_edges() {
        let closest = |corners: [[f64; 3]; 3]| closest_to_zero(corners.map(DVec3::from)).to_array();
        // the corner (1, 1, 0) in each place
        let corners = [[1.0, 1.0, 0.0], [5.0, 1.0, 0.0], [1.0, 5.0, 0.0]];
        for turn in 0..3 {
            let turned = [0, 1, 2].map(|i| corners[(i + turn) % 3]);
            assert_eq!(closest(turned), [1.0, 1.0, 0.0], "{turn}");
        }
        // an edge along x = 1 from y = −1 to 3, whose point (1, 0, 0) is the closest, in each place and both ways
        for third in [[5.0, 0.0, 0.0], [5.0, 9.0, 0.0]] {
            let corners = [[1.0, -1.0, 0.0], [1.0, 3.0, 0.0], third];
            for turn in 0..3 {
                let turned = [0, 1, 2].map(|i| corners[(i + turn) % 3]);
                assert_eq!(closest(turned), [1.0, 0.0, 0.0], "{turn}");
                let mirrored = [turned[0], turned[2], turned[1]];
                assert_eq!(closest(mirrored), [1.0, 0.0, 0.0], "{turn} mirrored");
            }
        }
        // across the origin at a distance of 2: inside, in each order of the corners
        let corners = [[-1.0, -1.0, 2.0], [3.0, -1.0, 2.0], [-1.0, 4.0, 2.0]];
        for turn in 0..3 {
            let turned = [0, 1, 2].map(|i| corners[(i + turn) % 3]);
            let off = DVec3::from(closest(turned)) - DVec3::new(0.0, 0.0, 2.0);
            assert!(off.length() <= 1e-15, "{turn} {off}");
        }
    }

    #[test]
    fn a_cone_along_z_touches_a_box_whose_closest_point_is_within_its_radius_there() {
        /// Beyond this distance a plane between the two is found; closer, a box may be reported to touch that does not.
        const CLEAR: f64 = 0.25;
        let cones = [(2.0, 2.0), (3.0, 0.0), (0.0, 3.0), (3.0, 1.5), (0.5, 2.5)];
        let (mut touching, mut clear) = (0, 0);
        for (base, apex) in cones {
            let (at, low, high) = (DVec3::new(1.0, -2.0, 0.0), 1.0, 5.0);
            let cone = Cone::new(at.with_z(low), base, at.with_z(high), apex).unwrap();
            let radius = |z: f64| base + (apex - base) * (z - low) / (high - low);
            for case in 0..1000_u32 {
                // corners on a lattice of fifths, shifted so that no box touches the cone in a point alone
                let number = |k: u32, range: u32| f64::from(case.wrapping_mul(k) / 7 % range);
                let corner = |k: u32| {
                    let place = DVec3::new(number(k, 37), number(k + 6, 41), number(k + 20, 43));
                    0.2 * place + DVec3::new(-2.97, -5.93, -1.01)
                };
                let (a, b) = (corner(2_654_435), corner(1_013_904));
                let (min, max) = (a.min(b), a.max(b) + 0.05);
                // in the heights that both have, the cone is widest at one end
                let (z_low, z_high) = (min.z.max(low), max.z.min(high));
                let beside = (min - at).max(at - max).max(DVec3::ZERO);
                let gap = beside.x.hypot(beside.y) - radius(z_low).max(radius(z_high));
                let found = cone_touches(&cone, &AxisBox { min, max });
                if z_low <= z_high && gap <= 0.0 {
                    touching += 1;
                    assert!(found, "{base} {apex} {min} {max}");
                } else if CLEAR < gap.max(z_low - z_high) {
                    clear += 1;
                    assert!(!found, "{base} {apex} {min} {max}");
                }
            }
        }
        assert!(500 < touching && 500 < clear, "{touching} {clear}");
    }
}
