//! The stepper in a terminal: the tree of steps, the working of the step, the state, and the drawing up to the step.
//!
//! What is shown and what a key does are apart, so that tests press keys without a terminal:
//!
//! ```text
//! key ─▶ app     what a key does: App::press, over step::Reader; what it cannot do alone is an Effect
//!         │        rows     the steps that are visible, around the one where the reader stands
//!         │        prompt   a line that is typed: a filter, a step, a command
//!         ▼
//!        view    App → a frame: layout, and a file for each part
//!         │        sign, look   what became of a step as a sign, and colours
//!         ▼
//!        screen  the terminal: keys in, frames out, restored whatever ends the program
//! ```
//!
//! All words come from [`step`](crate::step) and [`explain`](crate::explain), the drawing from [`figure`](crate::figure). Who
//! holds the scene does what an [`Effect`] asks for: it traces another pixel, saves, knows the command line.

mod app;
mod look;
mod prompt;
mod rows;
mod screen;
mod sign;
mod view;

pub use app::{App, Effect, Kept, Titles};
pub use look::{Colours, Look};
pub use screen::{Screen, restore};
pub use view::draw;
