//! The shade of a point, term by term.
//!
//! I = ambient·colour + Σ over visible lights of light·[colour·diffuse·max(0, N·L)
//! + specular·max(0, R·V)^shininess] + reflection·I_reflected + transmission·I_refracted

use glam::DVec3;

use crate::explain::number::Digits;
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::ray_start::to_light;
use crate::explain::worked::steps::Course;
use crate::geometry::{Refraction, reflect};
use crate::scene::{Emission, Material};
use crate::trace::{Item, Kind, LightTerm, Purpose, Shade, Visibility};

/// The diffuse and the specular term of one light.
pub(super) fn light(context: &Context, light: &LightTerm, course: &Course, page: &mut Pen) {
    if !context.shows(Kind::LightTerm) {
        return;
    }
    let d = Digits::USUAL;
    let term = &light.term;
    let (tone, verdict) = match light.visibility {
        Visibility::Visible => (Tone::Found, "visible"),
        Visibility::Shadowed => (Tone::Refused, "blocked, so the light adds nothing"),
        Visibility::FacesAway if term.distance == 0.0 => (
            Tone::Refused,
            "the light is at the point itself and adds nothing",
        ),
        Visibility::FacesAway => (
            Tone::Refused,
            "N·L ≤ 0, the surface faces away, so no shadow ray is cast and the light adds nothing",
        ),
        Visibility::NotTested => (Tone::Plain, "taken as visible, since no shadow ray is cast"),
    };
    let name = context.light_title(light.light);
    let text = format!(" of {name}: {verdict}");
    page.headed_line(tone, Part::Visibility, text);
    page.indented(|page| {
        let lamp = context.scene.lights.get(light.light as usize);
        if let (Some(lamp), Some(shade)) = (lamp, course.shade) {
            let text = to_light(lamp.position, shade.point);
            let product = d.dot(shade.normal, term.to_light);
            page.part(Part::ToLight)
                .plain(format!("L{text} = {}", d.vector(term.to_light)));
            page.part(Part::ToLight)
                .plain(format!("N·L = {product} = {}", d.number(term.n_dot_l)));
        }
        let adds = matches!(
            light.visibility,
            Visibility::Visible | Visibility::NotTested
        );
        let material = course
            .shade
            .map(|shade| *context.scene.material_of(shade.object));
        if let (true, Some(lamp), Some(material)) = (adds, lamp, material) {
            let colour = d.vector(material.colour.into());
            match lamp.emission {
                Emission::Colour(intensity) => {
                    let text = format!(
                        ": light·colour·diffuse·(N·L) = {}·{colour}·{}·{} = {}",
                        d.vector(intensity),
                        d.number(material.diffuse),
                        d.number(term.n_dot_l),
                        d.vector(term.diffuse)
                    );
                    page.headed(Part::Diffuse, text);
                    highlight(light, course, intensity, &material, page);
                }
                Emission::Power(power) => {
                    let r2 = term.distance * term.distance;
                    let irradiance = power * term.n_dot_l / (4.0 * std::f64::consts::PI * r2);
                    let text = format!(
                        ": E = Φ·(N·L)/(4π·r²) = {}·{}/(4π·{}²) = {}",
                        d.number(power),
                        d.number(term.n_dot_l),
                        d.number(term.distance),
                        d.number(irradiance)
                    );
                    page.headed(Part::Irradiance, text);
                    let text = format!(
                        ": colour·diffuse/π·E = {colour}·{}/π·{} = {}",
                        d.number(material.diffuse),
                        d.number(irradiance),
                        d.vector(term.diffuse)
                    );
                    page.headed(Part::Diffuse, text);
                    let text = ": none, a light with a power has no highlight";
                    page.headed(Part::Specular, text);
                }
            }
        }
    });
}

/// The specular term of a light.
fn highlight(
    light: &LightTerm,
    course: &Course,
    intensity: DVec3,
    material: &Material,
    page: &mut Pen,
) {
    let d = Digits::USUAL;
    let term = &light.term;
    if material.specular == 0.0 {
        page.headed(Part::Specular, ": none, the material's coefficient is 0");
        return;
    }
    if let (Some(start), Some(shade)) = (course.start, course.shade) {
        let mirrored = reflect(-term.to_light, shade.normal);
        let to_viewer = -start.ray.direction;
        let text = format!(
            ": R = 2(N·L)N − L = {}, V = −Δ = {}",
            d.vector(mirrored),
            d.vector(to_viewer)
        );
        page.headed(Part::Specular, text);
        let product = d.dot(mirrored, to_viewer);
        page.part(Part::Specular)
            .plain(format!("R·V = {product} = {}", d.number(term.r_dot_v)));
    }
    // max(0, R·V)^0 is 1, so a shininess of 0 has its highlight on the far side too
    if term.specular == DVec3::ZERO && term.r_dot_v <= 0.0 {
        let text = "R·V ≤ 0, so there is no highlight";
        page.part(Part::Specular).plain(text);
        return;
    }
    page.part(Part::Specular).plain(format!(
        "light·specular·max(0, R·V)^shininess = {}·{}·{}^{} = {}",
        d.vector(intensity),
        d.number(material.specular),
        d.number(term.r_dot_v.max(0.0)),
        d.number(material.shininess),
        d.vector(term.specular)
    ));
}

/// Snell's law.
pub(super) fn refraction(
    context: &Context,
    refraction: &Refraction,
    course: &Course,
    page: &mut Pen,
) {
    if !context.shows(Kind::Refraction) {
        return;
    }
    let d = Digits::USUAL;
    let (n1, n2) = (refraction.index_from, refraction.index_to);
    let eta = n1 / n2;
    let text = format!(
        ": n₁·sin θ₁ = n₂·sin θ₂ from index {} into index {} (outside all objects the index is 1)",
        d.number(n1),
        d.number(n2)
    );
    page.headed(Part::Snell, text);
    page.indented(|page| {
        // what is left of 1 near the critical angle has all its digits
        let d = Digits::for_difference(1.0, refraction.cos_refracted_squared);
        page.plain(format!(
            "cos θ₁ = −Δ·N = {}",
            d.number(refraction.cos_incident)
        ));
        let squared = format!(
            "cos²θ₂ = 1 − (n₁/n₂)²·(1 − cos²θ₁) = 1 − {}²·(1 − {}²) = {}",
            d.number(eta),
            d.factor(refraction.cos_incident),
            d.number(refraction.cos_refracted_squared)
        );
        match refraction.direction {
            Some(direction) => {
                let cosine = refraction.cos_refracted_squared.sqrt();
                page.plain(format!("{squared}, cos θ₂ = {}", d.number(cosine)));
                let parts = course.start.zip(course.normal).map(|(start, normal)| {
                    format!(
                        " = {}·{} + ({}·{} − {})·{}",
                        d.number(eta),
                        d.vector(start.ray.direction),
                        d.number(eta),
                        d.number(refraction.cos_incident),
                        d.number(cosine),
                        d.vector(normal)
                    )
                });
                let text = format!(
                    " = (n₁/n₂)·Δ + ((n₁/n₂)·cos θ₁ − cos θ₂)·N{} = {}",
                    parts.unwrap_or_default(),
                    d.vector(direction)
                );
                page.headed(Part::Transmitted, text);
                let of_radiance = course
                    .start
                    .is_some_and(|start| start.purpose != Purpose::Light);
                if of_radiance && context.settings.transport.follows_light() {
                    page.part(Part::Transmitted).plain(format!(
                        "the refracted radiance is multiplied by (n₁/n₂)² = {}² = {}, since the solid angle changes",
                        d.number(eta),
                        d.number(refraction.radiance_factor())
                    ));
                }
            }
            None => {
                let verdict =
                    "< 0: total internal reflection, the reflected ray gets the transmission too";
                page.line(Tone::Refused, format!("{squared} {verdict}"));
            }
        }
    });
}

/// What is known before the spawned rays return.
pub(super) fn shade(context: &Context, shade: &Shade, page: &mut Pen) {
    if !context.shows(Kind::Shade) {
        return;
    }
    let d = Digits::USUAL;
    let colour = DVec3::from(context.scene.material_of(shade.object).colour);
    if context.settings.transport.follows_light() {
        let text = ": none, the paths of light replace it";
        page.headed_line(Tone::Aside, Part::Ambient, text);
        let text = format!(" in all: {}", d.vector(shade.direct));
        return page.headed(Part::Gathered, text);
    }
    let text = format!(
        ": {}·{} = {}",
        d.vector(context.scene.ambient),
        d.vector(colour),
        d.vector(shade.ambient)
    );
    page.headed(Part::Ambient, text);
    let text = format!(": {}", d.vector(shade.direct));
    page.headed(Part::LightSum, text);
}

/// The terms of the sum that a ray returns: `(…) + (…) + 0.1·(…) = `.
pub(super) fn sum(context: &Context, course: &Course) -> Option<String> {
    let d = Digits::USUAL;
    let shade = course.shade?;
    let mut terms = vec![d.vector(shade.ambient), d.vector(shade.direct)];
    let mut words = vec!["ambient", "lights"];
    if context.settings.transport.follows_light() {
        terms = vec![d.vector(shade.direct)];
        words = vec!["gathered"];
    }
    for item in &context.tree.rays[course.place].items {
        let Item::Ray(child) = item else {
            continue;
        };
        let node = &context.tree.rays[*child];
        let (Some(start), Some(end)) = (node.start, node.end) else {
            continue;
        };
        let (weight, word) = match start.purpose {
            Purpose::Reflected => (shade.reflection, "reflection·I_reflected"),
            Purpose::Refracted => (shade.transmission, "transmission·I_refracted"),
            Purpose::Eye
            | Purpose::Shadow
            | Purpose::Scattered
            | Purpose::Light
            | Purpose::Connection => continue,
        };
        words.push(word);
        terms.push(format!("{}·{}", d.number(weight), d.vector(end.colour?)));
    }
    if terms.len() == 1 {
        return Some(format!("{} = ", words.join(" + ")));
    }
    Some(format!("{} = {} = ", words.join(" + "), terms.join(" + ")))
}
