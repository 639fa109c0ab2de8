//! What a kind of figure is. Each file in `kinds` has one.

use crate::figure::error::FigureError;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::frame::Frame;
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;

/// A kind of figure.
pub(super) struct Kind {
    /// Draws into a frame of the sheet, and says in words what there is to be seen.
    pub(super) draw: fn(&Figure, &mut Sheet, Frame) -> Result<String, FigureError>,
    /// How high it is in a book's column, in units of the sheet.
    pub(super) height: f64,
    /// What it shows if nothing is said.
    pub(super) usual: &'static [Layer],
    /// What else it can show.
    pub(super) more: &'static [Layer],
}
