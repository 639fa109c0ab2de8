//! The box: three slabs, their intervals and what they have in common.

use crate::explain::number::Digits;
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::worked::aligned::turned_slab;
use crate::explain::worked::context::Context;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::quadratic;
use crate::explain::worked::roots::choice;
use crate::explain::worked::steps::Course;
use crate::geometry::{Axis, BoxTest, Inside, Roots, SlabInterval};
use crate::scene::{PrimitiveId, Shape};

/// What the letters of a slab across an axis are.
const LETTERS: &str = "near, far of a slab: S is the coordinate of o along its axis, D is minus the coordinate of a \
    plane, and T is −1 over the component of Δ along the axis";

/// near = max of the near values, far = min of the far ones.
pub(super) fn slabs(
    context: &Context,
    object: PrimitiveId,
    test: &BoxTest,
    course: &Course,
    page: &mut Pen,
) {
    let Shape::Box(solid) = &context.scene.primitive(object).shape else {
        return;
    };
    let solid = *solid;
    let d = Digits::USUAL;
    let what = match course.aligned {
        Some(_) => format!(
            "box around {}, half sides {}",
            d.vector(course.place(0.5 * (solid.min + solid.max))),
            d.vector(0.5 * (solid.max - solid.min))
        ),
        None => format!(
            "box from {} to {}",
            d.vector(solid.min),
            d.vector(solid.max)
        ),
    };
    let turned = course.aligned.map(|aligned| solid.aligned_slabs(&aligned));
    quadratic::object_line(context, object, &what, page);
    page.indented(|page| {
        if turned.is_none() && course.start.is_some() {
            page.once(Part::NearFar, LETTERS);
        }
        let axes = [("x", Axis::X), ("y", Axis::Y), ("z", Axis::Z)];
        for (i, ((name, axis), interval)) in axes.into_iter().zip(test.slabs).enumerate() {
            if let Some(slabs) = &turned {
                page.headed(Part::NearFar, turned_slab(name, &slabs[i], interval));
                continue;
            }
            let (low, high) = (axis.of(solid.min), axis.of(solid.max));
            let slab = format!(" of {} ≤ {name} ≤ {}", d.number(low), d.number(high));
            let line = match (interval, course.start) {
                (SlabInterval::ParallelInside, _) => {
                    format!("{slab}: the ray is parallel and inside for every t")
                }
                (SlabInterval::ParallelOutside, _) => {
                    format!("{slab}: the ray is parallel and outside for every t")
                }
                (SlabInterval::Between { near, far }, Some(start)) => {
                    let (s, delta) = (axis.of(start.ray.origin), axis.of(start.ray.direction));
                    let t_scale = -1.0 / delta;
                    // D is minus the plane's place; the near plane is the high one if the ray runs down
                    let (first, second) = if delta < 0.0 {
                        (high, low)
                    } else {
                        (low, high)
                    };
                    let product = |plane: f64, t: f64| {
                        let d = Digits::for_difference(plane.abs().max(s.abs()), s - plane);
                        let (s, plane) = (d.number(s), d.term(-plane));
                        format!("({s} {plane})·{} = {}", d.factor(t_scale), d.number(t))
                    };
                    format!(
                        "{slab}: T = −1/{} = {}, near = (S + D)·T = {}, far = (S + D)·T = {}",
                        d.factor(delta),
                        d.number(t_scale),
                        product(first, near),
                        product(second, far)
                    )
                }
                (SlabInterval::Between { near, far }, None) => {
                    format!("{slab}: near = {}, far = {}", d.number(near), d.number(far))
                }
            };
            page.headed(Part::NearFar, line);
        }
        match test.roots {
            Roots::None => page.headed_line(Tone::Refused, Part::Interval, no_common_t(test)),
            Roots::Graze(_) | Roots::Two { .. } | Roots::Linear(_) => {
                let ends: Vec<_> = test.roots.iter().map(|root| d.number(root.t)).collect();
                let near = ends.first().map_or("", String::as_str);
                let far = ends.last().map_or("", String::as_str);
                let text = format!(
                    ": max near {near} ≤ min far {far}: inside all three slabs for t in [{near}, {far}]"
                );
                page.headed(Part::Interval, text);
                choice(&test.roots, course, page);
            }
        }
    });
}

fn no_common_t(test: &BoxTest) -> String {
    let d = Digits::USUAL;
    if test.slabs.contains(&SlabInterval::ParallelOutside) {
        return ": empty, the ray is outside one slab for every t: missed".into();
    }
    let Inside { near, far } = test.slabs.into_iter().fold(Inside::EVERYWHERE, Inside::and);
    format!(
        ": max near {} > min far {}: no t in common, missed",
        d.number(near),
        d.number(far)
    )
}
