//! The paths of light that led to a pixel: each in a few lines, or in full.

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec3;

use crate::explain::number::{Digits, grouped};
use crate::explain::page::Tone;
use crate::explain::worked::photon::{Carries, channels};
use crate::explain::worked::{Solution, count};
use crate::scene::Emission;
use crate::trace::{
    Arrival, Connection, Event, Item, Kind, Outcome, PathStart, Photon, PhotonFate, Purpose,
    RayNode, Record,
};

/// So many paths are told, and the others counted, unless all are wanted: more would hide the pixel.
const TOLD: usize = 8;

/// What is known of a path of light wherever it is spoken of.
#[derive(Clone, Debug, Default)]
pub(super) struct KnownPath {
    pub(super) start: Option<PathStart>,
    /// What met its surfaces, in order.
    pub(super) met: Vec<Photon>,
    /// What came of it to the eye.
    pub(super) arrivals: Vec<Arrival>,
    /// Lines from it to the eye.
    pub(super) lines: Vec<Connection>,
    /// The numbers of its surfaces where it was stored and the pixel has gathered it.
    pub(super) gathered: BTreeSet<u32>,
}

impl KnownPath {
    /// All paths that the records tell of.
    pub(super) fn all(records: &[Record]) -> BTreeMap<u32, Self> {
        let mut paths: BTreeMap<u32, Self> = BTreeMap::new();
        for record in records {
            let Some(path) = record.path else {
                if let Event::Nearby(photon) = record.event {
                    let known = paths.entry(photon.path).or_default();
                    known.gathered.insert(photon.surface);
                }
                continue;
            };
            let known = paths.entry(path).or_default();
            match record.event {
                Event::Path(start) => known.start = Some(start),
                Event::Photon(photon) => known.met.push(photon),
                Event::Arrival(arrival) => known.arrivals.push(arrival),
                Event::Connection(line) => known.lines.push(line),
                _ => {}
            }
        }
        paths
    }
}

/// What of a path is told where it is told in brief.
const IN_BRIEF: [Kind; 6] = [
    Kind::Path,
    Kind::Photon,
    Kind::Stored,
    Kind::Arrival,
    Kind::Alternative,
    Kind::Connection,
];

impl<'a> Solution<'a> {
    /// The paths of light, one after the other.
    pub(super) fn light_paths(&mut self, records: &'a [Record]) {
        let all = self.options.all;
        let is_told = |record: &Record| {
            let kind = record.event.kind();
            self.shows(kind) && (all || IN_BRIEF.contains(&kind))
        };
        let paths: Vec<&[Record]> = records
            .chunk_by(|a, b| a.path == b.path)
            .filter(|path| path.iter().any(is_told))
            .collect();
        let told = if all { paths.len() } else { TOLD };
        for path in paths.iter().take(told) {
            self.turn_to(path);
            self.light_path();
        }
        if let Some(more) = paths.len().checked_sub(told).filter(|&more| 0 < more) {
            self.page.gap();
            let more = count(more, "more path");
            let text = format!("… {more} of light led to the pixel (--all tells them)");
            self.page.line(Tone::Aside, text);
        }
    }
}

impl Solution<'_> {
    /// One path of light.
    fn light_path(&mut self) {
        let Some(number) = self.records.first().and_then(|record| record.path) else {
            return;
        };
        let known = self.paths.get(&number).cloned().unwrap_or_default();
        self.page.gap();
        self.page
            .line(Tone::Heading, self.path_title(number, &known));
        self.page.indent();
        let items = self.tree.items.clone();
        let mut surface = 0;
        let mut rest = items.as_slice();
        while let Some((first, after)) = rest.split_first() {
            if let Some((joined, length)) = self.joined(rest) {
                match joined.connection {
                    Some(line) if !self.options.all && line.pixel != self.pixel => {
                        self.line_elsewhere(&line);
                    }
                    _ => self.connect(&joined, &[]),
                }
                rest = &rest[length..];
                continue;
            }
            rest = after;
            let Item::Ray(place) = *first else {
                continue;
            };
            surface += 1;
            if self.options.all {
                self.page.gap();
                self.ray(place);
            } else {
                self.leg(place, surface, &known);
            }
        }
        self.page.outdent();
    }

    /// `Path 17 of light: from the light lamp, carries 150/768 = 0.195313 W in each channel`
    fn path_title(&self, number: u32, known: &KnownPath) -> String {
        let d = Digits::USUAL;
        let Some(start) = known.start.filter(|_| self.shows(Kind::Path)) else {
            return format!("Path {number} of light");
        };
        let lights = &self.scene.lights;
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
            "Path {number} of light: from the light {}, carries {} W in each channel ({} W {of} over {} paths)",
            self.light_name(start.light),
            d.number(start.power.x),
            d.number(power),
            grouped(u64::from(start.paths))
        )
    }

    /// One leg of a path in a line, and what of it came to the eye.
    fn leg(&mut self, place: usize, surface: u32, known: &KnownPath) {
        let ray = self.tree.rays[place].clone();
        if self.shows(Kind::Photon) || self.shows(Kind::RayEnd) {
            let from = match self.leg_before(place) {
                Some((_, photon)) => self.name(photon.object),
                None => known
                    .start
                    .map_or("the light".into(), |start| self.light_name(start.light)),
            };
            let to = self.end_of_leg(&ray, surface, known);
            self.page.plain(format!("{from} → {to}"));
        }
        for item in &ray.items {
            if let Item::Event(at) = *item
                && let Event::Arrival(arrival) = self.records[at].event
            {
                self.page.indent();
                self.seen(&arrival);
                self.page.outdent();
            }
        }
    }

    /// Where a leg ends, and what becomes of the photon there.
    fn end_of_leg(&self, ray: &RayNode, surface: u32, known: &KnownPath) -> String {
        let d = Digits::USUAL;
        let t = ray.end.and_then(|end| end.t);
        let at = t.map_or(String::new(), |t| format!(" at t = {}", d.number(t)));
        let Some(photon) = self.photon_of(ray) else {
            let carried = known.carried_after(surface - 1);
            let carried = carried.map_or(String::new(), |power| {
                format!(" with {}", Carries::Power.amount(power))
            });
            return match ray.end.map(|end| (end.outcome, end.object)) {
                Some((Outcome::CutOff, Some(object))) => format!(
                    "{}{at}: one surface more than a path may meet, cut off{carried}",
                    self.name(object)
                ),
                Some((Outcome::Miss, _)) => format!("out of the scene{carried}"),
                _ => format!("?{at}"),
            };
        };
        let chance = d.number(photon.chance);
        let limit = photon.reflection + photon.transmission;
        let becomes = match photon.fate {
            PhotonFate::Mirrored => {
                format!("mirrored (ξ = {chance} < {})", d.number(photon.reflection))
            }
            PhotonFate::Refracted => format!(
                "refracted (ξ = {chance} in {}..{})",
                d.number(photon.reflection),
                d.number(limit)
            ),
            PhotonFate::Diffused => format!("scattered (ξ = {chance}: {})", channels(&photon)),
            PhotonFate::Absorbed => format!("absorbed (ξ = {chance})"),
        };
        let is_stored = |item: &Item| match *item {
            Item::Event(at) => matches!(self.records[at].event, Event::Stored(_)),
            Item::Ray(_) => false,
        };
        let stored = match ray.items.iter().any(is_stored) {
            false => "",
            true if known.gathered.contains(&surface) => "stored and gathered by the pixel; ",
            true => "stored; ",
        };
        format!("{}{at}: {stored}{becomes}", self.name(photon.object))
    }

    /// A line to the eye that does not come to the pixel that is told.
    fn line_elsewhere(&mut self, line: &Connection) {
        if !self.shows(Kind::Connection) {
            return;
        }
        let from = self.light_vertex(line.path, usize::from(line.light_vertex));
        let end = match line.pixel {
            Some([x, y]) if line.visible => format!("comes to another pixel, ({x}, {y})"),
            _ => "is blocked".into(),
        };
        let text = format!("the line from {} to the eye {end}", from.name);
        self.page.line(Tone::Aside, text);
    }

    /// Of a leg of a path of light that meets nothing more: with what it leaves. Told below its ray.
    pub(super) fn leaves_with(&self, ray: &RayNode) -> Option<String> {
        let path = self.records.first()?.path?;
        let start = ray.start.filter(|start| start.purpose == Purpose::Light)?;
        let power = self
            .paths
            .get(&path)?
            .carried_after(start.depth.checked_sub(1)?)?;
        Some(format!(
            ": {} leaves the scene",
            Carries::Power.amount(power)
        ))
    }
}

impl KnownPath {
    /// What is carried on after so many surfaces.
    fn carried_after(&self, surfaces: u32) -> Option<DVec3> {
        match (surfaces as usize).checked_sub(1) {
            None => self.start.map(|start| start.power),
            Some(before) => self.met.get(before).map(Photon::leaving),
        }
    }
}
