//! A line of letters as the slides set it: variables in italics, real indices and exponents, a true minus.
//!
//! A plain text is what it says: a name of a scene may hold any letters. What the course writes is a [`formula`], and
//! the two are joined by `+`.

use std::ops::Add;

use glam::DVec2;

use crate::figure::sheet::font;
use crate::figure::sheet::frame::Frame;

/// Which point of a line of letters is placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::figure) enum Anchor {
    /// Its left end.
    Start,
    /// Its middle.
    Middle,
    /// Its right end.
    End,
}

/// On which height letters stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::figure) enum Level {
    /// On the line.
    Line,
    /// Below it, smaller: an index.
    Index,
    /// Above it, smaller: an exponent.
    Exponent,
}

impl Level {
    /// How far below the line the letters stand, in sizes of the text's letters.
    pub(in crate::figure) const fn drop(self) -> f64 {
        match self {
            Self::Line => 0.0,
            Self::Index => 0.22,
            Self::Exponent => -0.36,
        }
    }

    /// The size of the letters, in sizes of the text's letters.
    pub(in crate::figure) const fn size(self) -> f64 {
        match self {
            Self::Line => 1.0,
            Self::Index | Self::Exponent => 0.72,
        }
    }
}

/// Letters of one kind that stand beside each other.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::figure) struct Run {
    pub(in crate::figure) letters: String,
    pub(in crate::figure) italic: bool,
    pub(in crate::figure) level: Level,
}

/// A line of letters.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::figure) struct Text {
    pub(in crate::figure) runs: Vec<Run>,
}

impl Text {
    /// Adds a letter to the last run, or begins a new one.
    fn push(&mut self, letter: char, italic: bool, level: Level) {
        match self.runs.last_mut() {
            Some(run) if run.italic == italic && run.level == level => run.letters.push(letter),
            _ => self.runs.push(Run {
                letters: letter.into(),
                italic,
                level,
            }),
        }
    }

    /// How wide it is, in sizes of its letters.
    pub(in crate::figure) fn width(&self) -> f64 {
        let width = |run: &Run| run.level.size() * font::text_width(&run.letters);
        self.runs.iter().map(width).sum()
    }

    /// The rectangle that the letters fill: the anchor's point lies at half the height of a capital.
    pub(in crate::figure) fn frame(&self, anchor: Anchor, place: DVec2, size: f64) -> Frame {
        /// Half the height of a capital (DejaVu Sans).
        const MIDDLE: f64 = 0.36;
        /// From the line up to the top of the tallest letter, and down to the end of the longest.
        const UP: f64 = 0.78;
        const DOWN: f64 = 0.24;
        // digits end on the line
        let down = if self.is_digits() { 0.02 } else { DOWN };
        let width = self.width() * size;
        let left = match anchor {
            Anchor::Start => place.x,
            Anchor::Middle => place.x - 0.5 * width,
            Anchor::End => place.x - width,
        };
        let reach = |of: f64, sign: f64| {
            let reach = |run: &Run| of * run.level.size() + sign * run.level.drop();
            self.runs.iter().map(reach).fold(of, f64::max)
        };
        Frame {
            min: DVec2::new(left, place.y - (reach(UP, -1.0) - MIDDLE) * size),
            max: DVec2::new(left + width, place.y + (reach(down, 1.0) + MIDDLE) * size),
        }
    }

    fn is_digits(&self) -> bool {
        let letters = self.runs.iter().map(|run| run.letters.as_str());
        letters.flat_map(str::chars).all(|of| of.is_ascii_digit())
    }

    /// In lines that are no wider than that, in sizes of its letters: broken at blanks. A word that is wider than a line stands
    /// alone.
    pub(in crate::figure) fn wrapped(&self, room: f64) -> Vec<Self> {
        let mut lines = vec![Self::default()];
        let mut word = Self::default();
        let mut end = |word: &mut Self| {
            let word = std::mem::take(word);
            let Some(line) = lines.last_mut() else { return };
            if line.is_empty() {
                *line = word;
            } else if (line.clone() + " " + &word).width() <= room {
                *line = std::mem::take(line) + " " + word;
            } else {
                lines.push(word);
            }
        };
        for run in &self.runs {
            for letter in run.letters.chars() {
                if letter == ' ' {
                    end(&mut word);
                } else {
                    word.push(letter, run.italic, run.level);
                }
            }
        }
        end(&mut word);
        lines
    }

    pub(in crate::figure) fn is_empty(&self) -> bool {
        self.runs.is_empty()
    }
}

/// Plain letters; digits that Unicode has as indices and exponents become real ones.
impl From<&str> for Text {
    fn from(letters: &str) -> Self {
        let mut text = Self::default();
        for letter in letters.chars() {
            let (letter, level) = on_line(letter);
            text.push(letter, false, level);
        }
        text
    }
}

impl From<String> for Text {
    fn from(letters: String) -> Self {
        letters.as_str().into()
    }
}

impl From<&String> for Text {
    fn from(letters: &String) -> Self {
        letters.as_str().into()
    }
}

impl From<&Text> for Text {
    fn from(text: &Text) -> Self {
        text.clone()
    }
}

impl<T: Into<Text>> Add<T> for Text {
    type Output = Self;

    fn add(mut self, more: T) -> Self {
        for run in more.into().runs {
            match self.runs.last_mut() {
                Some(last) if last.italic == run.italic && last.level == run.level => {
                    last.letters.push_str(&run.letters);
                }
                _ => self.runs.push(run),
            }
        }
        self
    }
}

/// A formula of the course, as in `formula("t_1 = -D_min/T")`: letters that stand alone are variables and set in
/// italics, a word is set upright, `_` lowers the word or the number behind it, `-` is a minus.
pub(in crate::figure) fn formula(of: &str) -> Text {
    let letters: Vec<char> = of.chars().collect();
    let mut text = Text::default();
    let mut at = 0;
    while at < letters.len() {
        let is_index = letters[at] == '_';
        let start = at + usize::from(is_index);
        let belongs = if is_index {
            char::is_alphanumeric
        } else {
            char::is_alphabetic
        };
        let end = end_of_word(&letters, start, belongs);
        if is_index && start < end {
            let italic = is_variable(&letters[start..end]);
            for &letter in &letters[start..end] {
                text.push(letter, italic, Level::Index);
            }
            at = end;
            continue;
        }
        if start < end {
            word(&mut text, &letters[start..end]);
            at = end;
            continue;
        }
        let (letter, level) = on_line(letters[at]);
        let letter = if letter == '-' { '−' } else { letter };
        // an index that is a letter is a variable as well
        let italic = level != Level::Line && letter.is_alphabetic();
        text.push(letter, italic, level);
        at += 1;
    }
    text
}

/// Prose in which a letter may have an index, as in "the minimum D_min": such a word is a formula.
pub(in crate::figure) fn with_indices(prose: &str) -> Text {
    let has_index = |word: &str| {
        let before = word.split('_').next().unwrap_or_default();
        before.len() < word.len() && before.chars().filter(|c| c.is_alphanumeric()).count() == 1
    };
    let words = prose.split_inclusive(' ');
    words.fold(Text::default(), |text, word| {
        if has_index(word) {
            text + formula(word)
        } else {
            text + word
        }
    })
}

/// Where the letters end that begin there and belong to a word.
fn end_of_word(letters: &[char], start: usize, belongs: fn(char) -> bool) -> usize {
    let is_end = |letter: &char| !belongs(*letter) || on_line(*letter).1 != Level::Line;
    let rest = &letters[start..];
    start + rest.iter().position(is_end).unwrap_or(rest.len())
}

/// A word of a formula: a variable, a difference of one (Δx), or upright letters.
fn word(text: &mut Text, letters: &[char]) {
    let (first, rest) = match letters {
        ['Δ', rest @ ..] if !rest.is_empty() => (Some('Δ'), rest),
        all => (None, all),
    };
    if let Some(first) = first {
        text.push(first, false, Level::Line);
    }
    let italic = is_variable(rest);
    for &letter in rest {
        text.push(letter, italic, Level::Line);
    }
}

/// Is it one letter, or the product of 4ac? Capital Greek letters are set upright.
fn is_variable(letters: &[char]) -> bool {
    match letters {
        [letter] => letter.is_ascii_alphabetic() || ('α'..='ω').contains(letter),
        _ => letters == ['a', 'c'],
    }
}

/// The letter on the line, and where it stands.
fn on_line(letter: char) -> (char, Level) {
    const INDICES: &str = "₀₁₂₃₄₅₆₇₈₉ᵢₖₙₓ₊₋";
    const OF_INDICES: &str = "0123456789iknx+−";
    const EXPONENTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹ⁿ⁺⁻";
    const OF_EXPONENTS: &str = "0123456789n+−";
    for (from, to, level) in [
        (INDICES, OF_INDICES, Level::Index),
        (EXPONENTS, OF_EXPONENTS, Level::Exponent),
    ] {
        let place = from.chars().position(|of| of == letter);
        if let Some(found) = place.and_then(|place| to.chars().nth(place)) {
            return (found, level);
        }
    }
    (letter, Level::Line)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The runs as text: italics between `*`, indices behind `_`, exponents behind `^`.
    fn told(text: &Text) -> String {
        let told = |run: &Run| {
            let level = match run.level {
                Level::Line => "",
                Level::Index => "_",
                Level::Exponent => "^",
            };
            let star = if run.italic { "*" } else { "" };
            format!("{level}{star}{}{star}", run.letters)
        };
        text.runs.iter().map(told).collect()
    }

    #[test]
    fn a_formula_is_set_as_the_slides_set_it() {
        for (of, expected) in [
            ("t_1 = -D_min/T", "*t*_1 = −*D*_min/*T*"),
            ("A·Δx + B·Δy = 0", "*A*·Δ*x* + *B*·Δ*y* = 0"),
            ("f(t) = t² - 6t + 5", "*f*(*t*) = *t*^2 − 6*t* + 5"),
            ("b² - 4ac", "*b*^2 − 4*ac*"),
            ("n₁ sin θ₁", "*n*_1 sin *θ*_1"),
            ("x_k ≤ max(a, bc)", "*x*_*k* ≤ max(*a*, bc)"),
            ("p′", "*p*′"),
            ("a_ b", "*a*_ *b*"),
        ] {
            assert_eq!(told(&formula(of)), expected);
        }
    }

    #[test]
    fn a_name_stays_as_it_is_but_for_its_digits() {
        assert_eq!(told(&"a_b - t".into()), "a_b - t");
        assert_eq!(told(&"ball₁²".into()), "ball_1^2");
        let joined = formula("t = ") + "a_b" + String::from(" - t");
        assert_eq!(told(&joined), "*t* = a_b - t");
    }

    #[test]
    fn prose_has_formulas_where_a_letter_has_an_index() {
        let text = with_indices("A takes D_min, from (−D_max) of scan_line");
        assert_eq!(told(&text), "A takes *D*_min, from (−*D*_max) of scan_line");
    }

    #[test]
    fn an_index_is_narrower_and_reaches_below_the_line() {
        // DejaVu Sans: D has 1577 units of 2048, 1 has 1303
        let text = formula("D_1");
        let width = (1577.0 + 0.72 * 1303.0) / 2048.0;
        assert!((text.width() - width).abs() < 1e-12);
        let [plain, index] =
            [formula("D"), text].map(|text| text.frame(Anchor::Start, DVec2::ZERO, 10.0));
        assert!(plain.max.y < index.max.y && plain.min.y == index.min.y);
    }
}
