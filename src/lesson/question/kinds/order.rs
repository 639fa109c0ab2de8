//! An order: of events as they happen, or of the lines of a program.

use crate::lesson::question::asked::{AskedChoice, Form, OrderForm};
use crate::lesson::question::facts::Facts;
use crate::lesson::question::fault::Fault;
use crate::lesson::question::kinds::wrong;
use crate::lesson::question::situation::Situation;
use crate::lesson::question::spec::{Order, Program, Selector};
use crate::lesson::question::traced::{chosen, facts_of};

/// The most events that are put in order.
const MOST: usize = 12;

pub(in crate::lesson::question) fn events(
    situation: &Situation<'_>,
    of: &Order,
) -> Result<Form, Fault> {
    let mut items = labelled(situation, "ask.order", &of.of, &of.text, &of.reason, true)?;
    let count = items.len();
    if !(2..=MOST).contains(&count) {
        return Err(Fault::new(
            "ask.order.of",
            format!("{count} steps are to be put in order"),
            format!("choose 2 to {MOST}"),
        ));
    }
    if let Some(among) = &of.among {
        let key = "ask.order.among";
        let others = labelled(situation, key, &among.of, &of.text, &among.reason, false)?;
        let is_new = |item: &AskedChoice| items.iter().all(|known| known.text != item.text);
        let others: Vec<AskedChoice> = others.into_iter().filter(is_new).collect();
        items.extend(others);
    }
    let before = (1..count).map(|place| (place - 1, place)).collect();
    Ok(shuffled(situation, items, count, before))
}

/// The events of a selector with their words, each only once.
fn labelled(
    situation: &Situation<'_>,
    key: &str,
    selector: &Selector,
    text: &str,
    reason: &str,
    right: bool,
) -> Result<Vec<AskedChoice>, Fault> {
    let records = &situation.traced.records;
    let found = chosen(records, &situation.names, selector, &situation.facts)
        .map_err(|what| Fault::text(format!("{key}.of"), what))?;
    let mut items: Vec<AskedChoice> = Vec::new();
    for place in found {
        let mut facts: Facts<'_> = situation.facts.clone();
        let it = facts_of(&records[place], &situation.names);
        facts.events.insert("it".into(), it);
        let filled = |part: &str, text: &str| {
            facts
                .filled(text)
                .map_err(|what| Fault::text(format!("{key}.{part}"), what))
        };
        let item = AskedChoice {
            text: filled("text", text)?,
            right,
            reason: filled("reason", reason)?,
            mistake: None,
        };
        if item.reason.trim().is_empty() {
            let key = format!("{key}.reason");
            return Err(Fault::new(
                key,
                "there is no reason",
                "say why it comes where it does",
            ));
        }
        if items.iter().all(|known| known.text != item.text) {
            items.push(item);
        }
    }
    Ok(items)
}

pub(in crate::lesson::question) fn program(
    situation: &Situation<'_>,
    of: &Program,
) -> Result<Form, Fault> {
    let lines = of.name.lines();
    let mut items: Vec<AskedChoice> = lines
        .iter()
        .map(|line| AskedChoice {
            text: line.text.into(),
            right: true,
            reason: line.reason.into(),
            mistake: None,
        })
        .collect();
    for line in of.name.wrong() {
        let mistake = wrong::known("ask.program.name", line.mistake)?;
        items.push(AskedChoice {
            text: line.text.into(),
            right: false,
            reason: wrong::with_mistake(line.reason, Some(mistake)),
            mistake: Some(mistake.name),
        });
    }
    let before = lines.iter().enumerate();
    let before = before.flat_map(|(place, line)| line.after.iter().map(move |of| (*of, place)));
    let before = before.collect();
    Ok(shuffled(situation, items, lines.len(), before))
}

/// The items in another order; the first `count` of them are the right order.
fn shuffled(
    situation: &Situation<'_>,
    items: Vec<AskedChoice>,
    count: usize,
    before: Vec<(usize, usize)>,
) -> Form {
    let shown = situation.shuffle.order(items.len());
    let place_of = |item: usize| {
        let place = shown.iter().position(|of| *of == item);
        place.unwrap_or_default()
    };
    let order: Vec<usize> = (0..count).map(place_of).collect();
    let before = before
        .into_iter()
        .map(|(first, later)| (place_of(first), place_of(later)))
        .collect();
    Form::Order(OrderForm {
        items: situation.shuffle.of(items),
        order,
        before,
    })
}
