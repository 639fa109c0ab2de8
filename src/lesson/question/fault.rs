//! What is wrong with a question, and at which of its keys.

use crate::scene::LoadError;

/// What is wrong with a question.
#[derive(Debug)]
pub(in crate::lesson) enum Fault {
    /// A key of the question.
    Key {
        /// The path of the key in the question, as in `at.where`.
        key: String,
        /// What is wrong.
        what: String,
        /// What to do.
        fix: String,
    },
    /// Its scene.
    Load(LoadError),
}

impl Fault {
    pub(in crate::lesson) fn new(
        key: impl Into<String>,
        what: impl Into<String>,
        fix: impl Into<String>,
    ) -> Self {
        Self::Key {
            key: key.into(),
            what: what.into(),
            fix: fix.into(),
        }
    }

    pub(super) fn load(error: LoadError) -> Self {
        Self::Load(error)
    }

    /// An expression or a text that makes no sense.
    pub(super) fn text(key: impl Into<String>, what: String) -> Self {
        Self::new(
            key,
            what,
            "name a field of the step, of a step in \"with\", or of the scene",
        )
    }
}
