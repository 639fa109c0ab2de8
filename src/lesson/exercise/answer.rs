//! What a function gave in a case: the quantities in the order in which they are worked out.

use crate::explain::Part;
use crate::lesson::exercise::Value;

/// The quantities of an answer, each with the part that it belongs to and its symbol; the symbol is empty where the part
/// has one quantity.
pub type Answer = Vec<(Part, &'static str, Value)>;

/// An answer of one quantity.
pub fn answer(part: Part, value: impl Into<Value>) -> Answer {
    vec![(part, "", value.into())]
}

/// The first quantity that differs.
pub(super) fn first_difference(yours: &Answer, expected: &Answer) -> Option<usize> {
    let pairs = yours.iter().zip(expected);
    pairs
        .into_iter()
        .position(|(yours, expected)| !yours.2.is_same(&expected.2))
}

/// Are all quantities the same, those that are no numbers as well?
pub(super) fn is_same_answer(yours: &Answer, other: &Answer) -> bool {
    yours.len() == other.len() && {
        let mut pairs = yours.iter().zip(other);
        pairs.all(|(yours, other)| yours.2.is_same(&other.2) || yours.2.is_no_number_like(&other.2))
    }
}

/// How a quantity is called in a message.
pub(super) fn label(part: Part, symbol: &str) -> String {
    if symbol.is_empty() {
        part.name().into()
    } else {
        symbol.into()
    }
}
