//! Points of every surface lie inside the volume around it.

use std::f64::consts::TAU;

use glam::DVec3;
use raystep::scene::Shape;
use raystep::structure::{SlabBound, Volume, VolumeKind};
use serde_json::Value;

use super::{KINDS, around, brick, cone, ellipsoid, mesh, outline, polygon, scene, solid, sphere};
use crate::seeded::Seeded;

/// A point of the surface, not through any test of the library.
fn surface_point(shape: &Shape, random: &mut Seeded) -> DVec3 {
    match shape {
        Shape::Sphere(sphere) => sphere.center + sphere.radius * random.direction(),
        Shape::Ellipsoid(ellipsoid) => ellipsoid.center + ellipsoid.radii * random.direction(),
        Shape::Box(solid) => {
            let mut share = [0.0; 3].map(|_| random.unit());
            share[random.index(3)] = random.index(2) as f64;
            solid.min + DVec3::from(share) * (solid.max - solid.min)
        }
        Shape::Cone(cone) => {
            let share = match random.index(4) {
                0 => 0.0,
                1 => 1.0,
                _ => random.unit(),
            };
            let [base, apex] = cone.radii();
            let u = random.across(cone.axis());
            let v = cone.axis().cross(u);
            let angle = random.within(0.0, TAU);
            cone.base().lerp(cone.apex(), share)
                + (base + share * (apex - base)) * (angle.cos() * u + angle.sin() * v)
        }
        Shape::Polygon(polygon) => {
            // a triangle of vertices may leave a concave outline, but never the vertices' extent
            let vertices: Vec<DVec3> = polygon.vertices().collect();
            let [a, b, c] = [0; 3].map(|_| vertices[random.index(vertices.len())]);
            let (s, t) = (random.unit(), random.unit());
            if random.index(3) == 0 {
                return a;
            }
            a.lerp(b, s).lerp(c, t)
        }
    }
}

fn slabs_hold<const N: usize>(
    bound: &SlabBound<N>,
    normals: &[DVec3],
    point: DVec3,
    room: f64,
) -> bool {
    normals.iter().enumerate().all(|(slab, n)| {
        let along = n.dot(point);
        -bound.d_max[slab] - room <= along && along <= -bound.d_min[slab] + room
    })
}

/// Of a point's coordinates: the rounding of the point and of the volume.
const ROUNDING: f64 = 1e-12;

fn holds(volume: &Volume<7>, point: DVec3) -> bool {
    let room = ROUNDING * point.abs().element_sum();
    /// 1/√3.
    const D: f64 = 0.577_350_269_189_625_8;
    match volume {
        Volume::Sphere(sphere) => point.distance(sphere.center) <= sphere.radius + room,
        Volume::Ellipsoid(ellipsoid) => ellipsoid.with_room(room).level(point) <= 1.0,
        Volume::Box(bound) => slabs_hold(bound, &DVec3::AXES, point, room),
        Volume::Slabs(bound) => {
            let diagonals = [[D, D, D], [-D, D, D], [-D, -D, D], [D, -D, D]].map(DVec3::from);
            slabs_hold(
                bound,
                &[&DVec3::AXES[..], &diagonals[..]].concat(),
                point,
                room,
            )
        }
        Volume::Nothing => false,
    }
}

#[track_caller]
fn check(shape: &Value, random: &mut Seeded) {
    let scene = scene(std::slice::from_ref(shape));
    for kind in KINDS {
        let volume = around(shape.clone(), kind);
        for _ in 0..60 {
            let primitive = &scene.primitives[random.index(scene.primitives.len())];
            let point = surface_point(&primitive.shape, random);
            assert!(holds(&volume, point), "{point} {volume:?} {shape}");
        }
    }
}

#[test]
fn every_point_of_a_surface_lies_in_the_volume_around_it() {
    let mut random = Seeded::new(1);
    for _ in 0..200 {
        let random = &mut random;
        let radii = DVec3::from([0; 3].map(|_| random.power(-3.0, 1.0)));
        let middle = random.point(20.0);
        let shapes = [
            sphere(middle, random.power(-3.0, 2.0)),
            ellipsoid(middle, radii),
            solid(middle - radii, middle + radii),
            cone(
                middle,
                random.power(-2.0, 1.0),
                random.point(20.0),
                random.power(-2.0, 1.0),
            ),
            cone(middle, random.power(-2.0, 1.0), random.point(20.0), 0.0),
            cone(middle, 0.0, random.point(20.0), random.power(-2.0, 1.0)),
            polygon(&outline(random, 3, 0.8)),
            polygon(&outline(random, 4, 0.1)),
            polygon(&outline(random, 9, 0.8)),
            mesh(&brick(random)),
            mesh(&[outline(random, 5, 0.2), outline(random, 6, 0.2)]),
        ];
        for shape in &shapes {
            check(shape, random);
        }
    }
}

#[test]
fn a_bent_polygon_has_its_room_inside_the_volume() {
    // a vertex 2·10⁻⁶ off: hits may lie up to 64 times as far off the vertices' plane, as the polygon says
    let vertices = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 2e-6],
        [0.0, 1.0, 0.0],
    ]
    .map(DVec3::from);
    let scene = scene(&[polygon(&vertices)]);
    let Shape::Polygon(bent) = &scene.primitives[0].shape else {
        panic!("a polygon");
    };
    let room = bent.room();
    assert!(3e-5 < room, "{room}");
    let mut random = Seeded::new(2);
    for kind in KINDS {
        let volume = around(polygon(&vertices), kind);
        for _ in 0..1000 {
            let point = vertices[random.index(4)] + room * random.direction();
            assert!(holds(&volume, point), "{kind:?}");
        }
    }
}

#[test]
fn needles_and_polygons_of_any_size_and_place_lie_in_the_volume_around_them() {
    let mut random = Seeded::new(12);
    let mut checked = 0;
    for _ in 0..600 {
        let size = random.power(-45.0, 43.0);
        let place = random.direction() * size * random.power(-3.0, 6.0);
        let (long, across) = (random.direction(), random.direction());
        let thin = random.power(-14.0, 0.0);
        let mut vertex = || {
            place
                + size
                    * (random.within(-1.0, 1.0) * long + thin * random.within(-1.0, 1.0) * across)
        };
        let vertices = [vertex(), vertex(), vertex()];
        // thinner than the rounding of its place it is none
        if raystep::geometry::Polygon::new(vertices.to_vec(), None).is_err() {
            continue;
        }
        checked += 1;
        let twice = mesh(&[vertices.to_vec(), vertices.to_vec()]);
        for shape in [polygon(&vertices), twice] {
            check(&shape, &mut random);
        }
    }
    assert!(300 < checked, "{checked}");
}

#[test]
fn a_mesh_without_faces_has_a_volume_that_every_ray_misses() {
    for kind in KINDS {
        assert_eq!(around(mesh(&[]), kind), Volume::Nothing);
    }
}

#[test]
fn the_volume_of_each_kind_around_the_unit_sphere_is_the_known_one() {
    let volume = |kind| around(sphere(DVec3::ONE, 1.0), kind).volume();
    // (4/3)π and 2³
    for (kind, expected) in [
        (VolumeKind::Sphere, 4.188_790_204_786_391),
        (VolumeKind::Ellipsoid, 4.188_790_204_786_391),
        (VolumeKind::Box, 8.0),
    ] {
        let found = volume(kind).unwrap();
        assert!((found - expected).abs() <= 1e-14, "{kind:?} {found}");
    }
    assert_eq!(volume(VolumeKind::Slabs), None);
}
