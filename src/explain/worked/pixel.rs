//! The pixel: where its rays pass the window, the rays, and the colour that they make.

use glam::DVec3;

use crate::explain::number::{Digits, grouped};
use crate::explain::page::Tone;
use crate::explain::worked::{Solution, count};
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

impl Solution<'_> {
    /// All that belongs to the pixel itself.
    pub(super) fn pixel(&mut self) {
        let mut brought = Brought::default();
        let items = self.tree.items.clone();
        let mut rest = items.as_slice();
        while let Some((first, after)) = rest.split_first() {
            if let Some((joined, length)) = self.joined(rest) {
                self.connect(&joined, &brought.eye);
                if let (Some(line), Some(sum)) = (joined.connection, brought.paths.last_mut()) {
                    *sum += self.all_pixels() * line.contribution;
                }
                rest = &rest[length..];
                continue;
            }
            rest = after;
            match *first {
                Item::Ray(place) => {
                    self.page.gap();
                    self.ray(place);
                    let ray = &self.tree.rays[place];
                    brought.rays.extend(ray.end.and_then(|end| end.colour));
                    brought.eye.extend(self.photon_of(ray));
                }
                Item::Event(at) => match self.records[at].event {
                    Event::Pixel(sample) => {
                        brought.eye.clear();
                        brought.paths.push(DVec3::ZERO);
                        self.window_point(&sample);
                    }
                    Event::PixelColour(colour) => self.pixel_colour(&colour, &brought),
                    _ => {}
                },
            }
        }
    }

    /// One ray alone; one that connects with all that its line comes to.
    pub(super) fn one_ray(&mut self, id: u32) {
        let Some(wanted) = self.tree.find(id) else {
            return;
        };
        let items = self.tree.items.clone();
        let mut eye = Vec::new();
        for (at, item) in items.iter().enumerate() {
            match *item {
                Item::Ray(place) if place == wanted => {
                    if let Some((joined, _)) = self.joined(&items[at..]) {
                        return self.connect(&joined, &eye);
                    }
                }
                Item::Ray(place) => eye.extend(self.photon_of(&self.tree.rays[place])),
                Item::Event(at) => {
                    if let Event::Pixel(_) = self.records[at].event {
                        eye.clear();
                    }
                }
            }
        }
        self.page.gap();
        self.ray(wanted);
    }

    /// W·H: how many pixels the picture has.
    pub(super) fn all_pixels(&self) -> f64 {
        let [width, height] = self.scene.camera.pixels.map(f64::from);
        width * height
    }

    /// P = corner + (x/width)·right + (1 − y/height)·up
    fn window_point(&mut self, sample: &PixelSample) {
        if !self.shows(Kind::Pixel) {
            return;
        }
        let d = Digits::USUAL;
        let camera = &self.scene.camera;
        let [width, height] = camera.pixels;
        self.page.gap();
        let number = format!("{} of {}", sample.sample + 1, sample.samples);
        let place = match (self.settings.transport, self.settings.through) {
            (Transport::Forward, _) => {
                "The pixel's centre on the window: no ray is sent from it, photons come to the pixel".into()
            }
            (Transport::HybridConnected, _) => {
                format!("Path {number} from the eye: a place of chance in the pixel")
            }
            (_, Through::Centres) => "The pixel's centre on the window".into(),
            (_, Through::Corners) => format!("Corner {number} on the window"),
        };
        self.page.line(Tone::Heading, place);
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
        self.page.indented(|page| {
            for line in lines {
                page.plain(line);
            }
        });
    }

    fn pixel_colour(&mut self, colour: &PixelColour, brought: &Brought) {
        if !self.shows(Kind::PixelColour) {
            return;
        }
        let d = Digits::USUAL;
        self.page.gap();
        self.page.line(Tone::Heading, "The pixel's colour");
        let mut lines = match self.settings.transport {
            Transport::Forward => self.sum_of_arrivals(colour.raw),
            Transport::HybridConnected => self.sum_of_lines(colour.raw, &brought.paths),
            Transport::Backward | Transport::HybridLight | Transport::HybridStored => {
                vec![of_eye_rays(colour.raw, &brought.rays)]
            }
        };
        if colour.raw != colour.clamped {
            lines.push(format!("cut to 0..1: {}", d.vector(colour.clamped)));
        }
        let [r, g, b] = colour.rgb();
        lines.push(format!("in the picture, times 255: ({r}, {g}, {b})"));
        self.page.indented(|page| {
            for line in lines {
                page.plain(line);
            }
        });
    }

    /// What photons have brought to the pixel.
    fn sum_of_arrivals(&self, raw: DVec3) -> Vec<String> {
        let paths = grouped(self.settings.light.paths);
        let arrivals = self.arrivals_here();
        let light = &self.settings.light;
        if raw == DVec3::ZERO && arrivals.is_empty() {
            let pinhole = light.aperture_radius(&self.scene.camera) == 0.0;
            let why = if pinhole {
                ": the eye's aperture is a point, which no photon ever meets"
            } else {
                ""
            };
            let text =
                format!("none of {paths} photons has come through this pixel into the eye{why}");
            return vec![text, "nothing arrives: (0, 0, 0)".into()];
        }
        let radiances: Vec<DVec3> = arrivals.iter().map(|&(_, radiance)| radiance).collect();
        let what = format!(
            "what {} of {paths} brought",
            count(arrivals.len(), "photon")
        );
        vec![self.written_sum(&what, &radiances, raw)]
    }

    /// What the lines have brought: those of the pixel's own paths, and those of paths of light to the eye.
    fn sum_of_lines(&self, raw: DVec3, paths: &[DVec3]) -> Vec<String> {
        let lines: Vec<DVec3> = self
            .paths
            .values()
            .flat_map(|known| &known.lines)
            .filter(|line| line.visible && line.pixel == self.pixel)
            .map(|line| line.contribution)
            .collect();
        let own: DVec3 = paths.iter().sum();
        let seen: DVec3 = lines.iter().sum();
        let mut told = vec![self.written_sum(
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
            told.push(self.written_sum(&what, &lines, seen));
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
    fn written_sum(&self, what: &str, terms: &[DVec3], sum: DVec3) -> String {
        let d = Digits::USUAL;
        let found: DVec3 = terms.iter().sum();
        // the terms were added in another order
        let is_sum = (found - sum).abs().max_element() <= 1e-9 * sum.abs().max_element();
        let most = if self.options.all { usize::MAX } else { TERMS };
        if !is_sum || terms.len() < 2 || most < terms.len() {
            return format!("{what}: {}", d.vector(sum));
        }
        let texts: Vec<_> = terms.iter().map(|&term| d.vector(term)).collect();
        format!("{what}: {} = {}", texts.join(" + "), d.vector(sum))
    }
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
