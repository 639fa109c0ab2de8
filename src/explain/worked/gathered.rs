//! Light that is gathered around a point that a ray from the eye has hit.
//!
//! E = Σ power/area over the k − 1 nearest photons, and L = colour·diffuse/π·E.

use std::f64::consts::PI;

use glam::DVec3;

use crate::explain::number::Digits;
use crate::explain::number::count;
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::worked::context::Context;
use crate::explain::worked::extent::Extent;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::steps::Noted;
use crate::trace::{Gathered, Kind, Nearby};

/// How many of the nearest photons are shown, and how many of the farthest, unless all are asked for.
const SHOWN: [usize; 2] = [3, 2];

/// Light is gathered; of a filtered log either part may be missing.
pub(super) fn gather(
    context: &Context,
    nearest: &[Noted<Nearby>],
    gathered: Option<&Noted<Gathered>>,
    page: &mut Pen,
) {
    let nearest_shown = context.shows(Kind::Nearby) && !nearest.is_empty();
    let gathered = gathered.filter(|_| context.shows(Kind::Gathered));
    let first = nearest.first().filter(|_| nearest_shown);
    let Some(begins) = gathered
        .map(|all| all.extent)
        .or(first.map(|one| one.extent))
    else {
        return;
    };
    let on = gathered.map_or(String::new(), |gathered| {
        format!(" on {}", context.name(gathered.working.object))
    });
    page.telling(begins, |page| {
        page.headed(
            Part::Gathered,
            format!(" of the photons stored around p{on}"),
        );
        page.indented(|page| {
            if nearest_shown {
                nearby(context, nearest, page);
            }
            if let Some(gathered) = gathered {
                irradiance(context, nearest, &gathered.working, page);
            }
        });
    });
}

/// The nearest photons, from near to far; of many the first and the last.
fn nearby(context: &Context, nearest: &[Noted<Nearby>], page: &mut Pen) {
    let d = Digits::USUAL;
    let [first, last] = SHOWN;
    let left_out = match nearest.len().checked_sub(first + last) {
        Some(between) if !context.options.all && 1 < between => between,
        _ => 0,
    };
    let is_hidden = |number: usize| (first..first + left_out).contains(&number);
    for (number, noted) in nearest.iter().enumerate() {
        if 0 < left_out && number == first {
            let hidden = &nearest[first..first + left_out];
            let extent = Extent::around(hidden.iter().map(|photon| photon.extent));
            let text = format!("… {}", count(left_out, "more photon"));
            page.telling(extent, |page| page.folded(left_out, text));
        }
        if is_hidden(number) {
            continue;
        }
        let photon = &noted.working;
        let text = format!(
            "photon {} at {}, {} away: {} W, from path {} of light at its surface {}",
            number + 1,
            d.vector(photon.point),
            d.number(photon.distance),
            d.vector(photon.power),
            photon.path,
            photon.surface
        );
        page.telling(noted.extent, |page| page.plain(text));
    }
}

fn irradiance(context: &Context, nearest: &[Noted<Nearby>], gathered: &Gathered, page: &mut Pen) {
    let d = Digits::USUAL;
    if gathered.area == 0.0 {
        let text = ": no photon is stored here, so E = 0 and L = 0";
        return page.headed_line(Tone::Refused, Part::Irradiance, text);
    }
    let area = d.number(gathered.area);
    let counted = gathered.count as usize;
    let power = match gathered.radius {
        Some(radius) => {
            let disc = PI * radius * radius;
            let r = d.number(radius);
            let text = format!(
                ": a disc with r = {r}, the distance of the last of the {} photons; the disc ends at it, so the sum \
                 is over the other {counted}",
                counted + 1
            );
            page.headed(Part::Area, text);
            // the difference of a disc that reaches over an edge is more than rounding
            let is_whole = (disc - gathered.area).abs() <= 1e-9 * disc;
            let text = if is_whole {
                format!("area = π·r² = π·{r}² = {area}")
            } else {
                format!(
                    "area = {area}, the part on the surface of the disc, π·r² = π·{r}² = {}",
                    d.number(disc)
                )
            };
            page.part(Part::Area).plain(text);
            sum_of_powers(nearest.get(..counted), page)
                .unwrap_or(gathered.irradiance * gathered.area)
        }
        None => {
            let text = format!(
                " = {area}: p is in a cell of the surface's map, with {}",
                count(counted, "photon")
            );
            page.headed(Part::Area, text);
            gathered.irradiance * gathered.area
        }
    };
    let text = format!(
        ": E = Σ power/area = {}/{area} = {}",
        d.vector(power),
        d.vector(gathered.irradiance)
    );
    page.headed(Part::Irradiance, text);
    let material = context.scene.material_of(gathered.object);
    let text = format!(
        ": colour·diffuse/π·E = {}·{}/π·{} = {}",
        d.vector(material.colour.into()),
        d.number(material.diffuse),
        d.vector(gathered.irradiance),
        d.vector(gathered.radiance)
    );
    page.headed_line(Tone::Found, Part::Diffuse, text);
}

/// Σ power, counted channel by channel: a photon carries in each its whole share of the power or nothing.
fn sum_of_powers(photons: Option<&[Noted<Nearby>]>, page: &mut Pen) -> Option<DVec3> {
    let d = Digits::USUAL;
    let photons = photons?;
    let sum: DVec3 = photons.iter().map(|photon| photon.working.power).sum();
    let each = photons.iter().fold(0.0, |most, photon| {
        photon.working.power.max_element().max(most)
    });
    let in_channel = |channel: usize| {
        let carries = photons
            .iter()
            .filter(|photon| 0.0 < photon.working.power[channel]);
        carries.count() as f64
    };
    let counts = DVec3::from([0, 1, 2].map(in_channel));
    let is_counted = (counts * each - sum).abs().max_element() <= 1e-9 * sum.max_element();
    if is_counted && 0.0 < each {
        let text = format!(
            ": Σ power = {}·{} = {}, in W, with how many of the {} photons carry each channel",
            d.number(each),
            d.vector(counts),
            d.vector(sum),
            photons.len()
        );
        page.headed(Part::Irradiance, text);
    }
    Some(sum)
}
