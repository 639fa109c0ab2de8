//! Why was a test rejected? The log says it.

use serde_json::Value;

use crate::explain::shown;
use crate::lesson::question::asked::{AskedChoice, Form};
use crate::lesson::question::facts::Facts;
use crate::lesson::question::fault::Fault;
use crate::lesson::question::situation::Situation;
use crate::trace::{Kind, Why};

/// Digits of a number in a reason.
const DIGITS: u32 = 6;

pub(in crate::lesson::question) fn reason(situation: &Situation<'_>) -> Result<Form, Fault> {
    let own = situation.facts.own.as_ref();
    let kind = own.map(|own| own.kind);
    let word = own
        .and_then(|own| own.fields.get("why"))
        .and_then(Value::as_str);
    let (Some(kind), Some(word)) = (kind, word) else {
        return Err(Fault::new(
            "at",
            "this step has no \"why\": nothing was rejected in it",
            "choose the step of a test that was rejected",
        ));
    };
    let facts = found(kind, &situation.facts);
    let choices = may_be(kind).iter().map(|why| {
        let right = why.word() == word;
        let (text, needs) = words(*why);
        let reason = if right && facts.is_empty() {
            format!("It is so if {needs}.")
        } else if right {
            format!("{facts} So {text}.")
        } else {
            format!("This is the reason if {needs}. {facts}")
        };
        AskedChoice {
            text: text.into(),
            right,
            reason: reason.trim().into(),
            mistake: None,
        }
    });
    let choices: Vec<AskedChoice> = choices.collect();
    if choices.iter().filter(|choice| choice.right).count() != 1 || choices.len() < 2 {
        return Err(Fault::new(
            "at",
            format!("why a {} is rejected has no choices", kind.name()),
            "choose the test of an object, a plane, a polygon or a bound",
        ));
    }
    Ok(Form::Choice(situation.shuffle.of(choices)))
}

/// The reasons for which a test of this kind may be rejected.
fn may_be(kind: Kind) -> &'static [Why] {
    use Why::{
        Behind, BelowEpsilon, BeyondEnds, BeyondNearest, Empty, Missed, NoRoot, Outside, Parallel,
    };
    match kind {
        Kind::SphereTest | Kind::EllipsoidTest => &[NoRoot, Behind, BelowEpsilon, BeyondNearest],
        Kind::ConeTest => &[NoRoot, Behind, BelowEpsilon, BeyondNearest, BeyondEnds],
        Kind::BoxTest => &[Empty, Parallel, Behind, BeyondNearest],
        Kind::PlaneTest => &[Parallel, Behind, BelowEpsilon, BeyondNearest],
        Kind::PolygonTest => &[Outside, Parallel, Behind],
        Kind::SlabTest => &[Empty, Parallel],
        Kind::BoundTest => &[Missed, Behind, BeyondNearest],
        _ => &[],
    }
}

/// A reason in words, and when it applies.
fn words(why: Why) -> (&'static str, &'static str) {
    match why {
        Why::NoRoot => (
            "the equation has no real root",
            "the discriminant is below 0",
        ),
        Why::Empty => (
            "no t is inside all slabs",
            "the largest near is above the smallest far",
        ),
        Why::Parallel => ("the ray is parallel", "the denominator is 0"),
        Why::Missed => ("the ray passes by the volume", "no t is inside the volume"),
        Why::Behind => ("it lies behind the origin of the ray", "its t is at most 0"),
        Why::BelowEpsilon => (
            "it is the surface on which the ray starts",
            "its t is 0 but for rounding, which is below ε",
        ),
        Why::BeyondNearest => (
            "it is further away than the nearest hit so far, or than the light",
            "its t is above the last t that counts",
        ),
        Why::BackFace => (
            "the ray hits the back, and only the front can be seen",
            "only the front of the surface can be seen",
        ),
        Why::FrontFace => (
            "the ray hits the front, and only the back can be seen",
            "only the back of the surface can be seen",
        ),
        Why::BeyondEnds => (
            "the ray hits the endless cone beyond its base and its apex",
            "the point lies beyond the base or the apex",
        ),
        Why::Outside => (
            "the point lies outside of the polygon",
            "an even number of edges counts",
        ),
    }
}

/// The numbers of the test that decide.
fn found(kind: Kind, facts: &Facts<'_>) -> String {
    let number = |name: &str| facts.value(name).and_then(|value| value.number()).ok();
    let listed = |names: &[(&str, &str)]| {
        let known = names.iter().filter_map(|(key, title)| {
            number(key).map(|value| format!("{title} = {}", shown(value, DIGITS)))
        });
        let known: Vec<String> = known.collect();
        if known.is_empty() {
            String::new()
        } else {
            format!("Here {}.", known.join(", "))
        }
    };
    match kind {
        Kind::SphereTest | Kind::EllipsoidTest | Kind::ConeTest => listed(&[
            ("discriminant", "the discriminant"),
            ("near", "the smaller root"),
            ("far", "the larger root"),
        ]),
        Kind::PlaneTest => listed(&[("denominator", "the denominator"), ("root", "t")]),
        Kind::PolygonTest => listed(&[("crossings", "the number of edges that count")]),
        Kind::BoxTest | Kind::SlabTest | Kind::BoundTest => listed(&[
            ("max_near", "the largest near"),
            ("min_far", "the smallest far"),
            ("near", "near"),
            ("far", "far"),
        ]),
        _ => String::new(),
    }
}
