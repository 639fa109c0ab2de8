//! A grid in 2D, as it is seen along one of its axes, with the cells that a ray visits and the ray from cell to cell.

use glam::{DVec2, DVec3};

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::parts::outline::{self, Outline};
use crate::figure::parts::walk::{Visit, Walk};
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::brief;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::{Colour, Look};
use crate::figure::sheet::stage::{StageId, parts};
use crate::figure::sheet::text::{Text, formula};
use crate::figure::spec::Layer;
use crate::figure::subject::{DrawnRay, Figure};
use crate::figure::view::{Projection, Space};
use crate::geometry::{AxisBox, Ray};
use crate::trace::GridEnter;

/// A walk in a space.
pub(in crate::figure) struct Plan {
    pub(in crate::figure) space: Space,
    lattice: Lattice,
    /// The axis along which it is seen.
    depth: usize,
    part: Option<Shown>,
    /// The step at which the ray ends.
    last_step: u32,
}

/// What is to be seen of a ray.
#[derive(Clone, Copy)]
struct Shown {
    ray: Ray,
    /// Where it begins to be seen.
    from: f64,
    /// Where it enters the grid's box, and where it leaves it.
    inside: [f64; 2],
    /// Where it ends: at what it hits, or a little beyond the box.
    ends: f64,
}

impl Plan {
    /// The grid in a frame, with some of the ray before it.
    ///
    /// # Errors
    /// The figure does not look along an axis.
    pub(in crate::figure) fn new(
        figure: &Figure,
        (ray, walk): (&DrawnRay, &Walk),
        frame: Frame,
    ) -> Result<Self, FigureError> {
        let depth = depth_axis(figure)?;
        let lattice = Lattice::of(&walk.grid);
        let part = shown_part(figure, ray, walk, &lattice);
        let mut points = Vec::from(lattice.box_corners());
        if figure.shows(Layer::Ray) {
            points.extend(part.map(|part| part.ray.at(part.from)));
        }
        let last = ray.events.last().map(|record| record.step);
        Ok(Self {
            space: figure.space(frame, points),
            lattice,
            depth,
            part,
            last_step: last.unwrap_or(walk.step),
        })
    }

    /// The planes that are seen from their edge, those around all cells a little stronger.
    pub(in crate::figure) fn planes(&self, sheet: &mut Sheet) {
        let [a, b] = [(self.depth + 1) % 3, (self.depth + 2) % 3];
        for (across, along) in [(a, b), (b, a)] {
            let last = self.lattice.resolution[across];
            for place in 0..=last {
                let end = |to: u32| {
                    let mut at = [0; 3];
                    (at[across], at[along]) = (place, to);
                    self.space.projection.of(self.lattice.corner(at))
                };
                let line = [end(0), end(self.lattice.resolution[along])];
                let is_outer = place == 0 || place == last;
                // more planes would hide what lies between them
                let inner = if MANY <= last {
                    Look {
                        colour: Colour::Culled,
                        ..Look::THIN.wide(0.35)
                    }
                } else {
                    Look::THIN.wide(0.75)
                };
                let look = if is_outer {
                    Look::THIN.wide(1.5)
                } else {
                    inner
                };
                outline::line_on(sheet, &self.space, look, &line);
            }
        }
    }

    /// The indices of the cells below and at the left of the grid.
    pub(in crate::figure) fn indices(&self, sheet: &mut Sheet, within: Frame) {
        for axis in (0..3).filter(|&axis| axis != self.depth) {
            let other = 3 - axis - self.depth;
            let n = self.lattice.resolution;
            let middle = |index: u32, side: u32| {
                let end = |index: u32| {
                    let mut at = [0; 3];
                    (at[axis], at[other]) = (index, side);
                    self.space.place(self.lattice.corner(at))
                };
                end(index).midpoint(end(index + 1))
            };
            let sides = [0, n[other]].map(|side| middle(0, side));
            let is_level = sides[0].x == sides[1].x;
            let is_first = if is_level {
                sides[1].y < sides[0].y
            } else {
                sides[0].x < sides[1].x
            };
            let side = if is_first { 0 } else { n[other] };
            let outwards = if is_level { DVec2::Y } else { DVec2::NEG_X };
            for index in 0..n[axis] {
                let name = formula(["i = ", "j = ", "k = "][axis]);
                let text = if index == 0 {
                    name + index.to_string()
                } else {
                    Text::from(index.to_string())
                };
                sheet.label(within, middle(index, side), outwards, text);
            }
        }
    }

    /// A cell that was visited: its area with a label, and a frame around it if something is on its list.
    pub(in crate::figure) fn cell(&self, sheet: &mut Sheet, visit: &Visit, label: String) {
        let outline = self.lattice.cell(visit.cell.cell, &self.space.projection);
        let look = if visit.length == 0 { EMPTY } else { LISTED };
        sheet.event(visit.step, |sheet| {
            outline::rim(sheet, &self.space, &outline.rim, look);
            if let Some(area) = self.lattice.area(visit.cell.cell, &self.space) {
                sheet.label_in(area, label);
            }
        });
    }

    /// The line of the ray through the grid, and the ray from cell to cell.
    pub(in crate::figure) fn ray(&self, sheet: &mut Sheet, walk: &Walk) {
        let Some(part) = self.part else { return };
        let line = |sheet: &mut Sheet, look: Look, ends: [f64; 2]| {
            let ends = ends.map(|t| self.space.projection.of(part.ray.at(t)));
            outline::line_on(sheet, &self.space, look, &ends);
        };
        let [enters, leaves] = part.inside;
        let start = self.place(part.from);
        sheet.event(walk.step, |sheet| {
            line(sheet, Look::LINE_OF_RAY, [enters, leaves]);
            line(sheet, Look::RAY, [part.from, enters]);
            let middle = start.lerp(self.place(enters), 0.5);
            if self.space.frame.contains(middle) {
                sheet.label(self.space.frame, middle, self.above(), formula("R"));
            }
            for visit in &walk.visits {
                sheet.event(visit.step, |sheet| {
                    let to = visit.cell.t_out.min(part.ends);
                    line(sheet, Look::RAY, [visit.cell.t_in.min(to), to]);
                });
            }
        });
        sheet.event(self.last_step, |sheet| {
            let ends = [start, self.place(part.ends)];
            if let Some([from, to]) = self.space.frame.cut_line(ends) {
                sheet.arrow(Look::RAY, from, to);
            }
        });
    }

    /// The whole ray at once: up to its hit with its line behind it, or through the whole grid.
    pub(in crate::figure) fn whole_ray(&self, sheet: &mut Sheet, is_up_to_hit: bool) {
        let Some(part) = self.part else { return };
        let [_, leaves] = part.inside;
        let beyond = leaves + BEYOND * self.lattice.diagonal();
        let end = if is_up_to_hit { part.ends } else { beyond };
        if end < leaves {
            let line = [end, beyond].map(|t| self.space.projection.of(part.ray.at(t)));
            outline::line_on(sheet, &self.space, Look::LINE_OF_RAY, &line);
        }
        let ends = [part.from, end].map(|t| self.place(t));
        if let Some([from, to]) = self.space.frame.cut_line(ends) {
            sheet.arrow(Look::RAY, from, to);
        }
    }

    /// The axis of the plane of the box on which the ray is at a t; `None` if it is inside the box.
    pub(in crate::figure) fn entered_across(&self, t: f64) -> Option<usize> {
        /// Of the box, for the rounding of a point on its plane.
        const ON_PLANE: f64 = 1e-6;
        let point = self.part?.ray.at(t);
        let around = &self.lattice.around;
        (0..3).find(|&axis| {
            let near = ON_PLANE * around.size()[axis];
            let ends = [around.min, around.max];
            ends.iter()
                .any(|end| (end[axis] - point[axis]).abs() <= near)
        })
    }

    /// Where a point of the ray is on the sheet.
    pub(in crate::figure) fn place(&self, t: f64) -> DVec2 {
        let point = self.part.map_or(DVec3::ZERO, |part| part.ray.at(t));
        self.space.place(point)
    }

    /// The direction across the ray that goes up.
    pub(in crate::figure) fn above(&self) -> DVec2 {
        let along = self.part.map_or(DVec3::X, |part| part.ray.direction);
        let across = self.space.direction(along).perp();
        if 0.0 < across.y { -across } else { across }
    }
}

/// The stages of a walk: the ray that comes to the grid, its cells, and what it hits in the end.
pub(in crate::figure) fn stages(
    sheet: &mut Sheet,
    ray: &DrawnRay,
    walk: &Walk,
    cells: &[String],
    end: String,
) -> StageId {
    /// With the first one and the last one a dozen.
    const MOST: usize = 10;
    let [nx, ny, nz] = walk.grid.resolution;
    let enters = match walk.grid.inside {
        Some([enters, _]) if 0.0 < enters => {
            format!(
                "The ray R enters a grid of {nx} × {ny} × {nz} cells at t = {}.",
                brief(enters)
            )
        }
        Some(_) => format!("The ray R starts in a grid of {nx} × {ny} × {nz} cells."),
        None => format!("The ray R misses a grid of {nx} × {ny} × {nz} cells."),
    };
    sheet.stage(Part::Grid, walk.step, enters);
    let last = ray.events.last().map_or(walk.step, |record| record.step);
    for part in parts(walk.visits.len(), MOST) {
        let next = walk.visits.get(part.end).map(|next| next.step);
        let step = next.map_or(last, |next| next.saturating_sub(1));
        sheet.stage(Part::Cell, step, cells[part].join(" "));
    }
    sheet.stage(Part::WalkEnd, last, end)
}

/// A cell that was visited without an object on its list, and with one.
pub(in crate::figure) const EMPTY: Look = Look::VISITED.inside();
pub(in crate::figure) const LISTED: Look = Look::VISITED.wide(2.5);

/// Cells along an axis from which on planes are drawn fine.
const MANY: u32 = 24;

/// So far beyond the grid a ray is seen, of the box's diagonal.
const BEYOND: f64 = 0.06;

/// A ray that comes from far off is seen from a little before the grid. `None` if it passes by.
fn shown_part(figure: &Figure, ray: &DrawnRay, walk: &Walk, lattice: &Lattice) -> Option<Shown> {
    /// Of the box's diagonal, before it.
    const BEFORE: f64 = 0.12;
    let start = ray.node.start?;
    let [enters, leaves] = walk.grid.inside?;
    let inside = [enters.max(0.0), leaves.max(0.0)];
    let from = if figure.shows(Layer::Eye) {
        0.0
    } else {
        inside[0] - BEFORE * lattice.diagonal()
    };
    let met = ray.node.end.and_then(|end| end.t);
    let beyond = inside[1] + BEYOND * lattice.diagonal();
    Some(Shown {
        ray: start.ray,
        from: from.max(0.0),
        inside,
        ends: met.unwrap_or(start.range.max).min(beyond),
    })
}

/// Where the planes of a grid lie: the corners of its cells.
pub(in crate::figure) struct Lattice {
    around: AxisBox,
    pub(in crate::figure) resolution: [u32; 3],
}

impl Lattice {
    pub(in crate::figure) fn of(grid: &GridEnter) -> Self {
        Self {
            around: grid.around,
            resolution: grid.resolution,
        }
    }

    /// The corner between cells: min + (max − min)·at/n.
    pub(in crate::figure) fn corner(&self, at: [u32; 3]) -> DVec3 {
        let share = [0, 1, 2].map(|axis| f64::from(at[axis]) / f64::from(self.resolution[axis]));
        self.around.min + self.around.size() * DVec3::from(share)
    }

    /// All corners of the box.
    pub(in crate::figure) fn box_corners(&self) -> [DVec3; 8] {
        std::array::from_fn(|bits| {
            let end = |axis: usize| self.resolution[axis] * (bits as u32 >> axis & 1);
            self.corner([0, 1, 2].map(end))
        })
    }

    /// The whole box in a projection.
    pub(in crate::figure) fn whole(&self, projection: &Projection) -> Outline {
        Outline::of_box(&self.around, projection)
    }

    /// A cell in a projection.
    pub(in crate::figure) fn cell(&self, cell: [u32; 3], projection: &Projection) -> Outline {
        let next = cell.map(|at| at + 1);
        let [min, max] = [cell, next].map(|at| self.corner(at));
        Outline::of_box(&AxisBox { min, max }, projection)
    }

    /// What is seen of a cell in a space; `None` if it lies outside the frame.
    pub(in crate::figure) fn area(&self, cell: [u32; 3], space: &Space) -> Option<Frame> {
        let corners = self.cell(cell, &space.projection).rim.points();
        let corners = corners.iter().map(|point| space.place_flat(*point));
        let area = Frame::around(corners)?;
        let seen = Frame {
            min: area.min.max(space.frame.min),
            max: area.max.min(space.frame.max),
        };
        seen.min.cmplt(seen.max).all().then_some(seen)
    }

    /// The length of the box's diagonal.
    pub(in crate::figure) fn diagonal(&self) -> f64 {
        self.around.size().length()
    }
}

/// The axis along which a figure looks: 0, 1 or 2.
///
/// # Errors
/// It looks along none.
pub(in crate::figure) fn depth_axis(figure: &Figure) -> Result<usize, FigureError> {
    /// Of a unit vector; rounding leaves less.
    const ALMOST_1: f64 = 1.0 - 1e-9;
    let towards = figure.projection().towards();
    let axis = (0..3).find(|&axis| ALMOST_1 <= towards[axis].abs());
    axis.ok_or_else(|| {
        FigureError::new(
            "view",
            "a figure of a grid in 2D needs a view along one of its axes",
            "choose the \"view\" top, front or side",
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_corners_of_the_cells_cut_the_box_into_equal_parts() {
        let lattice = Lattice::of(&GridEnter {
            around: AxisBox {
                min: DVec3::new(-1.0, 0.0, 2.0),
                max: DVec3::new(3.0, 1.0, 8.0),
            },
            resolution: [4, 1, 3],
            ..GridEnter::default()
        });
        assert_eq!(lattice.corner([0, 0, 0]), DVec3::new(-1.0, 0.0, 2.0));
        assert_eq!(lattice.corner([1, 0, 2]), DVec3::new(0.0, 0.0, 6.0));
        assert_eq!(lattice.corner([4, 1, 3]), DVec3::new(3.0, 1.0, 8.0));
        let corners = lattice.box_corners();
        assert_eq!(corners[0b101], DVec3::new(3.0, 0.0, 8.0));
    }
}
