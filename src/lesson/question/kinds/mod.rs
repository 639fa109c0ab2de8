//! How a question is answered: a file for each kind.

pub(super) mod blank;
pub(super) mod choices;
pub(super) mod counterexample;
pub(super) mod number;
pub(super) mod order;
pub(super) mod reason;
pub(super) mod step;
mod wrong;
