//! The questions of lessons: declared in `lesson.json`, answered by the trace.
//!
//! A question chooses a step of a trace ([`Selector`]) and says how it is answered ([`Ask`]). Its texts and its choices hold
//! expressions over the fields of that step, so that no number is typed by hand, and wrong numbers are what the functions
//! of mistakes return. The way of the data, a file each:
//!
//! ```text
//! spec       what lesson.json says           confusion, program   what is confused; lines to be put in order
//!   ▶ traced    the pixel, traced; which events a selector chooses; the changed scene
//!   ▶ facts     what names stand for, with expression; spoiled: what a wrong function returns instead
//!   ▶ asking    the question with its facts (situation) ▶ kinds/ a file for each kind of answer; shuffled: the order of choices
//!   ▶ asked     text, choices with reasons, answer, working, and where the step is; whether an answer is right
//! ```

mod asked;
mod asking;
mod confusion;
mod expression;
mod facts;
mod fault;
mod kinds;
mod program;
mod shuffled;
mod situation;
mod spec;
mod spoiled;
mod traced;

pub use asked::{
    Asked, AskedChoice, BlankForm, Form, Given, Judged, NumberForm, OrderForm, StepPlace, letter,
};
pub(in crate::lesson) use asking::ask;
pub use confusion::Confusion;
pub(in crate::lesson) use fault::Fault;
pub use program::ProgramName;
#[cfg(feature = "book")]
pub(crate) use shuffled::fnv_1a;
pub use spec::{
    Among, Ask, Blank, ChoiceSpec, Choices, Counterexample, Each, Number, Order, Program,
    QuestionSpec, Reason, Selector, Step, Vary, WrongNumber,
};
pub use traced::TracedPixel;
pub(in crate::lesson) use traced::edited;
