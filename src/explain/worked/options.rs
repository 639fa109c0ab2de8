//! What of the working is shown.

use crate::trace::Kinds;

/// What of the working is shown.
#[derive(Clone, Copy, Debug)]
pub struct WorkedOptions {
    /// The kinds of event.
    pub kinds: Kinds,
    /// One ray alone.
    pub ray: Option<u32>,
    /// Every test in full, also where many miss.
    pub all: bool,
}

impl Default for WorkedOptions {
    fn default() -> Self {
        Self {
            kinds: Kinds::ALL,
            ray: None,
            all: false,
        }
    }
}
