//! A question with its choices.

use crate::mistake::Mistake;

/// What a question is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Asks {
    /// How many real roots has the equation?
    RootCount,
    /// Which root is the hit?
    RootThatCounts,
    /// Where does the ray hit the plane, or is it parallel?
    PlaneT,
    /// Which coordinate is dropped?
    DroppedAxis,
    /// Is the point inside the polygon?
    Inside,
    /// Which slab ends the test of a bound?
    SlabThatEnds,
    /// What becomes of a bound?
    Bound,
    /// Which node leaves the heap?
    NextNode,
    /// Is a node entered or pruned?
    Pruned,
    /// Which plane of the grid is crossed next?
    NextPlane,
    /// Must an object of a cell's list be tested?
    Mailbox,
    /// May the walk end with this hit?
    FinalHit,
    /// Is the light blocked, and by what?
    Blocked,
    /// Which terms of a light are 0?
    ZeroTerms,
    /// Is all light reflected?
    TotalReflection,
}

impl Asks {
    /// All kinds of questions.
    pub const ALL: [Self; 15] = [
        Self::RootCount,
        Self::RootThatCounts,
        Self::PlaneT,
        Self::DroppedAxis,
        Self::Inside,
        Self::SlabThatEnds,
        Self::Bound,
        Self::NextNode,
        Self::Pruned,
        Self::NextPlane,
        Self::Mailbox,
        Self::FinalHit,
        Self::Blocked,
        Self::ZeroTerms,
        Self::TotalReflection,
    ];

    /// Its word in the questions of lessons.
    pub const fn word(self) -> &'static str {
        match self {
            Self::RootCount => "root-count",
            Self::RootThatCounts => "root-that-counts",
            Self::PlaneT => "plane-t",
            Self::DroppedAxis => "dropped-axis",
            Self::Inside => "inside",
            Self::SlabThatEnds => "slab-that-ends",
            Self::Bound => "bound",
            Self::NextNode => "next-node",
            Self::Pruned => "pruned",
            Self::NextPlane => "next-plane",
            Self::Mailbox => "mailbox",
            Self::FinalHit => "final-hit",
            Self::Blocked => "blocked",
            Self::ZeroTerms => "zero-terms",
            Self::TotalReflection => "total-reflection",
        }
    }
}

/// A choice of a question.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// What is chosen.
    pub text: String,
    /// Why it is right or wrong.
    pub reason: String,
    /// The name of the mistake that leads to it, if one is known.
    pub mistake: Option<&'static str>,
}

impl Choice {
    pub(super) fn new(text: impl Into<String>, reason: impl Into<String>) -> Self {
        Self {
            text: text.into(),
            reason: reason.into(),
            mistake: None,
        }
    }

    /// The choice to which a mistake leads.
    pub(super) fn by(mut self, mistake: &'static Mistake) -> Self {
        if self.mistake.is_none() {
            self.mistake = Some(mistake.name);
            self.reason = format!(
                "{} Mistake \"{}\": {}",
                self.reason, mistake.name, mistake.sentence
            );
        }
        self
    }
}

/// A question with its choices, of which one is right.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// What it is about.
    pub asks: Asks,
    /// The question, with the numbers that decide it.
    pub text: String,
    /// The choices: at least two, and no two alike.
    pub choices: Vec<Choice>,
    /// The place of the right choice among them.
    pub right: usize,
}

/// The most choices of a question.
const MOST_CHOICES: usize = 4;

/// The letters of the choices, by their places.
pub const LETTERS: [char; MOST_CHOICES] = ['a', 'b', 'c', 'd'];

impl Question {
    /// What is said to an answer first: `right: a`, `wrong: b; a is right`.
    pub fn verdict(&self, choice: usize) -> String {
        let right = LETTERS[self.right];
        if choice == self.right {
            format!("right: {right}")
        } else {
            format!("wrong: {}; {right} is right", LETTERS[choice])
        }
    }

    /// Why each choice is right or wrong: `a is right: The discriminant is 4.`
    pub fn reasons(&self) -> impl Iterator<Item = String> {
        self.choices.iter().enumerate().map(|(place, choice)| {
            let word = if place == self.right {
                "right"
            } else {
                "wrong"
            };
            format!("{} is {word}: {}", LETTERS[place], choice.reason)
        })
    }

    /// A question with its right choice and the wrong ones, the likelier ones first. A wrong one that is like another is left
    /// out; without any there is no question.
    ///
    /// The right choice stands at a place that follows from the step's number in the log.
    pub(super) fn new(
        asks: Asks,
        text: String,
        step: u32,
        right: Choice,
        wrong: impl IntoIterator<Item = Choice>,
    ) -> Option<Self> {
        let mut choices: Vec<Choice> = Vec::new();
        for choice in wrong {
            let is_new =
                choice.text != right.text && choices.iter().all(|known| known.text != choice.text);
            if is_new && choices.len() + 1 < MOST_CHOICES {
                choices.push(choice);
            }
        }
        if choices.is_empty() {
            return None;
        }
        let place = spread(step ^ ((asks as u32) << 24)) as usize % (choices.len() + 1);
        choices.insert(place, right);
        Some(Self {
            asks,
            text,
            choices,
            right: place,
        })
    }
}

/// A number whose bits all depend on those of another one (the finaliser of MurmurHash3, A. Appleby 2011).
fn spread(mut bits: u32) -> u32 {
    bits ^= bits >> 16;
    bits = bits.wrapping_mul(0x85eb_ca6b);
    bits ^= bits >> 13;
    bits = bits.wrapping_mul(0xc2b2_ae35);
    bits ^ (bits >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asked(step: u32, wrong: &[&str]) -> Option<Question> {
        let choice = |text: &str| Choice::new(text, "Because.");
        let wrong = wrong.iter().map(|text| choice(text));
        Question::new(Asks::Bound, "Which?".into(), step, choice("right"), wrong)
    }

    #[test]
    fn a_choice_that_is_like_another_is_left_out_and_so_are_more_than_four() {
        let question = asked(7, &["one", "right", "one", "two", "three", "four"]).unwrap();
        let mut texts: Vec<&str> = question.choices.iter().map(|of| of.text.as_str()).collect();
        assert_eq!(texts.remove(question.right), "right");
        assert_eq!(texts, ["one", "two", "three"]);
        assert_eq!(asked(7, &["right"]), None);
        assert_eq!(asked(7, &[]), None);
    }

    #[test]
    fn the_right_choice_stands_at_each_place_about_as_often() {
        let mut places = [0; 4];
        for step in 0..4000 {
            let question = asked(step, &["one", "two", "three"]).unwrap();
            assert_eq!(
                asked(step, &["one", "two", "three"]).as_ref(),
                Some(&question)
            );
            places[question.right] += 1;
        }
        // a thousand each, and some four times √750 beside it
        assert!(
            places.iter().all(|of| (890..1110).contains(of)),
            "{places:?}"
        );
    }
}
