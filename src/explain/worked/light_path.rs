//! The paths of light that led to a pixel: each in a few lines, or in full.

use std::ops::Range;

use crate::explain::number::count;
use crate::explain::number::{Digits, grouped};
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::extent::Extent;
use crate::explain::worked::joined::joined;
use crate::explain::worked::known_path::KnownPath;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::photon::{Carries, channels};
use crate::explain::worked::{connection, ray, seen, vertex};
use crate::scene::Emission;
use crate::trace::{Connection, Event, Item, Kind, PhotonVerdict, RayNode, RayVerdict, Record};

/// The number of paths that are written; the others are counted, unless all are asked for: more would hide the pixel.
const TOLD: usize = 8;

/// The kinds of event that a path in brief has words for.
const IN_BRIEF: [Kind; 6] = [
    Kind::Path,
    Kind::Photon,
    Kind::Stored,
    Kind::Arrival,
    Kind::Alternative,
    Kind::Connection,
];

/// The paths of light, one after the other; `places` are those of their records among all.
pub(super) fn light_paths(context: &Context, places: Range<usize>, page: &mut Pen) {
    let all = context.options.all;
    let is_told = |record: &Record| {
        let kind = record.event.kind();
        context.shows(kind) && (all || IN_BRIEF.contains(&kind))
    };
    let of_paths = context.section(places.clone());
    let mut start = places.start;
    let mut paths: Vec<Range<usize>> = Vec::new();
    for path in of_paths.records.chunk_by(|a, b| a.path == b.path) {
        let end = start + path.len();
        if path.iter().any(is_told) {
            paths.push(start..end);
        }
        start = end;
    }
    let shown = if all {
        paths.len()
    } else {
        TOLD.min(paths.len())
    };
    let (shown, hidden) = paths.split_at(shown);
    for path in shown {
        light_path(&context.section(path.clone()), page);
    }
    if let (Some(first), Some(last)) = (hidden.first(), hidden.last()) {
        page.gap();
        let paths = count(hidden.len(), "more path");
        let text = format!("… {paths} of light led to the pixel");
        let extent = Extent::at(first.start).to(Extent::at(last.end - 1));
        page.telling(extent, |page| page.folded(hidden.len(), text));
    }
}

/// One path of light.
fn light_path(context: &Context, page: &mut Pen) {
    let Some(number) = context.records.first().and_then(|record| record.path) else {
        return;
    };
    let unknown = KnownPath::default();
    let known = context.paths.get(&number).unwrap_or(&unknown);
    page.gap();
    if page.writes(context.at(0)) {
        page.line(Tone::Heading, path_title(context, number, known));
    }
    page.indented(|page| {
        let mut surface = 0;
        let mut rest = context.tree.items.as_slice();
        while let Some((first, after)) = rest.split_first() {
            if let Some((joined, length)) = joined(context, rest) {
                match joined.connection {
                    Some(line) if !context.options.all && line.pixel != context.pixel => {
                        let items = rest[..length].iter();
                        let extent = Extent::around(items.map(|item| context.of_item(item)));
                        page.telling(extent, |page| line_elsewhere(context, &line, page));
                    }
                    _ => connection::connect(context, &joined, &[], page),
                }
                rest = &rest[length..];
                continue;
            }
            rest = after;
            let Item::Ray(place) = *first else {
                continue;
            };
            surface += 1;
            if context.options.all {
                page.gap();
                ray::ray(context, place, page);
            } else {
                leg(context, place, surface, known, page);
            }
        }
    });
}

/// `Path 17 of light: from light "lamp", carries 150/768 = 0.195313 W in each channel`
fn path_title(context: &Context, number: u32, known: &KnownPath) -> String {
    let d = Digits::USUAL;
    let Some(start) = known.start.filter(|_| context.shows(Kind::Path)) else {
        return format!("Path {number} of light");
    };
    let lights = &context.scene.lights;
    let power: f64 = lights
        .iter()
        .map(|light| match light.emission {
            Emission::Power(power) => power,
            Emission::Colour(_) => 0.0,
        })
        .sum();
    let of = if lights.len() == 1 {
        "of the light"
    } else {
        "of all lights"
    };
    format!(
        "Path {number} of light: from {}, carries {} W in each channel ({} W {of}, shared by {} paths)",
        context.light_title(start.light),
        d.number(start.power.x),
        d.number(power),
        grouped(u64::from(start.paths))
    )
}

/// One leg of a path in a line, and what of it arrived at the eye: all of it is one step.
fn leg(context: &Context, place: usize, surface: u32, known: &KnownPath, page: &mut Pen) {
    let ray = &context.tree.rays[place];
    page.of_ray(ray.id, |page| {
        page.telling(context.of_ray(place), |page| {
            if context.shows(Kind::Photon) || context.shows(Kind::RayEnd) {
                let from = match vertex::leg_before(context, place) {
                    Some((_, photon)) => context.name(photon.object),
                    None => known
                        .start
                        .map_or("a light".into(), |start| context.light_title(start.light)),
                };
                let to = end_of_leg(context, ray, surface, known);
                page.headed(Part::Leg, format!(" {surface}: {from} → {to}"));
            }
            for item in &ray.items {
                if let Item::Event(at) = *item
                    && let Event::Arrival(arrival) = context.records[at].event
                {
                    page.indented(|page| {
                        page.of_part(Part::Arrival, |page| seen::seen(context, &arrival, page));
                    });
                }
            }
        });
    });
}

/// Where a leg ends, and what becomes of the photon there.
fn end_of_leg(context: &Context, ray: &RayNode, surface: u32, known: &KnownPath) -> String {
    let d = Digits::USUAL;
    let t = ray.end.and_then(|end| end.t);
    let at = t.map_or(String::new(), |t| format!(" at t = {}", d.number(t)));
    let Some(photon) = vertex::photon_of(context, ray) else {
        let carried = known.carried_after(surface - 1);
        let carried = carried.map_or(String::new(), |power| {
            format!(" with {}", Carries::Power.amount(power))
        });
        return match ray.end.map(|end| (end.verdict, end.object)) {
            Some((RayVerdict::CutOff, Some(object))) => format!(
                "{}{at}: beyond the most surfaces of a path, cut off{carried}",
                context.name(object)
            ),
            Some((RayVerdict::Miss, _)) => format!("out of the scene{carried}"),
            _ => format!("?{at}"),
        };
    };
    let chance = d.number(photon.chance);
    let limit = photon.reflection + photon.transmission;
    let becomes = match photon.verdict {
        PhotonVerdict::Mirrored => {
            format!("mirrored (ξ = {chance} < {})", d.number(photon.reflection))
        }
        PhotonVerdict::Refracted => format!(
            "refracted (ξ = {chance} in {}..{})",
            d.number(photon.reflection),
            d.number(limit)
        ),
        PhotonVerdict::Diffused => format!("scattered (ξ = {chance}: {})", channels(&photon)),
        PhotonVerdict::Absorbed => format!("absorbed (ξ = {chance})"),
    };
    let is_stored = |item: &Item| match *item {
        Item::Event(at) => matches!(context.records[at].event, Event::Stored(_)),
        Item::Ray(_) => false,
    };
    let stored = match ray.items.iter().any(is_stored) {
        false => "",
        true if known.gathered.contains(&surface) => "stored and gathered by the pixel; ",
        true => "stored; ",
    };
    format!("{}{at}: {stored}{becomes}", context.name(photon.object))
}

/// A line to the eye through another pixel.
fn line_elsewhere(context: &Context, line: &Connection, page: &mut Pen) {
    if !context.shows(Kind::Connection) {
        return;
    }
    let from = vertex::light_vertex(context, line.path, usize::from(line.light_vertex));
    let end = match line.pixel {
        Some([x, y]) if line.visible => format!("goes through another pixel, ({x}, {y})"),
        _ => "is blocked".into(),
    };
    let text = format!(": none, the line from {} to the eye {end}", from.name);
    page.headed_line(Tone::Aside, Part::Contribution, text);
}
