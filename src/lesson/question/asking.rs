//! Asks a question: traces what it is about, finds its step, and hands its facts to the kind of answer.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::explain::{Line, Tone};
use crate::lesson::question::asked::{Asked, StepPlace};
use crate::lesson::question::facts::Facts;
use crate::lesson::question::fault::Fault;
use crate::lesson::question::kinds::{blank, choices, counterexample, number, order, reason, step};
use crate::lesson::question::shuffled::Shuffle;
use crate::lesson::question::situation::Situation;
use crate::lesson::question::spec::{Ask, QuestionSpec, Selector};
use crate::lesson::question::traced::{TracedPixel, chosen_one, edited, facts_of};
use crate::scene::Loaded;
use crate::step::{Address, StepLog};

/// Asks a question of a lesson.
pub(in crate::lesson) fn ask(
    loaded: Loaded,
    spec: &QuestionSpec,
    values: &BTreeMap<String, Value>,
    lesson: &str,
) -> Result<Asked, Fault> {
    let name = spec.name.as_str();
    let changed = |loaded: &Loaded, values: &BTreeMap<String, Value>| {
        edited(loaded, values).map_err(|(pointer, what)| {
            let fix = "name a value of the scene, as in /objects/0/shape/sphere/radius";
            Fault::new(format!("change.{pointer}"), what, fix)
        })
    };
    let loaded = if values.is_empty() {
        loaded
    } else {
        changed(&loaded, values)?
    };
    if spec.text.trim().is_empty() {
        return Err(Fault::new(
            "text",
            "the question has no text",
            "write what is asked",
        ));
    }
    let after = match (spec.change.is_empty(), spec.other_strategy) {
        (true, None) => None,
        (_, other) => {
            let other = QuestionSpec {
                strategy: other.unwrap_or(spec.strategy),
                ..spec.clone()
            };
            Some(TracedPixel::new(changed(&loaded, &spec.change)?, &other)?)
        }
    };
    let traced = TracedPixel::new(loaded, spec)?;
    let (event, mut facts) = facts(&traced, spec, "")?;
    if let Some(after) = &after {
        facts.after = Some(Box::new(
            self::facts(after, spec, " in the second trace")?.1,
        ));
    }
    let situation = Situation {
        spec,
        traced: &traced,
        names: traced.names(),
        event,
        facts,
        shuffle: Shuffle::new(lesson, name),
    };
    let text = situation.filled("text", &spec.text)?;
    let (more, form) = match &spec.ask {
        Ask::Number(of) => (None, number::number(&situation, of)?),
        Ask::Value(of) => (None, number::value(&situation, of)?),
        Ask::Choice(of) => (None, choices::choice(&situation, of)?),
        Ask::Several(of) => (None, choices::several(&situation, of)?),
        Ask::Place(of) => (None, choices::place(&situation, of)?),
        Ask::Order(of) => (None, order::events(&situation, of)?),
        Ask::Program(of) => (None, order::program(&situation, of)?),
        Ask::Blank(of) => (None, blank::blank(&situation, of)?),
        Ask::Reason(_) => (None, reason::reason(&situation)?),
        Ask::Step(of) => {
            let (text, form) = step::step(&situation, of)?;
            (Some(text), form)
        }
        Ask::Counterexample(of) => (None, counterexample::counterexample(&situation, of)?),
    };
    let mut working = Vec::new();
    for line in &spec.working {
        working.push(plain(situation.filled("working", line)?));
    }
    working.extend(situation.step_lines());
    let log = StepLog::new(&traced.scene, &traced.settings, &traced.records);
    let step = Address::of(&log, event);
    let place = StepPlace {
        lesson: spec.lesson.clone().unwrap_or_else(|| lesson.into()),
        scene: spec.scene.clone(),
        pixel: spec.pixel,
        step,
        event,
    };
    let text = match more {
        Some(more) => format!("{text} {more}"),
        None => text,
    };
    Ok(Asked {
        lesson: lesson.into(),
        name: name.into(),
        text,
        form,
        working,
        place,
        figure: spec.figure.clone(),
        confusions: spec.confusions.clone(),
        traced,
    })
}

fn plain(text: String) -> Line {
    Line {
        gap: false,
        indent: 0,
        tone: Tone::Plain,
        ray: None,
        steps: None,
        part: None,
        text,
    }
}

/// The place of the event that the question is about, and the facts of a trace. `place` says which trace it is.
fn facts<'a>(
    traced: &'a TracedPixel,
    spec: &'a QuestionSpec,
    place: &str,
) -> Result<(usize, Facts<'a>), Fault> {
    let names = traced.names();
    let mut facts = Facts {
        scene: Some(&traced.file),
        names: Some(&spec.names),
        ..Facts::default()
    };
    let one = |selector: &Selector, facts: &Facts<'_>, key: &str| {
        chosen_one(&traced.records, &names, selector, facts).map_err(|what| {
            let fix = "change the selector so that it chooses one step: its kind, object, ray, where or nth";
            Fault::new(key, format!("{what}{place}"), fix)
        })
    };
    let event = one(&spec.at, &facts, "at")?;
    facts.own = Some(facts_of(&traced.records[event], &names));
    let mut events = BTreeMap::new();
    for (name, selector) in &spec.others {
        let found = one(selector, &facts, &format!("with.{name}"))?;
        events.insert(name.clone(), facts_of(&traced.records[found], &names));
    }
    facts.events = events;
    for record in traced.records.iter() {
        *facts
            .counts
            .entry(record.event.kind().name())
            .or_insert(0.0) += 1.0;
    }
    Ok((event, facts))
}
