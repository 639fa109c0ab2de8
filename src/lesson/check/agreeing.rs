//! Some of the colours that agree before the first one differs: a mistake must leave them as they are.

use crate::lesson::check::reference::Expected;
use crate::lesson::check::value::Fields;

/// A pixel's colour.
#[derive(Clone, Debug)]
pub(super) struct Colour {
    pub(super) pixel: [u32; 2],
    pub(super) yours: Fields,
    pub(super) expected: Expected,
}

/// Colours from all over the log so far, and no more than a few.
#[derive(Clone, Debug, Default)]
pub(super) struct Agreeing {
    kept: Vec<Colour>,
    /// Every so manieth is kept, as a power of 2.
    power: u32,
    met: u64,
}

/// Enough to tell most mistakes apart, and fast to compute again.
const MOST: usize = 64;

impl Agreeing {
    /// Keeps a colour, or not.
    pub(super) fn keep(&mut self, colour: impl FnOnce() -> Colour) {
        let is_next = self.met.is_multiple_of(1 << self.power);
        self.met += 1;
        if !is_next {
            return;
        }
        self.kept.push(colour());
        if self.kept.len() == MOST {
            let mut place = 0;
            self.kept.retain(|_| {
                place += 1;
                place % 2 == 1
            });
            self.power += 1;
        }
    }

    /// What is kept.
    pub(super) fn take(&mut self) -> Vec<Colour> {
        std::mem::take(&mut self.kept)
    }
}
