//! An exercise with its cases, and how it is checked.

use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};

use glam::DVec3;

use crate::explain::Part;
use crate::figure::{SketchForm, SketchMark, Whose, sketch};
use crate::lesson::exercise::answer::{first_difference, is_same_answer, label};
use crate::lesson::exercise::{
    About, Answer, CaseSaid, Compared, Divergence, Outcome, Seeds, Silent, Value, Watch,
};
use crate::mistake::{Mistake, Wrong, mistake};

/// An exercise: `I` is what goes into a case, `F` the function that a student writes.
#[derive(Debug)]
pub struct Task<I: 'static, F> {
    /// Its description.
    pub about: About,
    /// The cases: those made by hand first, each with what is special in it, then seeded ones.
    pub cases: fn(&Seeds) -> Vec<Case<I>>,
    /// What goes into a case, in words.
    pub given: fn(&I) -> String,
    /// What a function gives in a case.
    pub answer: fn(F, &I, &dyn Watch) -> Answer,
    /// The right function.
    pub own: F,
    /// What a mistake gives in a case; nothing if it cannot be made here.
    pub mistaken: fn(&Wrong, &I) -> Option<Answer>,
    /// Answers that are right in another form of the formula.
    pub forms: &'static [Form<I>],
    /// What is drawn of a case, whatever the answer is.
    pub scenery: fn(&I) -> Vec<SketchMark>,
    /// What is drawn of an answer; nothing draws each number and vector of it.
    pub marks: Option<fn(&I, &Answer) -> Vec<SketchMark>>,
}

/// A case.
#[derive(Clone, Debug)]
pub struct Case<I> {
    /// What is special in it.
    pub note: String,
    /// What goes in.
    pub input: I,
}

impl<I> Case<I> {
    /// A case with what is special in it.
    pub fn new(note: impl Into<String>, input: I) -> Self {
        Self {
            note: note.into(),
            input,
        }
    }
}

/// An answer that is right in another form of the formula, but is not what was asked for.
#[derive(Debug)]
pub struct Form<I> {
    /// Is it this form?
    pub is: fn(&I, &Answer) -> bool,
    /// Which form is meant.
    pub note: &'static str,
}

/// An exercise of any kind.
pub trait Exercise: Sync {
    /// Its description.
    fn about(&self) -> &About;

    /// The parts of the quantities that are compared.
    fn compared(&self) -> Vec<Part>;

    /// What goes into each case, in words.
    fn given(&self, seeds: &Seeds) -> Vec<String>;

    /// Checks the crate's own function.
    fn check_own(&self) -> Outcome;

    /// Checks a mistake as if a student had made it; nothing if the exercise does not list it.
    fn check_mistake(&self, mistake: &Mistake) -> Option<Outcome>;
}

/// A student's function, to be checked.
pub trait Attempt {
    /// The exercise.
    fn about(&self) -> &'static About;

    /// Is it right? A panic is caught. A function that does not come back never ends the check: that is for the caller to end.
    fn check(&self, watch: &dyn Watch) -> Outcome {
        self.check_with(&Seeds::PUBLIC, watch)
    }

    /// The same with the cases of other seeds.
    fn check_with(&self, seeds: &Seeds, watch: &dyn Watch) -> Outcome;
}

/// A task with a student's function.
struct OfStudent<I: 'static, F: 'static> {
    task: &'static Task<I, F>,
    function: F,
}

impl<I, F: Copy> Attempt for OfStudent<I, F> {
    fn about(&self) -> &'static About {
        &self.task.about
    }

    fn check_with(&self, seeds: &Seeds, watch: &dyn Watch) -> Outcome {
        let task = self.task;
        task.check(seeds, watch, |input, watch| {
            (task.answer)(self.function, input, watch)
        })
    }
}

impl<I: Sync, F: Copy + Sync> Exercise for Task<I, F> {
    fn about(&self) -> &About {
        &self.about
    }

    fn compared(&self) -> Vec<Part> {
        let cases = (self.cases)(&Seeds::PUBLIC);
        let first = cases.first().map(|case| self.expected(&case.input));
        let quantities = first.into_iter().flatten();
        quantities.map(|(part, _, _)| part).collect()
    }

    fn given(&self, seeds: &Seeds) -> Vec<String> {
        let cases = self.cases_of(seeds);
        cases.iter().map(|case| (self.given)(&case.input)).collect()
    }

    fn check_own(&self) -> Outcome {
        self.check(&Seeds::PUBLIC, &Silent, |input, watch| {
            (self.answer)(self.own, input, watch)
        })
    }

    fn check_mistake(&self, mistake: &Mistake) -> Option<Outcome> {
        let wrong = &mistake.wrong;
        self.about.mistakes.contains(&mistake.name).then(|| {
            self.check(&Seeds::PUBLIC, &Silent, |input, _| {
                (self.mistaken)(wrong, input).unwrap_or_default()
            })
        })
    }
}

/// A case in which a quantity differs. There is no answer if the function panicked there.
struct Failing {
    case: usize,
    quantity: usize,
    yours: Option<Answer>,
}

impl<I, F: Copy> Task<I, F> {
    /// The exercise with the function that a student has written.
    pub fn with(&'static self, function: F) -> Box<dyn Attempt>
    where
        I: 'static,
        F: 'static,
    {
        Box::new(OfStudent {
            task: self,
            function,
        })
    }

    /// The cases. Of a secret only those that the public ones have not, if there is any such case.
    fn cases_of(&self, seeds: &Seeds) -> Vec<Case<I>> {
        let all = (self.cases)(seeds);
        if !seeds.are_secret() {
            return all;
        }
        let words = |case: &Case<I>| (self.given)(&case.input);
        let public: BTreeSet<String> = (self.cases)(&Seeds::PUBLIC).iter().map(words).collect();
        let (own, known): (Vec<_>, Vec<_>) = all
            .into_iter()
            .partition(|case| !public.contains(&words(case)));
        if own.is_empty() { known } else { own }
    }

    fn check(
        &self,
        seeds: &Seeds,
        watch: &dyn Watch,
        student: impl Fn(&I, &dyn Watch) -> Answer,
    ) -> Outcome {
        let cases = self.cases_of(seeds);
        let mut failing: Vec<Failing> = Vec::new();
        for (place, case) in cases.iter().enumerate() {
            watch.case(place + 1, &case.note);
            let expected = self.expected(&case.input);
            let caught = catch_unwind(AssertUnwindSafe(|| student(&case.input, watch)));
            match caught {
                Ok(yours) => {
                    if let Some(quantity) = first_difference(&yours, &expected) {
                        failing.push(Failing {
                            case: place,
                            quantity,
                            yours: Some(yours),
                        });
                    }
                }
                Err(thrown) => {
                    let what = told(&*thrown);
                    if failing.is_empty() && what.starts_with(TODO) {
                        return Outcome::NotWritten;
                    }
                    if failing.is_empty() {
                        let at = watch.panicked_at();
                        let at = at.map_or(String::new(), |at| format!(" at {at}"));
                        return Outcome::Broken {
                            what: format!("it panicked{at}: {what}"),
                            case: Some(self.said(place, case)),
                            place: None,
                        };
                    }
                    failing.push(Failing {
                        case: place,
                        quantity: 0,
                        yours: None,
                    });
                }
            }
        }
        let Some(Failing {
            case,
            quantity,
            yours: Some(yours),
        }) = failing.first()
        else {
            return Outcome::Right { cases: cases.len() };
        };
        let input = &cases[*case].input;
        let expected = self.expected(input);
        let form = self.forms.iter().find(|form| {
            let is = |of: &Failing| {
                let yours = of.yours.as_ref();
                yours.is_some_and(|yours| (form.is)(&cases[of.case].input, yours))
            };
            failing.iter().all(is)
        });
        let form = form.map(|form| form.note);
        let lines = yours.iter().zip(&expected).take(quantity + 1);
        let lines: Vec<Compared> = lines
            .map(|((part, symbol, yours), (_, _, expected))| {
                let [mine, right] = Value::pair(yours, expected);
                Compared {
                    label: label(*part, symbol),
                    yours: mine,
                    expected: right,
                    is_same: yours.is_same(expected),
                }
            })
            .collect();
        Outcome::Wrong(Box::new(Divergence {
            case: self.said(*case, &cases[*case]),
            failing: failing.len(),
            cases: cases.len(),
            mistake: match form {
                Some(_) => None,
                None => self.recognised(&cases, &failing),
            },
            form,
            picture: self.picture(input, yours, &expected, &lines),
            lines,
        }))
    }

    fn expected(&self, input: &I) -> Answer {
        (self.answer)(self.own, input, &Silent)
    }

    fn said(&self, place: usize, case: &Case<I>) -> CaseSaid {
        CaseSaid {
            number: place + 1,
            note: case.note.clone(),
            given: (self.given)(&case.input),
        }
    }

    /// The mistake that gives the student's values in every failing case, and that fails in no more than twice as many: who
    /// errs in one case alone has not made a mistake that spoils thirty. Where an answer is a word it must fail in the same
    /// cases, since of two words the wrong one is easily the same.
    fn recognised(&self, cases: &[Case<I>], failing: &[Failing]) -> Option<&'static Mistake> {
        let of = |place: usize, wrong: &Wrong| (self.mistaken)(wrong, &cases[place].input);
        let gives = |found: &&'static Mistake| {
            failing.iter().all(|failed| {
                let wrong = of(failed.case, &found.wrong);
                match (&failed.yours, wrong) {
                    (Some(yours), Some(wrong)) => is_same_answer(yours, &wrong),
                    _ => false,
                }
            })
        };
        let spoiled = |found: &&'static Mistake| {
            let places = 0..cases.len();
            let is_spoiled = |place: &usize| {
                let expected = self.expected(&cases[*place].input);
                of(*place, &found.wrong)
                    .is_none_or(|wrong| first_difference(&wrong, &expected).is_some())
            };
            places.filter(is_spoiled).count()
        };
        let known = self.about.mistakes.iter().filter_map(|name| mistake(name));
        let found: Vec<&'static Mistake> = known.filter(gives).collect();
        let best = found.into_iter().min_by_key(spoiled)?;
        let first = failing.first()?;
        let value = first.yours.as_ref()?.get(first.quantity);
        let is_word = value.is_some_and(|(_, _, value)| value.is_word());
        let most = if is_word { 1 } else { 2 } * failing.len();
        (spoiled(&best) <= most).then_some(best)
    }

    /// Both answers.
    fn picture(&self, input: &I, yours: &Answer, expected: &Answer, lines: &[Compared]) -> String {
        let mut marks: Vec<(Whose, SketchMark)> = (self.scenery)(input)
            .into_iter()
            .map(|mark| (Whose::Given, mark))
            .collect();
        for (whose, answer) in [(Whose::Yours, yours), (Whose::Expected, expected)] {
            let of_answer = match self.marks {
                Some(marks) => marks(input, answer),
                None => plain_marks(answer),
            };
            marks.extend(of_answer.into_iter().map(|mark| (whose, mark)));
        }
        let mut numbers = vec![(Whose::Given, (self.given)(input))];
        if let Some(line) = lines.last() {
            numbers.push((Whose::Yours, format!("{}: {}", line.label, line.yours)));
            numbers.push((
                Whose::Expected,
                format!("{}: {}", line.label, line.expected),
            ));
        }
        let description: Vec<&str> = numbers.iter().map(|(_, text)| text.as_str()).collect();
        let title = format!("{}: {}", self.about.id(), self.about.title);
        let id = self.about.id().replace('_', "-");
        sketch(&id, [&title, &description.join(". ")], &marks, &numbers)
    }
}

/// How the message of `todo!` begins.
const TODO: &str = "not yet implemented";

/// The message of a panic.
fn told(thrown: &(dyn std::any::Any + Send)) -> String {
    let text = thrown.downcast_ref::<&str>().map(ToString::to_string);
    text.or_else(|| thrown.downcast_ref::<String>().cloned())
        .unwrap_or_else(|| "a panic without words".into())
}

/// Each vector from the origin, each number as a bar in a row of its own.
fn plain_marks(answer: &Answer) -> Vec<SketchMark> {
    let mut marks = Vec::new();
    let mut bar = |row: usize, value: f64, name: &str| {
        let foot = DVec3::new(0.0, -(row as f64), 0.0);
        marks.push(SketchMark {
            form: SketchForm::Arrow(foot, foot + DVec3::X * value),
            name: name.into(),
        });
    };
    for (row, (part, symbol, value)) in answer.iter().enumerate() {
        let name = label(*part, symbol);
        match value {
            Value::Number(x) | Value::About { number: x, .. } => bar(row, *x, &name),
            Value::Numbers(numbers) => numbers.iter().for_each(|x| bar(row, *x, &name)),
            Value::Parity(count) => bar(row, *count as f64, &name),
            Value::Vector(_) | Value::Word(_) => {}
        }
    }
    for (part, symbol, value) in answer {
        if let Value::Vector(v) = value {
            marks.push(SketchMark {
                form: SketchForm::Arrow(DVec3::ZERO, *v),
                name: label(*part, symbol),
            });
        }
    }
    marks
}
