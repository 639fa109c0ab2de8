//! The stages of the argument that a point lies inside a polygon or not.

use crate::explain::Part;
use crate::figure::kinds::polygon::tested::{Tested, verdict};
use crate::figure::parts::axes;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::stage::StageId;
use crate::geometry::{Axis, PlaneVerdict, PolygonTest, Root};

/// The stages, in their order.
pub(super) struct Argument {
    pub(super) ray: StageId,
    pub(super) point: StageId,
    pub(super) axis: StageId,
    pub(super) projection: StageId,
    /// One for each crossing, from the nearest to p′ to the furthest; one for all of many, and for none.
    pub(super) crossings: Vec<StageId>,
    pub(super) verdict: StageId,
}

impl Argument {
    /// Up to this number of crossings each has a stage of its own: a figure has a dozen stages at most.
    const EACH: u32 = 4;

    pub(super) fn new(sheet: &mut Sheet, tested: &Tested, name: &str, along: Axis) -> Self {
        let (plane, plane_step) = tested.plane;
        let (test, last) = tested.point.unwrap_or((PolygonTest::default(), plane_step));
        let at = match plane.verdict {
            PlaneVerdict::Meets(Root { t, .. }) => format!(" at t = {}", quantity(t)),
            _ => String::new(),
        };
        let first_edge = tested.edges.first().map_or(last, |(_, step)| *step);
        let last_edge = tested.edges.last().map_or(last, |(_, step)| *step);
        let ray = sheet.stage(
            Part::Ray,
            tested.starts,
            format!("The ray R starts at the COP, above the polygon {name}."),
        );
        let point = sheet.stage(
            Part::PlanePoint,
            plane_step,
            format!("R hits the plane of the polygon in p{at}."),
        );
        let normal = plane.plane.normal.abs();
        let sizes = [Axis::X, Axis::Y, Axis::Z].map(|axis| {
            format!(
                "|{}| = {}",
                axes::coefficient(axis),
                quantity(axis.of(normal))
            )
        });
        let axis = sheet.stage(
            Part::Axis,
            plane_step,
            format!(
                "Of {} the largest is |{}|, so {} is dropped.",
                sizes.join(", "),
                axes::coefficient(test.dropped),
                axes::letter(test.dropped)
            ),
        );
        let projection = sheet.stage(
            Part::Projection,
            first_edge,
            if along == test.dropped {
                "The polygon and p are projected along that axis: p becomes p′.".into()
            } else {
                format!(
                    "Here they are projected along {} instead, where the projection is smaller.",
                    axes::letter(along)
                )
            },
        );
        // two projections beside each other have no room for the half-line
        let crossings = if along == test.dropped {
            Self::of_crossings(sheet, test.crossings, last_edge)
        } else {
            Vec::new()
        };
        let so = if test.inside { "inside" } else { "outside" };
        let verdict = sheet.stage(
            Part::InsideOut,
            last,
            format!(
                "{}: p lies {so}.",
                verdict(&test).split(':').next().unwrap_or_default()
            ),
        );
        Self {
            ray,
            point,
            axis,
            projection,
            crossings,
            verdict,
        }
    }

    fn of_crossings(sheet: &mut Sheet, count: u32, step: u32) -> Vec<StageId> {
        let half_line = "The half-line from p′";
        match count {
            0 => vec![sheet.stage(
                Part::Crossings,
                step,
                format!("{half_line} crosses no edge."),
            )],
            1..=Self::EACH => (1..=count)
                .map(|number| {
                    let of = ["first", "second", "third", "fourth"][number as usize - 1];
                    let sentence = format!("{half_line} crosses an edge for the {of} time.");
                    sheet.stage(Part::Crossings, step, sentence)
                })
                .collect(),
            _ => vec![sheet.stage(
                Part::Crossings,
                step,
                format!("{half_line} crosses {count} edges."),
            )],
        }
    }

    /// The stage of a crossing, numbered from 0.
    pub(super) fn crossing(&self, number: usize) -> StageId {
        let own = self.crossings.get(number).or(self.crossings.last());
        own.copied().unwrap_or(self.verdict)
    }
}
