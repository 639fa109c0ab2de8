//! The uniform grid against exact arithmetic: which cells a ray pierces, in which order; and what it finds
//! against every object tested.
//!
//! A cell is pierced if the ray, within its range, is in it for more than a single t, where a cell owns its
//! lower faces. The oracle takes the grid's planes as they are, sorts the t of all planes as exact fractions and
//! looks between each two of them: nothing of the walk is used, and nothing is rounded.

mod cones;
mod lists;
mod same_hits;

use std::cmp::Ordering;

use glam::DVec3;
use raystep::geometry::{Ray, TRange};
use raystep::structure::{Across, CellStep, Grid, GridOptions};
use raystep::{NoFiles, Scene, load_bytes};

use crate::exact::Exact;
use crate::seeded::Seeded;

/// A scene of these shapes, in the words of the scene file.
fn scene(shapes: &[String]) -> Scene {
    let objects: Vec<_> = shapes
        .iter()
        .enumerate()
        .map(|(i, shape)| format!(r#"{{"name": "o{i}", "material": "m", "shape": {{{shape}}}}}"#))
        .collect();
    let text = format!(
        r#"{{"camera": {{"look_at": {{"cop": [0, 0, 9], "target": [0, 0, 0], "up": [0, 1, 0],
        "fov_degrees": 60}}, "pixels": [8, 8]}},
        "materials": {{"m": {{"colour": [1, 1, 1]}}}}, "objects": [{}]}}"#,
        objects.join(",")
    );
    let loaded = load_bytes("scene.json", text.as_bytes(), &NoFiles);
    loaded.unwrap().build().unwrap()
}

fn sphere([x, y, z]: [f64; 3], radius: f64) -> String {
    format!(r#""sphere": {{"center": [{x}, {y}, {z}], "radius": {radius}}}"#)
}

/// A grid around a box with these corners.
fn grid_around(min: [f64; 3], max: [f64; 3], resolution: [u32; 3]) -> Grid {
    let solid = format!(r#""box": {{"min": {min:?}, "max": {max:?}}}"#);
    let options = GridOptions {
        resolution: Some(resolution),
        ..GridOptions::default()
    };
    Grid::new(&scene(&[solid]), &options).unwrap()
}

/// A fraction with a denominator above 0.
#[derive(Clone, Debug)]
struct Fraction {
    above: Exact,
    below: Exact,
}

impl Fraction {
    fn new(above: Exact, below: Exact) -> Self {
        if below.sign() < 0 {
            return Self {
                above: -&above,
                below: -&below,
            };
        }
        Self { above, below }
    }

    fn of(value: f64) -> Self {
        Self::new(Exact::from(value), Exact::from(1.0))
    }

    fn order(&self, other: &Self) -> Ordering {
        let difference = &self.above * &other.below - &other.above * &self.below;
        difference.sign().cmp(&0)
    }

    /// Is an f64 this fraction, within a share of it?
    fn is_about(&self, value: f64, share: f64) -> bool {
        let off = (Exact::from(value) * self.below.clone() - self.above.clone()).abs();
        (off - Exact::from(share) * self.above.abs()).sign() <= 0
    }
}

/// A cell that the ray pierces, as exact arithmetic has it.
#[derive(Debug)]
struct Pierced {
    cell: [u32; 3],
    t_in: Fraction,
    t_out: Option<Fraction>,
    across: Across,
}

/// t of the planes of one axis in the order in which the ray meets them; none if it does not move along it.
fn meetings(grid: &Grid, ray: &Ray, axis: usize) -> Vec<Fraction> {
    let direction = Exact::from(ray.direction[axis]);
    let origin = Exact::from(ray.origin[axis]);
    if direction.sign() == 0 {
        return Vec::new();
    }
    let t = |&plane: &f64| Fraction::new(Exact::from(plane) - origin.clone(), direction.clone());
    let mut found: Vec<_> = grid.planes(axis).iter().map(t).collect();
    if direction.sign() < 0 {
        found.reverse();
    }
    found
}

/// The cells that the ray pierces, by the definition.
fn pierced(grid: &Grid, ray: &Ray, range: TRange) -> Vec<Pierced> {
    let met = [0, 1, 2].map(|axis| meetings(grid, ray, axis));
    let end = range.max.is_finite().then(|| Fraction::of(range.max));
    let is_within = |t: &Fraction| {
        let end = end.as_ref();
        end.is_none_or(|end| t.order(end) == Ordering::Less)
    };
    let mut now = Fraction::of(range.min);
    let mut found = Vec::new();
    // how many planes of each axis are met at `now` or before
    let mut passed = [0; 3];
    while is_within(&now) {
        for axis in 0..3 {
            let is_met = |t: &Fraction| t.order(&now) != Ordering::Greater;
            while met[axis].get(passed[axis]).is_some_and(is_met) {
                passed[axis] += 1;
            }
        }
        let heads = [0, 1, 2].map(|axis| met[axis].get(passed[axis]));
        let next = heads
            .into_iter()
            .flatten()
            .min_by(|a, b| a.order(b))
            .cloned();
        let places = [0, 1, 2].map(|axis| place(grid, ray, axis, passed[axis]));
        if let [Some(i), Some(j), Some(k)] = places {
            let is_next = |head: Option<&Fraction>| match (head, &next) {
                (Some(head), Some(next)) => head.order(next) == Ordering::Equal,
                _ => false,
            };
            found.push(Pierced {
                cell: [i, j, k],
                t_in: now.clone(),
                t_out: next.clone(),
                across: across(heads.map(is_next)),
            });
        }
        match next {
            Some(next) => now = next,
            None => break,
        }
    }
    found
}

/// The cell along an axis in which the ray is when it has met so many planes.
fn place(grid: &Grid, ray: &Ray, axis: usize, passed: usize) -> Option<u32> {
    let planes = grid.planes(axis);
    let cells = planes.len() - 1;
    let origin = ray.origin[axis];
    let place = if ray.direction[axis] == 0.0 {
        if planes[cells] == origin {
            cells - 1
        } else {
            let below = planes.iter().filter(|&&plane| plane <= origin).count();
            below.checked_sub(1)?
        }
    } else if 0.0 < ray.direction[axis] {
        passed.checked_sub(1)?
    } else {
        if passed == 0 {
            return None;
        }
        cells.checked_sub(passed)?
    };
    (place < cells).then_some(place as u32)
}

fn across(steps: [bool; 3]) -> Across {
    match steps {
        [false, false, false] => Across::None,
        [true, false, false] => Across::X,
        [false, true, false] => Across::Y,
        [false, false, true] => Across::Z,
        [true, true, false] => Across::XY,
        [true, false, true] => Across::XZ,
        [false, true, true] => Across::YZ,
        [true, true, true] => Across::XYZ,
    }
}

/// A t is rounded three times, by half an ε each.
const T_IS_RIGHT: f64 = 4.0 * f64::EPSILON;

/// The walk visits the cells that exact arithmetic says, in order; returns how many.
#[track_caller]
fn check(grid: &Grid, ray: &Ray, range: TRange) -> usize {
    let expected = pierced(grid, ray, range);
    let found: Vec<CellStep> = grid.walk(ray, range).collect();
    let cells = |steps: &[CellStep]| steps.iter().map(|step| step.cell).collect::<Vec<_>>();
    let should_be: Vec<_> = expected.iter().map(|of| of.cell).collect();
    let context = || format!("{ray:?} {range:?} in {:?}", grid.resolution());
    assert_eq!(cells(&found), should_be, "{}", context());
    for (step, of) in found.iter().zip(&expected) {
        assert_eq!(step.across, of.across, "{step:?} {}", context());
        let right_in = of.t_in.is_about(step.t_in, T_IS_RIGHT);
        let right_out = match &of.t_out {
            Some(t_out) => t_out.is_about(step.t_out, T_IS_RIGHT),
            None => step.t_out == f64::INFINITY,
        };
        assert!(right_in && right_out, "{step:?} {of:?} {}", context());
        assert!(step.t_in <= step.t_out, "{step:?} {}", context());
    }
    found.len()
}

/// Grids with cell sides that f64 has exactly and others, flat and long ones.
fn grids() -> Vec<Grid> {
    vec![
        grid_around([-2.0; 3], [2.0; 3], [1; 3]),
        grid_around([-2.0; 3], [2.0; 3], [4; 3]),
        grid_around([-1.0; 3], [1.0; 3], [7; 3]),
        grid_around([-3.0, 0.1, -0.2], [1.0, 0.7, 0.1], [13, 1, 3]),
        grid_around([100.0, -0.3, 7.0], [103.0, 11.0, 7.5], [3, 11, 2]),
        grid_around([-1e6, -1.0, 0.0], [1e6, 1e-3, 1e-6], [5, 9, 4]),
    ]
}

/// A coordinate that is on a plane, between two, in the grid or beyond it.
fn coordinate(random: &mut Seeded, grid: &Grid, axis: usize) -> f64 {
    let planes = grid.planes(axis);
    let (low, high) = (planes[0], planes[planes.len() - 1]);
    match random.index(6) {
        0..=2 => planes[random.index(planes.len())],
        3 => {
            let at = random.index(planes.len() - 1);
            0.5 * (planes[at] + planes[at + 1])
        }
        4 => random.within(low, high),
        _ => random.within(2.0 * low - high, 2.0 * high - low),
    }
}

fn point(random: &mut Seeded, grid: &Grid) -> DVec3 {
    DVec3::from_array([0, 1, 2].map(|axis| coordinate(random, grid, axis)))
}

/// Rays that walks stumble over: between special points, along axes and diagonals, of any length.
fn hard_ray(random: &mut Seeded, grid: &Grid) -> Ray {
    let from = point(random, grid);
    let mut direction = match random.index(4) {
        // through a plane, an edge or a corner further on
        0 | 1 => point(random, grid) - from,
        // diagonals, also of a single face, and axes
        2 => DVec3::from_array([0; 3].map(|_| f64::from(random.whole(-1, 1)))),
        _ => {
            let cells = grid.resolution().map(f64::from);
            grid.around().size() / DVec3::from(cells) * random.sign()
        }
    };
    for axis in 0..3 {
        match random.index(8) {
            0 => direction[axis] = 0.0,
            1 => direction[axis] = -0.0,
            2 => direction[axis] = -direction[axis],
            _ => {}
        }
    }
    if random.index(8) == 0 {
        direction *= random.power(-300.0, 200.0);
    }
    // back out of the grid, to where the direction is kept as far as rounding lets it
    let back = match random.index(4) {
        0 => 1.0,
        1 => random.power(0.0, 12.0),
        _ => 0.0,
    };
    let origin = from - back * direction;
    Ray::new(if origin.is_finite() { origin } else { from }, direction)
}

/// A range that is open, or cut where the ray meets a plane, or anywhere.
fn hard_range(random: &mut Seeded, grid: &Grid, ray: &Ray) -> TRange {
    let mut end = |open: f64| {
        let axis = random.index(3);
        let t = (coordinate(random, grid, axis) - ray.origin[axis]) / ray.direction[axis];
        match random.index(4) {
            0 if t.is_finite() => t.max(0.0),
            _ => open,
        }
    };
    TRange {
        min: end(0.0),
        max: end(f64::INFINITY),
    }
}

#[test]
fn hard_rays_pierce_the_cells_that_exact_arithmetic_says() {
    let mut random = Seeded::new(61);
    let mut pierced = 0;
    for grid in &grids() {
        for _ in 0..3000 {
            let ray = hard_ray(&mut random, grid);
            let range = hard_range(&mut random, grid, &ray);
            pierced += check(grid, &ray, range);
        }
    }
    // most of them do hit the grid
    assert!(18_000 < pierced, "{pierced}");
}

#[test]
fn random_rays_pierce_the_cells_that_exact_arithmetic_says() {
    let mut random = Seeded::new(62);
    let mut pierced = 0;
    for grid in &grids() {
        let around = grid.around();
        let (middle, size) = (0.5 * (around.min + around.max), around.size());
        for _ in 0..700 {
            let to = middle + 0.5 * size * random.point(1.0);
            let from = middle + size * random.point(2.0);
            pierced += check(grid, &Ray::through(from, to), TRange::FORWARD);
        }
    }
    assert!(4200 < pierced, "{pierced}");
}

#[test]
fn the_diagonals_of_a_cube_pass_through_every_corner_on_their_way() {
    // planes of the three axes are the same numbers, so t is the same for all three
    for n in [1, 3, 7, 10] {
        let grid = grid_around([-1.0; 3], [1.0; 3], [n; 3]);
        for sign in [1.0, -1.0] {
            let ray = Ray::new(DVec3::splat(-3.0 * sign), DVec3::splat(sign / 3.0));
            let steps: Vec<_> = grid.walk(&ray, TRange::FORWARD).collect();
            assert_eq!(steps.len(), n as usize);
            assert!(steps.iter().all(|step| step.across == Across::XYZ));
            check(&grid, &ray, TRange::FORWARD);
        }
    }
}

#[test]
fn rays_from_far_away_are_exact_where_f64_is_not() {
    let grid = grid_around([-1.0; 3], [1.0; 3], [9, 8, 7]);
    let mut random = Seeded::new(63);
    for _ in 0..500 {
        let far = random.power(3.0, 18.0) * random.direction();
        // whole multiples of a point on the way back, so that the line does meet the grid
        let direction = -far * random.power(-20.0, 0.0);
        check(&grid, &Ray::new(far, direction), TRange::FORWARD);
    }
}
