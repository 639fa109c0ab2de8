//! Questions that may vary: with another pixel, or other numbers in the scene.

use std::collections::{BTreeMap, BTreeSet};

use raystep::lesson::LessonError;
use raystep::lesson::question::{QuestionSpec, Vary};
use serde_json::Value;

use super::lessons;

/// So many variants of each question are asked.
const VARIANTS: u32 = 8;

/// A number of a range by its smallest value, its largest and its step.
fn stepped([least, most, step]: [f64; 3], variant: u32) -> f64 {
    let count = ((most - least) / step).round() as u32 + 1;
    least + step * f64::from(variant * 3 % count)
}

fn variant(
    spec: &QuestionSpec,
    vary: &Vary,
    variant: u32,
) -> (QuestionSpec, BTreeMap<String, Value>) {
    let mut spec = spec.clone();
    if let Some([from, to]) = vary.pixels {
        let last = VARIANTS - 1;
        spec.pixel = [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * variant / last);
    }
    let numbers = vary.numbers.iter();
    let values = numbers.map(|(pointer, range)| (pointer.clone(), stepped(*range, variant).into()));
    (spec, values.collect())
}

#[test]
fn what_may_vary_gives_other_questions_with_right_answers() {
    let mut varied = 0;
    for lesson in &lessons().lessons {
        for spec in &lesson.content.questions {
            let Some(vary) = &spec.vary else {
                continue;
            };
            let mut texts = BTreeSet::new();
            for number in 0..VARIANTS {
                let (spec, values) = variant(spec, vary, number);
                match lessons().ask_varied(lesson, &spec, &values) {
                    Ok(asked) => {
                        assert!(asked.answer(&asked.right()).right, "{}", asked.name);
                        let lines: Vec<&str> = asked
                            .form
                            .choices()
                            .iter()
                            .map(|of| of.text.as_str())
                            .collect();
                        texts.insert(format!("{} {lines:?} {:?}", asked.text, asked.right()));
                    }
                    // not every pixel has such a step
                    Err(LessonError::Question { .. }) => {}
                    Err(error) => panic!("{}/{}: {error}", lesson.name, spec.name),
                }
            }
            assert!(3 <= texts.len(), "{}/{}: {texts:?}", lesson.name, spec.name);
            varied += 1;
        }
    }
    assert!(12 <= varied, "{varied}");
}
