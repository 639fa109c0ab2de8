//! The search for the nearest object among several.

use crate::geometry::{Ray, TRange};
use crate::mistake::{Mistake, Wrong};
use crate::scene::{PrimitiveId, Scene};
use crate::strategy::Hit;
use crate::tracer::simple::{Own, Parts};

pub(super) const MISTAKES: &[Mistake] = &[
    Mistake {
        name: "stops at the first leaf",
        sentence: "The search ends with the first object that is hit, although a nearer one may come later.",
        spoils: "nearest hit",
        wrong: Wrong::Nearest(first_hit_found),
    },
    Mistake {
        name: "last hit wins",
        sentence: "Each hit replaces the one before it, whether it is nearer or not.",
        spoils: "nearest hit",
        wrong: Wrong::Nearest(last_hit_wins),
    },
    Mistake {
        name: "one child only",
        sentence: "Only the first half of the objects is searched, as if a ray could never hit both children of a node.",
        spoils: "nearest hit",
        wrong: Wrong::Nearest(one_child_only),
    },
];

/// All hits, in the order of the objects.
fn hits(scene: &Scene, ray: &Ray, range: TRange) -> impl Iterator<Item = Hit> {
    let objects = (0..).map(PrimitiveId).zip(&scene.primitives);
    objects.filter_map(move |(object, primitive)| {
        let t = Own.hit(primitive, ray, range)?;
        Some(Hit { object, t })
    })
}

fn first_hit_found(scene: &Scene, ray: &Ray, range: TRange) -> Option<Hit> {
    hits(scene, ray, range).next()
}

fn last_hit_wins(scene: &Scene, ray: &Ray, range: TRange) -> Option<Hit> {
    hits(scene, ray, range).last()
}

/// The objects are halved by their order, and the second half is left out where the first one is hit.
fn one_child_only(scene: &Scene, ray: &Ray, range: TRange) -> Option<Hit> {
    let half = scene.primitives.len().div_ceil(2) as u32;
    let nearest = |second: bool| {
        let of_half = hits(scene, ray, range).filter(|hit| (half <= hit.object.0) == second);
        of_half.min_by(|one, other| one.t.total_cmp(&other.t))
    };
    nearest(false).or_else(|| nearest(true))
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::scene::small_scene::{scene_of, sphere};

    /// The hit of a ray along x with balls of radius 1 in this order: the right one, then that of each mistake.
    fn of(centers: [f64; 2]) -> [(u32, f64); 4] {
        let scene = scene_of(&centers.map(|x| sphere([x, 0.0, 0.0], 1.0)));
        let ray = Ray::new(DVec3::ZERO, DVec3::X);
        let nearest = |scene: &Scene, ray: &Ray, range| Own.nearest(scene, ray, range);
        let all = [nearest, first_hit_found, last_hit_wins, one_child_only];
        all.map(|nearest| {
            let hit = nearest(&scene, &ray, TRange::FORWARD).unwrap();
            (hit.object.0, hit.t)
        })
    }

    #[test]
    fn the_nearest_hit_wins_in_whichever_order_the_objects_come() {
        assert_eq!(of([9.0, 5.0]), [(1, 4.0), (0, 8.0), (1, 4.0), (0, 8.0)]);
        assert_eq!(of([5.0, 9.0]), [(0, 4.0), (0, 4.0), (1, 8.0), (0, 4.0)]);
    }
}
