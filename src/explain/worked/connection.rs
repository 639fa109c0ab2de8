//! A line that connects a path of light with a path from the eye, worked out.
//!
//! L = Φ·ρ/π · G·V · ρ'/π·β · w,  G = cos θ·cos θ'/d²

use glam::DVec3;

use crate::explain::number::Digits;
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::extent::Extent;
use crate::explain::worked::joined::Joined;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::seen::ALL_AROUND;
use crate::explain::worked::vertex::{Vertex, VertexPlace};
use crate::explain::worked::{ray, seen, vertex, weight};
use crate::trace::{Connection, Kind, Photon};

/// The working of a line; `eye` is what the path from the eye has hit.
pub(super) fn connect(context: &Context, joined: &Joined, eye: &[Photon], page: &mut Pen) {
    page.gap();
    let Some(line) = joined.connection.filter(|_| shows_lines(context)) else {
        if let Some(ray) = joined.ray {
            ray::ray(context, ray, page);
        }
        return;
    };
    let ends = [
        vertex::light_vertex(context, line.path, usize::from(line.light_vertex)),
        vertex::eye_vertex(context, eye, usize::from(line.eye_vertex)),
    ];
    let ray_at = joined.ray.map(|ray| context.of_ray(ray));
    let parts = [ray_at, joined.alternatives_at, joined.connection_at];
    let whole = Extent::around(parts.into_iter().flatten());
    if whole.is_none_or(|whole| page.writes(Extent::at(whole.first))) {
        let title = connection_title(&line, &ends);
        page.line(Tone::Heading, title);
    }
    page.indented(|page| {
        if let Some(ray) = joined.ray {
            ray::ray(context, ray, page);
        }
        if context.shows(Kind::Connection) {
            page.telling(joined.connection_at, |page| {
                page.of_part(Part::GeometryTerm, |page| {
                    geometry_term(context, &line, &ends, page);
                });
            });
        }
        if line.visible {
            if context.shows(Kind::Alternative) {
                page.telling(joined.alternatives_at, |page| {
                    page.of_part(Part::Weight, |page| {
                        weight::weight(context, joined, &line, eye, page);
                    });
                });
            }
            if context.shows(Kind::Connection) {
                page.telling(joined.connection_at, |page| {
                    page.of_part(Part::Contribution, |page| {
                        contribution(context, &line, &ends, page);
                    });
                });
            }
        } else if context.shows(Kind::Connection) {
            let text = ": none, V = 0 since an object is in between";
            page.telling(joined.connection_at, |page| {
                page.result(Tone::Refused, Part::Contribution, text);
            });
        }
    });
}

fn shows_lines(context: &Context) -> bool {
    context.shows(Kind::Connection) || context.shows(Kind::Alternative)
}

/// G = cos θ·cos θ'/d², from the vector between the two vertices on.
fn geometry_term(context: &Context, line: &Connection, ends: &[Vertex; 2], page: &mut Pen) {
    let d = Digits::USUAL;
    let vector = line.to - line.from;
    let squared = vector.length_squared();
    let length = squared.sqrt();
    let size = line.from.abs().max(line.to.abs()).max_element();
    let d_point = Digits::for_difference(size, length);
    let text = ": how much of the light that leaves x arrives at x′";
    page.headed(Part::GeometryTerm, text);
    page.indented(|page| {
        page.plain(format!(
            "x = {}{}, x′ = {}{}",
            d_point.vector(line.from),
            ends[0].beside(),
            d_point.vector(line.to),
            ends[1].beside()
        ));
        page.plain(format!(
            "x′ − x = {} − {} = {}",
            d_point.vector(line.to),
            d_point.vector(line.from),
            d.vector(vector)
        ));
        page.plain(format!(
            "d² = |x′ − x|² = {} = {}, d = {}",
            d.squares(vector),
            d.number(squared),
            d.number(length)
        ));
        for (end, name, line_from) in [(0, "θ", vector), (1, "θ′", -vector)] {
            let cosine = line.cosines[end];
            let text = cosine_text(context, &ends[end], name, line_from, cosine);
            page.plain(text);
        }
        page.line(
            Tone::Found,
            format!(
                "G = cos θ·cos θ′/d² = {}·{}/{} = {}",
                d.number(line.cosines[0]),
                d.number(line.cosines[1]),
                d.number(squared),
                d.number(line.geometry())
            ),
        );
    });
}

/// The cosine at one end, between the line away from it and the surface's normal.
fn cosine_text(context: &Context, end: &Vertex, name: &str, away: DVec3, cosine: f64) -> String {
    let d = Digits::USUAL;
    let prime = if name == "θ" { "" } else { "′" };
    let value = d.number(cosine);
    match &end.place {
        VertexPlace::Light(_) => {
            format!("cos {name} = 1: a point light emits the same in all directions")
        }
        VertexPlace::Eye => {
            format!("cos {name} = 1: the eye is a point and has no normal")
        }
        VertexPlace::Unknown => format!("cos {name} = {value}"),
        VertexPlace::Surface(photon) => {
            let normal = vertex::normal_towards(context, photon, away);
            let vector = if prime.is_empty() {
                "x′ − x"
            } else {
                "x − x′"
            };
            format!(
                "cos {name} = N{prime}·({vector})/d = [{}]/{} = {value}, with N{prime} = {}",
                d.dot(normal, away),
                d.number(away.length()),
                d.vector(normal)
            )
        }
    }
}

/// L: the product of all factors, and what it adds to the pixel.
fn contribution(context: &Context, line: &Connection, ends: &[Vertex; 2], page: &mut Pen) {
    let d = Digits::USUAL;
    page.headed(Part::Contribution, ": what the line adds to the pixel");
    page.indented(|page| {
        let sent = match &ends[0].place {
            VertexPlace::Light(power) => {
                let sent = *power * ALL_AROUND;
                page.plain(format!(
                    "sent: Φ/(4π) = {}/(4π) = {}, with Φ the power of this path in W",
                    d.vector(*power),
                    d.vector(sent)
                ));
                Some(sent)
            }
            VertexPlace::Surface(photon) => {
                let sent = photon.power * photon.diffuse / std::f64::consts::PI;
                page.plain(format!(
                    "sent: Φ·ρ/π = {}·{}/π = {}, with Φ the power in W that arrives at x and ρ = colour·diffuse",
                    d.vector(photon.power),
                    d.vector(photon.diffuse),
                    d.vector(sent)
                ));
                Some(sent)
            }
            VertexPlace::Eye | VertexPlace::Unknown => None,
        };
        let direction = (line.from - line.to).normalize_or_zero();
        let received = match &ends[1].place {
            VertexPlace::Surface(photon) => {
                let received = photon.diffuse / std::f64::consts::PI * photon.power;
                page.plain(format!(
                    "received: ρ′/π·β = {}/π·{} = {}, with β the weight of the path from the eye at x′",
                    d.vector(photon.diffuse),
                    d.vector(photon.power),
                    d.vector(received)
                ));
                Some(d.vector(received))
            }
            VertexPlace::Eye => {
                let area = context.scene.camera.pixel_area();
                let (way, cosine) = seen::way_to_window(context, direction);
                let text = seen::by_solid_angle(context, direction, area);
                page.plain(format!(
                    "received: d²/(A·cos θ) = {text}, with A the area of the pixel, d and θ those of the line at \
                     the window"
                ));
                Some(d.number(way * way / (area * cosine)))
            }
            VertexPlace::Light(_) | VertexPlace::Unknown => None,
        };
        let brings = d.vector(line.contribution);
        let product = sent.zip(received).map(|(sent, received)| {
            format!(
                " = {}·{}·1·{received}·{}",
                d.vector(sent),
                d.number(line.geometry()),
                d.number(line.weight)
            )
        });
        page.line(
            Tone::Found,
            format!(
                "L = sent·G·V·received·w{} = {brings}",
                product.unwrap_or_default()
            ),
        );
        if line.eye_vertex != 0 {
            let all = context.all_pixels();
            let samples = f64::from(context.settings.light.samples);
            // whole numbers, with all their digits
            let paths = samples * all;
            page.plain(format!(
                "{paths} paths of light share the power of the lights, and this pixel has {samples} of them, so the \
                 factor is W·H = {paths}/{samples} = {all}"
            ));
            page.plain(format!(
                "→ the line adds {all}·{brings} = {}",
                d.vector(all * line.contribution)
            ));
        }
    });
}

fn connection_title(line: &Connection, ends: &[Vertex; 2]) -> String {
    let eye = match line.eye_vertex {
        0 => "the eye".into(),
        number => format!(
            "{} (vertex {number} of the path from the eye)",
            ends[1].name
        ),
    };
    let pixel = line.pixel.map_or(String::new(), |[x, y]| {
        format!(", through pixel ({x}, {y})")
    });
    format!(
        "Connection of {} (vertex {} of path {} of light) with {eye}{pixel}",
        ends[0].name, line.light_vertex, line.path
    )
}
