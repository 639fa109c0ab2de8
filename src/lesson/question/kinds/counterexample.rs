//! A pixel that shows that something may happen, found in the log of every pixel.

use crate::lesson::question::asked::{AskedChoice, Form};
use crate::lesson::question::facts::{EventFacts, Facts};
use crate::lesson::question::fault::Fault;
use crate::lesson::question::situation::Situation;
use crate::lesson::question::spec::Counterexample;
use crate::lesson::question::traced::{chosen, facts_of};
use crate::trace::Record;

/// So many pixels are choices.
const PIXELS: usize = 3;

/// No picture has more pixels of which all are searched.
const MOST_PIXELS: u64 = 128 * 128;

pub(in crate::lesson::question) fn counterexample(
    situation: &Situation<'_>,
    of: &Counterexample,
) -> Result<Form, Fault> {
    let key = "ask.counterexample";
    let [width, height] = situation.traced.scene.camera.pixels;
    if MOST_PIXELS < u64::from(width) * u64::from(height) {
        return Err(Fault::new(
            "scene",
            format!("{width} × {height} pixels are too many to search"),
            "choose a scene with at most 128 × 128 pixels",
        ));
    }
    let (mut shows, mut does_not) = (Vec::new(), Vec::new());
    situation
        .traced
        .each_pixel(situation.spec, |pixel, records| {
            let found = witness(situation, of, &records);
            match found.map_err(|what| Fault::text(key, what))? {
                Some(facts) => shows.push((pixel, facts)),
                None => does_not.push(pixel),
            }
            Ok(())
        })?;
    // pixels that stand far apart, the same ones everywhere
    let spread = |count: usize, wanted: usize| {
        (1..=wanted.min(count)).map(move |place| place * count / (wanted + 1))
    };
    let name = |[x, y]: [u32; 2]| format!("pixel {x}, {y}");
    let mut choices = Vec::new();
    for place in spread(shows.len(), 1) {
        let (pixel, facts) = &shows[place];
        let reason = facts.filled(&of.reason);
        choices.push(AskedChoice {
            text: name(*pixel),
            right: true,
            reason: reason.map_err(|what| Fault::text(format!("{key}.reason"), what))?,
            mistake: None,
        });
    }
    let wanted = PIXELS - choices.len();
    for place in spread(does_not.len(), wanted) {
        choices.push(AskedChoice {
            text: name(does_not[place]),
            right: false,
            reason: situation.filled(&format!("{key}.otherwise"), &of.otherwise)?,
            mistake: None,
        });
    }
    let count = shows.len();
    let none = situation.filled(&format!("{key}.none"), &of.none)?;
    choices.push(AskedChoice {
        text: "no pixel of this picture".into(),
        right: count == 0,
        reason: match count {
            0 => none,
            1 => format!("1 pixel shows it. {none}"),
            many => format!("{many} pixels show it. {none}"),
        },
        mistake: None,
    });
    if choices.len() < 2 || choices.iter().any(|choice| choice.reason.trim().is_empty()) {
        return Err(Fault::new(
            key,
            "a choice has no reason, or there is one choice alone",
            "say why, or choose a picture with more pixels",
        ));
    }
    Ok(Form::Choice(situation.shuffle.of(choices)))
}

/// The facts of the first choice of events for which the expression holds.
fn witness<'a>(
    situation: &Situation<'a>,
    of: &Counterexample,
    records: &[Record],
) -> Result<Option<Facts<'a>>, String> {
    let mut found: Vec<(&String, Vec<EventFacts>)> = Vec::new();
    for (name, selector) in &of.of {
        let places = chosen(records, &situation.names, selector, &situation.facts)?;
        let places = match selector.nth {
            Some(nth) => places.into_iter().skip(nth).take(1).collect(),
            None => places,
        };
        let facts = places
            .into_iter()
            .map(|place| facts_of(&records[place], &situation.names));
        found.push((name, facts.collect()));
    }
    let mut facts = situation.facts.clone();
    Ok(holds(&found, &of.when, &mut facts)?.then_some(facts))
}

/// Is there a choice, one of each name, for which the expression holds? If so, the facts have it.
fn holds(
    found: &[(&String, Vec<EventFacts>)],
    when: &str,
    facts: &mut Facts<'_>,
) -> Result<bool, String> {
    let Some(((name, events), rest)) = found.split_first() else {
        return facts.value(when)?.flag();
    };
    for event in events {
        facts.events.insert((*name).clone(), event.clone());
        if holds(rest, when, facts)? {
            return Ok(true);
        }
    }
    Ok(false)
}
