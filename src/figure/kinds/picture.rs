//! The picture of a scene with its pixels as squares; the pixels whose trace is drawn are marked.

use crate::figure::drawing::Figure;
use crate::figure::error::FigureError;
use crate::figure::frame::Frame;
use crate::figure::kinds::Kind;
use crate::figure::picture;
use crate::figure::sheet::Sheet;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 460.0,
    usual: &[],
    more: &[],
};

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    if figure.first.picture().iter().all(Option::is_none) {
        return Err(FigureError::new(
            "kind",
            "the log holds the colour of no pixel",
            "trace the figure again",
        ));
    }
    Ok(picture::draw(figure, sheet, body))
}
