//! What is drawn, before it is written: marks and words on a sheet, each with the step that makes it.
//!
//! A kind of figure draws on the sheet and knows nothing of SVG. Words of two sorts: fixed ones stand where they
//! are put (ticks, tables, trees); labels are placed afterwards, where they cross no line and no other words
//! ([`place_labels`](crate::figure::sheet::labels::place_labels)).

use glam::DVec2;

use crate::figure::sheet::font;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;

/// Which point of a line of letters is placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::figure) enum Anchor {
    /// Its left end.
    Start,
    /// Its middle.
    Middle,
    /// Its right end.
    End,
}

/// The form of a mark, in units of the sheet: x to the right, y down.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::figure) enum Form {
    /// A line from point to point; closed, it has an inside.
    Path { points: Vec<DVec2>, closed: bool },
    /// An ellipse with its axes turned, in degrees clockwise.
    Ellipse {
        center: DVec2,
        radii: DVec2,
        turn: f64,
    },
    /// A rectangle along the sheet's edges.
    Rectangle(Frame),
    /// A rectangle of its own colour: a pixel of a picture.
    Pixel { frame: Frame, rgb: [u8; 3] },
    /// An area of its own colour: a pixel that is seen from the side.
    Patch { points: Vec<DVec2>, rgb: [u8; 3] },
}

/// Something drawn.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::figure) struct Mark {
    /// The step of the trace that makes it; `None` for what is there before.
    pub(in crate::figure) step: Option<u32>,
    pub(in crate::figure) look: Look,
    pub(in crate::figure) form: Form,
}

/// A line of letters at its place.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::figure) struct Words {
    pub(in crate::figure) step: Option<u32>,
    pub(in crate::figure) text: String,
    /// The anchor's point, at half the height of a capital.
    pub(in crate::figure) place: DVec2,
    pub(in crate::figure) anchor: Anchor,
    /// Size of the letters.
    pub(in crate::figure) size: f64,
}

/// A line of letters that belongs to a point and is still to be placed.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::figure) struct Label {
    pub(in crate::figure) step: Option<u32>,
    pub(in crate::figure) text: String,
    /// What it names.
    pub(in crate::figure) of: DVec2,
    /// Where it stands best, seen from there.
    pub(in crate::figure) towards: DVec2,
    /// Where it may stand.
    pub(in crate::figure) within: Frame,
    /// Any place in there will do, the corners first.
    pub(in crate::figure) anywhere: bool,
    /// Without room for it, it is left out.
    pub(in crate::figure) optional: bool,
    pub(in crate::figure) size: f64,
}

/// For what a figure is drawn: how large its letters are, against its width.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Width {
    /// A column of a book: 760 units wide, letters of 14, as high as the figure needs.
    #[default]
    Book,
    /// A slide of 16 : 9: 1280 × 720 units, letters of 24.
    Slide,
}

/// A sheet that is being drawn on.
#[derive(Clone, Debug)]
pub(in crate::figure) struct Sheet {
    pub(in crate::figure) size: DVec2,
    /// Size of letters.
    pub(in crate::figure) letters: f64,
    pub(in crate::figure) marks: Vec<Mark>,
    pub(in crate::figure) words: Vec<Words>,
    pub(in crate::figure) labels: Vec<Label>,
    step: Option<u32>,
    cut: Option<Frame>,
}

impl Words {
    /// The rectangle that the letters fill.
    pub(in crate::figure) fn frame(&self) -> Frame {
        let width = font::text_width(&self.text) * self.size;
        let left = match self.anchor {
            Anchor::Start => self.place.x,
            Anchor::Middle => self.place.x - 0.5 * width,
            Anchor::End => self.place.x - width,
        };
        letters_frame(left, self.place.y, width, self.size)
    }
}

/// The rectangle of a line of letters, by its left end and the middle of its capitals.
pub(in crate::figure) fn letters_frame(left: f64, middle: f64, width: f64, size: f64) -> Frame {
    /// From the middle of a capital up and down, in sizes: ascenders reach 0.76 above the line, descenders 0.24
    /// below it (DejaVu Sans), and a capital's middle is 0.36 above.
    const UP: f64 = 0.42;
    const DOWN: f64 = 0.6;
    Frame {
        min: DVec2::new(left, middle - UP * size),
        max: DVec2::new(left + width, middle + DOWN * size),
    }
}

impl Sheet {
    /// An empty sheet; a book's has the height that is asked for.
    pub(in crate::figure) fn new(width: Width, height: f64) -> Self {
        let (size, letters) = match width {
            Width::Book => (DVec2::new(760.0, height), 14.0),
            Width::Slide => (DVec2::new(1280.0, 720.0), 24.0),
        };
        Self {
            size,
            letters,
            marks: Vec::new(),
            words: Vec::new(),
            labels: Vec::new(),
            step: None,
            cut: None,
        }
    }

    /// What there is to draw on: the sheet without its margin.
    pub(in crate::figure) fn body(&self) -> Frame {
        let margin = DVec2::splat(self.letters);
        Frame {
            min: margin,
            max: self.size - margin,
        }
    }

    /// What is drawn inside is made by this step of the trace; after it, what was before is valid again.
    pub(in crate::figure) fn step<T>(
        &mut self,
        step: impl Into<Option<u32>>,
        draw: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let before = std::mem::replace(&mut self.step, step.into());
        let drawn = draw(self);
        self.step = before;
        drawn
    }

    /// Inside, straight lines end at a frame, and points and labels of points outside of it are left out.
    pub(in crate::figure) fn within<T>(
        &mut self,
        frame: Frame,
        draw: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let before = self.cut.replace(frame);
        let drawn = draw(self);
        self.cut = before;
        drawn
    }

    fn is_cut_off(&self, at: DVec2) -> bool {
        self.cut.is_some_and(|frame| !frame.contains(at))
    }

    /// What is left of a straight line.
    fn left_of(&self, ends: [DVec2; 2]) -> Option<[DVec2; 2]> {
        match self.cut {
            Some(frame) => frame.cut_line(ends),
            None => Some(ends),
        }
    }

    /// Lines grow with the letters.
    fn grown(&self, look: Look) -> Look {
        look.wide(look.width * self.unit())
    }

    /// One unit of a book's sheet.
    pub(in crate::figure) fn unit(&self) -> f64 {
        self.letters / 14.0
    }

    pub(in crate::figure) fn mark(&mut self, look: Look, form: Form) {
        let look = self.grown(look);
        self.marks.push(Mark {
            step: self.step,
            look,
            form,
        });
    }

    /// A straight line.
    pub(in crate::figure) fn line(&mut self, look: Look, from: DVec2, to: DVec2) {
        if let Some(ends) = self.left_of([from, to]) {
            self.path(look, ends.into());
        }
    }

    /// A line through points.
    pub(in crate::figure) fn path(&mut self, look: Look, points: Vec<DVec2>) {
        if 2 <= points.len() {
            let closed = false;
            self.mark(look, Form::Path { points, closed });
        }
    }

    /// A polygon.
    pub(in crate::figure) fn polygon(&mut self, look: Look, points: Vec<DVec2>) {
        if 3 <= points.len() {
            let closed = true;
            self.mark(look, Form::Path { points, closed });
        }
    }

    /// A rectangle.
    pub(in crate::figure) fn rectangle(&mut self, look: Look, frame: Frame) {
        self.mark(look, Form::Rectangle(frame));
    }

    /// A circle.
    pub(in crate::figure) fn circle(&mut self, look: Look, center: DVec2, radius: f64) {
        if self.is_cut_off(center) {
            return;
        }
        self.mark(
            look,
            Form::Ellipse {
                center,
                radii: DVec2::splat(radius),
                turn: 0.0,
            },
        );
    }

    /// A point that counts.
    pub(in crate::figure) fn dot(&mut self, look: Look, at: DVec2) {
        self.circle(look.inside().full(), at, 4.0 * self.unit());
    }

    /// A point that does not count: a ring.
    pub(in crate::figure) fn ring(&mut self, look: Look, at: DVec2) {
        let look = Look {
            dash: crate::figure::sheet::look::Dash::Solid,
            ..look.outline()
        };
        self.circle(look, at, 4.0 * self.unit());
    }

    /// A point that is refused: a cross.
    pub(in crate::figure) fn cross(&mut self, look: Look, at: DVec2) {
        let look = Look {
            dash: crate::figure::sheet::look::Dash::Solid,
            ..look.outline()
        };
        let arm = 5.0 * self.unit();
        for arm in [DVec2::new(arm, arm), DVec2::new(arm, -arm)] {
            self.line(look, at - arm, at + arm);
        }
    }

    /// A straight line with a head at its end.
    pub(in crate::figure) fn arrow(&mut self, look: Look, from: DVec2, to: DVec2) {
        let Some([from, to]) = self.left_of([from, to]) else {
            return;
        };
        let Some(along) = (to - from).try_normalize() else {
            return;
        };
        let length = (11.0 * self.unit()).min((to - from).length());
        let base = to - length * along;
        self.line(look, from, base);
        let across = 0.36 * length * along.perp();
        self.polygon(look.inside().full(), vec![to, base + across, base - across]);
    }

    /// A pixel of a picture.
    pub(in crate::figure) fn pixel(&mut self, frame: Frame, rgb: [u8; 3]) {
        self.mark(Look::OBJECT.inside(), Form::Pixel { frame, rgb });
    }

    /// A pixel of a picture that is seen from the side.
    pub(in crate::figure) fn patch(&mut self, points: Vec<DVec2>, rgb: [u8; 3]) {
        self.mark(Look::OBJECT.inside(), Form::Patch { points, rgb });
    }

    /// Letters at a fixed place, in height around it.
    pub(in crate::figure) fn text(
        &mut self,
        anchor: Anchor,
        place: DVec2,
        text: impl Into<String>,
    ) {
        self.words.push(Words {
            step: self.step,
            text: text.into(),
            place,
            anchor,
            size: self.letters,
        });
    }

    /// Lines of letters at the upper edge of a frame; gives back the frame that is left below them.
    pub(in crate::figure) fn lines(&mut self, frame: Frame, texts: &[String]) -> Frame {
        let height = self.line_height();
        for (line, text) in texts.iter().enumerate() {
            let down = DVec2::new(0.0, (line as f64 + 0.5) * height);
            self.text(Anchor::Start, frame.min + down, text.as_str());
        }
        let [_, rest] = frame.split_top((texts.len() as f64 + 0.4) * height);
        rest
    }

    /// A label of a point, best placed in a direction from it.
    pub(in crate::figure) fn label(
        &mut self,
        within: Frame,
        of: DVec2,
        towards: DVec2,
        text: impl Into<String>,
    ) {
        if self.is_cut_off(of) {
            return;
        }
        self.labels.push(Label {
            step: self.step,
            text: text.into(),
            of,
            towards,
            within,
            anywhere: false,
            optional: false,
            size: self.letters,
        });
    }

    /// A label that is left out if there is no room: one name of many.
    pub(in crate::figure) fn name(
        &mut self,
        within: Frame,
        of: DVec2,
        towards: DVec2,
        text: impl Into<String>,
    ) {
        self.label(within, of, towards, text);
        if let Some(label) = self.labels.last_mut() {
            label.optional = true;
        }
    }

    /// A label of an area, anywhere in it: in its upper left corner if that is free.
    pub(in crate::figure) fn label_in(&mut self, area: Frame, text: impl Into<String>) {
        self.labels.push(Label {
            step: self.step,
            text: text.into(),
            of: area.min,
            towards: DVec2::ONE,
            within: area,
            anywhere: true,
            optional: false,
            size: self.letters,
        });
    }

    /// How wide a text is on this sheet.
    pub(in crate::figure) fn width_of(&self, text: &str) -> f64 {
        font::text_width(text) * self.letters
    }

    /// From one line of letters to the next.
    pub(in crate::figure) fn line_height(&self) -> f64 {
        1.5 * self.letters
    }

    /// Says what looks mean, in lines at the lower edge of a frame, and gives back the frame that is left.
    pub(in crate::figure) fn legend(&mut self, frame: Frame, entries: &[(Look, &str)]) -> Frame {
        let swatch = 2.0 * self.letters;
        let gap = 0.5 * self.letters;
        let mut lines: Vec<Vec<(Look, &str, f64)>> = vec![Vec::new()];
        let mut x = 0.0;
        for &(look, text) in entries {
            let width = swatch + gap + self.width_of(text);
            if 0.0 < x && frame.size().x < x + width {
                lines.push(Vec::new());
                x = 0.0;
            }
            if let Some(line) = lines.last_mut() {
                line.push((look, text, x));
            }
            x += width + 2.0 * gap;
        }
        let height = lines.len() as f64 * self.line_height();
        let top = frame.max.y - height;
        for (row, line) in lines.iter().enumerate() {
            let middle = top + (row as f64 + 0.5) * self.line_height();
            for &(look, text, x) in line {
                let left = frame.min.x + x;
                let half = if look.fill == crate::figure::sheet::look::Fill::Empty {
                    0.0
                } else {
                    0.35 * self.letters
                };
                let (min, max) = (
                    DVec2::new(left, middle - half),
                    DVec2::new(left + swatch, middle + half),
                );
                if half == 0.0 {
                    self.line(look, min, max);
                } else {
                    self.rectangle(look, Frame { min, max });
                }
                let place = DVec2::new(left + swatch + gap, middle);
                self.text(Anchor::Start, place, text);
            }
        }
        Frame {
            min: frame.min,
            max: DVec2::new(frame.max.x, top - gap),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_outside_of_the_cut_is_left_out() {
        let mut sheet = Sheet::new(Width::Book, 400.0);
        let frame = Frame {
            min: DVec2::new(100.0, 100.0),
            max: DVec2::new(200.0, 200.0),
        };
        let (inside, outside) = (DVec2::new(150.0, 150.0), DVec2::new(150.0, 250.0));
        sheet.within(frame, |sheet| {
            sheet.line(Look::RAY, inside, outside);
            sheet.dot(Look::RAY, outside);
            sheet.label(frame, outside, DVec2::X, "p");
            let [Mark { form, .. }] = sheet.marks.as_slice() else {
                panic!("{:?}", sheet.marks);
            };
            let points = vec![inside, DVec2::new(150.0, 200.0)];
            let closed = false;
            assert_eq!(*form, Form::Path { points, closed });
            assert!(sheet.labels.is_empty());
        });
        sheet.dot(Look::RAY, outside);
        assert_eq!(sheet.marks.len(), 2);
    }
}
