//! The terms of a light: which of them are 0?

use glam::DVec3;

use crate::explain::name::light_title;
use crate::mistake::mistake;
use crate::scene::Emission;
use crate::step::question::at::{At, alike, number};
use crate::step::question::choice::{Asks, Choice, Question};
use crate::trace::{LightTerm, Visibility};

/// A specular term below this cannot be told from 0 with six digits.
const FAINT: f64 = 1e-6;

/// Which terms of the light are 0.
pub(super) fn zero_terms(at: &At, of: &LightTerm) -> Option<Question> {
    let term = &of.term;
    let light = at.log.scene.lights.get(of.light as usize)?;
    let shines = matches!(of.visibility, Visibility::Visible | Visibility::NotTested);
    let is_zero = |term: DVec3| !shines || term == DVec3::ZERO;
    let (diffuse, specular) = (is_zero(term.diffuse), is_zero(term.specular));
    if !specular && term.specular.max_element() < FAINT || alike(term.n_dot_l, 0.0) {
        return None;
    }
    let text_of = |zero: (bool, bool)| match zero {
        (false, false) => "neither",
        (true, false) => "the diffuse term alone",
        (false, true) => "the specular term alone",
        (true, true) => "both",
    };
    let n_dot_l = number(term.n_dot_l);
    let why = match of.visibility {
        Visibility::FacesAway => format!(
            "N·L = {n_dot_l} is not above 0: the light stands behind the surface, and both terms are 0."
        ),
        Visibility::Shadowed => "The light is blocked, so neither of its terms counts.".into(),
        Visibility::Visible | Visibility::NotTested => {
            let of_one = |name: &str, is_zero: bool| {
                format!(
                    "The {name} term is {}",
                    if is_zero { "0" } else { "above 0" }
                )
            };
            let highlight = match light.emission {
                Emission::Power(_) => "; a light with a power has no highlight".to_owned(),
                Emission::Colour(_) => format!(", with R·V = {}", number(term.r_dot_v)),
            };
            format!(
                "{}, with N·L = {n_dot_l}. {}{highlight}.",
                of_one("diffuse", diffuse),
                of_one("specular", specular)
            )
        }
    };
    let all = [(false, false), (true, false), (false, true), (true, true)];
    let wrong = all.into_iter().filter(|&zero| zero != (diffuse, specular));
    let wrong = wrong.map(|zero| {
        let choice = Choice::new(text_of(zero), why.clone());
        let faces_away = of.visibility == Visibility::FacesAway;
        let made = match zero {
            // behind the surface a highlight remains
            (_, false) if faces_away && 0.0 < term.r_dot_v => mistake("only the sum clamped"),
            (true, true) if shines => mistake("L from light to point"),
            _ => None,
        };
        match made {
            Some(mistake) => choice.by(mistake),
            None => choice,
        }
    });
    let right = Choice::new(text_of((diffuse, specular)), why.clone());
    let visibility = match of.visibility {
        Visibility::Shadowed => "blocked by an object",
        Visibility::Visible => "not blocked",
        Visibility::FacesAway | Visibility::NotTested => "not tested by a shadow ray",
    };
    let coefficients =
        self::coefficients(at, of.light).map_or(String::new(), |text| format!(" {text}"));
    let power = match light.emission {
        Emission::Power(_) => " It has a power, and so no highlight.",
        Emission::Colour(_) => "",
    };
    let text = format!(
        "The {} is {visibility}; N·L = {n_dot_l}, R·V = {}.{power}{coefficients} Which of its two terms, diffuse and specular, are 0?",
        light_title(at.log.scene, of.light),
        number(term.r_dot_v)
    );
    Question::new(Asks::ZeroTerms, text, at.step(), right, wrong)
}

/// The material's coefficients, of the object that the ray hits.
fn coefficients(at: &At, light: u32) -> Option<String> {
    let light = at.log.scene.lights.get(light as usize)?;
    let (object, _) = at.nearest()?;
    let material = at.log.scene.material_of(object);
    let colour = DVec3::from(material.colour);
    let emitted = match light.emission {
        Emission::Colour(colour) => colour,
        Emission::Power(_) => DVec3::ONE,
    };
    let dark = if colour * emitted == DVec3::ZERO {
        " Light and surface have no colour in common."
    } else {
        ""
    };
    Some(format!(
        "The material has diffuse {}, specular {}, shininess {}.{dark}",
        number(material.diffuse),
        number(material.specular),
        number(material.shininess)
    ))
}
