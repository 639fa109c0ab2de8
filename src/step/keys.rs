//! The keys of a stepper: one table for every face, with the words that stand for them where there are no keys.

use std::fmt;

use crate::scene::nearest_name;
use crate::step::cursor::Move;
use crate::step::filter::{Filter, FilterError};
use crate::step::level::Level;
use crate::step::who::Asked;

/// What a key does, or a word.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// A move of the cursor.
    Move(Move),
    /// So many moves of the cursor.
    Page(Move),
    /// To the next target.
    NextTarget,
    /// To the target before.
    PreviousTarget,
    /// The targets are what the filter names; `None`: what is of interest by itself.
    Filter(Option<Filter>),
    /// To the step that set a value; `None`: the value that the step has looked at.
    Who(Option<Asked>),
    /// To a step by its number in the log.
    Go(String),
    /// To another level.
    Level(Level),
    /// The same pixel with the next strategy.
    Strategy,
    /// The pixel beside.
    Pixel(Shift),
    /// Questions are asked before verdicts, or no more.
    Predict,
    /// The choice of a question, from 0.
    Answer(usize),
    /// No answer: the step is shown.
    Skip,
    /// All that is known here.
    View,
    /// The drawing up to here goes into a file.
    Save,
    /// The command that leads here.
    Address,
    /// The keys.
    Keys,
    /// The end.
    Quit,
}

/// To which side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shift {
    /// One column to the left.
    Left,
    /// One column to the right.
    Right,
    /// One row up.
    Up,
    /// One row down.
    Down,
}

impl Shift {
    /// The pixel beside; `None` where the picture ends.
    pub fn from(self, [x, y]: [u32; 2], [width, height]: [u32; 2]) -> Option<[u32; 2]> {
        match self {
            Self::Left => x.checked_sub(1).map(|x| [x, y]),
            Self::Right => x.checked_add(1).filter(|&x| x < width).map(|x| [x, y]),
            Self::Up => y.checked_sub(1).map(|y| [x, y]),
            Self::Down => y.checked_add(1).filter(|&y| y < height).map(|y| [x, y]),
        }
    }
}

/// So many steps are a page.
pub const PAGE: usize = 10;

/// A key.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// Its name on the keyboard.
    pub key: &'static str,
    /// The words that stand for it, the first of them in the list of the keys.
    pub words: &'static [&'static str],
    /// What follows the word, as it is written in the list of the keys; empty if nothing does.
    pub argument: &'static str,
    /// What it does.
    pub does: &'static str,
    command: fn(&mut Words) -> Result<Command, CommandError>,
}

impl Key {
    /// The words and the name of the key, each once, with what follows them: `over, down, ↓`, `g, go STEP`.
    pub fn names(&self) -> String {
        let mut names: Vec<&str> = Vec::new();
        for name in self.words.iter().copied().chain([self.key]) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        let argument = if self.argument.is_empty() {
            String::new()
        } else {
            format!(" {}", self.argument)
        };
        format!("{}{argument}", names.join(", "))
    }
}

/// A row of the table.
macro_rules! key {
    ($key:literal, $words:expr, $does:literal, $command:expr) => {
        Key {
            key: $key,
            words: &$words,
            argument: "",
            does: $does,
            command: |_| Ok($command),
        }
    };
    ($key:literal, $words:expr, $argument:literal, $does:literal, $command:path) => {
        Key {
            key: $key,
            words: &$words,
            argument: $argument,
            does: $does,
            command: $command,
        }
    };
}

/// The table of the keys.
pub const KEYS: &[Key] = &[
    key!(
        "↓",
        ["over", "down"],
        "next step",
        Command::Move(Move::Over)
    ),
    key!(
        "↑",
        ["back", "up"],
        "step before",
        Command::Move(Move::Back)
    ),
    key!(
        "→",
        ["into", "right"],
        "first step inside this one",
        Command::Move(Move::Into)
    ),
    key!(
        "←",
        ["out", "left"],
        "step around this one",
        Command::Move(Move::Out)
    ),
    key!(
        "Space",
        ["leaf", "space"],
        "next event",
        Command::Move(Move::NextLeaf)
    ),
    key!(
        "Backspace",
        ["leaf-back", "backspace"],
        "event before",
        Command::Move(Move::PreviousLeaf)
    ),
    key!(
        "n",
        ["n"],
        "next target: a step of interest, or one that / names",
        Command::NextTarget
    ),
    key!("N", ["N"], "target before", Command::PreviousTarget),
    key!(
        "/",
        ["/"],
        "WORD or KEY=VALUE",
        "choose the targets, as in /rejected or /kind=cell object=A; / alone: what is of interest",
        filter
    ),
    key!(
        "w",
        ["w", "who"],
        "[VALUE]",
        "who set this value: the step that did; in a script w t: the nearest t",
        who
    ),
    key!(
        "g",
        ["g", "go"],
        "STEP",
        "go to a step by its number in the log, as in g 37",
        go
    ),
    key!(
        "Home",
        ["first", "home"],
        "first step",
        Command::Move(Move::First)
    ),
    key!(
        "End",
        ["last", "end"],
        "last step",
        Command::Move(Move::Last)
    ),
    key!(
        "PgDn",
        ["page", "pgdn"],
        "10 steps on",
        Command::Page(Move::Over)
    ),
    key!(
        "PgUp",
        ["page-back", "pgup"],
        "10 steps back",
        Command::Page(Move::Back)
    ),
    key!(
        "1",
        ["1", "section"],
        "level: the pixel, a path of light, the building",
        Command::Level(Level::Section)
    ),
    key!("2", ["2", "ray"], "level: rays", Command::Level(Level::Ray)),
    key!(
        "3",
        ["3", "place"],
        "level: places, which are nodes or cells",
        Command::Level(Level::Place)
    ),
    key!(
        "4",
        ["4", "test"],
        "level: tests",
        Command::Level(Level::Test)
    ),
    key!(
        "5",
        ["5", "term"],
        "level: terms, each event by itself",
        Command::Level(Level::Term)
    ),
    key!(
        "x",
        ["x", "strategy"],
        "same pixel, next strategy",
        Command::Strategy
    ),
    key!(
        "Shift+→",
        ["pixel-right", "shift+right"],
        "pixel to the right",
        Command::Pixel(Shift::Right)
    ),
    key!(
        "Shift+←",
        ["pixel-left", "shift+left"],
        "pixel to the left",
        Command::Pixel(Shift::Left)
    ),
    key!(
        "Shift+↓",
        ["pixel-down", "shift+down"],
        "pixel below",
        Command::Pixel(Shift::Down)
    ),
    key!(
        "Shift+↑",
        ["pixel-up", "shift+up"],
        "pixel above",
        Command::Pixel(Shift::Up)
    ),
    key!(
        "p",
        ["p", "predict"],
        "predict: ask before a verdict is shown, or no more",
        Command::Predict
    ),
    key!("a", ["a"], "first choice of a question", Command::Answer(0)),
    key!("b", ["b"], "second choice", Command::Answer(1)),
    key!("c", ["c"], "third choice", Command::Answer(2)),
    key!("d", ["d"], "fourth choice", Command::Answer(3)),
    key!(
        "Esc",
        ["skip", "esc"],
        "no answer: show the step",
        Command::Skip
    ),
    key!(
        "v",
        ["v", "view"],
        "view all that is known here",
        Command::View
    ),
    key!(
        "s",
        ["s", "save"],
        "save the drawing up to here as SVG, in a new file",
        Command::Save
    ),
    key!(
        "y",
        ["y", "command"],
        "the command that leads here",
        Command::Address
    ),
    key!("?", ["?", "keys"], "all keys", Command::Keys),
    key!("q", ["q", "quit"], "end", Command::Quit),
];

/// Why words are no commands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CommandError {
    /// There is no such word; the word that is most like it.
    Unknown(String, Option<String>),
    /// A quotation mark is not closed.
    Quote(String),
    /// No step follows `g`.
    NoStep,
    /// The filter makes no sense.
    Filter(FilterError),
}

impl std::error::Error for CommandError {}

impl fmt::Display for CommandError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown(word, Some(near)) => {
                write!(
                    f,
                    "there is no command {word:?}; did you mean {near}? The command ? lists all"
                )
            }
            Self::Unknown(word, None) => {
                write!(f, "there is no command {word:?}; the command ? lists all")
            }
            Self::Quote(text) => write!(f, "a quotation mark of {text:?} is not closed"),
            Self::NoStep => write!(f, "g needs the number of a step, as in g 37"),
            Self::Filter(error) => error.fmt(f),
        }
    }
}

/// The words that are still to be read.
type Words = std::iter::Peekable<std::vec::IntoIter<String>>;

/// The commands of a line or a script, with spaces between them: `into n n w t /kind=cell object=A n`.
///
/// A word that begins with `/` is a filter, and so are the conditions `key=value` behind it. After `w` comes a value, if the
/// word is one, and after `g` a step.
///
/// # Errors
/// A word that no key has, a filter that makes no sense.
pub fn commands(text: &str) -> Result<Vec<Command>, CommandError> {
    let mut words = words(text)?.into_iter().peekable();
    let mut commands = Vec::new();
    while let Some(word) = words.next() {
        if let Some(rest) = word.strip_prefix('/') {
            commands.push(filter_of(rest, &mut words)?);
            continue;
        }
        let has_word = |key: &&Key| key.key == word || key.words.contains(&word.as_str());
        let Some(key) = KEYS.iter().find(has_word) else {
            let known = KEYS.iter().flat_map(|key| key.words).copied();
            let near = nearest_name(&word, known);
            return Err(CommandError::Unknown(word, near));
        };
        commands.push((key.command)(&mut words)?);
    }
    Ok(commands)
}

/// The words of a text; quotation marks hold one together.
fn words(text: &str) -> Result<Vec<String>, CommandError> {
    let mut words = Vec::new();
    let mut word: Option<String> = None;
    let mut quoted = false;
    for c in text.chars() {
        match c {
            '"' => {
                quoted = !quoted;
                word.get_or_insert_default();
            }
            c if c.is_whitespace() && !quoted => words.extend(word.take()),
            c => word.get_or_insert_default().push(c),
        }
    }
    if quoted {
        return Err(CommandError::Quote(text.into()));
    }
    words.extend(word);
    Ok(words)
}

fn filter(words: &mut Words) -> Result<Command, CommandError> {
    filter_of("", words)
}

/// A filter from what follows its stroke, and from the conditions behind it.
fn filter_of(first: &str, words: &mut Words) -> Result<Command, CommandError> {
    let mut conditions: Vec<String> = Vec::new();
    if !first.is_empty() {
        conditions.push(first.into());
    }
    while let Some(word) = words.next_if(|word| word.contains('=') && !word.starts_with('/')) {
        conditions.push(word);
    }
    if conditions.is_empty() {
        return Ok(Command::Filter(None));
    }
    let filter = Filter::new(&conditions).map_err(CommandError::Filter)?;
    Ok(Command::Filter(Some(filter)))
}

#[expect(
    clippy::unnecessary_wraps,
    reason = "as the other commands with an argument"
)]
fn who(words: &mut Words) -> Result<Command, CommandError> {
    let asked = words.peek().and_then(|word| Asked::named(word));
    if asked.is_some() {
        words.next();
    }
    Ok(Command::Who(asked))
}

fn go(words: &mut Words) -> Result<Command, CommandError> {
    let step = words.next().ok_or(CommandError::NoStep)?;
    Ok(Command::Go(step))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn no_two_keys_have_a_name_or_a_word_in_common() {
        let names: Vec<&str> = KEYS
            .iter()
            .flat_map(|key| {
                let own = Some(key.key).filter(|own| !key.words.contains(own));
                key.words.iter().copied().chain(own)
            })
            .collect();
        let different: BTreeSet<&str> = names.iter().copied().collect();
        assert_eq!(different.len(), names.len());
        // no condition of a filter is a command, and no value of `w` is one
        assert!(names.iter().all(|name| !name.contains('=')));
        assert!(Asked::words().all(|value| !different.contains(value)));
    }

    #[test]
    fn a_line_holds_several_commands_and_arguments_follow_theirs() {
        let found = commands("into n N w t w g 37 /kind=cell object=\"two words\" back").unwrap();
        let words: Vec<String> = vec!["kind=cell".into(), "object=two words".into()];
        let expected = [
            Command::Move(Move::Into),
            Command::NextTarget,
            Command::PreviousTarget,
            Command::Who(Asked::named("t")),
            Command::Who(None),
            Command::Go("37".into()),
            Command::Filter(Some(Filter::new(&words).unwrap())),
            Command::Move(Move::Back),
        ];
        assert_eq!(found, expected);
        assert_eq!(commands("/ ↓ Shift+→ 3").unwrap().len(), 4);
        assert_eq!(commands("  ").unwrap(), []);
    }

    #[test]
    fn a_word_that_no_key_has_names_the_nearest() {
        let error = commands("n itno").unwrap_err();
        assert_eq!(
            error,
            CommandError::Unknown("itno".into(), Some("into".into()))
        );
        assert!(error.to_string().contains("did you mean into?"));
        assert_eq!(commands("g").unwrap_err(), CommandError::NoStep);
        assert!(matches!(commands("/\"a"), Err(CommandError::Quote(_))));
        assert!(matches!(
            commands("/kind=cel"),
            Err(CommandError::Filter(_))
        ));
    }

    #[test]
    fn a_pixel_beside_the_edge_of_the_picture_is_none() {
        assert_eq!(Shift::Left.from([0, 3], [8, 4]), None);
        assert_eq!(Shift::Right.from([7, 3], [8, 4]), None);
        assert_eq!(Shift::Down.from([7, 3], [8, 4]), None);
        assert_eq!(Shift::Up.from([7, 3], [8, 4]), Some([7, 2]));
        assert_eq!(Shift::Right.from([6, 3], [8, 4]), Some([7, 3]));
    }
}
