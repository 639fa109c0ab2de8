//! What is drawn, before it is written: marks and words on a sheet, each with the step that makes it.
//!
//! A kind of figure draws on the sheet and knows nothing of SVG. Words of two sorts: fixed ones stand where they
//! are put (ticks, tables, trees); labels are placed afterwards, where they cross no line and no other words
//! ([`place_labels`](crate::figure::sheet::labels::place_labels)).

use glam::DVec2;

use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::image::Image;
use crate::figure::sheet::look::{Fill, Look};
use crate::figure::sheet::stage::{Stage, StageId, StageName};
use crate::figure::sheet::text::{Anchor, Text, with_indices};

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
    /// A picture, by its upper left, upper right and lower left corners: a parallelogram.
    Image { corners: [DVec2; 3], image: Image },
    /// A line on a picture: black or white, whatever the colours of the page are.
    OnPicture {
        points: Vec<DVec2>,
        closed: bool,
        is_white: bool,
        width: f64,
    },
}

/// Since when something is there. It orders what is drawn: what comes later lies above.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::figure) struct Since {
    /// The stage of the argument; `None` for what is there before the first.
    pub(in crate::figure) stage: Option<StageId>,
    /// The step of the trace that makes it; `None` for what is there before.
    pub(in crate::figure) step: Option<u32>,
}

/// Something drawn.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::figure) struct Mark {
    pub(in crate::figure) since: Since,
    pub(in crate::figure) look: Look,
    pub(in crate::figure) form: Form,
}

/// A line of letters at its place.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::figure) struct Words {
    pub(in crate::figure) since: Since,
    pub(in crate::figure) text: Text,
    /// The anchor's point, at half the height of a capital.
    pub(in crate::figure) place: DVec2,
    pub(in crate::figure) anchor: Anchor,
    /// Size of the letters.
    pub(in crate::figure) size: f64,
}

/// A line of letters that belongs to a point and is still to be placed.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::figure) struct Label {
    pub(in crate::figure) since: Since,
    pub(in crate::figure) text: Text,
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
    /// How it goes on later, part by part.
    pub(in crate::figure) later: Vec<(Since, Text)>,
    /// The outline that it names: in there it needs no leader.
    pub(in crate::figure) named: Vec<DVec2>,
    pub(in crate::figure) size: f64,
}

/// For what a figure is drawn: how large its letters are, against its width.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Width {
    /// A column of a book: 760 units wide, letters of 14, as high as the figure needs.
    #[default]
    Book,
    /// A slide of 16 : 9: 1280 × 720 units, letters of 32.
    Slide,
}

/// A sheet that is being drawn on.
#[derive(Clone, Debug)]
pub(in crate::figure) struct Sheet {
    /// For what it is drawn.
    pub(in crate::figure) width: Width,
    pub(in crate::figure) size: DVec2,
    /// Size of letters.
    pub(in crate::figure) letters: f64,
    pub(in crate::figure) marks: Vec<Mark>,
    pub(in crate::figure) words: Vec<Words>,
    pub(in crate::figure) labels: Vec<Label>,
    /// The stages of its argument, in their order.
    pub(in crate::figure) stages: Vec<Stage>,
    since: Since,
    cut: Option<Frame>,
}

impl Words {
    /// The rectangle that the letters fill.
    pub(in crate::figure) fn frame(&self) -> Frame {
        self.text.frame(self.anchor, self.place, self.size)
    }
}

impl Sheet {
    /// An empty sheet; a book's has the height that is asked for.
    pub(in crate::figure) fn new(width: Width, height: f64) -> Self {
        let (size, letters) = match width {
            Width::Book => (DVec2::new(760.0, height), 14.0),
            Width::Slide => (DVec2::new(1280.0, 720.0), 32.0),
        };
        Self {
            width,
            size,
            letters,
            marks: Vec::new(),
            words: Vec::new(),
            labels: Vec::new(),
            stages: Vec::new(),
            since: Since::default(),
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
        let since = Since {
            step: step.into(),
            ..self.since
        };
        self.since(since, draw)
    }

    /// The next stage of the figure's argument: its name, the last step of the trace that it needs, and what it says, as one
    /// sentence. What belongs to it is drawn with [`at`](Self::at), in any order.
    pub(in crate::figure) fn stage(
        &mut self,
        name: impl Into<StageName>,
        step: impl Into<Option<u32>>,
        sentence: impl Into<String>,
    ) -> StageId {
        self.stages.push(Stage {
            name: name.into(),
            step: step.into(),
            sentence: sentence.into(),
        });
        StageId(self.stages.len() as u32 - 1)
    }

    /// What is drawn inside belongs to a stage, and, where it has one, to its step of the trace.
    pub(in crate::figure) fn at<T>(
        &mut self,
        stage: StageId,
        draw: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let step = self.stages.get(stage.0 as usize).and_then(|of| of.step);
        let since = Since {
            stage: Some(stage),
            step: step.or(self.since.step),
        };
        self.since(since, draw)
    }

    /// What is drawn inside is made by an event of the trace, and belongs to the first stage that needs it.
    pub(in crate::figure) fn event<T>(
        &mut self,
        step: u32,
        draw: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let since = Since {
            stage: self.stage_of(step),
            step: Some(step),
        };
        self.since(since, draw)
    }

    /// What the last stage shows: nothing before it.
    pub(in crate::figure) fn at_last<T>(&mut self, draw: impl FnOnce(&mut Self) -> T) -> T {
        match self.stages.len().checked_sub(1) {
            Some(last) => self.at(StageId(last as u32), draw),
            None => draw(self),
        }
    }

    /// The first stage that needs an event; the last one if none says so.
    pub(in crate::figure) fn stage_of(&self, step: u32) -> Option<StageId> {
        let needs = |stage: &Stage| stage.step.is_some_and(|last| step <= last);
        let first = self.stages.iter().position(needs);
        let stage = first.or(self.stages.len().checked_sub(1));
        stage.map(|stage| StageId(stage as u32))
    }

    /// What is drawn inside is there since then.
    pub(in crate::figure) fn since<T>(
        &mut self,
        since: Since,
        draw: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let before = std::mem::replace(&mut self.since, since);
        let drawn = draw(self);
        self.since = before;
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
            since: self.since,
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

    /// A point that nothing is said about yet.
    pub(in crate::figure) fn small_dot(&mut self, look: Look, at: DVec2) {
        self.circle(look.inside().full(), at, 2.5 * self.unit());
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

    /// A picture that fills a frame.
    pub(in crate::figure) fn image(&mut self, frame: Frame, image: Image) {
        let [upper_left, upper_right, _, lower_left] = frame.corners();
        self.image_in([upper_left, upper_right, lower_left], image);
    }

    /// A picture in a parallelogram, by its upper left, upper right and lower left corners.
    pub(in crate::figure) fn image_in(&mut self, corners: [DVec2; 3], image: Image) {
        self.mark(Look::OBJECT.inside(), Form::Image { corners, image });
    }

    /// A line on a picture: black on white, so that it is seen on every colour.
    pub(in crate::figure) fn on_picture(&mut self, points: &[DVec2], closed: bool) {
        for (is_white, width) in [(true, 4.0), (false, 1.5)] {
            let form = Form::OnPicture {
                points: points.into(),
                closed,
                is_white,
                width: width * self.unit(),
            };
            self.mark(Look::OBJECT.inside(), form);
        }
    }

    /// Letters at a fixed place, in height around it.
    pub(in crate::figure) fn text(&mut self, anchor: Anchor, place: DVec2, text: impl Into<Text>) {
        self.words.push(Words {
            since: self.since,
            text: text.into(),
            place,
            anchor,
            size: self.letters,
        });
    }

    /// Lines of letters at the upper edge of a frame; gives back the frame that is left below them.
    pub(in crate::figure) fn lines<T: Clone + Into<Text>>(
        &mut self,
        frame: Frame,
        texts: &[T],
    ) -> Frame {
        let height = self.line_height();
        let room = frame.size().x / self.letters;
        let wrapped = texts.iter().flat_map(|of| of.clone().into().wrapped(room));
        let mut count = 0.0;
        for text in wrapped {
            let down = DVec2::new(0.0, (count + 0.5) * height);
            self.text(Anchor::Start, frame.min + down, text);
            count += 1.0;
        }
        let [_, rest] = frame.split_top((count + 0.4) * height);
        rest
    }

    /// A title at the upper edge of a frame, in larger letters; gives back the frame that is left below it.
    pub(in crate::figure) fn heading(&mut self, frame: Frame, title: &str) -> Frame {
        /// Against the other letters.
        const SIZE: f64 = 1.2;
        let size = SIZE * self.letters;
        let lines = with_indices(title).wrapped(frame.size().x / size);
        let count = lines.len() as f64;
        for (line, text) in lines.into_iter().enumerate() {
            self.words.push(Words {
                since: Since::default(),
                text,
                place: frame.min + DVec2::new(0.0, (line as f64 + 0.5) * 1.3 * size),
                anchor: Anchor::Start,
                size,
            });
        }
        let [_, rest] = frame.split_top((count + 0.3) * 1.3 * size);
        rest
    }

    /// A label of a point, best placed in a direction from it.
    pub(in crate::figure) fn label(
        &mut self,
        within: Frame,
        of: DVec2,
        towards: DVec2,
        text: impl Into<Text>,
    ) {
        if self.is_cut_off(of) {
            return;
        }
        self.labels.push(Label {
            since: self.since,
            text: text.into(),
            of,
            towards,
            within,
            anywhere: false,
            optional: false,
            later: Vec::new(),
            named: Vec::new(),
            size: self.letters,
        });
    }

    /// A label that is left out if there is no room: one name of many. Inside the outline that it names it needs no
    /// leader.
    pub(in crate::figure) fn name(
        &mut self,
        within: Frame,
        of: DVec2,
        towards: DVec2,
        (text, outline): (impl Into<Text>, Vec<DVec2>),
    ) {
        let count = self.labels.len();
        self.label(within, of, towards, text);
        if let Some(label) = self.labels.get_mut(count) {
            label.optional = true;
            label.named = outline;
        }
    }

    /// A label that goes on in a later stage: it has room from the first.
    pub(in crate::figure) fn label_that_goes_on(
        &mut self,
        within: Frame,
        of: DVec2,
        towards: DVec2,
        text: impl Into<Text>,
        (stage, more): (StageId, impl Into<Text>),
    ) {
        let count = self.labels.len();
        self.label(within, of, towards, text);
        let later = self.at(stage, |sheet| sheet.since);
        if let Some(label) = self.labels.get_mut(count) {
            label.later.push((later, more.into()));
        }
    }

    /// The label of an area, made last, goes on from here.
    pub(in crate::figure) fn label_goes_on(&mut self, more: impl Into<Text>) {
        let since = self.since;
        if let Some(label) = self.labels.last_mut() {
            label.later.push((since, more.into()));
        }
    }

    /// A label of an area, anywhere in it: in its upper left corner if that is free.
    pub(in crate::figure) fn label_in(&mut self, area: Frame, text: impl Into<Text>) {
        self.labels.push(Label {
            since: self.since,
            text: text.into(),
            of: area.min,
            towards: DVec2::ONE,
            within: area,
            anywhere: true,
            optional: false,
            later: Vec::new(),
            named: Vec::new(),
            size: self.letters,
        });
    }

    /// How wide a text is on this sheet.
    pub(in crate::figure) fn width_of(&self, text: impl Into<Text>) -> f64 {
        text.into().width() * self.letters
    }

    /// From one line of letters to the next.
    pub(in crate::figure) fn line_height(&self) -> f64 {
        1.5 * self.letters
    }

    /// Says what looks mean, in lines at the lower edge of a frame, and gives back the frame that is left.
    pub(in crate::figure) fn legend<T: Clone + Into<Text>>(
        &mut self,
        frame: Frame,
        entries: &[(Look, T)],
    ) -> Frame {
        let entries = entries
            .iter()
            .map(|(look, text)| (None, *look, text.clone()));
        self.staged_legend(frame, &entries.collect::<Vec<_>>())
    }

    /// The same with the stage from which on a look is seen: before, its name would tell what comes.
    pub(in crate::figure) fn staged_legend<T: Clone + Into<Text>>(
        &mut self,
        frame: Frame,
        entries: &[(Option<StageId>, Look, T)],
    ) -> Frame {
        let swatch = 2.0 * self.letters;
        let gap = 0.5 * self.letters;
        let mut places = Vec::new();
        let (mut x, mut line) = (0.0, 0.0);
        for (stage, look, text) in entries {
            let text: Text = text.clone().into();
            let width = swatch + gap + self.width_of(&text);
            if 0.0 < x && frame.size().x < x + width {
                (x, line) = (0.0, line + 1.0);
            }
            places.push((DVec2::new(x, line), *stage, *look, text));
            x += width + 2.0 * gap;
        }
        let height = self.line_height();
        let top = frame.max.y - (line + 1.0) * height;
        for (place, stage, look, text) in places {
            let left = frame.min + DVec2::new(place.x, 0.0);
            let middle = DVec2::new(left.x, top + (place.y + 0.5) * height);
            let entry = |sheet: &mut Self| {
                let end = middle + DVec2::new(swatch, 0.0);
                if look.fill == Fill::Empty {
                    sheet.line(look, middle, end);
                } else {
                    let half = DVec2::new(0.0, 0.35 * sheet.letters);
                    let (min, max) = (middle - half, end + half);
                    // a tint alone is faint, and more so in a dark theme
                    let look = look.wide(look.width.max(0.75));
                    sheet.rectangle(look, Frame { min, max });
                }
                let place = end + DVec2::new(gap, 0.0);
                sheet.text(Anchor::Start, place, text.clone());
            };
            match stage {
                Some(stage) => self.at(stage, entry),
                None => entry(self),
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
    fn an_event_belongs_to_the_first_stage_that_needs_it() {
        let mut sheet = Sheet::new(Width::Book, 400.0);
        sheet.event(3, |sheet| sheet.dot(Look::RAY, DVec2::ZERO));
        sheet.stage("scene", None, "");
        sheet.stage("ray", 2, "");
        sheet.stage("hit", 6, "");
        for step in [2, 3, 6, 7] {
            sheet.event(step, |sheet| sheet.dot(Look::RAY, DVec2::ZERO));
        }
        let found = sheet.marks.iter().map(|mark| mark.since);
        let found: Vec<_> = found.map(|of| (of.stage, of.step)).collect();
        let expected = [
            (None, 3),
            (Some(1), 2),
            (Some(2), 3),
            (Some(2), 6),
            (Some(2), 7),
        ];
        let expected = expected.map(|(stage, step)| (stage.map(StageId), Some(step)));
        assert_eq!(found, expected);
    }

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
