//! A diffuse room, as a scene and once more for a sampler of its own: paths from the surface that is looked at, from wall
//! to wall, with a ray to every lamp from each. It shares nothing with the tracer but the numbers of the room.

use std::f64::consts::PI;

use glam::DVec3;

use super::{Scene, built};
use crate::seeded::Seeded;

/// The room: x in −2..2, y in −1.3..1.3, z in 0..2.4.
const LOW: DVec3 = DVec3::new(-2.0, -1.3, 0.0);
const HIGH: DVec3 = DVec3::new(2.0, 1.3, 2.4);
const WALL: DVec3 = DVec3::new(0.8, 0.65, 0.7);

/// A partition, which leaves a passage from x = 0.1 on.
const PARTITION: [DVec3; 2] = [DVec3::new(-2.0, -1.3, 1.6), DVec3::new(0.1, 1.3, 1.65)];
const PARTITION_COLOUR: DVec3 = DVec3::new(0.6, 0.7, 0.5);

/// A ball in the passage.
const BALL: DVec3 = DVec3::new(1.4, -0.6, 1.95);
const BALL_RADIUS: f64 = 0.3;
const BALL_COLOUR: DVec3 = DVec3::new(0.3, 0.6, 0.8);

/// Two lamps: one before the partition, and a weaker one behind it. Of the wall z = 0 the second lights what lies to
/// the right of x = 0.1/0.55·2.2 = 0.4.
const LAMPS: [(DVec3, f64); 2] = [
    (DVec3::new(-0.1, 0.1, 0.8), 100.0),
    (DVec3::new(0.0, 0.3, 2.2), 40.0),
];

/// The room, with the eye 1.2 before the wall z = 0 and a window in that wall: each pixel is a square of it, 0.1 wide.
pub(super) fn scene() -> Scene {
    let vector = |v: DVec3| format!("[{}, {}, {}]", v.x, v.y, v.z);
    let lamp = |(position, power): (DVec3, f64)| {
        format!(
            r#"{{ "position": {}, "power": {power} }}"#,
            vector(position)
        )
    };
    let colour = |name, colour| {
        format!(
            r#""{name}": {{ "colour": {}, "diffuse": 1 }}"#,
            vector(colour)
        )
    };
    let solid = |name, [low, high]: [DVec3; 2]| {
        format!(
            r#"{{ "name": "the {name}", "material": "{name}",
                  "shape": {{ "box": {{ "min": {}, "max": {} }} }} }}"#,
            vector(low),
            vector(high)
        )
    };
    built(&format!(
        r#"{{ "name": "a room with a partition",
          "camera": {{ "window": {{ "cop": [0, 0, 1.2], "corner": [-1.8, -1.2, 0], "right": [3.6, 0, 0],
                                    "up": [0, 2.4, 0] }}, "pixels": [36, 24] }},
          "lights": [ {}, {} ],
          "materials": {{ {}, {}, {} }},
          "objects": [ {}, {},
            {{ "name": "the ball", "material": "ball",
               "shape": {{ "sphere": {{ "center": {}, "radius": {BALL_RADIUS} }} }} }} ] }}"#,
        lamp(LAMPS[0]),
        lamp(LAMPS[1]),
        colour("wall", WALL),
        colour("partition", PARTITION_COLOUR),
        colour("ball", BALL_COLOUR),
        solid("wall", [LOW, HIGH]),
        solid("partition", PARTITION),
        vector(BALL),
    ))
}

/// A point that a ray has met.
#[derive(Clone, Copy)]
struct Met {
    t: f64,
    point: DVec3,
    normal: DVec3,
    colour: DVec3,
}

/// Rays that start on a surface leave it out by this; the room is of size 1.
const OFF: f64 = 1e-9;

/// When does a ray come into a box and out of it, and across which axis?
fn through_box([low, high]: [DVec3; 2], from: DVec3, along: DVec3) -> [(f64, usize); 2] {
    let [mut enters, mut leaves] = [(f64::NEG_INFINITY, 0), (f64::INFINITY, 0)];
    for axis in 0..3 {
        let [a, b] = [low, high].map(|side| (side[axis] - from[axis]) / along[axis]);
        if enters.0 < a.min(b) {
            enters = (a.min(b), axis);
        }
        if a.max(b) < leaves.0 {
            leaves = (a.max(b), axis);
        }
    }
    [enters, leaves]
}

/// When does a ray come to the ball?
fn to_ball(from: DVec3, along: DVec3) -> Option<f64> {
    let offset = from - BALL;
    let middle = -offset.dot(along);
    let beside = offset + middle * along;
    let half = (BALL_RADIUS * BALL_RADIUS - beside.length_squared()).sqrt();
    // NaN for a ray that passes the ball
    (OFF < middle - half).then_some(middle - half)
}

/// When does a ray come to the partition?
fn to_partition(from: DVec3, along: DVec3) -> Option<(f64, usize)> {
    let [enters, leaves] = through_box(PARTITION, from, along);
    (OFF < enters.0 && enters.0 < leaves.0).then_some(enters)
}

/// What a ray meets in the room.
fn nearest(from: DVec3, along: DVec3) -> Met {
    let across = |axis: usize| {
        let mut normal = DVec3::ZERO;
        normal[axis] = -along[axis].signum();
        normal
    };
    let met = |t: f64, normal: DVec3, colour| Met {
        t,
        point: from + t * along,
        normal,
        colour,
    };
    let [_, (t, axis)] = through_box([LOW, HIGH], from, along);
    let mut nearest = met(t, across(axis), WALL);
    if let Some((t, axis)) = to_partition(from, along).filter(|(t, _)| *t < nearest.t) {
        nearest = met(t, across(axis), PARTITION_COLOUR);
    }
    if let Some(t) = to_ball(from, along).filter(|t| *t < nearest.t) {
        nearest = met(t, (from + t * along - BALL) / BALL_RADIUS, BALL_COLOUR);
    }
    nearest
}

/// Σ over the lamps of Φ·cos θ / (4π·r²), if nothing stands between.
fn direct_irradiance(at: &Met) -> f64 {
    let from_lamp = |&(position, power): &(DVec3, f64)| {
        let offset = position - at.point;
        let distance = offset.length();
        let along = offset / distance;
        let cosine = at.normal.dot(along);
        let ends = distance - OFF;
        let blocks = |t: Option<f64>| t.is_some_and(|t| t < ends);
        let shadowed = blocks(to_ball(at.point, along))
            || blocks(to_partition(at.point, along).map(|(t, _)| t));
        if cosine <= 0.0 || shadowed {
            0.0
        } else {
            power * cosine / (4.0 * PI * distance * distance)
        }
    };
    LAMPS.iter().map(from_lamp).sum()
}

/// A unit direction around a normal with a density of cos θ/π: over a point of the unit disc, chosen evenly
/// (Malley).
fn around(normal: DVec3, chance: &mut Seeded) -> DVec3 {
    let squared = chance.unit();
    let (sin, cos) = (2.0 * PI * chance.unit()).sin_cos();
    let beside = if normal.x.abs() < 0.5 {
        DVec3::X
    } else {
        DVec3::Y
    };
    let first = normal.cross(beside).normalize();
    let second = normal.cross(first);
    squared.sqrt() * (cos * first + sin * second) + (1.0 - squared).sqrt() * normal
}

/// One sample of the radiance of the wall z = 0 at a place.
pub(super) fn radiance(x: f64, y: f64, chance: &mut Seeded) -> DVec3 {
    let mut at = Met {
        t: 0.0,
        point: DVec3::new(x, y, 0.0),
        normal: DVec3::Z,
        colour: WALL,
    };
    let mut weight = DVec3::ONE;
    let mut radiance = DVec3::ZERO;
    loop {
        radiance += weight * at.colour / PI * direct_irradiance(&at);
        // it goes on with the chance of the channel that goes on most
        let goes_on = at.colour.max_element();
        if goes_on <= chance.unit() {
            return radiance;
        }
        weight *= at.colour / goes_on;
        at = nearest(at.point, around(at.normal, chance));
    }
}
