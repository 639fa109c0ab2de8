//! Who hears how far a check has come, in case it does not come to an end.

/// Hears about each case before it begins, and about each cell or node that a function visits.
pub trait Watch {
    /// A case begins, counted from 1.
    fn case(&self, number: usize, note: &str) {
        let _ = (number, note);
    }

    /// A function visits a cell or a node.
    fn place(&self, place: &str) {
        let _ = place;
    }

    /// In which line of which file the last panic was, if anybody knows.
    fn panicked_at(&self) -> Option<String> {
        None
    }
}

/// Hears nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Watch for Silent {}
