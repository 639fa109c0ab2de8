//! What of a log is compared, and how closely.

use crate::trace::Kinds;

/// What is compared, and how closely.
#[derive(Clone, Debug)]
pub struct CheckOptions {
    /// The kinds that are compared; all if `None`.
    pub only: Option<Kinds>,
    /// Two numbers are the same if they differ by at most this, relative to the larger of 1 and the expected one.
    pub tolerance: f64,
}

impl Default for CheckOptions {
    fn default() -> Self {
        Self {
            only: None,
            tolerance: TOLERANCE,
        }
    }
}

/// How far a colour may differ: a quarter of the step between two bytes.
pub(super) const COLOUR: f64 = 1e-3;

/// What six printed digits leave (5·10⁻⁶), and some.
pub const TOLERANCE: f64 = 1e-5;
