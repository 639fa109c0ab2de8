//! The slabs of a bound that is missed: which one ends the test?

use crate::geometry::SlabInterval;
use crate::mistake::mistake;
use crate::step::question::at::{At, listed, number};
use crate::step::question::choice::{Asks, Choice, Question};
use crate::structure::{SlabStep, SlabVerdict};
use crate::trace::{BoundTest, BoundVerdict, Event};

/// Which slab leaves no t.
pub(super) fn that_ends(at: &At, test: &BoundTest) -> Option<Question> {
    if test.verdict != BoundVerdict::Missed {
        return None;
    }
    let bare = bare_slabs(at)?;
    let (last, before) = bare.split_last()?;
    let interval = |slab: &SlabStep| match slab.interval {
        SlabInterval::Between { near, far } => {
            format!("slab {}: {} to {}", slab.slab, number(near), number(far))
        }
        SlabInterval::ParallelInside => format!("slab {}: parallel, inside", slab.slab),
        SlabInterval::ParallelOutside => format!("slab {}: parallel, outside", slab.slab),
    };
    let none = "none: each slab has an interval of its own";
    let (right, without) = match (last.verdict, last.interval, before.last()) {
        (SlabVerdict::ParallelOutside, ..) => (
            Choice::new(
                format!("slab {}: the ray is parallel to it and outside", last.slab),
                "No t brings a parallel ray into a slab, so nothing is left.",
            ),
            Choice::new(
                "none: a slab that the ray is parallel to changes nothing",
                "That is so for a ray inside the slab; this one is outside.",
            ),
        ),
        (SlabVerdict::Null, SlabInterval::Between { near, far }, Some(so_far)) => {
            // near and far of the last slab cannot both cross
            let (text, reason) = if so_far.min_far < near {
                let own = number(near);
                let of = slab_with(before, so_far.min_far, false)?;
                let limit = number(so_far.min_far);
                if own == limit {
                    return None;
                }
                (
                    format!("slab {}: its near is above far of slab {of}", last.slab),
                    format!("max near is now {own}, and min far {limit} comes before it."),
                )
            } else {
                let own = number(far);
                let of = slab_with(before, so_far.max_near, true)?;
                let limit = number(so_far.max_near);
                if own == limit {
                    return None;
                }
                (
                    format!("slab {}: its far is below near of slab {of}", last.slab),
                    format!("min far is now {own}, and max near {limit} comes after it."),
                )
            };
            let mut without = Choice::new(
                none,
                format!(
                    "The ray must be inside all slabs at once: max near {} and min far {} have crossed.",
                    number(last.max_near),
                    number(last.min_far)
                ),
            );
            if let Some(mistake) = mistake("running interval thrown away") {
                without = without.by(mistake);
            }
            (Choice::new(text, reason), without)
        }
        _ => return None,
    };
    let mut wrong = vec![without];
    wrong.extend(before.iter().rev().map(|slab| {
        Choice::new(
            format!("slab {}: nothing is left after it", slab.slab),
            format!(
                "After slab {} max near is {} and min far {}: t in between is left.",
                slab.slab,
                number(slab.max_near),
                number(slab.min_far)
            ),
        )
    }));
    wrong.push(Choice::new(
        format!("slab {}: its own far is below its near", last.slab),
        "Near is the smaller t of a slab by definition, so its own two cannot cross.",
    ));
    let intervals: Vec<String> = bare.iter().map(interval).collect();
    let text = format!(
        "The bound of {} is missed. Near and far, slab by slab: {}. Which slab ends the test, and why?",
        at.bound_name(test.of),
        listed(&intervals)
    );
    Question::new(Asks::SlabThatEnds, text, at.step(), right, wrong)
}

/// The slab that has this near or far.
fn slab_with(slabs: &[SlabStep], t: f64, is_near: bool) -> Option<u32> {
    let has = |slab: &&SlabStep| match slab.interval {
        SlabInterval::Between { near, far } => t == if is_near { near } else { far },
        _ => false,
    };
    slabs.iter().find(has).map(|slab| slab.slab)
}

/// The slabs of the step without their padding; `None` if that alone decides, or the log has not all of them.
pub(super) fn bare_slabs(at: &At) -> Option<Vec<SlabStep>> {
    let mut bare: Vec<SlabStep> = Vec::new();
    for record in at.events() {
        let Event::SlabTest(test) = record.event else {
            continue;
        };
        if test.step.slab as usize != bare.len() {
            return None;
        }
        let line = at.ray()?.slab_line(test.step.slab)?;
        let step = test.step.without_room(&line, bare.last());
        if step.verdict != test.step.verdict {
            return None;
        }
        bare.push(step);
    }
    Some(bare).filter(|bare| !bare.is_empty())
}
