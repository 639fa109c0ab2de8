//! A number, or one of several numbers.

use crate::explain::shown;
use crate::lesson::question::asked::{AskedChoice, Form, NumberForm};
use crate::lesson::question::facts::Facts;
use crate::lesson::question::fault::Fault;
use crate::lesson::question::kinds::wrong;
use crate::lesson::question::situation::Situation;
use crate::lesson::question::spec::{Number, WrongNumber};
use crate::lesson::question::spoiled::spoiled;

/// Digits of a number that is a choice.
const DIGITS: u32 = 6;

/// An answer with three right digits is right.
const USUAL_TOLERANCE: f64 = 5e-3;

/// Numbers of the course are of the size of 1, and f64 has 16 digits.
const ROUNDING: f64 = 1e-14;

/// Two routes to the same number differ by rounding alone.
const SAME: f64 = 1e-9;

pub(in crate::lesson::question) fn number(
    situation: &Situation<'_>,
    of: &Number,
) -> Result<Form, Fault> {
    computed("ask.number", situation, of).map(Form::Number)
}

/// The number among wrong ones, as choices.
pub(in crate::lesson::question) fn value(
    situation: &Situation<'_>,
    of: &Number,
) -> Result<Form, Fault> {
    let computed = computed("ask.value", situation, of)?;
    let with_unit = |value: f64| {
        let text = format!("{} {}", shown(value, DIGITS), of.unit);
        text.trim_end().to_owned()
    };
    let mut choices = vec![AskedChoice {
        text: with_unit(computed.answer),
        right: true,
        reason: computed.reason,
        mistake: None,
    }];
    choices.extend(
        computed
            .wrong
            .into_iter()
            .map(|(value, choice)| AskedChoice {
                text: with_unit(value),
                ..choice
            }),
    );
    if choices.len() < 2 {
        return Err(Fault::new(
            "ask.value",
            "there is no wrong number",
            "give some, or ask for a \"number\"",
        ));
    }
    Ok(Form::Choice(situation.shuffle.of(choices)))
}

fn computed(key: &str, situation: &Situation<'_>, of: &Number) -> Result<NumberForm, Fault> {
    let number_of = |facts: &Facts<'_>, key: &str, text: &str| {
        let value = facts.value(text).and_then(|value| value.number());
        let value = value.map_err(|what| Fault::text(key, what))?;
        if value.is_finite() {
            // what is left of a 0 by rounding
            return Ok(if value.abs() < ROUNDING { 0.0 } else { value });
        }
        Err(Fault::text(key, format!("{text:?} is no finite number")))
    };
    let answer = number_of(&situation.facts, &format!("{key}.answer"), &of.answer)?;
    if let Some(confirm) = &of.confirm {
        let key = format!("{key}.confirm");
        let other = number_of(&situation.facts, &key, confirm)?;
        if SAME * answer.abs().max(1.0) < (answer - other).abs() {
            let what = format!("{confirm:?} is {other}, and the answer is {answer}");
            return Err(Fault::new(key, what, "correct one of the two"));
        }
    }
    let reason = situation.filled(&format!("{key}.reason"), &of.reason)?;
    if reason.trim().is_empty() {
        let key = format!("{key}.reason");
        return Err(Fault::new(
            key,
            "the answer has no reason",
            "say why it is right",
        ));
    }
    let tolerance = of.tolerance.unwrap_or(USUAL_TOLERANCE * answer.abs());
    let mut known: Vec<(f64, AskedChoice)> = Vec::new();
    for (place, spec) in of.wrong.iter().enumerate() {
        let key = format!("{key}.wrong[{place}]");
        let (value, choice) = wrong_number(situation, &key, of, spec, number_of)?;
        let like = match known
            .iter()
            .position(|(of, _)| (of - value).abs() <= tolerance)
        {
            _ if (value - answer).abs() <= tolerance => Some("the answer".to_owned()),
            Some(other) => Some(format!("wrong number {other}")),
            None => None,
        };
        if let Some(like) = like {
            return Err(Fault::new(
                key,
                format!("the wrong number {} is {like}", shown(value, DIGITS)),
                "choose another one, or another pixel",
            ));
        }
        known.push((value, choice));
    }
    Ok(NumberForm {
        answer,
        unit: of.unit.clone(),
        tolerance,
        reason,
        wrong: known,
    })
}

fn wrong_number(
    situation: &Situation<'_>,
    key: &str,
    of: &Number,
    spec: &WrongNumber,
    number_of: impl Fn(&Facts<'_>, &str, &str) -> Result<f64, Fault>,
) -> Result<(f64, AskedChoice), Fault> {
    let mistake = match &spec.mistake {
        Some(name) => Some(wrong::known(&format!("{key}.mistake"), name)?),
        None => None,
    };
    let value = match (&spec.value, mistake) {
        (Some(value), _) => number_of(&situation.facts, &format!("{key}.value"), value)?,
        (None, Some(mistake)) => {
            let own = spoiled(mistake, situation.traced, situation.event);
            let own = own.ok_or_else(|| {
                Fault::new(
                    format!("{key}.mistake"),
                    format!("the mistake {:?} has no part in this step", mistake.name),
                    "choose another mistake or another step, or give its \"value\"",
                )
            })?;
            let facts = Facts {
                own: Some(own),
                ..situation.facts.clone()
            };
            number_of(&facts, &format!("{key}.mistake"), &of.answer)?
        }
        (None, None) => {
            let what = "the wrong number has neither a value nor a mistake";
            return Err(Fault::new(key, what, "give one of them"));
        }
    };
    let reason = situation.filled(&format!("{key}.reason"), &spec.reason)?;
    if reason.trim().is_empty() && mistake.is_none() {
        let key = format!("{key}.reason");
        return Err(Fault::new(
            key,
            "the choice has no reason",
            "say why it is wrong",
        ));
    }
    let choice = AskedChoice {
        text: shown(value, DIGITS),
        right: false,
        reason: wrong::with_mistake(&reason, mistake),
        mistake: mistake.map(|of| of.name),
    };
    Ok((value, choice))
}
