//! The question that the step asks before it shows its verdict.

use crate::lesson::question::asked::{AskedChoice, Form};
use crate::lesson::question::fault::Fault;
use crate::lesson::question::situation::Situation;
use crate::lesson::question::spec::Step;
use crate::scene::nearest_name;
use crate::step::{Asks, StepLog};

/// Its text and its choices.
pub(in crate::lesson::question) fn step(
    situation: &Situation<'_>,
    of: &Step,
) -> Result<(String, Form), Fault> {
    if let Some(word) = &of.asks
        && Asks::ALL.iter().all(|asks| asks.word() != word)
    {
        let near = nearest_name(word, Asks::ALL.iter().map(|asks| asks.word()));
        let fix = near.map_or("omit it".into(), |near| format!("did you mean {near:?}?"));
        let what = format!("no step asks {word:?}");
        return Err(Fault::new("ask.step.asks", what, fix));
    }
    let traced = situation.traced;
    let log = StepLog::new(&traced.scene, &traced.settings, &traced.records);
    let event = situation.event;
    let leaf = log.leaf(event);
    // the event itself, and the steps that it leads or begins
    let is_about =
        |step: &usize| log.step(*step).lead == event || log.step(*step).events.start == event;
    let above = log.above(leaf).filter(is_about);
    let wanted = |asks: Asks| of.asks.as_ref().is_none_or(|word| asks.word() == word);
    let question = [leaf]
        .into_iter()
        .chain(above)
        .filter_map(|step| log.question(step))
        .find(|question| wanted(question.asks));
    let question = question.ok_or_else(|| {
        Fault::new(
            "at",
            "this step asks no such question",
            "choose another step, or write the choices",
        )
    })?;
    let choices = question.choices.iter().enumerate();
    let choices = choices.map(|(place, choice)| AskedChoice {
        text: choice.text.clone(),
        right: place == question.right,
        reason: choice.reason.clone(),
        mistake: choice.mistake,
    });
    Ok((question.text.clone(), Form::Choice(choices.collect())))
}
