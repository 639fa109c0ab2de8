//! The description of an exercise.

use crate::explain::Part;
use crate::trace::Kind;

/// The description of an exercise: all but its cases.
#[derive(Debug)]
pub struct About {
    /// The number of the lesson.
    pub lesson: u8,
    /// Its name: lower-case letters, digits and `_`.
    pub name: &'static str,
    /// What is to be computed, in a few words.
    pub title: &'static str,
    /// The function that is to be written, in Rust.
    pub signature: &'static str,
    /// The named parts that the function works out, in this order: what the exercise teaches. The check compares those of them
    /// that the function returns.
    pub parts: &'static [Part],
    /// The named parts of earlier exercises that one needs.
    pub uses: &'static [Part],
    /// The names of the mistakes that can be made here.
    pub mistakes: &'static [&'static str],
    /// Where it can be seen.
    pub see: See,
    /// A nudge, the formula, the line.
    pub hints: [&'static str; 3],
    /// What is worth remembering once it works.
    pub take_away: &'static str,
    /// What to look at then.
    pub next: &'static str,
}

/// Where an exercise can be seen.
#[derive(Clone, Copy, Debug)]
pub enum See {
    /// A step of a pixel of a lesson's scene.
    Step {
        /// The scene, from the folder of the lessons.
        scene: &'static str,
        /// Column and row of the pixel.
        pixel: [u32; 2],
        /// How the nearest object is searched; every object is tested if empty.
        strategy: &'static str,
        /// The step of the pixel's log.
        at: u32,
        /// The kind of the event there.
        kind: Kind,
    },
    /// A figure, by its lesson and its name.
    Figure(&'static str),
}

impl About {
    /// The name with its lesson: `l04_roots`.
    pub fn id(&self) -> String {
        format!("l{:02}_{}", self.lesson, self.name)
    }
}
