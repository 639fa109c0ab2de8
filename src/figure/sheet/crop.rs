//! What of a sheet is shown: a book's is as high as what is drawn on it, a slide keeps its form.
//!
//! Every step counts, so that a figure up to a step has the size of the whole figure.

use glam::DVec2;

use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::{Form, Mark, Sheet, Width, Words};

/// The part of a finished sheet that is shown, in whole units: its full width, and the height of what is drawn with a margin
/// of one letter above and below.
pub(in crate::figure) fn shown(sheet: &Sheet) -> Frame {
    let whole = Frame {
        min: DVec2::ZERO,
        max: sheet.size,
    };
    if sheet.width == Width::Slide {
        return whole;
    }
    let marks = sheet.marks.iter().filter_map(extent);
    let drawn = marks.chain(sheet.words.iter().map(Words::frame));
    let corners = drawn.flat_map(|frame| [frame.min, frame.max]);
    let Some(drawn) = Frame::around(corners) else {
        return whole;
    };
    let top = (drawn.min.y - sheet.letters).floor();
    let bottom = (drawn.max.y + sheet.letters).ceil();
    Frame {
        min: DVec2::new(0.0, top.max(0.0)),
        max: DVec2::new(sheet.size.x, bottom.min(sheet.size.y)),
    }
}

/// The rectangle that a mark fills, its line included.
fn extent(mark: &Mark) -> Option<Frame> {
    let (inside, line) = match &mark.form {
        Form::Path { points, .. } => (Frame::around(points.iter().copied()), mark.look.width),
        Form::OnPicture { points, width, .. } => (Frame::around(points.iter().copied()), *width),
        Form::Rectangle(frame) => (Some(*frame), mark.look.width),
        Form::Image { corners, .. } => {
            let [corner, right, below] = *corners;
            (
                Frame::around([corner, right, below, right + below - corner]),
                0.0,
            )
        }
        Form::Ellipse {
            center,
            radii,
            turn,
        } => {
            let turn = turn.to_radians();
            let (sin, cos) = (libm::sin(turn), libm::cos(turn));
            let half = DVec2::new(
                (radii * DVec2::new(cos, sin)).length(),
                (radii * DVec2::new(sin, cos)).length(),
            );
            let (min, max) = (center - half, center + half);
            (Some(Frame { min, max }), mark.look.width)
        }
    };
    Some(inside?.wider(0.5 * line))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::sheet::look::Look;
    use crate::figure::sheet::{Anchor, Since};

    fn sheet(width: Width) -> Sheet {
        let mut sheet = Sheet::new(width, 500.0);
        let (min, max) = (DVec2::new(200.0, 150.0), DVec2::new(300.0, 250.0));
        sheet.rectangle(Look::OBJECT.wide(2.0), Frame { min, max });
        sheet
    }

    #[test]
    fn a_books_sheet_is_as_high_as_what_is_drawn_and_keeps_its_width() {
        // half of a line of 2 units around the rectangle, and a letter of 14 units
        let mut sheet = sheet(Width::Book);
        let expected = Frame {
            min: DVec2::new(0.0, 135.0),
            max: DVec2::new(760.0, 265.0),
        };
        assert_eq!(shown(&sheet), expected);
        // a capital is 0.72 high, and letters reach 0.6 below its middle: 300 + 0.6·14 + 14 = 322.4
        sheet.text(Anchor::Middle, DVec2::new(400.0, 300.0), "Q");
        assert_eq!(shown(&sheet).max.y, 323.0);
        // what a later step draws counts too, and nothing goes beyond the sheet
        sheet.step(9, |sheet| {
            sheet.line(Look::RAY, DVec2::ZERO, DVec2::new(5.0, 499.0));
        });
        let whole = Frame {
            min: DVec2::ZERO,
            max: DVec2::new(760.0, 500.0),
        };
        assert_eq!(shown(&sheet), whole);
    }

    #[test]
    fn a_slide_and_an_empty_sheet_keep_their_size() {
        assert_eq!(shown(&sheet(Width::Slide)).max, DVec2::new(1280.0, 720.0));
        let empty = Sheet::new(Width::Book, 120.0);
        assert_eq!(shown(&empty).max, DVec2::new(760.0, 120.0));
    }

    #[test]
    fn a_turned_ellipse_reaches_as_far_as_its_longer_radius() {
        let ellipse = |turn| Mark {
            since: Since::default(),
            look: Look::OBJECT.inside(),
            form: Form::Ellipse {
                center: DVec2::new(50.0, 50.0),
                radii: DVec2::new(30.0, 10.0),
                turn,
            },
        };
        let half = |turn| 0.5 * extent(&ellipse(turn)).unwrap().size();
        assert!((half(0.0) - DVec2::new(30.0, 10.0)).length() < 1e-9);
        assert!((half(90.0) - DVec2::new(10.0, 30.0)).length() < 1e-9);
        // at 45° both extents are √((30² + 10²)/2)
        assert!((half(45.0) - DVec2::splat(500f64.sqrt())).length() < 1e-9);
    }
}
