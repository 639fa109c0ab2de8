//! The questions of the lessons: each is asked and answered, and what a lesson gets wrong is refused with its line.

#[path = "lesson_questions/counts.rs"]
mod counts;
#[path = "lesson_questions/refused.rs"]
mod refused;
#[path = "lesson_questions/routes.rs"]
mod routes;
#[path = "lesson_questions/varied.rs"]
mod varied;

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::OnceLock;

use raystep::lesson::question::{Asked, Form, Given};
use raystep::{Library, open_lessons};

/// The lessons of the course, without the gallery of mistakes, which is no lesson and asks nothing.
pub(crate) fn lessons() -> &'static Library {
    static LESSONS: OnceLock<Library> = OnceLock::new();
    LESSONS.get_or_init(|| {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons");
        let mut library = open_lessons(&folder).unwrap();
        library.lessons.retain(|of| of.name != "gallery");
        library
    })
}

/// Every question of the course, asked once for all tests.
pub(crate) fn all() -> &'static [Asked] {
    static ALL: OnceLock<Vec<Asked>> = OnceLock::new();
    ALL.get_or_init(|| {
        let mut asked = Vec::new();
        for lesson in &lessons().lessons {
            for question in &lesson.content.questions {
                let of = lessons().ask(&lesson.name, &question.name);
                asked.push(of.unwrap_or_else(|error| panic!("{error}")));
            }
        }
        asked
    })
}

#[track_caller]
fn is_wrong(asked: &Asked, given: &Given) {
    let judged = asked.answer(given);
    assert!(!judged.right, "{}/{}: {given:?}", asked.lesson, asked.name);
    assert!(
        judged.reason.ends_with('.'),
        "{}/{}: {}",
        asked.lesson,
        asked.name,
        judged.reason
    );
}

#[test]
fn each_question_takes_its_right_answer_and_refuses_each_wrong_one_with_its_reason() {
    for asked in all() {
        let name = format!("{}/{}", asked.lesson, asked.name);
        let right = asked.right();
        assert!(asked.answer(&right).right, "{name}: {right:?}");
        // as it is printed it is read again
        let typed = asked.read(&asked.answer_text()).unwrap();
        assert!(
            asked.answer(&typed).right,
            "{name}: {}",
            asked.answer_text()
        );
        assert!(
            asked
                .read("nonsense!")
                .unwrap_err()
                .contains(&asked.accepts())
        );

        let choices = asked.form.choices();
        let texts: BTreeSet<&str> = choices.iter().map(|of| of.text.as_str()).collect();
        assert_eq!(texts.len(), choices.len(), "{name}");
        for choice in choices {
            assert!(choice.reason.ends_with('.'), "{name}: {}", choice.reason);
        }
        match &asked.form {
            Form::Number(of) => {
                is_wrong(asked, &Given::Number(of.answer + 1.5 * of.tolerance));
                for (value, choice) in &of.wrong {
                    is_wrong(asked, &Given::Number(*value));
                    assert_eq!(asked.answer(&Given::Number(*value)).reason, choice.reason);
                }
            }
            Form::Choice(_) | Form::Place(_) => {
                assert_eq!(choices.iter().filter(|of| of.right).count(), 1, "{name}");
                for (place, choice) in choices.iter().enumerate().filter(|(_, of)| !of.right) {
                    is_wrong(asked, &Given::Choice(place));
                    assert_eq!(asked.answer(&Given::Choice(place)).reason, choice.reason);
                }
            }
            Form::Several(_) => {
                let Given::Several(places) = right else {
                    panic!("{name}");
                };
                for place in 0..choices.len() {
                    // one more, or one less
                    let mut other = places.clone();
                    if !other.remove(&place) {
                        other.insert(place);
                    }
                    is_wrong(asked, &Given::Several(other));
                }
            }
            Form::Order(of) => {
                let mut turned = of.order.clone();
                turned.reverse();
                is_wrong(asked, &Given::Order(turned));
                is_wrong(asked, &Given::Order(of.order[1..].to_vec()));
                for place in (0..choices.len()).filter(|place| !choices[*place].right) {
                    let mut more = of.order.clone();
                    more.push(place);
                    is_wrong(asked, &Given::Order(more));
                }
            }
            Form::Blank(of) => {
                for place in 0..of.answers.len() {
                    let mut numbers: Vec<f64> = of.answers.iter().map(|of| of.0).collect();
                    numbers[place] += 1.5 * of.answers[place].1 + 0.01;
                    is_wrong(asked, &Given::Blanks(numbers));
                    assert!(
                        of.lines
                            .iter()
                            .any(|line| line.contains(&format!("[{}]", place + 1)))
                    );
                }
            }
        }
        assert!(!asked.working.is_empty(), "{name} has no working");
        assert!(!asked.text.contains(['{', '}']), "{name}: {}", asked.text);
    }
}

#[test]
fn the_working_of_a_bound_begins_with_its_first_slab() {
    // S and T of all slabs come before the bound in the log, so the lines of the first slab were left out
    for name in ["near-of-a-slab", "slab-that-ends"] {
        let asked = all().iter().find(|of| of.name == name).unwrap();
        let lines: Vec<&str> = asked.working.iter().map(|of| of.text.as_str()).collect();
        assert!(
            lines[0].starts_with("Bounding volume of shape"),
            "{lines:?}"
        );
        assert!(lines[1].starts_with("S, T of slab 0, "), "{lines:?}");
    }
}
