//! What of the working is shown.

use crate::trace::Kinds;

/// What of the working is shown.
#[derive(Clone, Copy, Debug)]
pub struct WorkedOptions {
    /// The kinds of event.
    pub kinds: Kinds,
    /// The number of the one ray that is shown, with the rays that it spawned in short; absent: all rays.
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
