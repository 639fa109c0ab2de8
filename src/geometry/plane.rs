//! The plane: the slides' equations (iv) and (v).

use glam::{DVec2, DVec3};

use crate::geometry::root::{hidden_side, judged};
use crate::geometry::{Ray, Root, Sides, TRange};

/// A·x + B·y + C·z + D = 0 … (iv), with (A, B, C) of unit length.
///
/// With a unit normal the left side is the signed distance of (x, y, z) from the plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plane {
    /// (A, B, C), of unit length.
    pub normal: DVec3,
    /// D: minus the plane's position along the normal.
    pub d: f64,
}

/// A coordinate axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axis {
    /// The first coordinate.
    #[default]
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}

impl Axis {
    /// The axis along which a vector is longest; the first of equals.
    #[inline]
    pub fn of_largest(v: DVec3) -> Self {
        let [x, y, z] = v.abs().to_array();
        if y <= x && z <= x {
            Self::X
        } else if z <= y {
            Self::Y
        } else {
            Self::Z
        }
    }

    /// The axis along which a vector is shortest; the first of equals.
    #[inline]
    pub(crate) fn of_smallest(v: DVec3) -> Self {
        let [x, y, z] = v.abs().to_array();
        if x <= y && x <= z {
            Self::X
        } else if y <= z {
            Self::Y
        } else {
            Self::Z
        }
    }

    /// The point without this coordinate: its orthographic projection along the axis.
    #[inline]
    pub fn drop_from(self, p: DVec3) -> DVec2 {
        let [u, v] = self.others();
        let p = p.to_array();
        DVec2::new(p[u], p[v])
    }

    /// The point whose projection along the axis is this one: the inverse of [`Axis::drop_from`].
    #[inline]
    pub(super) fn put_back(self, p: DVec2, coordinate: f64) -> DVec3 {
        match self {
            Self::X => DVec3::new(coordinate, p.x, p.y),
            Self::Y => DVec3::new(p.x, coordinate, p.y),
            Self::Z => DVec3::new(p.x, p.y, coordinate),
        }
    }

    /// The places of the two other coordinates. To read them by place is quicker than to branch: which
    /// axis it is changes from polygon to polygon, and no processor foresees it.
    #[inline]
    pub(super) fn others(self) -> [usize; 2] {
        [
            usize::from(self == Self::X),
            2 - usize::from(self == Self::Z),
        ]
    }

    /// This coordinate of a point.
    #[inline]
    pub fn of(self, p: DVec3) -> f64 {
        match self {
            Self::X => p.x,
            Self::Y => p.y,
            Self::Z => p.z,
        }
    }
}

/// What equation (v) of a ray and a plane gave.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlaneTest {
    /// (A, B, C) and D.
    pub plane: Plane,
    /// A·x₀ + B·y₀ + C·z₀ + D: the distance of the origin from the plane, signed.
    pub numerator: f64,
    /// A·Δx + B·Δy + C·Δz: the cosine between ray and normal, for a unit ray.
    pub denominator: f64,
    /// Where they intersect, or how they are parallel.
    pub verdict: PlaneVerdict,
}

/// Does a ray hit a plane?
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlaneVerdict {
    /// The line does, at this t; the root's verdict says whether the ray does (erratum 12).
    Meets(Root),
    /// Parallel, beside the plane.
    ParallelBeside,
    /// Parallel, in the plane: numerator and denominator are both 0.
    ParallelWithin,
}

impl Default for PlaneVerdict {
    fn default() -> Self {
        Self::Meets(Root::default())
    }
}

impl PlaneTest {
    /// t, if the plane is hit where it counts.
    #[inline]
    pub fn chosen(&self) -> Option<f64> {
        match self.verdict {
            PlaneVerdict::Meets(root) => {
                (root.verdict == crate::geometry::RootVerdict::Chosen).then_some(root.t)
            }
            PlaneVerdict::ParallelBeside | PlaneVerdict::ParallelWithin => None,
        }
    }
}

/// A sum of three products counts as 0 within this share of the sum of their magnitudes: the rounding
/// of the products and of the sum.
const ZERO: f64 = 4.0 * f64::EPSILON;

/// A ray is flat below this share of |Δx| + |Δy| + |Δz|, which is about 1° above the plane. The rounding of
/// (v) is stretched by no more than 64 above it, to some 10⁻¹³ of the numbers that enter, and without limit
/// below. A power of 2, so that the product is exact.
pub(crate) const FLAT: f64 = 1.0 / 64.0;

impl Plane {
    /// The plane of a polygon, after Newell: each component of the normal is the area of the outline
    /// projected along that axis, so that no single corner decides and concave corners do no harm.
    ///
    /// A = ½ Σ (yᵢ − yⱼ)(zᵢ + zⱼ), B and C cyclically, j = i + 1; then normalised. D puts the mean of the
    /// vertices on the plane. The normal points to where the vertices run counter-clockwise.
    ///
    /// `None` if the outline has no area: collinear vertices, or fewer than three.
    pub fn newell(vertices: &[DVec3]) -> Option<Self> {
        let origin = *vertices.first()?;
        let mut doubled_area = DVec3::ZERO;
        let mut mean = DVec3::ZERO;
        let mut size: f64 = 0.0;
        for (i, &vertex) in vertices.iter().enumerate() {
            // relative to the first vertex: an outline far from the world's origin keeps its digits
            let (p, q) = (vertex - origin, vertices[(i + 1) % vertices.len()] - origin);
            doubled_area += DVec3::new(
                (p.y - q.y) * (p.z + q.z),
                (p.z - q.z) * (p.x + q.x),
                (p.x - q.x) * (p.y + q.y),
            );
            mean += p / vertices.len() as f64;
            size = size.max(p.abs().max_element());
        }
        // below this the area is the rounding of the vertices' own coordinates
        let rounding = 16.0 * f64::EPSILON * size * (size + origin.abs().max_element());
        let length = doubled_area.length();
        if !length.is_finite() || length <= rounding {
            return None;
        }
        let normal = doubled_area / length;
        let d = 0.0 - normal.dot(origin + mean);
        Some(Self { normal, d })
    }

    /// A·x + B·y + C·z + D: how far in front of the plane a point lies.
    #[inline]
    pub fn distance(&self, point: DVec3) -> f64 {
        self.normal.dot(point) + self.d
    }

    /// Where does the ray hit the plane?
    ///
    /// t = −(A·x₀ + B·y₀ + C·z₀ + D) / (A·Δx + B·Δy + C·Δz) … (v)
    ///
    /// Parallel if the denominator is 0, that is, within 4ε of the size of its own terms; then in the
    /// plane if the numerator is 0 by the same measure, else beside it. A denominator above 0 means
    /// that the ray hits the back.
    ///
    /// ```
    /// use glam::DVec3;
    /// use raystep::geometry::{Plane, Ray, Sides, TRange};
    ///
    /// let floor = Plane { normal: DVec3::Y, d: 0.0 };
    /// let ray = Ray::new(DVec3::new(0.0, 3.0, 0.0), DVec3::new(0.8, -0.6, 0.0));
    /// let test = floor.test(&ray, TRange::FORWARD, Sides::Both);
    /// assert_eq!((test.numerator, test.denominator), (3.0, -0.6));
    /// assert_eq!(test.chosen(), Some(5.0));
    /// ```
    #[inline]
    pub fn test(&self, ray: &Ray, range: TRange, sides: Sides) -> PlaneTest {
        self.test_settled(ray, range, sides, |t| t)
    }

    /// The same, with `settled` of t in its place where the ray runs flat.
    #[inline]
    pub(super) fn test_settled(
        &self,
        ray: &Ray,
        range: TRange,
        sides: Sides,
        settled: impl FnOnce(f64) -> f64,
    ) -> PlaneTest {
        let numerator = self.distance(ray.origin);
        let denominator = self.normal.dot(ray.direction);
        let is_flat = self.is_flat(ray);

        let parallel = if is_flat { self.parallel(ray) } else { None };
        let verdict = parallel.unwrap_or_else(|| {
            let quotient = -numerator / denominator;
            let t = if is_flat { settled(quotient) } else { quotient };
            let refused = |_| hidden_side(denominator < 0.0, sides);
            PlaneVerdict::Meets(judged(t, range, refused))
        });
        PlaneTest {
            plane: *self,
            numerator,
            denominator,
            verdict,
        }
    }

    /// Does the ray run so flat along the plane that its t has lost digits?
    ///
    /// |A·Δx + B·Δy + C·Δz| ≤ (|Δx| + |Δy| + |Δz|)/64
    #[inline]
    pub(crate) fn is_flat(&self, ray: &Ray) -> bool {
        self.normal.dot(ray.direction).abs() <= FLAT * ray.direction.abs().element_sum()
    }

    /// Is the ray parallel to the plane, within the rounding of the denominator? Only a flat ray can be.
    #[cold]
    fn parallel(&self, ray: &Ray) -> Option<PlaneVerdict> {
        let steepness = self.normal.abs().dot(ray.direction.abs());
        if ZERO * steepness < self.normal.dot(ray.direction).abs() {
            return None;
        }
        let reach = self.normal.abs().dot(ray.origin.abs()) + self.d.abs();
        if self.distance(ray.origin).abs() <= ZERO * reach {
            Some(PlaneVerdict::ParallelWithin)
        } else {
            Some(PlaneVerdict::ParallelBeside)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::RootVerdict;

    const FLOOR: Plane = Plane {
        normal: DVec3::Y,
        d: 0.0,
    };

    #[track_caller]
    fn check(origin: [f64; 3], direction: [f64; 3], verdict: PlaneVerdict) {
        let ray = Ray::new(origin.into(), direction.into());
        let test = FLOOR.test(&ray, TRange::FORWARD, Sides::Both);
        assert_eq!(test.verdict, verdict, "{test:?}");
    }

    #[test]
    fn parallel_beside_the_plane_and_in_it_are_told_apart() {
        check(
            [0.0, 1.0, 0.0],
            [1.0, 0.0, 0.0],
            PlaneVerdict::ParallelBeside,
        );
        check(
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            PlaneVerdict::ParallelWithin,
        );
        check(
            [0.0, -0.0, 0.0],
            [1.0, -0.0, 0.0],
            PlaneVerdict::ParallelWithin,
        );
    }

    #[test]
    fn a_line_that_meets_the_plane_behind_the_origin_is_no_hit() {
        let behind = Root {
            t: -2.0,
            verdict: RootVerdict::Behind,
        };
        check(
            [0.0, 2.0, 0.0],
            [0.0, 1.0, 0.0],
            PlaneVerdict::Meets(behind),
        );
    }

    #[test]
    fn the_back_is_refused_where_only_the_front_shows() {
        let from_below = Ray::new(-DVec3::Y, DVec3::Y);
        let verdict = |sides| match FLOOR.test(&from_below, TRange::FORWARD, sides).verdict {
            PlaneVerdict::Meets(root) => root.verdict,
            other => panic!("{other:?}"),
        };
        assert_eq!(verdict(Sides::Both), RootVerdict::Chosen);
        assert_eq!(verdict(Sides::Front), RootVerdict::BackFace);
        assert_eq!(verdict(Sides::Back), RootVerdict::Chosen);
    }

    #[test]
    fn newell_gives_the_plane_of_a_tilted_triangle() {
        // x/1 + y/2 + z/2 = 1, that is 2x + y + z = 2, over √6
        let [a, b, c] = [DVec3::X, 2.0 * DVec3::Y, 2.0 * DVec3::Z];
        let plane = Plane::newell(&[a, b, c]).unwrap();
        let expected = DVec3::new(2.0, 1.0, 1.0) / 6f64.sqrt();
        assert!((plane.normal - expected).length() <= 1e-15, "{plane:?}");
        assert!((plane.d + 2.0 / 6f64.sqrt()).abs() <= 1e-15, "{plane:?}");
    }

    #[test]
    fn newell_is_not_misled_by_a_concave_first_corner() {
        let arrow = [(2.0, 1.0), (0.0, 0.0), (4.0, 0.0), (2.0, 4.0)];
        // first corner between (2,4) and (0,0) is convex; rotate so that the notch comes first
        let notch = [(1.0, 1.0), (0.0, 4.0), (0.0, 0.0), (4.0, 0.0)];
        for outline in [arrow, notch] {
            let vertices: Vec<_> = outline.map(|(x, y)| DVec3::new(x, y, 5.0)).to_vec();
            let plane = Plane::newell(&vertices).unwrap();
            assert_eq!((plane.normal, plane.d), (DVec3::Z, -5.0));
        }
    }

    #[test]
    fn an_outline_without_area_has_no_plane() {
        let line = [DVec3::ZERO, DVec3::ONE, 2.0 * DVec3::ONE];
        assert_eq!(Plane::newell(&line), None);
        assert_eq!(Plane::newell(&[DVec3::ZERO, DVec3::X]), None);
        assert_eq!(Plane::newell(&[]), None);
    }

    #[test]
    fn the_largest_coefficient_chooses_the_axis() {
        assert_eq!(Axis::of_largest(DVec3::new(0.1, -0.9, 0.3)), Axis::Y);
        assert_eq!(Axis::of_largest(DVec3::new(0.5, 0.5, 0.5)), Axis::X);
        let p = DVec3::new(1.0, 2.0, 3.0);
        assert_eq!(Axis::X.drop_from(p), DVec2::new(2.0, 3.0));
        assert_eq!(Axis::Y.drop_from(p), DVec2::new(1.0, 3.0));
        assert_eq!(Axis::Z.drop_from(p), DVec2::new(1.0, 2.0));
    }

    #[test]
    fn the_first_of_equals_chooses_the_axis() {
        assert_eq!(Axis::of_largest(DVec3::new(1.0, -2.0, 2.0)), Axis::Y);
        assert_eq!(Axis::of_largest(DVec3::new(2.0, 1.0, -2.0)), Axis::X);
        for (v, axis) in [
            ([1.0, 1.0, 1.0], Axis::X),
            ([1.0, -1.0, 2.0], Axis::X),
            ([-1.0, 2.0, 1.0], Axis::X),
            ([2.0, 1.0, -1.0], Axis::Y),
            ([3.0, 2.0, 1.0], Axis::Z),
        ] {
            assert_eq!(Axis::of_smallest(v.into()), axis, "{v:?}");
        }
    }

    #[test]
    fn a_ray_is_flat_up_to_a_64th_of_the_size_of_its_direction() {
        // 1 against (63 + 1)/64 and (62 + 1)/64
        for (along, flat) in [(63.0, true), (62.0, false)] {
            let ray = Ray::new(DVec3::ZERO, DVec3::new(along, -1.0, 0.0));
            assert_eq!(FLOOR.is_flat(&ray), flat, "{along}");
        }
    }

    #[test]
    fn parallel_and_within_are_measured_by_the_terms_at_every_length_of_the_ray() {
        // 0.6x + 0.8y = 5, through (3, 4, 0) and along (0.8, −0.6, 0), and its mirror images
        let (eps, far) = (f64::EPSILON, 2.0_f64.powi(30));
        let lengths = [1.0, far, 1.0 / far, -1.0];
        let signs = [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]];
        for (length, [x, y]) in lengths
            .into_iter()
            .flat_map(|l| signs.map(|signs| (l, signs)))
        {
            let mirror = DVec3::new(x, y, 1.0);
            let slanted = Plane {
                normal: mirror * DVec3::new(0.6, 0.8, 0.0),
                d: -5.0,
            };
            let verdict = |up: f64, turn: f64| {
                let origin = mirror * DVec3::new(3.0, 4.0 + up, 0.0);
                let direction = length * mirror * DVec3::new(0.8, -0.6 + turn, 0.0);
                slanted
                    .test(&Ray::new(origin, direction), TRange::FORWARD, Sides::Both)
                    .verdict
            };
            // ε = 2⁻⁵²; the terms of the denominator are 0.48 + 0.48, and 4ε·0.96 lies between 0.8·4ε and 0.8·8ε;
            // those of the numerator are 1.8 + 3.2 + 5, and 4ε·10 lies between 0.8·16ε and 0.8·64ε
            for side in [1.0, -1.0] {
                let up = side * eps;
                assert_eq!(verdict(16.0 * up, 4.0 * eps), PlaneVerdict::ParallelWithin);
                assert_eq!(verdict(64.0 * up, -4.0 * eps), PlaneVerdict::ParallelBeside);
                assert!(matches!(verdict(0.0, 8.0 * up), PlaneVerdict::Meets(_)));
            }
        }
    }

    #[test]
    fn an_area_within_the_rounding_of_far_off_coordinates_is_none() {
        // size 4 at x = 1020: 16ε·4·(4 + 1020) = 2⁻³⁶ for twice the area, which is 4·height
        let height = 2.0_f64.powi(-38);
        for side in [1.0, -1.0] {
            let sliver = |height| {
                [
                    [1020.0, 0.0, 0.0],
                    [1024.0, 0.0, 0.0],
                    [1020.0, height, 0.0],
                ]
                .map(|p| side * DVec3::from(p))
            };
            assert_eq!(Plane::newell(&sliver(height)), None);
            let plane = Plane::newell(&sliver(2.0 * height)).unwrap();
            assert_eq!((plane.normal, plane.d), (DVec3::Z, 0.0));
        }
    }
}
