//! The pixel: where its rays pass the window, the rays, and the colour of the pixel.

use glam::DVec3;

use crate::explain::number::count;
use crate::explain::number::{Digits, grouped};
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::extent::Extent;
use crate::explain::worked::joined::joined;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::{connection, ray, seen, vertex};
use crate::trace::{Event, Item, Kind, Photon, PixelColour, PixelSample, Through, Transport};

/// The number of terms of a sum that are written out, unless all are asked for: a line has room for no more.
const TERMS: usize = 12;

/// What the rays and lines of a pixel have brought so far.
#[derive(Debug, Default)]
struct Brought {
    /// The colour that each eye ray returns.
    rays: Vec<DVec3>,
    /// What the lines of each path from the eye add, times W·H.
    paths: Vec<DVec3>,
    /// The photons at the surfaces of the path from the eye.
    eye: Vec<Photon>,
}

/// All that belongs to the pixel itself.
pub(super) fn pixel(context: &Context, page: &mut Pen) {
    let mut brought = Brought::default();
    let mut rest = context.tree.items.as_slice();
    while let Some((first, after)) = rest.split_first() {
        if let Some((joined, length)) = joined(context, rest) {
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

/// One ray alone, or a connecting ray with its whole connection. Returns the events of the page.
pub(super) fn one_ray(context: &Context, id: u32, page: &mut Pen) -> Option<Extent> {
    let wanted = context.tree.find(id)?;
    let items = &context.tree.items;
    let mut eye = Vec::new();
    for (at, item) in items.iter().enumerate() {
        match *item {
            Item::Ray(place) if place == wanted => {
                if let Some((joined, length)) = joined(context, &items[at..]) {
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
            ": the pixel's centre; no ray is cast through it, photons arrive at the pixel".into()
        }
        (Transport::HybridConnected, _) => {
            format!(" of path {number} from the eye: a random point in the pixel")
        }
        (_, Through::Centres) => ": the pixel's centre".into(),
        (_, Through::Corners) => format!(": corner {number} of the pixel"),
    };
    page.titled(Part::WindowPoint, place);
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
            "P = corner + {}/{width}·right + (1 − {}/{height})·up",
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
    page.titled(Part::PixelColour, "");
    let mut lines = match context.settings.transport {
        Transport::Forward => sum_of_arrivals(context, colour.raw),
        Transport::HybridConnected => sum_of_lines(context, colour.raw, &brought.paths),
        Transport::Backward | Transport::HybridLight | Transport::HybridStored => {
            vec![of_eye_rays(colour.raw, &brought.rays)]
        }
    };
    if colour.raw != colour.clamped {
        lines.push(format!("clamped to 0..1: {}", d.vector(colour.clamped)));
    }
    let [r, g, b] = colour.rgb();
    lines.push(format!("times 255, in the picture: ({r}, {g}, {b})"));
    page.indented(|page| {
        for line in lines {
            page.plain(line);
        }
    });
}

/// The radiance that photons bring to the pixel.
fn sum_of_arrivals(context: &Context, raw: DVec3) -> Vec<String> {
    let paths = grouped(context.settings.light.paths);
    let arrivals = seen::arrivals_here(context);
    let light = &context.settings.light;
    if raw == DVec3::ZERO && arrivals.is_empty() {
        let pinhole = light.aperture_radius(&context.scene.camera) == 0.0;
        let why = if pinhole {
            ": the eye's aperture is a point, which no photon ever hits"
        } else {
            ""
        };
        let text = format!("none of {paths} photons passes this pixel into the eye{why}");
        return vec![text, "nothing arrives: (0, 0, 0)".into()];
    }
    let radiances: Vec<DVec3> = arrivals.iter().map(|&(_, radiance)| radiance).collect();
    let what = format!("from {} of {paths}", count(arrivals.len(), "photon"));
    vec![written_sum(context, &what, &radiances, raw)]
}

/// The radiance of the lines: those of the pixel's own paths, and those of paths of light to the eye.
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
        &format!("from the lines of {}", count(paths.len(), "eye path")),
        paths,
        own,
    )];
    if lines.is_empty() {
        told.push("no line from a path of light to the eye passes this pixel".into());
    } else {
        let what = format!(
            "from {} of paths of light to the eye",
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

/// The colour that the eye rays return.
fn of_eye_rays(raw: DVec3, of_rays: &[DVec3]) -> String {
    let d = Digits::USUAL;
    if of_rays.len() < 2 {
        return format!("from the eye ray: {}", d.vector(raw));
    }
    let terms: Vec<_> = of_rays.iter().map(|&c| d.vector(c)).collect();
    format!(
        "the mean of {} eye rays: [{}] / {} = {}",
        of_rays.len(),
        terms.join(" + "),
        of_rays.len(),
        d.vector(raw)
    )
}
