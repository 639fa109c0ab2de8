//! A log as a tree of steps: walked forwards and backwards, with the state at each of them.
//!
//! A step is not an event. The events of a pixel are put together into steps of five [`Level`]s: the building, a path of
//! light or the pixel; a ray; a place, which is a node of the hierarchy or a cell of the grid; a test; a term of it. Many
//! siblings of one kind and verdict are one step, "7 379 spheres missed". Each event is a leaf of the tree, so the leaves
//! are the log in its order.
//!
//! The way of the data, a file each:
//!
//! ```text
//! records ─▶ group   which events make a place or a test together
//!          ▶ state   what is known after an event, its quantities, and which event set each (setter); states keeps some
//!          ▶ builder the steps, in one pass over the records; fold puts siblings together
//!          ▶ tree    the steps of a log
//!                     │
//!                     ├─ cursor    where one stands, and the moves: over, back, into, out, leaf, level
//!                     ├─ interest, filter   the targets: by themselves, or what a reader asks for
//!                     ├─ known   all that is known after a step
//!                     ├─ change, who        what a step changed, old → new; which step set a quantity
//!                     ├─ address, same      a step by the log's number; the same place in another log
//!                     ├─ question  what a step asks before it shows its verdict, with choices and reasons
//!                     ├─ words, headline    the lines of `explain` that tell a step, and its title
//!                     ├─ told    all that a step says, the same in every face
//!                     └─ moves   the moves from every step as tables, for a face that has no log
//! reader    where one stands in a log, and what a command does: the same in every face
//! keys      the moves by their keys and words: one table for every face
//! ```
//!
//! Nothing here traces, reads or writes.

mod address;
mod builder;
mod change;
mod cursor;
mod filter;
mod fold;
mod group;
mod headline;
mod interest;
mod keys;
mod known;
mod level;
mod moves;
mod quantity;
mod question;
mod reader;
mod same;
mod setter;
mod state;
mod states;
#[expect(
    clippy::module_inception,
    reason = "the file is found by the name of its idea"
)]
mod step;
mod told;
mod tree;
mod verdict;
mod who;
mod words;

pub use address::{Address, AddressError};
pub use change::Change;
pub use cursor::{Cursor, Grain, Move};
pub use filter::{Filter, FilterError};
pub use headline::{headline, subject};
pub use interest::Interest;
pub use keys::{Command, CommandError, KEYS, Key, PAGE, Shift, commands};
pub use known::Known;
pub use level::Level;
pub use moves::{Moves, MovesFrom};
pub use quantity::{Held, Quantity, Value};
pub use question::{Asks, Choice, LETTERS, Question};
pub use reader::{Reaction, Reader};
pub use same::same_place;
pub use state::{RayState, State};
pub use step::Step;
pub use told::Told;
pub use tree::StepLog;
pub use verdict::Became;
pub use who::{Asked, Setter};
pub use words::StepWords;
