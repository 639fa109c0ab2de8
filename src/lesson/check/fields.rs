//! Which quantity of a line differs from the one that is expected, and which may.

use crate::lesson::check::checked::Quantity;
use crate::lesson::check::value::{Fields, Value, close};
use crate::trace::Kind;

/// Where a line belongs, what counts steps of this program, and what is free: ε, and how deep an eye ray is.
const FREE: [&str; 17] = [
    "kind",
    "step",
    "pixel",
    "ray",
    "parent",
    "purpose",
    "sample",
    "samples",
    "place",
    "t_min",
    "t_max",
    "depth",
    "tests",
    "hits",
    "replaced",
    "decided_by",
    "t_window",
];

/// Keys that an event has or has not: what stands there where nothing is expected is a difference.
const OPTIONAL: [&str; 10] = [
    "near",
    "far",
    "root",
    "t",
    "object",
    "direction",
    "near_verdict",
    "far_verdict",
    "root_verdict",
    "why",
];

/// How a line is compared.
#[derive(Clone, Copy, Debug)]
pub(super) struct How {
    pub(super) kind: Kind,
    pub(super) tolerance: f64,
    /// How far colours may differ.
    pub(super) colour: f64,
    /// The length of the log's direction: its t are the expected ones divided by this.
    pub(super) length: f64,
    /// t of the ray's nearest hit, on the log's scale: whoever tests the objects in another order says "beyond" of another one.
    pub(super) nearest: Option<f64>,
    /// Is it a shadow ray? Then any blocker will do.
    pub(super) is_shadow: bool,
}

/// A field that has another kind of value than it can have.
pub(super) struct WrongType {
    pub(super) key: String,
    pub(super) yours: Value,
    pub(super) expected: Value,
}

/// The quantities that a line and an event both have, in the order in which they are worked out.
pub(super) fn compare(
    yours: &Fields,
    expected: &Fields,
    how: How,
) -> Result<Vec<Quantity>, WrongType> {
    let mut expected = in_their_form(yours, expected, how);
    if how.kind == Kind::LightTerm {
        // L and the cosines come before the question whether the light is hidden
        expected
            .0
            .sort_by_key(|(key, _)| ["visibility", "diffuse", "specular"].contains(&key.as_str()));
    }
    let expected = &expected;
    let mut found = Vec::new();
    for (key, expected_value) in &expected.0 {
        if FREE.contains(&key.as_str()) || is_left_out(key, expected, how) {
            continue;
        }
        let Some(value) = yours.get(key).filter(|of| **of != Value::Nothing) else {
            continue;
        };
        let has_type = std::mem::discriminant(value) == std::mem::discriminant(expected_value);
        if !has_type {
            return Err(WrongType {
                key: key.clone(),
                yours: value.clone(),
                expected: expected_value.clone(),
            });
        }
        found.push(Quantity {
            key: key.clone(),
            yours: value.to_string(),
            expected: expected_value.to_string(),
            is_same: is_same(key, [value, expected_value], [yours, expected], how),
        });
    }
    for key in OPTIONAL {
        let (Some(value), None) = (yours.get(key), expected.get(key)) else {
            continue;
        };
        if *value == Value::Nothing || is_left_out(key, expected, how) || is_beyond(yours, how) {
            continue;
        }
        // words that only say more closely what others say
        if key == "why" || key.ends_with("_verdict") {
            continue;
        }
        found.push(Quantity {
            key: key.into(),
            yours: value.to_string(),
            expected: "nothing".into(),
            is_same: false,
        });
    }
    Ok(found)
}

/// Is what follows from the sign of a discriminant free, since it is 0 within the tolerance?
fn is_graze(expected: &Fields) -> bool {
    /// Of b²: what is left of it where the ray touches.
    const SHARE: f64 = 1e-7;
    match (expected.number("discriminant"), expected.number("b")) {
        (Some(discriminant), Some(b)) => discriminant.abs() <= SHARE * b * b,
        _ => false,
    }
}

fn is_left_out(key: &str, expected: &Fields, how: How) -> bool {
    let of_roots = [
        "roots",
        "near",
        "far",
        "near_verdict",
        "far_verdict",
        "verdict",
        "why",
        "t",
    ];
    if is_graze(expected) && of_roots.contains(&key) {
        return true;
    }
    match how.kind {
        Kind::RayEnd => how.is_shadow && ["object", "t", "colour"].contains(&key),
        // another order of the objects, another last but one
        Kind::Cell => key == "listed",
        _ => false,
    }
}

/// Does the line say "beyond the nearest" of a hit that is?
fn is_beyond(yours: &Fields, how: How) -> bool {
    let t = ["near", "root", "t"]
        .into_iter()
        .find_map(|key| yours.number(key));
    match (t, how.nearest) {
        (Some(t), Some(nearest)) => nearest - how.tolerance * nearest.abs().max(1.0) <= t,
        _ => false,
    }
}

fn is_same(
    key: &str,
    [yours, expected]: [&Value; 2],
    [line, event]: [&Fields; 2],
    how: How,
) -> bool {
    let tolerance = match (how.kind, key) {
        (Kind::PixelColour, _) | (Kind::RayEnd, "colour") => how.colour,
        _ => how.tolerance,
    };
    let scaled = |size: f64| match (yours, expected) {
        (Value::Number(yours), Value::Number(expected)) => {
            (yours - expected).abs() <= tolerance * size.max(1.0).max(expected.abs())
        }
        _ => false,
    };
    let b_squared = event.number("b").map_or(0.0, |b| b * b);
    match (how.kind, key) {
        // differences of larger terms
        (_, "discriminant") => {
            let product = event
                .number("a")
                .zip(event.number("c"))
                .map_or(0.0, |(a, c)| 4.0 * a * c);
            scaled(10.0 * (b_squared + product.abs()))
        }
        (_, "c") => scaled(b_squared),
        (_, "verdict" | "why" | "near_verdict" | "far_verdict" | "root_verdict") => {
            is_same_word(yours, expected) || is_beyond(line, how)
        }
        (Kind::RayEnd, "outcome") => is_same_outcome(yours, expected),
        // the other sign, where the root says that both have it
        (Kind::PlaneTest, "numerator" | "denominator") if has_root(line, event, tolerance) => {
            same_size(yours, expected, tolerance)
        }
        // cut off at 0 as the terms are
        (Kind::LightTerm, "n_dot_l" | "r_dot_v") => {
            let is_cut = matches!((yours, expected), (Value::Number(yours), Value::Number(expected))
                if *yours == 0.0 && *expected < 0.0);
            yours.is(expected, tolerance) || is_cut
        }
        (Kind::LightTerm, "to_light") => {
            let unit = line.vector("to_light").map(glam::DVec3::normalize_or_zero);
            let unit = unit.map(|unit| Value::List(unit.to_array().into()));
            yours.is(expected, tolerance) || unit.is_some_and(|unit| unit.is(expected, tolerance))
        }
        (Kind::PolygonTest, "crossings") => match (yours, expected) {
            // the half-line may go either way
            (Value::Number(yours), Value::Number(expected)) => (yours - expected) % 2.0 == 0.0,
            _ => false,
        },
        (Kind::PolygonTest, "dropped" | "coefficient") => {
            // of two coefficients of one size either may be dropped
            yours.is(expected, tolerance) || has_same_size(line, event, tolerance)
        }
        (Kind::PolygonTest, "projected") => {
            yours.is(expected, tolerance) || line.text("dropped") != event.text("dropped")
        }
        (Kind::LightTerm, "visibility") => {
            // behind the surface nobody needs to ask
            yours == expected || event.number("n_dot_l").is_some_and(|cosine| cosine <= 0.0)
        }
        (Kind::LightTerm, "diffuse" | "specular") => {
            let is_dark = event.text("visibility") != Some("visible");
            let is_0 = matches!(yours, Value::List(list) if list.iter().all(|of| *of == 0.0));
            yours.is(expected, tolerance) || (is_dark && is_0)
        }
        // rounded or cut off
        (Kind::PixelColour, "rgb") => yours.is_within(expected, 1.0),
        _ => yours.is(expected, tolerance),
    }
}

/// Is the root of a plane the expected one?
fn has_root(line: &Fields, event: &Fields, tolerance: f64) -> bool {
    match (line.number("root"), event.number("root")) {
        (Some(yours), Some(expected)) => close(yours, expected, tolerance),
        _ => false,
    }
}

fn same_size(yours: &Value, expected: &Value, tolerance: f64) -> bool {
    match (yours, expected) {
        (Value::Number(yours), Value::Number(expected)) => {
            close(yours.abs(), expected.abs(), tolerance)
        }
        _ => false,
    }
}

/// Behind the origin or below ε: which of the two depends on ε.
fn is_same_word(yours: &Value, expected: &Value) -> bool {
    let before = |value: &Value| matches!(value, Value::Text(word) if word == "behind" || word == "below_epsilon");
    yours == expected || (before(yours) && before(expected))
}

/// A shadow ray that hits nothing reaches its light.
fn is_same_outcome(yours: &Value, expected: &Value) -> bool {
    let plain = |value: &Value| match value {
        Value::Text(word) => match word.as_str() {
            "reaches_light" => "miss".to_owned(),
            "blocked" => "hit".to_owned(),
            other => other.to_owned(),
        },
        _ => String::new(),
    };
    plain(yours) == plain(expected)
}

fn has_same_size(yours: &Fields, expected: &Fields, tolerance: f64) -> bool {
    match (yours.number("coefficient"), expected.number("coefficient")) {
        (Some(yours), Some(expected)) => close(yours.abs(), expected.abs(), tolerance),
        _ => false,
    }
}

/// What is expected in the form that the line has: t on its scale, half b, a plane with another factor.
fn in_their_form(yours: &Fields, expected: &Fields, how: How) -> Fields {
    let mut form = expected.clone();
    match how.kind {
        Kind::Cell | Kind::GridEnter | Kind::HitOutsideCell => {
            let keys = [
                "t", "t_in", "t_out", "next_x", "next_y", "next_z", "near", "far",
            ];
            scale(&mut form, &keys, 1.0 / how.length);
        }
        Kind::PlaneTest | Kind::PolygonTest => {
            // N·p = D has the other D
            let mut other = expected.clone();
            for (key, value) in &mut other.0 {
                if let ("plane", Value::List(list)) = (key.as_str(), value)
                    && let Some(d) = list.get_mut(3)
                {
                    *d = -*d;
                }
            }
            let is_other = plane_factor(yours, expected, how.tolerance).is_none()
                && yours.get("plane").is_some()
                && has_root(yours, expected, how.tolerance)
                && plane_factor(yours, &other, how.tolerance).is_some();
            let source = if is_other { &other } else { expected };
            if is_other {
                form = other.clone();
            }
            if let Some(factor) = plane_factor(yours, source, how.tolerance) {
                scale(
                    &mut form,
                    &["plane", "numerator", "denominator", "coefficient"],
                    factor,
                );
            }
        }
        Kind::SphereTest | Kind::EllipsoidTest | Kind::ConeTest => {
            if let Some(of) = quadratic_form(yours, expected, how.tolerance) {
                scale(&mut form, &["a", "c"], of.a);
                scale(&mut form, &["b"], of.b);
                scale(&mut form, &["discriminant"], of.discriminant);
            }
        }
        _ => {}
    }
    form
}

fn scale(form: &mut Fields, keys: &[&str], factor: f64) {
    for (key, value) in &mut form.0 {
        if keys.contains(&key.as_str()) {
            match value {
                Value::Number(number) => *number *= factor,
                Value::List(list) => list.iter_mut().for_each(|of| *of *= factor),
                _ => {}
            }
        }
    }
}

/// A, B, C and D mean the same plane with any factor: the one that the line has. `None` if it is not the same plane.
fn plane_factor(yours: &Fields, expected: &Fields, tolerance: f64) -> Option<f64> {
    let pairs = |key: &str| Some((yours.list(key)?.to_vec(), expected.list(key)?.to_vec()));
    if let Some((yours, expected)) = pairs("plane") {
        let [largest] = expected
            .iter()
            .take(3)
            .enumerate()
            .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))
            .map(|(place, _)| [place])?;
        let factor = yours.get(largest)? / expected[largest];
        let fits = yours.len() == expected.len()
            && yours
                .iter()
                .zip(&expected)
                .all(|(yours, expected)| close(*yours, factor * expected, tolerance));
        return (fits && factor != 0.0).then_some(factor);
    }
    let ratio = |key: &str| Some(yours.number(key)? / expected.number(key)?);
    let factors: Vec<f64> = ["denominator", "numerator", "coefficient"]
        .into_iter()
        .filter_map(ratio)
        .filter(|factor| factor.is_finite() && *factor != 0.0)
        .collect();
    let first = *factors.first()?;
    // a single number of another size may be a mistake; two that agree are another factor
    let agrees = factors
        .iter()
        .all(|factor| close(factor / first, 1.0, 10.0 * tolerance));
    (agrees && (1 < factors.len() || close(first, -1.0, tolerance))).then_some(first)
}

/// The form of the quadratic that the line has.
struct Form {
    a: f64,
    b: f64,
    discriminant: f64,
}

/// The form of the quadratic that the line has: half b with b′² − ac, b with the other sign, which the formula of the roots
/// then has too, and any of these divided by a number such as a. `None`: the usual one, or none that fits.
///
/// Of the equation k·a·t² + k·b·t + k·c = 0 the roots are the same, and b² − 4ac is k² times as large.
fn quadratic_form(yours: &Fields, expected: &Fields, tolerance: f64) -> Option<Form> {
    /// Factors of b, and of the discriminant.
    const SHAPES: [[f64; 2]; 4] = [[1.0, 1.0], [0.5, 0.25], [-1.0, 1.0], [-0.5, 0.25]];
    let loose = 10.0 * tolerance;
    let fits = |key: &str, factor: f64| {
        let (yours, expected) = (yours.number(key), expected.number(key)?);
        yours.map(|yours| close(yours, factor * expected, loose))
    };
    let forms = |k: f64| {
        SHAPES.map(|[b, discriminant]| Form {
            a: k,
            b: k * b,
            discriminant: k * k * discriminant,
        })
    };
    // how many of its numbers the line has; none if one of them does not fit
    let count = |form: &Form| {
        let keys = [
            ("a", form.a),
            ("b", form.b),
            ("c", form.a),
            ("discriminant", form.discriminant),
        ];
        let given: Vec<bool> = keys.iter().filter_map(|(key, of)| fits(key, *of)).collect();
        given.iter().all(|fits| *fits).then_some(given.len())
    };
    let [usual, others @ ..] = forms(1.0);
    if count(&usual).is_some() {
        return None;
    }
    let roots: Vec<bool> = ["near", "far", "t"]
        .into_iter()
        .filter_map(|key| fits(key, 1.0))
        .collect();
    let has_roots = !roots.is_empty() && roots.iter().all(|fits| *fits);
    let may_have_roots = has_roots || expected.number("near").is_none();
    // b alone says nothing of the form; with its sign turned, the roots tell whether that was meant
    let of_sign = others.into_iter().find(|form| {
        let has_evidence = if form.b < 0.0 {
            may_have_roots && fits("b", form.b).is_some()
        } else {
            has_roots || fits("discriminant", form.discriminant).is_some()
        };
        count(form).is_some() && has_evidence
    });
    if of_sign.is_some() {
        return of_sign;
    }
    let ratio = |key: &str| Some(yours.number(key)? / expected.number(key)?);
    let scale = ratio("a").or_else(|| ratio("c")).or_else(|| ratio("b"))?;
    if !scale.is_finite() || scale == 0.0 {
        return None;
    }
    // where there is no root, two numbers that agree are another factor
    let least = if has_roots { 1 } else { 2 };
    forms(scale)
        .into_iter()
        .find(|form| may_have_roots && count(form).is_some_and(|count| least <= count))
}
