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
        Visibility::Shadowed => (Tone::Refused, "in shadow, adds nothing"),
        Visibility::FacesAway if term.distance == 0.0 => {
            (Tone::Refused, "stands in the point itself, adds nothing")
        }
        Visibility::FacesAway => (
            Tone::Refused,
            "N·L ≤ 0, the surface faces away: no shadow ray, adds nothing",
        ),
        Visibility::NotTested => (Tone::Plain, "taken as visible: no ray is cast to it"),
    };
    let name = context.light_name(light.light);
    page.part(Part::Visibility)
        .line(tone, format!("Light {name}: {verdict}"));
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
                    page.part(Part::Diffuse).plain(format!(
                        "diffuse: light·colour·diffuse·(N·L) = {}·{colour}·{}·{} = {}",
                        d.vector(intensity),
                        d.number(material.diffuse),
                        d.number(term.n_dot_l),
                        d.vector(term.diffuse)
                    ));
                    highlight(light, course, intensity, &material, page);
                }
                Emission::Power(power) => {
                    let r2 = term.distance * term.distance;
                    let irradiance = power * term.n_dot_l / (4.0 * std::f64::consts::PI * r2);
                    page.part(Part::Irradiance).plain(format!(
                        "irradiance: E = Φ·(N·L)/(4π·r²) = {}·{}/(4π·{}²) = {}",
                        d.number(power),
                        d.number(term.n_dot_l),
                        d.number(term.distance),
                        d.number(irradiance)
                    ));
                    page.part(Part::Diffuse).plain(format!(
                        "reflected: colour·diffuse/π·E = {colour}·{}/π·{} = {}",
                        d.number(material.diffuse),
                        d.number(irradiance),
                        d.vector(term.diffuse)
                    ));
                    page.part(Part::Specular)
                        .plain("specular: none, a light with a power has no highlight");
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
        page.part(Part::Specular)
            .plain("specular: none, the material's coefficient is 0");
        return;
    }
    if let (Some(start), Some(shade)) = (course.start, course.shade) {
        let mirrored = reflect(-term.to_light, shade.normal);
        let to_viewer = -start.ray.direction;
        page.part(Part::Specular).plain(format!(
            "R = 2(N·L)N - L = {}, V = -Δ = {}",
            d.vector(mirrored),
            d.vector(to_viewer)
        ));
        let product = d.dot(mirrored, to_viewer);
        page.part(Part::Specular)
            .plain(format!("R·V = {product} = {}", d.number(term.r_dot_v)));
    }
    // max(0, R·V)^0 is 1, so a shininess of 0 has its highlight on the far side too
    if term.specular == DVec3::ZERO && term.r_dot_v <= 0.0 {
        page.part(Part::Specular)
            .plain("specular: none, R·V is not above 0");
        return;
    }
    page.part(Part::Specular).plain(format!(
        "specular: light·specular·max(0, R·V)^shininess = {}·{}·{}^{} = {}",
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
    page.plain(format!(
        "Refraction from index {} into {} (outside of an object it is 1)",
        d.number(n1),
        d.number(n2)
    ));
    page.indented(|page| {
        page.plain("n₁·sin θ₁ = n₂·sin θ₂ (Snell)");
        // what is left of 1 near the critical angle is told with all its digits
        let d = Digits::for_difference(1.0, refraction.cos_refracted_squared);
        page.plain(format!(
            "cos θ₁ = -Δ·N = {}",
            d.number(refraction.cos_incident)
        ));
        let squared = format!(
            "cos²θ₂ = 1 - (n₁/n₂)²·(1 - cos²θ₁) = 1 - {}²·(1 - {}²) = {}",
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
                        " = {}·{} + ({}·{} - {})·{}",
                        d.number(eta),
                        d.vector(start.ray.direction),
                        d.number(eta),
                        d.number(refraction.cos_incident),
                        d.number(cosine),
                        d.vector(normal)
                    )
                });
                page.part(Part::Transmitted).plain(format!(
                    "T = (n₁/n₂)·Δ + ((n₁/n₂)·cos θ₁ - cos θ₂)·N{} = {}",
                    parts.unwrap_or_default(),
                    d.vector(direction)
                ));
                let of_radiance = course
                    .start
                    .is_some_and(|start| start.purpose != Purpose::Light);
                if of_radiance && context.settings.transport.follows_light() {
                    page.plain(format!(
                        "what is seen through the surface counts (n₁/n₂)² = {}² = {} times: behind it the same \
                         light fills another solid angle",
                        d.number(eta),
                        d.number(refraction.radiance_factor())
                    ));
                }
            }
            None => {
                let verdict =
                    "< 0: total internal reflection, the transmission goes to the reflected ray";
                page.line(Tone::Refused, format!("{squared} {verdict}"));
            }
        }
        });
}

/// What is known before the rays sent on come back.
pub(super) fn shade(context: &Context, shade: &Shade, page: &mut Pen) {
    if !context.shows(Kind::Shade) {
        return;
    }
    let d = Digits::USUAL;
    let colour = DVec3::from(context.scene.material_of(shade.object).colour);
    if context.settings.transport.follows_light() {
        let text = "Ambient: none, for the light that it stands for was followed";
        page.part(Part::Ambient).line(Tone::Aside, text);
        let text = format!("Light gathered: {}", d.vector(shade.direct));
        return page.part(Part::LightSum).plain(text);
    }
    page.part(Part::Ambient).plain(format!(
        "Ambient: {}·{} = {}",
        d.vector(context.scene.ambient),
        d.vector(colour),
        d.vector(shade.ambient)
    ));
    page.part(Part::LightSum).plain(format!(
        "Sum over the visible lights: {}",
        d.vector(shade.direct)
    ));
}

/// The terms of the sum that a ray brings back: `(…) + (…) + 0.1·(…) = `.
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
