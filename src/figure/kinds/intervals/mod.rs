//! Near and far along a ray, slab by slab (slides, "Optimizing Intersection Calculations").
//!
//! Above, the bound with its slabs, turned so that the ray lies level; below, on the axis of t beneath the ray, the
//! interval of each slab and what all slabs so far have in common. Where nothing is left the processing stops, and
//! the slabs behind are not looked at.

mod argument;

use glam::DVec2;

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::kinds::intervals::argument::Argument;
use crate::figure::kinds::slabs::{SlabTests, bounded};
use crate::figure::parts::bound::{self, Slab};
use crate::figure::parts::outline;
use crate::figure::parts::scenery;
use crate::figure::parts::slab_rows::{Axis, LEFT, OF_SLAB, SO_FAR};
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::text::formula;
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::view::{Projection, Space};
use crate::geometry::{Ray, SlabInterval};
use crate::structure::{SlabStep, SlabVerdict};

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
    let records = figure.records()?;
    let starts = drawn.node.ends_at[0].map(|at| records[at].step);
    let all = bound::bound_of(figure.first, found.of)?;
    let projection = along_the_ray(figure, &ray)?;
    let argument = Argument::new(figure, sheet, &found, &all, starts);

    // the letters of a slide leave no room for it, and the rows say it as well
    let body = if figure.shows(Layer::Legend) && sheet.width == Width::Book {
        let entries = [
            (OF_SLAB, "near to far of one slab"),
            (SO_FAR, "max near to min far of all slabs so far"),
        ];
        let entries = entries.map(|(look, words)| (Some(argument.slab(0)), look, words));
        sheet.staged_legend(body, &entries)
    } else {
        body
    };
    let row = sheet.line_height()
        * match sheet.width {
            Width::Book => 1.35,
            Width::Slide => 0.92,
        };
    // one for each slab, one for what is left, the axis with its numbers
    let below = (all.len() as f64 + 1.0) * row + 1.5 * sheet.line_height();
    let [drawing, rows] = body.split_top(body.size().y - below);
    let margin = DVec2::new(2.5 * sheet.letters, 0.0);
    let inner = Frame {
        min: drawing.min + margin,
        max: drawing.max,
    };
    let space = space(&all, &ray, &found, projection, inner);
    geometry(figure, sheet, &space, &ray, (&all, &found), &argument);

    let axis = Axis {
        space: &space,
        ray: &ray,
        frame: rows,
        row,
    };
    for (place, slab) in all.iter().enumerate() {
        let title = slab.title(&figure.projection());
        if let Some(test) = found.of_slab(slab) {
            sheet.at(argument.slab(test), |sheet| {
                let (step, test) = &found.tests[test];
                sheet.step(*step, |sheet| {
                    let names = (formula(&slab.name()), title);
                    axis.slab(sheet, place, names, &test.step);
                });
            });
        } else {
            sheet.at(argument.interval, |sheet| {
                axis.untouched(sheet, place, title);
            });
        }
    }
    let tested = found.tests.iter().filter_map(|(_, test)| {
        let row = all.iter().position(|slab| slab.number == test.step.slab)?;
        Some((row, test.step))
    });
    let tested: Vec<(usize, SlabStep)> = tested.collect();
    sheet.at(argument.interval, |sheet| {
        axis.result(sheet, all.len(), &tested);
    });
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
    const FURTHEST: f64 = 1.65;
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
    (all, found): (&[Slab], &SlabTests),
    argument: &Argument,
) {
    if figure.shows(Layer::Objects) {
        scenery::some_objects(figure, sheet, space, &found.objects(figure), Look::OBJECT);
    }
    let left = found.tests.last().and_then(|(_, test)| test.step.inside());
    if figure.shows(Layer::Volumes) {
        let around = bound::outline(all, &space.projection);
        outline::rim(sheet, space, &around.rim, Look::OBJECT.outline());
        let look = match left {
            Some(_) => Look::VISITED.wide(2.5),
            None => Look::REJECTED,
        };
        sheet.at(argument.interval, |sheet| {
            outline::rim(sheet, space, &around.rim, look);
        });
    }
    let from = space.place(ray.origin);
    let to = DVec2::new(space.frame.max.x, from.y);
    sheet.at(argument.ray, |sheet| {
        sheet.arrow(Look::RAY, from, to);
        sheet.dot(Look::RAY, from);
        sheet.label(space.frame, from, DVec2::NEG_Y, "COP");
    });
    let middle = bound::middle(all);
    let room = Frame {
        min: space.frame.min + DVec2::new(0.0, 1.5 * sheet.letters),
        max: space.frame.max - DVec2::new(0.0, sheet.letters),
    };
    for slab in all {
        let shows_pair = figure.shows(Layer::Slabs) && slab.is_on_edge(&space.projection);
        let Some(test) = found.of_slab(slab) else {
            if shows_pair {
                sheet.at(argument.interval, |sheet| {
                    bound::pair(sheet, space, room, slab, middle, Look::CULLED);
                });
            }
            continue;
        };
        let (step, test_of) = &found.tests[test];
        sheet.at(argument.slab(test), |sheet| {
            sheet.step(*step, |sheet| {
                if shows_pair {
                    let look = Look::VISITED.outline().wide(1.0);
                    bound::pair(sheet, space, room, slab, middle, look);
                }
                near_and_far(sheet, space, ray, test_of.step.interval);
            });
        });
    }
    let Some([near, far]) = left.and_then(|left| left.ends()) else {
        return;
    };
    let ends = [near, far].map(|t| space.place(ray.at(t)));
    sheet.at(argument.interval, |sheet| {
        sheet.line(LEFT, ends[0], ends[1]);
        for at in ends {
            sheet.dot(Look::ANSWER, at);
        }
    });
}

/// Where the ray enters a slab and where it leaves it.
fn near_and_far(sheet: &mut Sheet, space: &Space, ray: &Ray, interval: SlabInterval) {
    let SlabInterval::Between { near, far } = interval else {
        return;
    };
    for (t, is_near) in [(near, true), (far, false)] {
        let at = space.place(ray.at(t));
        if !space.frame.contains(at) {
            continue;
        }
        if t < 0.0 {
            // the plane lies behind the origin
            sheet.line(Look::LINE_OF_RAY, at, space.place(ray.origin));
        }
        if is_near {
            sheet.dot(OF_SLAB, at);
        } else {
            sheet.ring(OF_SLAB.wide(1.75), at);
        }
    }
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

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use serde_json::json;

    use crate::figure::kinds::slabs::by_hand;
    use crate::figure::read_back::ReadBack;

    #[test]
    fn near_and_far_lie_on_the_ray_and_on_the_axis_at_their_t() {
        // the cube's x from 4 to 6 lie at t = 5 and 7.5, its y from −1 to 1 at t = 6 and 9.333
        let traced = by_hand::trace(DVec3::new(0.0, -4.6, 0.0), DVec3::new(0.8, 0.6, 0.0));
        let drawn = ReadBack::of(
            json!({"kind": "intervals", "pixel": [0, 0], "view": "front"}),
            traced,
        );
        let [enter, leave] = drawn.dots("answer")[..] else {
            panic!("{:?}", drawn.dots("answer"));
        };
        assert!((enter.y - leave.y).abs() < 0.02, "the ray is level");
        // from t = 0 to 6 is four times as long as from 6 to 7.5
        let origin = enter - 4.0 * (leave - enter);
        let is_at = |at: &glam::DVec2| at.distance(origin) < 0.05;
        assert!(drawn.dots("ink").iter().any(is_at), "no origin at {origin}");
        // below, what is left is as long
        let lines = drawn.paths("answer");
        let row = lines.iter().filter(|line| line[0].y > enter.y + 50.0);
        let row: Vec<_> = row.collect();
        assert_eq!(row.len(), 1, "{lines:?}");
        assert!((row[0][0].x - enter.x).abs() < 0.02 && (row[0][1].x - leave.x).abs() < 0.02);
        let texts = drawn.texts();
        for text in [
            "n0: near 5",
            "7.5 far",
            "n1: 6",
            "max near 6",
            "min far 7.5",
        ] {
            assert!(texts.iter().any(|of| of == text), "{text}: {texts:?}");
        }
    }
}
