//! Light that is gathered around a point that a ray from the eye has met.
//!
//! E = Σ power/area over the k − 1 nearest photons, and L = colour·diffuse/π·E.

use std::f64::consts::PI;

use glam::DVec3;

use crate::explain::number::Digits;
use crate::explain::page::Tone;
use crate::explain::worked::{Solution, count};
use crate::trace::{Gathered, Kind, Nearby};

/// So many of the nearest photons are told, and so many of the farthest, unless all are wanted.
const TOLD: [usize; 2] = [3, 2];

impl Solution<'_> {
    /// Light is gathered; of a filtered log either part may be missing.
    pub(super) fn gather(&mut self, nearby: &[Nearby], gathered: Option<&Gathered>) {
        let shows_nearby = self.shows(Kind::Nearby) && !nearby.is_empty();
        let gathered = gathered.filter(|_| self.shows(Kind::Gathered));
        if !shows_nearby && gathered.is_none() {
            return;
        }
        let on = gathered.map_or(String::new(), |gathered| {
            format!(" on {}", self.name(gathered.object))
        });
        self.page
            .plain(format!("Light that is stored around p{on}"));
        self.page.indent();
        if shows_nearby {
            self.nearby(nearby);
        }
        if let Some(gathered) = gathered {
            self.irradiance(nearby, gathered);
        }
        self.page.outdent();
    }

    /// The nearest photons, from near to far; of many the first and the last.
    fn nearby(&mut self, nearby: &[Nearby]) {
        let d = Digits::USUAL;
        let [first, last] = TOLD;
        let left_out = match nearby.len().checked_sub(first + last) {
            Some(between) if !self.options.all && 1 < between => between,
            _ => 0,
        };
        for (number, photon) in nearby.iter().enumerate() {
            if 0 < left_out && number == first {
                let more = count(left_out, "more photon");
                let text = format!("… {more} (--all tells them)");
                self.page.line(Tone::Aside, text);
            }
            if (first..first + left_out).contains(&number) {
                continue;
            }
            self.page.plain(format!(
                "photon {} at {}, {} away: {} W, from path {} of light at its surface {}",
                number + 1,
                d.vector(photon.point),
                d.number(photon.distance),
                d.vector(photon.power),
                photon.path,
                photon.surface
            ));
        }
    }

    fn irradiance(&mut self, nearby: &[Nearby], gathered: &Gathered) {
        let d = Digits::USUAL;
        if gathered.area == 0.0 {
            let text = "no light is stored here: E = 0 and L = 0";
            return self.page.line(Tone::Refused, text);
        }
        let area = d.number(gathered.area);
        let counted = gathered.count as usize;
        let power = match gathered.radius {
            Some(radius) => {
                let disc = PI * radius * radius;
                let r = d.number(radius);
                self.page.plain(format!(
                    "r = {r}, to the last of the {}: the disc is so large because it is there, so that it counts \
                     for nothing and the sum goes over {counted}",
                    counted + 1
                ));
                // of a disc that reaches over an edge the difference is more than rounding
                let is_whole = (disc - gathered.area).abs() <= 1e-9 * disc;
                let text = if is_whole {
                    format!("area = π·r² = π·{r}² = {area}")
                } else {
                    format!(
                        "area = {area}: what of the disc, π·r² = π·{r}² = {}, lies on the surface",
                        d.number(disc)
                    )
                };
                self.page.plain(text);
                self.sum_of_powers(nearby.get(..counted))
                    .unwrap_or(gathered.irradiance * gathered.area)
            }
            None => {
                self.page.plain(format!(
                    "p lies in a cell of the surface's map, with {}; area = {area}",
                    count(counted, "photon")
                ));
                gathered.irradiance * gathered.area
            }
        };
        self.page.plain(format!(
            "E = Σ power/area = {}/{area} = {}",
            d.vector(power),
            d.vector(gathered.irradiance)
        ));
        let material = self.scene.material_of(gathered.object);
        self.page.line(
            Tone::Found,
            format!(
                "L = colour·diffuse/π·E = {}·{}/π·{} = {}",
                d.vector(material.colour.into()),
                d.number(material.diffuse),
                d.vector(gathered.irradiance),
                d.vector(gathered.radiance)
            ),
        );
    }

    /// Σ power, counted channel by channel: a photon carries in each its whole share of the power or nothing.
    fn sum_of_powers(&mut self, photons: Option<&[Nearby]>) -> Option<DVec3> {
        let d = Digits::USUAL;
        let photons = photons?;
        let sum: DVec3 = photons.iter().map(|photon| photon.power).sum();
        let each = photons
            .iter()
            .fold(0.0, |most, photon| photon.power.max_element().max(most));
        let in_channel = |channel: usize| {
            let carries = photons.iter().filter(|photon| 0.0 < photon.power[channel]);
            carries.count() as f64
        };
        let counts = DVec3::from([0, 1, 2].map(in_channel));
        let is_counted = (counts * each - sum).abs().max_element() <= 1e-9 * sum.max_element();
        if is_counted && 0.0 < each {
            self.page.plain(format!(
                "Σ power = {}·{} = {}, in watts: so many of the {} photons carry each channel",
                d.number(each),
                d.vector(counts),
                d.vector(sum),
                photons.len()
            ));
        }
        Some(sum)
    }
}
