//! Two forms of one quadratic equation beside each other: with b and b² − 4ac, and with b′ = b/2 and b′² − ac. Both give the
//! same roots; a third column mixes them, which does not.

use glam::DVec2;

use crate::explain::Part;
use crate::figure::error::FigureError;
use crate::figure::kind::Kind;
use crate::figure::parts::{parabola, scenery};
use crate::figure::sheet::canvas::quantity;
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::look::Look;
use crate::figure::sheet::stage::StageId;
use crate::figure::sheet::text::{Text, formula};
use crate::figure::sheet::{Anchor, Sheet};
use crate::figure::subject::Figure;
use crate::geometry::QuadraticTest;
use crate::trace::Event;

pub(super) const KIND: Kind = Kind {
    draw,
    height: 330.0,
    usual: &[],
    more: &[],
};

/// A way to compute the roots.
struct Form {
    name: &'static str,
    /// b or b′, the discriminant, how the roots follow from it.
    lines: [Text; 3],
    /// The roots, which are two or none.
    roots: Option<[f64; 2]>,
    sentence: String,
    is_right: bool,
}

fn draw(figure: &Figure, sheet: &mut Sheet, body: Frame) -> Result<String, FigureError> {
    let drawn = figure.ray()?;
    let asked = figure.object()?;
    let found = drawn.events.iter().find_map(|record| match record.event {
        Event::SphereTest { object, test }
            if 0.0 < test.a
                && 0.0 < test.discriminant
                && asked.is_none_or(|asked| asked == object) =>
        {
            Some((object, test, record.step))
        }
        _ => None,
    });
    let Some((object, test, step)) = found else {
        return Err(FigureError::new(
            "pixel",
            "the ray of this pixel has no two roots with a sphere",
            "name a pixel in which it passes through a sphere",
        ));
    };
    let name = scenery::name_of(figure.scene, object);
    let QuadraticTest { a, b, c, .. } = test;
    let given = format!(
        "The ray and the sphere {name} have a = {}, b = {} and c = {}.",
        quantity(a),
        quantity(b),
        quantity(c)
    );
    let first = sheet.stage(Part::Coefficients, step, given.clone());
    let forms = forms(&test);
    let stages: Vec<StageId> = forms
        .iter()
        .map(|form| sheet.stage(form.name, step, form.sentence.clone()))
        .collect();
    let letters = ["a", "b", "c"].into_iter().zip([a, b, c]);
    let letters: Vec<Text> = letters
        .map(|(letter, value)| formula(letter) + " = " + quantity(value))
        .collect();
    let mut header = formula("f(t) = a·t² + b·t + c:  ");
    for (place, text) in letters.into_iter().enumerate() {
        header = header + if place == 0 { "" } else { ", " } + text;
    }
    let rest = sheet.at(first, |sheet| sheet.lines(body, &[header]));
    let below = columns(sheet, rest, &forms, &stages);
    axis(sheet, below, &forms, first, &stages);
    let mut sentences = vec![given];
    sentences.extend(forms.into_iter().map(|form| form.sentence));
    Ok(sentences.join(" "))
}

/// The full form, the one with half of b, and half of b in the full form.
fn forms(test: &QuadraticTest) -> [Form; 3] {
    let QuadraticTest { a, b, c, .. } = *test;
    let half = 0.5 * b;
    let quarter = half * half - a * c;
    let mixed = half * half - 4.0 * a * c;
    let of = |b: f64, discriminant: f64, divisor: f64| {
        let root = (0.0 <= discriminant).then(|| discriminant.sqrt())?;
        Some([-b - root, -b + root].map(|of| of / divisor))
    };
    let found = parabola::roots(test);
    let full: Vec<f64> = found.iter().map(|(_, root)| root.t).collect();
    let full = <[f64; 2]>::try_from(full).ok();
    let mixed_roots = of(half, mixed, 2.0 * a);
    [
        Form {
            name: "full",
            lines: [
                formula("b = ") + quantity(b),
                formula("D = b² - 4ac = ") + quantity(test.discriminant),
                formula("t = (-b ± √D)/2a"),
            ],
            roots: full,
            sentence: format!(
                "The full form has b and 4ac, and divides by 2a: the discriminant is {}.",
                quantity(test.discriminant)
            ),
            is_right: true,
        },
        Form {
            name: "half",
            lines: [
                formula("b′ = b/2 = ") + quantity(half),
                formula("D′ = b′² - ac = ") + quantity(quarter),
                formula("t = (-b′ ± √D′)/a"),
            ],
            roots: of(half, quarter, a),
            sentence: format!(
                "The half form has b′ = b/2 and ac, and divides by a: {} is a quarter of the discriminant, and the roots are the same.",
                quantity(quarter)
            ),
            is_right: true,
        },
        Form {
            name: "mixed",
            lines: [
                formula("b′ = b/2 = ") + quantity(half),
                formula("D = b′² - 4ac = ") + quantity(mixed),
                formula("t = (-b′ ± √D)/2a"),
            ],
            roots: mixed_roots,
            sentence: match mixed_roots {
                None => "Half of b in the full form is wrong: here it finds no root, and the sphere is not seen.".into(),
                Some(_) => "Half of b in the full form is wrong: it finds other roots.".into(),
            },
            is_right: false,
        },
    ]
}

fn roots_in_letters(form: &Form) -> Text {
    match form.roots {
        None => "no root".into(),
        Some([near, far]) => {
            formula("t₁ = ") + quantity(near) + ", " + formula("t₂ = ") + quantity(far)
        }
    }
}

/// The three columns; gives back what is left below them.
fn columns(sheet: &mut Sheet, frame: Frame, forms: &[Form; 3], stages: &[StageId]) -> Frame {
    let gap = sheet.letters;
    let width = (frame.size().x - 2.0 * gap) / 3.0;
    let line = sheet.line_height();
    let rows = 5.0;
    for (number, (form, stage)) in (0..3).zip(forms.iter().zip(stages)) {
        let left = frame.min.x + f64::from(number) * (width + gap);
        let [a, b, c] = form.lines.clone();
        let heading: Text = match form.name {
            "mixed" => formula("b′") + " in the full form",
            name => format!("{name} form").into(),
        };
        sheet.at(*stage, |sheet| {
            for (row, text) in [heading, a, b, c, roots_in_letters(form)]
                .into_iter()
                .enumerate()
            {
                let at = DVec2::new(left, frame.min.y + (row as f64 + 0.5) * line);
                sheet.text(Anchor::Start, at, text);
            }
            let under = frame.min.y + line;
            let look = if form.is_right {
                Look::THIN
            } else {
                Look::REJECTED.outline()
            };
            sheet.line(
                look,
                DVec2::new(left, under),
                DVec2::new(left + width, under),
            );
        });
    }
    let [_, below] = frame.split_top((rows + 0.6) * line);
    below
}

/// The roots of all forms, row by row, over one axis of t.
fn axis(sheet: &mut Sheet, frame: Frame, forms: &[Form; 3], first: StageId, stages: &[StageId]) {
    let line = sheet.line_height();
    let names = forms.iter().map(|form| sheet.width_of(form.name));
    let left = frame.min.x + names.fold(0.0, f64::max) + sheet.letters;
    let right = frame.max.x - sheet.letters;
    let all = forms.iter().filter_map(|form| form.roots).flatten();
    let most = all.fold(0.0, f64::max);
    let x = |t: f64| left + (right - left) * t / (1.15 * most);
    let row = |number: usize| frame.min.y + (number as f64 + 0.6) * line;
    let axis = row(forms.len());
    sheet.at(first, |sheet| {
        sheet.arrow(
            Look::THIN,
            DVec2::new(x(0.0), axis),
            DVec2::new(right, axis),
        );
        let end = DVec2::new(right, axis + 0.6 * line);
        sheet.text(Anchor::End, end, formula("t"));
        let zero = DVec2::new(x(0.0), axis + 0.6 * line);
        sheet.text(Anchor::Middle, zero, "0");
    });
    for (number, (form, stage)) in forms.iter().zip(stages).enumerate() {
        let y = row(number);
        sheet.at(*stage, |sheet| {
            sheet.text(Anchor::Start, DVec2::new(frame.min.x, y), form.name);
            let Some(roots) = form.roots else {
                sheet.text(Anchor::Start, DVec2::new(x(0.0), y), "no root");
                return;
            };
            for (place, t) in roots.into_iter().enumerate() {
                let at = DVec2::new(x(t), y);
                if number == 0 {
                    sheet.line(Look::HELP.wide(0.75), at, DVec2::new(x(t), axis));
                    let below = DVec2::new(x(t), axis + 0.6 * line);
                    let name = ["t₁", "t₂"][place];
                    sheet.text(Anchor::Middle, below, formula(name));
                }
                if form.is_right {
                    sheet.dot(Look::ANSWER, at);
                } else {
                    sheet.cross(Look::REJECTED, at);
                }
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::figure::read_back::{DRAWN, ReadBack, ball};

    #[test]
    fn both_forms_have_their_roots_at_the_same_t_and_the_mixed_one_has_none() {
        // a ball of radius 2 around t = 10: a = 1, b = −20, c = 96; 400 − 384 = 16, 100 − 96 = 4, 100 − 384 = −284
        let objects = json!([ball("A", [0.0, 0.0, 0.0], 2.0)]);
        let (drawn, _) = ReadBack::of_ray_along_x(&objects, json!({"kind": "forms"}));
        let texts = drawn.texts().join(" ");
        for part in [
            "b = −20",
            "b2 − 4ac = 16",
            "b′ = b/2 = −10",
            "b′2 − ac = 4",
            "b′2 − 4ac = −284",
            "t1 = 8, t2 = 12",
            "no root",
        ] {
            assert!(texts.contains(part), "{part}: {texts}");
        }
        let mut dots = drawn.dots("answer");
        dots.sort_by(|a, b| a.x.total_cmp(&b.x));
        let [a, b, c, d] = dots[..] else {
            panic!("{dots:?}");
        };
        assert!((a.x - b.x).abs() < DRAWN && (c.x - d.x).abs() < DRAWN && a.x < c.x);
    }

    #[test]
    fn half_of_b_in_the_full_form_finds_other_roots_of_a_ball_that_is_near() {
        // radius 9.75 around t = 10: c = 100 − 95.0625 = 4.9375, 100 − 4·4.9375 = 80.25 and (10 ∓ 8.958)/2
        let objects = json!([ball("A", [0.0, 0.0, 0.0], 9.75)]);
        let (drawn, _) = ReadBack::of_ray_along_x(&objects, json!({"kind": "forms"}));
        assert_eq!(drawn.crosses("rejected").len(), 2);
        let texts = drawn.texts().join(" ");
        assert!(texts.contains("t1 = 0.5209, t2 = 9.479"), "{texts}");
    }
}
