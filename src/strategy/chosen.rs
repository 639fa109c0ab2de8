//! The one line that chooses the driver of a strategy.
//!
//! ```text
//!                    ┌─ somebody follows ─▶ the strategy: steps, each noted ─┐
//! ray ─▶ Driven ─────┤                                                       ├─▶ the same hit
//!                    └─ nobody does ──────▶ fast: the same structure, aids ──┘
//! ```

use std::ops::ControlFlow;
use std::sync::OnceLock;

use crate::geometry::Ray;
use crate::strategy::fast::Fast;
use crate::strategy::{Search, Strategy};
use crate::trace::Recorder;

/// A strategy, and what its fast driver needs.
#[derive(Clone, Debug)]
pub(super) struct Driven<S: Fast> {
    pub(super) strategy: S,
    /// Built when the first ray comes that nobody follows.
    aids: OnceLock<S::Aids>,
}

impl<S: Fast> Driven<S> {
    pub(super) fn new(strategy: S) -> Self {
        Self {
            strategy,
            aids: OnceLock::new(),
        }
    }

    /// The fast driver, with its aids.
    // apart: what chooses a strategy for a ray then needs no room for the variables of any of them
    #[inline(never)]
    fn search_fast(&self, ray: &Ray, search: &mut impl Search) -> ControlFlow<()> {
        let Self { strategy, aids } = self;
        strategy.search_fast(aids.get_or_init(|| strategy.aids()), ray, search)
    }
}

impl<S: Fast> Strategy for Driven<S> {
    #[inline]
    fn search<R: Recorder>(
        &self,
        ray: &Ray,
        search: &mut impl Search,
        recorder: &mut R,
    ) -> ControlFlow<()> {
        if R::ENABLED {
            self.strategy.search(ray, search, recorder)
        } else {
            self.search_fast(ray, search)
        }
    }

    fn note_building<R: Recorder>(&self, recorder: &mut R) {
        self.strategy.note_building(recorder);
    }

    fn bytes(&self) -> usize {
        self.strategy.bytes() + self.aids.get().map_or(0, S::bytes_of)
    }
}
