//! The stages of the argument that each point of a ray's line has its t.

use crate::explain::Part;
use crate::figure::kinds::line_of_t::stops::{Line, Place, Stop};
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::stage::StageId;

/// The stages, in their order.
pub(super) struct Argument {
    pub(super) window: StageId,
    pub(super) direction: StageId,
    pub(super) ray: StageId,
    pub(super) unit: StageId,
    pub(super) hit: StageId,
}

impl Argument {
    /// `met` is the name of what is hit.
    /// When a point is marked on the line.
    pub(super) fn of(&self, stop: &Stop) -> StageId {
        match stop.place {
            Place::Cop | Place::PixelCentre => self.window,
            Place::BehindCop => self.ray,
            Place::Hit => self.hit,
        }
    }

    pub(super) fn new(sheet: &mut Sheet, line: &Line, met: Option<&str>) -> Self {
        let delta = line.to_window.direction;
        let window_t = quantity(line.window_t());
        let window = sheet.stage(
            Part::WindowPoint,
            line.window_step,
            "A line runs from the COP through the centre of a pixel on the window.",
        );
        let direction = sheet.stage(
            Part::Direction,
            line.window_step,
            format!(
                "Δ = {} leads from the COP, where t is 0, to the pixel's centre, where t is 1.",
                coordinates(delta)
            ),
        );
        let ray = sheet.stage(
            Part::Ray,
            line.window_step,
            "By equation (i) every point of the line has its t: below 0 behind the COP, above 1 beyond the window.",
        );
        let unit = sheet.stage(
            "|Δ| = 1",
            line.unit_step,
            format!(
                "With Δ divided by its length {} t is the distance from the COP, and {window_t} on the window.",
                quantity(delta.length())
            ),
        );
        let told = match (line.end.t, met) {
            (Some(t), Some(met)) => format!(
                "The ray hits {met} at t = {}, or {} with |Δ| = 1.",
                quantity(t / line.window_t()),
                quantity(t)
            ),
            _ => "The ray misses all objects.".into(),
        };
        let hit = sheet.stage(Part::Nearest, line.end_step, told);
        Self {
            window,
            direction,
            ray,
            unit,
            hit,
        }
    }
}
