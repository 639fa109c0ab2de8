//! The picture of a scene with its pixels as squares; the pixels whose trace is drawn are marked.

use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::picture;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::frame::Frame;
use crate::figure::subject::Figure;

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
            "the log has no colour of a pixel",
            "trace the figure again",
        ));
    }
    Ok(picture::draw(figure, sheet, body))
}
