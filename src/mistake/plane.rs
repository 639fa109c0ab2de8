//! The plane (v).

use crate::geometry::{Polygon, Ray, RootVerdict, Sides, TRange, hidden_side, verdict_of};
use crate::mistake::{Mistake, Wrong};

pub(super) const MISTAKES: &[Mistake] = &[
    Mistake {
        name: "no parallel case",
        sentence: "The denominator of (v) is not compared with 0, so a parallel ray gets t = ±∞ or no number at all.",
        spoils: "t",
        wrong: Wrong::PlaneT(no_parallel_case),
    },
    Mistake {
        name: "negative t kept",
        sentence: "t of a plane behind the origin is taken, although the ray only goes forwards.",
        spoils: "t",
        wrong: Wrong::PlaneT(negative_t_kept),
    },
    Mistake {
        name: "sign of D",
        sentence: "D is subtracted in the numerator of (v) instead of added.",
        spoils: "numerator",
        wrong: Wrong::PlaneT(sign_of_d),
    },
];

/// t, if it counts and the side that is hit can be seen.
fn counted(t: f64, denominator: f64, range: TRange, sides: Sides) -> Option<f64> {
    let is_seen = hidden_side(denominator < 0.0, sides).is_none();
    (is_seen && verdict_of(t, range) == RootVerdict::Chosen).then_some(t)
}

fn no_parallel_case(polygon: &Polygon, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
    let test = polygon.plane_test(ray, range, sides);
    let t = -test.numerator / test.denominator;
    counted(t, test.denominator, range, sides)
}

fn negative_t_kept(polygon: &Polygon, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
    let test = polygon.plane_test(ray, range, sides);
    let t = -test.numerator / test.denominator;
    if t < 0.0 && t.is_finite() {
        return Some(t);
    }
    test.chosen()
}

fn sign_of_d(polygon: &Polygon, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
    let test = polygon.plane_test(ray, range, sides);
    let t = -(test.numerator - 2.0 * test.plane.d) / test.denominator;
    counted(t, test.denominator, range, sides)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    type PlaneT = fn(&Polygon, &Ray, TRange, Sides) -> Option<f64>;

    /// t with the plane y = height, whose normal is +y: D = −height.
    fn of(plane_t: PlaneT, height: f64, from: f64, direction: [f64; 3]) -> Option<f64> {
        let corners = [[-9.0, -9.0], [-9.0, 9.0], [9.0, 9.0], [9.0, -9.0]];
        let corners = corners.map(|[x, z]| DVec3::new(x, height, z)).to_vec();
        let polygon = Polygon::new(corners, None).unwrap();
        let ray = Ray::new(DVec3::new(0.0, from, 0.0), direction.into());
        plane_t(&polygon, &ray, TRange::FORWARD, Sides::Both)
    }

    fn right(polygon: &Polygon, ray: &Ray, range: TRange, sides: Sides) -> Option<f64> {
        polygon.plane_test(ray, range, sides).chosen()
    }

    #[test]
    fn a_plane_counts_if_the_ray_is_not_parallel_and_goes_towards_it() {
        let down = [0.8, -0.6, 0.0];
        // from y = 3 to y = 0: 3 / 0.6
        for plane_t in [right, no_parallel_case, negative_t_kept, sign_of_d] {
            assert_eq!(of(plane_t, 0.0, 3.0, down), Some(5.0));
        }
        // below the floor: −(−3) / 0
        assert_eq!(of(right, 0.0, -3.0, [1.0, 0.0, 0.0]), None);
        let endless = of(no_parallel_case, 0.0, -3.0, [1.0, 0.0, 0.0]);
        assert_eq!(endless, Some(f64::INFINITY));
        // the floor lies behind: −3 / 0.6
        assert_eq!(of(right, 0.0, 3.0, [0.8, 0.6, 0.0]), None);
        assert_eq!(of(negative_t_kept, 0.0, 3.0, [0.8, 0.6, 0.0]), Some(-5.0));
        // y = 1.5 from y = 3: 1.5 / 0.6, and with the other sign of D 4.5 / 0.6
        assert_eq!(of(right, 1.5, 3.0, down), Some(2.5));
        assert_eq!(of(sign_of_d, 1.5, 3.0, down), Some(7.5));
    }
}
