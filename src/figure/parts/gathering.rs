//! What was gathered at a point: the photons around it, and the density that follows from them.

use std::f64::consts::PI;

use glam::DVec3;

use crate::figure::parts::disc;
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::text::{Text, formula};
use crate::figure::traced::Section;
use crate::scene::Scene;
use crate::trace::{Event, Gathered, Nearby};

/// A point at which light was gathered.
#[derive(Clone, Debug)]
pub(in crate::figure) struct Gathering<'a> {
    /// The nearest photons with the steps at which they were found, the nearest first; the last does not count.
    pub(in crate::figure) nearby: Vec<(u32, &'a Nearby)>,
    pub(in crate::figure) gathered: &'a Gathered,
    /// The step at which it was.
    pub(in crate::figure) step: u32,
}

impl<'a> Gathering<'a> {
    /// All of a section, in order.
    pub(in crate::figure) fn all(section: &Section<'a>) -> Vec<Self> {
        let mut all = Vec::new();
        let mut nearby = Vec::new();
        for record in section.records {
            match &record.event {
                Event::Nearby(photon) => nearby.push((section.step(record), photon)),
                Event::Gathered(gathered) => all.push(Self {
                    nearby: std::mem::take(&mut nearby),
                    gathered,
                    step: section.step(record),
                }),
                _ => {}
            }
        }
        all
    }

    /// The rim of the disc that holds the photons; `None` for the cell of a map, or where nothing is stored.
    pub(in crate::figure) fn disc(&self, scene: &Scene) -> Option<Vec<DVec3>> {
        let Gathered { object, point, .. } = *self.gathered;
        let normal = scene.primitive(object).shape.normals(point).geometric;
        Some(disc::rim(point, normal, self.gathered.radius?))
    }

    /// Those that count, with their steps.
    pub(in crate::figure) fn counted(&self) -> &[(u32, &'a Nearby)] {
        &self.nearby[..self.nearby.len().min(self.gathered.count as usize)]
    }

    /// What those that count carry: `4 · 0.25 W` if it is the same for all.
    fn power(&self) -> String {
        let counted = self.counted();
        if counted.is_empty() {
            // of the cell of a map only their sum is known
            let power = self.gathered.area * self.gathered.irradiance;
            return format!("{} W", amount(power));
        }
        let first = counted.first().map_or(DVec3::ZERO, |(_, of)| of.power);
        if counted.iter().all(|(_, of)| of.power == first) {
            return format!("{} · {} W", counted.len(), amount(first));
        }
        let sum: DVec3 = counted.iter().map(|(_, of)| of.power).sum();
        format!("{} W", amount(sum))
    }

    /// On what area: that of the disc, or what of it the surface has.
    fn area(&self) -> String {
        /// Of an area that was added up piece by piece.
        const ROUNDING: f64 = 1e-9;
        let area = self.gathered.area;
        match self.gathered.radius {
            Some(r) if (area - PI * r * r).abs() <= ROUNDING * area => {
                format!("(π · {}² m²)", quantity(r))
            }
            _ => format!("{} m²", quantity(area)),
        }
    }

    /// E with its numbers, in watts and metres: in one line, or in two where three colours differ.
    pub(in crate::figure) fn working(&self) -> Vec<String> {
        let from = format!("E = {} / {}", self.power(), self.area());
        let irradiance = self.gathered.irradiance;
        let result = format!("= {} W/m²", amount(irradiance));
        if is_grey(irradiance) {
            vec![format!("{from} {result}")]
        } else {
            vec![from, result]
        }
    }
}

impl Gathering<'_> {
    /// The same as lines of a drawing.
    pub(in crate::figure) fn lines(&self) -> Vec<Text> {
        let line = |text: &String| match text.strip_prefix("E ") {
            Some(rest) => formula("E ") + rest,
            None => text.into(),
        };
        self.working().iter().map(line).collect()
    }
}

fn is_grey(of: DVec3) -> bool {
    of.x == of.y && of.y == of.z
}

/// Red, green and blue, or the one number that all three are.
fn amount(of: DVec3) -> String {
    if is_grey(of) {
        quantity(of.x)
    } else {
        coordinates(of)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nearby(powers: &[DVec3]) -> Vec<Nearby> {
        let photon = |&power| Nearby {
            power,
            ..Nearby::default()
        };
        powers.iter().map(photon).collect()
    }

    fn gathering<'a>(photons: &'a [Nearby], gathered: &'a Gathered) -> Gathering<'a> {
        Gathering {
            nearby: (0..).zip(photons).collect(),
            gathered,
            step: 9,
        }
    }

    #[test]
    fn of_equal_photons_the_working_says_how_many_count() {
        // two of three count: 2 · 0.5 / 4π
        let photons = nearby(&[DVec3::splat(0.5); 3]);
        let gathered = Gathered {
            count: 2,
            radius: Some(2.0),
            area: 4.0 * PI,
            irradiance: DVec3::splat(0.25 / PI),
            ..Gathered::default()
        };
        let found = gathering(&photons, &gathered).working();
        assert_eq!(found, ["E = 2 · 0.5 W / (π · 2² m²) = 0.07958 W/m²"]);
    }

    #[test]
    fn of_coloured_photons_it_says_the_sum_and_at_an_edge_what_the_surface_has_of_the_disc() {
        let photons = nearby(&[DVec3::ONE, DVec3::X, DVec3::splat(7.0)]);
        let gathered = Gathered {
            count: 2,
            radius: Some(2.0),
            area: 4.0,
            irradiance: DVec3::new(0.5, 0.25, 0.25),
            ..Gathered::default()
        };
        let found = gathering(&photons, &gathered).working();
        assert_eq!(
            found,
            ["E = (2, 1, 1) W / 4 m²", "= (0.5, 0.25, 0.25) W/m²"]
        );
    }

    #[test]
    fn of_a_map_it_says_what_fell_on_the_cell() {
        let gathered = Gathered {
            count: 3,
            radius: None,
            area: 0.5,
            irradiance: DVec3::splat(3.0),
            ..Gathered::default()
        };
        let found = gathering(&[], &gathered).working();
        assert_eq!(found, ["E = 1.5 W / 0.5 m² = 3 W/m²"]);
    }
}
