//! With volumes around the objects every ray meets the same object at the same t, bit for bit.

use glam::DVec3;
use raystep::geometry::{Ray, TRange};
use raystep::strategy::{BoundedObjects, Exhaustive, Hit, Strategy};
use raystep::structure::{SlabSet, VolumeKind};
use raystep::trace::{BoundVerdict, Bounded};
use raystep::{Event, Off, Recording, Scene};
use serde_json::Value;

use super::{KINDS, brick, cone, ellipsoid, mesh, outline, own_set, polygon, scene, solid, sphere};
use crate::seeded::Seeded;

/// Every shape, some twice, crossing each other.
fn mixed(random: &mut Seeded) -> Vec<Value> {
    let mut shapes: Vec<Value> = Vec::new();
    for round in 0..2 {
        let middle = random.point(5.0);
        let radii = DVec3::from([0; 3].map(|_| random.power(-2.0, 0.5)));
        let tip = if round == 0 {
            0.0
        } else {
            random.power(-1.0, 0.3)
        };
        shapes.extend([
            sphere(random.point(5.0), random.power(-1.5, 0.3)),
            ellipsoid(random.point(5.0), radii),
            solid(middle - radii, middle + radii),
            cone(
                random.point(5.0),
                random.power(-1.0, 0.3),
                random.point(5.0),
                tip,
            ),
            polygon(&outline(random, 3, 0.5)),
            polygon(&outline(random, 8, 0.7)),
            mesh(&brick(random)),
            mesh(&[outline(random, 4, 0.1), outline(random, 5, 0.1)]),
        ]);
    }
    // the same polygon as its own twin: equal t
    shapes.push(shapes[4].clone());
    shapes
}

/// Moves every point of a shape.
fn shift(value: &mut Value, by: DVec3) {
    match value {
        Value::Object(parts) => {
            for (_, part) in parts.iter_mut().filter(|(key, _)| *key != "radii") {
                shift(part, by);
            }
        }
        Value::Array(list) if list.iter().all(Value::is_number) => {
            for (coordinate, by) in list.iter_mut().zip(by.to_array()) {
                *coordinate = (coordinate.as_f64().unwrap() + by).into();
            }
        }
        Value::Array(list) => list.iter_mut().for_each(|part| shift(part, by)),
        _ => {}
    }
}

/// A ray of one of the kinds that have gone wrong elsewhere.
fn ray(scene: &Scene, random: &mut Seeded) -> Ray {
    let direction = match random.index(4) {
        0 => {
            let axis = DVec3::AXES[random.index(3)];
            // with 0 and −0 beside the 1
            random.sign() * axis
        }
        1 => {
            let mut flat = random.direction();
            flat[random.index(3)] = if random.index(2) == 0 { 0.0 } else { -0.0 };
            flat.normalize()
        }
        _ => random.direction(),
    };
    let target = random.point(5.0);
    match random.index(5) {
        // from a surface
        0 => {
            let first = Ray::new(random.point(9.0), random.direction());
            let hit = Exhaustive::new(scene).nearest(&first, TRange::FORWARD, &mut Off);
            let start = hit.map_or(target, |hit| first.at(hit.t));
            Ray::new(start, direction)
        }
        // from far away
        1 => Ray::new(target - random.power(1.0, 7.0) * direction, direction),
        // past the edge of a round object, or at a vertex
        2 => grazing(scene, direction, random),
        3 => Ray::new(target, direction * random.power(-2.0, 2.0)),
        _ => Ray::new(target - 10.0 * direction, direction),
    }
}

/// A ray at the very edge of an object as it is seen along the direction.
fn grazing(scene: &Scene, direction: DVec3, random: &mut Seeded) -> Ray {
    use raystep::scene::Shape;
    let across = random.across(direction);
    let edge = match &scene.primitives[random.index(scene.primitives.len())].shape {
        Shape::Sphere(sphere) => sphere.center + sphere.radius * across,
        Shape::Ellipsoid(ellipsoid) => {
            // where the normal stands across the ray
            let n = ellipsoid.radii * across;
            ellipsoid.center + ellipsoid.radii * n / n.length()
        }
        Shape::Box(solid) => {
            let corner = [0, 1, 2].map(|i| [solid.min, solid.max][random.index(2)][i]);
            DVec3::from(corner)
        }
        Shape::Cone(cone) => {
            let out = random.across(cone.axis());
            [
                cone.base() + cone.radii()[0] * out,
                cone.apex() + cone.radii()[1] * out,
            ][random.index(2)]
        }
        Shape::Polygon(polygon) => {
            let vertices: Vec<DVec3> = polygon.vertices().collect();
            let i = random.index(vertices.len());
            let next = vertices[(i + 1) % vertices.len()];
            let share = [0.0, 0.5, random.unit()][random.index(3)];
            vertices[i].lerp(next, share)
        }
    };
    let inwards = [0.0, 1e-15, -1e-15, 1e-12, 1e-9][random.index(5)];
    Ray::new(
        edge * (1.0 - inwards) - random.power(-1.0, 3.0) * direction,
        direction,
    )
}

fn bits(hit: Option<Hit>) -> Option<(u32, u64)> {
    hit.map(|hit| (hit.object.0, hit.t.to_bits()))
}

/// Compares one strategy with the exhaustive one on one ray.
#[track_caller]
fn check(strategy: &impl Strategy, scene: &Scene, ray: &Ray, range: TRange, what: VolumeKind) {
    let exhaustive = Exhaustive::new(scene);
    let expected = exhaustive.nearest(ray, range, &mut Off);
    let found = strategy.nearest(ray, range, &mut Off);
    assert_eq!(
        bits(found),
        bits(expected),
        "{what:?} {ray:?} {found:?} {expected:?}"
    );
    let any = strategy.any(ray, range, &mut Off);
    assert_eq!(any.is_some(), expected.is_some(), "{what:?} {ray:?}");
}

#[test]
fn every_ray_meets_the_same_object_at_the_same_t_as_without_volumes() {
    const SCENES: usize = 60;
    const RAYS: usize = 1500;
    let mut random = Seeded::new(10);
    let mut hits = 0;
    for round in 0..SCENES {
        let mut shapes = mixed(&mut random);
        let about_the_origin = scene(&shapes);
        // every third scene lies far off
        let place = if round % 3 == 0 {
            random.point([1e2, 1e4, 1e6][round / 3 % 3])
        } else {
            DVec3::ZERO
        };
        for shape in &mut shapes {
            shift(shape, place);
        }
        let scene = scene(&shapes);
        let by_kind = KINDS.map(|kind| BoundedObjects::new(&scene, kind, &SlabSet::SEVEN));
        let own = BoundedObjects::new(&scene, VolumeKind::Slabs, &own_set());
        for _ in 0..RAYS {
            let mut ray = ray(&about_the_origin, &mut random);
            ray.origin += place;
            let mut range = TRange {
                min: [0.0, 1e-8][random.index(2)],
                ..TRange::FORWARD
            };
            if random.index(4) == 0 {
                range.max = random.power(-1.0, 1.5);
            }
            for (kind, bounded) in KINDS.into_iter().zip(&by_kind) {
                check(bounded, &scene, &ray, range, kind);
            }
            check(&own, &scene, &ray, range, VolumeKind::Slabs);
            hits += usize::from(
                Exhaustive::new(&scene)
                    .nearest(&ray, range, &mut Off)
                    .is_some(),
            );
        }
    }
    // a fifth of the rays at least meet something
    assert!(SCENES * RAYS < 5 * hits, "{hits} hits");
}

/// What became of each object's volume.
fn verdicts(scene: &Scene, kind: VolumeKind, ray: &Ray) -> Vec<(Bounded, BoundVerdict)> {
    let bounded = BoundedObjects::new(scene, kind, &SlabSet::SEVEN);
    let mut recording = Recording::new(Vec::new());
    bounded.nearest(ray, TRange::FORWARD, &mut recording);
    let records = recording.into_sink();
    let tests = records.iter().filter_map(|record| match record.event {
        Event::BoundTest(test) => Some((test.of, test.verdict)),
        _ => None,
    });
    tests.collect()
}

#[test]
fn each_object_has_one_test_of_its_volume_and_the_reason_is_told() {
    let at = |z: f64| DVec3::new(0.0, 0.0, z);
    let scene = scene(&[
        sphere(at(0.0), 1.0),
        sphere(at(-5.0), 1.0),
        sphere(at(20.0), 1.0),
        sphere(DVec3::new(9.0, 0.0, 0.0), 1.0),
        sphere(at(3.0), 1.0),
    ]);
    // down the z axis from z = 10: the first is met at 9, the second begins behind that, the third lies
    // behind the origin, the fourth beside, the fifth is nearer
    let ray = Ray::new(at(10.0), -DVec3::Z);
    use BoundVerdict::{Behind, Beyond, Hit, Missed};
    let expected: Vec<_> = [Hit, Beyond, Behind, Missed, Hit]
        .into_iter()
        .enumerate()
        .map(|(i, verdict)| (Bounded::Object(i as u32), verdict))
        .collect();
    for kind in KINDS {
        assert_eq!(verdicts(&scene, kind, &ray), expected, "{kind:?}");
    }
}

#[test]
fn slabs_are_told_one_by_one_up_to_the_one_that_decides() {
    let scene = scene(&[sphere(DVec3::ZERO, 1.0)]);
    let slabs_told = |set: SlabSet<16>, ray: &Ray| {
        let bounded = BoundedObjects::new(&scene, VolumeKind::Slabs, &set);
        let mut recording = Recording::new(Vec::new());
        bounded.nearest(ray, TRange::FORWARD, &mut recording);
        let records = recording.into_sink();
        let told = records
            .iter()
            .filter(|record| matches!(record.event, Event::SlabTest(_)));
        told.count()
    };
    // the four of this set and none of the twelve places that it leaves empty
    let through = Ray::new(DVec3::new(-5.0, 0.0, 0.0), DVec3::X);
    assert_eq!(slabs_told(own_set(), &through), 4);
    // parallel to the second slab and outside of it
    let axes = SlabSet::of(&DVec3::AXES).unwrap();
    let beside = Ray::new(DVec3::new(-5.0, 2.0, 0.0), DVec3::X);
    assert_eq!(slabs_told(axes, &beside), 2);
}
