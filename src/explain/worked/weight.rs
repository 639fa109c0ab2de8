//! The weight of a connection by the balance heuristic: which edges of the whole path could have been the line, and how
//! likely each of them was.
//!
//! w = share/Σ shares,  share = 1/(G·φ·φ')

use std::f64::consts::PI;

use glam::DVec3;

use crate::explain::number::Digits;
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::joined::Joined;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::seen::ALL_AROUND;
use crate::explain::worked::vertex::{Vertex, VertexPlace};
use crate::explain::worked::{seen, vertex};
use crate::trace::{Connection, Photon};

/// w, from the shares of all edges.
pub(super) fn weight(
    context: &Context,
    joined: &Joined,
    line: &Connection,
    eye: &[Photon],
    page: &mut Pen,
) {
    if joined.alternatives.is_empty() {
        return;
    }
    let d = Digits::USUAL;
    let light_vertex = usize::from(line.light_vertex);
    let eye_vertex = usize::from(line.eye_vertex);
    let of_light =
        (0..=light_vertex).map(|number| vertex::light_vertex(context, line.path, number));
    let of_eye = (0..=eye_vertex).rev();
    let of_eye = of_eye.map(|number| vertex::eye_vertex(context, eye, number));
    let vertices: Vec<Vertex> = of_light.chain(of_eye).collect();

    let text = " by the balance heuristic: each edge of the whole path could have been the line";
    page.headed(Part::Weight, text);
    page.indented(|page| {
        let names: Vec<_> = (0..)
            .zip(&vertices)
            .map(|(number, vertex)| format!("{number} {}", vertex.name))
            .collect();
        page.plain(format!("the path: {}", names.join(" – ")));
        densities(context, joined, line, &vertices, page);

        let mut barred = Vec::new();
        for edge in 1..vertices.len() {
            let [from, to] = [edge - 1, edge];
            let found = joined.alternatives.iter().find(|a| a.edge as usize == edge);
            let Some(alternative) = found else {
                barred.push(format!("{from}–{to}"));
                continue;
            };
            let [a, b] = alternative.densities;
            let (tone, is_line) = if alternative.chosen {
                (Tone::Found, ", the line")
            } else {
                (Tone::Plain, "")
            };
            let text = format!(
                "edge {from}–{to}{is_line}: G = {geometry}, share = 1/(G·{}·{}) = 1/({geometry}·{}·{}) = {}",
                phi(from),
                phi(to),
                d.number(a),
                d.number(b),
                d.number(alternative.share),
                geometry = d.number(alternative.geometry),
            );
            page.line(tone, text);
        }

        if !barred.is_empty() {
            let text = format!(
                "never the line: {}, since a mirror or glass at an end reflects or refracts in one direction only",
                barred.join(", ")
            );
            page.line(Tone::Aside, text);
        }
        let w = d.number(line.weight);
        let text = match joined.alternatives.as_slice() {
            [_] => format!("w = {w}: no other edge could have been the line"),
            edges => {
                let shares: Vec<_> = edges.iter().map(|edge| d.number(edge.share)).collect();
                let own = edges.iter().find(|edge| edge.chosen);
                let own = own.map_or("?".into(), |edge| d.number(edge.share));
                format!("w = share/Σ shares = {own}/({}) = {w}", shares.join(" + "))
            }
        };
        page.line(Tone::Found, text);
    });
}

/// φ of each vertex at which an edge ends that could have been the line.
fn densities(
    context: &Context,
    joined: &Joined,
    line: &Connection,
    vertices: &[Vertex],
    page: &mut Pen,
) {
    let d = Digits::USUAL;
    for (number, vertex) in vertices.iter().enumerate() {
        let ends_here = joined.alternatives.iter().find_map(|edge| {
            let at = edge.edge as usize;
            let [from, to] = edge.densities;
            match number {
                _ if number + 1 == at => Some(from),
                _ if number == at => Some(to),
                _ => None,
            }
        });
        let Some(density) = ends_here else { continue };
        let phi = phi(number);
        let text = match &vertex.place {
            VertexPlace::Light(_) => format!(
                "{phi} = 1/(4π) = {}, the pdf per steradian of a direction from the light",
                d.number(ALL_AROUND)
            ),
            VertexPlace::Surface(photon) => {
                let most = photon.diffuse.max_element();
                format!(
                    "{phi} = ρ/π = {}/π = {}, with the largest ρ of the channels: the probability to continue",
                    d.number(most),
                    d.number(most / PI)
                )
            }
            VertexPlace::Eye => {
                let before = number.checked_sub(1).map(|before| &vertices[before]);
                eye_density(context, &phi, before, line)
                    .unwrap_or_else(|| format!("{phi} = {}", d.number(density)))
            }
            VertexPlace::Unknown => format!("{phi} = {}", d.number(density)),
        };
        page.plain(text);
    }
}

/// φ at the eye, whose paths are uniform on the window.
fn eye_density(
    context: &Context,
    phi: &str,
    before: Option<&Vertex>,
    line: &Connection,
) -> Option<String> {
    let point = match before?.photon() {
        Some(photon) => photon.point,
        None => line.from,
    };
    let camera = &context.scene.camera;
    let direction: DVec3 = (point - camera.cop).try_normalize()?;
    let [width, height] = camera.pixels.map(f64::from);
    let area = camera.pixel_area() * width * height;
    Some(format!(
        "{phi} = d²/(A·cos θ) = {}, with A the area of the window, d and θ those of the path at the window",
        seen::by_solid_angle(context, direction, area)
    ))
}

/// φ with the number of its vertex below: `φ₁₂`.
fn phi(number: usize) -> String {
    let digits = number.to_string();
    let below = digits.bytes().filter_map(|digit| {
        // the ten digits stand in a row from ₀ on
        char::from_u32('₀' as u32 + u32::from(digit - b'0'))
    });
    std::iter::once('φ').chain(below).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vertices_are_numbered_below_the_line() {
        assert_eq!(phi(0), "φ₀");
        assert_eq!(phi(12), "φ₁₂");
    }
}
