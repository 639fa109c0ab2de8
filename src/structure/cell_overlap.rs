//! Which cells does an object reach into?
//!
//! "Solid" is meant: a cell in the middle of a sphere lists it. Every test is on the safe side: it may keep a
//! cell that the object passes by within the room for rounding, and never leaves out one that the object,
//! widened by that room, touches.

use glam::DVec3;

use crate::geometry::{Polygon, Sphere};
use crate::scene::Shape;
use crate::structure::Lists;
use crate::structure::cell_planes::CellPlanes;
use crate::structure::cone_overlap::cone_touches;
use crate::structure::extent::ROUNDING;
use crate::structure::grid::Bounds;

/// Finds the cells of one object after the other.
#[derive(Debug)]
pub(super) struct CellOverlap<'c> {
    cells: &'c CellPlanes,
    lists: Lists,
    /// What objects are widened by, besides a share of their own size.
    room: f64,
    /// The polygon whose cells are looked for.
    outline: Vec<DVec3>,
    /// What is left of it between two planes across x, and between two more across y.
    slab: Vec<DVec3>,
    column: Vec<DVec3>,
    /// What is left of it on one side of a plane.
    half: Vec<DVec3>,
}

/// The cells that a widened object's box touches: the first and the last along each axis.
type Touched = [[u32; 2]; 3];

impl<'c> CellOverlap<'c> {
    pub(super) fn new(cells: &'c CellPlanes, lists: Lists, room: f64) -> Self {
        Self {
            cells,
            lists,
            room,
            outline: Vec::new(),
            slab: Vec::new(),
            column: Vec::new(),
            half: Vec::new(),
        }
    }

    /// Gives `put` the number of each cell that lists the shape, which has these bounds.
    pub(super) fn cells_of(&mut self, shape: &Shape, bounds: Bounds, put: &mut dyn FnMut(usize)) {
        let touched = self.touched(bounds);
        if self.lists == Lists::Boxes || is_one(touched) {
            return self.each(touched, |_| true, put);
        }
        let pad = self.room + ROUNDING * shape.reach();
        match shape {
            Shape::Box(_) => self.each(touched, |_| true, put),
            Shape::Sphere(Sphere { center, radius }) => {
                self.ellipsoid(*center, DVec3::splat(*radius), pad, touched, put);
            }
            Shape::Ellipsoid(of) => self.ellipsoid(of.center, of.radii, pad, touched, put),
            Shape::Cone(cone) => {
                let meets = |[min, max]: [DVec3; 2]| cone_touches(cone, min - pad, max + pad);
                self.each(touched, |cell| meets(self.corners(cell)), put);
            }
            Shape::Polygon(polygon) => self.polygon(polygon, pad + polygon.play(), touched, put),
        }
    }

    /// Does the whole of an object with these bounds lie in one cell?
    pub(super) fn is_in_one_cell(&self, bounds: Bounds) -> bool {
        is_one(self.touched(bounds))
    }

    fn touched(&self, bounds: Bounds) -> Touched {
        [0, 1, 2].map(|axis| self.cells.touched(axis, bounds[axis]))
    }

    fn each(&self, touched: Touched, meets: impl Fn([u32; 3]) -> bool, put: &mut dyn FnMut(usize)) {
        let [i, j, k] = touched.map(|[first, last]| first..=last);
        for k in k {
            for j in j.clone() {
                for i in i.clone() {
                    if meets([i, j, k]) {
                        put(self.cells.number([i, j, k]));
                    }
                }
            }
        }
    }

    /// The smallest and the largest corner of a cell.
    fn corners(&self, cell: [u32; 3]) -> [DVec3; 2] {
        let plane = |axis: usize, by: u32| self.cells.axis(axis)[(cell[axis] + by) as usize];
        [0, 1].map(|by| DVec3::new(plane(0, by), plane(1, by), plane(2, by)))
    }

    /// In the space where the ellipsoid is a sphere of radius 1, how far is the cell's closest point?
    ///
    /// A widening by `pad` in the world is one by `pad`/r at most in that space, with the smallest r.
    fn ellipsoid(
        &self,
        center: DVec3,
        radii: DVec3,
        pad: f64,
        touched: Touched,
        put: &mut dyn FnMut(usize),
    ) {
        let radius = 1.0 + pad / radii.min_element();
        let distance2 = |axis: usize, at: u32| {
            let planes = self.cells.axis(axis);
            let (low, high) = (planes[at as usize], planes[at as usize + 1]);
            let beside = (low - center[axis]).max(center[axis] - high).max(0.0);
            let scaled = beside / radii[axis];
            scaled * scaled
        };
        let radius2 = radius * radius;
        let [[i, i_last], [j, j_last], [k, k_last]] = touched;
        for k in k..=k_last {
            let in_z = distance2(2, k);
            for j in j..=j_last {
                let in_yz = distance2(1, j) + in_z;
                if radius2 < in_yz {
                    continue;
                }
                for i in i..=i_last {
                    if distance2(0, i) + in_yz <= radius2 {
                        put(self.cells.number([i, j, k]));
                    }
                }
            }
        }
    }

    /// What a column of cells along z cuts out of the polygon reaches from some cell of it to another.
    fn polygon(
        &mut self,
        polygon: &Polygon,
        pad: f64,
        [[i, i_last], [j, j_last], _]: Touched,
        put: &mut dyn FnMut(usize),
    ) {
        let widened = |axis: usize, at: u32| {
            let planes = self.cells.axis(axis);
            [planes[at as usize] - pad, planes[at as usize + 1] + pad]
        };
        self.outline.clear();
        self.outline.extend(polygon.vertices());
        for i in i..=i_last {
            let Self {
                outline,
                slab,
                half,
                ..
            } = self;
            clip(outline, 0, widened(0, i), half, slab);
            let Some(in_y) = range(&self.slab, 1, pad) else {
                continue;
            };
            let [j_first, j_end] = self.cells.touched(1, in_y);
            for j in j_first.max(j)..=j_end.min(j_last) {
                clip(
                    &self.slab,
                    1,
                    widened(1, j),
                    &mut self.half,
                    &mut self.column,
                );
                let Some(in_z) = range(&self.column, 2, pad) else {
                    continue;
                };
                let [k, k_last] = self.cells.touched(2, in_z);
                for k in k..=k_last {
                    put(self.cells.number([i, j, k]));
                }
            }
        }
    }
}

fn is_one(touched: Touched) -> bool {
    touched.iter().all(|[first, last]| first == last)
}

/// From the smallest to the largest coordinate of some points, widened; `None` without points.
fn range(points: &[DVec3], axis: usize, pad: f64) -> Option<[f64; 2]> {
    let first = points.first()?[axis];
    let (low, high) = points.iter().fold((first, first), |(low, high), point| {
        (low.min(point[axis]), high.max(point[axis]))
    });
    Some([low - pad, high + pad])
}

/// What is left of an outline between two planes across an axis (I. Sutherland and G. Hodgman 1974).
///
/// Parts of a concave outline stay connected by edges in the planes, which adds no more than what lies between
/// them.
fn clip(
    outline: &[DVec3],
    axis: usize,
    [low, high]: [f64; 2],
    half: &mut Vec<DVec3>,
    clipped: &mut Vec<DVec3>,
) {
    cut(outline, axis, low, |x| low <= x, half);
    cut(half, axis, high, |x| x <= high, clipped);
}

/// What is left of an outline on one side of a plane.
fn cut(
    outline: &[DVec3],
    axis: usize,
    plane: f64,
    keeps: impl Fn(f64) -> bool,
    left: &mut Vec<DVec3>,
) {
    left.clear();
    let Some(&last) = outline.last() else {
        return;
    };
    let mut from = last;
    for &to in outline {
        let (kept_from, kept_to) = (keeps(from[axis]), keeps(to[axis]));
        if kept_from != kept_to {
            let share = (plane - from[axis]) / (to[axis] - from[axis]);
            let mut crossing = from + share * (to - from);
            crossing[axis] = plane;
            left.push(crossing);
        }
        if kept_to {
            left.push(to);
        }
        from = to;
    }
}
