//! The tests of a polygon that its figure draws.

use glam::{DVec2, DVec3};

use crate::figure::error::FigureError;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::look::Look;
use crate::figure::subject::{DrawnRay, Figure};
use crate::geometry::{EdgeTest, PlaneTest, PlaneVerdict, Polygon, PolygonTest, Ray};
use crate::scene::{PrimitiveId, Shape};
use crate::trace::{Event, Record, StrategyName};

/// The tests that are drawn, each with its step.
pub(super) struct Tested<'a> {
    pub(super) id: PrimitiveId,
    pub(super) polygon: &'a Polygon,
    pub(super) ray: Ray,
    pub(super) starts: Option<u32>,
    pub(super) plane: (PlaneTest, u32),
    pub(super) edges: Vec<(EdgeTest, u32)>,
    pub(super) point: Option<(PolygonTest, u32)>,
}

/// How many edges count, and what follows.
pub(super) fn verdict(test: &PolygonTest) -> String {
    let edges = match test.crossings {
        1 => "1 crossing".into(),
        count => format!("{count} crossings"),
    };
    let so = if test.inside {
        "odd: inside"
    } else {
        "even: outside"
    };
    format!("{edges}, {so}")
}

impl<'a> Tested<'a> {
    pub(super) fn find(figure: &Figure<'a>) -> Result<Self, FigureError> {
        if figure.first.settings.strategy == StrategyName::ZAligned {
            return Err(FigureError::new(
                "strategy",
                "with z-aligned rays the polygon is tested in the frame of the ray, which Fig. 15.57 does not show",
                "choose another \"strategy\", or the kind alignment",
            ));
        }
        let DrawnRay { node, events } = figure.ray()?;
        let asked = figure.object()?;
        let none = || {
            FigureError::new(
                "object",
                "this ray is not tested against such a polygon",
                "name a polygon that the ray is tested against, or omit \"object\" for the first one",
            )
        };
        let found = events.iter().find_map(|record| match record.event {
            Event::PlaneTest { object, test } if asked.is_none_or(|of| of == object) => {
                Some((object, test, record.step))
            }
            _ => None,
        });
        let (id, plane, step) = found.ok_or_else(none)?;
        let (Some(start), Shape::Polygon(polygon)) =
            (node.start, &figure.scene.primitive(id).shape)
        else {
            return Err(none());
        };
        let records = figure.records()?;
        let starts = node.ends_at[0].map(|at| records[at].step);
        let edge = |record: &&Record| match record.event {
            Event::Edge { object, edge } if object == id => Some((edge, record.step)),
            _ => None,
        };
        let point = |record: &&Record| match record.event {
            Event::PolygonTest { object, test } if object == id => Some((test, record.step)),
            _ => None,
        };
        let tested = Self {
            id,
            polygon,
            ray: start.ray,
            starts,
            plane: (plane, step),
            edges: events.iter().filter_map(edge).collect(),
            point: events.iter().find_map(point),
        };
        if tested.point.is_none() && matches!(plane.verdict, PlaneVerdict::Meets(_)) {
            return Err(FigureError::new(
                "pixel",
                "the ray hits the polygon's plane at no t that counts, so no point is projected",
                "name a pixel whose ray hits the plane before the nearest hit",
            ));
        }
        Ok(tested)
    }

    /// The largest coordinates of the polygon, with some room beyond: so far the axes are drawn.
    pub(super) fn reach(&self) -> DVec3 {
        const ROOM: f64 = 1.2;
        let largest = self.polygon.vertices().fold(DVec3::ZERO, DVec3::max);
        ROOM * largest.max(DVec3::splat(0.5 * largest.max_element()))
    }
}

/// p or p′: a point if it is inside, else a cross.
pub(super) fn mark(sheet: &mut Sheet, inside: bool, at: DVec2) {
    if inside {
        sheet.dot(Look::ANSWER, at);
    } else {
        sheet.cross(Look::REJECTED, at);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_odd_count_is_inside() {
        let test = |crossings, inside| PolygonTest {
            crossings,
            inside,
            ..PolygonTest::default()
        };
        assert_eq!(verdict(&test(1, true)), "1 crossing, odd: inside");
        assert_eq!(verdict(&test(2, false)), "2 crossings, even: outside");
    }
}
