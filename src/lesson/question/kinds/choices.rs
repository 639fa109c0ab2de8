//! One choice of several, all that are right, or a place of a figure.

use crate::lesson::question::asked::{AskedChoice, Form};
use crate::lesson::question::facts::Facts;
use crate::lesson::question::fault::Fault;
use crate::lesson::question::kinds::wrong;
use crate::lesson::question::situation::Situation;
use crate::lesson::question::spec::{Choices, Each};
use crate::lesson::question::traced::{chosen, facts_of};

/// The most places of a figure, or steps, of which each is a choice: letters end at z.
const MOST: usize = 26;

pub(in crate::lesson::question) fn choice(
    situation: &Situation<'_>,
    of: &Choices,
) -> Result<Form, Fault> {
    one_right("ask.choice", situation, of).map(Form::Choice)
}

pub(in crate::lesson::question) fn place(
    situation: &Situation<'_>,
    of: &Choices,
) -> Result<Form, Fault> {
    one_right("ask.place", situation, of).map(Form::Place)
}

pub(in crate::lesson::question) fn several(
    situation: &Situation<'_>,
    of: &Choices,
) -> Result<Form, Fault> {
    all("ask.several", situation, of).map(Form::Several)
}

fn one_right(
    key: &str,
    situation: &Situation<'_>,
    of: &Choices,
) -> Result<Vec<AskedChoice>, Fault> {
    let choices = all(key, situation, of)?;
    let right: Vec<&str> = choices
        .iter()
        .filter(|choice| choice.right)
        .map(|choice| choice.text.as_str())
        .collect();
    if right.len() != 1 {
        let what = match right.len() {
            0 => "no choice is right".into(),
            many => format!("{many} choices are right: {}", right.join("; ")),
        };
        let fix = "change \"when\" so that one choice is right";
        return Err(Fault::new(key, what, fix));
    }
    Ok(choices)
}

fn all(key: &str, situation: &Situation<'_>, of: &Choices) -> Result<Vec<AskedChoice>, Fault> {
    let mut choices = Vec::new();
    for (place, spec) in of.choices.iter().enumerate() {
        let key = format!("{key}.choices[{place}]");
        let when = situation
            .facts
            .value(&spec.when)
            .and_then(|value| value.flag());
        let right = when.map_err(|what| Fault::text(format!("{key}.when"), what))?;
        let texts = [spec.text.as_str(), spec.reason.as_str()];
        choices.push(wrong::choice(
            situation,
            &key,
            texts,
            right,
            spec.mistake.as_deref(),
        )?);
    }
    wrong::unlike(&format!("{key}.choices"), &choices)?;
    if let Some(each) = &of.each {
        of_each(&format!("{key}.each"), situation, each, &mut choices)?;
    }
    if !(2..=MOST).contains(&choices.len()) {
        let what = format!("there are {} choices", choices.len());
        return Err(Fault::new(key, what, format!("give 2 to {MOST}")));
    }
    // steps stay in the order of the log: which one is right does not follow from their places
    Ok(match of.each {
        Some(_) => choices,
        None => situation.shuffle.of(choices),
    })
}

fn of_each(
    key: &str,
    situation: &Situation<'_>,
    each: &Each,
    choices: &mut Vec<AskedChoice>,
) -> Result<(), Fault> {
    let records = &situation.traced.records;
    let found = chosen(records, &situation.names, &each.of, &situation.facts)
        .map_err(|what| Fault::text(format!("{key}.of"), what))?;
    for place in found {
        let mut facts: Facts<'_> = situation.facts.clone();
        let it = facts_of(&records[place], &situation.names);
        facts.events.insert("it".into(), it);
        let with_it =
            |key: &str, text: &str| facts.filled(text).map_err(|what| Fault::text(key, what));
        let text = with_it(&format!("{key}.text"), &each.text)?;
        if choices.iter().any(|choice| choice.text == text) {
            continue;
        }
        let when = facts.value(&each.when).and_then(|value| value.flag());
        let right = when.map_err(|what| Fault::text(format!("{key}.when"), what))?;
        let (part, reason) = if right {
            ("reason", &each.reason)
        } else {
            ("otherwise", &each.otherwise)
        };
        let key = format!("{key}.{part}");
        let reason = with_it(&key, reason)?;
        if reason.trim().is_empty() {
            return Err(Fault::new(
                key,
                "the choice has no reason",
                "say why it is right or wrong",
            ));
        }
        choices.push(AskedChoice {
            text,
            right,
            reason,
            mistake: None,
        });
    }
    Ok(())
}
