//! The sphere's quadratic (iii): coefficients, and which root counts.

use crate::geometry::{
    QuadraticTest, Ray, Root, RootVerdict, Roots, Sides, Sphere, TRange, hidden_side, verdict_of,
};
use crate::mistake::{Mistake, Wrong};

pub(super) const MISTAKES: &[Mistake] = &[
    Mistake {
        name: "half b in the full formula",
        sentence: "b lacks its factor 2, but the formula is still the one with b² − 4ac and 2a.",
        spoils: "b",
        wrong: Wrong::SphereTest(half_b_in_the_full_formula),
    },
    Mistake {
        name: "c − o without the turned sign",
        sentence: "b is formed with center − origin instead of origin − center, so both roots change their sign.",
        spoils: "b",
        wrong: Wrong::SphereTest(center_minus_origin),
    },
    Mistake {
        name: "graze is two hits",
        sentence: "A discriminant of 0 is taken for two roots, although the ray touches the sphere at one point.",
        spoils: "roots",
        wrong: Wrong::SphereTest(graze_is_two_hits),
    },
    Mistake {
        name: "first root always",
        sentence: "The smaller root is taken, even if it lies behind the origin.",
        spoils: "t",
        wrong: Wrong::Root(first_root_always),
    },
    Mistake {
        name: "largest root",
        sentence: "The larger root is taken, where the ray leaves the sphere.",
        spoils: "t",
        wrong: Wrong::Root(largest_root),
    },
    Mistake {
        name: "inside is a miss",
        sentence: "A sphere whose smaller root lies behind the origin counts as missed.",
        spoils: "t",
        wrong: Wrong::Root(inside_is_a_miss),
    },
];

/// The roots by the formula as it is printed, t = (−b ± √(b² − 4ac)) / 2a.
fn by_formula([a, b, c]: [f64; 3], range: TRange, sides: Sides) -> QuadraticTest {
    let discriminant = b * b - 4.0 * a * c;
    let judged = |t, entering| {
        let verdict = match verdict_of(t, range) {
            place @ (RootVerdict::Behind | RootVerdict::BelowEpsilon) => place,
            place => hidden_side(entering, sides).unwrap_or(place),
        };
        Root { t, verdict }
    };
    let [near, far] = [-1.0, 1.0].map(|sign| (-b + sign * discriminant.sqrt()) / (2.0 * a));
    let roots = if discriminant < 0.0 || a <= 0.0 {
        Roots::None
    } else if discriminant == 0.0 {
        Roots::Graze(judged(near, true))
    } else {
        two(judged(near, true), judged(far, false))
    };
    QuadraticTest {
        a,
        b,
        c,
        discriminant,
        roots,
    }
}

/// Two roots, of which at most one is chosen.
fn two(near: Root, mut far: Root) -> Roots {
    if near.verdict == RootVerdict::Chosen && far.verdict == RootVerdict::Chosen {
        far.verdict = RootVerdict::BeyondNearest;
    }
    Roots::Two { near, far }
}

fn half_b_in_the_full_formula(
    sphere: &Sphere,
    ray: &Ray,
    range: TRange,
    sides: Sides,
) -> QuadraticTest {
    let QuadraticTest { a, b, c, .. } = sphere.test(ray, range, sides);
    by_formula([a, 0.5 * b, c], range, sides)
}

fn center_minus_origin(sphere: &Sphere, ray: &Ray, range: TRange, sides: Sides) -> QuadraticTest {
    let QuadraticTest { a, b, c, .. } = sphere.test(ray, range, sides);
    by_formula([a, -b, c], range, sides)
}

fn graze_is_two_hits(sphere: &Sphere, ray: &Ray, range: TRange, sides: Sides) -> QuadraticTest {
    let mut test = sphere.test(ray, range, sides);
    if let Roots::Graze(root) = test.roots {
        test.roots = two(root, root);
    }
    test
}

/// Both roots of the right test, or a graze twice.
fn roots(sphere: &Sphere, ray: &Ray, range: TRange, sides: Sides) -> Option<[Root; 2]> {
    let roots = sphere.test(ray, range, sides).roots;
    Some([roots.iter().next()?, roots.iter().last()?])
}

fn first_root_always(sphere: &Sphere, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
    let [near, _] = roots(sphere, ray, range, sides)?;
    Some(near.t)
}

fn largest_root(sphere: &Sphere, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
    let [_, far] = roots(sphere, ray, range, sides)?;
    (verdict_of(far.t, range) == RootVerdict::Chosen).then_some(far.t)
}

fn inside_is_a_miss(sphere: &Sphere, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
    let [near, _] = roots(sphere, ray, range, sides)?;
    (near.verdict == RootVerdict::Chosen).then_some(near.t)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    const UNIT: Sphere = Sphere {
        center: DVec3::ZERO,
        radius: 1.0,
    };

    /// Along −z from this point.
    fn down(x: f64, z: f64) -> Ray {
        Ray::new(DVec3::new(x, 0.0, z), DVec3::NEG_Z)
    }

    /// From z = 6: a = 1, b = −12, c = 35, the roots are (12 ∓ 2)/2 = 5 and 7. From the centre: b = 0, the roots ±1.
    #[test]
    fn b_without_its_factor_loses_the_hit_and_with_the_wrong_sign_turns_it_round() {
        let of = |test: fn(&Sphere, &Ray, TRange, Sides) -> QuadraticTest, z| {
            let test = test(&UNIT, &down(0.0, z), TRange::FORWARD, Sides::Both);
            (
                test.b,
                test.discriminant,
                test.roots.iter().map(|root| root.t).collect::<Vec<_>>(),
            )
        };
        let right = |sphere: &Sphere, ray: &Ray, range, sides| sphere.test(ray, range, sides);
        assert_eq!(of(right, 6.0), (-12.0, 4.0, vec![5.0, 7.0]));
        // 36 − 140
        assert_eq!(of(half_b_in_the_full_formula, 6.0), (-6.0, -104.0, vec![]));
        assert_eq!(of(center_minus_origin, 6.0), (12.0, 4.0, vec![-7.0, -5.0]));
        for wrong in [half_b_in_the_full_formula, center_minus_origin] {
            assert_eq!(of(wrong, 0.0).2, of(right, 0.0).2);
        }
    }

    #[test]
    fn a_graze_has_one_root_and_not_two() {
        // b = −10, c = 1 + 25 − 1 = 25: 100 − 100
        let count = |test: fn(&Sphere, &Ray, TRange, Sides) -> QuadraticTest, x| {
            let test = test(&UNIT, &down(x, 5.0), TRange::FORWARD, Sides::Both);
            (test.roots.iter().count(), test.roots.chosen())
        };
        let right = |sphere: &Sphere, ray: &Ray, range, sides| sphere.test(ray, range, sides);
        assert_eq!(count(right, 1.0), (1, Some(5.0)));
        assert_eq!(count(graze_is_two_hits, 1.0), (2, Some(5.0)));
        assert_eq!(count(graze_is_two_hits, 0.0), (2, Some(4.0)));
        assert_eq!(count(graze_is_two_hits, 2.0), (0, None));
    }

    #[test]
    fn the_root_that_counts_depends_on_where_the_ray_starts() {
        // from z = 6: 5 and 7; from z = ½, inside: −½ and 1½; from z = −6: both behind
        let of = |root: fn(&Sphere, &Ray, TRange, Sides) -> Option<f64>| {
            [6.0, 0.5, -6.0].map(|z| root(&UNIT, &down(0.0, z), TRange::FORWARD, Sides::Both))
        };
        let right = |sphere: &Sphere, ray: &Ray, range, sides| {
            sphere.test(ray, range, sides).roots.chosen()
        };
        assert_eq!(of(right), [Some(5.0), Some(1.5), None]);
        assert_eq!(of(first_root_always), [Some(5.0), Some(-0.5), Some(-7.0)]);
        assert_eq!(of(largest_root), [Some(7.0), Some(1.5), None]);
        assert_eq!(of(inside_is_a_miss), [Some(5.0), None, None]);
    }
}
