//! Sphere, ellipsoid and cone: the quadratic with its numbers, and its roots, each with its verdict.

use glam::DVec3;

use crate::explain::number::Digits;
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::worked::aligned;
use crate::explain::worked::context::Context;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::steps::Course;
use crate::geometry::{Fate, QuadraticTest, Ray, Root, Roots};
use crate::scene::{PrimitiveId, Shape};
use crate::trace::Purpose;

/// Equation (iii).
pub(super) fn sphere(
    context: &Context,
    object: PrimitiveId,
    test: &QuadraticTest,
    course: &Course,
    full: bool,
    page: &mut Pen,
) {
    let Shape::Sphere(sphere) = &context.scene.primitive(object).shape else {
        return;
    };
    let (center, radius) = (course.place(sphere.center), sphere.radius);
    let d = Digits::USUAL;
    let what = format!(
        "sphere, center {}, radius {}",
        d.vector(center),
        d.number(radius)
    );
    let Some(ray) = course.ray().filter(|_| full) else {
        return quadratic_in_short(context, object, &what, test, course, page);
    };
    object_line(context, object, &what, page);
    let offset = ray.origin - center;
    page.indented(|page| {
        let given = precise(test, offset).vector(offset);
        page.headed(Part::Frame, format!(": o − center = {given}"));
        coefficients(&Ray::new(offset, ray.direction), radius, test, page);
        roots(test, page);
        match course.aligned {
            Some(_) => aligned::sphere_at_axis(center, radius, page),
            None => page.once(Part::Discriminant, COMPUTED_FOR_SPHERE),
        }
        verdict(&test.roots, course, page);
    });
}

/// Equation (iii) for the unit sphere that the ellipsoid is in a space of its own.
pub(super) fn ellipsoid(
    context: &Context,
    object: PrimitiveId,
    test: &QuadraticTest,
    course: &Course,
    full: bool,
    page: &mut Pen,
) {
    let Shape::Ellipsoid(ellipsoid) = &context.scene.primitive(object).shape else {
        return;
    };
    let ellipsoid = *ellipsoid;
    let (center, radii) = (course.place(ellipsoid.center), ellipsoid.radii);
    let d = Digits::USUAL;
    let what = format!(
        "ellipsoid, center {}, radii {}",
        d.vector(center),
        d.vector(radii)
    );
    let Some(ray) = course.ray().filter(|_| full) else {
        return quadratic_in_short(context, object, &what, test, course, page);
    };
    object_line(context, object, &what, page);
    let (scaled, offset_by, direction_by) = match course.aligned {
        // its half axes h are turned
        Some(aligned) => (
            ellipsoid.unit_ray(&aligned),
            "hᵢ·(o − center)/rᵢ²",
            "hᵢ·Δ/rᵢ²",
        ),
        None => (
            Ray::new((ray.origin - center) / radii, ray.direction / radii),
            "(o − center)/radii",
            "Δ/radii",
        ),
    };
    let d = precise(test, scaled.origin);
    page.indented(|page| {
        let along = course.aligned.map_or("", |_| " along its half axes h");
        page.headed(
            Part::Frame,
            format!(": divided by its radii{along} it is the unit sphere, and t stays"),
        );
        page.part(Part::Frame).plain(format!(
            "o − center → {offset_by} = {}",
            d.vector(scaled.origin)
        ));
        page.part(Part::Frame).plain(format!(
            "Δ → {direction_by} = {}",
            d.vector(scaled.direction)
        ));
        coefficients(&scaled, 1.0, test, page);
        roots(test, page);
        if course.aligned.is_none() {
            page.once(Part::Discriminant, COMPUTED_FOR_SPHERE);
        }
        verdict(&test.roots, course, page);
    });
}

/// The quadratic of an open cone or cylinder.
pub(super) fn cone(
    context: &Context,
    object: PrimitiveId,
    test: &QuadraticTest,
    course: &Course,
    full: bool,
    page: &mut Pen,
) {
    let Shape::Cone(cone) = &context.scene.primitive(object).shape else {
        return;
    };
    let cone = course
        .aligned
        .map_or(*cone, |aligned| cone.aligned(&aligned.frame));
    let d = Digits::USUAL;
    let [base_radius, apex_radius] = cone.radii();
    let what = if base_radius == apex_radius {
        format!(
            "cylinder from {} to {}, radius {}",
            d.vector(cone.base()),
            d.vector(cone.apex()),
            d.number(base_radius)
        )
    } else {
        format!(
            "cone from {}, radius {}, to {}, radius {}",
            d.vector(cone.base()),
            d.number(base_radius),
            d.vector(cone.apex()),
            d.number(apex_radius)
        )
    };
    let Some(ray) = course.ray().filter(|_| full) else {
        return quadratic_in_short(context, object, &what, test, course, page);
    };
    object_line(context, object, &what, page);
    let (axis, slope) = (cone.axis(), cone.slope());
    let m = ray.origin - cone.base();
    let (height, climb) = (m.dot(axis), ray.direction.dot(axis));
    let across = m - height * axis;
    let direction = ray.direction - climb * axis;
    let radius = base_radius + slope * height;
    let d = precise(test, across);
    page.indented(|page| {
        page.headed(
            Part::Frame,
            format!(
                ": axis w = {}, height {}, k = (r_apex − r_base)/height = {}",
                d.vector(axis),
                d.number(cone.height()),
                d.number(slope)
            ),
        );
        page.part(Part::Frame).plain(format!(
            "m = o − base: m·w = {}, across the axis m⊥ = {}",
            d.number(height),
            d.vector(across)
        ));
        page.part(Part::Frame).plain(format!(
            "Δ: Δ·w = {}, across the axis Δ⊥ = {}; radius at the origin's height R = {}",
            d.number(climb),
            d.vector(direction),
            d.number(radius)
        ));
        equation(page);
        page.part(Part::Coefficients).plain(format!(
            "a = Δ⊥·Δ⊥ − k²(Δ·w)² = {} − {}²·{}² = {}",
            d.number(direction.length_squared()),
            d.factor(slope),
            d.factor(climb),
            d.number(test.a)
        ));
        page.part(Part::Coefficients).plain(format!(
            "b = 2[Δ⊥·m⊥ − k(Δ·w)R] = 2·[{} − {}·{}·{}] = {}",
            d.number(direction.dot(across)),
            d.factor(slope),
            d.factor(climb),
            d.factor(radius),
            d.number(test.b)
        ));
        page.part(Part::Coefficients).plain(format!(
            "c = m⊥·m⊥ − R² = {} − {}² = {}",
            d.number(across.length_squared()),
            d.factor(radius),
            d.difference(across.length_squared(), test.c)
        ));
        roots(test, page);
        // a linear equation is solved as it is printed
        if course.aligned.is_none() && test.a != 0.0 {
            page.once(Part::Discriminant, COMPUTED_FOR_CONE);
        }
        for root in test.roots.iter() {
            let y = height + root.t * climb;
            let text = format!(
                " at t = {}: m·w + t·(Δ·w) = {} {} = {}; the surface has 0 to {}",
                d.number(root.t),
                d.number(height),
                d.term(root.t * climb),
                d.number(y),
                d.number(cone.height())
            );
            page.headed(Part::Height, text);
        }
        verdict(&test.roots, course, page);
    });
}

/// How the program computes the numbers of a sphere, and of the unit sphere that an ellipsoid is in its frame.
const COMPUTED_FOR_SPHERE: &str = "the program computes the same with less rounding: b² − 4ac as \
    4(a·r² − |Δ × (o − center)|²), and the root nearer to 0 as c/(a·t) of the other";

/// The same of a cone.
const COMPUTED_FOR_CONE: &str = "the program computes the same with less rounding: b² − 4ac as \
    4(|R·Δ⊥ − k(Δ·w)·m⊥|² − |Δ⊥ × m⊥|²), and the root nearer to 0 as c/(a·t) of the other";

/// Equation (iii), whose coefficients follow.
fn equation(page: &mut Pen) {
    page.headed(Part::Coefficients, " of a·t² + b·t + c = 0 … (iii)");
}

/// a, b and c of a sphere of a radius around the origin.
fn coefficients(ray: &Ray, radius: f64, test: &QuadraticTest, page: &mut Pen) {
    let d = precise(test, ray.origin);
    let (offset, direction) = (ray.origin, ray.direction);
    equation(page);
    page.part(Part::Coefficients).plain(format!(
        "a = Δ·Δ = {} = {}",
        d.squares(direction),
        d.number(test.a)
    ));
    page.part(Part::Coefficients).plain(format!(
        "b = 2·Δ·(o − center) = 2·[{}] = {}",
        d.dot(direction, offset),
        d.number(test.b)
    ));
    page.part(Part::Coefficients).plain(format!(
        "c = |o − center|² − r² = {} − {}² = {}",
        d.squares(offset),
        d.number(radius),
        d.difference(offset.length_squared(), test.c)
    ));
}

/// The discriminant and the roots.
fn roots(test: &QuadraticTest, page: &mut Pen) {
    let (b2, ac4) = (test.b * test.b, 4.0 * test.a * test.c);
    let size = b2.abs().max(ac4.abs());
    let d = Digits::for_difference(size, test.discriminant);
    let discriminant = format!(
        ": b² − 4ac = {} {} = {}",
        d.number(b2),
        d.term(-ac4),
        d.difference(size, test.discriminant)
    );
    match test.roots {
        Roots::None if test.discriminant < 0.0 => {
            page.headed(
                Part::Discriminant,
                format!("{discriminant} < 0: no real root"),
            );
        }
        Roots::None => page.headed(
            Part::Roots,
            format!(
                ": none, since a = 0 and b = 0, and c = {} is not 0",
                d.number(test.c)
            ),
        ),
        Roots::Graze(root) => {
            page.headed(
                Part::Discriminant,
                format!("{discriminant}: one double root, a graze"),
            );
            let text = format!(
                ": t = −b/2a = {}/{} = {}",
                d.number(-test.b),
                d.factor(2.0 * test.a),
                d.number(root.t)
            );
            page.headed(Part::Roots, text);
        }
        Roots::Two { near, far } => {
            page.headed(
                Part::Discriminant,
                format!("{discriminant} > 0: two real roots"),
            );
            let text = format!(
                ": t = (−b ± √{})/2a = ({} ± {})/{} = {} and {}",
                d.number(test.discriminant),
                d.number(-test.b),
                d.number(test.discriminant.sqrt()),
                d.factor(2.0 * test.a),
                d.number(near.t),
                d.number(far.t)
            );
            page.headed(Part::Roots, text);
        }
        Roots::Linear(root) => {
            let text = format!(
                ": a = 0 leaves b·t + c = 0, one root t = −c/b = {}/{} = {}",
                d.number(-test.c),
                d.factor(test.b),
                d.number(root.t)
            );
            page.headed(Part::Roots, text);
        }
    }
}

/// The verdict on each root.
pub(super) fn verdict(roots: &Roots, course: &Course, page: &mut Pen) {
    let fates = fates(roots, course);
    let (tone, text) = match roots {
        Roots::None => (Tone::Refused, ": none, missed".into()),
        _ if roots.chosen().is_some() => (Tone::Found, format!(": {fates}")),
        _ => (Tone::Refused, format!(": none, {fates}: missed")),
    };
    page.headed_line(tone, Part::Choice, text);
}

/// A miss: the equation with its numbers, and the verdict.
fn quadratic_in_short(
    context: &Context,
    object: PrimitiveId,
    what: &str,
    test: &QuadraticTest,
    course: &Course,
    page: &mut Pen,
) {
    let (b2, ac4) = (test.b * test.b, 4.0 * test.a * test.c);
    let d = Digits::for_difference(b2.abs().max(ac4.abs()), test.discriminant);
    object_line(context, object, what, page);
    let discriminant = format!(
        " of {} {} {} = 0: b² − 4ac = {} {} = {}",
        d.times(test.a, "t²"),
        d.term_times(test.b, "t"),
        d.term(test.c),
        d.number(b2),
        d.term(-ac4),
        d.difference(b2.abs().max(ac4.abs()), test.discriminant)
    );
    page.indented(|page| {
        let why = match test.roots {
            Roots::None if test.discriminant < 0.0 => " < 0, no real root: missed",
            Roots::None => ": no t solves it, missed",
            _ => {
                page.headed(Part::Discriminant, discriminant);
                return verdict(&test.roots, course, page);
            }
        };
        let text = format!("{discriminant}{why}");
        page.headed_line(Tone::Refused, Part::Discriminant, text);
    });
}

/// The name of an object and what it is.
pub(super) fn object_line(context: &Context, object: PrimitiveId, what: &str, page: &mut Pen) {
    let name = context.name(object);
    page.line(Tone::Heading, format!("{name}: {what}"));
}

/// Digits for a, b and c: c is a difference too, that of |o − center|² and r².
fn precise(test: &QuadraticTest, offset: DVec3) -> Digits {
    let (b2, ac4) = (test.b * test.b, 4.0 * test.a * test.c);
    let for_c = Digits::for_difference(offset.length_squared(), test.c);
    Digits::for_difference(b2.abs().max(ac4.abs()), test.discriminant).or(for_c)
}

/// The verdict on each root, in one sentence.
fn fates(roots: &Roots, course: &Course) -> String {
    let chosen = roots.chosen();
    let sentences: Vec<String> = roots
        .iter()
        .map(|root| fate(root, chosen, course))
        .collect();
    sentences.join("; ")
}

/// The verdict on one root.
pub(super) fn fate(root: Root, chosen: Option<f64>, course: &Course) -> String {
    let d = Digits::USUAL;
    let t = format!("t = {}", d.number(root.t));
    match root.fate {
        Fate::Chosen => format!("{t}, the smallest that counts: a hit"),
        Fate::Behind if root.t == 0.0 => format!("{t} is the origin itself"),
        Fate::Behind => format!("{t} lies behind the origin"),
        Fate::BelowEpsilon => format!("{t} is 0 within ε: the surface that the ray starts on"),
        Fate::BeyondNearest if chosen.is_some() => format!("{t} lies beyond it"),
        Fate::BeyondNearest => match (course.nearest, course.start) {
            (Some(nearest), _) => {
                format!(
                    "{t} is farther than the nearest hit so far, t = {}",
                    d.number(nearest)
                )
            }
            (None, Some(start)) if start.purpose == Purpose::Shadow => {
                format!("{t} lies beyond the light")
            }
            _ => format!("{t} is too far"),
        },
        Fate::BackFace => format!("{t} is on the back, and only the front is visible"),
        Fate::FrontFace => format!("{t} is on the front, and only the back is visible"),
        Fate::BeyondEnds => format!("{t} lies beyond the ends of the surface"),
    }
}
