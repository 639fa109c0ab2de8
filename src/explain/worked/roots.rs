//! The roots of a quadratic, or of a box: the discriminant, their numbers, and the verdict on each.

use crate::explain::number::Digits;
use crate::explain::page::Tone;
use crate::explain::part::Part;
use crate::explain::worked::pen::Pen;
use crate::explain::worked::steps::Course;
use crate::geometry::{QuadraticTest, Root, RootVerdict, Roots};
use crate::trace::Purpose;

/// The discriminant and the roots.
pub(super) fn roots(test: &QuadraticTest, page: &mut Pen) {
    let (b2, ac4) = (test.b * test.b, 4.0 * test.a * test.c);
    let size = b2.abs().max(ac4.abs());
    let d = Digits::for_difference(size, test.discriminant);
    let discriminant = format!(
        ": b² − 4ac = {} {} = {}",
        d.number(b2),
        d.term(-ac4),
        d.difference(size, test.discriminant)
    );
    match test.roots {
        Roots::None if test.discriminant < 0.0 => {
            page.headed(
                Part::Discriminant,
                format!("{discriminant} < 0: no real root"),
            );
        }
        Roots::None => page.headed(
            Part::Roots,
            format!(
                ": none, since a = 0 and b = 0, and c = {} is not 0",
                d.number(test.c)
            ),
        ),
        Roots::Graze(root) => {
            page.headed(
                Part::Discriminant,
                format!("{discriminant}: one double root, a graze"),
            );
            let text = format!(
                ": t = −b/2a = {}/{} = {}",
                d.number(-test.b),
                d.factor(2.0 * test.a),
                d.number(root.t)
            );
            page.headed(Part::Roots, text);
        }
        Roots::Two { near, far } => {
            page.headed(
                Part::Discriminant,
                format!("{discriminant} > 0: two real roots"),
            );
            let text = format!(
                ": t = (−b ± √{})/2a = ({} ± {})/{} = {} and {}",
                d.number(test.discriminant),
                d.number(-test.b),
                d.number(test.discriminant.sqrt()),
                d.factor(2.0 * test.a),
                d.number(near.t),
                d.number(far.t)
            );
            page.headed(Part::Roots, text);
        }
        Roots::Linear(root) => {
            let text = format!(
                ": a = 0 leaves b·t + c = 0, one root t = −c/b = {}/{} = {}",
                d.number(-test.c),
                d.factor(test.b),
                d.number(root.t)
            );
            page.headed(Part::Roots, text);
        }
    }
}

/// The verdict on each root.
pub(super) fn choice(roots: &Roots, course: &Course, page: &mut Pen) {
    let sentences = sentences(roots, course);
    let (tone, text) = match roots {
        Roots::None => (Tone::Refused, ": none, missed".into()),
        _ if roots.chosen().is_some() => (Tone::Found, format!(": {sentences}")),
        _ => (Tone::Refused, format!(": none, {sentences}: missed")),
    };
    page.headed_line(tone, Part::Choice, text);
}

/// The verdict on each root, in one sentence.
fn sentences(roots: &Roots, course: &Course) -> String {
    let chosen = roots.chosen();
    let sentences: Vec<String> = roots
        .iter()
        .map(|root| sentence(root, chosen, course))
        .collect();
    sentences.join("; ")
}

/// The verdict on one root.
pub(super) fn sentence(root: Root, chosen: Option<f64>, course: &Course) -> String {
    let d = Digits::USUAL;
    let t = format!("t = {}", d.number(root.t));
    match root.verdict {
        RootVerdict::Chosen => format!("{t}, the smallest that counts: a hit"),
        RootVerdict::Behind if root.t == 0.0 => format!("{t} is the origin itself"),
        RootVerdict::Behind => format!("{t} lies behind the origin"),
        RootVerdict::BelowEpsilon => {
            format!("{t} is 0 within ε: the surface that the ray starts on")
        }
        RootVerdict::BeyondNearest if chosen.is_some() => format!("{t} lies beyond it"),
        RootVerdict::BeyondNearest => match (course.nearest, course.start) {
            (Some(nearest), _) => {
                format!(
                    "{t} is farther than the nearest hit so far, t = {}",
                    d.number(nearest)
                )
            }
            (None, Some(start)) if start.purpose == Purpose::Shadow => {
                format!("{t} lies beyond the light")
            }
            (None, Some(start)) if start.purpose == Purpose::Connection => {
                format!("{t} lies beyond x")
            }
            _ => format!("{t} is beyond the last t that counts"),
        },
        RootVerdict::BackFace => format!("{t} is on the back, and only the front is visible"),
        RootVerdict::FrontFace => format!("{t} is on the front, and only the back is visible"),
        RootVerdict::BeyondEnds => format!("{t} lies beyond the ends of the surface"),
    }
}
