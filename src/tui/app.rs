//! What the terminal shows of a log, and what a key does: no terminal is needed for it.

use std::collections::VecDeque;

use crate::explain::{Line, Tone};
use crate::figure::Far;
use crate::lesson::{StepFigures, StepStrokes, Thumbnail};
use crate::step::{
    Command, Cursor, Filter, KEYS, Known, LETTERS, Reaction, Reader, Shift, StepLog, StepWords,
    Told, commands,
};
use crate::tui::prompt::{Prompt, Typed};

/// From so many columns on the drawing stands beside the working.
pub(super) const WIDE: u16 = 110;

/// What a key asks of whoever has the scene and the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// To save the drawing up to the step.
    Save,
    /// To tell the command that leads here.
    Address,
    /// To trace the same pixel with the next strategy.
    Strategy,
    /// To trace the pixel beside.
    Pixel(Shift),
    /// To end.
    Quit,
    /// To end as an interrupt does.
    Interrupt,
}

/// What stands in the title bar.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Titles {
    /// The scene or the log.
    pub scene: String,
    /// The pixel that is stepped through.
    pub pixel: [u32; 2],
    /// The strategy.
    pub strategy: String,
}

/// The small picture.
#[derive(Clone, Debug, Default, PartialEq)]
enum Small {
    /// Nobody has asked for it.
    #[default]
    Unasked,
    /// There is none of this scene.
    None,
    /// This one.
    Some(Thumbnail),
}

/// What stays when another log is shown: of another pixel, or with another strategy.
#[derive(Clone, Debug, Default)]
pub struct Kept {
    filter: Option<Filter>,
    predicts: bool,
    shows_drawing: bool,
    shows_picture: bool,
    picture: Small,
    waiting: VecDeque<Command>,
    size: [u16; 2],
}

impl Kept {
    /// Before the first log.
    pub fn new(predicts: bool) -> Self {
        Self {
            predicts,
            ..Self::default()
        }
    }
}

/// Lines over the whole screen: the keys, the state, a long working.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sheet {
    pub(super) title: String,
    pub(super) lines: Vec<Line>,
    /// By how much the rest of a wrapped line is indented.
    pub(super) hanging: usize,
    /// The first line that is visible.
    pub(super) top: usize,
}

/// A line of the state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Fact {
    pub(super) text: String,
    /// Has the step changed it?
    pub(super) is_new: bool,
}

/// What the terminal shows of a log.
#[derive(Debug)]
pub struct App<'a, 'l> {
    pub(super) reader: Reader<'a, 'l>,
    pub(super) titles: Titles,
    words: StepWords<'l>,
    /// What the step says.
    pub(super) told: Told,
    /// The state: what the step changed, old → new, and what else is known.
    pub(super) state: Vec<Fact>,
    /// What was said instead of a step, at the lower edge.
    pub(super) said: Vec<String>,
    /// What was said of the step, above its words.
    pub(super) first: Vec<String>,
    pub(super) prompt: Option<Prompt>,
    pub(super) sheet: Option<Sheet>,
    /// Is the drawing in the place of the working, where there is room for one of them?
    pub(super) shows_drawing: bool,
    /// Has the reader gone to another pixel with the last key?
    pub(super) shows_picture: bool,
    /// The small picture that shows which pixel it is.
    picture: Small,
    figures: Option<StepFigures>,
    /// The drawing of the step, or why there is none.
    pub(super) drawn: Option<Result<StepStrokes, String>>,
    /// Commands that are still to be done.
    waiting: VecDeque<Command>,
    size: [u16; 2],
}

impl<'a, 'l> App<'a, 'l> {
    /// At a step of a log.
    pub fn new(log: &'a StepLog<'l>, cursor: Cursor, kept: Kept, titles: Titles) -> Self {
        let words = StepWords::new(log);
        let reader = Reader::new(log, cursor, kept.filter, kept.predicts);
        let told = log.told(&words, reader.here());
        let mut app = Self {
            reader,
            titles,
            words,
            told,
            state: Vec::new(),
            said: Vec::new(),
            first: Vec::new(),
            prompt: None,
            sheet: None,
            shows_drawing: kept.shows_drawing,
            shows_picture: kept.shows_picture,
            picture: kept.picture,
            figures: None,
            drawn: None,
            waiting: kept.waiting,
            size: kept.size,
        };
        app.state = app.state();
        app.draw_again();
        app
    }

    /// What stays for the next log.
    pub fn keep(&self) -> Kept {
        Kept {
            filter: self.reader.filter().cloned(),
            predicts: self.reader.predicts(),
            shows_drawing: self.shows_drawing,
            shows_picture: self.shows_picture,
            picture: self.picture.clone(),
            waiting: self.waiting.clone(),
            size: self.size,
        }
    }

    /// The log.
    pub fn log(&self) -> &'a StepLog<'l> {
        self.reader.log()
    }

    /// The number of the step where the reader stands.
    pub fn here(&self) -> usize {
        self.reader.here()
    }

    /// Is the small picture visible that shows which pixel it is, and was never made?
    pub fn needs_picture(&self) -> bool {
        self.picture == Small::Unasked && (self.shows_picture || WIDE <= self.size[0])
    }

    /// Here is the small picture; `None`: the scene has none.
    pub fn set_picture(&mut self, picture: Option<Thumbnail>) {
        self.picture = picture.map_or(Small::None, Small::Some);
    }

    /// The small picture, if there is one.
    pub(super) fn picture(&self) -> Option<&Thumbnail> {
        match &self.picture {
            Small::Some(picture) => Some(picture),
            Small::Unasked | Small::None => None,
        }
    }

    /// Says something at the lower edge.
    pub fn say(&mut self, text: &str) {
        self.said = text.lines().map(str::to_owned).collect();
    }

    /// The terminal has another size.
    pub fn resize(&mut self, size: [u16; 2]) {
        if self.size != size {
            self.size = size;
            self.draw_again();
        }
    }

    /// A key by its name, as in [`KEYS`], or `Enter`, `Tab`, `Ctrl+C`; a letter is its own name.
    pub fn press(&mut self, key: &str) -> Option<Effect> {
        self.said.clear();
        if key == "Ctrl+C" {
            return Some(Effect::Interrupt);
        }
        if let Some(prompt) = &mut self.prompt {
            match prompt.press(key) {
                Typed::More => {}
                Typed::Left => self.prompt = None,
                Typed::Done(text) => {
                    self.prompt = None;
                    self.type_in(&text);
                }
            }
            return self.go_on();
        }
        if self.sheet.is_some() && self.turn(key) {
            return None;
        }
        self.shows_picture = false;
        match key {
            "Tab" => {
                self.shows_drawing = !self.shows_drawing;
                self.draw_again();
            }
            "Enter" => {
                self.sheet = Some(Sheet {
                    title: self.told.title.clone(),
                    lines: self.working(),
                    hanging: 2,
                    top: 0,
                });
            }
            key => match Prompt::of(key) {
                Some(prompt) => self.prompt = Some(prompt),
                None => self.type_in(key),
            },
        }
        self.go_on()
    }

    /// Does what is still to be done, up to the first thing that it cannot do alone.
    pub fn go_on(&mut self) -> Option<Effect> {
        while let Some(command) = self.waiting.pop_front() {
            if let Some(effect) = self.obey(command) {
                return Some(effect);
            }
        }
        None
    }

    /// Words that are commands.
    fn type_in(&mut self, text: &str) {
        match commands(text) {
            Ok(commands) => self.waiting.extend(commands),
            Err(error) => self.say(&error.to_string()),
        }
    }

    fn obey(&mut self, command: Command) -> Option<Effect> {
        let before = self.reader.cursor();
        let by = match command {
            Command::Move(by) | Command::Page(by) => Some(by),
            _ => None,
        };
        let reaction = self.reader.obey(command);
        if let Some(by) = by.filter(|_| before == self.reader.cursor()) {
            let is_leaf = self.log().step(self.here()).is_leaf();
            let more = if is_leaf {
                ""
            } else {
                " at this level: → goes in"
            };
            self.say(&format!("{}{more}", by.leads_nowhere()));
            return None;
        }
        match reaction {
            Reaction::Shown(lines) => {
                self.first = lines;
                self.told = self.log().told(&self.words, self.here());
                self.state = self.state();
                self.draw_again();
                None
            }
            Reaction::Said(lines) => {
                self.said = lines;
                None
            }
            Reaction::Left(command) => match command {
                Command::View => {
                    let lines = self.log().view(self.here());
                    self.open("all that is known here", 2, lines.into_iter().map(plain));
                    None
                }
                Command::Keys => {
                    self.open("keys", NAMES + 1, keys());
                    None
                }
                Command::Save => Some(Effect::Save),
                Command::Address => Some(Effect::Address),
                Command::Strategy => Some(Effect::Strategy),
                Command::Pixel(shift) => {
                    self.shows_picture = true;
                    Some(Effect::Pixel(shift))
                }
                _ => Some(Effect::Quit),
            },
        }
    }

    /// The state after the step; before its question is answered, the state before it.
    fn state(&self) -> Vec<Fact> {
        let (log, here) = (self.log(), self.here());
        let old = |known: &Known| Fact {
            text: known.text(log),
            is_new: false,
        };
        if self.reader.asked().is_some() {
            return log.known_before(here).iter().rev().map(old).collect();
        }
        let changes = log.changes(here);
        let is_changed = |known: &&Known| {
            let mut changes = changes.iter();
            changes.any(|change| (change.ray, change.quantity) == (known.ray, known.quantity))
        };
        let new = self.told.changes.iter().map(|text| Fact {
            text: text.clone(),
            is_new: true,
        });
        let known = log.known(here);
        // of the innermost ray first
        let rest = known.iter().rev().filter(|known| !is_changed(known));
        new.chain(rest.map(old)).collect()
    }

    fn open(&mut self, title: &str, hanging: usize, lines: impl Iterator<Item = Line>) {
        self.sheet = Some(Sheet {
            title: title.into(),
            lines: lines.collect(),
            hanging,
            top: 0,
        });
    }

    /// A key while lines lie over the screen; `false` if it is no key of theirs, which closes them.
    fn turn(&mut self, key: &str) -> bool {
        let page = usize::from(self.size[1]).saturating_sub(4).max(1);
        let Some(sheet) = &mut self.sheet else {
            return false;
        };
        let top = match key {
            "↓" => sheet.top + 1,
            "↑" => sheet.top.saturating_sub(1),
            "PgDn" | "Space" => sheet.top + page,
            "PgUp" | "Backspace" => sheet.top.saturating_sub(page),
            "Home" => 0,
            "End" => usize::MAX,
            "Esc" | "Enter" | "q" | "?" | "v" => {
                self.sheet = None;
                return true;
            }
            _ => {
                self.sheet = None;
                return false;
            }
        };
        // a line may be wrapped, so the last one alone is surely the end
        sheet.top = top.min(sheet.lines.len().saturating_sub(1));
        true
    }

    /// What the working shows: the question, or the words of the step.
    pub(super) fn working(&self) -> Vec<Line> {
        let first = self.first.iter().cloned();
        let mut lines: Vec<Line> = first.map(|text| line(text, 0, Tone::Found)).collect();
        let has_first = !lines.is_empty();
        if let Some(question) = self.reader.asked() {
            lines.push(line(question.text.clone(), 0, Tone::Heading));
            let choices = LETTERS.iter().zip(&question.choices);
            lines.extend(choices.map(|(letter, choice)| {
                line(format!("{letter}: {}", choice.text), 1, Tone::Plain)
            }));
            lines.push(line(
                "answer with a letter, or skip with Esc",
                0,
                Tone::Aside,
            ));
        } else {
            let told = self.told.lines.iter().cloned();
            let facts = self.told.facts().into_iter();
            let facts = facts.filter(|fact| !fact.starts_with("changed: "));
            lines.extend(told.chain(facts.map(|fact| line(fact, 0, Tone::Aside))));
        }
        if let Some(first) = lines.get_mut(self.first.len()).filter(|_| has_first) {
            first.gap = true;
        }
        lines
    }

    /// Is the drawing visible?
    pub(super) fn draws(&self) -> bool {
        WIDE <= self.size[0] || self.shows_drawing
    }

    /// Makes the drawing of the step, if it is visible and another one than before.
    fn draw_again(&mut self) {
        if !self.draws() {
            return;
        }
        let log = self.reader.log();
        let figures = self.figures.get_or_insert_with(|| StepFigures::new(log));
        let known = self.drawn.take().and_then(Result::ok);
        let drawn = figures.strokes(log, self.reader.here(), known);
        self.drawn = Some(drawn.map_err(|error| error.what));
    }

    /// How far the drawing is shown.
    pub(super) fn far(&self) -> Far {
        let events = &self.log().step(self.here()).events;
        // before a question is answered what follows would give the answer away
        let end = events.end.min(self.reader.seen());
        match (&self.figures, &self.drawn, end.checked_sub(1)) {
            (Some(figures), Some(Ok(strokes)), Some(last)) => {
                figures.far(self.log(), last, strokes.kind)
            }
            _ => Far::Nothing,
        }
    }
}

fn plain(text: String) -> Line {
    line(text, 0, Tone::Plain)
}

fn line(text: impl Into<String>, indent: usize, tone: Tone) -> Line {
    Line {
        gap: false,
        indent,
        tone,
        ray: None,
        steps: None,
        part: None,
        text: text.into(),
    }
}

/// What keys do that are not in the table of all steppers.
const OF_TERMINAL: [(&str, &str); 5] = [
    ("Tab", "the drawing in the place of the working, and back"),
    ("Enter", "the working of the step over the whole screen"),
    (
        "W",
        "who set a value that is named, such as t: the nearest t",
    ),
    (
        ":",
        "type a command by its word, as in w t or level 3; the words are those of --plain",
    ),
    ("Ctrl+C", "end at once"),
];

/// So many columns the names of keys take.
const NAMES: usize = 9;

/// All keys, each with what it does.
fn keys() -> impl Iterator<Item = Line> {
    let of_table = KEYS.iter().map(|key| (key.key, key.does));
    let all = of_table.chain(OF_TERMINAL);
    all.map(|(key, does)| plain(format!("{key:<NAMES$} {does}")))
}
