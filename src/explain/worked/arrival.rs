//! The point that a ray hits: where it is, its normal, and ε of the rays that are spawned there.

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
        return hits(context, &photon, course, page);
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
    page.result(
        Tone::Found,
        Part::Point,
        format!(": the ray hits {name}{t}"),
    );
    page.indented(|page| {
        let (formula, numbers, d_point) = normal_formula(context, &shade);
        page.plain(format!("p = o + t·Δ = {}", d_point.vector(shade.point)));
        // N is on the ray's side: from the back it is the surface's own normal, negated
        let (sign, back) = if shade.back {
            ("−", " (the ray hits the back)")
        } else {
            ("", "")
        };
        let numbers = numbers.map_or(String::new(), |numbers| format!(" = {sign}{numbers}"));
        let text = format!(
            ": N = {sign}{formula}{numbers} = {}{back}",
            d.vector(shade.normal)
        );
        page.headed(Part::Normal, text);
        if let Some(text) = epsilon(context, course, &shade) {
            page.plain(text);
        }
        let object = context.scene.object_of(shade.object);
        let (material, values) = &context.scene.materials.0[object.material as usize];
        let text = format!(
            "material {}: colour {}, diffuse {}, specular {}, shininess {}, reflection {}, \
             transmission {}, index of refraction {}",
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

/// The point at which Russian roulette decides how a path continues.
fn hits(context: &Context, photon: &Photon, course: &Course, page: &mut Pen) {
    if !context.shows(Kind::Photon) {
        return;
    }
    let d = Digits::USUAL;
    let t = course.end.and_then(|end| end.t);
    let t = t.map_or(String::new(), |t| format!(" at t = {}", d.number(t)));
    let name = context.name(photon.object);
    page.gap();
    page.result(
        Tone::Found,
        Part::Point,
        format!(": the path hits {name}{t}"),
    );
    let normal = course.normal.map_or(String::new(), |normal| {
        format!(", N = {}", d.vector(normal))
    });
    let point = d.vector(photon.point);
    page.indented(|page| page.plain(format!("p = o + t·Δ = {point}{normal}")));
}

/// How the normal of a surface is found, the numbers put in, and the digits that p needs there.
fn normal_formula(context: &Context, shade: &Shade) -> (String, Option<String>, Digits) {
    let d = Digits::USUAL;
    let p = shade.point;
    let digits = |size: f64| Digits::for_difference(p.abs().max_element(), size);
    match &context.scene.primitive(shade.object).shape {
        Shape::Sphere(sphere) => {
            let d = digits(sphere.radius);
            let (p, center) = (d.vector(p), d.vector(sphere.center));
            let radius = d.number(sphere.radius);
            let numbers = format!("[{p} − {center}]/{radius}");
            ("(p − centre)/r".into(), Some(numbers), d)
        }
        Shape::Ellipsoid(ellipsoid) => {
            let d = digits(ellipsoid.radii.min_element());
            let (p, center) = (d.vector(p), d.vector(ellipsoid.center));
            let radii = d.vector(ellipsoid.radii);
            let numbers = format!("[{p} − {center}]/{radii}², normalised");
            ("(p − centre)/radii²".into(), Some(numbers), d)
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
            let face = format!("normal of the face where {name} is {}", d.number(place));
            (face, None, d)
        }
        Shape::Cone(cone) => {
            let [base, apex] = cone.radii();
            let formula = "(m⊥/|m⊥| − k·w), normalised, with m = p − base";
            (formula.into(), None, digits(base.max(apex)))
        }
        Shape::Polygon(polygon) => match polygon.normals() {
            None => ("(A, B, C)".into(), None, d),
            Some(normals) => {
                let projected = polygon.dropped().drop_from(p);
                let weights = mean_value_weights(polygon.outline(), projected);
                let term = |(&w, &n)| format!("{}·{}", d.number(w), d.vector(n));
                let terms: Vec<_> = weights.iter().zip(normals).map(term).collect();
                let numbers = format!("[{}], normalised", terms.join(" + "));
                ("Σ wᵢ·Nᵢ over the vertices".into(), Some(numbers), d)
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
        "1e-13·(largest coordinate or radius of the surface)".into()
    };
    let epsilon = d.number(epsilon);
    Some(format!(
        "ε of the rays spawned here = {formula} = {epsilon}"
    ))
}
