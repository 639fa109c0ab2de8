//! Near and far along a ray, slab by slab (slides, "Optimizing Intersection Calculations").
//!
//! Above, the bound with its slabs, turned so that the ray lies level; below, on the axis of t beneath the ray, the
//! interval of each slab and what all slabs so far have in common. Where nothing is left the processing stops, and
//! the slabs behind are not looked at.

use glam::DVec2;

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::kinds::slabs::{SlabTests, bounded};
use crate::figure::parts::bound::{self, Slab};
use crate::figure::parts::outline;
use crate::figure::parts::scenery;
use crate::figure::parts::slab_rows::{Axis, COMMON, OF_SLAB};
use crate::figure::sheet::Sheet;
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::{Projection, Space};
use crate::geometry::{Ray, SlabInterval};
use crate::structure::SlabVerdict;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 420.0,
    usual: &[Layer::Objects, Layer::Slabs, Layer::Volumes, Layer::Legend],
    more: &[],
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let drawn = figure.ray()?;
    let found = SlabTests::find(figure, &drawn.events)?;
    let ray = drawn.node.start.map(|start| start.ray).unwrap_or_default();
    let all = bound::bound_of(figure.first, found.of)?;
    let projection = along_the_ray(figure, &ray)?;

    let body = if figure.shows(Layer::Legend) {
        let mut entries = vec![
            (OF_SLAB, "near to far of one slab"),
            (COMMON, "max near to min far so far"),
        ];
        if found.tests.len() < all.len() {
            entries.push((Look::CULLED, "not tested"));
        }
        sheet.legend(body, &entries)
    } else {
        body
    };
    let row = 1.35 * sheet.line_height();
    // one for each slab, one for what they have in common, the axis
    let below = (all.len() as f64 + 2.0) * row;
    let [drawing, rows] = body.split_top(body.size().y - below);
    let margin = DVec2::new(2.5 * sheet.letters, 0.0);
    let inner = Frame {
        min: drawing.min + margin,
        max: drawing.max,
    };
    let space = space(&all, &ray, &found, projection, inner);
    geometry(figure, sheet, &space, &ray, &all, &found);

    let axis = Axis {
        space: &space,
        ray: &ray,
        frame: rows,
        row,
    };
    for (place, slab) in all.iter().enumerate() {
        let test = found
            .tests
            .iter()
            .find(|(_, test)| test.step.slab == slab.number);
        axis.name(sheet, place, slab);
        if let Some((step, test)) = test {
            sheet.step(*step, |sheet| {
                axis.slab(sheet, place, &test.step);
            });
        } else {
            axis.untouched(sheet, place);
        }
    }
    if let Some((step, last)) = found.tests.last() {
        sheet.step(*step, |sheet| {
            axis.result(sheet, all.len(), &last.step);
        });
    }
    axis.draw(sheet, all.len() + 1);
    Ok(in_words(figure, &found, all.len()))
}

/// The view, turned about its line of sight so that the ray goes to the right.
fn along_the_ray(figure: &Figure, ray: &Ray) -> Result<Projection, FigureError> {
    let towards = figure.projection().towards();
    let across = ray.direction.reject_from_normalized(towards);
    /// Of a unit vector: a ray that is shorter than this is seen from its end.
    const SHORT: f64 = 1e-3;
    if across.length() < SHORT {
        return Err(FigureError::new(
            "view",
            "the view is along the ray, so t has no direction in it",
            "choose another \"view\"",
        ));
    }
    Ok(Projection::new(across, towards.cross(across)))
}

/// From the ray's origin to behind the slabs, and the bound's own height.
fn space(
    all: &[Slab],
    ray: &Ray,
    found: &SlabTests,
    projection: Projection,
    frame: Frame,
) -> Space {
    /// A slab along the ray ends far away: so much further than the bound is shown.
    const FURTHEST: f64 = 1.5;
    /// The axis goes on behind the last plane.
    const BEYOND: f64 = 1.06;
    /// Beside the ray, of the bound's height.
    const ASIDE: f64 = 0.2;
    let corners = bound::corners(all);
    let along = corners.iter().map(|p| ray.direction.dot(*p - ray.origin));
    let bound_ends = along.fold(0.0, f64::max);
    let fars = found
        .tests
        .iter()
        .map(|(_, test)| match test.step.interval {
            SlabInterval::Between { far, .. } => far,
            SlabInterval::ParallelInside | SlabInterval::ParallelOutside => 0.0,
        });
    let end = fars.fold(bound_ends, f64::max).min(FURTHEST * bound_ends);
    let mut shown: Vec<DVec2> = corners.iter().map(|p| projection.of(*p)).collect();
    // a ray past the bound is not at the edge of the drawing
    let height = Frame::around(shown.iter().copied()).map_or(0.0, |around| around.size().y);
    let aside = DVec2::new(0.0, ASIDE * height);
    let ends = [ray.origin, ray.at(BEYOND * end)].map(|p| projection.of(p));
    shown.extend(ends.iter().flat_map(|&p| [p - aside, p + aside]));
    Space::fitted_flat(projection, frame, shown)
}

/// The ray through the bound and its slabs.
fn geometry(
    figure: &Figure,
    sheet: &mut Sheet,
    space: &Space,
    ray: &Ray,
    all: &[Slab],
    found: &SlabTests,
) {
    if figure.shows(Layer::Objects) {
        scenery::some_objects(figure, sheet, space, &found.objects(figure), Look::OBJECT);
    }
    if figure.shows(Layer::Volumes) {
        let around = bound::outline(all, &space.projection);
        outline::rim(sheet, space, &around.rim, Look::VISITED.wide(2.5));
    }
    let middle = bound::middle(all);
    let room = Frame {
        min: space.frame.min + DVec2::new(0.0, 1.5 * sheet.letters),
        max: space.frame.max - DVec2::new(0.0, sheet.letters),
    };
    for slab in all {
        let test = found
            .tests
            .iter()
            .find(|(_, test)| test.step.slab == slab.number);
        sheet.step(test.map(|(step, _)| *step), |sheet| {
            if figure.shows(Layer::Slabs) && slab.is_on_edge(&space.projection) {
                let look = if test.is_some() {
                    Look::VISITED.outline().wide(1.0)
                } else {
                    Look::CULLED
                };
                bound::pair(sheet, space, room, slab, middle, look);
            }
            if let Some((_, test)) = test
                && let SlabInterval::Between { near, far } = test.step.interval
            {
                for (t, is_near) in [(near, true), (far, false)] {
                    let at = space.place(ray.at(t));
                    if !space.frame.contains(at) {
                        continue;
                    }
                    if is_near {
                        sheet.dot(OF_SLAB, at);
                    } else {
                        sheet.ring(OF_SLAB.wide(1.75), at);
                    }
                }
            }
        });
    }
    let from = space.place(ray.origin);
    let to = DVec2::new(space.frame.max.x, from.y);
    sheet.arrow(Look::RAY, from, to);
    sheet.dot(Look::RAY, from);
    sheet.label(space.frame, from, DVec2::NEG_Y, "COP");
}

fn in_words(figure: &Figure, found: &SlabTests, slabs: usize) -> String {
    let mut sentences = vec![format!(
        "The ray and the slabs of {}, one after the other.",
        bounded(figure, found.of)
    )];
    for (_, test) in &found.tests {
        let step = &test.step;
        let number = step.slab;
        let (near, far) = (quantity(step.max_near), quantity(step.min_far));
        sentences.push(match (step.interval, step.verdict) {
            (SlabInterval::Between { near: a, far: b }, SlabVerdict::Null) => format!(
                "Slab {number}: near {}, far {}; max near {near} > min far {far}: null intersection.",
                quantity(a),
                quantity(b)
            ),
            (SlabInterval::Between { near: a, far: b }, _) => format!(
                "Slab {number}: near {}, far {}; max near {near} ≤ min far {far}.",
                quantity(a),
                quantity(b)
            ),
            (_, SlabVerdict::ParallelOutside | SlabVerdict::Null) => {
                format!("Slab {number}: parallel and outside: null intersection.")
            }
            _ => format!("Slab {number}: parallel and inside."),
        });
    }
    match slabs.saturating_sub(found.tests.len()) {
        0 => {}
        1 => sentences.push("One more slab is not tested.".into()),
        left => sentences.push(format!("{left} more slabs are not tested.")),
    }
    sentences.join(" ")
}
