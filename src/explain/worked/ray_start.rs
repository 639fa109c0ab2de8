//! Where a ray starts and which way it goes.

use glam::DVec3;

use crate::explain::number::Digits;
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::photon;
use crate::explain::worked::steps::{Step, steps};
use crate::trace::{Purpose, RayStart};

/// Equation (i) with the ray's numbers, and where they come from.
pub(super) fn ray_start(
    context: &Context,
    place: usize,
    start: &RayStart,
    parent: Option<u32>,
    page: &mut Pen,
) {
    let d = Digits::USUAL;
    let (origin, direction) = (start.ray.origin, start.ray.direction);
    let on_path = photon::direction_of_leg(context, place);
    let mut head = |text: String| page.headed(Part::Direction, format!(": {text}"));
    match start.purpose {
        _ if let Some(text) = on_path => head(text),
        Purpose::Eye => {
            if let Some(window) = start.window_t {
                // a length near 1 has the digits in which it differs from 1
                let length = Digits::for_difference(window, window - 1.0).number(window);
                let to_window = d.vector(window * direction);
                head(format!("P − COP = {to_window}, of length {length}"));
                page.plain(format!(
                    "Δ = (P − COP)/{length} = {}: normalised, so t is a distance and the window is at t = {length}",
                    d.vector(direction)
                ));
            }
        }
        Purpose::Shadow => {
            let lights = &context.scene.lights;
            let lamp = start.light.and_then(|light| lights.get(light as usize));
            let text = lamp.map_or(String::new(), |lamp| to_light(lamp.position, origin));
            head(format!("Δ = L{text} = {}", d.vector(direction)));
        }
        Purpose::Reflected => {
            let from = parent.and_then(|parent| surface_of(context, parent));
            match from {
                Some((incoming, normal)) => {
                    let cosine = incoming.dot(normal);
                    head(format!(
                        "Δ = Δ′ − 2(Δ′·N)N = {} − 2·{}·{} = {}, with Δ′ the direction of the incoming ray",
                        d.vector(incoming),
                        d.factor(cosine),
                        d.vector(normal),
                        d.vector(direction)
                    ));
                }
                None => head(format!("Δ = {}", d.vector(direction))),
            }
        }
        Purpose::Refracted => head(format!("Δ = T = {}", d.vector(direction))),
        Purpose::Light => head(format!(
            "Δ = {}: a random direction, pdf 1/(4π) per steradian",
            d.vector(direction)
        )),
        Purpose::Scattered => head(format!("Δ = {}", d.vector(direction))),
        Purpose::Connection => {
            head(format!("Δ = (x − x′)/|x − x′| = {}", d.vector(direction)));
        }
    }
    let text = format!(
        ": (x, y, z) = {} + t·{} … (i){}",
        d.vector(origin),
        d.vector(direction),
        range_text(start)
    );
    page.headed(Part::Ray, text);
}

/// Direction and normal where a ray hit its surface.
fn surface_of(context: &Context, ray: u32) -> Option<(DVec3, DVec3)> {
    let node = &context.tree.rays[context.tree.find(ray)?];
    let shade = steps(context, &node.items)
        .into_iter()
        .find_map(|told| match told.step {
            Step::Shade(shade) => Some(shade),
            _ => None,
        })?;
    Some((node.start?.ray.direction, shade.normal))
}

/// L = (light − p)/|light − p|, with its numbers.
pub(super) fn to_light(light: DVec3, point: DVec3) -> String {
    let distance = (light - point).length();
    let d = Digits::for_difference(light.abs().max_element(), distance);
    format!(
        " = (light − p)/|light − p| = [{} − {}]/{}",
        d.vector(light),
        d.vector(point),
        d.number(distance)
    )
}

/// Which t count, in words.
fn range_text(start: &RayStart) -> String {
    let d = Digits::USUAL;
    let low = if start.range.min == 0.0 {
        "t > 0".into()
    } else {
        format!("t ≥ ε = {}", d.number(start.range.min))
    };
    if start.range.max.is_finite() {
        let end = match start.purpose {
            Purpose::Shadow => ", just short of the light",
            Purpose::Connection => ", just short of x",
            _ => "",
        };
        format!(", for {low} up to {}{end}", d.number(start.range.max))
    } else {
        format!(", for {low}")
    }
}
