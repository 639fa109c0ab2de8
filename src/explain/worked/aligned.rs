//! Aligned rays: the frame in which the ray is the z axis, what it makes of an object, and the z sort.

use glam::DVec3;

use crate::explain::number::{Digits, without_rounding};
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::steps::{Course, Step, Told};
use crate::geometry::{AlignedRay, AlignedSlab, Alignment, Ray, SlabInterval};
use crate::scene::Shape;
use crate::trace::{Aligned, AlignedPart, Event, Kind, RayStart, StrategyName, ZSort};

/// A polygon with more vertices than this shows only the first of them.
const VERTICES_SHOWN: u32 = 8;

/// The ray and the frame in which its tests are worked out, if they are not in the world. In a filtered
/// log either the alignment or the ray's start may be missing.
pub(super) fn aligned_ray(
    context: &Context,
    steps: &[Told],
    start: Option<RayStart>,
) -> Option<AlignedRay> {
    let frame = steps.iter().find_map(|told| match told.step {
        Step::Search(Event::Align(frame)) => Some(frame),
        _ => None,
    });
    if frame.is_none() && context.settings.strategy != StrategyName::ZAligned {
        return None;
    }
    let from_frame = || frame.map(|frame| Ray::new(frame.origin, frame.z));
    let ray = start.map(|start| start.ray).or_else(from_frame)?;
    Some(AlignedRay::new(&ray))
}

/// The rows of the rotation, where they come from, and what they make of the ray.
pub(super) fn align(context: &Context, frame: &Alignment, page: &mut Pen) {
    if !context.shows(Kind::Align) {
        return;
    }
    let d = Digits::USUAL;
    let Alignment { origin, x, y, z } = *frame;
    let e = frame.shortest();
    let along = e.dot(z);
    let lines = [
        format!("o = {}, z = Δ = {}", d.vector(origin), d.vector(z)),
        format!(
            "x = [e − (e·z)·z]/|z × e| = [{} − {}·{}]/{} = {}, with e the axis of the smallest component of Δ",
            d.vector(e),
            d.factor(along),
            d.vector(z),
            d.number(z.cross(e).length()),
            d.vector(x)
        ),
        format!("y = z × x = [z × e]/|z × e| = {}", d.vector(y)),
        "o′ = (0, 0, 0), Δ′ = (x·Δ, y·Δ, z·Δ) = (0, 0, 1): any hit has x = y = 0, and its z is t"
            .into(),
    ];
    let words = ", in which the ray is the z axis: p′ = (x·(p − o), y·(p − o), z·(p − o))";
    page.titled(Part::Alignment, words);
    page.indented(|page| {
        for line in lines {
            page.plain(line);
        }
    });
}

/// A point of an object, before and after.
pub(super) fn aligned(context: &Context, point: &Aligned, page: &mut Pen) {
    if !context.shows(Kind::Aligned) {
        return;
    }
    let d = Digits::USUAL;
    let name = context.name(point.object);
    let part = match point.part {
        AlignedPart::Center => "centre".into(),
        AlignedPart::HalfAxis => format!("half axis {}", point.index),
        AlignedPart::Vertex => format!("vertex {}", point.index),
        AlignedPart::Base => "base".into(),
        AlignedPart::Apex => "apex".into(),
    };
    if context.options.all || point.index < VERTICES_SHOWN {
        let (from, to) = (d.vector(point.from), d.vector(without_rounding(point.to)));
        let words = format!(": {part} of {name} {from} → {to}");
        page.headed(Part::AlignedPoint, words);
        return;
    }
    // the rest of the vertices is summed up where the last one stands
    let Shape::Polygon(polygon) = &context.scene.primitive(point.object).shape else {
        return;
    };
    if polygon.vertices().len() == point.index as usize + 1 {
        let more = (point.index + 1 - VERTICES_SHOWN) as usize;
        let vertices = if more == 1 { "vertex" } else { "vertices" };
        let text = format!("… {more} more {vertices} of {name}");
        page.folded(more, text);
    }
}

/// A hit in its place; the first one goes back into the world.
pub(super) fn z_sort(context: &Context, sorted: &ZSort, course: &Course, page: &mut Pen) {
    if !context.shows(Kind::ZSort) {
        return;
    }
    let d = Digits::USUAL;
    let z = d.number(sorted.z);
    if sorted.place == 0 {
        page.titled(Part::ZSort, ": the hits, the nearest first");
    }
    let mut text = format!(
        "{}. {} at z = {z}",
        sorted.place + 1,
        context.name(sorted.object)
    );
    if let (0, Some(aligned)) = (sorted.place, &course.aligned) {
        let frame = aligned.frame;
        text = format!(
            "{text}: (0, 0, {z}) is o + z·Δ = {} + {}·{} = {} in the scene",
            d.vector(frame.origin),
            d.factor(sorted.z),
            d.vector(frame.z),
            d.vector(frame.back(DVec3::new(0.0, 0.0, sorted.z)))
        );
    }
    page.indented(|page| page.plain(text));
}

/// (ii) at x = y = 0: what the alignment simplifies.
pub(super) fn sphere_at_axis(center: DVec3, radius: f64, page: &mut Pen) {
    let radius2 = radius * radius;
    let inside = radius2 - center.truncate().length_squared();
    let d = Digits::for_difference(radius2, inside);
    page.part(Part::Discriminant).plain(format!(
        "at x = y = 0 (ii) is (z − c_z)² = r² − c_x² − c_y² = {}² − {}² − {}² = {}",
        d.number(radius),
        d.factor(center.x),
        d.factor(center.y),
        d.difference(radius2, inside)
    ));
}

/// A slab of a box whose normal is turned: at x = y = 0 its planes are z = −D/C.
pub(super) fn turned_slab(name: &str, slab: &AlignedSlab, interval: SlabInterval) -> String {
    let d = Digits::USUAL;
    let normal = d.vector(without_rounding(slab.normal));
    let text = format!(" of the slab across {name}, turned to (A, B, C) = {normal}");
    match interval {
        SlabInterval::ParallelInside => {
            format!("{text}: the ray is parallel and inside for every z")
        }
        SlabInterval::ParallelOutside => {
            format!("{text}: the ray is parallel and outside for every z")
        }
        SlabInterval::Between { near, far } => {
            // the near plane is that of D_max if the ray runs along the normal
            let (first, second) = if slab.t_scale < 0.0 {
                (slab.d_max, slab.d_min)
            } else {
                (slab.d_min, slab.d_max)
            };
            let cosine = -1.0 / slab.t_scale;
            let at = |d_plane: f64, z: f64| {
                let quotient = format!("{}/{}", d.factor(d_plane), d.factor(cosine));
                format!("= −D/C = −{quotient} = {}", d.number(z))
            };
            format!("{text}: near {}, far {}", at(first, near), at(second, far))
        }
    }
}
