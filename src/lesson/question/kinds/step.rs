//! The question that the step asks before it shows its verdict.

use crate::lesson::question::asked::{AskedChoice, Form};
use crate::lesson::question::asking::Situation;
use crate::lesson::question::fault::Fault;
use crate::step::StepLog;

/// Its text and its choices.
pub(in crate::lesson::question) fn step(
    situation: &Situation<'_>,
) -> Result<(String, Form), Fault> {
    let traced = situation.traced;
    let log = StepLog::new(&traced.scene, &traced.settings, &traced.records);
    let landing = log.landing(situation.event);
    let mut steps = [log.leaf(situation.event), landing]
        .into_iter()
        .chain(log.above(landing));
    let leads = |step: &usize| log.step(*step).lead == situation.event;
    let is_about = |step: &usize| {
        *step == landing || leads(step) || log.step(*step).events.start == situation.event
    };
    let question = steps
        .by_ref()
        .filter(is_about)
        .find_map(|step| log.question(step));
    let question = question.ok_or_else(|| {
        Fault::new(
            "at",
            "this step asks no question",
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
