//! A picture with two answers: what is given in ink, the expected answer in green, the other one in orange.

use glam::{DVec2, DVec3};

use crate::figure::sheet::canvas::{Canvas, Rendition};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::{Anchor, Sheet, Width};

/// Whose mark it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whose {
    /// It belongs to the case.
    Given,
    /// It is the answer to be checked.
    Yours,
    /// It is the right answer.
    Expected,
}

/// What is drawn, in world coordinates.
#[derive(Clone, Debug, PartialEq)]
pub enum SketchForm {
    /// A point.
    Dot(DVec3),
    /// A vector with its foot and its head.
    Arrow(DVec3, DVec3),
    /// A piece of a line.
    Line(DVec3, DVec3),
    /// A sphere, by its center and radius.
    Circle(DVec3, f64),
    /// A closed outline.
    Outline(Vec<DVec3>),
}

/// A mark with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct SketchMark {
    /// What is drawn.
    pub form: SketchForm,
    /// The text beside it; empty if there is none.
    pub name: String,
}

impl SketchForm {
    /// The points that must be on the sheet.
    fn reach(&self) -> Vec<DVec3> {
        match self {
            Self::Dot(at) => vec![*at],
            Self::Arrow(from, to) | Self::Line(from, to) => vec![*from, *to],
            Self::Circle(center, radius) => vec![*center - *radius, *center + *radius],
            Self::Outline(points) => points.clone(),
        }
    }
}

/// Height of the drawing, in units of the sheet.
const HEIGHT: f64 = 300.0;

/// Draws the marks in the plane of the two axes along which they reach furthest, with the legend and the numbers below.
///
/// Marks that are not finite are left out. `numbers` are lines of text; `id` begins all ids of the SVG.
pub fn sketch(
    id: &str,
    [title, description]: [&str; 2],
    marks: &[(Whose, SketchMark)],
    numbers: &[(Whose, String)],
) -> String {
    let finite = |mark: &&(Whose, SketchMark)| mark.1.form.reach().iter().all(|p| p.is_finite());
    let marks: Vec<&(Whose, SketchMark)> = marks.iter().filter(finite).collect();
    let mut sheet = Sheet::new(Width::Book, HEIGHT);
    let line = sheet.line_height();
    sheet.size.y += line * (numbers.len() as f64 + 3.0);
    let body = sheet.body();
    let frame = Frame {
        min: body.min + DVec2::splat(line),
        max: DVec2::new(body.max.x - line, body.min.y + HEIGHT - line),
    };
    let place = Place::of(&marks, frame);
    // the expected answer is drawn first: where both are the same the other one is seen on it, dashed
    for whose in [Whose::Given, Whose::Expected, Whose::Yours] {
        for (_, mark) in marks.iter().filter(|mark| mark.0 == whose) {
            draw(&mut sheet, frame, &place, whose, mark);
        }
    }
    let mut at = DVec2::new(body.min.x, body.min.y + HEIGHT + line);
    for (whose, words) in [(Whose::Yours, "yours"), (Whose::Expected, "expected")] {
        sheet.line(look(whose), at, at + DVec2::new(2.0 * line, 0.0));
        at.x += 2.5 * line;
        sheet.text(Anchor::Start, at, words);
        at.x += sheet.width_of(words) + line;
    }
    sheet.text(Anchor::Start, at, place.axes());
    let mut at = DVec2::new(body.min.x, at.y + 1.2 * line);
    for (whose, words) in numbers {
        if *whose != Whose::Given {
            sheet.dot(look(*whose), at + DVec2::new(0.3 * line, 0.0));
        }
        sheet.text(Anchor::Start, at + DVec2::new(line, 0.0), words.as_str());
        at.y += line;
    }
    let rendition = Rendition {
        standalone: true,
        ..Rendition::default()
    };
    Canvas::write(sheet, id, [title, description], rendition)
}

fn look(whose: Whose) -> Look {
    match whose {
        Whose::Given => Look::OBJECT,
        Whose::Yours => Look::REJECTED,
        Whose::Expected => Look::ANSWER,
    }
}

fn draw(sheet: &mut Sheet, frame: Frame, place: &Place, whose: Whose, mark: &SketchMark) {
    let look = look(whose);
    let at = |point: DVec3| place.on_sheet(point);
    let towards = if whose == Whose::Yours {
        DVec2::new(1.0, 1.0)
    } else {
        DVec2::new(1.0, -1.0)
    };
    let labelled = match &mark.form {
        SketchForm::Dot(point) => {
            sheet.dot(look, at(*point));
            at(*point)
        }
        SketchForm::Arrow(from, to) => {
            sheet.arrow(look.outline(), at(*from), at(*to));
            at(*to)
        }
        SketchForm::Line(from, to) => {
            sheet.line(look.outline(), at(*from), at(*to));
            at(*to)
        }
        SketchForm::Circle(center, radius) => {
            sheet.circle(look, at(*center), radius * place.scale);
            at(*center)
        }
        SketchForm::Outline(points) => {
            sheet.polygon(look, points.iter().map(|p| at(*p)).collect());
            points.first().map_or(frame.min, |p| at(*p))
        }
    };
    if !mark.name.is_empty() {
        sheet.label(frame, labelled, towards, mark.name.as_str());
    }
}

/// From the world to the sheet.
struct Place {
    /// Which two coordinates are seen: to the right, and upwards.
    axes: [usize; 2],
    /// What lies in the middle of the frame.
    middle: DVec2,
    frame: Frame,
    scale: f64,
}

impl Place {
    fn of(marks: &[&(Whose, SketchMark)], frame: Frame) -> Self {
        let points: Vec<DVec3> = marks.iter().flat_map(|mark| mark.1.form.reach()).collect();
        let low = points
            .iter()
            .copied()
            .reduce(DVec3::min)
            .unwrap_or_default();
        let high = points
            .iter()
            .copied()
            .reduce(DVec3::max)
            .unwrap_or_default();
        let reach = high - low;
        // the axis along which the least is seen is left out, the last of equals
        let hidden = (0..3)
            .rev()
            .min_by(|&a, &b| reach[a].total_cmp(&reach[b]))
            .unwrap_or(2);
        let axes = match hidden {
            0 => [2, 1],
            1 => [0, 2],
            _ => [0, 1],
        };
        let seen = |v: DVec3| DVec2::new(v[axes[0]], v[axes[1]]);
        let room = frame.size() / seen(reach).max(DVec2::splat(1e-9));
        let scale = room.min_element();
        Self {
            axes,
            middle: seen(low.midpoint(high)),
            frame,
            scale: if scale.is_finite() { scale } else { 1.0 },
        }
    }

    fn on_sheet(&self, point: DVec3) -> DVec2 {
        let seen = DVec2::new(point[self.axes[0]], point[self.axes[1]]);
        // the sheet's y runs downwards
        self.frame.middle() + self.scale * (seen - self.middle) * DVec2::new(1.0, -1.0)
    }

    /// In words.
    fn axes(&self) -> String {
        let name = |axis: usize| ["x", "y", "z"][axis];
        format!(
            "{} to the right, {} up",
            name(self.axes[0]),
            name(self.axes[1])
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mark(form: SketchForm) -> SketchMark {
        SketchMark {
            form,
            name: String::new(),
        }
    }

    #[test]
    fn the_axis_along_which_the_marks_reach_least_is_not_seen() {
        let frame = Frame {
            min: DVec2::ZERO,
            max: DVec2::splat(100.0),
        };
        let from_to = |to: [f64; 3]| {
            let line = mark(SketchForm::Line(DVec3::ZERO, to.into()));
            Place::of(&[&(Whose::Given, line)], frame)
        };
        assert_eq!(from_to([4.0, 2.0, 1.0]).axes, [0, 1]);
        assert_eq!(from_to([4.0, 1.0, 2.0]).axes, [0, 2]);
        let place = from_to([0.0, 1.0, 2.0]);
        assert_eq!(place.axes, [2, 1]);
        // 2 units on 100, the middle (1, 0.5) in the middle, y upwards
        assert_eq!(place.scale, 50.0);
        assert_eq!(place.on_sheet(DVec3::ZERO), DVec2::new(0.0, 75.0));
    }

    #[test]
    fn a_mark_that_is_no_number_is_left_out() {
        let marks = [
            (Whose::Yours, mark(SketchForm::Dot(DVec3::NAN))),
            (Whose::Expected, mark(SketchForm::Dot(DVec3::ONE))),
            (Whose::Given, mark(SketchForm::Circle(DVec3::ZERO, 1.0))),
        ];
        let svg = sketch("s", ["t", "d"], &marks, &[(Whose::Yours, "t = 5".into())]);
        assert!(svg.contains("t = 5") && !svg.contains("NaN"), "{svg}");
    }
}
