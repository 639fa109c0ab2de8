//! The point in the polygon: which coordinate is dropped, and is the point inside?

use crate::geometry::{Axis, DecidedBy, EdgeTest, Polygon, PolygonTest};
use crate::mistake::{Wrong, mistakes};
use crate::scene::{PrimitiveId, Shape};
use crate::step::question::at::{At, alike, listed, number};
use crate::step::question::choice::{Asks, Choice, Question};
use crate::trace::{Event, StrategyName};

/// The most vertices of an outline that a question shows.
const MOST_VERTICES: usize = 6;

/// The name of an axis.
fn name(axis: Axis) -> &'static str {
    match axis {
        Axis::X => "x",
        Axis::Y => "y",
        Axis::Z => "z",
    }
}

/// The polygon, unless the test has other coordinates than the scene: those in the frame of the ray.
fn polygon_of<'l>(at: &At<'_, 'l>, object: PrimitiveId) -> Option<&'l Polygon> {
    match &at.log.scene.primitive(object).shape {
        Shape::Polygon(polygon) if at.log.settings.strategy != StrategyName::ZAligned => {
            Some(polygon)
        }
        _ => None,
    }
}

/// Which coordinate is dropped.
pub(super) fn dropped_axis(at: &At, object: PrimitiveId, test: &PolygonTest) -> Option<Question> {
    let polygon = polygon_of(at, object)?;
    let normal = polygon.plane().normal;
    let axes = [Axis::X, Axis::Y, Axis::Z];
    let others = axes.iter().filter(|&&axis| axis != test.dropped);
    if others
        .clone()
        .any(|axis| alike(axis.of(normal).abs(), test.coefficient.abs()))
    {
        return None;
    }
    let size = number(test.coefficient.abs());
    let choice = |axis: Axis| {
        let own = number(axis.of(normal).abs());
        let reason = if axis == test.dropped {
            format!(
                "Its coefficient is the largest in absolute value: {size}. So the outline keeps the most of its area."
            )
        } else {
            format!(
                "Its coefficient is {own} in absolute value, and that of {} is {size}.",
                name(test.dropped)
            )
        };
        let choice = Choice::new(name(axis), reason);
        let made = mistakes().find(
            |mistake| matches!(mistake.wrong, Wrong::DroppedAxis(wrong) if wrong(normal) == axis),
        );
        match made.filter(|_| axis != test.dropped) {
            Some(mistake) => choice.by(mistake),
            None => choice,
        }
    };
    let text = format!(
        "Plane of {}: A = {}, B = {}, C = {}. Which coordinate is dropped for the point-in-polygon test?",
        at.name(object),
        number(normal.x),
        number(normal.y),
        number(normal.z)
    );
    let wrong = others.map(|&axis| choice(axis));
    Question::new(
        Asks::DroppedAxis,
        text,
        at.step(),
        choice(test.dropped),
        wrong,
    )
}

/// Is the point inside, and how many edges count?
pub(super) fn inside(at: &At, object: PrimitiveId, test: &PolygonTest) -> Option<Question> {
    let polygon = polygon_of(at, object)?;
    let vertices = polygon.outline();
    let is_shown = vertices.len() <= MOST_VERTICES && test.decided_by == DecidedBy::Point;
    if !is_shown
        || vertices
            .iter()
            .any(|vertex| alike(vertex.y, test.projected.y))
    {
        return None;
    }
    let edges = edges_before(at, object);
    if edges.len() != vertices.len() {
        return None;
    }
    let counting: Vec<String> = edges
        .iter()
        .filter(|edge| edge.counts)
        .map(|edge| edge.index.to_string())
        .collect();
    let text_of = |crossings: u32| {
        let place = if crossings % 2 == 1 {
            "inside"
        } else {
            "outside"
        };
        match crossings {
            0 => format!("{place}: no edge counts"),
            1 => format!("{place}: 1 edge counts"),
            many => format!("{place}: {many} edges count"),
        }
    };
    let count = match counting.len() {
        0 => "No edge counts".to_owned(),
        1 => format!("Edge {} alone counts", counting[0]),
        _ => format!("Edges {} count", listed(&counting)),
    };
    let odd = if test.inside { "odd" } else { "even" };
    let right = Choice::new(
        text_of(test.crossings),
        format!(
            "{count}, from the vertex of that number: {} is {odd}.",
            test.crossings
        ),
    );
    let heights = edges.iter().filter(|edge| edge.straddles).count() as u32;
    let mut wrong = Vec::new();
    if heights != test.crossings {
        wrong.push(Choice::new(
            text_of(heights),
            format!("{heights} edges pass the height of p′, on either side of it; the half-line goes to one side alone. {count}."),
        ));
    }
    let [u, v] = ["first", "second"];
    let reason = |crossings: u32| {
        format!(
            "{count}: an edge counts if its ends lie on both sides of the {v} coordinate of p′ and it passes p′ at a larger {u} coordinate. \
             That is not so for {crossings}."
        )
    };
    let others = [
        Some(test.crossings + 1),
        test.crossings.checked_sub(1),
        Some(test.crossings + 2),
    ];
    wrong.extend(
        others
            .into_iter()
            .flatten()
            .map(|crossings| Choice::new(text_of(crossings), reason(crossings))),
    );
    let vertices: Vec<String> = vertices
        .iter()
        .map(|vertex| format!("({}, {})", number(vertex.x), number(vertex.y)))
        .collect();
    let text = format!(
        "Polygon {}: {} is dropped, p′ = ({}, {}), and the vertices are {}. A half-line runs from p′ towards a larger {u} coordinate. \
         Is p′ inside, and how many edges count?",
        at.name(object),
        name(test.dropped),
        number(test.projected.x),
        number(test.projected.y),
        listed(&vertices)
    );
    Question::new(Asks::Inside, text, at.step(), right, wrong)
}

/// The edges of the polygon, which come before its test.
fn edges_before(at: &At, of: PrimitiveId) -> Vec<EdgeTest> {
    let before = at.log.records[..at.event].iter().rev();
    let mut edges: Vec<EdgeTest> = before
        .map_while(|record| match record.event {
            Event::Edge { object, edge } if object == of => Some(edge),
            _ => None,
        })
        .collect();
    edges.reverse();
    edges
}
