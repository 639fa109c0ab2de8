//! The quadratic a·t² + b·t + c = 0, solved without cancellation.
//!
//! The slides solve (iii) with the quadratic formula t = (−b ± √(b² − 4ac)) / 2a. Two of its
//! subtractions can lose every digit. Both are avoided here for all shapes alike:
//! - b² − 4ac, when the ray passes near the edge of a surface. Each shape hands in the discriminant in a
//!   form that subtracts two squares of lengths instead (see the shapes' own derivations), and the
//!   larger of them, against which "zero" is measured;
//! - −b + √…, when b is large (a small far sphere, or an origin close to a huge one). The root in which
//!   −b and the square root have one sign is computed first; the other follows from t₁·t₂ = c/a.

use crate::geometry::root::{hidden_side, judged, two_roots};
use crate::geometry::{RootVerdict, Roots, Sides, TRange};

/// A ray grazes a surface if its discriminant is within this share of its larger term.
///
/// 4ε: what is left is the rounding of the two squares. Two roots that this takes for one lie within
/// 4·√ε radii of each other.
pub const GRAZE: f64 = 4.0 * f64::EPSILON;

/// What the quadratic of a ray and a surface of second degree gave: sphere, ellipsoid or cone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct QuadraticTest {
    /// The coefficient of t².
    pub a: f64,
    /// The coefficient of t, with its factor 2.
    pub b: f64,
    /// The constant term: negative if the ray starts inside.
    pub c: f64,
    /// b² − 4ac: above 0 with two real roots, below 0 with none.
    pub discriminant: f64,
    /// The roots and what became of each.
    pub roots: Roots,
}

/// The coefficients of (iii), or of its like for another surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quadratic {
    /// a, exactly 0 where it is nothing but rounding. That is for the shape to say, which knows what entered: a
    /// difference, as for a cone, can be 0; a sum of squares, as for sphere and ellipsoid, is 0 only for a direction
    /// of zero.
    pub(super) a: f64,
    /// b, with its factor 2.
    pub(super) b: f64,
    pub(super) c: f64,
    /// b² − 4ac.
    pub(super) discriminant: f64,
    /// The larger of the two terms that the discriminant is the difference of.
    pub(super) scale: f64,
}

impl Quadratic {
    /// The equation with its roots.
    #[inline]
    pub(super) fn test(
        &self,
        range: TRange,
        sides: Sides,
        beyond_ends: impl Fn(f64) -> bool,
    ) -> QuadraticTest {
        QuadraticTest {
            a: self.a,
            b: self.b,
            c: self.c,
            discriminant: self.discriminant,
            roots: self.roots(range, sides, beyond_ends),
        }
    }

    /// The real roots and their verdicts.
    ///
    /// `beyond_ends` says whether the surface ends before t.
    #[inline]
    fn roots(&self, range: TRange, sides: Sides, beyond_ends: impl Fn(f64) -> bool) -> Roots {
        let judge = |t, entering| {
            judged(t, range, |t| {
                if beyond_ends(t) {
                    return Some(RootVerdict::BeyondEnds);
                }
                hidden_side(entering, sides)
            })
        };
        match self.real_roots() {
            RealRoots::None => Roots::None,
            RealRoots::Linear { t, entering } => Roots::Linear(judge(t, entering)),
            RealRoots::Graze(t) => Roots::Graze(judge(t, true)),
            RealRoots::Two {
                t: [near, far],
                near_enters,
            } => two_roots(judge(near, near_enters), judge(far, !near_enters)),
        }
    }

    /// The roots, whatever lies there.
    ///
    /// The surface is passed from outside to inside where a·t² + b·t + c falls: at the nearer root if
    /// a > 0. Coefficients that are not finite (a product beyond f64) give no root.
    #[inline]
    pub(crate) fn real_roots(&self) -> RealRoots {
        // most rays pass by: only this much is done for each of them
        let real = -GRAZE * self.scale <= self.discriminant && self.discriminant.is_finite();
        if !real {
            return RealRoots::None;
        }

        // a = 0: b·t + c = 0
        if self.a == 0.0 {
            let t = -self.c / self.b;
            if !t.is_finite() {
                return RealRoots::None;
            }
            let entering = self.b < 0.0;
            return RealRoots::Linear { t, entering };
        }

        // one double root, at the vertex of the parabola
        if self.discriminant <= GRAZE * self.scale {
            return RealRoots::Graze(-self.b / (2.0 * self.a));
        }

        // two: q has no cancellation, and t₁·t₂ = c/a gives the other
        let q = -0.5 * (self.b + self.discriminant.sqrt().copysign(self.b));
        let (t1, t2) = (self.c / q, q / self.a);
        RealRoots::Two {
            t: if t2 < t1 { [t2, t1] } else { [t1, t2] },
            near_enters: self.a > 0.0,
        }
    }
}

/// The real roots of (iii), or of its like, and whether the surface is entered there.
#[derive(Clone, Copy, Debug)]
pub(crate) enum RealRoots {
    /// None.
    None,
    /// One, of a linear equation.
    Linear { t: f64, entering: bool },
    /// A double root.
    Graze(f64),
    /// Two, the smaller first.
    Two { t: [f64; 2], near_enters: bool },
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Root;

    /// t² − 6t + c, with a discriminant and a scale of their own.
    fn roots(discriminant: f64, scale: f64) -> Roots {
        let equation = Quadratic {
            a: 1.0,
            b: -6.0,
            c: 9.0 - 0.25 * discriminant,
            discriminant,
            scale,
        };
        let test = equation.test(TRange::FORWARD, Sides::Both, |_| false);
        test.roots
    }

    #[test]
    fn the_tolerance_itself_is_a_graze_and_the_next_number_beyond_it_is_not() {
        // 4ε of the scale: 2⁻⁵⁰·64 = 2⁻⁴⁴
        let tolerance = 2.0_f64.powi(-44);
        let graze = Roots::Graze(Root {
            t: 3.0,
            verdict: RootVerdict::Chosen,
        });
        for discriminant in [-tolerance, 0.0, tolerance] {
            assert_eq!(roots(discriminant, 64.0), graze, "{discriminant}");
        }
        assert_eq!(roots((-tolerance).next_down(), 64.0), Roots::None);
        let two = roots(tolerance.next_up(), 64.0);
        assert!(matches!(two, Roots::Two { .. }), "{two:?}");
    }

    #[test]
    fn a_root_beside_a_huge_one_keeps_its_digits() {
        // t² ∓ 2⁴⁰·t + 1: the roots are 2⁻⁴⁰ and 2⁴⁰ within 10⁻²⁴ of themselves
        let (small, large) = (2.0_f64.powi(-40), 2.0_f64.powi(40));
        for sign in [1.0, -1.0] {
            let discriminant = large * large - 4.0;
            let equation = Quadratic {
                a: 1.0,
                b: -sign * large,
                c: 1.0,
                discriminant,
                scale: large * large,
            };
            let test = equation.test(TRange::FORWARD, Sides::Both, |_| false);
            let mut found: Vec<f64> = test.roots.iter().map(|root| root.t).collect();
            found.sort_by(|s, t| s.abs().total_cmp(&t.abs()));
            assert_eq!(found, [sign * small, sign * large]);
        }
    }

    #[test]
    fn a_graze_lies_at_the_vertex_of_the_parabola() {
        // 4t² − 20t + 25 = (2t − 5)²
        let equation = Quadratic {
            a: 4.0,
            b: -20.0,
            c: 25.0,
            discriminant: 0.0,
            scale: 400.0,
        };
        let graze = Root {
            t: 2.5,
            verdict: RootVerdict::Chosen,
        };
        let test = equation.test(TRange::FORWARD, Sides::Both, |_| false);
        assert_eq!(test.roots, Roots::Graze(graze));
    }
}
