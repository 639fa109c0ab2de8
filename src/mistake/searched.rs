//! The search with bounds or with a grid, a step of which may be wrong: for pictures of mistakes in those steps.
//!
//! Both are written so that one function can be replaced, and nothing in them is there for speed. With the right functions
//! they find the hits that testing every object finds.

use std::collections::HashSet;

use crate::geometry::{Inside, Ray, SlabRay, TRange};
use crate::mistake::Wrong;
use crate::mistake::spoil::{Pair, differ, pair, words};
use crate::scene::{PrimitiveId, Scene};
use crate::strategy::{Hit, is_passed};
use crate::structure::{Across, Grid, GridError, GridOptions, SlabBound, SlabSet};
use crate::trace::{BoundVerdict, SpoiltValue};
use crate::tracer::simple::{Own, Parts};

/// The axes and the diagonals of a cube.
const SLABS: SlabSet<7> = SlabSet::SEVEN;

/// What a wrong function is a step of.
pub(super) enum Structure {
    /// A bound of slabs around each primitive.
    Bounds(Vec<SlabBound<7>>),
    /// A grid over the scene.
    Grid(Grid),
}

/// What a search found, and what it took.
pub(super) struct Searched {
    pub(super) hit: Option<Hit>,
    pub(super) tests: u64,
    pub(super) cells: u64,
    /// What the wrong function returned first that the right one does not.
    pub(super) spoilt: Vec<Pair>,
}

impl Structure {
    /// The structure that a function belongs to; `None` of all that need no structure.
    ///
    /// # Errors
    /// A scene that is too large for a grid.
    pub(super) fn of(scene: &Scene, wrong: &Wrong) -> Result<Option<Self>, GridError> {
        Ok(match wrong {
            Wrong::SlabInterval(_) | Wrong::SlabsSoFar(_) | Wrong::Bound(_) => {
                let bounds = scene.primitives.iter();
                let bounds = bounds.map(|of| SlabBound::of(&of.shape, &SLABS));
                Some(Self::Bounds(bounds.collect()))
            }
            Wrong::PlanesCrossed(_)
            | Wrong::NextPlane(_)
            | Wrong::CellsVisited(_)
            | Wrong::WalkEnds(_) => Some(Self::Grid(Grid::new(scene, &GridOptions::default())?)),
            _ => None,
        })
    }

    /// The nearest hit in the range, by the wrong function or by the right one.
    pub(super) fn search(
        &self,
        scene: &Scene,
        ray: &Ray,
        range: TRange,
        wrong: Option<&Wrong>,
    ) -> Searched {
        let mut search = Search {
            scene,
            ray,
            range,
            tested: HashSet::new(),
            found: Searched {
                hit: None,
                tests: 0,
                cells: 0,
                spoilt: Vec::new(),
            },
        };
        match self {
            Self::Bounds(bounds) => by_bounds(&mut search, bounds, wrong),
            Self::Grid(grid) => by_grid(&mut search, grid, wrong),
        }
        search.found
    }
}

/// A search that goes on.
struct Search<'a> {
    scene: &'a Scene,
    ray: &'a Ray,
    /// Up to the nearest hit so far.
    range: TRange,
    tested: HashSet<PrimitiveId>,
    found: Searched,
}

impl Search<'_> {
    /// Tests an object once. Of two hits at equal t the one first in the scene stays.
    fn test(&mut self, object: PrimitiveId) {
        if !self.tested.insert(object) {
            return;
        }
        self.found.tests += 1;
        let Some(t) = Own.hit(self.scene.primitive(object), self.ray, self.range) else {
            return;
        };
        let is_nearer = |hit: Hit| t < hit.t || (t == hit.t && object.0 < hit.object.0);
        if self.found.hit.is_none_or(is_nearer) {
            self.found.hit = Some(Hit { object, t });
        }
    }

    /// t of the nearest hit so far.
    fn nearest(&self) -> f64 {
        self.found.hit.map_or(f64::INFINITY, |hit| hit.t)
    }

    /// Keeps the first quantities that differ.
    fn note(&mut self, pairs: Vec<Pair>) {
        let differs = |(_, [right, wrong]): &Pair| differ(right, wrong);
        if self.found.spoilt.is_empty() && pairs.iter().any(differs) {
            self.found.spoilt = pairs;
        }
    }
}

fn verdict_word(of: BoundVerdict) -> &'static str {
    match of {
        BoundVerdict::Hit => "hit",
        BoundVerdict::Missed => "missed",
        BoundVerdict::Behind => "behind the origin",
        BoundVerdict::Beyond => "beyond the nearest hit",
    }
}

/// "The object need not be tested if the ray fails to intersect with its bounding volume."
fn by_bounds(search: &mut Search, bounds: &[SlabBound<7>], wrong: Option<&Wrong>) {
    let ray = search.ray;
    let lines = SLABS.directions().iter();
    let lines: Vec<SlabRay> = lines.map(|normal| SlabRay::new(ray, *normal)).collect();
    for (object, bound) in (0..).map(PrimitiveId).zip(bounds) {
        let mut so_far = Inside::EVERYWHERE;
        for (slab, line) in lines.iter().enumerate() {
            let [d_min, d_max] = [bound.d_min[slab], bound.d_max[slab]];
            // a little wider than it is, since a hit is rounded
            let room = ROOM * (1.0 + line.s.abs() + d_min.abs().max(d_max.abs()));
            let [d_min, d_max] = [d_min - room, d_max + room];
            let right = line.interval(d_min, d_max);
            let interval = match wrong {
                Some(Wrong::SlabInterval(wrong)) => wrong(line, d_min, d_max),
                _ => right,
            };
            if interval != right {
                let [right, wrong] = [right, interval].map(|of| Inside::EVERYWHERE.and(of));
                search.note(vec![
                    pair("near of a slab", [&right, &wrong], |of| of.near),
                    pair("far of a slab", [&right, &wrong], |of| of.far),
                ]);
            }
            let before = so_far;
            so_far = match wrong {
                Some(Wrong::SlabsSoFar(wrong)) => wrong(before, interval),
                _ => before.and(interval),
            };
            let right = before.and(interval);
            if so_far != right {
                search.note(vec![
                    pair("max near", [&right, &so_far], |of| of.near),
                    pair("min far", [&right, &so_far], |of| of.far),
                ]);
            }
            if so_far.is_empty() {
                break;
            }
        }
        let ends = so_far.ends();
        let right = BoundVerdict::of(ends, search.range);
        let verdict = match wrong {
            Some(Wrong::Bound(wrong)) => wrong(ends, search.range),
            _ => right,
        };
        if (verdict == BoundVerdict::Hit) != (right == BoundVerdict::Hit) {
            search.note(vec![pair("bound", [&right, &verdict], |of| {
                verdict_word(*of)
            })]);
        }
        if verdict == BoundVerdict::Hit {
            search.test(object);
        }
    }
}

/// Of the coordinates: a computed root is good to 10⁻¹⁰ of them.
const ROOM: f64 = 1e-9;

/// Cell by cell, until the nearest hit lies in its cell.
fn by_grid(search: &mut Search, grid: &Grid, wrong: Option<&Wrong>) {
    if let Some(Wrong::CellsVisited(wrong)) = wrong {
        let right: Vec<[u32; 3]> = grid
            .walk(search.ray, search.range)
            .map(|of| of.cell)
            .collect();
        let visited = wrong(&grid.around(), grid.resolution(), search.ray, search.range);
        if let Some(skipped) = right.iter().find(|cell| !visited.contains(cell)) {
            let count = |cells: &Vec<[u32; 3]>| cells.len() as f64;
            let name = format!("cell {}", cell_name(*skipped));
            search.note(vec![
                pair(name, [&true, &false], |is| {
                    words(*is, ["visited", "skipped"])
                }),
                pair("cells on the ray", [&right, &visited], count),
            ]);
        }
        for cell in visited {
            let next = next_planes(search, grid, cell, right_plane);
            let t_out = next.into_iter().fold(f64::INFINITY, f64::min);
            if visit(search, grid, cell, t_out, None) {
                break;
            }
        }
        return;
    }
    let Some(mut cell) = grid.walk(search.ray, search.range).next().map(|of| of.cell) else {
        return;
    };
    loop {
        let next_plane = match wrong {
            Some(Wrong::NextPlane(wrong)) => *wrong,
            _ => right_plane,
        };
        let next = next_planes(search, grid, cell, next_plane);
        let right = next_planes(search, grid, cell, right_plane);
        if let Some(axis) = (0..3).find(|&axis| next[axis] != right[axis]) {
            let name = [
                "t of the next x plane",
                "t of the next y plane",
                "t of the next z plane",
            ];
            search.note(vec![pair(name[axis], [&right, &next], |t| t[axis])]);
        }
        let smallest = next.into_iter().fold(f64::INFINITY, f64::min);
        let first = bits(|axis| next[axis] == smallest && next[axis].is_finite());
        let crossed = match wrong {
            Some(Wrong::PlanesCrossed(wrong)) => bits_of(wrong(next)),
            _ => first,
        };
        let across = (0..3).filter(|axis| 0 < crossed & 1 << axis);
        let t_out = across.map(|axis| next[axis]).fold(f64::INFINITY, f64::min);
        let [behind, right] = [crossed, first].map(|of| cell_behind(search, grid, cell, of));
        if crossed != first {
            let word = |of: &Option<[u32; 3]>| {
                SpoiltValue::Words(of.map_or_else(|| "outside of the grid".into(), cell_name))
            };
            let name = format!("next cell after {}", cell_name(cell));
            search.note(vec![pair(name, [&right, &behind], word)]);
        }
        if visit(search, grid, cell, t_out, wrong) {
            return;
        }
        match behind {
            Some(behind) => cell = behind,
            None => return,
        }
    }
}

/// Tests the objects of a cell. Does the walk end here?
fn visit(
    search: &mut Search,
    grid: &Grid,
    cell: [u32; 3],
    t_out: f64,
    wrong: Option<&Wrong>,
) -> bool {
    search.found.cells += 1;
    for &object in grid.cell_objects(cell) {
        search.test(object);
    }
    let nearest = search.nearest();
    let right = is_passed(nearest, t_out);
    let ends = match wrong {
        Some(Wrong::WalkEnds(wrong)) => wrong(nearest, t_out),
        _ => right,
    };
    if ends != right {
        let name = if right {
            "walk with a hit in the cell"
        } else {
            "walk with a hit beyond the cell"
        };
        search.note(vec![pair(name, [&right, &ends], |ends| {
            words(*ends, ["ends", "goes on"])
        })]);
    }
    ends
}

fn right_plane(cell: u32, direction: f64) -> u32 {
    if direction < 0.0 { cell } else { cell + 1 }
}

/// t of the next planes, by which plane is next along each axis.
fn next_planes(
    search: &Search,
    grid: &Grid,
    cell: [u32; 3],
    next_plane: fn(u32, f64) -> u32,
) -> [f64; 3] {
    [0, 1, 2].map(|axis| {
        let (origin, direction) = (search.ray.origin[axis], search.ray.direction[axis]);
        if direction == 0.0 {
            return f64::INFINITY;
        }
        let plane = next_plane(cell[axis], direction) as usize;
        (grid.planes(axis)[plane] - origin) / direction
    })
}

/// The cell behind these planes; `None` if the grid ends there, or none is crossed.
fn cell_behind(search: &Search, grid: &Grid, cell: [u32; 3], crossed: u8) -> Option<[u32; 3]> {
    if crossed == 0 {
        return None;
    }
    let mut behind = cell;
    for axis in (0..3).filter(|axis| 0 < crossed & 1 << axis) {
        behind[axis] = if search.ray.direction[axis] < 0.0 {
            cell[axis].checked_sub(1)?
        } else {
            let above = cell[axis] + 1;
            (above < grid.resolution()[axis]).then_some(above)?
        };
    }
    Some(behind)
}

/// 1 for x, 2 for y, 4 for z.
fn bits(is_crossed: impl Fn(usize) -> bool) -> u8 {
    let crossed = (0..3).filter(|&axis| is_crossed(axis));
    crossed.map(|axis| 1 << axis).sum()
}

fn bits_of(across: Across) -> u8 {
    let all = (0..).zip(Across::BY_BITS);
    all.filter(|(_, of)| *of == across)
        .map(|(bits, _)| bits)
        .sum()
}

/// A cell as the log names it.
fn cell_name([i, j, k]: [u32; 3]) -> String {
    format!("[{i}, {j}, {k}]")
}
