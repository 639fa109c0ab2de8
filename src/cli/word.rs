//! The words of the library's choices on the command line, and what the help says of each.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
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
            "Every object whose bounding volume is met",
        ),
        (
            Self::Hierarchy,
            "hierarchy",
            "A hierarchy of bounding volumes, walked depth first",
        ),
        (
            Self::Heap,
            "heap",
            "A hierarchy of bounding volumes, walked in the order of distance",
        ),
        (
            Self::Grid,
            "grid",
            "The cells of a uniform grid, one after the other along the ray",
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
            "From the eye alone; no rays to lights, so no shadows",
        ),
        (
            Self::HybridLight,
            "hybrid-light",
            "From the eye, with a ray to each light from each point",
        ),
        (
            Self::Forward,
            "forward",
            "From the lights alone; what passes the window into the eye makes the picture",
        ),
        (
            Self::HybridStored,
            "hybrid-stored",
            "From the lights, stored on the surfaces; then from the eye, gathering what is stored",
        ),
        (
            Self::HybridConnected,
            "hybrid-connected",
            "From the lights and from the eye; lines connect the two",
        ),
    ];
}

impl Word for Through {
    const WORDS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Centres, "centres", "One ray through its centre"),
        (
            Self::Corners,
            "corners",
            "Four rays through its corners, of which the pixel is the mean. A picture shares them: (width + 1) × (height + 1) in all",
        ),
    ];
}

impl Word for SlabChoice {
    const WORDS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Axes, "axes", "The three axes: a box"),
        (
            Self::Seven,
            "seven",
            "The axes and the four diagonals of a cube: the seven of Kay and Kajiya's paper",
        ),
        (Self::Scene, "scene", "The set in the scene file"),
    ];
}

impl Word for Lists {
    const WORDS: &'static [(Self, &'static str, &'static str)] = &[
        (
            Self::Objects,
            "objects",
            "The object itself reaches into the cell",
        ),
        (Self::Boxes, "boxes", "The box around the object does"),
    ];
}

impl Word for Build {
    const WORDS: &'static [(Self, &'static str, &'static str)] = &[
        (
            Self::BottomUp,
            "bottom-up",
            "From the objects upwards, the nearest two volumes joined each time, as the slides say",
        ),
        (
            Self::Insertion,
            "insertion",
            "One object after the other put where it adds the least area (Goldsmith and Salmon 1987)",
        ),
        (
            Self::SurfaceArea,
            "surface-area",
            "From the top downwards, each node cut where the areas of its halves promise the fewest tests",
        ),
    ];
}

impl Word for VolumeKind {
    const WORDS: &'static [(Self, &'static str, &'static str)] = &[
        (Self::Sphere, "sphere", "The smallest sphere"),
        (
            Self::Ellipsoid,
            "ellipsoid",
            "The ellipsoid of least volume, turned as it fits best",
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
            "How many object tests the pixel's rays took",
        ),
        (
            Self::Nodes,
            "nodes",
            "How many bounds they were tested against and nodes they entered",
        ),
        (
            Self::Cells,
            "cells",
            "How many cells of the grid they visited",
        ),
        (
            Self::Depth,
            "depth",
            "How deep the tree of rays is: 1 for the eye ray alone; shadow rays count",
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
    fn every_value_has_a_word_of_its_own() {
        let words: BTreeSet<&str> = HeatOf::WORDS.iter().map(|(_, word, _)| *word).collect();
        assert_eq!(words.len(), HeatOf::WORDS.len());
        assert_eq!(Transport::WORDS.len(), Transport::ALL.len());
    }
}
