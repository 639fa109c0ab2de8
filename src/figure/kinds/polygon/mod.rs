//! A ray and a polygon, projected along an axis (Fig. 15.57): in space, and in true shape with the half-line from p′
//! and the edges that it crosses.
//!
//! With `drop` the projection is along another axis than the test's, which makes it smaller: its area is that of the
//! polygon times |A|, |B| or |C|. A ray parallel to the plane is drawn with the distance that it keeps.

mod beside_plane;
mod in_space;
mod true_shape;

use glam::{DVec2, DVec3};

use crate::figure::axes;
use crate::figure::canvas::quantity;
use crate::figure::drawing::{DrawnRay, Figure};
use crate::figure::error::FigureError;
use crate::figure::frame::Frame;
use crate::figure::kinds::Kind;
use crate::figure::look::Look;
use crate::figure::scenery;
use crate::figure::sheet::Sheet;
use crate::figure::spec::{DroppedAxis, Layer};
use crate::geometry::{Axis, EdgeTest, PlaneTest, PlaneVerdict, Polygon, PolygonTest, Ray};
use crate::scene::{PrimitiveId, Shape};
use crate::trace::{Event, Record, StrategyName};

pub(super) const KIND: Kind = Kind {
    draw,
    height: 350.0,
    usual: &[Layer::Projection],
    more: &[],
};

/// The tests that are drawn, each with its step.
struct Tested<'a> {
    id: PrimitiveId,
    polygon: &'a Polygon,
    ray: Ray,
    starts: Option<u32>,
    plane: (PlaneTest, u32),
    edges: Vec<(EdgeTest, u32)>,
    point: Option<(PolygonTest, u32)>,
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let tested = Tested::find(figure)?;
    let name = scenery::name_of(figure.scene, tested.id);
    let Some((test, _)) = tested.point else {
        return Ok(beside_plane::draw(figure, sheet, body, &tested, &name));
    };
    let chosen = test.dropped;
    let along = figure.spec.drop.map_or(chosen, axis_of);
    let mut left = body;
    if figure.shows(Layer::Projection) {
        /// Of the width: the drawing in space comes first.
        const SHARE: f64 = 0.6;
        let [space, flat] = body.split(SHARE, 2.0 * sheet.letters);
        if along == chosen {
            true_shape::draw(sheet, flat, &tested);
        } else {
            true_shape::draw_two(sheet, flat, &tested, along);
        }
        left = space;
    }
    in_space::draw(figure, sheet, left, &tested, along);

    let compared = if along == chosen {
        String::new()
    } else {
        let normal = tested.plane.0.plane.normal;
        let [other, own] = [along, chosen].map(|axis| quantity(axis.of(normal).abs()));
        format!(
            " With {} dropped in its place, the projection has {other} of the polygon's area, not {own}.",
            axes::letter(along)
        )
    };
    Ok(format!(
        "The ray meets the plane of {name} in p. Of A, B and C, {} has the largest absolute value, {}, so the test \
         drops {}. {}.{compared}",
        axes::coefficient(chosen),
        quantity(test.coefficient.abs()),
        axes::letter(chosen),
        verdict(&test)
    ))
}

/// How many edges count, and what follows.
fn verdict(test: &PolygonTest) -> String {
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
    fn find(figure: &Figure<'a>) -> Result<Self, FigureError> {
        if figure.first.settings.strategy == StrategyName::ZAligned {
            return Err(FigureError::new(
                "strategy",
                "with z-aligned rays the polygon is tested in the frame of the ray, where Fig. 15.57 does not take place",
                "take another strategy, or draw the kind alignment",
            ));
        }
        let DrawnRay { node, events } = figure.ray()?;
        let asked = figure.object()?;
        let none = || {
            FigureError::new(
                "object",
                "the trace of this ray has no such test of a polygon",
                "name a polygon that the ray is tested against, or leave it out for the first one",
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
                "the ray does not meet the polygon's plane where it counts, so nothing is projected",
                "name a pixel whose ray meets the plane in front of it and before the nearest hit",
            ));
        }
        Ok(tested)
    }

    /// The largest coordinates of the polygon, with some room beyond: so far the axes are drawn.
    fn reach(&self) -> DVec3 {
        const ROOM: f64 = 1.12;
        let largest = self.polygon.vertices().fold(DVec3::ZERO, DVec3::max);
        ROOM * largest.max(DVec3::splat(0.5 * largest.max_element()))
    }
}

fn axis_of(dropped: DroppedAxis) -> Axis {
    match dropped {
        DroppedAxis::X => Axis::X,
        DroppedAxis::Y => Axis::Y,
        DroppedAxis::Z => Axis::Z,
    }
}

/// p or p′: a point if it is inside, else a cross.
fn mark(sheet: &mut Sheet, inside: bool, at: DVec2) {
    if inside {
        sheet.dot(Look::HIT, at);
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
