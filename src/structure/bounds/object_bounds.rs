//! The volume around an object of each kind: closed forms for what is round or square, and for polygons and
//! meshes the smallest sphere and the ellipsoid of least volume around their vertices.
//!
//! Each is that of the object itself, and as thick as bent polygons are: the room for rounding comes with the ray
//! ([`VolumeRay`](crate::structure::VolumeRay)).

use glam::DVec3;

use crate::geometry::{AxisBox, Cone, Ellipsoid, OrientedEllipsoid, Sphere};
use crate::scene::{Primitive, Shape};
use crate::structure::bounds::extent::thickness;
use crate::structure::bounds::least_ellipsoid::{LeastEllipsoid, least_ellipsoid};
use crate::structure::bounds::smallest_sphere::smallest_sphere;
use crate::structure::{SlabBound, SlabSet};

/// The third half axis of the ellipsoid around something flat, as a share of the first.
///
/// The least volume around something flat is 0, so any thickness is as good. A thousandth looks flat and
/// lets one in a thousand more rays in; much thinner, and rounding would count in the test.
pub(in crate::structure) const THICKNESS: f64 = 1e-3;

/// No half axis is shorter than this multiple of the thickness of bent polygons; the rest grows by a sixteenth at most
/// to make room for that.
const ROOM: f64 = 16.0;

/// The smallest sphere around an object; `None` around a mesh without faces.
pub(in crate::structure) fn sphere_around(primitives: &[Primitive]) -> Option<Sphere> {
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
pub(in crate::structure) fn ellipsoid_around(
    primitives: &[Primitive],
) -> Option<OrientedEllipsoid> {
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
pub(in crate::structure) fn slabs_around<const N: usize>(
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
        radius: libm::hypot(at, base).max(libm::hypot(height - at, apex)),
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
    ellipsoid.radii = radii.with_z(thickness) * libm::hypot(within, off / thickness);
    ellipsoid
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use crate::scene::small_scene::{polygon, scene_of, solid, sphere};

    /// A few roundings of numbers up to 10.
    const ROUNDED: f64 = 1e-14;

    #[track_caller]
    fn check_sphere(scene: &Scene, center: [f64; 3], radius: f64) {
        let found = sphere_around(&scene.primitives).unwrap();
        let off = (found.center - DVec3::from(center)).length();
        assert!(
            off <= ROUNDED && (found.radius - radius).abs() <= ROUNDED,
            "{found:?}"
        );
    }

    /// The half axes as they come: along the cone's axis first, along x, y, z of what stands upright.
    #[track_caller]
    fn check_ellipsoid(found: &OrientedEllipsoid, center: [f64; 3], radii: [f64; 3]) {
        let off = (found.center - DVec3::from(center)).length();
        let off_radii = (found.radii - DVec3::from(radii)).abs().max_element();
        assert!(off <= ROUNDED && off_radii <= ROUNDED, "{found:?}");
    }

    fn ellipsoid_of(scene: &Scene) -> OrientedEllipsoid {
        ellipsoid_around(&scene.primitives).unwrap()
    }

    fn cone(base: [f64; 3], base_radius: f64, apex: [f64; 3], apex_radius: f64) -> Scene {
        scene_of(&[format!(
            r#"{{"cone":{{"base":{base:?},"base_radius":{base_radius:?},
            "apex":{apex:?},"apex_radius":{apex_radius:?}}}}}"#
        )])
    }

    #[test]
    fn a_box_from_1_2_3_to_3_6_7_has_a_sphere_of_radius_3_and_root_3_times_half_its_sides() {
        let scene = scene_of(&[solid([1.0, 2.0, 3.0], [3.0, 6.0, 7.0])]);
        // sides 2, 4, 4: the diagonal is 6
        check_sphere(&scene, [2.0, 4.0, 5.0], 3.0);
        let root = 3.0_f64.sqrt();
        let radii = [root, 2.0 * root, 2.0 * root];
        check_ellipsoid(&ellipsoid_of(&scene), [2.0, 4.0, 5.0], radii);
    }

    #[test]
    fn a_sphere_is_its_own_volume_and_an_ellipsoid_its_own_ellipsoid() {
        let scene = scene_of(&[sphere([1.0, 2.0, 3.0], 4.0)]);
        check_sphere(&scene, [1.0, 2.0, 3.0], 4.0);
        check_ellipsoid(&ellipsoid_of(&scene), [1.0, 2.0, 3.0], [4.0; 3]);
        let scene = scene_of(&[r#"{"ellipsoid":{"center":[1,2,3],"radii":[2,5,4]}}"#.to_string()]);
        check_sphere(&scene, [1.0, 2.0, 3.0], 5.0);
        check_ellipsoid(&ellipsoid_of(&scene), [1.0, 2.0, 3.0], [2.0, 5.0, 4.0]);
    }

    #[test]
    fn the_sphere_around_a_cone_touches_both_rims_or_has_the_wider_one_as_its_equator() {
        // a cylinder: its half height 2 and its radius 1.5 give 2.5
        let cylinder = cone([1.0, 2.0, 3.0], 1.5, [1.0, 2.0, 7.0], 1.5);
        check_sphere(&cylinder, [1.0, 2.0, 5.0], 2.5);
        // (81 − 9)/18 = 4 above the base: 4² + 3² = 5², and 9 − 4 = 5 to the tip
        let steep = cone([1.0, 2.0, 3.0], 3.0, [1.0, 2.0, 12.0], 0.0);
        check_sphere(&steep, [1.0, 2.0, 7.0], 5.0);
        let turned = cone([1.0, 2.0, 3.0], 0.0, [1.0, 2.0, 12.0], 3.0);
        check_sphere(&turned, [1.0, 2.0, 8.0], 5.0);
        // (36 + 4 − 16)/12 = 2 above the base: 2² + 4² = 4² + 2²
        let cut_off = cone([1.0, 1.0, 1.0], 4.0, [7.0, 1.0, 1.0], 2.0);
        check_sphere(&cut_off, [3.0, 1.0, 1.0], 20.0_f64.sqrt());
        // (4 − 16)/4 lies below the base
        let flat = cone([1.0, 2.0, 3.0], 4.0, [1.0, 2.0, 5.0], 0.0);
        check_sphere(&flat, [1.0, 2.0, 3.0], 4.0);
        let flat = cone([1.0, 2.0, 3.0], 0.0, [1.0, 2.0, 5.0], 4.0);
        check_sphere(&flat, [1.0, 2.0, 5.0], 4.0);
    }

    #[test]
    fn the_least_ellipsoid_around_a_cone_has_the_published_share_of_its_height() {
        let root = f64::sqrt;
        // a cylinder: λ = ½, 4·√¾ along and 2·√1.5 across
        let cylinder = ellipsoid_of(&cone([1.0, 2.0, 3.0], 2.0, [1.0, 2.0, 7.0], 2.0));
        let radii = [2.0 * root(3.0), root(6.0), root(6.0)];
        check_ellipsoid(&cylinder, [1.0, 2.0, 5.0], radii);
        assert_eq!(cylinder.axes[0], DVec3::Z);
        // a tip: λ = ¼, 8·√(9/16) along and 2·√(9/8) across
        let radii = [6.0, root(4.5), root(4.5)];
        let tip = ellipsoid_of(&cone([1.0, 2.0, 3.0], 2.0, [9.0, 2.0, 3.0], 0.0));
        check_ellipsoid(&tip, [3.0, 2.0, 3.0], radii);
        let turned = ellipsoid_of(&cone([1.0, 2.0, 3.0], 0.0, [9.0, 2.0, 3.0], 2.0));
        check_ellipsoid(&turned, [7.0, 2.0, 3.0], radii);
        // K = 1 − 5/9 = 4/9: 16/9·λ² − 10/3·λ + 1 = 0, λ = 3/8; 8·√(45/64) along, 3·√(5/4) across
        let radii = [3.0 * root(5.0), 1.5 * root(5.0), 1.5 * root(5.0)];
        let cut_off = ellipsoid_of(&cone([1.0, 2.0, 3.0], 3.0, [9.0, 2.0, 3.0], root(5.0)));
        check_ellipsoid(&cut_off, [4.0, 2.0, 3.0], radii);
    }

    #[test]
    fn a_rectangle_has_the_ellipse_of_least_area_and_a_thousandth_of_its_length_as_thickness() {
        let corners = [
            [1.0, 1.0, 5.0],
            [9.0, 1.0, 5.0],
            [9.0, 5.0, 5.0],
            [1.0, 5.0, 5.0],
        ];
        let scene = scene_of(&[polygon(&corners)]);
        check_sphere(&scene, [5.0, 3.0, 5.0], 20.0_f64.sqrt());
        // half sides 4 and 2, each times √2
        let long = 4.0 * 2.0_f64.sqrt();
        let found = ellipsoid_of(&scene);
        let off = (found.radii - DVec3::new(long, 0.5 * long, 0.001 * long)).abs();
        // the weights are within 10⁻⁹ of the best
        assert!(off.max_element() <= 1e-7, "{found:?}");
        assert!((found.center - DVec3::new(5.0, 3.0, 5.0)).length() <= 1e-8);
        assert!(found.axes[0].x.abs() >= 1.0 - 1e-8, "{found:?}");
    }

    #[test]
    fn the_volumes_around_a_bent_polygon_are_thicker_by_its_play() {
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 4e-6], [0.0, 1.0, 0.0]];
        let scene = scene_of(&[polygon(&corners)]);
        let found = sphere_around(&scene.primitives).unwrap();
        // a vertex off by 10⁻⁶ under 1 in 64; the diagonal is longer than √2 by (4·10⁻⁶)²
        let off = found.radius - (0.5_f64.sqrt() + 64e-6);
        assert!(off.abs() <= 1e-10, "{found:?}");
        assert_eq!(thickest(&[]), 0.0);
    }

    #[test]
    fn a_mesh_without_faces_has_no_volume() {
        assert_eq!(sphere_around(&[]), None);
        assert_eq!(ellipsoid_around(&[]), None);
        assert_eq!(slabs_around(&[], &SlabSet::AXES), SlabBound::EMPTY);
    }

    #[test]
    fn the_slabs_around_several_faces_go_from_the_smallest_to_the_largest_extent() {
        let scene = scene_of(&[
            solid([1.0, 2.0, 3.0], [3.0, 6.0, 7.0]),
            solid([2.0, -1.0, 4.0], [5.0, 0.0, 5.0]),
        ]);
        // D_min = −largest, D_max = −smallest
        let bound = SlabBound {
            d_min: [-5.0, -6.0, -7.0],
            d_max: [-1.0, 1.0, -3.0],
        };
        assert_eq!(slabs_around(&scene.primitives, &SlabSet::AXES), bound);
    }

    fn least(radii: [f64; 3], off_plane: Option<f64>) -> LeastEllipsoid {
        LeastEllipsoid {
            ellipsoid: OrientedEllipsoid {
                center: DVec3::ONE,
                axes: DVec3::AXES,
                radii: radii.into(),
            },
            off_plane,
        }
    }

    #[test]
    fn an_ellipsoid_with_room_grows_by_the_room_s_share_of_its_smallest_half_axis() {
        let round = least([2.0, 4.0, 8.0], None);
        check_ellipsoid(&with_room(round, 0.0), [1.0; 3], [2.0, 4.0, 8.0]);
        // 0.1 of 2 is a twentieth
        check_ellipsoid(&with_room(round, 0.1), [1.0; 3], [2.1, 4.2, 8.4]);
        // no half axis is below 16 times the room, which is a sixteenth of that
        check_ellipsoid(&with_room(round, 0.25), [1.0; 3], [4.25, 4.25, 8.5]);
    }

    #[test]
    fn a_flat_ellipsoid_with_room_is_thick_enough_for_what_lies_off_its_plane() {
        let flat = |off| least([3.0, 2.0, 0.0], Some(off));
        check_ellipsoid(&with_room(flat(0.0), 0.0), [1.0; 3], [3.0, 2.0, 0.003]);
        // 0.03 off the plane: 16·0.03 thick, and 1/16 of that off
        let grown = 1.0_f64.hypot(1.0 / 16.0);
        let radii = [3.0, 2.0, 0.48].map(|radius| radius * grown);
        check_ellipsoid(&with_room(flat(0.03), 0.0), [1.0; 3], radii);
        // and hits 0.1 off in any direction: 0.13 off the plane, 0.1 of 2 within it
        let grown = 1.05_f64.hypot(1.0 / 16.0);
        let radii = [3.0, 2.0, 2.08].map(|radius| radius * grown);
        check_ellipsoid(&with_room(flat(0.03), 0.1), [1.0; 3], radii);
    }
}
