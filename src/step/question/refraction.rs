//! Snell's law: does the ray pass, or is all light reflected?

use crate::geometry::Refraction;
use crate::mistake::mistake;
use crate::step::question::at::{At, number};
use crate::step::question::choice::{Asks, Choice, Question};

/// cos²θ₂ decides as printed if it is further from 0 than this.
const DECIDES: f64 = 1e-4;

/// Is all light reflected?
pub(super) fn total(at: &At, of: &Refraction) -> Option<Question> {
    let Refraction {
        index_from,
        index_to,
        cos_incident,
        cos_refracted_squared,
        ..
    } = *of;
    if cos_refracted_squared.abs() <= DECIDES {
        return None;
    }
    let sine_squared = 1.0 - cos_incident * cos_incident;
    let text_of = |squared: f64| {
        if squared < 0.0 {
            format!("all light is reflected: cos²θ₂ = {}", number(squared))
        } else {
            format!("the ray passes: cos²θ₂ = {}", number(squared))
        }
    };
    let [from, to] = [index_from, index_to].map(number);
    let right = Choice::new(
        text_of(cos_refracted_squared),
        format!(
            "cos²θ₂ = 1 − ({from}/{to})²·(1 − {}²) = {}, and it is {}.",
            number(cos_incident),
            number(cos_refracted_squared),
            if cos_refracted_squared < 0.0 {
                "below 0"
            } else {
                "not below 0"
            }
        ),
    );
    let turned = index_to / index_from;
    let turned = 1.0 - turned * turned * sine_squared;
    let ratio = Choice::new(
        text_of(turned),
        format!("This is with n₂/n₁ = {to}/{from}; Snell's law has n₁/n₂."),
    );
    let ratio = match mistake("ratio never inverted").filter(|_| index_to < index_from) {
        Some(mistake) => ratio.by(mistake),
        None => ratio,
    };
    let plain = index_from / index_to;
    let plain = 1.0 - plain * sine_squared;
    let not_squared = Choice::new(
        text_of(plain),
        "Here n₁/n₂ is not squared: cos²θ₂ = 1 − (n₁/n₂)²·sin²θ₁.",
    );
    let as_it_was = Choice::new(
        text_of(cos_incident * cos_incident),
        "This is cos²θ₁: the ray would not be bent at all.",
    );
    let text = format!(
        "n₁ = {from}, n₂ = {to}, cos θ₁ = {}. Does the ray pass, or is all light reflected?",
        number(cos_incident)
    );
    Question::new(
        Asks::TotalReflection,
        text,
        at.step(),
        right,
        [ratio, not_squared, as_it_was],
    )
}
