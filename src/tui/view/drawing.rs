//! The drawing up to the step: the lines, points and words of the figure on a canvas of letters.

use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::style::{Color, Style};
use ratatui::symbols::Marker;
use ratatui::text::Line as Text;
use ratatui::widgets::Paragraph;
use ratatui::widgets::canvas::{Canvas, Line};

use crate::figure::{Stroke, StrokeForm, StrokeWords, Strokes};
use crate::tui::app::App;
use crate::tui::look::Look;
use crate::tui::view::part::framed;
use crate::tui::view::text::{width, wrapped};

/// How units of the sheet lie on the letters of an area.
struct Fit {
    area: Rect,
    /// The corner of the area, in units of the sheet.
    left: f64,
    top: f64,
    /// Units of the sheet in a column; a row has twice as many, as a letter is twice as high as it is wide.
    column: f64,
}

impl Fit {
    /// The largest one that shows everything, with the drawing in the middle.
    fn of(strokes: &Strokes, area: Rect) -> Option<Self> {
        let points = strokes
            .strokes
            .iter()
            .flat_map(|stroke| match &stroke.form {
                StrokeForm::Line { points, .. } => points.clone(),
                StrokeForm::Point { at, .. } => vec![*at],
            });
        let words = strokes
            .words
            .iter()
            .flat_map(|words| [words.from, words.to]);
        let (mut min, mut max) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in points.chain(words) {
            for axis in 0..2 {
                min[axis] = min[axis].min(point[axis]);
                max[axis] = max[axis].max(point[axis]);
            }
        }
        let size = [max[0] - min[0], max[1] - min[1]];
        let (columns, rows) = (f64::from(area.width), f64::from(area.height));
        if !size.iter().all(|side| side.is_finite()) || columns < 2.0 || rows < 2.0 {
            return None;
        }
        // half a letter stays free at each edge
        let across = size[0] / (columns - 1.0);
        let column = across
            .max(size[1] / (2.0 * (rows - 1.0)))
            .max(f64::MIN_POSITIVE);
        Some(Self {
            area,
            left: f64::midpoint(min[0], max[0]) - 0.5 * column * columns,
            top: f64::midpoint(min[1], max[1]) - column * rows,
            column,
        })
    }

    /// The letter at a point, counted from the corner of the area.
    fn letter(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            ((x - self.left) / self.column).floor(),
            ((y - self.top) / (2.0 * self.column)).floor(),
        ]
    }
}

/// Draws the figure of the step, or says why there is none.
pub(super) fn draw(app: &App<'_, '_>, look: Look, area: Rect, frame: &mut Frame<'_>) {
    let drawn = match &app.drawn {
        Some(Ok(drawn)) => &drawn.strokes,
        none => {
            let inside = framed("drawing", look, area, frame);
            let why = match none {
                Some(Err(why)) => why.as_str(),
                _ => "",
            };
            let lines = wrapped(why, usize::from(inside.width), 0).into_iter();
            let lines: Vec<Text> = lines.map(Text::from).collect();
            frame.render_widget(Paragraph::new(lines).style(Look::faint()), inside);
            return;
        }
    };
    let inside = framed("drawing up to here", look, area, frame);
    let far = app.far();
    let Some(fit) = Fit::of(drawn, inside) else {
        return;
    };
    let strokes = drawn.strokes.iter().filter(|of| of.is_there(far));
    let strokes: Vec<&Stroke> = strokes.collect();
    lines(&strokes, &fit, look, frame);
    let taken = points(&strokes, &fit, look, frame);
    let words = drawn.words.iter().filter(|of| of.are_there(far));
    set_words(&words.collect::<Vec<_>>(), &fit, taken, frame);
}

fn lines(strokes: &[&Stroke], fit: &Fit, look: Look, frame: &mut Frame<'_>) {
    let (columns, rows) = (f64::from(fit.area.width), f64::from(fit.area.height));
    // the canvas counts y upwards
    let bounds_y = [-(fit.top + 2.0 * fit.column * rows), -fit.top];
    let canvas = Canvas::default()
        .marker(if look.is_ascii {
            Marker::Custom('.')
        } else {
            Marker::Braille
        })
        .x_bounds([fit.left, fit.left + fit.column * columns])
        .y_bounds(bounds_y)
        .paint(|context| {
            for stroke in strokes {
                let StrokeForm::Line { points, is_dashed } = &stroke.form else {
                    continue;
                };
                let colour = look.figure(stroke.colour);
                let pieces = if *is_dashed {
                    dashes(points, 1.5 * fit.column)
                } else {
                    points.windows(2).map(|ends| [ends[0], ends[1]]).collect()
                };
                for [[x1, y1], [x2, y2]] in pieces {
                    context.draw(&Line::new(x1, -y1, x2, -y2, colour));
                }
            }
        });
    frame.render_widget(canvas, fit.area);
}

/// Every second piece of a line.
fn dashes(points: &[[f64; 2]], length: f64) -> Vec<[[f64; 2]; 2]> {
    /// No drawing has more of them: a line far out of the sheet is cut there.
    const MOST: usize = 2000;
    let mut pieces = Vec::new();
    let mut walked = 0.0;
    for ends in points.windows(2) {
        let [a, b] = [ends[0], ends[1]];
        let whole = (b[0] - a[0]).hypot(b[1] - a[1]);
        let at = |along: f64| {
            let share = if whole == 0.0 { 0.0 } else { along / whole };
            [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]
        };
        let mut along = 0.0;
        while along < whole && pieces.len() < MOST {
            let place = walked + along;
            let next = ((place / length).floor() + 1.0) * length - walked;
            let next = next.clamp(along + 0.01 * length, whole.max(along + 0.01 * length));
            if (place / length).floor() as i64 % 2 == 0 {
                pieces.push([at(along), at(next.min(whole))]);
            }
            along = next;
        }
        walked += whole;
    }
    pieces
}

/// Letters that are taken, by column and row.
type Taken = Vec<[f64; 2]>;

fn points(strokes: &[&Stroke], fit: &Fit, look: Look, frame: &mut Frame<'_>) -> Taken {
    let mut taken = Taken::new();
    for stroke in strokes {
        let StrokeForm::Point { at, is_full } = stroke.form else {
            continue;
        };
        let letter = match (is_full, look.is_ascii) {
            (true, false) => "●",
            (false, false) => "○",
            (true, true) => "*",
            (false, true) => "o",
        };
        let place = fit.letter(at);
        if set(
            fit,
            place,
            letter,
            Style::new().fg(look.figure(stroke.colour)),
            frame,
        ) {
            taken.push(place);
        }
    }
    taken
}

/// Writes letters that lie inside the area.
fn set(fit: &Fit, [x, y]: [f64; 2], text: &str, style: Style, frame: &mut Frame<'_>) -> bool {
    let fits = 0.0 <= x
        && 0.0 <= y
        && x + width(text) as f64 <= f64::from(fit.area.width)
        && y < f64::from(fit.area.height);
    if fits {
        let (x, y) = (fit.area.x + x as u16, fit.area.y + y as u16);
        frame.buffer_mut().set_string(x, y, text, style);
    }
    fits
}

/// Words that go on where others end, as one.
fn joined(words: &[&StrokeWords]) -> Vec<StrokeWords> {
    /// Less than a blank.
    const APART: f64 = 2.0;
    let goes_on = |words: &StrokeWords, before: &StrokeWords| {
        words.from[1] == before.to[1] && (words.from[0] - before.to[0]).abs() <= APART
    };
    let mut all: Vec<StrokeWords> = Vec::new();
    for words in words {
        match all.iter_mut().find(|before| goes_on(words, before)) {
            Some(before) => {
                before.text.push_str(&words.text);
                before.to = words.to;
                before.step = before.step.max(words.step);
            }
            None => all.push((*words).clone()),
        }
    }
    all
}

/// Words where nothing else is written, those of the last step first; others are left out. Letters are wider here than in the
/// figure.
fn set_words(words: &[&StrokeWords], fit: &Fit, mut taken: Taken, frame: &mut Frame<'_>) {
    let mut words = joined(words);
    words.sort_by_key(|words| std::cmp::Reverse(words.step));
    for words in &words {
        let letters = width(&words.text) as f64;
        let middle = words.anchor * (words.to[0] - words.from[0]) + words.from[0];
        let [x, y] = fit.letter([middle, words.from[1]]);
        let last = f64::from(fit.area.width) - letters;
        let x = (x - (words.anchor * letters).floor()).clamp(0.0, last.max(0.0));
        let is_free = |y: f64| {
            !taken
                .iter()
                .any(|&[column, row]| row == y && x - 1.0 <= column && column <= x + letters)
        };
        let rows = [y, y - 1.0, y + 1.0];
        let Some(row) = rows.into_iter().find(|&row| 0.0 <= row && is_free(row)) else {
            continue;
        };
        if set(
            fit,
            [x, row],
            &words.text,
            Style::new().fg(Color::Reset),
            frame,
        ) {
            taken.extend((0..letters as usize).map(|place| [x + place as f64, row]));
        }
    }
}
