//! The words of the library's choices on the command line, and what the help says of each.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use raystep::figure::FigureKind;
use raystep::structure::{Build, Lists, SlabChoice, VolumeKind};
use raystep::tracer::HeatOf;
use raystep::{StrategyName, Through, Transport};

/// A choice of the library that has a word for each of its values.
pub(crate) trait Word: Copy + PartialEq + Send + Sync + 'static {
    /// Every value, its word, and what it means.
    const WORDS: &'static [(Self, &'static str, &'static str)];
}

/// A value as it is written on the command line.
pub(crate) fn word<T: Word>(value: T) -> &'static str {
    let known = T::WORDS.iter().find(|(known, ..)| *known == value);
    known.map_or("", |(_, word, _)| word)
}

/// The choice of an option as it was written, or the default of the option.
pub(crate) fn choice<T: Word>(option: &str, given: Option<T>, default: T) -> String {
    match given {
        Some(given) => format!("{option} {}", word(given)),
        None => format!("{}, the default of {option}", word(default)),
    }
}

/// Reads the words of a choice.
pub(crate) fn one_of<T: Word>() -> impl TypedValueParser<Value = T> {
    let words = T::WORDS.iter();
    let words = words.map(|(_, word, means)| PossibleValue::new(*word).help(*means));
    PossibleValuesParser::new(words).try_map(|word| {
        let known = T::WORDS.iter().find(|(_, known, _)| *known == word);
        known.map(|(value, ..)| *value).ok_or("no such word")
    })
}

impl Word for StrategyName {
    const WORDS: &'static [(Self, &'static str, &'static str)] = &[
        (
            Self::Exhaustive,
            "exhaustive",
            "Every object, as in Fig. 15.56",
        ),
        (
            Self::Bounds,
            "bounds",
            "Every object whose bounding volume the ray hits",
        ),
        (
            Self::Hierarchy,
            "hierarchy",
            "A hierarchy of bounding volumes, traversed depth first",
        ),
        (
            Self::Heap,
            "heap",
            "A hierarchy of bounding volumes, traversed nearest node first with a heap",
        ),
        (
            Self::Grid,
            "grid",
            "The objects in the cells of a uniform grid, cell by cell along the ray",
        ),
        (
            Self::ZAligned,
            "z-aligned",
            "Every object, in a frame in which the ray is the z axis",
        ),
    ];
}

impl Word for Transport {
    const WORDS: &'static [(Self, &'static str, &'static str)] = &[
        (
            Self::Backward,
            "backward",
            "Rays from the eye only; no shadow rays, so no shadows",
        ),
        (
            Self::HybridLight,
            "hybrid-light",
            "Rays from the eye, and a shadow ray from each point to each light",
        ),
        (
            Self::Forward,
            "forward",
            "Rays from the lights only; those that pass the window into the eye make the picture",
        ),
        (
            Self::HybridStored,
            "hybrid-stored",
            "Light is stored on the surfaces; then rays from the eye gather it (photon mapping)",
        ),
        (
            Self::HybridConnected,
            "hybrid-connected",
            "Paths from the lights and from the eye, connected by lines (bidirectional path tracing)",
        ),
    ];
}

impl Word for Through {
    const WORDS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Centres, "centres", "One ray through its centre"),
        (
            Self::Corners,
            "corners",
            "Four rays through its corners; the pixel is their mean. A picture shares them: (width + 1) × (height + 1) in all",
        ),
    ];
}

impl Word for FigureKind {
    const WORDS: &'static [(Self, &'static str, &'static str)] = &[
        (
            Self::Pinhole,
            "pinhole",
            "The pinhole camera with the image of the pixel",
        ),
        (
            Self::Window,
            "window",
            "The window, its pixels, and the eye ray through one",
        ),
        (Self::Rays, "rays", "All rays of the pixel"),
        (
            Self::LineOfT,
            "line-of-t",
            "The parameter t along the eye ray",
        ),
        (
            Self::Sphere,
            "sphere",
            "A sphere, its quadratic and the roots",
        ),
        (
            Self::Polygon,
            "polygon",
            "A polygon, its plane and its projection",
        ),
        (
            Self::Shading,
            "shading",
            "N, L, R and V, and the terms of the shade",
        ),
        (
            Self::Alignment,
            "alignment",
            "The frame in which the ray is the z axis",
        ),
        (
            Self::Volumes,
            "volumes",
            "Bounding volumes around an object, and what they waste",
        ),
        (Self::Slabs, "slabs", "An object in its slabs"),
        (Self::Merge, "merge", "The bound of two bounds"),
        (
            Self::Intervals,
            "intervals",
            "The ray in each slab, as bars",
        ),
        (
            Self::Hierarchy,
            "hierarchy",
            "The bounding volumes and the tree",
        ),
        (Self::Heap, "heap", "The nodes that wait, from pop to pop"),
        (Self::Partition, "partition", "The grid around the scene"),
        (Self::Grid, "grid", "The ray from cell to cell"),
        (
            Self::Steps,
            "steps",
            "The t of the next planes, cell by cell",
        ),
        (Self::Costs, "costs", "The tests of the pixel, by strategy"),
        (Self::Heat, "heat", "The tests of each pixel, by strategy"),
        (
            Self::Picture,
            "picture",
            "The picture with the pixel marked",
        ),
        (Self::Paths, "paths", "Paths of light to the pixel"),
        (
            Self::Gather,
            "gather",
            "The photons around what the pixel shows",
        ),
        (
            Self::Irradiance,
            "irradiance",
            "The irradiance on what each pixel shows",
        ),
        (
            Self::Connections,
            "connections",
            "A path of light and one from the eye, connected",
        ),
        (
            Self::PixelGrid,
            "pixel-grid",
            "The window in its own plane, with the centre of each pixel",
        ),
        (
            Self::RootCases,
            "root-cases",
            "All spheres on the line of the ray, with their parabolas",
        ),
        (
            Self::Forms,
            "forms",
            "The quadratic with b and with half of b",
        ),
        (
            Self::Stretched,
            "stretched",
            "An ellipsoid and its ray, and both where it is the unit sphere",
        ),
        (
            Self::PlaneCases,
            "plane-cases",
            "The planes of the first polygons, each with its case of (v)",
        ),
        (Self::Terms, "terms", "The terms of the shade as bars"),
        (
            Self::Sides,
            "sides",
            "The normals on the sides that rays come from",
        ),
        (
            Self::Epsilon,
            "epsilon",
            "The root of a shadow ray that is its own surface, and ε",
        ),
        (
            Self::Rim,
            "rim",
            "Balls at the rim of the picture, and their cones",
        ),
        (
            Self::Algorithm,
            "algorithm",
            "The lines of Fig. 15.56, and what each does",
        ),
        (
            Self::RayTree,
            "ray-tree",
            "The rays of the pixel as a tree with weights",
        ),
    ];
}

impl Word for SlabChoice {
    const WORDS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Axes, "axes", "The three axes: a box"),
        (
            Self::Seven,
            "seven",
            "The three axes and the four diagonals of a cube: the seven of Kay and Kajiya's paper",
        ),
        (Self::Scene, "scene", "The set in the scene file"),
    ];
}

impl Word for Lists {
    const WORDS: &'static [(Self, &'static str, &'static str)] = &[
        (
            Self::Objects,
            "objects",
            "A cell lists an object whose shape reaches into the cell",
        ),
        (
            Self::Boxes,
            "boxes",
            "A cell lists an object whose bounding box reaches into the cell",
        ),
    ];
}

impl Word for Build {
    const WORDS: &'static [(Self, &'static str, &'static str)] = &[
        (
            Self::BottomUp,
            "bottom-up",
            "From the objects up: the nearest two volumes are joined each time, as the slides say",
        ),
        (
            Self::Insertion,
            "insertion",
            "Objects are inserted one by one where they add the least area (Goldsmith and Salmon 1987)",
        ),
        (
            Self::SurfaceArea,
            "surface-area",
            "From the top down: each node is split where the surface-area heuristic expects the fewest tests",
        ),
    ];
}

impl Word for VolumeKind {
    const WORDS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Sphere, "sphere", "The smallest sphere"),
        (
            Self::Ellipsoid,
            "ellipsoid",
            "The ellipsoid of the smallest volume, in any orientation",
        ),
        (Self::Box, "box", "The rectangular solid along the axes"),
        (Self::Slabs, "slabs", "The intersection of slabs"),
    ];
}

impl Word for HeatOf {
    const WORDS: &'static [(Self, &'static str, &'static str)] = &[
        (
            Self::Tests,
            "tests",
            "The number of object tests of the pixel's rays",
        ),
        (
            Self::Nodes,
            "nodes",
            "The number of bound tests and of nodes entered",
        ),
        (Self::Cells, "cells", "The number of grid cells visited"),
        (
            Self::Depth,
            "depth",
            "The depth of the tree of rays: 1 for the eye ray alone; shadow rays count",
        ),
    ];
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::fmt::Debug;

    use serde::Serialize;

    use super::*;

    #[track_caller]
    fn check<T: Word + Serialize + Debug>() {
        for (value, word, _) in T::WORDS {
            assert_eq!(serde_json::to_value(value).unwrap(), *word, "{value:?}");
        }
    }

    #[test]
    fn the_words_are_those_of_scenes_lessons_and_logs() {
        check::<StrategyName>();
        check::<Transport>();
        check::<Through>();
        check::<SlabChoice>();
        check::<Lists>();
        check::<Build>();
        check::<VolumeKind>();
    }

    #[test]
    fn a_choice_that_nobody_wrote_is_told_as_the_default() {
        let of = |given| choice("--strategy", given, StrategyName::Heap);
        assert_eq!(of(Some(StrategyName::Grid)), "--strategy grid");
        assert_eq!(of(None), "heap, the default of --strategy");
    }

    #[test]
    fn every_value_has_a_word_of_its_own() {
        let words: BTreeSet<&str> = HeatOf::WORDS.iter().map(|(_, word, _)| *word).collect();
        assert_eq!(words.len(), HeatOf::WORDS.len());
        assert_eq!(Transport::WORDS.len(), Transport::ALL.len());
    }
}
