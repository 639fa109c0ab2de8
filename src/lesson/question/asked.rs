//! A question as it is asked: its text, its choices with their reasons, the answer, the working, and where its step is.

use std::collections::BTreeSet;

use crate::explain::{Line, shown};
use crate::lesson::question::confusion::Confusion;
use crate::lesson::question::traced::TracedPixel;
use crate::step::Address;

/// A question that was traced and answered.
#[derive(Clone, Debug)]
pub struct Asked {
    /// The folder of the lesson.
    pub lesson: String,
    /// Its name in the lesson.
    pub name: String,
    /// The question.
    pub text: String,
    /// How it is answered, and the answer.
    pub form: Form,
    /// Lines of the working: the question's own, then those of its step.
    pub working: Vec<Line>,
    /// The step that it is about.
    pub place: StepPlace,
    /// The figure that is shown with it, as in `04-sphere/two-roots`.
    pub figure: Option<String>,
    /// What students confuse here.
    pub confusions: Vec<Confusion>,
    /// The pixel's trace, so that a stepper can be opened on it.
    pub traced: TracedPixel,
}

/// Where the step of a question is.
#[derive(Clone, Debug, PartialEq)]
pub struct StepPlace {
    /// The folder of the lesson that has the scene.
    pub lesson: String,
    /// The scene's file in that folder.
    pub scene: String,
    /// The pixel.
    pub pixel: [u32; 2],
    /// The step.
    pub step: Address,
    /// The event that the question is about, by its place among the records.
    pub event: usize,
}

/// How a question is answered, with the answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// By a number.
    Number(NumberForm),
    /// By one of the choices: one is right.
    Choice(Vec<AskedChoice>),
    /// By all choices that are right.
    Several(Vec<AskedChoice>),
    /// By one place of the figure: one is right.
    Place(Vec<AskedChoice>),
    /// By an order of the choices that are right.
    Order(OrderForm),
    /// By the quantities that are taken out of lines.
    Blank(BlankForm),
}

/// A choice.
#[derive(Clone, Debug, PartialEq)]
pub struct AskedChoice {
    /// What is chosen.
    pub text: String,
    /// Is it right? Of an order: does it belong to it?
    pub right: bool,
    /// Why it is right or wrong.
    pub reason: String,
    /// The mistake that leads to it, by its name.
    pub mistake: Option<&'static str>,
}

/// A number that is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct NumberForm {
    /// The right one.
    pub answer: f64,
    /// Its unit; empty: it has none.
    pub unit: String,
    /// How far an answer may be from it.
    pub tolerance: f64,
    /// Why it is right.
    pub reason: String,
    /// Wrong numbers, with their reasons.
    pub wrong: Vec<(f64, AskedChoice)>,
}

/// An order that is asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct OrderForm {
    /// What is put in order, as it is shown; those that are not right are no part of it.
    pub items: Vec<AskedChoice>,
    /// An order that is right, by the places among the items.
    pub order: Vec<usize>,
    /// Which item must come before which: each order that respects these pairs is right.
    pub before: Vec<(usize, usize)>,
}

/// Lines with quantities taken out.
#[derive(Clone, Debug, PartialEq)]
pub struct BlankForm {
    /// The lines, with `[1]`, `[2]` … for the quantities.
    pub lines: Vec<String>,
    /// The quantities, each with how far an answer may be from it.
    pub answers: Vec<(f64, f64)>,
    /// Why these are the values.
    pub reason: String,
}

/// An answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Given {
    /// A number.
    Number(f64),
    /// A choice by its place.
    Choice(usize),
    /// Choices by their places.
    Several(BTreeSet<usize>),
    /// Items by their places, in their order.
    Order(Vec<usize>),
    /// Numbers for the blanks, in their order.
    Blanks(Vec<f64>),
}

/// What is said to an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// Is it right?
    pub right: bool,
    /// Why it is right or wrong.
    pub reason: String,
}

/// Digits of a number in an answer.
const DIGITS: u32 = 6;

/// The letter of a choice by its place: a, b, c …
pub fn letter(place: usize) -> char {
    let place = u8::try_from(place).unwrap_or(u8::MAX);
    char::from(b'a'.saturating_add(place.min(25)))
}

impl Form {
    /// The choices; none for numbers and blanks.
    pub fn choices(&self) -> &[AskedChoice] {
        match self {
            Self::Choice(choices) | Self::Several(choices) | Self::Place(choices) => choices,
            Self::Order(order) => &order.items,
            Self::Number(_) | Self::Blank(_) => &[],
        }
    }
}

impl Asked {
    /// An answer that is right.
    pub fn right(&self) -> Given {
        match &self.form {
            Form::Number(number) => Given::Number(number.answer),
            Form::Choice(choices) | Form::Place(choices) => {
                let right = choices.iter().position(|choice| choice.right);
                Given::Choice(right.unwrap_or_default())
            }
            Form::Several(choices) => {
                let all = choices.iter().enumerate();
                Given::Several(
                    all.filter(|(_, of)| of.right)
                        .map(|(place, _)| place)
                        .collect(),
                )
            }
            Form::Order(order) => Given::Order(order.order.clone()),
            Form::Blank(blank) => Given::Blanks(blank.answers.iter().map(|of| of.0).collect()),
        }
    }

    /// What answers are accepted, in words.
    pub fn accepts(&self) -> String {
        let last = letter(self.form.choices().len().saturating_sub(1));
        match &self.form {
            Form::Number(number) if number.unit.is_empty() => {
                "give a number, such as 2.5 or 1e-3".into()
            }
            Form::Number(number) => {
                format!("give a number in {}, such as 2.5 or 1e-3", number.unit)
            }
            Form::Choice(_) | Form::Place(_) => format!("give one letter, a to {last}"),
            Form::Several(_) => {
                format!("give all letters that are right, a to {last}, as in a c; or none")
            }
            Form::Order(order) => format!(
                "give the letters of all that belong to it in their order, as in {} {}; the letters are a to {last}",
                letter(1),
                letter(0)
            )
            .replace("all that belong to it", if order.items.iter().all(|of| of.right) {
                "all"
            } else {
                "all that belong to it"
            }),
            Form::Blank(blank) => match blank.answers.len() {
                1 => "give a number".into(),
                count => format!("give {count} numbers with spaces between them, for [1] to [{count}]"),
            },
        }
    }

    /// Reads an answer.
    ///
    /// # Errors
    /// It is none: what is accepted.
    pub fn read(&self, text: &str) -> Result<Given, String> {
        let count = self.form.choices().len();
        let refused = || format!("{:?} is no answer: {}", text.trim(), self.accepts());
        match &self.form {
            Form::Number(of) => {
                let text = text.trim();
                let bare = text.strip_suffix(of.unit.as_str()).unwrap_or(text);
                number(bare).map(Given::Number).ok_or_else(refused)
            }
            Form::Choice(_) | Form::Place(_) => match letters(text, count).as_deref() {
                Some(&[place]) => Ok(Given::Choice(place)),
                _ => Err(refused()),
            },
            Form::Several(_) if text.trim() == "none" => Ok(Given::Several(BTreeSet::new())),
            Form::Several(_) => match letters(text, count) {
                Some(places) if !places.is_empty() => {
                    Ok(Given::Several(places.into_iter().collect()))
                }
                _ => Err(refused()),
            },
            Form::Order(_) => match letters(text, count) {
                Some(places) if !places.is_empty() => Ok(Given::Order(places)),
                _ => Err(refused()),
            },
            Form::Blank(blank) => {
                let words = text
                    .split([' ', ';', '\t'])
                    .filter(|word| !word.trim().is_empty());
                let numbers: Option<Vec<f64>> = words.map(number).collect();
                let numbers = numbers.filter(|of| of.len() == blank.answers.len());
                numbers.map(Given::Blanks).ok_or_else(refused)
            }
        }
    }

    /// Is an answer right, and why?
    pub fn answer(&self, given: &Given) -> Judged {
        let right = |reason: &str| Judged {
            right: true,
            reason: reason.into(),
        };
        let wrong = |reason: String| Judged {
            right: false,
            reason,
        };
        match (&self.form, given) {
            (Form::Number(of), Given::Number(number)) => {
                if (number - of.answer).abs() <= of.tolerance {
                    return right(&of.reason);
                }
                let is_it =
                    |(value, _): &&(f64, AskedChoice)| (number - value).abs() <= of.tolerance;
                match of.wrong.iter().find(is_it) {
                    Some((_, choice)) => wrong(choice.reason.clone()),
                    None => wrong(of.reason.clone()),
                }
            }
            (Form::Choice(choices) | Form::Place(choices), Given::Choice(place)) => {
                match choices.get(*place) {
                    Some(choice) => Judged {
                        right: choice.right,
                        reason: choice.reason.clone(),
                    },
                    None => wrong(self.accepts()),
                }
            }
            (Form::Several(choices), Given::Several(places)) => {
                let mut of_wrong = choices.iter().enumerate().filter_map(|(place, choice)| {
                    let is_given = places.contains(&place);
                    let word = if is_given { "is not" } else { "is" };
                    (is_given != choice.right)
                        .then(|| format!("{} {word} one of them: {}", letter(place), choice.reason))
                });
                match of_wrong.next() {
                    Some(reason) => wrong(reason),
                    None => right("All that are right are named, and no other."),
                }
            }
            (Form::Order(order), Given::Order(places)) => match order.fault(places) {
                Some(reason) => wrong(reason),
                None => right("Each comes where it must."),
            },
            (Form::Blank(blank), Given::Blanks(numbers)) => {
                let pairs = numbers.iter().zip(&blank.answers);
                let differs = |(number, (answer, tolerance)): (&f64, &(f64, f64))| {
                    tolerance < &(number - answer).abs()
                };
                let first = pairs.map(differs).position(|differs| differs);
                match first {
                    _ if numbers.len() != blank.answers.len() => wrong(self.accepts()),
                    None => right(&blank.reason),
                    Some(place) => wrong(format!(
                        "[{}] is {}, and not {}. {}",
                        place + 1,
                        shown(blank.answers[place].0, DIGITS),
                        shown(numbers[place], DIGITS),
                        blank.reason
                    )),
                }
            }
            _ => wrong(self.accepts()),
        }
    }

    /// The answer in words: `b`, `a c`, `2.5 pixels`.
    pub fn answer_text(&self) -> String {
        let spaced = |places: &mut dyn Iterator<Item = usize>| {
            let letters: Vec<String> = places.map(|place| letter(place).to_string()).collect();
            letters.join(" ")
        };
        match (&self.form, self.right()) {
            (Form::Number(of), _) => {
                let number = shown(of.answer, DIGITS);
                format!("{number} {}", of.unit).trim_end().into()
            }
            (_, Given::Choice(place)) => letter(place).into(),
            (_, Given::Several(places)) if places.is_empty() => "none".into(),
            (_, Given::Several(places)) => spaced(&mut places.into_iter()),
            (_, Given::Order(places)) => spaced(&mut places.into_iter()),
            (_, Given::Blanks(numbers)) => {
                let numbers: Vec<String> = numbers.iter().map(|of| shown(*of, DIGITS)).collect();
                numbers.join(" ")
            }
            (_, Given::Number(number)) => shown(number, DIGITS),
        }
    }

    /// Every choice with its reason, one a line; of an order first the right one, of a number and of blanks the answer first.
    pub fn reasons(&self) -> Vec<String> {
        let of_choice = |(place, choice): (usize, &AskedChoice)| {
            let letter = letter(place);
            let word = match (&self.form, choice.right) {
                (Form::Order(_), true) => "belongs to it",
                (Form::Order(_), false) => "does not belong to it",
                (_, true) => "is right",
                (_, false) => "is wrong",
            };
            format!("{letter} {word}: {}", choice.reason)
        };
        match &self.form {
            Form::Number(of) => {
                let right = format!("{} is right: {}", self.answer_text(), of.reason);
                let wrong = of.wrong.iter().map(|(value, choice)| {
                    let value = format!("{} {}", shown(*value, DIGITS), of.unit);
                    format!("{} is wrong: {}", value.trim_end(), choice.reason)
                });
                std::iter::once(right).chain(wrong).collect()
            }
            Form::Blank(blank) => {
                let answers = blank.answers.iter().enumerate();
                let texts = answers.map(|(place, (answer, _))| {
                    format!("[{}] is {}.", place + 1, shown(*answer, DIGITS))
                });
                texts.chain([blank.reason.clone()]).collect()
            }
            Form::Order(order) => {
                let is_right = |place: &usize| order.order.contains(place);
                let others = (0..order.items.len()).filter(|place| !is_right(place));
                let places = order.order.iter().copied().chain(others);
                places
                    .map(|place| of_choice((place, &order.items[place])))
                    .collect()
            }
            form => form.choices().iter().enumerate().map(of_choice).collect(),
        }
    }
}

impl OrderForm {
    /// What is wrong with an order, if something is.
    fn fault(&self, places: &[usize]) -> Option<String> {
        for (place, item) in places.iter().map(|place| (place, self.items.get(*place))) {
            let item = item?;
            if !item.right {
                return Some(format!(
                    "{} does not belong to it: {}",
                    letter(*place),
                    item.reason
                ));
            }
        }
        let at = |item: usize| places.iter().position(|place| *place == item);
        for &item in &self.order {
            let Some(own) = at(item) else {
                return Some(format!(
                    "{} is missing: {}",
                    letter(item),
                    self.items[item].reason
                ));
            };
            let first = self.before.iter().filter(|(_, later)| *later == item);
            for (first, _) in first {
                if at(*first).is_none_or(|first| own < first) {
                    return Some(format!(
                        "{} comes before {}: {}",
                        letter(*first),
                        letter(item),
                        self.items[item].reason
                    ));
                }
            }
        }
        let is_twice = self.order.len() < places.len();
        is_twice.then(|| "One of them is named twice.".into())
    }
}

/// A number as people write it: with a point or a comma, a real minus sign, or as a fraction.
fn number(text: &str) -> Option<f64> {
    let text = text.trim().replace('−', "-").replace(',', ".");
    let number = match text.split_once('/') {
        Some((above, below)) => {
            above.trim().parse::<f64>().ok()? / below.trim().parse::<f64>().ok()?
        }
        None => text.parse().ok()?,
    };
    number.is_finite().then_some(number)
}

/// The places of letters; `None` if one is no choice.
fn letters(text: &str, count: usize) -> Option<Vec<usize>> {
    let places = text
        .chars()
        .filter(|c| !c.is_whitespace() && *c != ',')
        .map(|c| {
            let place = u32::from(c.to_ascii_lowercase()).checked_sub('a'.into())?;
            usize::try_from(place).ok().filter(|place| *place < count)
        });
    places.collect()
}
