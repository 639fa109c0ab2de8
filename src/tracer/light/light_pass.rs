//! What all paths of light have left, for the pixels to ask.

use std::collections::BTreeSet;

use glam::DVec3;

use crate::trace::LightOptions;
use crate::tracer::light::hybrid_stored::StoredLight;
use crate::tracer::light::lamps::Lamps;

/// What the paths of light have left.
#[doc(alias = "light tracing")]
#[doc(alias = "pdf")]
#[doc(alias = "Russian roulette")]
#[doc(alias = "particle tracing")]
#[derive(Clone, Debug)]
pub struct LightPass {
    pub(in crate::tracer) options: LightOptions,
    pub(in crate::tracer) lamps: Lamps,
    pub(super) pixels: [u32; 2],
    /// What each pixel sees of the paths themselves, row by row; empty where light is stored.
    pub(super) seen: Vec<DVec3>,
    pub(super) stored: StoredLight,
    /// The paths that pixels of a region have seen.
    pub(super) reached: BTreeSet<u32>,
}

impl LightPass {
    /// The light that is stored on the surfaces.
    pub fn stored(&self) -> &StoredLight {
        &self.stored
    }

    /// What a pixel has seen of the paths themselves.
    pub(in crate::tracer) fn seen(&self, pixel: [u32; 2]) -> DVec3 {
        let place = place(pixel, self.pixels);
        self.seen.get(place).copied().unwrap_or_default()
    }
}

/// The place of a pixel in a picture, row by row from the top left.
pub(super) fn place([x, y]: [u32; 2], [width, _]: [u32; 2]) -> usize {
    y as usize * width as usize + x as usize
}
