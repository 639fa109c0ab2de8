//! A bounding volume: is it hit, missed, behind, or beyond the nearest hit?

use crate::mistake::{Wrong, mistakes};
use crate::step::question::at::{At, alike, number};
use crate::step::question::choice::{Asks, Choice, Question};
use crate::step::question::slab::bare_slabs;
use crate::trace::{BoundTest, BoundVerdict};

/// What becomes of the bound.
pub(super) fn verdict(at: &At, test: &BoundTest) -> Option<Question> {
    let range = at.range()?;
    let [near, far] = match bare_slabs(at) {
        Some(slabs) => {
            let last = slabs.last()?;
            [last.max_near, last.min_far]
        }
        None => test.inside?,
    };
    // without its padding it must be the same, and plain to see
    let inside = (near <= far).then_some([near, far]);
    let ends = [range.min, range.max];
    let is_plain =
        !alike(near, far) && !ends.iter().any(|&end| alike(near, end) || alike(far, end));
    if BoundVerdict::of(inside, range) != test.verdict || !is_plain {
        return None;
    }
    let [near_text, far_text] = [near, far].map(number);
    let choice = |verdict: BoundVerdict| {
        let (text, is, is_not) = match verdict {
            BoundVerdict::Hit => (
                "it is hit, and what is inside is tested",
                "The ray is inside for some t that counts.",
                "The ray is inside for no t that counts.",
            ),
            BoundVerdict::Missed => (
                "the ray misses it",
                "max near is above min far: the ray is never inside all slabs at once.",
                "max near is not above min far, so the ray is inside for a while.",
            ),
            BoundVerdict::Behind => (
                "it lies behind the origin",
                "min far is below the first t that counts.",
                "min far is not below the first t that counts.",
            ),
            BoundVerdict::Beyond => (
                "it begins beyond the last t that counts",
                "max near is above the last t that counts.",
                "max near is not above the last t that counts.",
            ),
        };
        let is_right = verdict == test.verdict;
        let choice = Choice::new(text, if is_right { is } else { is_not });
        let made = mistakes().find(|mistake| {
            matches!(mistake.wrong, Wrong::Bound(wrong) if wrong(inside, range) == verdict)
        });
        match made.filter(|_| !is_right) {
            Some(mistake) => choice.by(mistake),
            None => choice,
        }
    };
    let all = [
        BoundVerdict::Hit,
        BoundVerdict::Missed,
        BoundVerdict::Behind,
        BoundVerdict::Beyond,
    ];
    // a bound that is missed may be said to lie behind, too
    if test.verdict == BoundVerdict::Missed && (far < range.min || range.max < near) {
        return None;
    }
    let wrong = all.into_iter().filter(|&other| other != test.verdict);
    let text = format!(
        "Bound of {}: max near = {near_text}, min far = {far_text}; {}. What becomes of the bound?",
        at.bound_name(test.of),
        at.range_text(range)
    );
    Question::new(
        Asks::Bound,
        text,
        at.step(),
        choice(test.verdict),
        wrong.map(choice),
    )
}
