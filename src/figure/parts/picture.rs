//! The output image: each pixel a square of its colour, the traced ones marked.

use glam::{DVec2, DVec3};

use crate::figure::heat_map::Rgb;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::subject::Figure;

/// Draws the picture at the right of a frame, and gives back what is left of the frame.
pub(in crate::figure) fn beside(figure: &Figure, sheet: &mut Sheet, frame: Frame) -> Frame {
    /// Of the width: the figure itself is what matters.
    const SHARE: f64 = 0.64;
    let [left, right] = frame.split(SHARE, 2.0 * sheet.letters);
    draw(figure, sheet, right);
    left
}

/// Draws the picture as large as the frame allows, and says what it is.
pub(in crate::figure) fn draw(figure: &Figure, sheet: &mut Sheet, frame: Frame) -> String {
    let [width, height] = figure.scene.camera.pixels;
    let line = sheet.line_height();
    let room = Frame {
        min: frame.min,
        max: frame.max - DVec2::new(0.0, line),
    };
    let rgb = |colour: DVec3| (colour * 255.0).round().to_array().map(|of| of as u8);
    let colours: Vec<Option<Rgb>> = figure
        .first
        .picture()
        .into_iter()
        .map(|of| of.map(rgb))
        .collect();
    let squares = squares(sheet, room, [width, height], &colours);
    let at = |x: u32, y: u32| squares.at(x, y);
    let whole = squares.whole;
    let mut marked = Vec::new();
    for [x, y] in figure.pixels() {
        let pixel = Frame {
            min: at(x, y),
            max: at(x + 1, y + 1),
        };
        // on any colour: dark inside light
        let around = pixel.wider(2.0 * sheet.unit());
        sheet.rectangle(Look::PAPER_LINE, around);
        sheet.rectangle(Look::THIN.wide(1.5), pixel.wider(1.0 * sheet.unit()));
        marked.push(format!("({x}, {y})"));
    }
    let caption = match marked.as_slice() {
        [] => format!("{width} × {height} pixels"),
        [one] => format!("pixel {one} of {width} × {height}"),
        several => format!("pixels {} of {width} × {height}", several.join(", ")),
    };
    let below = DVec2::new(room.middle().x, whole.max.y + 0.75 * line);
    sheet.text(crate::figure::sheet::Anchor::Middle, below, caption.clone());
    format!("The picture of the scene, {caption}.")
}

/// A picture's pixels as squares on a sheet.
pub(in crate::figure) struct Squares {
    /// What is around all of them.
    pub(in crate::figure) whole: Frame,
    side: f64,
}

impl Squares {
    /// The upper left corner of a pixel.
    pub(in crate::figure) fn at(&self, x: u32, y: u32) -> DVec2 {
        self.whole.min + self.side * DVec2::new(f64::from(x), f64::from(y))
    }
}

/// Draws pixels as squares in the middle of a frame, as large as it allows; `None` where nothing is known.
pub(in crate::figure) fn squares(
    sheet: &mut Sheet,
    room: Frame,
    [width, height]: [u32; 2],
    colours: &[Option<Rgb>],
) -> Squares {
    let pixels = DVec2::new(f64::from(width), f64::from(height));
    let side = (room.size() / pixels).min_element();
    let half = 0.5 * side * pixels;
    let squares = Squares {
        whole: Frame {
            min: room.middle() - half,
            max: room.middle() + half,
        },
        side,
    };
    // each square reaches a little under the next ones, so that no seam of the ground shows between them
    let under = |corner: DVec2| (corner + 0.5).min(squares.whole.max);
    for (y, row) in (0..).zip(colours.chunks(width as usize)) {
        // pixels of one colour beside each other are one rectangle
        let mut x = 0;
        for run in row.chunk_by(|a, b| a == b) {
            let end = x + run.len() as u32;
            if let Some(Some(rgb)) = run.first() {
                let frame = Frame {
                    min: squares.at(x, y),
                    max: under(squares.at(end, y + 1)),
                };
                sheet.pixel(frame, *rgb);
            }
            x = end;
        }
    }
    sheet.rectangle(Look::THIN, squares.whole);
    squares
}
