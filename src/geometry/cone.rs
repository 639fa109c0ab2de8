//! The open cone: a frustum or a cylinder without its end discs, as NFF has it.

use glam::DVec3;

use crate::geometry::quadratic::Quadratic;
use crate::geometry::{Alignment, QuadraticTest, Ray, Sides, TRange};

/// The surface between a base circle and an apex circle around the axis from base to apex.
///
/// With w the unit axis and y the height (p − base)·w over the base, 0 ≤ y ≤ height:
/// |p − base|² − y² = (r_base + k·y)²,  k = (r_apex − r_base)/height
///
/// Equal radii make a cylinder, one radius of 0 a cone with a tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// The middle of the base circle, in world coordinates.
    base: DVec3,
    /// The middle of the apex circle.
    apex: DVec3,
    /// From base to apex, unit length.
    axis: DVec3,
    /// The distance from base to apex.
    height: f64,
    /// r_base ≥ 0.
    base_radius: f64,
    /// k: what the radius gains per unit of height.
    slope: f64,
    /// r_apex ≥ 0, as it was given.
    apex_radius: f64,
}

/// Within this share of the sizes that entered them, a and b are rounding: what [`Cone::is_along_a_generator`]
/// and [`Cone::linear`] count, rounded up to a power of 2.
const ZERO: f64 = 32.0 * f64::EPSILON;

impl Cone {
    /// The cone between two circles; what is constant for all rays is computed here.
    ///
    /// `None` if base and apex are one point, or both radii are 0, or one is negative.
    pub fn new(base: DVec3, base_radius: f64, apex: DVec3, apex_radius: f64) -> Option<Self> {
        let height = (apex - base).length();
        let radii_fit = 0.0 <= base_radius && 0.0 <= apex_radius && 0.0 < base_radius + apex_radius;
        if !(radii_fit && 0.0 < height && height.is_finite()) {
            return None;
        }
        Some(Self {
            base,
            apex,
            axis: (apex - base) / height,
            height,
            base_radius,
            slope: (apex_radius - base_radius) / height,
            apex_radius,
        })
    }

    /// The middle of the base circle.
    pub fn base(&self) -> DVec3 {
        self.base
    }

    /// The middle of the apex circle.
    pub fn apex(&self) -> DVec3 {
        self.apex
    }

    /// From base to apex, unit length.
    pub fn axis(&self) -> DVec3 {
        self.axis
    }

    /// The distance from base to apex.
    pub fn height(&self) -> f64 {
        self.height
    }

    /// The radii of the base and of the apex.
    pub fn radii(&self) -> [f64; 2] {
        [self.base_radius, self.apex_radius]
    }

    /// k = (r_apex − r_base)/height.
    pub fn slope(&self) -> f64 {
        self.slope
    }

    /// The same cone in the frame of a ray: both circles are moved, the axis is turned.
    #[inline]
    #[must_use]
    pub fn aligned(&self, frame: &Alignment) -> Self {
        Self {
            base: frame.point(self.base),
            apex: frame.point(self.apex),
            axis: frame.vector(self.axis),
            ..*self
        }
    }

    /// Where does the ray hit the surface between base and apex?
    ///
    /// With m = o − base split into a height m·w and a part m⊥ across the axis, Δ likewise, and R the
    /// radius at the origin's height, R = r_base + k(m·w):
    ///
    /// a = |Δ⊥|² − k²(Δ·w)²,  b = 2[Δ⊥·m⊥ − k(Δ·w)R],  c = |m⊥|² − R²
    ///
    /// b² − 4ac = 4(|R·Δ⊥ − k(Δ·w)m⊥|² − |Δ⊥ × m⊥|²), by Lagrange's identity, without cancellation.
    ///
    /// A root whose height is not between 0 and `height` is beyond the ends.
    ///
    /// A ray along a generator has a = 0, which leaves b·t + c = 0 and one root. In the plane that touches the
    /// cone along that generator b = 0 too, as for a ray along the axis of a cylinder: no root. Rounding hides
    /// both zeros, so a and b count as 0, and are returned as 0, within 32ε of the sizes that entered them.
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::geometry::{Cone, Ray, Sides, TRange};
    ///
    /// let tip = Cone::new(DVec3::ZERO, 2.0, DVec3::new(0.0, 2.0, 0.0), 0.0).unwrap();
    /// let ray = Ray::new(DVec3::new(-5.0, 1.0, 0.0), DVec3::X); // at y = 1 the radius is 1
    /// let test = tip.test(&ray, TRange::FORWARD, Sides::Both);
    /// assert_eq!((test.a, test.b, test.c), (1.0, -10.0, 24.0));
    /// assert_eq!(test.roots.chosen(), Some(4.0));
    /// ```
    #[inline]
    pub fn test(&self, ray: &Ray, range: TRange, sides: Sides) -> QuadraticTest {
        let from_base = ray.origin - self.base;
        let height = from_base.dot(self.axis);
        let climb = ray.direction.dot(self.axis);
        let across = from_base - height * self.axis;
        let direction = ray.direction - climb * self.axis;
        let radius = self.base_radius + self.slope * height;
        let narrowing = self.slope * climb;

        let a = direction.length_squared() - narrowing * narrowing;
        let b = 2.0 * (direction.dot(across) - narrowing * radius);
        let c = across.length_squared() - radius * radius;
        let outer = (radius * direction - narrowing * across).length_squared();
        let passing = direction.cross(across).length_squared();

        let equation = if self.is_along_a_generator(ray, a) {
            self.linear(ray, b, c)
        } else {
            Quadratic {
                a,
                b,
                c,
                discriminant: 4.0 * (outer - passing),
                scale: 4.0 * outer,
            }
        };
        equation.test(range, sides, |t| {
            let y = height + t * climb;
            y < 0.0 || self.height < y
        })
    }

    /// Is a = |Δ⊥|² − k²(Δ·w)² nothing but rounding?
    ///
    /// With roundings of ½ε each: the unit axis w is off by 2ε and Δ by 1½ε, so Δ·w by 5ε|Δ| and Δ⊥ by 10ε|Δ|.
    /// k(Δ·w) is off by |k| times the former, and by 2ε of itself. Their squares are off by twice these times what
    /// is squared: 20ε|Δ||Δ⊥| + 14ε|Δ||k·k(Δ·w)| at most.
    #[inline]
    fn is_along_a_generator(&self, ray: &Ray, a: f64) -> bool {
        // |Δ⊥| and |Δ·w| are no longer than Δ: this settles it for nearly every ray
        let slope2 = self.slope * self.slope;
        let length2 = ray.direction.length_squared();
        a.abs() <= ZERO * (1.0 + slope2) * length2 && {
            let climb = ray.direction.dot(self.axis);
            let across = (ray.direction - climb * self.axis).length();
            a.abs() <= ZERO * length2.sqrt() * (across + slope2 * climb.abs())
        }
    }

    /// The equation without a: b·t + c = 0, with b = 0 where it is nothing but rounding.
    ///
    /// b/2 = Δ⊥·m⊥ − k(Δ·w)R. With the errors of [`Cone::is_along_a_generator`], and m⊥ off by 8ε|m|, R by
    /// 6ε|k||m| + 2ε·r_base, the first term is off by 10ε|Δ||m⊥| + 8ε|Δ⊥||m|, and the second by
    /// 7ε|k||Δ||R| + 6ε|k(Δ·w)|(|k||m| + r_base).
    #[cold]
    fn linear(&self, ray: &Ray, b: f64, c: f64) -> Quadratic {
        let from_base = (ray.origin - self.base).length();
        let length = ray.direction.length();
        let slope = self.slope.abs();
        let largest_radius = self.base_radius + slope * from_base;
        let size = length * (from_base + slope * largest_radius);
        let b = if b.abs() <= 2.0 * ZERO * size { 0.0 } else { b };
        let discriminant = b * b;
        Quadratic {
            a: 0.0,
            b,
            c,
            discriminant,
            scale: discriminant,
        }
    }

    /// The unit normal at a point of the surface, outwards: m⊥/|m⊥| − k·w, normalised.
    ///
    /// At the tip, where no normal exists: along the axis, outwards.
    pub fn normal(&self, point: DVec3) -> DVec3 {
        let from_base = point - self.base;
        let across = from_base - from_base.dot(self.axis) * self.axis;
        let outwards = across.normalize_or_zero() - self.slope * self.axis;
        outwards.normalize_or(self.axis)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Root, RootVerdict, Roots};

    /// Radius 1 around the y axis, from y = 0 to y = 2.
    fn cylinder() -> Cone {
        Cone::new(DVec3::ZERO, 1.0, DVec3::new(0.0, 2.0, 0.0), 1.0).unwrap()
    }

    /// Radius 2 at y = 0, tip at y = 2.
    fn tip() -> Cone {
        Cone::new(DVec3::ZERO, 2.0, DVec3::new(0.0, 2.0, 0.0), 0.0).unwrap()
    }

    #[track_caller]
    fn check(cone: Cone, origin: [f64; 3], direction: [f64; 3], roots: &[(f64, RootVerdict)]) {
        let ray = Ray::new(origin.into(), direction.into());
        let test = cone.test(&ray, TRange::FORWARD, Sides::Both);
        let found: Vec<_> = test
            .roots
            .iter()
            .map(|Root { t, verdict }| (t, verdict))
            .collect();
        assert_eq!(found, roots, "{test:?}");
    }

    #[test]
    fn a_cylinder_is_met_twice_across_its_axis() {
        let roots = [
            (4.0, RootVerdict::Chosen),
            (6.0, RootVerdict::BeyondNearest),
        ];
        check(cylinder(), [-5.0, 1.0, 0.0], [1.0, 0.0, 0.0], &roots);
    }

    #[test]
    fn above_the_apex_both_roots_are_beyond_the_ends() {
        let roots = [
            (4.0, RootVerdict::BeyondEnds),
            (6.0, RootVerdict::BeyondEnds),
        ];
        check(cylinder(), [-5.0, 2.5, 0.0], [1.0, 0.0, 0.0], &roots);
    }

    #[test]
    fn the_cylinder_is_open_so_a_ray_through_its_mouth_hits_the_inside() {
        // from (0.5, 3, 0) down at 45°: x = 0.5 − t; the near root t = −0.5 lies behind, x = −1 at
        // t = 1.5 with y = 1.5
        let roots = [(-0.5, RootVerdict::Behind), (1.5, RootVerdict::Chosen)];
        check(cylinder(), [0.5, 3.0, 0.0], [-1.0, -1.0, 0.0], &roots);
    }

    #[test]
    fn a_ray_along_the_axis_of_a_cylinder_meets_nothing() {
        check(cylinder(), [0.5, -5.0, 0.0], [0.0, 1.0, 0.0], &[]);
    }

    #[test]
    fn a_ray_along_a_generator_has_one_linear_root() {
        // slope −1, so direction (1, −1, 0)·s runs along a generator: a = 1 − 1 = 0. From (−3, 2, 0)
        // y = 2 − t, x = −3 + t, surface |x| = 2 − y = t: 3 − t = t at t = 1.5, y = 0.5
        let ray = Ray::new(DVec3::new(-3.0, 2.0, 0.0), DVec3::new(1.0, -1.0, 0.0));
        let test = tip().test(&ray, TRange::FORWARD, Sides::Both);
        assert_eq!(test.a, 0.0);
        let expected = Root {
            t: 1.5,
            verdict: RootVerdict::Chosen,
        };
        assert_eq!(test.roots, Roots::Linear(expected));
    }

    #[test]
    fn a_and_b_of_a_generator_are_0_though_their_terms_are_rounded() {
        // 3-4-5: k = −¾, and (−0.6, 0.8, 0) runs along a generator; a = 0.36 − 0.36, of which neither is exact
        let cone = Cone::new(DVec3::ZERO, 3.0, DVec3::new(0.0, 4.0, 0.0), 0.0).unwrap();
        let along = DVec3::new(-3.0, 4.0, 0.0) / 5.0;
        for (origin, b, c, t) in [
            // b = 2[0 + 0.6·3], c = 1 − 9: from inside
            ([0.0, 0.0, 1.0], 3.6, -8.0, Some(20.0 / 9.0)),
            // b = 2[−3 + 1.8], c = 25 − 9: t = 16/2.4, where y = 16/3 is beyond the tip
            ([5.0, 0.0, 0.0], -2.4, 16.0, None),
            // in the plane that touches the cone along (3, 0, 0) + t(−3, 4, 0), beside it by 7: b = 2[−1.8 + 1.8]
            ([3.0, 0.0, 7.0], 0.0, 49.0, None),
        ] {
            for scale in [1.0, 1e-40, 1e40] {
                let ray = Ray::new(scale * DVec3::from(origin), along);
                let [base, apex] = [cone.base(), cone.apex()].map(|p| scale * p);
                let scaled = Cone::new(base, 3.0 * scale, apex, 0.0).unwrap();
                let test = scaled.test(&ray, TRange::FORWARD, Sides::Both);
                assert_eq!(test.a, 0.0);
                assert!((test.b / scale - b).abs() <= 1e-14, "{test:?}");
                assert!((test.c / scale / scale - c).abs() <= 1e-13, "{test:?}");
                assert_eq!(test.roots == Roots::None, b == 0.0, "{test:?}");
                let off = |t: f64| (test.roots.chosen().unwrap() / scale - t).abs();
                assert!(t.is_none_or(|t| off(t) <= 1e-14), "{test:?}");
                assert_eq!(test.roots.chosen().is_some(), t.is_some(), "{test:?}");
            }
        }
    }

    #[test]
    fn the_mirror_cone_above_the_tip_is_beyond_the_ends() {
        let roots = [
            (4.0, RootVerdict::BeyondEnds),
            (6.0, RootVerdict::BeyondEnds),
        ];
        check(tip(), [-5.0, 3.0, 0.0], [1.0, 0.0, 0.0], &roots);
    }

    #[test]
    fn the_normal_leans_away_from_the_tip() {
        let normal = tip().normal(DVec3::new(1.0, 1.0, 0.0));
        let expected = DVec3::new(1.0, 1.0, 0.0) / 2f64.sqrt();
        assert!((normal - expected).length() <= 1e-15, "{normal}");
        assert_eq!(cylinder().normal(DVec3::new(0.0, 1.0, -1.0)), -DVec3::Z);
        assert_eq!(tip().normal(DVec3::new(0.0, 2.0, 0.0)), DVec3::Y);
    }

    #[test]
    fn a_cone_without_height_or_radius_is_refused() {
        assert_eq!(Cone::new(DVec3::ONE, 1.0, DVec3::ONE, 1.0), None);
        assert_eq!(Cone::new(DVec3::ZERO, 0.0, DVec3::Y, 0.0), None);
        assert_eq!(Cone::new(DVec3::ZERO, -1.0, DVec3::Y, 1.0), None);
    }

    /// Radius 3 at (1, 2, 3), tip 4 above: k = −¾, a 3-4-5 cone.
    fn three_four_five() -> Cone {
        Cone::new(
            DVec3::new(1.0, 2.0, 3.0),
            3.0,
            DVec3::new(1.0, 6.0, 3.0),
            0.0,
        )
        .unwrap()
    }

    #[test]
    fn the_coefficients_of_a_slanted_ray_count_from_the_base() {
        // radius 2 at y = 2, tip at y = 4, k = −1. m = (−4, 1, 1): m⊥ = (−4, 0, 1), R = 2 − 1 = 1;
        // Δ = (2, 1, 0): Δ⊥ = (2, 0, 0), k(Δ·w) = −1
        let base = DVec3::new(1.0, 2.0, 3.0);
        let cone = Cone::new(base, 2.0, DVec3::new(1.0, 4.0, 3.0), 0.0).unwrap();
        assert_eq!(
            (cone.axis(), cone.height(), cone.slope()),
            (DVec3::Y, 2.0, -1.0)
        );
        let ray = Ray::new(DVec3::new(-3.0, 3.0, 4.0), DVec3::new(2.0, 1.0, 0.0));
        let test = cone.test(&ray, TRange::FORWARD, Sides::Both);
        // 4 − 1, 2[−8 + 1], 17 − 1, 4(|(2, 0, 0) + (−4, 0, 1)|² − |(0, −2, 0)|²) = 4(5 − 4) = 14² − 4·3·16
        assert_eq!((test.a, test.b, test.c), (3.0, -14.0, 16.0));
        assert_eq!(test.discriminant, 4.0);
        // the same cone and a ray of another length beside it: 4(|R·Δ⊥ − …|² − …) goes with |Δ|²
        let longer = Ray::new(ray.origin, 4.0 * ray.direction);
        let test = cone.test(&longer, TRange::FORWARD, Sides::Both);
        assert_eq!(
            (test.a, test.b, test.c, test.discriminant),
            (48.0, -56.0, 16.0, 64.0)
        );
        // at (2, 3, 3) the radius is 1, and the normal leans towards the tip as far as outwards
        let normal = cone.normal(DVec3::new(2.0, 3.0, 3.0));
        assert!((normal - DVec3::new(1.0, 1.0, 0.0) / 2f64.sqrt()).length() <= 1e-15);
    }

    #[test]
    fn both_circles_belong_to_the_surface() {
        let roots = [
            (4.0, RootVerdict::Chosen),
            (6.0, RootVerdict::BeyondNearest),
        ];
        for y in [0.0, 2.0] {
            check(cylinder(), [-5.0, y, 0.0], [1.0, 0.0, 0.0], &roots);
        }
        let beyond = roots.map(|(t, _)| (t, RootVerdict::BeyondEnds));
        for y in [-f64::EPSILON, 2.0 + 2.0 * f64::EPSILON] {
            check(cylinder(), [-5.0, y, 0.0], [1.0, 0.0, 0.0], &beyond);
        }
    }

    #[test]
    fn a_graze_is_measured_by_the_size_of_the_cone() {
        // across a cylinder of radius r, at z = r(1 − nε): 4(r² − z²) = 8nε·r², and 4ε·4r² is a graze
        let radius = 1024.0;
        let wide = Cone::new(DVec3::ZERO, radius, DVec3::Y, radius).unwrap();
        for (n, grazes) in [(1.0, true), (2.0, true), (3.0, false)] {
            let origin = DVec3::new(-9.0, 0.5, radius * (1.0 - n * f64::EPSILON));
            let ray = Ray::new(origin, DVec3::X);
            let roots = wide.test(&ray, TRange::FORWARD, Sides::Both).roots;
            assert_eq!(matches!(roots, Roots::Graze(_)), grazes, "{n}: {roots:?}");
        }
    }

    #[test]
    fn a_counts_as_0_within_32_eps_of_the_terms_that_it_is_the_difference_of() {
        // |Δ|(|Δ⊥| + k²|Δ·w|) = 5(3 + 4·9/16) = 26¼, and 32·26¼ = 840
        let ray = Ray::new(DVec3::ZERO, DVec3::new(-3.0, 4.0, 0.0));
        let is_along = |a: f64| three_four_five().is_along_a_generator(&ray, a * f64::EPSILON);
        assert!(is_along(840.0) && is_along(-840.0));
        assert!(!is_along(841.0) && !is_along(-841.0));
        // the other way along it
        let ray = Ray::new(ray.origin, -ray.direction);
        let is_along = |a: f64| three_four_five().is_along_a_generator(&ray, a * f64::EPSILON);
        assert!(is_along(840.0) && !is_along(841.0));
        // straight across a cylinder: 1·(1 + 0)
        let across = Ray::new(DVec3::ZERO, DVec3::X);
        let is_along = |a: f64| cylinder().is_along_a_generator(&across, a * f64::EPSILON);
        assert!(is_along(32.0) && !is_along(33.0));
    }

    #[test]
    fn b_of_the_linear_equation_counts_as_0_within_64_eps_of_its_terms() {
        // 5 from the base: |Δ|(|m| + |k|(r_base + |k||m|)) = 5(5 + ¾(3 + 15/4)) = 805/16, and 64·805/16 = 3220
        let ray = Ray::new(DVec3::new(1.0, 2.0, 8.0), DVec3::new(-3.0, 4.0, 0.0));
        let linear = |b: f64| three_four_five().linear(&ray, b, 7.0);
        for (b, expected) in [(3220.0, 0.0), (-3220.0, 0.0), (3221.0, 3221.0)] {
            let [b, expected] = [b, expected].map(|b| b * f64::EPSILON);
            assert_eq!(linear(b).b, expected, "{b}");
        }
        let plain = linear(3.0);
        assert_eq!((plain.a, plain.b, plain.c), (0.0, 3.0, 7.0));
        assert_eq!((plain.discriminant, plain.scale), (9.0, 9.0));
    }

    #[test]
    fn the_one_root_of_a_generator_enters_where_the_ray_comes_from_outside() {
        // as above from (−3, 2, 0), to t = 1.5 on the outside
        let ray = Ray::new(DVec3::new(-3.0, 2.0, 0.0), DVec3::new(1.0, -1.0, 0.0));
        let root = |sides| tip().test(&ray, TRange::FORWARD, sides).roots;
        let expected = |verdict| Roots::Linear(Root { t: 1.5, verdict });
        assert_eq!(root(Sides::Front), expected(RootVerdict::Chosen));
        assert_eq!(root(Sides::Back), expected(RootVerdict::FrontFace));
    }

    #[test]
    fn a_radius_of_0_makes_a_tip_at_either_end_and_none_is_negative() {
        assert!(Cone::new(DVec3::ZERO, 0.0, DVec3::Y, 1.0).is_some());
        assert!(Cone::new(DVec3::ZERO, 1.0, DVec3::Y, 0.0).is_some());
        assert_eq!(Cone::new(DVec3::ZERO, 1.0, DVec3::Y, -0.5), None);
        assert_eq!(Cone::new(DVec3::ZERO, -0.5, DVec3::Y, 1.0), None);
    }
}
