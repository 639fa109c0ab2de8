//! The paths that a figure shows, and what each leg of them is good for.

use std::collections::BTreeMap;
use std::ops::Range;

use glam::DVec3;

use crate::explain::grouped;
use crate::figure::error::FigureError;
use crate::figure::parts::gathering::Gathering;
use crate::figure::parts::light_path::{LightPath, Use, gathered_from};
use crate::figure::subject::Figure;
use crate::figure::traced::Section;
use crate::trace::Transport;

/// The part of the scene between two planes across the line of sight: paths that leave it would seem to bend where they do not.
struct Slice {
    towards: DVec3,
    ends: [f64; 2],
}

impl Slice {
    /// That of the specification's frame, if it has a depth.
    fn of(figure: &Figure) -> Option<Self> {
        let corners = figure.spec.frame?.map(DVec3::from);
        let projection = figure.projection();
        let towards = projection.towards();
        let [a, b] = corners.map(|corner| corner.dot(towards));
        let ends = [a.min(b), a.max(b)];
        (!projection.in_space && ends[0] < ends[1]).then_some(Self { towards, ends })
    }

    /// Does the whole path lie in it?
    fn holds(&self, path: &LightPath) -> bool {
        let is_inside = |at: DVec3| {
            let depth = at.dot(self.towards);
            self.ends[0] <= depth && depth <= self.ends[1]
        };
        path.legs.iter().all(|leg| {
            let ray = &leg.start.ray;
            is_inside(ray.origin) && leg.end.t.is_none_or(|t| is_inside(ray.at(t)))
        })
    }
}

/// The paths that are shown, and what each leg of them is good for.
pub(super) struct Shown<'a> {
    pub(super) paths: Vec<(LightPath<'a>, Vec<Use>)>,
    /// What was gathered at the pixels, with their events.
    pub(super) pixels: Vec<(Section<'a>, Vec<Gathering<'a>>)>,
    pub(super) transport: Transport,
}

impl<'a> Shown<'a> {
    pub(super) fn of(figure: &Figure<'a>) -> Result<Self, FigureError> {
        let mut pixels = Vec::new();
        let mut surfaces: BTreeMap<u32, u32> = BTreeMap::new();
        for pixel in figure.pixels() {
            let section = figure.section_of(pixel)?;
            for (path, surface) in gathered_from(section.records) {
                let last = surfaces.entry(path).or_default();
                *last = surface.max(*last);
            }
            pixels.push((section, Gathering::all(&section)));
        }
        let with_uses = |section: &Section<'a>| {
            let path = LightPath::of(section)?;
            let uses = path.uses(surfaces.get(&path.start.path).copied());
            Some((path, uses))
        };
        let sections = figure.first.paths();
        let mut paths: Vec<_> = sections.iter().filter_map(with_uses).collect();
        if let Some(slice) = Slice::of(figure) {
            paths.retain(|(path, _)| slice.holds(path));
        }
        if paths.is_empty() {
            return Err(FigureError::new(
                "paths",
                "the log has no path of light",
                "add a \"transport\" that traces light, and show some paths: \"paths\": 20",
            ));
        }
        Ok(Self {
            paths,
            pixels,
            transport: figure.first.settings.transport,
        })
    }

    /// Of how many paths is this the best use? Their first legs lead to all that the others lead to.
    pub(super) fn count(&self, of: Use) -> usize {
        let paths = self.paths.iter();
        paths.filter(|(_, uses)| uses.first() == Some(&of)).count()
    }

    /// How many paths there are, shown or not.
    pub(super) fn all(&self) -> String {
        let first = self.paths.first();
        grouped(first.map_or(0, |(path, _)| path.start.paths.into()))
    }

    /// How many photons the shown paths have stored.
    pub(super) fn stored(&self) -> usize {
        let legs = self.paths.iter().flat_map(|(path, _)| &path.legs);
        legs.filter(|leg| leg.stored.is_some()).count()
    }

    /// How many of the first paths are shown whatever comes of them; those behind them lead to the pixels that are drawn.
    pub(super) fn first(&self, figure: &Figure) -> usize {
        let first = figure.spec.paths.unwrap_or(0) as usize;
        first.min(self.paths.len())
    }

    /// The last step of some paths.
    pub(super) fn last_step(&self, paths: Range<usize>) -> Option<u32> {
        let legs = self.paths[paths].iter().flat_map(|(path, _)| &path.legs);
        legs.map(|leg| leg.step).max()
    }
}
