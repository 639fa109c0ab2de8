//! Other numbers for a question: another pixel, or other numbers of its scene.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use crate::lesson::exercise::Seeded;
use crate::lesson::question::{Ask, QuestionSpec};

/// A question with other numbers.
#[derive(Clone, Debug)]
pub(super) struct Varied {
    /// The question, with another pixel if it has one.
    pub(super) spec: QuestionSpec,
    /// Values of the scene by their JSON pointers.
    pub(super) values: BTreeMap<String, Value>,
}

/// Has the question numbers that could be others? The order of a program's lines has none, and a search through all pixels
/// is about the whole picture. Where light is followed from the lamps, chance leads it elsewhere in another scene.
pub(super) fn can_vary(spec: &QuestionSpec) -> bool {
    let is_of_pixel = !matches!(spec.ask, Ask::Program(_) | Ask::Counterexample(_));
    spec.vary.is_some() || (is_of_pixel && !spec.transport.follows_light())
}

/// Draws other numbers. What the lesson says may vary is taken from there; else the scene changes a little.
pub(super) fn draw(spec: &QuestionSpec, scene: &Value, random: &mut Seeded) -> Varied {
    let mut varied = Varied {
        spec: spec.clone(),
        values: BTreeMap::new(),
    };
    let Some(vary) = &spec.vary else {
        varied.values = moved(scene, random);
        return varied;
    };
    if let Some([first, last]) = vary.pixels {
        varied.spec.pixel = std::array::from_fn(|axis| {
            let count = last[axis].saturating_sub(first[axis]) + 1;
            first[axis] + random.below(count)
        });
    }
    for (pointer, [smallest, largest, step]) in &vary.numbers {
        let count = ((largest - smallest) / step).round().max(0.0) as u32 + 1;
        let value = smallest + f64::from(random.below(count)) * step;
        varied.values.insert(pointer.clone(), rounded(value));
    }
    varied
}

/// How many numbers of a scene change at once.
const MOST_MOVED: u32 = 3;

/// By how many steps.
const MOST_STEPS: u32 = 4;

/// A few numbers of the scene, each a little larger or smaller.
pub(super) fn moved(scene: &Value, random: &mut Seeded) -> BTreeMap<String, Value> {
    let mut numbers = Vec::new();
    numbers_of(scene, String::new(), &mut numbers);
    let mut moved = BTreeMap::new();
    if numbers.is_empty() {
        return moved;
    }
    for _ in 0..=random.below(MOST_MOVED) {
        let (pointer, value) = &numbers[random.below(numbers.len() as u32) as usize];
        let steps = 1 + random.below(MOST_STEPS);
        let sign = if random.below(2) == 0 { 1.0 } else { -1.0 };
        let step = if value.abs() < 1.0 { 0.05 } else { 0.1 };
        moved.insert(
            pointer.clone(),
            rounded(value + sign * f64::from(steps) * step),
        );
    }
    moved
}

/// Numbers that people can copy: sums of twentieths have rounding in them.
fn rounded(value: f64) -> Value {
    json!((1000.0 * value).round() / 1000.0)
}

/// The numbers of a scene that say where something is: the eye, a lamp, a sphere with its radius, a box.
fn numbers_of(value: &Value, pointer: String, found: &mut Vec<(String, f64)>) {
    /// What is moved as a whole, coordinate by coordinate, keeps its shape. A polygon whose vertices were moved one by one would
    /// be bent.
    const KEYS: [&str; 8] = [
        "/cop",
        "/corner",
        "/position",
        "/center",
        "/radius",
        "/radii",
        "/target",
        "/base_radius",
    ];
    match value {
        Value::Number(number) => {
            let names = pointer.trim_end_matches(|c: char| c.is_ascii_digit() || c == '/');
            if KEYS.iter().any(|key| names.ends_with(key))
                && let Some(number) = number.as_f64()
            {
                found.push((pointer, number));
            }
        }
        Value::Array(items) => {
            for (place, item) in items.iter().enumerate() {
                numbers_of(item, format!("{pointer}/{place}"), found);
            }
        }
        Value::Object(fields) => {
            for (key, item) in fields {
                // the names of materials and objects may hold anything
                let key = key.replace('~', "~0").replace('/', "~1");
                numbers_of(item, format!("{pointer}/{key}"), found);
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn where_something_is_may_move_and_nothing_else() {
        let scene = json!({
            "camera": { "look_at": { "cop": [0, 1, 6.5], "fov_degrees": 40 }, "pixels": [4, 3] },
            "ambient": [0.1, 0.1, 0.1],
            "lights": [{ "position": [1, 2, 3], "colour": [1, 1, 1] }],
            "objects": [
                { "shape": { "sphere": { "center": [7, 8, 9], "radius": 2 } } },
                { "shape": { "polygon": { "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]] } } }
            ]
        });
        let mut found = Vec::new();
        numbers_of(&scene, String::new(), &mut found);
        let pointers: Vec<(&str, f64)> = found.iter().map(|(at, of)| (at.as_str(), *of)).collect();
        assert_eq!(
            pointers,
            [
                ("/camera/look_at/cop/0", 0.0),
                ("/camera/look_at/cop/1", 1.0),
                ("/camera/look_at/cop/2", 6.5),
                ("/lights/0/position/0", 1.0),
                ("/lights/0/position/1", 2.0),
                ("/lights/0/position/2", 3.0),
                ("/objects/0/shape/sphere/center/0", 7.0),
                ("/objects/0/shape/sphere/center/1", 8.0),
                ("/objects/0/shape/sphere/center/2", 9.0),
                ("/objects/0/shape/sphere/radius", 2.0),
            ]
        );
        let mut random = Seeded::new(1);
        for _ in 0..100 {
            for (pointer, value) in moved(&scene, &mut random) {
                let (_, old) = found.iter().find(|(at, _)| *at == pointer).unwrap();
                let by = (value.as_f64().unwrap() - old).abs();
                // a step of 0.05 below 1, else 0.1, and up to four of them
                assert!(0.049 < by && by < 0.401, "{pointer}: {by}");
                assert!(value.to_string().len() <= 5, "{value}");
            }
        }
    }
}
