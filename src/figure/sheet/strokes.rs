//! A finished sheet as lines, points and words: for a face that draws by itself and knows no SVG, such as a terminal.
//!
//! They are the same marks as in the SVG, at the same places. It leaves out what such a face cannot show: areas, pictures, gaps
//! and sizes of letters.

use glam::DVec2;

use crate::figure::drawn_up_to::Far;
use crate::figure::sheet::crop;
use crate::figure::sheet::labels::place_labels;
use crate::figure::sheet::look::{Colour, Dash, Fill};
use crate::figure::sheet::text::{Level, Run};
use crate::figure::sheet::{Anchor, Form, Mark, Sheet, Words};

/// A drawing as lines, points and words, in units of its sheet: x to the right, y down.
#[derive(Clone, Debug, PartialEq)]
pub struct Strokes {
    /// The upper left corner of what is drawn.
    pub min: [f64; 2],
    /// The lower right corner.
    pub max: [f64; 2],
    /// Lines and points; what comes later lies above.
    pub strokes: Vec<Stroke>,
    /// Words.
    pub words: Vec<StrokeWords>,
}

/// A line or a point of a strokes.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// The step of the trace that makes it; `None` for what is there before.
    pub step: Option<u32>,
    /// What the colour says.
    pub colour: Colour,
    /// Its form.
    pub form: StrokeForm,
}

/// The form of a stroke.
#[derive(Clone, Debug, PartialEq)]
pub enum StrokeForm {
    /// A line from point to point.
    Line {
        /// The points; of a closed line the first one is the last one too.
        points: Vec<[f64; 2]>,
        /// Is it dashed or dotted?
        is_dashed: bool,
    },
    /// A point.
    Point {
        /// Where it is.
        at: [f64; 2],
        /// Is it filled? A ring is a point that does not count.
        is_full: bool,
    },
}

/// Words of a strokes.
#[derive(Clone, Debug, PartialEq)]
pub struct StrokeWords {
    /// The step of the trace that makes them; `None` for what is there before.
    pub step: Option<u32>,
    /// The letters in one line.
    pub text: String,
    /// The left end, at half the height of a capital.
    pub from: [f64; 2],
    /// The right end.
    pub to: [f64; 2],
    /// Which share of their width lies left of what they name or of the place where they were put: 0, ½ or 1.
    pub anchor: f64,
}

/// Is something there that a step of the trace makes, when the figure is drawn so far?
fn is_there(step: Option<u32>, far: Far) -> bool {
    step.is_none_or(|step| match far {
        Far::Nothing => false,
        Far::Step(last) => step <= last,
        Far::Whole => true,
    })
}

impl Stroke {
    /// Is it there when the figure is drawn so far?
    pub fn is_there(&self, far: Far) -> bool {
        is_there(self.step, far)
    }
}

impl StrokeWords {
    /// Are they there when the figure is drawn so far?
    pub fn are_there(&self, far: Far) -> bool {
        is_there(self.step, far)
    }
}

impl Strokes {
    /// What is drawn on a sheet.
    pub(in crate::figure) fn of(mut sheet: Sheet) -> Self {
        place_labels(&mut sheet);
        let shown = crop::shown(&sheet);
        let mut marks: Vec<&Mark> = sheet.marks.iter().collect();
        // as in the SVG: without a stage or a step comes first
        marks.sort_by_key(|mark| mark.since);
        Self {
            min: shown.min.to_array(),
            max: shown.max.to_array(),
            strokes: marks
                .into_iter()
                .filter_map(|mark| stroke(mark, sheet.unit()))
                .collect(),
            words: sheet.words.iter().map(words).collect(),
        }
    }
}

/// A mark as a stroke; `None` of an area without an edge and of what covers others.
fn stroke(mark: &Mark, unit: f64) -> Option<Stroke> {
    /// The largest radius of a point, in units of a book's sheet: a point that counts has 4.
    const POINT: f64 = 5.0;
    let look = mark.look;
    let has_edge = 0.0 < look.width || look.fill == Fill::Full;
    if look.colour == Colour::Paper || !has_edge {
        return None;
    }
    let line = |points: Vec<DVec2>, closed: bool| {
        let mut points: Vec<[f64; 2]> = points.into_iter().map(|of| of.to_array()).collect();
        if closed {
            points.extend(points.first().copied());
        }
        StrokeForm::Line {
            points,
            is_dashed: look.dash != Dash::Solid,
        }
    };
    let form = match &mark.form {
        Form::Path { points, closed } | Form::OnPicture { points, closed, .. } => {
            line(points.clone(), *closed)
        }
        Form::Rectangle(frame) => line(frame.corners().to_vec(), true),
        Form::Image {
            corners: [corner, right, below],
            ..
        } => line(
            vec![*corner, *right, *right + *below - *corner, *below],
            true,
        ),
        Form::Ellipse { center, radii, .. } if radii.max_element() <= POINT * unit => {
            StrokeForm::Point {
                at: center.to_array(),
                is_full: look.fill == Fill::Full,
            }
        }
        Form::Ellipse {
            center,
            radii,
            turn,
        } => line(around(*center, *radii, *turn), true),
    };
    Some(Stroke {
        step: mark.since.step,
        colour: look.colour,
        form,
    })
}

/// Points on an ellipse whose axes are turned, in degrees clockwise.
fn around(center: DVec2, radii: DVec2, turn: f64) -> Vec<DVec2> {
    /// On a circle as wide as the sheet a piece is a tenth of it.
    const PIECES: u32 = 64;
    let turn = turn.to_radians();
    let (x, y) = (libm::cos(turn), libm::sin(turn));
    let point = |piece: u32| {
        let angle = f64::from(piece) / f64::from(PIECES) * std::f64::consts::TAU;
        let on = radii * DVec2::new(libm::cos(angle), libm::sin(angle));
        center + DVec2::new(x * on.x - y * on.y, y * on.x + x * on.y)
    };
    (0..PIECES).map(point).collect()
}

fn words(of: &Words) -> StrokeWords {
    let frame = of.frame();
    StrokeWords {
        step: of.since.step,
        text: of.text.runs.iter().map(letters).collect(),
        from: [frame.min.x, of.place.y],
        to: [frame.max.x, of.place.y],
        anchor: match of.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5,
            Anchor::End => 1.0,
        },
    }
}

/// Letters in one size: digits of an index and an exponent have letters of their own.
fn letters(run: &Run) -> String {
    const INDICES: [char; 10] = ['₀', '₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'];
    const EXPONENTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digits = match run.level {
        Level::Line => return run.letters.clone(),
        Level::Index => INDICES,
        Level::Exponent => EXPONENTS,
    };
    let small = |letter: char| {
        letter
            .to_digit(10)
            .map_or(letter, |digit| digits[digit as usize])
    };
    run.letters.chars().map(small).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::sheet::Width;
    use crate::figure::sheet::look::Look;

    #[test]
    fn marks_are_strokes_in_the_order_of_their_steps_and_areas_are_left_out() {
        let mut sheet = Sheet::new(Width::Book, 100.0);
        let at = |x: f64, y: f64| DVec2::new(x, y);
        sheet.step(7, |sheet| sheet.dot(Look::ANSWER, at(10.0, 20.0)));
        sheet.line(Look::HELP, at(0.0, 0.0), at(30.0, 40.0));
        sheet.step(3, |sheet| {
            sheet.polygon(Look::RAY, vec![at(0.0, 0.0), at(6.0, 0.0), at(0.0, 6.0)]);
        });
        sheet.circle(Look::PAPER_LINE, at(50.0, 50.0), 9.0);
        sheet.text(Anchor::End, at(60.0, 50.0), "t");
        let strokes = Strokes::of(sheet);
        let line = |points: &[[f64; 2]], is_dashed| StrokeForm::Line {
            points: points.into(),
            is_dashed,
        };
        let forms: Vec<_> = strokes
            .strokes
            .iter()
            .map(|of| (of.step, of.form.clone()))
            .collect();
        let point = StrokeForm::Point {
            at: [10.0, 20.0],
            is_full: true,
        };
        let triangle = [[0.0, 0.0], [6.0, 0.0], [0.0, 6.0], [0.0, 0.0]];
        assert_eq!(
            forms,
            [
                (None, line(&[[0.0, 0.0], [30.0, 40.0]], true)),
                (Some(3), line(&triangle, false)),
                (Some(7), point),
            ]
        );
        let there = |far| {
            let strokes = strokes.strokes.iter();
            strokes.filter(|of| of.is_there(far)).count()
        };
        let all = [Far::Nothing, Far::Step(3), Far::Whole].map(there);
        assert_eq!(all, [1, 2, 3]);
        let [words] = &strokes.words[..] else {
            panic!("{:?}", strokes.words);
        };
        assert_eq!(
            (words.text.as_str(), words.to, words.anchor),
            ("t", [60.0, 50.0], 1.0)
        );
    }

    #[test]
    fn an_ellipse_goes_through_the_ends_of_its_axes() {
        // turned by 90°: the axis of 20 points down
        let points = around(DVec2::new(100.0, 100.0), DVec2::new(20.0, 10.0), 90.0);
        for end in [[100.0, 120.0], [90.0, 100.0], [100.0, 80.0], [110.0, 100.0]] {
            let end = DVec2::from(end);
            assert!(points.iter().any(|of| of.distance(end) < 1e-9), "{end}");
        }
    }
}
