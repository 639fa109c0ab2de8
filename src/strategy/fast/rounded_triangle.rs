//! A triangle in one cache line: its plane, and its outline with 24 bits to a coordinate.
//!
//! A search looks at many triangles that its ray misses, or hits far from their edges. This copy settles those,
//! and says so where it cannot: the rest is for the [`Polygon`]. What it settles is what the polygon would have
//! said, and t has the same bits.
//!
//! **Why rounding the outline does no harm.** Let p′ be further from the line of each rounded edge than the
//! vertices were moved, √2 times the largest change of a coordinate at most. As the vertices move back, straight
//! and all at once, no edge passes p′, so p′ is inside the outline if it is inside the rounded one. Let p′ be
//! further by 512 times the error that [`Polygon::contains`] states for an upright ray; that is 8 times its
//! tolerance, since the tolerance of a ray that is not flat is stretched by 64. The polygon leaves to the ray what is
//! within 4½ tolerances of an edge: 3√2 across it, and √2 beyond its end. So here p′ decides, and rightly.

use glam::{DVec2, DVec3, Vec2};

use crate::geometry::{
    Axis, FLAT, OUTLINE_ROUNDING, Plane, Polygon, Ray, Sides, TRange, clear_crossings,
};

/// A triangle, or any other shape as one that settles nothing.
///
/// It takes 64 bytes, a cache line, and is laid out on one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub(super) struct RoundedTriangle {
    /// As it is: t depends on it.
    plane: Plane,
    outline: [Vec2; 3],
    /// What the rounding and the vertices' distance from the plane add to how far p′ must be from an edge.
    tolerance: f32,
    dropped: Axis,
    sides: Sides,
}

/// Where does a ray hit a triangle, as far as its rounded outline can decide?
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum RoundedTest {
    /// Where the triangle's own test finds no hit.
    Missed,
    /// Where it finds this one.
    Hit(f64),
    /// That test must be asked.
    Unsettled,
}

/// How many errors of an upright ray p′ is to be from an edge: twice those of [`Polygon::contains`].
const CLEAR: f64 = 8.0 / FLAT;

impl RoundedTriangle {
    /// Settles nothing: whatever the ray, it is flat.
    pub(super) const UNSETTLED: Self = Self {
        plane: Plane {
            normal: DVec3::ZERO,
            d: 0.0,
        },
        outline: [Vec2::ZERO; 3],
        tolerance: f32::INFINITY,
        dropped: Axis::X,
        sides: Sides::Both,
    };

    /// The copy of a polygon; `None` if that is no triangle.
    pub(super) fn new(polygon: &Polygon, sides: Sides) -> Option<Self> {
        let outline: [DVec2; 3] = polygon.outline().try_into().ok()?;
        let rounded = outline.map(DVec2::as_vec2);
        let moved = |(p, rounded): (&DVec2, &Vec2)| (*p - rounded.as_dvec2()).abs().max_element();
        // beyond the largest number of 32 bits it is infinite: then nothing is clear of an edge
        let moved = outline.iter().zip(&rounded).map(moved).fold(0.0, f64::max);
        let tolerance = CLEAR * polygon.off_plane() + 2.0 * moved;
        Some(Self {
            plane: polygon.plane(),
            outline: rounded,
            tolerance: (tolerance as f32).next_up(),
            dropped: polygon.dropped(),
            sides,
        })
    }

    /// Where does the ray hit the triangle, if it does so in the range?
    ///
    /// t of (v), then the edges that the half-line from p′ crosses, as in Fig. 15.57. A flat ray, and one that
    /// passes an edge closely, is left to the polygon.
    #[inline]
    pub(super) fn test(&self, ray: &Ray, range: TRange) -> RoundedTest {
        if self.plane.is_flat(ray) {
            return RoundedTest::Unsettled;
        }
        let Some(t) = self.plane.test(ray, range, self.sides).chosen() else {
            return RoundedTest::Missed;
        };
        let projected = self.dropped.drop_from(ray.at(t));
        let spread = ray.direction.abs().element_sum();
        let reach = ray.origin.abs().element_sum() + t * spread + self.plane.d.abs();
        let tolerance = CLEAR * OUTLINE_ROUNDING * reach + f64::from(self.tolerance);
        match clear_crossings(&self.outline.map(Vec2::as_dvec2), projected, tolerance) {
            Some(crossings) if crossings % 2 == 1 => RoundedTest::Hit(t),
            Some(_) => RoundedTest::Missed,
            None => RoundedTest::Unsettled,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(corners: [DVec3; 3]) -> (Polygon, RoundedTriangle) {
        let polygon = Polygon::new(corners.to_vec(), None).unwrap();
        let rounded = RoundedTriangle::new(&polygon, Sides::Both).unwrap();
        (polygon, rounded)
    }

    #[test]
    fn a_copy_takes_one_cache_line() {
        assert_eq!(size_of::<RoundedTriangle>(), 64);
        assert_eq!(align_of::<RoundedTriangle>(), 64);
    }

    #[test]
    fn inside_and_outside_are_settled_and_the_edge_is_left_to_the_polygon() {
        let (_, rounded) = triangle([DVec3::ZERO, 4.0 * DVec3::X, 4.0 * DVec3::Y]);
        let test = |x, y| {
            let ray = Ray::new(DVec3::new(x, y, 5.0), -DVec3::Z);
            rounded.test(&ray, TRange::FORWARD)
        };
        assert_eq!(test(1.0, 1.0), RoundedTest::Hit(5.0));
        assert_eq!(test(3.0, 3.0), RoundedTest::Missed);
        assert_eq!(test(2.0, 2.0), RoundedTest::Unsettled);
        assert_eq!(test(0.0, 0.0), RoundedTest::Unsettled);
    }

    #[test]
    fn a_hit_behind_or_beyond_the_range_is_missed() {
        let (_, rounded) = triangle([DVec3::ZERO, 4.0 * DVec3::X, 4.0 * DVec3::Y]);
        let above = Ray::new(DVec3::new(1.0, 1.0, 5.0), DVec3::Z);
        assert_eq!(rounded.test(&above, TRange::FORWARD), RoundedTest::Missed);
        let below = Ray::new(DVec3::new(1.0, 1.0, -5.0), DVec3::Z);
        let near = TRange::FORWARD.up_to(4.0);
        assert_eq!(rounded.test(&below, near), RoundedTest::Missed);
    }

    #[test]
    fn a_flat_ray_settles_nothing_and_a_shape_that_is_no_triangle_neither() {
        let (_, rounded) = triangle([DVec3::ZERO, 4.0 * DVec3::X, 4.0 * DVec3::Y]);
        let flat = Ray::new(DVec3::new(-1.0, 1.0, 0.01), DVec3::new(1.0, 0.0, -0.01));
        let steep = Ray::new(DVec3::ONE, -DVec3::Z);
        let settles =
            |copy: RoundedTriangle, ray| copy.test(ray, TRange::FORWARD) != RoundedTest::Unsettled;
        assert!(!settles(rounded, &flat) && settles(rounded, &steep));
        assert!(!settles(RoundedTriangle::UNSETTLED, &steep));
    }

    #[test]
    fn coordinates_that_32_bits_cannot_hold_settle_nothing() {
        for size in [1e-60, 1e45] {
            let (polygon, rounded) = triangle([DVec3::ZERO, size * DVec3::X, size * DVec3::Y]);
            let ray = Ray::new(size * DVec3::new(0.25, 0.25, 1.0), -DVec3::Z);
            let t = polygon
                .plane_test(&ray, TRange::FORWARD, Sides::Both)
                .chosen();
            assert!(t.is_some());
            assert_eq!(
                rounded.test(&ray, TRange::FORWARD),
                RoundedTest::Unsettled,
                "{size}"
            );
        }
    }

    /// Numbers between −1 and 1 that fill it evenly: the fractions of multiples of the golden ratio.
    fn spread(i: u32) -> f64 {
        2.0 * (f64::from(i) * 0.618_033_988_749_894_9).fract() - 1.0
    }

    #[test]
    fn what_is_settled_is_what_the_polygon_says_bit_for_bit() {
        let mut next = 0;
        let mut number = || {
            next += 1;
            spread(next)
        };
        let mut settled = [0; 3];
        for case in 0..40_000_u32 {
            let shift = if case % 2 == 0 { 0.0 } else { 1e3 };
            let mut point = || DVec3::new(number(), number(), number());
            let corners = [point(), point(), point()].map(|p| p + shift);
            let Ok(polygon) = Polygon::new(corners.to_vec(), None) else {
                continue;
            };
            let rounded = RoundedTriangle::new(&polygon, Sides::Both).unwrap();
            // a point of an edge, and beside it by 1 down to 10⁻¹⁷
            let [from, to] = [corners[0], corners[1]];
            let along = 0.5 + 0.6 * number();
            let beside = number() * 0.1_f64.powf(f64::from(case % 18));
            let target = from.lerp(to, along) + beside * (corners[2] - from);
            // from nearby, and from so far away that the rounding of the origin is what counts
            let away = if case % 5 == 0 { 1e6 } else { 3.0 };
            let origin = target + away * DVec3::new(number(), number(), number());
            let ray = Ray::through(origin, target);

            let t = polygon
                .plane_test(&ray, TRange::FORWARD, Sides::Both)
                .chosen();
            let whole = t.filter(|&t| polygon.contains(&ray, t).inside);
            match rounded.test(&ray, TRange::FORWARD) {
                RoundedTest::Hit(t) => {
                    settled[0] += 1;
                    assert_eq!(whole.map(f64::to_bits), Some(t.to_bits()), "{case}");
                }
                RoundedTest::Missed => {
                    settled[1] += 1;
                    assert_eq!(whole, None, "{case}");
                }
                RoundedTest::Unsettled => settled[2] += 1,
            }
        }
        // each of the three is common among such rays, else this test would hold of itself
        assert!(settled.iter().all(|&count| 2_000 <= count), "{settled:?}");
    }

    #[test]
    fn from_far_away_a_triangle_with_exact_corners_is_settled_as_the_polygon_says() {
        // corners on a lattice of eighths, which 32 bits hold: so the rounding of the ray alone keeps p′ off the edges
        let mut next = 0;
        let mut number = || {
            next += 1;
            spread(next)
        };
        let mut settled = [0; 2];
        for case in 0..10_000_i32 {
            let mut corner = || (64.0 * DVec3::new(number(), number(), number())).round() / 8.0;
            let corners = [corner(), corner(), corner()];
            let Ok(polygon) = Polygon::new(corners.to_vec(), None) else {
                continue;
            };
            let rounded = RoundedTriangle::new(&polygon, Sides::Both).unwrap();
            // beside an edge by 10⁻² down to 10⁻¹¹ of the triangle's size, from 10⁷ away: p′ is good to some 10⁻⁹
            let along = 0.5 + 0.4 * number();
            let beside = number() * 0.1_f64.powi(2 + case % 10);
            let target = corners[0].lerp(corners[1], along) + beside * (corners[2] - corners[0]);
            let ray = Ray::through(
                target + 1e7 * DVec3::new(number(), number(), number()),
                target,
            );
            let t = polygon
                .plane_test(&ray, TRange::FORWARD, Sides::Both)
                .chosen();
            let whole = t.filter(|&t| polygon.contains(&ray, t).inside);
            match rounded.test(&ray, TRange::FORWARD) {
                RoundedTest::Hit(t) => assert_eq!(whole, Some(t), "{case}"),
                RoundedTest::Missed => assert_eq!(whole, None, "{case}"),
                RoundedTest::Unsettled => {
                    settled[0] += 1;
                    continue;
                }
            }
            settled[1] += 1;
        }
        assert!(settled.iter().all(|&count| 500 <= count), "{settled:?}");
    }
}
