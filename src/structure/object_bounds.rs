//! The volume around an object of each kind: closed forms for what is round or square, and for polygons and
//! meshes the smallest sphere and the ellipsoid of least volume around their vertices.
//!
//! Each is that of the object itself, and as thick as bent polygons are: the room for rounding comes with the ray
//! ([`VolumeRay`](crate::structure::VolumeRay)).

use glam::DVec3;

use crate::geometry::{AxisBox, Cone, Ellipsoid, OrientedEllipsoid, Sphere};
use crate::scene::{Primitive, Shape};
use crate::structure::extent::thickness;
use crate::structure::least_ellipsoid::{LeastEllipsoid, least_ellipsoid};
use crate::structure::smallest_sphere::smallest_sphere;
use crate::structure::{SlabBound, SlabSet};

/// The third half axis of the ellipsoid around something flat, as a share of the first.
///
/// The least volume around something flat is 0, so any thickness is as good. A thousandth looks flat and
/// lets one in a thousand more rays in; much thinner, and rounding would count in the test.
pub(super) const THICKNESS: f64 = 1e-3;

/// No half axis is shorter than so many times the thickness of bent polygons; the rest grows by a sixteenth at most
/// to make room for that.
const ROOM: f64 = 16.0;

/// The smallest sphere around an object; `None` around a mesh without faces.
pub(super) fn sphere_around(primitives: &[Primitive]) -> Option<Sphere> {
    let smallest = match primitives {
        [only] => match &only.shape {
            Shape::Sphere(sphere) => *sphere,
            Shape::Ellipsoid(Ellipsoid { center, radii }) => Sphere {
                center: *center,
                radius: radii.max_element(),
            },
            Shape::Box(AxisBox { min, max }) => Sphere {
                center: 0.5 * (*min + *max),
                radius: 0.5 * (*max - *min).length(),
            },
            Shape::Cone(cone) => sphere_around_cone(cone),
            Shape::Polygon(_) => smallest_sphere(&vertices(primitives))?,
        },
        faces => smallest_sphere(&vertices(faces))?,
    };
    Some(Sphere {
        radius: smallest.radius + thickest(primitives),
        ..smallest
    })
}

/// The ellipsoid of least volume around an object; `None` around a mesh without faces.
///
/// Around something flat it is the ellipse of least area in the plane, and [`THICKNESS`] thick.
pub(super) fn ellipsoid_around(primitives: &[Primitive]) -> Option<OrientedEllipsoid> {
    let upright = |center, radii| LeastEllipsoid {
        ellipsoid: OrientedEllipsoid {
            center,
            axes: DVec3::AXES,
            radii,
        },
        off_plane: None,
    };
    // points too near to a line for an ellipsoid, were there such, would still have a sphere
    let of_points = |points: &[DVec3], is_flat| {
        least_ellipsoid(points, is_flat).or_else(|| {
            let Sphere { center, radius } = smallest_sphere(points)?;
            Some(upright(center, DVec3::splat(radius)))
        })
    };
    let least = match primitives {
        [only] => match &only.shape {
            Shape::Sphere(sphere) => upright(sphere.center, DVec3::splat(sphere.radius)),
            Shape::Ellipsoid(ellipsoid) => upright(ellipsoid.center, ellipsoid.radii),
            // the sphere around a cube, stretched with it
            Shape::Box(AxisBox { min, max }) => {
                upright(0.5 * (*min + *max), 0.5 * (*max - *min) * 3.0_f64.sqrt())
            }
            Shape::Cone(cone) => LeastEllipsoid {
                ellipsoid: ellipsoid_around_cone(cone),
                off_plane: None,
            },
            Shape::Polygon(_) => of_points(&vertices(primitives), true)?,
        },
        faces => of_points(&vertices(faces), false)?,
    };
    Some(with_room(least, thickest(primitives)))
}

/// The intersection of slabs around an object; around a mesh without faces the bound of nothing.
pub(super) fn slabs_around<const N: usize>(
    primitives: &[Primitive],
    set: &SlabSet<N>,
) -> SlabBound<N> {
    primitives
        .iter()
        .map(|primitive| SlabBound::of(&primitive.shape, set))
        .fold(SlabBound::EMPTY, |sum, bound| sum.union(&bound))
}

/// The sphere around two circles on one axis, at the heights 0 and h over the base.
///
/// At the height (h² + r_apex² − r_base²)/2h both rims are equally far. If that is beyond an end, the rim
/// there holds the other one within the sphere of its own radius.
fn sphere_around_cone(cone: &Cone) -> Sphere {
    let (height, [base, apex]) = (cone.height(), cone.radii());
    let even = 0.5 * (height + (apex - base) * (apex + base) / height);
    let at = even.clamp(0.0, height);
    Sphere {
        center: cone.base() + at * cone.axis(),
        radius: at.hypot(base).max((height - at).hypot(apex)),
    }
}

/// The ellipsoid of least volume around two circles on one axis, R ≥ r and h apart.
///
/// Like all it holds, it is round about the axis. If the smaller circle has the weight λ and the larger one
/// 1 − λ, the ellipsoid of that covariance has its center at λh from the larger circle, the half axis
/// h·√(3λ(1 − λ)) along the axis, and the radius √(3/2·((1 − λ)R² + λr²)) across. It is the least where
/// 4Kλ² − (3K + 2)λ + 1 = 0, with K = 1 − (r/R)², and λ the smaller root: ½ for a cylinder, ¼ for a tip.
fn ellipsoid_around_cone(cone: &Cone) -> OrientedEllipsoid {
    let (height, [base, apex]) = (cone.height(), cone.radii());
    let (wide, narrow) = if apex <= base {
        (base, apex)
    } else {
        (apex, base)
    };
    let ratio = narrow / wide;
    let k = 1.0 - ratio * ratio;
    let b = 3.0 * k + 2.0;
    // 2c/(b + √…) in place of (b − √…)/2a: nothing cancels, and the cylinder's K = 0 needs no case
    let share = 2.0 / (b + (b * b - 16.0 * k).sqrt());
    let from_base = if apex <= base { share } else { 1.0 - share };
    let along = height * (3.0 * share * (1.0 - share)).sqrt();
    let across = wide * (1.5 * ((1.0 - share) + share * ratio * ratio)).sqrt();
    let (u, v) = cone.axis().any_orthonormal_pair();
    OrientedEllipsoid {
        center: cone.base() + from_base * height * cone.axis(),
        axes: [cone.axis(), u, v],
        radii: DVec3::new(along, across, across),
    }
}

/// All vertices of the faces of a mesh; those of neighbours several times.
fn vertices(faces: &[Primitive]) -> Vec<DVec3> {
    faces
        .iter()
        .filter_map(|face| match &face.shape {
            Shape::Polygon(polygon) => Some(polygon.vertices()),
            _ => None,
        })
        .flatten()
        .collect()
}

/// How far hits may lie off the extent of the vertices of bent polygons; 0 without such.
fn thickest(primitives: &[Primitive]) -> f64 {
    let of = |primitive: &Primitive| thickness(&primitive.shape);
    primitives.iter().map(of).fold(0.0, f64::max)
}

/// The ellipsoid with room for hits that lie off the object by some distance, in any direction.
///
/// Seen from the unit sphere's space a distance d is at most d/r, r the smallest half axis: a factor of
/// 1 + d/r holds it. Flat points have 0 as their third coordinate but for what they are off their plane, so
/// there both errors add up as the sides of a right triangle, and the thickness costs next to nothing.
fn with_room(least: LeastEllipsoid, distance: f64) -> OrientedEllipsoid {
    let LeastEllipsoid {
        mut ellipsoid,
        off_plane,
    } = least;
    let radii = ellipsoid.radii.max(DVec3::splat(ROOM * distance));
    let Some(off_plane) = off_plane else {
        ellipsoid.radii = radii * (1.0 + distance / radii.min_element());
        return ellipsoid;
    };
    let off = off_plane + distance;
    let thickness = (THICKNESS * radii.x).max(ROOM * off);
    let within = 1.0 + distance / radii.x.min(radii.y);
    ellipsoid.radii = radii.with_z(thickness) * within.hypot(off / thickness);
    ellipsoid
}
