//! A photon passes the window into the eye.
//!
//! L = power/(G·π·R²·A),  G = cos²θ/d²

use std::f64::consts::PI;

use glam::DVec3;

use crate::explain::number::Digits;
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::pen::Pen;
use crate::trace::{Arrival, Kind};

/// A photon arrives: in full at the pixel of the page, or if all is asked for.
pub(super) fn seen(context: &Context, arrival: &Arrival, page: &mut Pen) {
    if !context.shows(Kind::Arrival) {
        return;
    }
    let d = Digits::USUAL;
    let [x, y] = arrival.pixel;
    let is_here = context.pixel == Some(arrival.pixel);
    if !is_here && !context.options.all {
        let text = format!(": through the window into the eye at another pixel, ({x}, {y})");
        return page.result(Tone::Aside, Part::Arrival, text);
    }
    let camera = &context.scene.camera;
    let radius = context.settings.light.aperture_radius(camera);
    let line = arrival.window - arrival.aperture;
    let squared = line.length_squared();
    // across both planes, on the side of the window
    let normal = camera.window_normal();
    let normal = normal * normal.dot(line).signum();
    let cosine = normal.dot(line) / squared.sqrt();
    let size = arrival.aperture.abs().max_element();
    let d_point = Digits::for_difference(size, line.length());
    let beside = (arrival.aperture - camera.cop).length();
    let area = camera.pixel_area();
    let lines = [
        format!(
            "through the window at {} and the aperture at {}, {} from the COP; the aperture has R = {}",
            d_point.vector(arrival.window),
            d_point.vector(arrival.aperture),
            d.number(beside),
            d.number(radius)
        ),
        format!(
            "d² = |window − aperture|² = {} = {}",
            d.squares(line),
            d.number(squared)
        ),
        format!(
            "cos θ = N·(window − aperture)/d = [{}]/{} = {}, with N = {} of both planes",
            d.dot(normal, line),
            d.number(squared.sqrt()),
            d.number(cosine),
            d.vector(normal)
        ),
        format!(
            "G = cos²θ/d² = {}²/{} = {}",
            d.number(cosine),
            d.number(squared),
            d.number(arrival.geometry)
        ),
        format!(
            "L = power/(G·π·R²·A) = {}/({}·π·{}²·{}) = {}, with A the area of a pixel on the window",
            d.vector(arrival.power),
            d.number(arrival.geometry),
            d.number(radius),
            d.number(area),
            d.vector(arrival.radiance)
        ),
    ];
    let text = format!(": through the window into the eye at pixel ({x}, {y})");
    page.result(Tone::Found, Part::Arrival, text);
    page.indented(|page| {
        for line in lines {
            page.plain(line);
        }
    });
}

/// What has arrived at the pixel of the page, path by path.
pub(super) fn arrivals_here(context: &Context) -> Vec<(u32, DVec3)> {
    let here = |arrival: &&Arrival| Some(arrival.pixel) == context.pixel;
    context
        .paths
        .iter()
        .flat_map(|(&path, known)| {
            let seen = known.arrivals.iter().filter(here);
            seen.map(move |arrival| (path, arrival.radiance))
        })
        .collect()
}

/// How far the window's plane is from the eye along a unit direction, and the cosine between the two normals.
pub(super) fn way_to_window(context: &Context, direction: DVec3) -> (f64, f64) {
    let camera = &context.scene.camera;
    let across = camera.window_normal();
    let cosine = direction.dot(across).abs();
    (camera.to_corner.dot(across).abs() / cosine, cosine)
}

/// The pdf of a direction from the eye: d²/(area·cos θ).
pub(super) fn by_solid_angle(context: &Context, direction: DVec3, area: f64) -> String {
    let d = Digits::USUAL;
    let (way, cosine) = way_to_window(context, direction);
    let value = way * way / (area * cosine);
    format!(
        "{}²/({}·{}) = {}",
        d.number(way),
        d.number(area),
        d.number(cosine),
        d.number(value)
    )
}

/// 1/(4π): the same in every direction.
pub(super) const ALL_AROUND: f64 = 1.0 / (4.0 * PI);
