//! The grid finds what is found when every object is tested: the same object at the same t, bit for bit.

use glam::DVec3;
use raystep::geometry::{Ray, TRange};
use raystep::strategy::{Exhaustive, Strategy, UniformGrid};
use raystep::structure::{GridOptions, Lists};
use raystep::trace::WalkEnd;
use raystep::{Event, Off, Record, Recording, Scene};

use crate::grid_exact::{scene, sphere};
use crate::seeded::Seeded;

/// A shape of any kind, about as large as `size`.
fn shape(random: &mut Seeded, size: f64) -> String {
    let at = random.point(4.0);
    let mut near = || (at + random.point(size)).to_array();
    let (a, b, c) = (near(), near(), near());
    let mut length = || size * random.power(-1.0, 0.0);
    let (r, s) = (length(), length());
    let [x, y, z] = at.to_array();
    match random.index(7) {
        0 | 1 => sphere([x, y, z], r),
        2 => format!(r#""ellipsoid": {{"center": {a:?}, "radii": [{r}, {s}, {size}]}}"#),
        3 => {
            let max = [x + r, y + s, z + size];
            format!(r#""box": {{"min": [{x}, {y}, {z}], "max": {max:?}}}"#)
        }
        4 => format!(
            r#""cone": {{"base": {a:?}, "base_radius": {r}, "apex": {b:?}, "apex_radius": {s}}}"#
        ),
        5 => format!(r#""polygon": {{"vertices": [{a:?}, {b:?}, {c:?}]}}"#),
        // an L in a plane across an axis, which may lie in a plane of the grid
        _ => {
            let outline = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]];
            let height = z.round();
            let vertices =
                outline.map(|[u, v]| [x + size * f64::from(u), y + size * f64::from(v), height]);
            format!(r#""polygon": {{"vertices": {vertices:?}}}"#)
        }
    }
}

fn random_scene(random: &mut Seeded) -> Scene {
    let size = random.power(-1.0, 0.7);
    let count = random.index(40) + 1;
    let mut shapes: Vec<_> = (0..count).map(|_| shape(random, size)).collect();
    // twins are met at equal t
    shapes.push(shapes[0].clone());
    scene(&shapes)
}

/// From anywhere to anywhere, or along an axis, or from the surface of something.
fn ray(random: &mut Seeded, scene: &Scene) -> (Ray, TRange) {
    let from = random.point(9.0);
    let direction = match random.index(4) {
        0 => DVec3::AXES[random.index(3)] * random.sign(),
        1 => random.direction(),
        _ => (random.point(4.0) - from).normalize(),
    };
    let eye = Ray::new(from, direction);
    let hit = Exhaustive::new(scene).nearest(&eye, TRange::FORWARD, &mut Off);
    match (hit, random.index(2)) {
        (Some(hit), 0) => {
            let min = 1e-9 * hit.t.max(1.0);
            let max = random.power(-1.0, 1.5);
            let away = Ray::new(eye.at(hit.t), random.direction());
            (away, TRange { min, max })
        }
        _ => (eye, TRange::FORWARD),
    }
}

#[test]
fn the_grid_finds_the_same_object_at_the_same_t_as_every_object_tested() {
    let mut random = Seeded::new(71);
    let mut hits = 0;
    for _ in 0..120 {
        let scene = random_scene(&mut random);
        let every = Exhaustive::new(&scene);
        let mut grids = Vec::new();
        for lists in [Lists::Objects, Lists::Boxes] {
            for mailboxes in [true, false] {
                let resolution = match random.index(3) {
                    0 => None,
                    _ => Some([0; 3].map(|_| random.whole(1, 9) as u32)),
                };
                let options = GridOptions {
                    resolution,
                    lists,
                    mailboxes,
                    density: random.power(-1.0, 1.5),
                };
                grids.push((options, UniformGrid::new(&scene, &options).unwrap()));
            }
        }
        for _ in 0..150 {
            let (ray, range) = ray(&mut random, &scene);
            let expected = every.nearest(&ray, range, &mut Off);
            hits += usize::from(expected.is_some());
            for (options, grid) in &grids {
                let found = grid.nearest(&ray, range, &mut Off);
                assert_eq!(found, expected, "{ray:?} {range:?} {options:?}");
                let blocked = grid.any(&ray, range, &mut Off).is_some();
                assert_eq!(blocked, expected.is_some(), "{ray:?} {range:?} {options:?}");
            }
        }
    }
    assert!(1500 < hits, "{hits}");
}

/// Fig. 15.62: a long object is listed in the first cell and hit in a later one, behind a nearer object.
fn hit_in_a_later_cell(mailboxes: bool) -> (Scene, GridOptions) {
    // the plane leans from (0, −½) to (4, ½): the ray y = 0.4 meets it at x = 3.6; the sphere at x = 2.7
    let leaning =
        r#""polygon": {"vertices": [[0, -0.5, -1], [4, 0.5, -1], [4, 0.5, 1], [0, -0.5, 1]]}"#;
    let scene = scene(&[leaning.to_string(), sphere([3.0, 0.4, 0.0], 0.3)]);
    let options = GridOptions {
        resolution: Some([2, 1, 1]),
        mailboxes,
        ..GridOptions::default()
    };
    (scene, options)
}

fn events(mailboxes: bool) -> Vec<Event> {
    let (scene, options) = hit_in_a_later_cell(mailboxes);
    let grid = UniformGrid::new(&scene, &options).unwrap();
    let ray = Ray::new(DVec3::new(-1.0, 0.4, 0.0), DVec3::X);
    let mut recording = Recording::new(Vec::new());
    let hit = grid.nearest(&ray, TRange::FORWARD, &mut recording).unwrap();
    assert_eq!(hit.object.0, 1);
    assert!((hit.t - 3.7).abs() <= 1e-12, "{hit:?}");
    let records: Vec<Record> = recording.into_sink();
    records.into_iter().map(|record| record.event).collect()
}

/// The kinds of the events, without the tests' own working.
fn kinds(events: &[Event]) -> Vec<&'static str> {
    let all = events.iter().map(|event| event.kind().name());
    all.filter(|kind| !["edge", "polygon_test"].contains(kind))
        .collect()
}

#[test]
fn a_hit_beyond_its_cell_is_kept_and_the_walk_goes_on_to_a_nearer_one() {
    let expected = [
        "grid_enter",
        "cell",
        "listed",
        "plane_test",
        "nearest",
        "hit_outside_cell",
        "cell",
        "listed",
        "mailbox",
        "listed",
        "sphere_test",
        "nearest",
        "grid_exit",
    ];
    assert_eq!(kinds(&events(true)), expected);
}

#[test]
fn without_mailboxes_an_object_is_tested_again_in_every_cell() {
    let expected = [
        "grid_enter",
        "cell",
        "listed",
        "plane_test",
        "nearest",
        "hit_outside_cell",
        "cell",
        "listed",
        "plane_test",
        "listed",
        "sphere_test",
        "nearest",
        "grid_exit",
    ];
    assert_eq!(kinds(&events(false)), expected);
}

#[test]
fn a_walk_says_why_it_ended() {
    let (scene, options) = hit_in_a_later_cell(true);
    let grid = UniformGrid::new(&scene, &options).unwrap();
    let end = |from: [f64; 3], to: DVec3| {
        let mut recording = Recording::new(Vec::new());
        grid.nearest(&Ray::new(from.into(), to), TRange::FORWARD, &mut recording);
        let records: Vec<Record> = recording.into_sink();
        match records.last().map(|record| record.event) {
            Some(Event::GridExit(exit)) => (exit.end, exit.cells),
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(end([-1.0, 0.4, 0.0], DVec3::X), (WalkEnd::HitInCell, 2));
    assert_eq!(end([-1.0, 0.45, 0.9], DVec3::Y), (WalkEnd::Outside, 0));
    // away from where the plane is at y = 0.45, x = 3.8, and beside the sphere
    assert_eq!(end([1.0, 0.45, 0.9], -DVec3::X), (WalkEnd::Left, 1));
}
