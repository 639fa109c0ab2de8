//! Random shapes, and rays on which two searches disagree, if they ever do.

use glam::DVec3;
use raystep::Scene;
use raystep::geometry::{AxisBox, Cone, Ellipsoid, Polygon, Ray, Sphere};
use raystep::scene::Shape;

use crate::seeded::Seeded;

/// A polygon of three to eight corners, some of them concave, in a plane of any direction.
fn polygon(seeded: &mut Seeded) -> Shape {
    let (middle, normal) = (seeded.point(8.0), seeded.direction());
    let u = seeded.across(normal);
    let v = normal.cross(u);
    let count = seeded.whole(3, 8);
    let corner = |seeded: &mut Seeded, k: i32| {
        let angle = f64::from(k) * std::f64::consts::TAU / f64::from(count);
        let radius = seeded.within(0.5, 3.0);
        middle + radius * (angle.cos() * u + angle.sin() * v)
    };
    let vertices = (0..count).map(|k| corner(seeded, k)).collect();
    Shape::Polygon(Polygon::new(vertices, None).unwrap())
}

/// Any shape, from 0.1 to 3 in size.
pub(super) fn shape(seeded: &mut Seeded) -> Shape {
    let center = seeded.point(8.0);
    let size = |seeded: &mut Seeded| seeded.power(-1.0, 0.5);
    match seeded.index(5) {
        0 => Shape::Sphere(Sphere {
            center,
            radius: size(seeded),
        }),
        1 => Shape::Ellipsoid(Ellipsoid {
            center,
            radii: DVec3::from_array([0; 3].map(|_| size(seeded))),
        }),
        2 => Shape::Box(AxisBox {
            min: center,
            max: center + DVec3::from_array([0; 3].map(|_| size(seeded))),
        }),
        3 => {
            let height = size(seeded);
            let apex = center + height * seeded.direction();
            let radii = [0; 2].map(|_| size(seeded));
            // cones, cylinders and cones with a tip
            let apex_radius = [radii[1], radii[0], 0.0][seeded.index(3)];
            Shape::Cone(Cone::new(center, radii[0], apex, apex_radius).unwrap())
        }
        _ => polygon(seeded),
    }
}

/// A point of the surface, or of its edges, and a direction that runs along it there: a graze.
fn graze(shape: &Shape, seeded: &mut Seeded) -> (DVec3, DVec3) {
    // next to it or exactly on it
    let share = match seeded.index(3) {
        0 => 1.0,
        _ => 1.0 + seeded.sign() * seeded.power(-17.0, -2.0),
    };
    match shape {
        Shape::Sphere(sphere) => {
            let direction = seeded.direction();
            let across = seeded.across(direction);
            (sphere.center + share * sphere.radius * across, direction)
        }
        Shape::Ellipsoid(ellipsoid) => {
            let direction = seeded.direction();
            let across = seeded.across(direction);
            let point = ellipsoid.center + share * ellipsoid.radii * across;
            (point, (ellipsoid.radii * direction).normalize())
        }
        Shape::Box(solid) => {
            // on an edge or a corner, or along a face
            let share =
                DVec3::from_array([0; 3].map(|_| [0.0, 1.0, seeded.unit()][seeded.index(3)]));
            let point = solid.min + share * (solid.max - solid.min);
            let point = DVec3::select(share.cmpeq(DVec3::ONE), solid.max, point);
            let mut direction = seeded.direction();
            if seeded.index(2) == 0 {
                direction[seeded.index(3)] = 0.0;
            }
            (point, direction.normalize())
        }
        Shape::Cone(cone) => {
            let out = seeded.across(cone.axis());
            let [base, apex] = cone.radii();
            let up = [0.0, 1.0, seeded.unit()][seeded.index(3)];
            let radius = share * (base + up * (apex - base));
            let point = cone.base() + up * cone.height() * cone.axis() + radius * out;
            let generator = cone.height() * cone.axis() + (apex - base) * out;
            let around = cone.axis().cross(out);
            let turn = seeded.within(0.0, 3.0);
            let along = match seeded.index(3) {
                0 => generator,
                1 => around,
                _ => turn.cos() * generator.normalize() + turn.sin() * around,
            };
            (point, along.normalize())
        }
        Shape::Polygon(polygon) => {
            let vertices: Vec<DVec3> = polygon.vertices().collect();
            let at = seeded.index(vertices.len());
            let (from, to) = (vertices[at], vertices[(at + 1) % vertices.len()]);
            let along = [0.0, 0.5, seeded.unit()][seeded.index(3)];
            let point = from + along * (to - from);
            let lift = [0.0, seeded.power(-9.0, -1.0)][seeded.index(2)];
            let in_plane = seeded.across(polygon.plane().normal);
            (
                point,
                (in_plane + lift * polygon.plane().normal).normalize(),
            )
        }
    }
}

/// A ray of one of the kinds on which searches disagree, if they ever do.
pub(super) fn ray(scene: &Scene, seeded: &mut Seeded) -> Ray {
    let target = &scene.primitives[seeded.index(scene.primitives.len())].shape;
    let (point, along) = graze(target, seeded);
    let far = seeded.power(-2.0, 2.0);
    let aimed = match seeded.index(6) {
        0 => Ray::new(seeded.point(20.0), seeded.direction()),
        1 => {
            let axis = DVec3::AXES[seeded.index(3)] * seeded.sign();
            Ray::new(point - far * axis, axis)
        }
        // aimed at a point of an edge, exactly or as nearly as f64 has it
        2 => {
            Ray::through(seeded.point(20.0), point)
                .normalised()
                .unwrap()
                .0
        }
        3 => Ray::new(point, seeded.direction()),
        _ => Ray::new(point - far * along, along),
    };
    match seeded.index(10) {
        0 => Ray::new(aimed.origin, seeded.power(-3.0, 3.0) * aimed.direction),
        _ => aimed,
    }
}
