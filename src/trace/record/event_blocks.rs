//! Events kept in memory that is used again.

use crate::trace::record::recorder::Numbering;
use crate::trace::{Event, Record, Recorder};

/// How many events a block holds: at 128 bytes each, half of a second-level cache of 256 kB.
const BLOCK: usize = 1024;

/// Keeps every event; the fastest way to record.
///
/// The number of an event and the ray it belongs to follow from the order of the events alone. So the
/// events are kept as they come, and numbered when they are asked for.
///
/// The list grows by whole blocks, and keeps them when it is emptied. A list in one piece moves all it
/// holds whenever it grows, and memory that the system hands out for the first time costs more than the
/// event put into it: who records many pixels empties the list after each, and pays for neither.
#[derive(Clone, Debug, Default)]
pub struct EventBlocks {
    full: Vec<Vec<Event>>,
    /// The block that is being filled.
    filling: Vec<Event>,
    /// Emptied blocks.
    spare: Vec<Vec<Event>>,
}

impl EventBlocks {
    /// How many events there are.
    pub fn len(&self) -> usize {
        self.full.len() * BLOCK + self.filling.len()
    }

    /// Is there none?
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Forgets the events and keeps their memory.
    pub fn clear(&mut self) {
        self.filling.clear();
        for mut block in self.full.drain(..) {
            block.clear();
            self.spare.push(block);
        }
    }

    /// The events in their order, each with its place in its pixel's trace.
    pub fn records(&self) -> impl Iterator<Item = Record> {
        let events = self.full.iter().flatten().chain(&self.filling);
        let mut numbering = Numbering::default();
        events.map(move |event| numbering.number(*event))
    }

    /// Puts the full block away and takes an empty one.
    #[cold]
    fn next_block(&mut self) {
        let empty = self.spare.pop();
        let empty = empty.unwrap_or_else(|| Vec::with_capacity(BLOCK));
        let full = std::mem::replace(&mut self.filling, empty);
        // before the first event there was no block at all
        if !full.is_empty() {
            self.full.push(full);
        }
    }
}

impl Recorder for EventBlocks {
    const ENABLED: bool = true;

    #[inline]
    fn note(&mut self, event: impl FnOnce() -> Event) {
        if self.filling.len() == self.filling.capacity() {
            self.next_block();
        }
        self.filling.push(event());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::{PixelSample, RayEnd, RayStart, Recording};

    /// A pixel whose only ray is tested against nothing, again and again: 3 events each.
    fn note_pixels(count: u32, recorder: &mut impl Recorder) {
        for x in 0..count {
            recorder.note(|| {
                Event::Pixel(PixelSample {
                    pixel: [x, 0],
                    ..PixelSample::default()
                })
            });
            recorder.note(|| Event::Ray(RayStart::default()));
            recorder.note(|| Event::RayEnd(RayEnd::default()));
        }
    }

    #[test]
    fn the_records_are_those_of_a_recording() {
        let mut blocks = EventBlocks::default();
        let mut recording = Recording::new(Vec::new());
        note_pixels(BLOCK as u32, &mut blocks);
        note_pixels(BLOCK as u32, &mut recording);
        assert_eq!(blocks.len(), 3 * BLOCK);
        assert!(blocks.records().eq(recording.into_sink()));
    }

    #[test]
    fn emptied_blocks_are_filled_again() {
        let mut blocks = EventBlocks::default();
        note_pixels(2 * BLOCK as u32, &mut blocks);
        let had = blocks.full.len();
        blocks.clear();
        assert!(blocks.is_empty());
        assert_eq!(blocks.records().count(), 0);
        note_pixels(2 * BLOCK as u32, &mut blocks);
        assert_eq!((blocks.full.len(), blocks.spare.len()), (had, 0));
        assert_eq!(blocks.records().count(), 6 * BLOCK);
    }
}
