//! Which objects of a large scene a figure shows: those near its rays.

use glam::DVec3;

use crate::figure::traced::Traced;
use crate::scene::{Primitive, PrimitiveId, Scene};
use crate::structure::extent;
use crate::trace::{Event, Record};

/// A scene with more objects is not shown whole.
const WHOLE: usize = 200;

/// The number of objects that are shown of a larger scene.
const MOST: usize = 60;

/// Straight pieces of rays, from their start to their end.
type Pieces = Vec<[DVec3; 2]>;

/// The primitives that a figure draws, in the order of the scene: all of a small scene; of a large one those that its rays were
/// tested against or come near to.
pub(super) fn near(scene: &Scene, records: &[Record]) -> Vec<PrimitiveId> {
    let all = (0..scene.primitives.len() as u32).map(PrimitiveId);
    if scene.primitives.len() <= WHOLE {
        return all.collect();
    }
    let pieces = pieces(records);
    let mut found: Vec<(f64, PrimitiveId)> = all
        .map(|id| (distance(scene.primitive(id), &pieces), id))
        .collect();
    // of equally near ones the first of the scene; their order is of no account
    found.select_nth_unstable_by(MOST, |(a, first), (b, second)| {
        a.total_cmp(b).then(first.cmp(second))
    });
    found.truncate(MOST);
    let mut near: Vec<PrimitiveId> = found.into_iter().map(|(_, id)| id).collect();
    near.sort_unstable();
    near
}

/// The rays of a trace, each up to what it hits; one that hits nothing ends where it starts.
fn pieces(records: &[Record]) -> Pieces {
    let mut open: Vec<(Option<u32>, crate::geometry::Ray)> = Vec::new();
    let mut pieces = Vec::new();
    for record in records {
        match &record.event {
            Event::Ray(start) => open.push((record.ray, start.ray)),
            Event::RayEnd(end) => {
                let Some(place) = open.iter().rposition(|(ray, _)| *ray == record.ray) else {
                    continue;
                };
                let (_, ray) = open.swap_remove(place);
                pieces.push([ray.origin, ray.at(end.t.unwrap_or(0.0))]);
            }
            _ => {}
        }
    }
    pieces
}

/// The direction of a ray, and two corners of a box.
type Around = (DVec3, [DVec3; 2]);

/// The direction of the first ray of a trace, and two corners of a box around what happens to its rays: the rays, and the objects
/// near them that are not much larger; first without the window, and then with it. `None` without a ray.
pub(crate) fn around_rays(traced: &Traced) -> Option<[Around; 2]> {
    /// An object that is wider than the rays are long by this factor would make them small.
    const LARGE: f64 = 1.0;
    /// Around all of it, of its diagonal.
    const ROOM: f64 = 0.05;
    let mut pieces = pieces(&traced.records);
    let [from, to] = *pieces.first()?;
    let along = traced
        .records
        .iter()
        .find_map(|record| match &record.event {
            Event::Ray(start) => Some(start.ray.direction),
            _ => None,
        })?;
    if from == to {
        // it hits nothing: as far as the middle of the scene
        let all = traced.scene.primitives.iter().map(corners);
        let [low, high] = all.reduce(union)?;
        let far = from.distance(low.midpoint(high));
        pieces.push([from, from + far * along.normalize_or_zero()]);
    }
    let rays = pieces
        .iter()
        .copied()
        .map(|[a, b]| [a.min(b), a.max(b)])
        .reduce(union)?;
    let camera = &traced.scene.camera;
    let corner = camera.corner();
    let sides = [
        DVec3::ZERO,
        camera.right,
        camera.up,
        camera.right + camera.up,
    ];
    let window = sides.map(|side| [corner + side; 2]);
    let near = near(&traced.scene, &traced.records);
    let touched: Vec<[DVec3; 2]> = near
        .into_iter()
        .map(|id| traced.scene.primitive(id))
        .filter(|of| distance(of, &pieces) <= 0.0)
        .map(corners)
        .collect();
    let around = |rays: [DVec3; 2]| {
        let length = rays[0].distance(rays[1]);
        let touched = touched.iter().copied();
        let around = touched
            .filter(|[low, high]| low.distance(*high) <= LARGE * length)
            .fold(rays, union);
        let room = DVec3::splat(ROOM * around[0].distance(around[1]));
        (along, [around[0] - room, around[1] + room])
    };
    Some([around(rays), around(window.into_iter().fold(rays, union))])
}

fn union(a: [DVec3; 2], b: [DVec3; 2]) -> [DVec3; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

/// How far a primitive is from the nearest piece: the box around it, taken as a ball, from the piece. At most 0 is touched.
fn distance(primitive: &Primitive, pieces: &[[DVec3; 2]]) -> f64 {
    let [low, high] = corners(primitive);
    let (center, radius) = (low.midpoint(high), 0.5 * low.distance(high));
    let to = |[from, to]: &[DVec3; 2]| {
        let along = *to - *from;
        let length = along.length_squared();
        let share = if length == 0.0 {
            0.0
        } else {
            ((center - *from).dot(along) / length).clamp(0.0, 1.0)
        };
        center.distance(*from + share * along) - radius
    };
    pieces.iter().map(to).fold(f64::INFINITY, f64::min)
}

/// The corners of the box around a primitive.
fn corners(primitive: &Primitive) -> [DVec3; 2] {
    let bounds = DVec3::AXES.map(|axis| extent(&primitive.shape, axis));
    [0, 1].map(|side| DVec3::from_array([0, 1, 2].map(|axis| bounds[axis][side])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::small_scene;

    #[test]
    fn a_small_scene_is_shown_whole_and_of_a_large_one_what_is_near() {
        let row = |count: u32| {
            let shapes: Vec<String> = (0..count)
                .map(|i| small_scene::sphere([f64::from(i), 0.0, -3.0], 0.25))
                .collect();
            small_scene::scene_of(&shapes)
        };
        assert_eq!(near(&row(200), &[]).len(), 200);
        let large = row(201);
        let id = |i: u32| large.primitive(PrimitiveId(i));
        // from (50, 0, 0) along −z up to t = 3: the 50th ball is hit, the 53rd is 3 away less its half diagonal
        let piece = [DVec3::new(50.0, 0.0, 0.0), DVec3::new(50.0, 0.0, -3.0)];
        let half_diagonal = 0.25 * 3f64.sqrt();
        assert!((distance(id(50), &[piece]) + half_diagonal).abs() < 1e-12);
        assert!((distance(id(53), &[piece]) - (3.0 - half_diagonal)).abs() < 1e-12);
    }
}
