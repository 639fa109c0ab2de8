//! A question with its trace and its facts, as each kind of answer needs it.

use crate::explain::Line;
use crate::lesson::question::facts::Facts;
use crate::lesson::question::fault::Fault;
use crate::lesson::question::shuffled::Shuffle;
use crate::lesson::question::spec::QuestionSpec;
use crate::lesson::question::traced::TracedPixel;
use crate::step::{StepLog, StepWords};
use crate::trace::LogNames;

/// A question with its trace, as each kind of answer needs it.
pub(super) struct Situation<'a> {
    pub(super) spec: &'a QuestionSpec,
    pub(super) traced: &'a TracedPixel,
    pub(super) names: LogNames,
    /// The place of the event that it is about, among the records.
    pub(super) event: usize,
    pub(super) facts: Facts<'a>,
    pub(super) shuffle: Shuffle,
}

impl Situation<'_> {
    /// A text with its expressions filled in.
    pub(super) fn filled(&self, key: &str, text: &str) -> Result<String, Fault> {
        self.facts
            .filled(text)
            .map_err(|what| Fault::text(key, what))
    }

    /// The lines of the worked solution of the step, as they are.
    pub(super) fn step_lines(&self) -> Vec<Line> {
        let log = StepLog::new(
            &self.traced.scene,
            &self.traced.settings,
            &self.traced.records,
        );
        let words = StepWords::new(&log);
        words.of(&log, log.landing(self.event))
    }
}
