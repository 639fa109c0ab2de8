//! The worked solution can be followed with a calculator: every line of arithmetic that it prints is
//! computed again from the printed numbers alone, and gives the printed result.

mod light;
mod strategies;

use std::path::Path;

use raystep::strategy::Strategy;
use raystep::tracer::trace_pixel;
use raystep::{
    Chosen, NoFiles, Recording, Scene, Settings, StrategyName, Through, Tracer, Transport,
    WorkedOptions, load, load_bytes,
};

use crate::worked_solution::worked_text;

/// Half a unit in the sixth digit, of three printed numbers that enter.
const PRINTED: f64 = 2e-5;

/// A sum is also wrong by this share of its largest term.
const OF_TERMS: f64 = 3e-6;

/// A sum of squares that is 0 but for rounding has no more than six digits of each number: 5·10⁻⁶ of it, twice that of
/// its square, and of four squares at most.
const OF_SQUARES: f64 = 4e-5;

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
                // what a difference below the line has lost counts as well
                value = value.join(factor, |(a, s), (b, t)| {
                    (a / b, (s / b.abs()).max(t * a.abs() / (b * b)))
                });
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
    let words = ["but for rounding", "times: ", "and "];
    (whole || words.iter().any(|word| ends.starts_with(word))).then_some(value)
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

/// Both sides of an equation, if they can be computed.
fn sides(left: &str, right: &str) -> Option<[Value; 2]> {
    // the one step that is written in words
    let direction = left.strip_suffix(", normalised");
    let mut sides = [at_end(direction.unwrap_or(left))?, at_start(right)?];
    if direction.is_some() {
        let length = sides[0].parts.iter().map(|part| part * part).sum::<f64>();
        let divide = |part: f64| part / length.sqrt();
        sides[0].parts = sides[0].parts.map(divide);
        sides[0].sizes = sides[0].sizes.map(divide);
    }
    (sides[0].is_vector == sides[1].is_vector).then_some(sides)
}

#[track_caller]
fn check_sides(sides: [Value; 2], line: &str) {
    check_within(sides, OF_TERMS, line);
}

/// The same, where the left side may be wrong by another share of its largest term.
#[track_caller]
fn check_within([left, right]: [Value; 2], of_terms: f64, line: &str) {
    for i in 0..3 {
        let (a, b) = (left.parts[i], right.parts[i]);
        let allowed = PRINTED * a.abs().max(b.abs()) + of_terms * left.sizes[i];
        assert!((a - b).abs() <= allowed, "{a} {b} in: {line}");
    }
}

/// A line as a keyboard has its signs.
fn typed(line: &str) -> String {
    line.replace('−', "-").replace('′', "'")
}

/// How many equations of a line were computed again: between numbers, and between vectors.
#[track_caller]
pub(crate) fn check_line(line: &str) -> [usize; 2] {
    let line = &typed(line);
    let mut checked = [0; 2];
    let parts: Vec<_> = line.split(" = ").collect();
    for pair in parts.windows(2) {
        let [left, right] = [pair[0], pair[1]];
        // both roots at once: the smaller one comes first
        if let (true, Some((near, far))) = (left.contains('±'), right.split_once(" and ")) {
            let root = |sign, root| sides(&left.replace('±', sign), root);
            let (Some(minus), Some(plus)) = (root("-", near), root("+", near)) else {
                continue;
            };
            let Some(far) = at_start(far) else {
                continue;
            };
            let (first, second) = if minus[0].parts[0] <= plus[0].parts[0] {
                (minus[0], plus[0])
            } else {
                (plus[0], minus[0])
            };
            check_sides([first, minus[1]], line);
            check_sides([second, far], line);
            checked[0] += 2;
            continue;
        }
        let Some(sides) = sides(left, right) else {
            continue;
        };
        let is_rounding = right.starts_with("0 but for rounding");
        let of_terms = if is_rounding { OF_SQUARES } else { OF_TERMS };
        check_within(sides, of_terms, line);
        checked[usize::from(sides[0].is_vector)] += 1;
    }
    // P - COP = (…), of length …
    if let Some((vector, length)) = line.split_once(", of length ") {
        let value = at_end(vector).zip(at_start(length));
        if let Some((vector, length)) = value {
            let squares = vector.parts.iter().map(|part| part * part);
            let of_vector = Value::number(squares.sum::<f64>().sqrt());
            check_sides([of_vector, length], line);
            checked[0] += 1;
        }
    }
    checked
}

/// Lines with an equals sign that there is nothing to compute in, by what they hold, and why.
const NOT_COMPUTED: [(&str, &str); 35] = [
    ("… (i)", "equation (i) itself, with the ray's numbers"),
    ("… (iii)", "equation (iii) itself"),
    ("… (iv)", "equation (iv) itself, with the plane's numbers"),
    ("o - centre", "o and the centre are on other lines"),
    ("Δ → ", "Δ and the radii are on other lines"),
    ("axis w = ", "the axis of a cone, as the scene has it"),
    ("m = o - base: ", "o and the base are on other lines"),
    ("Δ: Δ·w = ", "Δ and w are on other lines"),
    ("p = o + t·Δ = ", "o, t and Δ are on other lines"),
    (
        ", on the z axis",
        "the z of p is t, which is on another line",
    ),
    (
        "in which the ray is the z axis: p' = ",
        "what the frame does to any p",
    ),
    ("o = (", "the ray, as it is"),
    (
        "y = z × x = ",
        "a vector product, of vectors on other lines",
    ),
    ("o' = (0, 0, 0), Δ' = ", "the ray in its own frame"),
    (" at z = ", "the t of a hit, which is in the hit's test"),
    ("Δ = (P - COP)/", "P - COP is on the line above"),
    ("Δ = T = ", "T is in the refraction"),
    ("Δ = (x - x')/|x - x'| = ", "x and x' are on other lines"),
    (": a random direction", "a random direction"),
    (
        "Russian roulette: ξ = ",
        "a random number, or no number at all",
    ),
    (
        "colour·diffuse = ",
        "a product of the material, whose colour is in the scene",
    ),
    ("N = (A, B, C) = ", "the plane's normal, which is in (iv)"),
    ("N = -(A, B, C) = ", "the plane's normal, which is in (iv)"),
    (
        "N = normal of the face where ",
        "the face's normal, in words",
    ),
    (
        "N = (m⊥/|m⊥| - k·w), normalised",
        "m⊥ and w are on other lines",
    ),
    ("R = 2(N·L)N - L = ", "N and L are on other lines"),
    ("n₁·sin θ₁ = n₂·sin θ₂", "Snell's law itself"),
    ("cos θ₁ = -Δ·N = ", "Δ and N are on other lines"),
    ("x = (", "the two ends of a line, as they are"),
    ("cos θ = 1", "the end of a line that has no normal"),
    ("cos θ' = 1", "the end of a line that has no normal"),
    ("I = gathered = ", "a sum of one term"),
    (": p is in a cell of the surface's map", "the cell's area"),
    ("and c = ", "c, which is not 0"),
    (
        " from the COP; the aperture has R = ",
        "the COP is in the scene, and R is given",
    ),
];

/// More of them, which begin with these words or hold them alone.
const NO_TERMS: [(&str, &str); 5] = [
    ("area: a disc with r = ", "the distance of the last photon"),
    (
        "irradiance: no photon is stored here",
        "nothing is gathered",
    ),
    ("w = 1: no other edge", "a single share"),
    ("→ contribution: none, V = 0", "the line is blocked"),
    (
        "normal: N = -(m⊥/|m⊥| - k·w), normalised",
        "m⊥ and w are on other lines",
    ),
];

/// Why there is nothing to compute in a line; `None` if it should have been computed.
fn why_not_computed(line: &str) -> Option<&'static str> {
    let line = line.trim_start();
    let named = NOT_COMPUTED.iter().find(|(words, _)| line.contains(words));
    let begins = NO_TERMS.iter().find(|(words, _)| line.starts_with(words));
    // t of a root, a bound or a hit, as the lines above have found it
    let parts: Vec<&str> = line.split(" = ").collect();
    let (_, before) = parts.split_last()?;
    let is_t = |left: &&str| *left == "t" || left.ends_with(" t");
    let of_t = before
        .iter()
        .all(is_t)
        .then_some("a t that was found above");
    named.or(begins).map(|(_, why)| *why).or(of_t)
}

/// What a text says of a polygon, up to its p′.
#[derive(Debug, Default)]
struct Outline {
    /// A, B and C.
    plane: Option<[f64; 3]>,
    /// p.
    point: Option<[f64; 3]>,
    /// Which coordinate is dropped.
    dropped: Option<usize>,
}

impl Outline {
    /// Checks that the axis is that of the largest coefficient, and that p′ is p without its coordinate. Returns how
    /// many of the two the line has.
    #[track_caller]
    fn check(&mut self, line: &str) -> usize {
        let line = line.trim_start();
        if let Some(equation) = line.strip_prefix("plane: ") {
            *self = Self::default();
            self.plane = Some(coefficients(equation));
        } else if line.starts_with("p = ") {
            let right = line.rsplit(" = ").next();
            self.point = right.and_then(at_start).map(|point| point.parts);
        } else if let Some(words) = line.strip_prefix("axis: ") {
            let letter = words
                .split(", so ")
                .nth(1)
                .or(words.strip_prefix("z, ").map(|_| "z"));
            let letter = letter.and_then(|word| word.chars().next()).unwrap();
            let dropped = "xyz".find(letter).unwrap();
            self.dropped = Some(dropped);
            // along the z axis the coefficients are those of the scene's frame
            let Some((_, value)) = words.split_once("| = ") else {
                return 1;
            };
            let size = at_start_of(value);
            let plane = self.plane.unwrap().map(f64::abs);
            assert!(
                words.starts_with(&format!("|{}|", &"ABC"[dropped..=dropped])),
                "{line}"
            );
            for coefficient in plane {
                assert!(coefficient <= size * (1.0 + PRINTED), "{plane:?} {line}");
            }
            assert!(
                (plane[dropped] - size).abs() <= PRINTED * size,
                "{plane:?} {line}"
            );
            return 1;
        } else if let Some(point) = line.strip_prefix("p' = (") {
            let (of, dropped) = (self.point.unwrap(), self.dropped.unwrap());
            let numbers: Vec<f64> = point
                .trim_end_matches(')')
                .split(", ")
                .map(|number| number.parse().unwrap())
                .collect();
            let kept: Vec<f64> = (0..3).filter(|&i| i != dropped).map(|i| of[i]).collect();
            assert_eq!(numbers, kept, "{line}");
            return 1;
        }
        0
    }
}

/// A, B and C of `0.5·x - y + 0·z + 2 = 0 … (iv)`.
#[track_caller]
fn coefficients(equation: &str) -> [f64; 3] {
    let mut rest = equation;
    ["x", "y", "z"].map(|letter| {
        let (term, after) = rest.split_once(letter).unwrap();
        rest = after.trim_start();
        let term = term
            .trim_end_matches('·')
            .replace("- ", "-")
            .replace("+ ", "");
        match term.as_str() {
            "" => 1.0,
            "-" => -1.0,
            number => number.parse().unwrap(),
        }
    })
}

/// The number that a text begins with.
#[track_caller]
fn at_start_of(text: &str) -> f64 {
    let number = text.split([' ', ',']).next().unwrap();
    number.parse().unwrap()
}

/// The lines of a text, those that go on an equation of the line above joined to it.
fn whole_lines(text: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for line in text.lines() {
        match lines.last_mut() {
            Some(last) if line.trim_start().starts_with("= ") => {
                *last += " ";
                *last += line.trim_start();
            }
            _ => lines.push(line.into()),
        }
    }
    lines
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
    worked_text(scene, settings, &recording.into_sink(), &options)
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
    let mut left_out = Vec::new();
    let mut outline = Outline::default();
    for line in whole_lines(&typed(text)) {
        let mut checked = check_line(&line);
        checked[0] += outline.check(&line);
        sum = [sum[0] + checked[0], sum[1] + checked[1]];
        if checked == [0; 2] && line.contains(" = ") && why_not_computed(&line).is_none() {
            left_out.push(line);
        }
    }
    assert!(
        left_out.is_empty(),
        "{} lines were not computed again:\n{}",
        left_out.len(),
        left_out.join("\n")
    );
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
#[should_panic(expected = "in: t = (-b ± √4)/2a = (6 ± 2)/4 = 1 and 3")]
fn a_wrong_root_is_noticed() {
    check_line("t = (-b ± √4)/2a = (6 ± 2)/4 = 1 and 3");
}

#[test]
fn the_axis_and_the_point_without_its_coordinate_are_checked() {
    let lines = "plane: 0.6·x − y + 0·z + 2 = 0 … (iv)\n\
                 p = o + t·Δ = (1, 2.6, 5)\n\
                 axis: |B| = 1 is the largest coefficient, so y is dropped\n\
                 p′ = (1, 5)";
    check_text(lines, [2, 0]);
    let wrong = |from, to| {
        let text = lines.replace(from, to);
        std::panic::catch_unwind(|| check_text(&text, [2, 0])).is_err()
    };
    assert!(!wrong("2.6", "2.7"));
    assert!(wrong("p′ = (1, 5)", "p′ = (2.6, 5)"));
    assert!(wrong("p′ = (1, 5)", "p′ = (1, 6)"));
    // x has not the largest coefficient, and B is not 2
    assert!(wrong(
        "|B| = 1 is the largest coefficient, so y",
        "|A| = 0.6 is the largest coefficient, so x"
    ));
    assert!(wrong("|B| = 1", "|B| = 2"));
}

#[test]
fn roots_normals_and_lengths_are_computed_too() {
    assert_eq!(check_line("t = (-b ± √4)/2a = (6 ± 2)/4 = 1 and 2"), [2, 0]);
    let normal =
        "N = (p - centre)/radii² = [(2, 1, 0) - (1, 1, 0)]/(2, 1, 1)², normalised = (1, 0, 0)";
    assert_eq!(check_line(normal), [0, 1]);
    assert_eq!(check_line("P - COP = (3, 0, 4), of length 5"), [1, 0]);
    // six digits of each number of the second leave 9.7·10⁻⁸
    for rounding in [
        "c = |o - centre|² - r² = 0.6² + 0.8² + 0² - 1² = 0 but for rounding",
        "c = |o - centre|² - r² = (-0.126746)² + (-0.113287)² + (-0.00126639)² - 0.17² = 0 but for rounding",
    ] {
        assert_eq!(check_line(rounding), [1, 0]);
    }
}

#[test]
#[should_panic(expected = "= 0 but for rounding")]
fn a_sum_that_is_not_0_is_noticed() {
    check_line("c = |o - centre|² - r² = 0.6² + 0.81² + 0² - 1² = 0 but for rounding");
}

#[test]
fn a_line_that_goes_on_an_equation_is_part_of_it() {
    let text = "  t = -(A·x₀ + D)/(A·Δx) … (v)\n    = -(2·3 - 4)/(2·1)\n    = -2/2 = -1\nend";
    let lines = whole_lines(text);
    assert_eq!(lines.len(), 2);
    assert_eq!(check_line(&lines[0]), [2, 0]);
}

#[test]
#[should_panic(expected = "1 lines were not computed again:\n  E = a lot = 3")]
fn a_line_that_cannot_be_computed_is_named() {
    check_text(
        "  1 + 1 = 2\n  E = a lot = 3\n  t = 4 lies behind the origin",
        [1, 0],
    );
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
            "a = 0 leaves b·t + c = 0, one root t = −c/b = 8/3.6 = 2.22222",
        ),
        (
            [3, 0, 7],
            [0, 4, 7],
            "none, since a = 0 and b = 0, and c = 49 is not 0",
        ),
    ] {
        let text = format!(
            r#"{{"camera": {{"look_at": {{"cop": {cop:?}, "target": {target:?}, "up": [0, 0, 1], "fov_degrees": 40}},
            "pixels": [1, 1]}}, "materials": {{"m": {{"colour": [1, 1, 1]}}}}, "objects": [{{"name": "A",
            "material": "m", "shape": {{"cone": {{"base": [0, 0, 0], "base_radius": 3, "apex": [0, 4, 0],
            "apex_radius": 0}}}}}}]}}"#
        );
        let scene = load_bytes("cone.json", text.as_bytes(), &NoFiles).unwrap();
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
