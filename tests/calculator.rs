//! The worked solution can be followed with a calculator: every line of arithmetic that it prints is
//! computed again from the printed numbers alone, and gives the printed result.

mod light;
mod strategies;

use std::path::Path;

use raystep::{
    Chosen, Recording, Scene, Settings, Strategy, StrategyName, Through, Tracer, Transport,
    WorkedOptions, load, load_bytes, trace_pixel, worked_solution,
};

/// Half a unit in the sixth digit, of three printed numbers that enter.
const PRINTED: f64 = 2e-5;

/// A sum is also wrong by this share of its largest term.
const OF_TERMS: f64 = 3e-6;

/// A number, or a vector: three of them. Colours are multiplied component by component.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Value {
    parts: [f64; 3],
    /// The size of the largest term that entered each.
    sizes: [f64; 3],
    is_vector: bool,
}

impl Value {
    fn number(value: f64) -> Self {
        Self {
            parts: [value; 3],
            sizes: [value.abs(); 3],
            is_vector: false,
        }
    }

    /// Joins each part with that of another value; both functions are of (value, size) pairs.
    fn join(self, other: Self, join: impl Fn((f64, f64), (f64, f64)) -> (f64, f64)) -> Self {
        let mut joined = self;
        joined.is_vector |= other.is_vector;
        for i in 0..3 {
            let left = (self.parts[i], self.sizes[i]);
            let right = (other.parts[i], other.sizes[i]);
            (joined.parts[i], joined.sizes[i]) = join(left, right);
        }
        joined
    }
}

/// Reads sums, products and powers of numbers and vectors.
struct Calculator<'a> {
    rest: &'a str,
}

impl Calculator<'_> {
    fn eat(&mut self, sign: &str) -> bool {
        self.rest = self.rest.trim_start();
        let found = self.rest.strip_prefix(sign);
        self.rest = found.unwrap_or(self.rest);
        found.is_some()
    }

    fn sum(&mut self) -> Option<Value> {
        let mut value = self.product()?;
        loop {
            let sign = if self.eat("+ ") {
                1.0
            } else if self.eat("- ") {
                -1.0
            } else {
                return Some(value);
            };
            let term = self.product()?;
            value = value.join(term, |(a, s), (b, t)| (a + sign * b, s.max(t)));
        }
    }

    fn product(&mut self) -> Option<Value> {
        let mut value = self.power()?;
        loop {
            if self.eat("·") {
                let factor = self.power()?;
                value = value.join(factor, |(a, s), (b, t)| {
                    (a * b, (s * b.abs()).max(t * a.abs()))
                });
            } else if self.eat("/") {
                let factor = self.power()?;
                value = value.join(factor, |(a, s), (b, _)| (a / b, s / b.abs()));
            } else {
                return Some(value);
            }
        }
    }

    fn power(&mut self) -> Option<Value> {
        let mut value = self.operand()?;
        loop {
            if self.eat("²") {
                value = value.join(value, |(a, s), _| (a * a, s * s));
            } else if self.eat("^") {
                let exponent = self.operand()?;
                // the base is printed with six digits, of which the power loses some
                value = value.join(exponent, |(a, _), (e, _)| {
                    let power = a.powf(e);
                    (power, power * (1.0 + e))
                });
            } else {
                return Some(value);
            }
        }
    }

    fn operand(&mut self) -> Option<Value> {
        if self.eat("[") {
            let inner = self.sum()?;
            return self.eat("]").then_some(inner);
        }
        for (name, choose) in [
            ("min(", f64::min as fn(f64, f64) -> f64),
            ("max(", f64::max),
        ] {
            if self.eat(name) {
                let first = self.sum()?;
                let second = self.eat(",").then(|| self.sum())??;
                let chosen = first.join(second, |(a, s), (b, t)| (choose(a, b), s.max(t)));
                return self.eat(")").then_some(chosen);
            }
        }
        if self.eat("(") {
            let first = self.sum()?;
            if self.eat(")") {
                return Some(first);
            }
            let mut parts = [first; 3];
            for part in &mut parts[1..] {
                if !self.eat(",") {
                    return None;
                }
                *part = self.sum()?;
            }
            return self.eat(")").then_some(Value {
                parts: parts.map(|part| part.parts[0]),
                sizes: parts.map(|part| part.sizes[0]),
                is_vector: true,
            });
        }
        if self.eat("π") {
            return Some(Value::number(std::f64::consts::PI));
        }
        if self.eat("-") {
            let value = self.operand()?;
            return Some(value.join(value, |(a, s), _| (-a, s)));
        }
        let mut end = 0;
        for (i, c) in self.rest.char_indices() {
            let in_exponent = self.rest[..i].ends_with('e') && c == '-';
            if !(c.is_ascii_digit() || c == '.' || (c == 'e' && 0 < i) || in_exponent) {
                break;
            }
            end = i + c.len_utf8();
        }
        let value: f64 = self.rest[..end].trim_end_matches('.').parse().ok()?;
        self.rest = &self.rest[end..];
        // 4π
        if let Some(after) = self.rest.strip_prefix('π') {
            self.rest = after;
            return Some(Value::number(value * std::f64::consts::PI));
        }
        Some(Value::number(value))
    }
}

/// The value that a text begins with, if it ends where a number may end.
fn at_start(text: &str) -> Option<Value> {
    let mut calculator = Calculator { rest: text };
    let value = calculator.sum()?;
    let ends = calculator.rest.trim_start();
    let whole = ends.is_empty() || ends.starts_with([',', ':', ';', '>', '<', '…', '(']);
    whole.then_some(value)
}

/// The value of the longest expression that a text ends with.
fn at_end(text: &str) -> Option<Value> {
    let after_space = text.match_indices(' ').map(|(at, _)| at + 1);
    std::iter::once(0).chain(after_space).find_map(|start| {
        // the rest of a longer expression, of which the first part has letters
        let before = text[..start].trim_end();
        let open = before.matches(['(', '[']).count() != before.matches([')', ']']).count();
        if open
            || before.ends_with(['+', '-', '±', '·', '/'])
            || text[start..].starts_with("- ")
            || text[start..].starts_with("+ ")
        {
            return None;
        }
        let mut calculator = Calculator {
            rest: &text[start..],
        };
        let value = calculator.sum()?;
        calculator.rest.trim().is_empty().then_some(value)
    })
}

/// How many equations of a line were computed again: between numbers, and between vectors.
#[track_caller]
pub(crate) fn check_line(line: &str) -> [usize; 2] {
    let mut checked = [0; 2];
    // the one step that is told in words
    if line.contains("normalised") {
        return checked;
    }
    let parts: Vec<_> = line.split(" = ").collect();
    for pair in parts.windows(2) {
        let (Some(left), Some(right)) = (at_end(pair[0]), at_start(pair[1])) else {
            continue;
        };
        if left.is_vector != right.is_vector {
            continue;
        }
        for i in 0..3 {
            let (a, b) = (left.parts[i], right.parts[i]);
            let allowed = PRINTED * a.abs().max(b.abs()) + OF_TERMS * left.sizes[i];
            assert!((a - b).abs() <= allowed, "{a} {b} in: {line}");
        }
        checked[usize::from(left.is_vector)] += 1;
    }
    checked
}

fn solution(scene: &str, pixel: [u32; 2], settings: &Settings) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(scene);
    solution_of(&load(&path).unwrap().build().unwrap(), pixel, settings)
}

fn solution_of(scene: &Scene, pixel: [u32; 2], settings: &Settings) -> String {
    let strategy = Chosen::new(scene, settings.strategy, &settings.structure).unwrap();
    let tracer = Tracer::new(scene, &strategy, Transport::HybridLight);
    let mut recording = Recording::new(Vec::new());
    if settings.building {
        strategy.note_building(&mut recording);
    }
    trace_pixel(&tracer, pixel, Through::Centres, &mut recording).unwrap();
    let options = WorkedOptions {
        all: true,
        ..WorkedOptions::default()
    };
    worked_solution(scene, settings, &recording.into_sink(), &options)
}

/// At least so many equations in the solution, each of which comes out.
#[track_caller]
fn check(scene: &str, pixel: [u32; 2], at_least: [usize; 2]) {
    check_with(&Settings::default(), scene, pixel, at_least);
}

#[track_caller]
fn check_with(settings: &Settings, scene: &str, pixel: [u32; 2], at_least: [usize; 2]) {
    let text = solution(scene, pixel, settings);
    check_text(&text, at_least);
}

/// At least so many equations in a solution, each of which comes out.
#[track_caller]
fn check_text(text: &str, at_least: [usize; 2]) {
    let mut sum = [0; 2];
    // P goes over two lines
    for line in text.replace("\n    = ", " = ").lines() {
        let checked = check_line(line);
        sum = [sum[0] + checked[0], sum[1] + checked[1]];
    }
    let enough = at_least[0] <= sum[0] && at_least[1] <= sum[1];
    assert!(enough, "only {sum:?} equations in\n{text}");
}

#[test]
fn the_calculator_knows_the_signs_that_the_solution_uses() {
    for (text, value) in [
        ("1·2 + 3·(-4) - 5", -15.0),
        ("2·[0.5² + (-1)²]", 2.5),
        ("-6/(-0.5)", 12.0),
        ("(3 - 1)/4 : so", 0.5),
        ("0.5^3, and", 0.125),
        ("min(-1, -3)", -3.0),
        ("2·max(2e-1, -4) - 1", -0.6),
        ("1.5e-3 … (v)", 0.0015),
        ("2/(4π)·π", 0.5),
    ] {
        assert_eq!(
            at_start(text).map(|value| value.parts[0]),
            Some(value),
            "{text}"
        );
    }
    let vector = at_start("[(1, 2, 3) - (1, 1, 1)]/2·(2, 2, 4)").unwrap();
    assert_eq!((vector.parts, vector.is_vector), ([0.0, 1.0, 4.0], true));
    assert_eq!(at_start("2 pixels"), None);
}

#[test]
#[should_panic(expected = "in: x = 1 + 1 = 3")]
fn a_wrong_sum_is_noticed() {
    check_line("x = 1 + 1 = 3");
}

#[test]
#[should_panic(expected = "in: L = (1, 0, 0) + (0, 1, 0) = (1, 2, 0)")]
fn a_wrong_vector_is_noticed() {
    check_line("L = (1, 0, 0) + (0, 1, 0) = (1, 2, 0)");
}

#[test]
fn the_two_balls_can_be_computed_again() {
    for pixel in [
        [80, 60],
        [40, 70],
        [120, 60],
        [20, 75],
        [80, 110],
        [110, 58],
    ] {
        check("lessons/04-sphere/scene.json", pixel, [10, 1]);
    }
}

#[test]
fn glass_and_total_internal_reflection_can_be_computed_again() {
    for pixel in [[112, 56], [125, 55], [140, 62]] {
        check("lessons/04-sphere/scene.json", pixel, [60, 30]);
    }
}

#[test]
fn a_cone_along_its_generator_can_be_computed_again() {
    // k = −¾; (−3, 4, 0)/5 runs along a generator: from (0, 0, 1) t = 8/3.6, from (3, 0, 7), in the plane that
    // touches the cone there, no t
    for (cop, target, line) in [
        (
            [0, 0, 1],
            [-3, 4, 1],
            "a = 0: b·t + c = 0, t = -c/b = 8/3.6 = 2.22222",
        ),
        (
            [3, 0, 7],
            [0, 4, 7],
            "a = 0 and b = 0: 49 = 0 has no solution for any t",
        ),
    ] {
        let text = format!(
            r#"{{"camera": {{"look_at": {{"cop": {cop:?}, "target": {target:?}, "up": [0, 0, 1], "fov_degrees": 40}},
            "pixels": [1, 1]}}, "materials": {{"m": {{"colour": [1, 1, 1]}}}}, "objects": [{{"name": "A",
            "material": "m", "shape": {{"cone": {{"base": [0, 0, 0], "base_radius": 3, "apex": [0, 4, 0],
            "apex_radius": 0}}}}}}]}}"#
        );
        let scene = load_bytes("cone.json", text.as_bytes(), Path::new("")).unwrap();
        let scene = scene.build().unwrap();
        for strategy in [StrategyName::Exhaustive, StrategyName::ZAligned] {
            let settings = Settings {
                strategy,
                ..Settings::default()
            };
            let text = solution_of(&scene, [0, 0], &settings);
            check_text(&text, [3, 1]);
            assert!(text.contains(line), "{text}");
        }
    }
}

#[test]
fn pixels_of_the_databases_can_be_computed_again() {
    for (name, at_least) in [
        ("balls-2", [500, 10]),
        ("gears-1", [100, 5]),
        ("mount-3", [100, 5]),
        ("rings-1", [50, 5]),
        ("teapot-2", [500, 5]),
        ("tetra-3", [50, 3]),
        ("tree-4", [100, 5]),
    ] {
        for pixel in [[256, 256], [200, 300]] {
            check(&format!("tests/data/nff/{name}.nff"), pixel, at_least);
        }
    }
}
