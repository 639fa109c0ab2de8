//! The rays that a figure draws, and what it shows where they hit.

use crate::figure::error::FigureError;
use crate::figure::parts::surface;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::figure::traced::Section;
use crate::trace::{Purpose, RayNode, RayTree, RayVerdict};

/// The rays that are drawn.
pub(super) struct Drawn<'a> {
    pub(super) trees: Vec<(Section<'a>, RayTree)>,
    /// Each by its tree and its place there.
    pub(super) rays: Vec<(usize, usize)>,
    /// Does a square show the colour of the pixel?
    pub(super) shows_colour: bool,
}

impl<'a> Drawn<'a> {
    pub(super) fn find(figure: &Figure<'a>) -> Result<Self, FigureError> {
        let mut sections = figure.first.paths();
        let paths = sections.len();
        for pixel in figure.pixels() {
            sections.push(figure.section_of(pixel)?);
        }
        if sections.is_empty() {
            figure.pixel()?;
        }
        let trees: Vec<_> = sections
            .into_iter()
            .map(|section| (section, RayTree::new(section.records)))
            .collect();
        let is_drawn = |node: &RayNode| match (node.start, node.end) {
            (Some(start), Some(end)) => {
                figure.shows(layer(start.purpose)) && end.verdict != RayVerdict::DepthLimit
            }
            _ => false,
        };
        let rays = trees.iter().enumerate().flat_map(|(tree, (_, of))| {
            let places = of.rays.iter().enumerate();
            places
                .filter(|(_, node)| is_drawn(node))
                .map(move |(place, _)| (tree, place))
        });
        Ok(Self {
            rays: rays.collect(),
            // one pixel, whose colour is not shown by the picture beside it nor by what reflects
            shows_colour: paths == 0
                && trees.len() == 1
                && figure.shows(Layer::Window)
                && !figure.shows(Layer::Angles)
                && !figure.spec.show.contains(&Layer::Image),
            trees,
        })
    }

    /// The rays with their places, and where each comes from.
    pub(super) fn nodes(&self) -> impl Iterator<Item = (usize, &Section<'a>, &RayNode)> {
        self.rays.iter().enumerate().map(|(place, (tree, node))| {
            let (section, tree) = &self.trees[*tree];
            (place, section, &tree.rays[*node])
        })
    }

    /// Where rays hit surfaces whose angles are shown, each with the place of its ray.
    pub(super) fn surfaces(&self, figure: &Figure) -> Vec<(usize, surface::Met<'a>)> {
        let met = |(place, section, node): (usize, &Section<'a>, &RayNode)| {
            Some((place, surface::Met::shown(figure, section.records, node)?))
        };
        self.nodes().filter_map(met).collect()
    }

    /// Snell's law at the first surface that a ray passes.
    pub(super) fn law(&self, figure: &Figure) -> Option<(usize, surface::Law)> {
        let surfaces = self.surfaces(figure);
        surfaces
            .iter()
            .find_map(|(place, met)| Some((*place, met.law()?)))
    }

    pub(super) fn has_total_reflection(&self, figure: &Figure) -> bool {
        self.surfaces(figure).iter().any(|(_, met)| met.is_total())
    }

    /// The place of the ray that spawned one.
    pub(super) fn parent(&self, place: usize) -> Option<usize> {
        let (tree, node) = self.rays[place];
        let nodes = &self.trees[tree].1.rays;
        let parent = nodes[node].parent?;
        let is_parent = |(of, at): &(usize, usize)| *of == tree && nodes[*at].id == parent;
        self.rays.iter().position(is_parent)
    }
}

pub(super) fn layer(purpose: Purpose) -> Layer {
    match purpose {
        Purpose::Eye => Layer::Ray,
        Purpose::Shadow => Layer::ShadowRays,
        Purpose::Reflected | Purpose::Refracted | Purpose::Scattered => Layer::Secondary,
        Purpose::Light => Layer::LightPaths,
        Purpose::Connection => Layer::Connections,
    }
}
