//! The pixel: where its rays pass the window, the rays, and the colour that they make.

use glam::DVec3;

use crate::explain::number::{Digits, grouped};
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::count;
use crate::explain::worked::extent::Extent;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::{connection, ray, seen, vertex};
use crate::trace::{Event, Item, Kind, Photon, PixelColour, PixelSample, Through, Transport};

/// So many terms of a sum are written out, unless all are wanted: a line has room for no more.
const TERMS: usize = 12;

/// What the parts of a pixel have brought, while it is told.
#[derive(Debug, Default)]
struct Brought {
    /// What each eye ray brings back.
    rays: Vec<DVec3>,
    /// What the lines of each path from the eye add, times W·H.
    paths: Vec<DVec3>,
    /// The surfaces that the path from the eye has met.
    eye: Vec<Photon>,
}

/// All that belongs to the pixel itself.
pub(super) fn pixel(context: &Context, page: &mut Pen) {
    let mut brought = Brought::default();
    let mut rest = context.tree.items.as_slice();
    while let Some((first, after)) = rest.split_first() {
        if let Some((joined, length)) = connection::joined(context, rest) {
            connection::connect(context, &joined, &brought.eye, page);
            if let (Some(line), Some(sum)) = (joined.connection, brought.paths.last_mut()) {
                *sum += context.all_pixels() * line.contribution;
            }
            rest = &rest[length..];
            continue;
        }
        rest = after;
        match *first {
            Item::Ray(place) => {
                page.gap();
                ray::ray(context, place, page);
                let ray = &context.tree.rays[place];
                brought.rays.extend(ray.end.and_then(|end| end.colour));
                brought.eye.extend(vertex::photon_of(context, ray));
            }
            Item::Event(at) => match context.records[at].event {
                Event::Pixel(sample) => {
                    brought.eye.clear();
                    brought.paths.push(DVec3::ZERO);
                    page.telling(context.at(at), |page| {
                        page.of_part(Part::WindowPoint, |page| {
                            window_point(context, &sample, page);
                        });
                    });
                }
                Event::PixelColour(colour) => page.telling(context.at(at), |page| {
                    page.of_part(Part::PixelColour, |page| {
                        pixel_colour(context, &colour, &brought, page);
                    });
                }),
                _ => {}
            },
        }
    }
}

/// One ray alone; one that connects with all that its line comes to. Its events are those of the page.
pub(super) fn one_ray(context: &Context, id: u32, page: &mut Pen) -> Option<Extent> {
    let wanted = context.tree.find(id)?;
    let items = &context.tree.items;
    let mut eye = Vec::new();
    for (at, item) in items.iter().enumerate() {
        match *item {
            Item::Ray(place) if place == wanted => {
                if let Some((joined, length)) = connection::joined(context, &items[at..]) {
                    connection::connect(context, &joined, &eye, page);
                    let items = &items[at..at + length];
                    return Extent::around(items.iter().map(|item| context.of_item(item)));
                }
            }
            Item::Ray(place) => eye.extend(vertex::photon_of(context, &context.tree.rays[place])),
            Item::Event(at) => {
                if let Event::Pixel(_) = context.records[at].event {
                    eye.clear();
                }
            }
        }
    }
    page.gap();
    ray::ray(context, wanted, page);
    Some(context.of_ray(wanted))
}

/// P = corner + (x/width)·right + (1 − y/height)·up
fn window_point(context: &Context, sample: &PixelSample, page: &mut Pen) {
    if !context.shows(Kind::Pixel) {
        return;
    }
    let d = Digits::USUAL;
    let camera = &context.scene.camera;
    let [width, height] = camera.pixels;
    page.gap();
    let number = format!("{} of {}", sample.sample + 1, sample.samples);
    let place = match (context.settings.transport, context.settings.through) {
        (Transport::Forward, _) => {
            "The pixel's centre on the window: no ray is sent from it, photons come to the pixel"
                .into()
        }
        (Transport::HybridConnected, _) => {
            format!("Path {number} from the eye: a place of chance in the pixel")
        }
        (_, Through::Centres) => "The pixel's centre on the window".into(),
        (_, Through::Corners) => format!("Corner {number} on the window"),
    };
    page.line(Tone::Heading, place);
    let (across, down) = (
        sample.place.x / f64::from(width),
        1.0 - sample.place.y / f64::from(height),
    );
    // an eye far from the origin: as many digits as P - COP needs
    let to_window = (sample.point - camera.cop).length();
    let d_point = Digits::for_difference(sample.point.abs().max_element(), to_window);
    let lines = [
        format!(
            "{} pixels from the left and {} from the top, of {width} × {height}",
            d.number(sample.place.x),
            d.number(sample.place.y)
        ),
        format!(
            "P = corner + {}/{width}·right + (1 - {}/{height})·up",
            d.number(sample.place.x),
            d.number(sample.place.y)
        ),
        format!(
            "  = {} + {}·{} + {}·{}",
            d_point.vector(camera.corner()),
            d.number(across),
            d.vector(camera.right),
            d.number(down),
            d.vector(camera.up)
        ),
        format!("  = {}", d_point.vector(sample.point)),
    ];
    page.indented(|page| {
        for line in lines {
            page.plain(line);
        }
    });
}

fn pixel_colour(context: &Context, colour: &PixelColour, brought: &Brought, page: &mut Pen) {
    if !context.shows(Kind::PixelColour) {
        return;
    }
    let d = Digits::USUAL;
    page.gap();
    page.line(Tone::Heading, "The pixel's colour");
    let mut lines = match context.settings.transport {
        Transport::Forward => sum_of_arrivals(context, colour.raw),
        Transport::HybridConnected => sum_of_lines(context, colour.raw, &brought.paths),
        Transport::Backward | Transport::HybridLight | Transport::HybridStored => {
            vec![of_eye_rays(colour.raw, &brought.rays)]
        }
    };
    if colour.raw != colour.clamped {
        lines.push(format!("cut to 0..1: {}", d.vector(colour.clamped)));
    }
    let [r, g, b] = colour.rgb();
    lines.push(format!("in the picture, times 255: ({r}, {g}, {b})"));
    page.indented(|page| {
        for line in lines {
            page.plain(line);
        }
    });
}

/// What photons have brought to the pixel.
fn sum_of_arrivals(context: &Context, raw: DVec3) -> Vec<String> {
    let paths = grouped(context.settings.light.paths);
    let arrivals = seen::arrivals_here(context);
    let light = &context.settings.light;
    if raw == DVec3::ZERO && arrivals.is_empty() {
        let pinhole = light.aperture_radius(&context.scene.camera) == 0.0;
        let why = if pinhole {
            ": the eye's aperture is a point, which no photon ever meets"
        } else {
            ""
        };
        let text = format!("none of {paths} photons has come through this pixel into the eye{why}");
        return vec![text, "nothing arrives: (0, 0, 0)".into()];
    }
    let radiances: Vec<DVec3> = arrivals.iter().map(|&(_, radiance)| radiance).collect();
    let what = format!(
        "what {} of {paths} brought",
        count(arrivals.len(), "photon")
    );
    vec![written_sum(context, &what, &radiances, raw)]
}

/// What the lines have brought: those of the pixel's own paths, and those of paths of light to the eye.
fn sum_of_lines(context: &Context, raw: DVec3, paths: &[DVec3]) -> Vec<String> {
    let lines: Vec<DVec3> = context
        .paths
        .values()
        .flat_map(|known| &known.lines)
        .filter(|line| line.visible && line.pixel == context.pixel)
        .map(|line| line.contribution)
        .collect();
    let own: DVec3 = paths.iter().sum();
    let seen: DVec3 = lines.iter().sum();
    let mut told = vec![written_sum(
        context,
        &format!("what the lines of {} bring", count(paths.len(), "eye path")),
        paths,
        own,
    )];
    if lines.is_empty() {
        told.push("no line from a path of light to the eye comes through this pixel".into());
    } else {
        let what = format!(
            "what {} from paths of light to the eye brings",
            count(lines.len(), "line")
        );
        told.push(written_sum(context, &what, &lines, seen));
    }
    let d = Digits::USUAL;
    told.push(format!(
        "together: {} + {} = {}",
        d.vector(own),
        d.vector(seen),
        d.vector(raw)
    ));
    told
}

/// A sum with its terms, if there are not too many, and they are there: a filtered log may hold only some.
fn written_sum(context: &Context, what: &str, terms: &[DVec3], sum: DVec3) -> String {
    let d = Digits::USUAL;
    let found: DVec3 = terms.iter().sum();
    // the terms were added in another order
    let is_sum = (found - sum).abs().max_element() <= 1e-9 * sum.abs().max_element();
    let most = if context.options.all {
        usize::MAX
    } else {
        TERMS
    };
    if !is_sum || terms.len() < 2 || most < terms.len() {
        return format!("{what}: {}", d.vector(sum));
    }
    let texts: Vec<_> = terms.iter().map(|&term| d.vector(term)).collect();
    format!("{what}: {} = {}", texts.join(" + "), d.vector(sum))
}

/// What the eye rays have brought back.
fn of_eye_rays(raw: DVec3, of_rays: &[DVec3]) -> String {
    let d = Digits::USUAL;
    if of_rays.len() < 2 {
        return format!("what the eye ray brings back: {}", d.vector(raw));
    }
    let terms: Vec<_> = of_rays.iter().map(|&c| d.vector(c)).collect();
    format!(
        "the mean of its {} eye rays: [{}] / {} = {}",
        of_rays.len(),
        terms.join(" + "),
        of_rays.len(),
        d.vector(raw)
    )
}
