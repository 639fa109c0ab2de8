//! The point that a ray meets: where it is, its normal, and ε for what is sent on from it.

use crate::explain::number::Digits;
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::printable;
use crate::explain::worked::context::Context;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::steps::Course;
use crate::geometry::{Axis, mean_value_weights};
use crate::scene::Shape;
use crate::trace::{Item, Kind, Photon, Shade};

/// The point that the ray hits, before the first ray that is spawned there.
pub(super) fn arrive(context: &Context, course: &mut Course, page: &mut Pen) {
    if std::mem::replace(&mut course.arrived, true) {
        return;
    }
    if let Some(photon) = course.photon {
        return meets(context, &photon, course, page);
    }
    let (Some(end), Some(shade)) = (course.end, course.shade) else {
        return;
    };
    if !context.shows(Kind::Shade) {
        return;
    }
    let d = Digits::USUAL;
    let name = context.name(shade.object);
    let t = end
        .t
        .map_or(String::new(), |t| format!(" at t = {}", d.number(t)));
    page.gap();
    page.line(Tone::Found, format!("→ The ray meets {name}{t}"));
    page.indented(|page| {
        let (formula, numbers, d_point) = normal_formula(context, &shade);
        page.plain(format!("p = o + t·Δ = {}", d_point.vector(shade.point)));
        // N is on the ray's side: from the back it is the surface's own normal turned round
        let (sign, back) = if shade.back {
            ("-", " (the ray meets the back)")
        } else {
            ("", "")
        };
        let numbers = numbers.map_or(String::new(), |numbers| format!(" = {sign}{numbers}"));
        page.part(Part::Normal).plain(format!(
            "N = {sign}{formula}{numbers} = {}{back}",
            d.vector(shade.normal)
        ));
        if let Some(text) = epsilon(context, course, &shade) {
            page.plain(text);
        }
        let object = context.scene.object_of(shade.object);
        let (material, values) = &context.scene.materials.0[object.material as usize];
        let text = format!(
            "material {}: colour {}, diffuse {}, specular {}, shininess {}, reflection {}, \
             transmission {}, index {}",
            printable(material),
            d.vector(values.colour.into()),
            d.number(values.diffuse),
            d.number(values.specular),
            d.number(values.shininess),
            d.number(values.reflection),
            d.number(values.transmission),
            d.number(values.index)
        );
        page.line(Tone::Aside, text);
    });
}

/// The point at which chance decides how a path goes on.
fn meets(context: &Context, photon: &Photon, course: &Course, page: &mut Pen) {
    if !context.shows(Kind::Photon) {
        return;
    }
    let d = Digits::USUAL;
    let t = course.end.and_then(|end| end.t);
    let t = t.map_or(String::new(), |t| format!(" at t = {}", d.number(t)));
    let name = context.name(photon.object);
    page.gap();
    page.line(Tone::Found, format!("→ The path meets {name}{t}"));
    let normal = course.normal.map_or(String::new(), |normal| {
        format!(", N = {}", d.vector(normal))
    });
    let point = d.vector(photon.point);
    page.indented(|page| page.plain(format!("p = o + t·Δ = {point}{normal}")));
}

/// How the normal of a surface is found, the numbers put in, and the digits that p needs there.
fn normal_formula(context: &Context, shade: &Shade) -> (&'static str, Option<String>, Digits) {
    let d = Digits::USUAL;
    let p = shade.point;
    let digits = |size: f64| Digits::for_difference(p.abs().max_element(), size);
    match &context.scene.primitive(shade.object).shape {
        Shape::Sphere(sphere) => {
            let d = digits(sphere.radius);
            let (p, center) = (d.vector(p), d.vector(sphere.center));
            let radius = d.number(sphere.radius);
            let numbers = format!("[{p} - {center}]/{radius}");
            ("(p - center)/r", Some(numbers), d)
        }
        Shape::Ellipsoid(ellipsoid) => {
            let d = digits(ellipsoid.radii.min_element());
            let (p, center) = (d.vector(p), d.vector(ellipsoid.center));
            let radii = d.vector(ellipsoid.radii);
            let numbers = format!("[{p} - {center}]/{radii}², normalised");
            ("(p - center)/radii²", Some(numbers), d)
        }
        Shape::Box(solid) => {
            let normal = solid.normal(p);
            let axis = Axis::of_largest(normal);
            let name = match axis {
                Axis::X => "x",
                Axis::Y => "y",
                Axis::Z => "z",
            };
            let low = axis.of(normal) < 0.0;
            let place = axis.of(if low { solid.min } else { solid.max });
            let face = format!("that of the face at {name} = {}", d.number(place));
            ("normal of the box", Some(face), d)
        }
        Shape::Cone(cone) => {
            let [base, apex] = cone.radii();
            let formula = "(m⊥/|m⊥| - k·w), normalised, with m = p - base";
            (formula, None, digits(base.max(apex)))
        }
        Shape::Polygon(polygon) => match polygon.normals() {
            None => ("(A, B, C)", None, d),
            Some(normals) => {
                let projected = polygon.dropped().drop_from(p);
                let weights = mean_value_weights(polygon.outline(), projected);
                let term = |(&w, &n)| format!("{}·{}", d.number(w), d.vector(n));
                let terms: Vec<_> = weights.iter().zip(normals).map(term).collect();
                let numbers = format!("[{}], normalised", terms.join(" + "));
                ("Σ wᵢ·Nᵢ over the vertices", Some(numbers), d)
            }
        },
    }
}

/// ε of the rays that are spawned here, if there are any.
fn epsilon(context: &Context, course: &Course, shade: &Shade) -> Option<String> {
    let d = Digits::USUAL;
    let items = &context.tree.rays[course.place].items;
    let first = items.iter().find_map(|item| match item {
        Item::Ray(child) => context.tree.rays[*child].start,
        Item::Event(_) => None,
    })?;
    let epsilon = first.range.min;
    let numbers = shade.point.abs().max_element().max(course.end?.t?);
    // of the two that ε is the larger of, the one that it is
    let formula = if epsilon <= 1.000_001e-9 * numbers {
        format!("1e-9·max(|x|, |y|, |z|, t) = 1e-9·{}", d.number(numbers))
    } else {
        "1e-13 of the surface's largest coordinate or radius".into()
    };
    let epsilon = d.number(epsilon);
    Some(format!(
        "ε of the rays sent on from here = {formula} = {epsilon}"
    ))
}
