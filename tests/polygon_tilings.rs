//! Polygons that tile a plane take every ray through the tiled area exactly once.
//!
//! The hard rays are those through an edge or a vertex: exactly through it, where the numbers allow,
//! or past it by less than f64 can tell. Each neighbour alone may answer as it likes; together they
//! may leave no gap and no overlap.

use glam::{DMat3, DVec2, DVec3};
use raystep::geometry::{DecidedBy, PlaneVerdict, Polygon, Ray, Sides, TRange};

use crate::seeded::Seeded;

/// Rays per tiling and plane.
const RAYS: usize = 800;

/// Tiles in a plane, as corners in it, and what they cover: a disc around (0, 0).
struct Tiling {
    tiles: Vec<Vec<DVec2>>,
    covered: f64,
}

/// Quads with whole corners from −3 to 3.
fn grid() -> Tiling {
    let corner = |x: i32, y: i32| DVec2::new(f64::from(x), f64::from(y));
    let quad = |x, y| {
        [
            corner(x, y),
            corner(x + 1, y),
            corner(x + 1, y + 1),
            corner(x, y + 1),
        ]
        .to_vec()
    };
    let tiles = (-3..3).flat_map(|x| (-3..3).map(move |y| (x, y)));
    Tiling {
        tiles: tiles.map(|(x, y)| quad(x, y)).collect(),
        covered: 3.0,
    }
}

/// Triangles around one vertex.
fn fan(count: usize) -> Tiling {
    let step = std::f64::consts::TAU / count as f64;
    let rim = |i: usize| DVec2::from_angle(step * (i % count) as f64);
    let tiles = (0..count)
        .map(|i| vec![DVec2::ZERO, rim(i), rim(i + 1)])
        .collect();
    Tiling {
        tiles,
        covered: (0.5 * step).cos(),
    }
}

/// The grid with its inner corners moved: by whole steps of 1/1024, so that the corners of a tile in a
/// plane of whole vectors stay exactly in it, and by no more than 1/5, so that the quads stay convex.
/// Some quads are cut in two, along either diagonal; some pairs are one hexagon, mostly concave.
fn irregular(random: &mut Seeded) -> Tiling {
    let moved: Vec<DVec2> = (0..49)
        .map(|i| {
            let corner = DVec2::new(f64::from(i % 7 - 3), f64::from(i / 7 - 3));
            let by = DVec2::new(random.within(-0.2, 0.2), random.within(-0.2, 0.2));
            let inner = corner.abs().max_element() < 3.0;
            if inner {
                corner + (by * 1024.0).round() / 1024.0
            } else {
                corner
            }
        })
        .collect();
    let corner = |x: usize, y: usize| moved[x + 7 * y];
    let mut tiles = Vec::new();
    for y in 0..6 {
        for pair in 0..3 {
            let [x, middle, end] = [2 * pair, 2 * pair + 1, 2 * pair + 2];
            let (a, b, c) = (corner(x, y), corner(middle, y), corner(end, y));
            let (d, e, f) = (corner(end, y + 1), corner(middle, y + 1), corner(x, y + 1));
            match random.index(4) {
                0 => tiles.extend([vec![a, b, e, f], vec![b, c, d, e]]),
                1 => tiles.extend([vec![a, b, f], vec![b, e, f], vec![b, c, d], vec![b, d, e]]),
                2 => tiles.extend([vec![a, b, e], vec![a, e, f], vec![b, c, e], vec![c, d, e]]),
                _ => tiles.push(vec![a, b, c, d, e, f]),
            }
        }
    }
    Tiling {
        tiles,
        covered: 2.5,
    }
}

/// How the plane lies in space: u and v are the images of the two axes of the tiling.
#[derive(Clone, Copy, Debug)]
struct Placed {
    origin: DVec3,
    u: DVec3,
    v: DVec3,
}

impl Placed {
    fn point(&self, p: DVec2) -> DVec3 {
        self.origin + p.x * self.u + p.y * self.v
    }
}

/// Planes along the axes, and tilted ones of whole vectors, in which corners are not rounded.
fn whole_planes() -> [Placed; 6] {
    let vector = |v: [i32; 3]| DVec3::from_array(v.map(f64::from));
    [
        ([0, 0, 5], [1, 0, 0], [0, 1, 0]),
        ([2, 0, 0], [0, 1, 0], [0, 0, 1]),
        ([0, -1, 0], [0, 0, 1], [1, 0, 0]),
        ([1, 2, 3], [1, 0, 1], [0, 1, 1]),
        ([0, 0, 0], [2, 1, 0], [-1, 2, 3]),
        ([-7, 5, 1], [3, -1, 2], [0, 2, 1]),
    ]
    .map(|(origin, u, v)| Placed {
        origin: vector(origin),
        u: vector(u),
        v: vector(v),
    })
}

/// A plane turned and moved by numbers of full length: every corner is rounded.
fn any_plane(random: &mut Seeded) -> Placed {
    let turn = {
        let normal = random.direction();
        let u = random.across(normal);
        DMat3::from_cols(u, normal.cross(u), normal)
    };
    let size = random.power(-3.0, 3.0);
    Placed {
        origin: size * random.point(10.0),
        u: size * turn.x_axis,
        v: size * turn.y_axis,
    }
}

/// How many rays were held against a tiling, and how many of them some tile left to the ray.
#[derive(Debug, Default)]
struct Tally {
    rays: usize,
    by_ray: usize,
}

/// Exactly one of the polygons must take the ray.
#[track_caller]
fn check(polygons: &[Polygon], ray: &Ray, tally: &mut Tally) {
    let meets = |polygon: &&Polygon| {
        let plane_test = polygon.plane_test(ray, TRange::FORWARD, Sides::Both);
        match plane_test.verdict {
            PlaneVerdict::Meets(root) => Some((root.t, polygon.contains(ray, root.t))),
            _ => None,
        }
    };
    let tests: Vec<_> = polygons
        .iter()
        .filter_map(|polygon| meets(&polygon))
        .collect();
    let takers: Vec<_> = tests.iter().filter(|(_, test)| test.inside).collect();
    assert_eq!(takers.len(), 1, "{ray:?} is taken by {takers:?}");
    tally.rays += 1;
    tally.by_ray += usize::from(
        tests
            .iter()
            .any(|(_, test)| test.decided_by == DecidedBy::Ray),
    );
}

/// Rays at vertices and edges of the tiling that lie in the covered part, and next to them.
#[track_caller]
fn check_tiling(random: &mut Seeded, tiling: &Tiling, placed: Placed, tally: &mut Tally) {
    let polygon =
        |tile: &Vec<DVec2>| Polygon::new(tile.iter().map(|&p| placed.point(p)).collect(), None);
    let polygons: Vec<_> = tiling
        .tiles
        .iter()
        .map(|tile| polygon(tile).unwrap())
        .collect();
    let corners: Vec<_> = polygons
        .iter()
        .zip(&tiling.tiles)
        .map(|(p, tile)| (p.vertices().collect(), tile))
        .collect();
    let size = placed.u.length();
    let normal = placed.u.cross(placed.v).normalize();
    for _ in 0..RAYS {
        let (vertices, tile): &(Vec<DVec3>, _) = &corners[random.index(corners.len())];
        let i = random.index(tile.len());
        let j = (i + 1) % tile.len();
        if tiling.covered <= tile[i].length().max(tile[j].length()) && tile[i] != DVec2::ZERO {
            continue;
        }
        // the vertex itself, the middle of the edge, or elsewhere on it
        let share = [0.0, 0.5, 0.9 * random.unit()][random.index(3)];
        let goal = vertices[i] + share * (vertices[j] - vertices[i]);
        let beside = match random.index(3) {
            0 => size * random.power(-17.0, -9.0) * random.direction(),
            _ => DVec3::ZERO,
        };
        // whole coordinates, so that the ray goes exactly through a whole goal, or any
        let away = size * (5.0 * random.direction() + 2.0 * random.sign() * normal);
        let origin = goal + away;
        let origin = if random.sign() < 0.0 {
            origin.round()
        } else {
            origin
        };
        let ray = Ray::through(origin, goal + beside);
        if ray.direction.dot(normal).abs() < 0.1 * ray.direction.length() {
            continue;
        }
        let unit = ray.normalised().unwrap().0;
        check(
            &polygons,
            if random.sign() < 0.0 { &ray } else { &unit },
            tally,
        );
    }
}

#[track_caller]
fn check_everywhere(seed: u64, make: impl Fn(&mut Seeded) -> Tiling) {
    let mut random = Seeded::new(seed);
    let mut tally = Tally::default();
    for placed in whole_planes() {
        let tiling = make(&mut random);
        check_tiling(&mut random, &tiling, placed, &mut tally);
    }
    for _ in 0..6 {
        let tiling = make(&mut random);
        let placed = any_plane(&mut random);
        check_tiling(&mut random, &tiling, placed, &mut tally);
    }
    // the tests are about rays at edges: most must have been too close for the point to decide
    assert!(
        1000 <= tally.rays && tally.rays < 2 * tally.by_ray,
        "{tally:?}"
    );
}

#[test]
fn four_squares_around_a_corner_take_the_ray_through_it_once() {
    let mut tally = Tally::default();
    let square = |x: f64, y: f64| {
        let corners = [(x, y), (x + 1.0, y), (x + 1.0, y + 1.0), (x, y + 1.0)];
        Polygon::new(corners.map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec(), None).unwrap()
    };
    let squares = [(0.0, 0.0), (-1.0, 0.0), (0.0, -1.0), (-1.0, -1.0)].map(|(x, y)| square(x, y));
    // straight down, and along every combination of signs: the shortest axis differs, or is tied
    for x in -2..=2 {
        for y in -2..=2 {
            let away = DVec3::new(f64::from(x), f64::from(y), 1.0);
            check(&squares, &Ray::new(away, -away), &mut tally);
            check(&squares, &Ray::new(-away, away), &mut tally);
        }
    }
    assert_eq!(tally.by_ray, 50);
}

#[test]
fn a_grid_of_quads_takes_every_ray_once() {
    check_everywhere(1, |_| grid());
}

#[test]
fn a_fan_of_triangles_takes_every_ray_once() {
    for count in [3, 4, 7, 24] {
        check_everywhere(2, |_| fan(count));
    }
}

#[test]
fn irregular_tiles_take_every_ray_once() {
    for seed in 3..8 {
        check_everywhere(seed, irregular);
    }
}

#[test]
fn neighbours_that_are_planar_within_tolerance_only_take_every_ray_once() {
    // Heights are off by up to 0.4·10⁻⁵: the planes of two neighbours differ, their vertices do not.
    // p′ of a ray at an edge then lies on different sides in the two, by much more than rounding.
    let mut random = Seeded::new(9);
    let mut tally = Tally::default();
    for _ in 0..12 {
        let placed = any_plane(&mut random);
        let (size, normal) = (placed.u.length(), placed.u.cross(placed.v).normalize());
        let mut heights = Vec::new();
        heights.resize_with(49, || random.within(-4e-6, 4e-6));
        let corner = |x: i32, y: i32| {
            let flat = placed.point(DVec2::new(f64::from(x), f64::from(y)));
            flat + size * heights[(x + 3 + 7 * (y + 3)) as usize] * normal
        };
        let quad = |(x, y)| {
            [
                corner(x, y),
                corner(x + 1, y),
                corner(x + 1, y + 1),
                corner(x, y + 1),
            ]
        };
        let places = (-3..3).flat_map(|x| (-3..3).map(move |y| (x, y)));
        let polygons: Vec<_> = places
            .map(|place| Polygon::new(quad(place).to_vec(), None).unwrap())
            .collect();
        for _ in 0..RAYS {
            let (x, y) = (random.whole(-2, 2), random.whole(-2, 2));
            let (from, to) = (
                corner(x, y),
                if random.sign() < 0.0 {
                    corner(x + 1, y)
                } else {
                    corner(x, y + 1)
                },
            );
            let beside = size * random.power(-16.0, -4.0) * random.direction();
            let goal = from + 0.999 * random.unit() * (to - from) + beside;
            let away = size * (5.0 * random.direction() + 7.0 * random.sign() * normal);
            check(&polygons, &Ray::through(goal + away, goal), &mut tally);
        }
    }
    assert!(tally.rays < 2 * tally.by_ray, "{tally:?}");
}
