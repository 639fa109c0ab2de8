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
use crate::geometry::{Fate, Roots, Sides, TRange};

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
    /// b² − 4ac.
    pub discriminant: f64,
    /// The roots and what became of each.
    pub roots: Roots,
}

/// The coefficients of (iii), or of its like for another surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quadratic {
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

    /// The real roots and their fates.
    ///
    /// The surface is passed from outside to inside where a·t² + b·t + c falls: at the nearer root if
    /// a > 0. `beyond_ends` says whether the surface ends before t. Coefficients that are not finite
    /// (a product beyond f64) give no root.
    #[inline]
    fn roots(&self, range: TRange, sides: Sides, beyond_ends: impl Fn(f64) -> bool) -> Roots {
        // most rays pass by: only this much is done for each of them
        let real = -GRAZE * self.scale <= self.discriminant && self.discriminant.is_finite();
        if !real {
            return Roots::None;
        }
        self.real_roots(range, |t, entering| {
            if beyond_ends(t) {
                return Some(Fate::BeyondEnds);
            }
            hidden_side(entering, sides)
        })
    }

    /// The roots of an equation that has some.
    fn real_roots(&self, range: TRange, refused: impl Fn(f64, bool) -> Option<Fate>) -> Roots {
        // a = 0: b·t + c = 0
        if self.a == 0.0 {
            let t = -self.c / self.b;
            if !t.is_finite() {
                return Roots::None;
            }
            return Roots::Linear(judged(t, range, |t| refused(t, self.b < 0.0)));
        }

        // one double root, at the vertex of the parabola
        if self.discriminant <= GRAZE * self.scale {
            let t = -self.b / (2.0 * self.a);
            return Roots::Graze(judged(t, range, |t| refused(t, true)));
        }

        // two: q has no cancellation, and t₁·t₂ = c/a gives the other
        let q = -0.5 * (self.b + self.discriminant.sqrt().copysign(self.b));
        let (t1, t2) = (self.c / q, q / self.a);
        let ordered = if t2 < t1 { [t2, t1] } else { [t1, t2] };
        two_roots(ordered, range, refused, self.a > 0.0)
    }
}
