//! Bounding volumes: each holds its object, none could be smaller, and no hit is lost by them.

mod hold;
mod least;
mod lowner;
mod room;
mod same_hits;
mod worked;

use std::f64::consts::TAU;

use glam::{DQuat, DVec3};
use raystep::geometry::MOST_SLABS;
use raystep::scene::Loaded;
use raystep::structure::{SlabSet, Volume, VolumeKind};
use raystep::{NoFiles, Scene, load_bytes};
use serde_json::{Value, json};

use crate::seeded::Seeded;

const KINDS: [VolumeKind; 4] = [
    VolumeKind::Sphere,
    VolumeKind::Ellipsoid,
    VolumeKind::Box,
    VolumeKind::Slabs,
];

/// A scene of these shapes.
#[track_caller]
fn scene(shapes: &[Value]) -> Scene {
    let object = |(i, shape): (usize, &Value)| json!({ "name": format!("{i}"), "material": "red", "shape": shape });
    let objects: Vec<_> = shapes.iter().enumerate().map(object).collect();
    let scene = json!({
        "camera": {
            "window": { "cop": [0, 0, 9], "corner": [-1, -1, 5], "right": [2, 0, 0], "up": [0, 2, 0] },
            "pixels": [2, 2]
        },
        "materials": { "red": { "colour": [0.8, 0.2, 0.1], "diffuse": 0.7 } },
        "objects": objects
    });
    let loaded = load_bytes("scene.json", scene.to_string().as_bytes(), &NoFiles);
    loaded.and_then(Loaded::build).unwrap()
}

/// The volume around the only object of a scene.
#[track_caller]
fn around(shape: Value, kind: VolumeKind) -> Volume<7> {
    Volume::around(&scene(&[shape]), 0, kind, &SlabSet::SEVEN)
}

/// A set of one's own with room to spare.
fn own_set() -> SlabSet<MOST_SLABS> {
    let directions = [
        [1.0, 0.2, 0.0],
        [0.0, 1.0, -0.3],
        [0.4, 0.0, 1.0],
        [1.0, 1.0, 1.0],
    ];
    SlabSet::of(&directions.map(DVec3::from)).unwrap()
}

fn sphere(center: DVec3, radius: f64) -> Value {
    json!({ "sphere": { "center": center.to_array(), "radius": radius } })
}

fn ellipsoid(center: DVec3, radii: DVec3) -> Value {
    json!({ "ellipsoid": { "center": center.to_array(), "radii": radii.to_array() } })
}

fn solid(min: DVec3, max: DVec3) -> Value {
    json!({ "box": { "min": min.to_array(), "max": max.to_array() } })
}

fn cone(base: DVec3, base_radius: f64, apex: DVec3, apex_radius: f64) -> Value {
    json!({ "cone": {
        "base": base.to_array(), "base_radius": base_radius,
        "apex": apex.to_array(), "apex_radius": apex_radius
    } })
}

fn polygon(vertices: &[DVec3]) -> Value {
    json!({ "polygon": { "vertices": list(vertices) } })
}

fn mesh(faces: &[Vec<DVec3>]) -> Value {
    let faces: Vec<_> = faces
        .iter()
        .map(|face| json!({ "vertices": list(face) }))
        .collect();
    json!({ "mesh": { "faces": faces } })
}

fn list(points: &[DVec3]) -> Vec<[f64; 3]> {
    points.iter().map(DVec3::to_array).collect()
}

/// A mesh whose vertices are these points: a triangle of each three that follow each other.
fn mesh_of(points: &[DVec3]) -> Value {
    mesh(&points.windows(3).map(<[_]>::to_vec).collect::<Vec<_>>())
}

/// Points in a plane of any direction, around an ellipse and inside of it by up to a share of its radius.
fn outline(random: &mut Seeded, corners: usize, roughness: f64) -> Vec<DVec3> {
    let center = random.point(5.0);
    let normal = random.direction();
    let u = random.across(normal);
    let v = normal.cross(u);
    let (width, height) = (random.power(-1.0, 0.5), random.power(-1.0, 0.5));
    let mut angles: Vec<_> = (0..corners)
        .map(|i| TAU * (i as f64 + random.within(0.0, 0.9)) / corners as f64)
        .collect();
    angles.sort_by(f64::total_cmp);
    let corner = |angle: f64, random: &mut Seeded| {
        let r = random.within(1.0 - roughness, 1.0);
        center + r * (width * angle.cos() * u + height * angle.sin() * v)
    };
    angles.iter().map(|&a| corner(a, random)).collect()
}

/// A closed mesh that lies askew: a cube, stretched and turned.
fn brick(random: &mut Seeded) -> Vec<Vec<DVec3>> {
    let turn = DQuat::from_axis_angle(random.direction(), random.within(0.0, 3.0));
    let half = DVec3::new(
        random.power(-1.5, 0.3),
        random.power(-1.0, 0.3),
        random.power(-1.0, 0.3),
    );
    let center = random.point(5.0);
    let corner = |i: i32| {
        let signs = [0, 1, 2].map(|axis| f64::from(2 * (i >> axis & 1) - 1));
        center + turn * (half * DVec3::from(signs))
    };
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    faces.map(|face| face.map(corner).to_vec()).to_vec()
}
