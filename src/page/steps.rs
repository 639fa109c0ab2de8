//! A pixel's steps as data: what each says, what it asks, and where each move leads from it.

use serde::Serialize;

use crate::explain::{Line, Tone};
use crate::figure::{DrawnUpTo, Far};
use crate::step::{Became, LETTERS, Level, Moves, Question, StepLog, StepWords, subject};

/// The steps of a pixel, with the tables of their moves. A step is named by its place in the list.
#[derive(Clone, Debug, Serialize)]
pub struct PixelSteps {
    /// The steps.
    pub steps: Vec<StepFace>,
    /// Of each grain the steps that lie side by side, in the order of the log.
    pub walks: Vec<Vec<usize>>,
}

/// A step of a trace, for who looks for it on a page.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct TracePlace {
    /// The name of the trace: two traces of one page with the same name have the same events.
    pub trace: String,
    /// The step, as `step` in the log.
    pub step: u32,
}

/// A step as a page shows it.
#[derive(Clone, Debug, Serialize)]
pub struct StepFace {
    /// The address of its first event, as `37`.
    pub at: String,
    /// The name of its level.
    pub level: &'static str,
    /// What it is about, without its verdict.
    pub subject: String,
    /// The same with its verdict.
    pub title: String,
    /// Where it is: `test, steps 2 to 3 of 32, ray 0`.
    pub place: String,
    /// ✓ of what was found, ✗ of what was refused, · of all else.
    pub sign: char,
    /// The lines that tell it.
    pub lines: Vec<LineFace>,
    /// What it changed, why it is of interest, how many steps it holds.
    pub facts: Vec<String>,
    /// What it asks before its verdict is shown.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub question: Option<QuestionFace>,
    /// Of each drawing the last step that is shown before this step and after it. −1: only what is there from the first.
    pub drawn: Vec<[i64; 2]>,
    /// Where the moves lead from it; absent where there is one walk alone.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub moves: Option<MovesFace>,
}

/// A line of a step.
#[derive(Clone, Debug, Serialize)]
pub struct LineFace {
    /// What it is: `heading`, `plain`, `found`, `refused`, `aside` or `folded`.
    pub tone: &'static str,
    /// The number of levels that it is indented by.
    pub indent: usize,
    /// Does a paragraph begin with it?
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub gap: bool,
    /// The words.
    pub text: String,
}

/// A question of a step.
#[derive(Clone, Debug, Serialize)]
pub struct QuestionFace {
    /// The question.
    pub text: String,
    /// The choices, each with its letter: `a: two`.
    pub choices: Vec<String>,
    /// What is said first to each choice: `right: a`.
    pub verdicts: Vec<String>,
    /// Why each choice is right or wrong.
    pub reasons: Vec<String>,
}

/// Where the moves lead from a step, by the places of the steps. A move that is absent leads nowhere.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct MovesFace {
    /// Its events: the place of the first, and the place behind the last.
    pub events: [usize; 2],
    /// The steps that it holds: the first, and the one behind the last.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub children: Option<[usize; 2]>,
    /// The walk of its siblings.
    pub grain: usize,
    /// The step that holds it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub out: Option<usize>,
    /// The first step that it holds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub into: Option<usize>,
    /// The next event.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub leaf: Option<usize>,
    /// The event before.
    #[serde(rename = "leafBack", skip_serializing_if = "Option::is_none")]
    pub leaf_back: Option<usize>,
    /// The next target.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub target: Option<usize>,
    /// The target before.
    #[serde(rename = "targetBack", skip_serializing_if = "Option::is_none")]
    pub target_back: Option<usize>,
    /// Of each level the step and its walk.
    pub levels: [[usize; 2]; Level::ALL.len()],
    /// The step that set the value that this one looks at, and what is said of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub who: Option<(usize, String)>,
}

/// How far a drawing goes as a number that the script compares with `data-step`.
fn as_number(far: Far) -> i64 {
    match far {
        Far::Nothing => -1,
        Far::Step(step) => step.into(),
        Far::Whole => u32::MAX.into(),
    }
}

impl PixelSteps {
    /// Some steps of a log, which follow each other: the steps of a book. There is one walk, and no move leaves it.
    pub fn of_walk(log: &StepLog, walk: &[usize], drawn: &DrawnUpTo) -> Self {
        let words = StepWords::of_all(log);
        let face = |&step: &usize| StepFace::of(log, &words, step, &[drawn]);
        Self {
            steps: walk.iter().map(face).collect(),
            walks: vec![(0..walk.len()).collect()],
        }
    }
}

/// The moves of a log, with the steps of each walk in the order of their events.
pub(super) struct Grains<'a> {
    moves: &'a Moves,
    /// Of each walk the places of the first events.
    starts: Vec<Vec<usize>>,
}

impl<'a> Grains<'a> {
    pub(super) fn new(log: &StepLog, moves: &'a Moves) -> Self {
        let start = |&step: &usize| log.step(step).events.start;
        let walks = moves.walks.iter();
        let starts = walks.map(|walk| walk.iter().map(start).collect());
        Self {
            starts: starts.collect(),
            moves,
        }
    }

    /// The step of a walk that holds an event.
    fn holding(&self, walk: usize, event: usize) -> usize {
        let behind = self.starts[walk].partition_point(|start| *start <= event);
        self.moves.walks[walk][behind.saturating_sub(1)]
    }

    fn from(&self, log: &StepLog, number: usize) -> MovesFace {
        let step = log.step(number);
        let from = &self.moves.from[number];
        let with_grain = |step: usize| [step, self.moves.from[step].grain];
        let levels = std::array::from_fn(|level| {
            let around = match Level::ALL[level] {
                Level::Section => from.section,
                Level::Ray => from.ray,
                Level::Place | Level::Test | Level::Term => None,
            };
            around.map_or_else(
                || {
                    let walk = self.moves.levels[level];
                    [self.holding(walk, step.events.start), walk]
                },
                with_grain,
            )
        });
        let children = &step.children;
        let who = log.who_set(number, None).map(|setter| {
            let text = setter.text(log);
            (log.landing(setter.event), text)
        });
        MovesFace {
            events: [step.events.start, step.events.end],
            children: (!children.is_empty()).then_some([children.start, children.end]),
            grain: from.grain,
            out: from.out,
            into: from.into,
            leaf: from.next_leaf,
            leaf_back: from.previous_leaf,
            target: from.next_target,
            target_back: from.previous_target,
            levels,
            who,
        }
    }
}

impl StepFace {
    /// A step with its moves.
    pub(super) fn with_moves(
        log: &StepLog,
        words: &StepWords,
        number: usize,
        drawn: &[&DrawnUpTo],
        grains: &Grains,
    ) -> Self {
        Self {
            moves: Some(grains.from(log, number)),
            ..Self::of(log, words, number, drawn)
        }
    }

    fn of(log: &StepLog, words: &StepWords, number: usize, drawn: &[&DrawnUpTo]) -> Self {
        let step = log.step(number);
        let told = log.told(words, number);
        let before = step.events.start.checked_sub(1);
        let of_drawing = |drawing: &&DrawnUpTo| {
            let at = |event: usize| as_number(drawing.after(&log.records[event]));
            [before.map_or(-1, at), at(step.events.end - 1)]
        };
        Self {
            at: log.address(number).to_string(),
            level: step.level.name(),
            subject: subject(log, number),
            place: told.place.clone(),
            sign: step.became.map_or('·', Became::sign),
            facts: told.facts(),
            title: told.title,
            lines: told.lines.into_iter().map(LineFace::from).collect(),
            question: log.question(number).as_ref().map(QuestionFace::of),
            drawn: drawn.iter().map(of_drawing).collect(),
            moves: None,
        }
    }
}

impl QuestionFace {
    fn of(question: &Question) -> Self {
        let choices = LETTERS.iter().zip(&question.choices);
        Self {
            text: question.text.clone(),
            choices: choices
                .map(|(letter, choice)| format!("{letter}: {}", choice.text))
                .collect(),
            verdicts: (0..question.choices.len())
                .map(|choice| question.verdict(choice))
                .collect(),
            reasons: question.reasons().collect(),
        }
    }
}

impl From<Line> for LineFace {
    fn from(line: Line) -> Self {
        let tone = match line.tone {
            Tone::Heading => "heading",
            Tone::Plain => "plain",
            Tone::Found => "found",
            Tone::Refused => "refused",
            Tone::Aside => "aside",
            Tone::Folded(_) => "folded",
        };
        Self {
            tone,
            indent: line.indent,
            gap: line.gap,
            text: line.text,
        }
    }
}
