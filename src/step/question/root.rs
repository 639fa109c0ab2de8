//! The roots of a sphere, an ellipsoid, a cone or a box: how many, and which one counts.

use crate::geometry::{
    BoxTest, QuadraticTest, Root, RootVerdict, Roots, Sides, TRange, verdict_of,
};
use crate::mistake::{Wrong, mistakes};
use crate::scene::{PrimitiveId, Shape};
use crate::step::question::at::{At, alike, number};
use crate::step::question::choice::{Asks, Choice, Question};

/// b² − 4ac decides as printed if it is no smaller than this share of its larger term.
const DECIDES: f64 = 1e-4;

/// Of every so many steps with two roots one asks for their number.
const COUNTED: u32 = 3;

/// How many roots, or which one counts.
pub(super) fn of_quadratic(at: &At, object: PrimitiveId, test: &QuadraticTest) -> Option<Question> {
    match test.roots {
        Roots::None | Roots::Graze(_) => how_many(at, object, test),
        Roots::Two { .. } if at.step().is_multiple_of(COUNTED) => how_many(at, object, test),
        Roots::Two { .. } | Roots::Linear(_) => which(at, object, &test.roots),
    }
}

/// Which of a box's two t counts.
pub(super) fn of_box(at: &At, object: PrimitiveId, test: &BoxTest) -> Option<Question> {
    which(at, object, &test.roots)
}

fn how_many(at: &At, object: PrimitiveId, test: &QuadraticTest) -> Option<Question> {
    let QuadraticTest {
        a,
        b,
        c,
        discriminant,
        roots,
    } = *test;
    let (square, product) = (b * b, 4.0 * a * c);
    let is_graze = matches!(roots, Roots::Graze(_));
    if !is_graze && discriminant.abs() <= DECIDES * square.max(product.abs()) {
        return None;
    }
    let texts = [
        "none: the ray misses",
        "one: the ray touches the surface",
        "two",
    ];
    let count = roots.iter().count();
    let needed = ["below 0", "equal to 0", "above 0"];
    let found = format!(
        "b² − 4ac = {} − {} = {}",
        number(square),
        bracketed(product),
        if is_graze {
            "0".into()
        } else {
            number(discriminant)
        }
    );
    let choice = |roots: usize| {
        let reason = if roots == count {
            format!("{found}, which is {}.", needed[roots])
        } else {
            format!("That needs b² − 4ac {}, but {found}.", needed[roots])
        };
        Choice::new(texts[roots], reason)
    };
    let primitive = at.log.scene.primitive(object);
    let ray = at.ray()?.start?.ray;
    let wrong = (0..3).filter(|&roots| roots != count).map(|roots| {
        let made = mistakes().find(|mistake| match (&mistake.wrong, &primitive.shape) {
            (Wrong::SphereTest(wrong), Shape::Sphere(sphere)) => {
                let test = wrong(sphere, &ray, TRange::FORWARD, Sides::Both);
                test.roots.iter().count() == roots
            }
            _ => false,
        });
        match made {
            Some(mistake) => choice(roots).by(mistake),
            None => choice(roots),
        }
    });
    let graze = if is_graze {
        " Without rounding b² is 4ac."
    } else {
        ""
    };
    let text = format!(
        "For {}, a·t² + b·t + c = 0 has a = {}, b = {}, c = {}.{graze} How many real roots are there?",
        at.name(object),
        number(a),
        number(b),
        number(c)
    );
    Question::new(Asks::RootCount, text, at.step(), choice(count), wrong)
}

fn bracketed(x: f64) -> String {
    if x < 0.0 {
        format!("({})", number(x))
    } else {
        number(x)
    }
}

fn which(at: &At, object: PrimitiveId, roots: &Roots) -> Option<Question> {
    let range = at.range()?;
    let start = at.ray()?.start?;
    let primitive = at.log.scene.primitive(object);
    let all: Vec<_> = roots.iter().collect();
    let chosen = roots.chosen();
    let mut seen: Vec<String> = Vec::new();
    for root in &all {
        // the numbers that are shown must decide
        let by_range = verdict_of(root.t, range);
        let decides = match root.verdict {
            RootVerdict::BeyondEnds => false,
            RootVerdict::BackFace | RootVerdict::FrontFace => true,
            RootVerdict::BeyondNearest => by_range == root.verdict || chosen.is_some(),
            verdict => by_range == verdict,
        };
        let text = number(root.t);
        if !decides || alike(root.t, range.max) || seen.contains(&text) {
            return None;
        }
        seen.push(text);
    }
    let text_of = |t: Option<f64>| match t {
        Some(t) => format!("t = {}", number(t)),
        None if all.len() == 1 => "it does not count: the ray misses".into(),
        None => "neither: the ray misses".into(),
    };
    let reason_of = |root: &Root| reason(*root, chosen.is_some());
    let by_mistake = |t: Option<f64>, choice: Choice| {
        let made = mistakes().find(|mistake| match (&mistake.wrong, &primitive.shape) {
            (Wrong::Root(wrong), Shape::Sphere(sphere)) => {
                wrong(sphere, &start.ray, range, primitive.sides).map(number) == t.map(number)
            }
            (Wrong::Hit(wrong), Shape::Sphere(_)) => {
                t.is_some() && wrong(primitive, &start.ray, range).map(number) == t.map(number)
            }
            _ => false,
        });
        match made {
            Some(mistake) => choice.by(mistake),
            None => choice,
        }
    };
    let mut choices: Vec<Choice> = Vec::new();
    let mut right = None;
    for root in &all {
        let choice = Choice::new(text_of(Some(root.t)), reason_of(root));
        if root.verdict == RootVerdict::Chosen {
            right = Some(choice);
        } else {
            choices.push(by_mistake(Some(root.t), choice));
        }
    }
    let reasons: Vec<String> = all.iter().map(reason_of).collect();
    let right = match chosen {
        None => Choice::new(text_of(None), reasons.join(" ")),
        Some(t) => {
            let none = Choice::new(
                text_of(None),
                format!("The root t = {} counts, so the ray hits.", number(t)),
            );
            choices.push(by_mistake(None, none));
            right?
        }
    };
    let name = at.name(object);
    let roots = match all.as_slice() {
        [one] => format!("The only root of {name} is t = {}", number(one.t)),
        _ => format!("The roots of {name} are t = {}", seen.join(" and t = ")),
    };
    let sides = match primitive.sides {
        Sides::Both => "",
        Sides::Front => " Only the front of the surface can be seen.",
        Sides::Back => " Only the back of the surface can be seen.",
    };
    let text = format!(
        "{roots}; {}.{sides} Which root is the hit?",
        at.range_text(range)
    );
    Question::new(Asks::RootThatCounts, text, at.step(), right, choices)
}

/// Why a root is the hit or not.
fn reason(Root { t, verdict }: Root, other_counts: bool) -> String {
    let t = number(t);
    match verdict {
        RootVerdict::Chosen => format!("t = {t} is the smallest root that counts."),
        RootVerdict::Behind => format!("t = {t} lies behind the origin of the ray."),
        RootVerdict::BelowEpsilon => {
            format!("t = {t} is the surface that the ray starts on: it is below ε.")
        }
        RootVerdict::BeyondNearest if other_counts => {
            format!("At t = {t} the ray leaves the surface; the other root counts and comes first.")
        }
        RootVerdict::BeyondNearest => format!("t = {t} lies beyond the end of the t that count."),
        RootVerdict::BackFace => {
            format!("At t = {t} the ray hits the back, and only the front can be seen.")
        }
        RootVerdict::FrontFace => {
            format!("At t = {t} the ray hits the front, and only the back can be seen.")
        }
        RootVerdict::BeyondEnds => format!("t = {t} lies beyond base and apex."),
    }
}
