//! Which trace a stepper goes through and which one a question is about: where both are the same, the question leads to its
//! step.

use crate::explain::{Section, StepAddress};
use crate::lesson::question::fnv_1a;
use crate::page::TracePlace;
use crate::scene::Scene;
use crate::trace::{LogNames, Record, write_event};

/// The trace of a pixel and one of its steps. The trace is named by a hash of its lines in the log, so two traces of a page
/// have one name if all their events are the same. The building of a structure and the paths of light do not count.
///
/// `None` if the event is not one of the pixel itself.
pub(super) fn place_of(scene: &Scene, records: &[Record], event: usize) -> Option<TracePlace> {
    let is_of_pixel = |record: &Record| StepAddress::of(record).section == Section::Pixel;
    let record = records.get(event).filter(|record| is_of_pixel(record))?;
    let names = LogNames::new(scene);
    let mut lines = Vec::new();
    for record in records.iter().filter(|record| is_of_pixel(record)) {
        write_event(record, &names, &mut lines);
        lines.push(b'\n');
    }
    Some(TracePlace {
        trace: format!("{:016x}", fnv_1a(lines.into_iter())),
        step: record.step,
    })
}
