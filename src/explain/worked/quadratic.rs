//! Sphere, ellipsoid and cone: the quadratic with its numbers, and its roots, each with its verdict.

use glam::DVec3;

use crate::explain::number::Digits;
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::worked::aligned;
use crate::explain::worked::context::Context;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::roots::{choice, roots};
use crate::explain::worked::steps::Course;
use crate::geometry::{QuadraticTest, Ray, Roots};
use crate::scene::{PrimitiveId, Shape};

/// An object whose test is a quadratic, and what its working is written from.
#[derive(Clone, Copy)]
pub(super) struct Tested<'a> {
    pub(super) context: &'a Context<'a>,
    pub(super) object: PrimitiveId,
    pub(super) test: &'a QuadraticTest,
    pub(super) course: &'a Course,
    /// With all its lines, or the equation alone.
    pub(super) full: bool,
}

impl<'a> Tested<'a> {
    fn shape(&self) -> &'a Shape {
        &self.context.scene.primitive(self.object).shape
    }

    /// What the object is, the working, and the verdict on each root; in short where the working is not asked for, or the
    /// log does not have the ray.
    fn told(&self, what: &str, page: &mut Pen, working: impl FnOnce(&Ray, &mut Pen)) {
        object_line(self.context, self.object, what, page);
        page.indented(|page| match self.course.ray() {
            Some(ray) if self.full => {
                working(&ray, page);
                choice(&self.test.roots, self.course, page);
            }
            _ => self.in_short(page),
        });
    }

    /// The equation with its numbers, and the verdict.
    fn in_short(&self, page: &mut Pen) {
        let test = self.test;
        let (b2, ac4) = (test.b * test.b, 4.0 * test.a * test.c);
        let size = b2.abs().max(ac4.abs());
        let d = Digits::for_difference(size, test.discriminant);
        let discriminant = format!(
            " of {} {} {} = 0: b² − 4ac = {} {} = {}",
            d.times(test.a, "t²"),
            d.term_times(test.b, "t"),
            d.term(test.c),
            d.number(b2),
            d.term(-ac4),
            d.difference(size, test.discriminant)
        );
        let why = match test.roots {
            Roots::None if test.discriminant < 0.0 => " < 0, no real root: missed",
            Roots::None => ": no t solves it, missed",
            _ => {
                page.headed(Part::Discriminant, discriminant);
                return choice(&test.roots, self.course, page);
            }
        };
        let text = format!("{discriminant}{why}");
        page.headed_line(Tone::Refused, Part::Discriminant, text);
    }
}

/// Equation (iii).
pub(super) fn sphere(of: Tested, page: &mut Pen) {
    let (test, course) = (of.test, of.course);
    let Shape::Sphere(sphere) = of.shape() else {
        return;
    };
    let (center, radius) = (course.place(sphere.center), sphere.radius);
    let d = Digits::USUAL;
    let what = format!(
        "sphere, centre {}, radius {}",
        d.vector(center),
        d.number(radius)
    );
    of.told(&what, page, |ray, page| {
        let offset = ray.origin - center;
        let given = precise(test, offset).vector(offset);
        page.headed(Part::Frame, format!(": o − centre = {given}"));
        coefficients(&Ray::new(offset, ray.direction), radius, test, page);
        roots(test, page);
        match course.aligned {
            Some(_) => aligned::sphere_at_axis(center, radius, page),
            None => page.once(Part::Discriminant, COMPUTED_FOR_SPHERE),
        }
    });
}

/// Equation (iii) for the unit sphere that the ellipsoid is in a space of its own.
pub(super) fn ellipsoid(of: Tested, page: &mut Pen) {
    let (test, course) = (of.test, of.course);
    let Shape::Ellipsoid(ellipsoid) = of.shape() else {
        return;
    };
    let ellipsoid = *ellipsoid;
    let (center, radii) = (course.place(ellipsoid.center), ellipsoid.radii);
    let d = Digits::USUAL;
    let what = format!(
        "ellipsoid, centre {}, radii {}",
        d.vector(center),
        d.vector(radii)
    );
    of.told(&what, page, |ray, page| {
        let (scaled, offset_by, direction_by) = match course.aligned {
            // its half axes h are turned
            Some(aligned) => (
                ellipsoid.unit_ray(&aligned),
                "hᵢ·(o − centre)/rᵢ²",
                "hᵢ·Δ/rᵢ²",
            ),
            None => (
                Ray::new((ray.origin - center) / radii, ray.direction / radii),
                "(o − centre)/radii",
                "Δ/radii",
            ),
        };
        let d = precise(test, scaled.origin);
        let along = course.aligned.map_or("", |_| " along its half axes h");
        page.headed(
            Part::Frame,
            format!(": space divided by the radii{along}: there the ellipsoid is the unit sphere, and t is the same"),
        );
        page.part(Part::Frame).plain(format!(
            "o − centre → {offset_by} = {}",
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
    });
}

/// The quadratic of an open cone or cylinder.
pub(super) fn cone(of: Tested, page: &mut Pen) {
    let (test, course) = (of.test, of.course);
    let Shape::Cone(cone) = of.shape() else {
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
    of.told(&what, page, |ray, page| {
        let (axis, slope) = (cone.axis(), cone.slope());
        let m = ray.origin - cone.base();
        let (height, climb) = (m.dot(axis), ray.direction.dot(axis));
        let across = m - height * axis;
        let direction = ray.direction - climb * axis;
        let radius = base_radius + slope * height;
        let d = precise(test, across);
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
    });
}

/// How the program computes the numbers of a sphere, and of the unit sphere that an ellipsoid is in its frame.
const COMPUTED_FOR_SPHERE: &str = "the program computes the same with less rounding: b² − 4ac as \
    4(a·r² − |Δ × (o − centre)|²), and the root nearer to 0 as c/(a·t) of the other";

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
        "b = 2·Δ·(o − centre) = 2·[{}] = {}",
        d.dot(direction, offset),
        d.number(test.b)
    ));
    page.part(Part::Coefficients).plain(format!(
        "c = |o − centre|² − r² = {} − {}² = {}",
        d.squares(offset),
        d.number(radius),
        d.difference(offset.length_squared(), test.c)
    ));
}

/// The name of an object and what it is.
pub(super) fn object_line(context: &Context, object: PrimitiveId, what: &str, page: &mut Pen) {
    let name = context.name(object);
    page.line(Tone::Heading, format!("{name}: {what}"));
}

/// Digits for a, b and c: c is a difference too, that of |o − centre|² and r².
fn precise(test: &QuadraticTest, offset: DVec3) -> Digits {
    let (b2, ac4) = (test.b * test.b, 4.0 * test.a * test.c);
    let for_c = Digits::for_difference(offset.length_squared(), test.c);
    Digits::for_difference(b2.abs().max(ac4.abs()), test.discriminant).or(for_c)
}
