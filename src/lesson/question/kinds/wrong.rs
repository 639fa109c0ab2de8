//! What a choice must have: a reason, words unlike those of others, a mistake that is known.

use crate::lesson::question::asked::AskedChoice;
use crate::lesson::question::fault::Fault;
use crate::lesson::question::situation::Situation;
use crate::mistake::{Mistake, mistake};
use crate::scene::nearest_name;

/// The mistake of a name.
pub(super) fn known(key: &str, name: &str) -> Result<&'static Mistake, Fault> {
    mistake(name).ok_or_else(|| {
        let names = crate::mistake::mistakes().map(|of| of.name);
        let fix = match nearest_name(name, names) {
            Some(near) => format!("did you mean {near:?}?"),
            None => "name a mistake of the registry".into(),
        };
        Fault::new(key, format!("there is no mistake {name:?}"), fix)
    })
}

/// A reason with the sentence of a mistake after it.
pub(super) fn with_mistake(reason: &str, mistake: Option<&'static Mistake>) -> String {
    match mistake {
        None => reason.into(),
        Some(of) => {
            let text = format!("{reason} Mistake \"{}\": {}", of.name, of.sentence);
            text.trim_start().into()
        }
    }
}

/// A choice with its texts filled in.
pub(super) fn choice(
    situation: &Situation<'_>,
    key: &str,
    [text, reason]: [&str; 2],
    right: bool,
    mistake: Option<&str>,
) -> Result<AskedChoice, Fault> {
    let of_mistake = match mistake {
        Some(name) => Some(known(&format!("{key}.mistake"), name)?),
        None => None,
    };
    let reason = situation.filled(&format!("{key}.reason"), reason)?;
    if reason.trim().is_empty() {
        return Err(Fault::new(
            format!("{key}.reason"),
            "the choice has no reason",
            "say why it is right or wrong",
        ));
    }
    Ok(AskedChoice {
        text: situation.filled(&format!("{key}.text"), text)?,
        right,
        reason: with_mistake(&reason, of_mistake.filter(|_| !right)),
        mistake: of_mistake.filter(|_| !right).map(|of| of.name),
    })
}

/// No two choices may say the same.
pub(super) fn unlike(key: &str, choices: &[AskedChoice]) -> Result<(), Fault> {
    for (place, choice) in choices.iter().enumerate() {
        if let Some(first) = choices[..place]
            .iter()
            .position(|of| of.text == choice.text)
        {
            return Err(Fault::new(
                format!("{key}[{place}]"),
                format!("choice {place} is like choice {first}: {:?}", choice.text),
                "change one of them",
            ));
        }
    }
    Ok(())
}
