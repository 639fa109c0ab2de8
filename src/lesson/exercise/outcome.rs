//! What came out of a check.

use crate::mistake::Mistake;

/// The four states of an exercise.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// The function, or the part of it that a case needs, is not written.
    NotWritten,
    /// The function panicked, or it did not come back.
    Broken {
        /// What happened.
        what: String,
        /// In which case.
        case: Option<CaseSaid>,
        /// The last cell or node that it visited.
        place: Option<String>,
    },
    /// A quantity differs.
    Wrong(Box<Divergence>),
    /// All quantities of all cases are right.
    Right {
        /// How many cases there were.
        cases: usize,
    },
}

impl Outcome {
    /// The state for programs.
    pub fn state(&self) -> &'static str {
        match self {
            Self::NotWritten => "not written",
            Self::Broken { .. } => "broken",
            Self::Wrong(_) => "wrong",
            Self::Right { .. } => "right",
        }
    }
}

/// A case in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CaseSaid {
    /// Its number, from 1.
    pub number: usize,
    /// What is special in it.
    pub note: String,
    /// What goes in.
    pub given: String,
}

/// The first quantity that differs, in the first case in which one does.
#[derive(Clone, Debug)]
pub struct Divergence {
    /// The case.
    pub case: CaseSaid,
    /// The quantities up to the one that differs, which is the last one.
    pub lines: Vec<Compared>,
    /// In how many cases a quantity differs.
    pub failing: usize,
    /// How many cases there are.
    pub cases: usize,
    /// The mistake that gives these values in all of those cases.
    pub mistake: Option<&'static Mistake>,
    /// Which form of the formula is meant, where the answer is right in another one.
    pub form: Option<&'static str>,
    /// Both answers, as a whole SVG.
    pub picture: String,
}

/// A quantity of both answers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Compared {
    /// The name of the part, or the symbol.
    pub label: String,
    /// Yours.
    pub yours: String,
    /// The right one.
    pub expected: String,
    /// Are they the same?
    pub is_same: bool,
}
