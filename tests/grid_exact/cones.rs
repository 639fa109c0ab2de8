//! The cells that list a cone, against points of its surface.

use std::f64::consts::TAU;

use glam::DVec3;
use raystep::scene::PrimitiveId;
use raystep::structure::{Grid, GridOptions};

use crate::grid_exact::scene;
use crate::seeded::Seeded;

/// Cones in all.
const CONES: usize = 600;
/// Points of each, along it and around it.
const SAMPLES: [u32; 2] = [24, 48];

/// Somewhere on the axes, on a lattice, or anywhere; with a height from flat to long.
fn cone(random: &mut Seeded, scale: f64) -> [([f64; 3], f64); 2] {
    let whole = random.index(2) == 0;
    let number = |random: &mut Seeded, size: i32| {
        if whole {
            f64::from(random.whole(-size, size))
        } else {
            random.within(-f64::from(size), f64::from(size))
        }
    };
    // many sizes away from the origin, where coordinates are rounded most
    let away = [0.0, 0.0, 1e3, 1e6][random.index(4)];
    loop {
        let base = [0; 3].map(|_| number(random, 4) + away);
        let mut apex = base;
        match random.index(3) {
            0 => apex[random.index(3)] += number(random, 4),
            1 => apex = apex.map(|x| x + number(random, 4)),
            // nearly along an axis
            _ => {
                let along = random.index(3);
                apex[along] += 1.0 + random.unit();
                apex[(along + 1) % 3] += random.power(-12.0, -1.0);
            }
        }
        let radii = [
            number(random, 3).abs(),
            [0.0, number(random, 3).abs()][random.index(2)],
        ];
        // a scene refuses what has no height or no radius
        if apex != base && 1e-3 < radii[0].max(radii[1]) {
            let scaled = |p: [f64; 3]| p.map(|x| x * scale);
            return [
                (scaled(base), radii[0] * scale),
                (scaled(apex), radii[1] * scale),
            ];
        }
    }
}

/// The cell of the grid in which a point lies; it owns its lower faces.
fn cell_of(grid: &Grid, p: DVec3) -> [u32; 3] {
    [0, 1, 2].map(|axis| {
        let planes = grid.planes(axis);
        let inner = &planes[1..planes.len() - 1];
        inner.partition_point(|&plane| plane <= p[axis]) as u32
    })
}

/// How far is a point from the solid cone, its ends closed? In the plane of the axis and the point, where the
/// solid is a trapezoid, and by ternary search along its slanted side.
fn distance([(base, r), (apex, s)]: [([f64; 3], f64); 2], p: DVec3) -> f64 {
    let (base, apex) = (DVec3::from(base), DVec3::from(apex));
    let height = (apex - base).length();
    let axis = (apex - base) / height;
    let y = (p - base).dot(axis);
    let from_axis = (p - base - y * axis).length();
    let to = |share: f64| {
        let beside = (from_axis - (r + share * (s - r))).max(0.0);
        (y - share * height).hypot(beside)
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..200 {
        let [a, b] = [(2.0 * low + high) / 3.0, (low + 2.0 * high) / 3.0];
        if to(a) <= to(b) {
            high = b;
        } else {
            low = a;
        }
    }
    to(0.5 * (low + high))
}

#[test]
fn a_cone_is_in_the_list_of_every_cell_that_a_point_of_its_surface_lies_in() {
    let mut random = Seeded::new(16);
    let (mut listed, mut needless, mut all) = (0, 0, 0);
    for _ in 0..CONES {
        let scale = 10f64.powi(random.whole(-20, 20));
        let ends = cone(&mut random, scale);
        let [(base, r), (apex, s)] = ends;
        let text = format!(
            r#""cone": {{"base": {base:?}, "base_radius": {r:?}, "apex": {apex:?}, "apex_radius": {s:?}}}"#
        );
        let options = GridOptions {
            resolution: Some([0; 3].map(|_| random.whole(1, 9) as u32)),
            ..GridOptions::default()
        };
        let grid = Grid::new(&scene(std::slice::from_ref(&text)), &options).unwrap();

        // the surface, by two angles across the axis that are no concern of the code's
        let [base, apex] = [base, apex].map(DVec3::from);
        let axis = (apex - base).normalize();
        let u = random.across(axis);
        let v = axis.cross(u);
        for along in 0..=SAMPLES[0] {
            let share = f64::from(along) / f64::from(SAMPLES[0]);
            let (middle, radius) = (base.lerp(apex, share), r + share * (s - r));
            for around in 0..SAMPLES[1] {
                let angle = TAU * f64::from(around) / f64::from(SAMPLES[1]);
                let p = middle + radius * (angle.cos() * u + angle.sin() * v);
                let cell = cell_of(&grid, p);
                assert!(
                    grid.cell_objects(cell).contains(&PrimitiveId(0)),
                    "{p} is in cell {cell:?} of {:?}, which does not list {text}",
                    grid.resolution()
                );
            }
        }

        // and no cell that is nowhere near
        let [nx, ny, nz] = grid.resolution();
        let cells =
            (0..nx).flat_map(move |i| (0..ny).flat_map(move |j| (0..nz).map(move |k| [i, j, k])));
        for cell in cells {
            all += 1;
            if grid.cell_objects(cell).is_empty() {
                continue;
            }
            listed += 1;
            let corner = |by: u32| {
                DVec3::from([0, 1, 2].map(|a: usize| grid.planes(a)[(cell[a] + by) as usize]))
            };
            let (middle, half) = (0.5 * (corner(0) + corner(1)), 0.5 * (corner(1) - corner(0)));
            let off = distance(ends, middle);
            // widened by 1e-10 of the coordinates, those of the eye at (0, 0, 9) among them; and the solid's own
            // distance is found to 1e-7
            let room = 1e-7 * (base.length() + apex.length() + r + s) + 1e-8;
            needless += usize::from(half.length() + room < off);
        }
    }
    // where a cell nearly touches, a step towards 0 may gain nothing: then it is listed
    assert!(
        needless <= listed / 1000,
        "{needless} of {listed} are nowhere near"
    );
    // else every cell might be listed
    assert!(
        all / 10 <= listed && listed <= all - all / 10,
        "{listed} of {all}"
    );
}
