//! What the words are made from. Nothing in it changes while a page is written; a structure is built again when it is
//! first asked for.

use std::collections::BTreeMap;
use std::ops::Range;

use crate::explain::name::{light_title, primitive_name};
use crate::explain::worked::built_again::BuiltAgain;
use crate::explain::worked::extent::Extent;
use crate::explain::worked::known_path::KnownPath;
use crate::explain::worked::options::WorkedOptions;
use crate::scene::{PrimitiveId, Scene};
use crate::trace::{Item, Kind, RayTree, Record, Settings};

/// A section of a pixel's records, and what is known beside it: the scene, the settings, what is asked for.
///
/// The sections are the building, each path of light, and the pixel itself. Steps and rays are numbered from 0 in each.
#[derive(Clone, Debug)]
pub(super) struct Context<'a> {
    pub(super) scene: &'a Scene,
    pub(super) settings: &'a Settings,
    pub(super) options: &'a WorkedOptions,
    /// The pixel; a filtered log may hold nothing of it.
    pub(super) pixel: Option<[u32; 2]>,
    /// The paths of light that led to it.
    pub(super) paths: &'a BTreeMap<u32, KnownPath>,
    /// The structures without room for rounding, one for all sections.
    pub(super) again: &'a BuiltAgain,
    /// The records of all sections.
    all: &'a [Record],
    /// The place of the section's first record among all.
    start: usize,
    /// The section's records.
    pub(super) records: &'a [Record],
    /// The section's rays.
    pub(super) tree: RayTree,
}

impl<'a> Context<'a> {
    /// A context with no section.
    pub(super) fn new(
        scene: &'a Scene,
        settings: &'a Settings,
        options: &'a WorkedOptions,
        paths: &'a BTreeMap<u32, KnownPath>,
        again: &'a BuiltAgain,
        all: &'a [Record],
    ) -> Self {
        Self {
            scene,
            settings,
            options,
            pixel: all.iter().find_map(|record| record.pixel),
            paths,
            again,
            all,
            start: 0,
            records: &[],
            tree: RayTree::default(),
        }
    }

    /// The same with these records as its section; all of them, if there are fewer.
    pub(super) fn section(&self, places: Range<usize>) -> Self {
        let records = self.all.get(places.clone()).unwrap_or(self.all);
        Self {
            start: places.start,
            records,
            tree: RayTree::new(records),
            ..*self
        }
    }

    /// The extent of an event of the section.
    pub(super) fn at(&self, place: usize) -> Extent {
        Extent::at(self.start + place)
    }

    /// From the first event of a ray to the last, those of the rays that it spawned included.
    pub(super) fn of_ray(&self, place: usize) -> Extent {
        let ray = &self.tree.rays[place];
        let ends = ray.ends_at.into_iter().flatten().map(|at| self.at(at));
        let inside = ray.items.iter().map(|item| self.of_item(item));
        // a ray is in the tree because one of its events is there
        Extent::around(ends.chain(inside)).unwrap_or(self.at(0))
    }

    /// From the first event of an item to the last.
    pub(super) fn of_item(&self, item: &Item) -> Extent {
        match *item {
            Item::Event(at) => self.at(at),
            Item::Ray(place) => self.of_ray(place),
        }
    }

    /// Are events of this kind shown?
    pub(super) fn shows(&self, kind: Kind) -> bool {
        self.options.kinds.contains(kind)
    }

    /// A primitive as it is called in the text.
    pub(super) fn name(&self, id: PrimitiveId) -> String {
        primitive_name(self.scene, id)
    }

    /// A light as it is called in the text: `light "lamp"`.
    pub(super) fn light_title(&self, light: u32) -> String {
        light_title(self.scene, light)
    }

    /// W·H: how many pixels the picture has.
    pub(super) fn all_pixels(&self) -> f64 {
        let [width, height] = self.scene.camera.pixels.map(f64::from);
        width * height
    }
}
