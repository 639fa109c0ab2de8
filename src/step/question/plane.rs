//! The plane of a polygon: where does the line of the ray hit it, or is it parallel?

use crate::geometry::{PlaneTest, PlaneVerdict, RootVerdict};
use crate::mistake::mistake;
use crate::scene::PrimitiveId;
use crate::step::question::at::{At, number};
use crate::step::question::choice::{Asks, Choice, Question};

/// Where the line of the ray hits the plane.
pub(super) fn t(at: &At, object: PrimitiveId, test: &PlaneTest) -> Option<Question> {
    let PlaneTest {
        plane,
        numerator,
        denominator,
        verdict,
    } = *test;
    let [top, bottom] = [number(numerator), number(denominator)];
    let beside = "nowhere: the ray is parallel to the plane and beside it";
    let within = "nowhere: the ray is parallel to the plane and runs in it";
    let at_t = |t: f64| format!("at t = {}", number(t));
    let not_parallel = format!("The denominator is {bottom} and not 0, so there is one t.");
    let (right, wrong) = match verdict {
        PlaneVerdict::Meets(root) => {
            // beside an edge-on plane t was moved into the outline; the plane that the ray starts on has a t of rounding
            let is_moved = number(root.t) != number(-numerator / denominator);
            if is_moved || root.verdict == RootVerdict::BelowEpsilon {
                return None;
            }
            let right = format!("t = −({top}) / ({bottom}) = {}.", number(root.t));
            let mut wrong = vec![
                Choice::new(
                    at_t(-root.t),
                    "(v) has a minus sign before the numerator, and here it is missing.",
                ),
                Choice::new(beside, not_parallel.clone()),
            ];
            if let Some(mistake) = mistake("sign of D") {
                let t = -(numerator - 2.0 * plane.d) / denominator;
                wrong.insert(
                    0,
                    Choice::new(at_t(t), "This is the t of another plane.").by(mistake),
                );
            }
            wrong.push(Choice::new(within, not_parallel));
            (Choice::new(at_t(root.t), right), wrong)
        }
        PlaneVerdict::ParallelBeside | PlaneVerdict::ParallelWithin => {
            let is_within = verdict == PlaneVerdict::ParallelWithin;
            let (text, other) = if is_within {
                (within, beside)
            } else {
                (beside, within)
            };
            let is = if is_within { "0" } else { "not 0" };
            let reason = format!("The denominator is 0, and the numerator {top} is {is}.");
            let other_reason = format!("The numerator is {top}, which is {is}.");
            let mut endless = Choice::new(
                "at t = ∞",
                "No t brings a parallel ray to the plane, so the test has no t at all.",
            );
            if let Some(mistake) = mistake("no parallel case") {
                endless = endless.by(mistake);
            }
            let zero = Choice::new(
                "at t = 0",
                "A quotient whose denominator is 0 has no value; it is not 0.",
            );
            (
                Choice::new(text, reason),
                vec![endless, Choice::new(other, other_reason), zero],
            )
        }
    };
    let is_parallel = !matches!(verdict, PlaneVerdict::Meets(_));
    let bottom = if is_parallel {
        "0 but for rounding".into()
    } else {
        bottom
    };
    let text = format!(
        "Plane of {}: D = {}, the numerator A·x₀ + B·y₀ + C·z₀ + D is {top}, the denominator A·Δx + B·Δy + C·Δz is {bottom}. \
         Where does the line of the ray hit the plane?",
        at.name(object),
        number(plane.d)
    );
    Question::new(Asks::PlaneT, text, at.step(), right, wrong)
}
