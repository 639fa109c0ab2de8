//! Cells of a uniform grid: the traversal by a ray, and how the lists were filled.

use crate::explain::number::count;
use crate::explain::number::{Digits, cell_name};
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::steps::Course;
use crate::scene::PrimitiveId;
use crate::structure::{Across, AssignStep, BareGrid, Share};
use crate::trace::{CellVisit, GridEnter, GridExit, HitOutsideCell, Purpose, WalkEnd};

/// The grid, and where the ray enters it.
pub(super) fn grid_enter(context: &Context, enter: &GridEnter, course: &Course, page: &mut Pen) {
    let d = Digits::USUAL;
    let bare = bare_grid(context, enter.resolution);
    let [nx, ny, nz] = enter.resolution;
    let text = format!(
        " of {nx} × {ny} × {nz} cells from {} to {}",
        d.vector(bare.around.min),
        d.vector(bare.around.max)
    );
    page.headed(Part::Grid, text);
    let ray = course.start.map(|start| start.ray);
    let inside = ray.map_or(enter.inside, |ray| bare.inside(&ray));
    match (inside, enter.cell) {
        (None, Some(cell)) => page.plain(format!(
            "the ray misses its box, but by less than the padding: it starts in cell {}",
            cell_name(cell)
        )),
        (Some(inside), Some(cell)) => page.plain(format!(
            "the ray is in its box for t in {} and starts in cell {}",
            from_to(inside),
            cell_name(cell)
        )),
        (Some(inside), None) => page.line(
            Tone::Refused,
            format!(
                "the ray is in its box for t in {}, where no t counts",
                from_to(inside)
            ),
        ),
        (None, _) => page.line(Tone::Refused, "the ray misses its box"),
    }
}

/// Where a stretch of a ray begins and ends. A ray that starts on the box has an end at 0, and not at its rounding.
fn from_to(ends: [f64; 2]) -> String {
    /// t is good to about 10⁻¹⁵ of the larger end; a thousand times that allows for the rounding of the point.
    const ROUNDING: f64 = 1e-12;
    let d = Digits::USUAL;
    let largest = ends[0].abs().max(ends[1].abs());
    let [from, to] = ends.map(|t| {
        if t.abs() <= ROUNDING * largest {
            0.0
        } else {
            t
        }
    });
    format!("[{}, {}]", d.number(from), d.number(to))
}

/// The grid of the log, without padding.
fn bare_grid(context: &Context, resolution: [u32; 3]) -> BareGrid {
    let built = || BareGrid::around(context.scene, resolution);
    *context.again.grid.get_or_init(built)
}

/// The grid whose planes give the t of the cells in the worked text.
pub(super) fn grid_along(
    context: &Context,
    enter: &GridEnter,
    course: &Course,
) -> Option<BareGrid> {
    let bare = bare_grid(context, enter.resolution);
    bare.inside(&course.start?.ray).map(|_| bare)
}

/// A cell with its t, and the plane that comes next.
pub(super) fn cell(visit: &CellVisit, course: &Course, page: &mut Pen) {
    let d = Digits::USUAL;
    let step = match (&course.grid, course.start) {
        (Some(grid), Some(start)) => grid.step(&start.ray, start.range.min, &visit.step),
        _ => visit.step,
    };
    let next: Vec<String> = ["x", "y", "z"]
        .into_iter()
        .zip(step.next)
        .filter(|(_, t)| t.is_finite())
        .map(|(axis, t)| format!("{axis} at t = {}", d.number(t)))
        .collect();
    let across = match step.across {
        Across::None => "",
        Across::X => "x",
        Across::Y => "y",
        Across::Z => "z",
        Across::XY => "x and y at the same t, through an edge",
        Across::XZ => "x and z at the same t, through an edge",
        Across::YZ => "y and z at the same t, through an edge",
        Across::XYZ => "x, y and z at the same t, through a corner",
    };
    let listed = match visit.listed {
        0 => "no object listed".into(),
        listed => format!("{} listed", count(listed as usize, "object")),
    };
    let text = format!(
        " {}: t in [{}, {}], {listed}",
        cell_name(step.cell),
        d.number(step.t_in),
        d.number(step.t_out)
    );
    page.headed(Part::Cell, text);
    if !next.is_empty() {
        let text = format!(
            ": {}; the ray leaves the cell across {across}",
            next.join(", ")
        );
        page.indented(|page| page.headed(Part::NextPlanes, text));
    }
}

/// An object that was tested in an earlier cell.
pub(super) fn mailbox(context: &Context, object: PrimitiveId, page: &mut Pen) {
    let name = context.name(object);
    let text = format!(" of {name}: tested with this ray in an earlier cell, so not again");
    page.headed_line(Tone::Aside, Part::Mailbox, text);
}

/// A hit beyond the cell.
pub(super) fn hit_outside_cell(hit: &HitOutsideCell, page: &mut Pen) {
    let d = Digits::for_difference(hit.t, hit.t - hit.t_out);
    let text = format!(
        ": t = {} is beyond the end of the cell at {}, so the hit is kept and the traversal continues",
        d.number(hit.t),
        d.number(hit.t_out)
    );
    page.indented(|page| page.result(Tone::Refused, Part::HitOutside, text));
}

/// Why the traversal ended.
pub(super) fn grid_exit(exit: GridExit, course: &Course, page: &mut Pen) {
    let shadow = course
        .start
        .is_some_and(|start| start.purpose == Purpose::Shadow);
    let cells = count(exit.cells as usize, "cell");
    let (tone, text) = match exit.end {
        WalkEnd::HitInCell if shadow => (
            Tone::Found,
            format!(": one hit is enough for a shadow ray; {cells} visited"),
        ),
        WalkEnd::HitInCell => (
            Tone::Found,
            format!(
                ": the nearest hit is in this cell, so no later cell has a nearer one; {cells} visited"
            ),
        ),
        WalkEnd::Left => (
            Tone::Refused,
            format!(": the ray leaves the grid or ends here; {cells} visited"),
        ),
        WalkEnd::Outside => (Tone::Refused, ": the ray visits no cell".into()),
    };
    page.headed_line(tone, Part::WalkEnd, text);
}

/// An object put into a cell's list.
pub(super) fn assign(context: &Context, step: &AssignStep, page: &mut Pen) {
    let name = context.name(step.object);
    let share = match step.share {
        Share::Whole => "all of which is in it",
        Share::Part => "a part of which is in it",
    };
    page.plain(format!(
        "cell {} lists {name}, {share}",
        cell_name(step.cell)
    ));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ray_that_starts_on_the_box_is_in_it_from_0() {
        assert_eq!(from_to([-2.032_96e-16, 3.662_25]), "[0, 3.66225]");
        assert_eq!(from_to([-3.5, 1e-16]), "[−3.5, 0]");
        assert_eq!(from_to([1e-3, 2.0]), "[0.001, 2]");
    }
}
