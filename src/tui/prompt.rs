//! A line that is typed at the lower edge: a filter, the number of a step, or a command by its word.

/// A line that is being typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Prompt {
    /// What stands before the line on the screen.
    pub(super) label: &'static str,
    /// What stands before it in the command that it makes.
    start: &'static str,
    /// What has been typed.
    pub(super) text: String,
}

/// What a key makes of a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Typed {
    /// It goes on.
    More,
    /// It is left without anything done.
    Left,
    /// It is a command.
    Done(String),
}

impl Prompt {
    /// The line that a key opens; `None` if it opens none.
    pub(super) fn of(key: &str) -> Option<Self> {
        let (label, start) = match key {
            "/" => ("filter: /", "/"),
            "g" => ("go to step: ", "g "),
            "W" => ("who set (t, near, far, colour, …): ", "w "),
            ":" => ("command: ", ""),
            _ => return None,
        };
        Some(Self {
            label,
            start,
            text: String::new(),
        })
    }

    /// One more key.
    pub(super) fn press(&mut self, key: &str) -> Typed {
        match key {
            "Enter" => return Typed::Done(format!("{}{}", self.start, self.text)),
            "Esc" => return Typed::Left,
            "Space" => self.text.push(' '),
            "Backspace" if self.text.is_empty() => return Typed::Left,
            "Backspace" => {
                self.text.pop();
            }
            key if key.chars().count() == 1 && !"↓↑→←".contains(key) => {
                self.text.push_str(key);
            }
            _ => {}
        }
        Typed::More
    }
}
