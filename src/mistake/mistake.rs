//! A mistake with its name.

use crate::mistake::Wrong;

/// What students write instead of a function.
#[derive(Clone, Copy, Debug)]
pub struct Mistake {
    /// Its name, in a few words.
    pub name: &'static str,
    /// What it does wrong, in one sentence that a student reads.
    pub sentence: &'static str,
    /// The quantity that it spoils, in the word of the worked solution.
    pub spoils: &'static str,
    /// The wrong function. It tells which right one it replaces.
    pub wrong: Wrong,
}
