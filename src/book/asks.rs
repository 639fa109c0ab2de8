//! What a directive asks for, by its first word.

use crate::scene::{nearest_name, quoted};

/// What a directive asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Asks {
    /// `{{#raystep NAME}}`: the figure; `{{#raystep NAME stepper}}`: step by step.
    Figure,
    /// `{{#raystep-log NAME}}`: the worked solution of its pixel.
    Log,
    /// `{{#raystep-blanks NAME}}`: the same with results taken out.
    Blanks,
    /// `{{#raystep-value NAME PATH}}`: a number.
    Value,
    /// `{{#raystep-compare NAME}}`: what each strategy costs.
    Compare,
    /// `{{#raystep-code PATH:ITEM}}`: source.
    Code,
    /// `{{#raystep-run VERB …}}`: a command, and what it prints.
    Run,
    /// `{{#raystep-question LESSON/NAME}}`: a question, answered at once.
    Question,
    /// `{{#raystep-questions}}`: all questions.
    Questions,
    /// `{{#raystep-answers}}`: all answers.
    Answers,
    /// `{{#raystep-map FILE}}`: where each subject of the course is.
    Map,
    /// `{{#raystep-mistakes}}`: the mistakes that exercises recognise.
    Mistakes,
}

impl Asks {
    const ALL: [Self; 12] = [
        Self::Figure,
        Self::Log,
        Self::Blanks,
        Self::Value,
        Self::Compare,
        Self::Code,
        Self::Run,
        Self::Question,
        Self::Questions,
        Self::Answers,
        Self::Map,
        Self::Mistakes,
    ];

    /// The directive that a word means.
    ///
    /// # Errors
    /// There is none of this name; a near one, or all, are named.
    pub(super) fn named(word: &str) -> Result<Self, String> {
        if let Some(asks) = Self::ALL.into_iter().find(|asks| asks.name() == word) {
            return Ok(asks);
        }
        let names = Self::ALL.map(Self::name);
        let fix = match nearest_name(word, names.into_iter()) {
            Some(near) => format!("did you mean {near}?"),
            None => format!("there are {}", names.join(", ")),
        };
        Err(format!("there is no directive {}\n  {fix}", quoted(word)))
    }

    fn name(self) -> &'static str {
        match self {
            Self::Figure => "raystep",
            Self::Log => "raystep-log",
            Self::Blanks => "raystep-blanks",
            Self::Value => "raystep-value",
            Self::Compare => "raystep-compare",
            Self::Code => "raystep-code",
            Self::Run => "raystep-run",
            Self::Question => "raystep-question",
            Self::Questions => "raystep-questions",
            Self::Answers => "raystep-answers",
            Self::Map => "raystep-map",
            Self::Mistakes => "raystep-mistakes",
        }
    }
}
