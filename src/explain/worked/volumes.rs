//! Bounding volumes: where a ray hits one, slab by slab, and whether what is inside is tested.

use glam::DVec3;

use crate::explain::number::Digits;
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::printable;
use crate::explain::worked::bare::bare_inside;
use crate::explain::worked::context::Context;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::steps::Course;
use crate::geometry::{AxisBox, SlabInterval, TRange};
use crate::structure::{SlabSet, SlabStep, SlabVerdict, Volume, VolumeKind};
use crate::trace::{BoundTest, BoundVerdict, Bounded, Kind, Purpose, RaySlab, SlabTest};

/// S and T of the ray and one direction of slabs.
pub(super) fn slab_ray(line: &RaySlab, course: &Course, page: &mut Pen) {
    page.headed(Part::SlabRay, s_and_t(line, course));
}

/// S, T, and from D_min and D_max the near and the far t of one slab.
pub(super) fn slab_test(context: &Context, test: &SlabTest, course: &Course, page: &mut Pen) {
    if !context.shows(Kind::SlabTest) {
        return;
    }
    let step = &course.bare_slab(test);
    if step.slab == 0 {
        let title = format!(" of {}, slab by slab", bounded(context, test.of));
        page.titled(Part::Bound, title);
    }
    let line = course.slab_rays.iter().find(|line| line.slab == step.slab);
    // a log that somebody filtered may have lost it
    let first = line.map_or_else(
        || format!(" of slab {}: not in the log", step.slab),
        |line| s_and_t(line, course),
    );
    let second = near_and_far(step, line);
    let (tone, third) = interval(step);
    page.indented(|page| {
        page.headed(Part::SlabRay, first);
        page.indented(|page| {
            page.headed(Part::NearFar, second);
            page.headed_line(tone, Part::Interval, third);
        });
    });
}

/// Where the ray is inside a volume, and what follows from that.
pub(super) fn bound_test(context: &Context, test: &BoundTest, course: &Course, page: &mut Pen) {
    if !context.shows(Kind::BoundTest) {
        return;
    }
    let d = Digits::USUAL;
    let (tested, left_out) = match test.of {
        Bounded::Object(_) => ("the object is tested", "the object is not tested"),
        Bounded::Node(_) => (
            "the node can be entered",
            "nothing below the node is tested",
        ),
    };
    let volume = match test.volume {
        VolumeKind::Sphere => "sphere",
        VolumeKind::Ellipsoid => "ellipsoid",
        VolumeKind::Box => "box",
        VolumeKind::Slabs => "slabs",
    };
    let bare = bare_inside(context, test, course);
    let stretch = bare.map_or(String::new(), |[near, far]| {
        format!("inside for t in [{}, {}]", d.number(near), d.number(far))
    });
    let begins = bare.map_or(String::new(), |[near, _]| d.number(near));
    let by_room = by_room_alone(test, bare, course);
    let of = bounded(context, test.of);
    let verdict = match test.verdict {
        BoundVerdict::Behind | BoundVerdict::Beyond if bare.is_none() => BoundVerdict::Missed,
        verdict => verdict,
    };
    let (tone, text) = match verdict {
        BoundVerdict::Hit if let Some(why) = by_room => {
            (Tone::Found, format!("{why}, so {tested}"))
        }
        BoundVerdict::Hit => (Tone::Found, format!("hit, {stretch}, so {tested}")),
        BoundVerdict::Missed => (Tone::Refused, format!("missed, so {left_out}")),
        BoundVerdict::Behind => (
            Tone::Refused,
            format!("behind the origin, {stretch}, so {left_out}"),
        ),
        BoundVerdict::Beyond => (
            Tone::Refused,
            format!("begins at t = {begins}, {}, so {left_out}", beyond(course)),
        ),
    };
    page.headed_line(tone, Part::Bound, format!(" of {of} ({volume}): {text}"));
    if let Some(place) = volume_of(context, test) {
        page.indented(|page| page.part(Part::Bound).line(Tone::Aside, place));
    }
}

/// Where the volume around an object is, built again from the scene; slabs are written one by one.
fn volume_of(context: &Context, test: &BoundTest) -> Option<String> {
    let d = Digits::USUAL;
    let Bounded::Object(object) = test.of else {
        return None;
    };
    let object = object as usize;
    context.scene.objects.get(object)?;
    match Volume::around(context.scene, object, test.volume, &SlabSet::AXES) {
        Volume::Sphere(sphere) => Some(format!(
            "centre {}, radius {}",
            d.vector(sphere.center),
            d.number(sphere.radius)
        )),
        Volume::Ellipsoid(ellipsoid) => {
            let [a, b, c] = [0, 1, 2].map(|i| d.vector(ellipsoid.radii[i] * ellipsoid.axes[i]));
            let center = d.vector(ellipsoid.center);
            Some(format!("centre {center}, half axes {a}, {b} and {c}"))
        }
        Volume::Box(bound) => {
            let AxisBox { min, max } = bound.as_box();
            Some(format!("from {} to {}", d.vector(min), d.vector(max)))
        }
        Volume::Slabs(_) | Volume::Nothing => None,
    }
}

/// What a volume is around, as it is called in the text.
fn bounded(context: &Context, of: Bounded) -> String {
    match of {
        Bounded::Node(node) => format!("node {node}"),
        Bounded::Object(object) => {
            let object = context.scene.objects.get(object as usize);
            object.map_or("?".into(), |object| printable(&object.name))
        }
    }
}

/// That a volume counts by its padding alone, if it does.
fn by_room_alone(test: &BoundTest, bare: Option<[f64; 2]>, course: &Course) -> Option<String> {
    let d = Digits::USUAL;
    let range = course.start.map_or(TRange::FORWARD, |start| start.range);
    let range = course.nearest.map_or(range, |t| range.up_to(t));
    let what = match (BoundVerdict::of(bare, range), bare) {
        (BoundVerdict::Hit, _) => return None,
        (BoundVerdict::Behind, Some([_, far])) => {
            format!("ends at t = {}, before the t that count", d.number(far))
        }
        (BoundVerdict::Beyond, Some([near, _])) => {
            format!("begins at t = {}, {}", d.number(near), beyond(course))
        }
        _ => "missed".into(),
    };
    let room = d.number(test.room);
    Some(format!("{what}, but by less than its padding, {room}"))
}

/// Behind what a volume begins.
fn beyond(course: &Course) -> String {
    let shadow = course
        .start
        .is_some_and(|start| start.purpose == Purpose::Shadow);
    match course.nearest {
        _ if shadow => "beyond the light".into(),
        Some(t) => format!("behind the nearest hit, t = {}", Digits::USUAL.number(t)),
        None => "behind the nearest hit".into(),
    }
}

/// S = A·x₀ + B·y₀ + C·z₀ and T = −1/(A·Δx + B·Δy + C·Δz), with their numbers.
fn s_and_t(line: &RaySlab, course: &Course) -> String {
    let slab = format!(
        " of slab {}, (A, B, C) = {}",
        line.slab,
        Digits::USUAL.vector(line.normal)
    );
    let is_parallel = line.t_scale == f64::INFINITY;
    let Some(start) = course.start else {
        let d = Digits::USUAL;
        let (s, t) = (d.number(line.s), d.number(line.t_scale));
        return if is_parallel {
            format!("{slab}: S = {s}")
        } else {
            format!("{slab}: S = {s}, T = {t}")
        };
    };
    let (n, origin, direction) = (line.normal, start.ray.origin, start.ray.direction);
    let largest = |v: DVec3| (n * v).abs().max_element();
    let d_s = Digits::for_difference(largest(origin), line.s);
    let s = d_s.difference(largest(origin), line.s);
    let s = format!("{slab}: S = {} = {s}", d_s.dot(n, origin));
    let cosine = n.dot(direction);
    if is_parallel {
        let product = Digits::USUAL.dot(n, direction);
        let cosine = Digits::USUAL.difference(largest(direction), cosine);
        return format!("{s}, {product} = {cosine}: the ray is parallel");
    }
    let d_t = Digits::for_difference(largest(direction), cosine);
    format!(
        "{s}, T = −1/[{}] = {}",
        d_t.dot(n, direction),
        Digits::USUAL.number(line.t_scale)
    )
}

/// near = (S + D)·T of the plane that the ray hits first, far of the other; for a parallel ray whether S is between the
/// planes.
fn near_and_far(step: &SlabStep, line: Option<&RaySlab>) -> String {
    let d = Digits::USUAL;
    let (d_min, d_max) = (step.d_min, step.d_max);
    let Some(&RaySlab { s, t_scale, .. }) = line else {
        return without_products(step);
    };
    // T < 0 along the normal: then the ray hits the plane furthest back, of D_max, first (erratum 5)
    let (first, second) = if t_scale < 0.0 {
        (("D_max", d_max), ("D_min", d_min))
    } else {
        (("D_min", d_min), ("D_max", d_max))
    };
    let product = |(name, plane): (&str, f64), t: f64| {
        let d_sum = Digits::for_difference(s.abs().max(plane.abs()), s + plane);
        format!(
            " = (S + {name})·T = ({} {})·{} = {}",
            d_sum.number(s),
            d_sum.term(plane),
            d.factor(t_scale),
            d.number(t)
        )
    };
    let between = |inside: &str| {
        let size = d_min.abs().max(d_max.abs());
        let edge = (s + d_min).abs().min((s + d_max).abs());
        let d = Digits::for_difference(size.max(s.abs()), edge);
        format!(
            ": −D_max = {}, −D_min = {}, and S {inside}",
            d.number(-d_max),
            d.number(-d_min)
        )
    };
    let (near, far) = match step.interval {
        SlabInterval::ParallelInside => {
            return between("is between them, so the ray is inside for every t");
        }
        SlabInterval::ParallelOutside => {
            return between("is not between them, so the ray is outside for every t");
        }
        SlabInterval::Between { near, far } => (near, far),
    };
    format!(
        ": near{}, far{}",
        product(first, near),
        product(second, far)
    )
}

/// The same where S and T are not known.
fn without_products(step: &SlabStep) -> String {
    let d = Digits::USUAL;
    match step.interval {
        SlabInterval::ParallelInside => ": the ray is parallel and inside for every t".into(),
        SlabInterval::ParallelOutside => ": the ray is parallel and outside for every t".into(),
        SlabInterval::Between { near, far } => {
            format!(": near = {}, far = {}", d.number(near), d.number(far))
        }
    }
}

/// What all slabs so far have in common.
fn interval(step: &SlabStep) -> (Tone, String) {
    let (near, far) = (step.max_near, step.min_far);
    match step.verdict {
        SlabVerdict::GoesOn | SlabVerdict::ParallelInside => {
            let d = Digits::USUAL;
            let text = match (near.is_finite(), far.is_finite()) {
                (true, true) => format!(
                    ": max near {} ≤ min far {} so far",
                    d.number(near),
                    d.number(far)
                ),
                _ => ": every t so far".into(),
            };
            (Tone::Plain, text)
        }
        SlabVerdict::ParallelOutside => (
            Tone::Refused,
            ": empty, missed; no more slabs are tested".into(),
        ),
        SlabVerdict::Null => {
            let d = Digits::for_difference(near.abs().max(far.abs()), near - far);
            let sign = if far < near { ">" } else { "=" };
            let text = format!(
                ": max near {} {sign} min far {}: no t in common, missed; no more slabs are tested",
                d.number(near),
                d.number(far)
            );
            (Tone::Refused, text)
        }
    }
}
