//! Questions of steps: the right answer is found by another route, from the scene and the ray, and never from the event's
//! verdict; every choice has a reason, and no two choices are alike.

mod light;
mod objects;
mod search;

use std::collections::{BTreeMap, BTreeSet};

use raystep::geometry::{Ray, TRange};
use raystep::mistake::mistake;
use raystep::scene::{Primitive, PrimitiveId};
use raystep::step::{Asks, Question, StepLog};
use raystep::trace::RayStart;
use raystep::{Event, Record, Settings};

use super::{each_lesson, each_random};
use crate::seeded::Seeded;

/// Numbers in a question have six digits.
const SHOWN: f64 = 2e-5;

/// The event that a step's question is about, with what came before it on its ray.
struct Asked<'a, 'l> {
    log: &'a StepLog<'l>,
    question: &'a Question,
    events: &'a [Record],
    /// The events of the ray before the step's own and those of it, in order.
    on_ray: Vec<&'a Event>,
    start: Option<RayStart>,
}

impl<'a, 'l> Asked<'a, 'l> {
    fn new(log: &'a StepLog<'l>, number: usize, question: &'a Question) -> Self {
        let step = log.step(number);
        let events = &log.records[step.events.clone()];
        let lead = &log.records[step.lead];
        let on_ray: Vec<&Event> = log.records[..step.events.end]
            .iter()
            .filter(|record| {
                record.ray == lead.ray && (record.pixel, record.path) == (lead.pixel, lead.path)
            })
            .map(|record| &record.event)
            .collect();
        // of several eye rays of a pixel each has a number of its own
        let start = on_ray.iter().find_map(|event| match event {
            Event::Ray(start) => Some(*start),
            _ => None,
        });
        Self {
            log,
            question,
            events,
            on_ray,
            start,
        }
    }

    fn right(&self) -> &str {
        &self.question.choices[self.question.right].text
    }

    /// The events of the ray before the first event of the step.
    fn before(&self) -> &[&'a Event] {
        let own = self.events.iter().filter(|record| {
            // a ray's step holds the rays inside it
            record.ray == self.events[0].ray
        });
        &self.on_ray[..self.on_ray.len() - own.count()]
    }

    fn primitive(&self, object: PrimitiveId) -> &'l Primitive {
        self.log.scene.primitive(object)
    }

    fn ray(&self) -> Ray {
        self.start.unwrap().ray
    }

    /// Those t that count, up to the nearest hit that was noted before.
    fn range(&self) -> TRange {
        let nearest = self.before().iter().filter_map(|event| match event {
            Event::Nearest(hit) => Some(hit.t),
            _ => None,
        });
        nearest.fold(self.start.unwrap().range, TRange::up_to)
    }
}

/// The number behind some words.
fn number_in(text: &str, before: &str) -> Option<f64> {
    let rest = &text[text.find(before)? + before.len()..];
    let word = rest.split([' ', ',', ';']).next()?;
    word.trim_end_matches('.').replace('−', "-").parse().ok()
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= SHOWN * a.abs().max(b.abs()) + 1e-12
}

/// What is wrong with the right answer, if anything is.
fn wrong(asked: &Asked) -> Option<String> {
    let found = asked.right();
    let expected = match asked.question.asks {
        Asks::RootCount => objects::root_count(asked),
        Asks::RootThatCounts => objects::root_that_counts(asked),
        Asks::PlaneT => objects::plane_t(asked),
        Asks::DroppedAxis => objects::dropped_axis(asked),
        Asks::Inside => objects::inside(asked),
        Asks::SlabThatEnds => search::slab_that_ends(asked),
        Asks::Bound => search::bound(asked),
        Asks::NextNode => search::next_node(asked),
        Asks::Pruned => search::pruned(asked),
        Asks::NextPlane => search::next_plane(asked),
        Asks::Mailbox => search::mailbox(asked),
        Asks::FinalHit => search::final_hit(asked),
        Asks::Blocked => return light::blocked(asked),
        Asks::ZeroTerms => light::zero_terms(asked),
        Asks::TotalReflection => light::total_reflection(asked),
    };
    if found == expected {
        return None;
    }
    // a t as printed, and as computed here
    match (number_in(found, "t = "), number_in(&expected, "t = ")) {
        (Some(a), Some(b)) if close(a, b) => None,
        _ => Some(format!("{found:?}, expected {expected:?}")),
    }
}

/// What is wrong with the choices, if anything is.
fn wrong_choices(question: &Question) -> Option<String> {
    let texts: BTreeSet<&str> = question.choices.iter().map(|of| of.text.as_str()).collect();
    if texts.len() != question.choices.len() || !(2..=4).contains(&texts.len()) {
        return Some("two choices are alike, or there are too few or too many".into());
    }
    for choice in &question.choices {
        if choice.reason.len() < 10 || !choice.reason.ends_with('.') || choice.text.is_empty() {
            return Some(format!("no reason: {choice:?}"));
        }
        match choice.mistake.map(mistake) {
            Some(None) => return Some(format!("no such mistake: {choice:?}")),
            Some(Some(of)) if !choice.reason.contains(of.sentence) => {
                return Some(format!("the mistake is not told: {choice:?}"));
            }
            _ => {}
        }
    }
    let right = &question.choices[question.right];
    if right.mistake.is_some() || !question.text.ends_with('?') {
        return Some(format!("{right:?}"));
    }
    // numbers that are printed alike are no different answers
    let numbers: Vec<f64> = texts
        .iter()
        .filter_map(|text| number_in(text, "t = "))
        .collect();
    let alike = |a: usize, b: usize| a != b && numbers[a] == numbers[b];
    (0..numbers.len())
        .any(|a| (0..numbers.len()).any(|b| alike(a, b)))
        .then(|| "two numbers are equal".into())
}

/// So many steps of a log are asked of each kind, chosen by chance.
const OF_EACH: usize = 4;

/// So many steps of a log are tried.
const TRIED: usize = 150;

#[test]
fn the_right_answer_of_ten_thousand_steps_is_confirmed_by_another_route() {
    let mut random = Seeded::new(19);
    let mut counts: BTreeMap<Asks, usize> = BTreeMap::new();
    let mut places: BTreeMap<Asks, BTreeSet<usize>> = BTreeMap::new();
    let mut mistakes = BTreeSet::new();
    let mut check = |name: &str, log: &StepLog| {
        let mut of_log: BTreeMap<Asks, usize> = BTreeMap::new();
        let steps = log.steps().len();
        let tried: BTreeSet<usize> = (0..TRIED).map(|_| random.index(steps)).collect();
        for number in tried {
            let Some(question) = log.question(number) else {
                continue;
            };
            let count = of_log.entry(question.asks).or_default();
            if *count == OF_EACH {
                continue;
            }
            *count += 1;
            let asked = Asked::new(log, number, &question);
            if let Some(what) = wrong(&asked).or_else(|| wrong_choices(&question)) {
                panic!("{name}: {what}\n{question:#?}\n{:#?}", asked.events);
            }
            // the same step asks the same
            assert_eq!(log.question(number).as_ref(), Some(&question));
            *counts.entry(question.asks).or_default() += 1;
            places
                .entry(question.asks)
                .or_default()
                .insert(question.right);
            mistakes.extend(question.choices.iter().filter_map(|choice| choice.mistake));
        }
    };
    each_lesson(&mut check);
    each_random(&mut check);
    let all: usize = counts.values().sum();
    assert!(10_000 <= all, "{all}: {counts:?}");
    for asks in Asks::ALL {
        let count = counts.get(&asks).copied().unwrap_or_default();
        assert!(20 <= count, "{asks:?}: {counts:?}");
        assert!(
            2 <= places[&asks].len(),
            "{asks:?} stands at one place alone"
        );
    }
    assert!(15 <= mistakes.len(), "{mistakes:?}");
}

/// The question of a step of the pixel on paper: its text, its right choice, and the wrong ones in their order.
#[track_caller]
fn check_on_paper(
    choose: impl Fn(&StepLog) -> usize,
    text: &str,
    right: [&str; 2],
    wrong: &[(&str, Option<&str>)],
) {
    let scene = crate::worked_solution::scene();
    let records = crate::worked_solution::records(&scene);
    let settings = Settings::default();
    let log = StepLog::new(&scene, &settings, &records);
    let question = log.question(choose(&log)).unwrap();
    assert_eq!(question.text, text);
    let mut choices = question.choices.clone();
    let found = choices.remove(question.right);
    assert_eq!([found.text.as_str(), found.reason.as_str()], right);
    let found: Vec<_> = choices
        .iter()
        .map(|of| (of.text.as_str(), of.mistake))
        .collect();
    assert_eq!(found, wrong);
}

#[test]
fn the_questions_of_the_pixel_on_paper_are_those_that_a_lecturer_would_ask() {
    // the ball of radius 2 is 4 behind the eye, and M was hit at 4
    check_on_paper(
        |log| log.leaf(4),
        "The roots of ball are t = −6 and t = −2; t counts from 0 to 4, the nearest hit so far. Which root is the hit?",
        [
            "neither: the ray misses",
            "t = −6 lies behind the origin of the ray. t = −2 lies behind the origin of the ray.",
        ],
        &[("t = −6", Some("first root always")), ("t = −2", None)],
    );
    // x = 3, and the ray runs along z
    check_on_paper(
        |log| log.leaf(5),
        "Plane of wall: D = −3, the numerator A·x₀ + B·y₀ + C·z₀ + D is −3, the denominator A·Δx + B·Δy + C·Δz is 0 but for rounding. Where does the line of the ray hit the plane?",
        [
            "nowhere: the ray is parallel to the plane and beside it",
            "The denominator is 0, and the numerator −3 is not 0.",
        ],
        &[
            ("at t = ∞", Some("no parallel case")),
            (
                "nowhere: the ray is parallel to the plane and runs in it",
                None,
            ),
            ("at t = 0", None),
        ],
    );
    // (0, 3, 5): c = 9 + 25 − 1
    check_on_paper(
        |log| log.leaf(6),
        "For far, a·t² + b·t + c = 0 has a = 1, b = −10, c = 33. How many real roots are there?",
        [
            "none: the ray misses",
            "b² − 4ac = 100 − 132 = −32, which is below 0.",
        ],
        &[("one: the ray touches the surface", None), ("two", None)],
    );
    // from (0, 0, 4) back to the lamp in the eye; the ball begins 6 away, behind it
    check_on_paper(
        |log| log.step(log.leaf(7)).parent.unwrap(),
        "A shadow ray runs from (0, 0, 4) to light \"lamp\", which is 4 away. Is the light blocked, and by what?",
        [
            "not blocked",
            "No object is hit at a t up to 4, where the light is.",
        ],
        &[
            ("blocked by ball", Some("any hit counts")),
            ("blocked by M", Some("offset to the wrong side")),
            ("blocked by wall", None),
        ],
    );
    check_on_paper(
        |log| log.leaf(13),
        "The light \"lamp\" is not blocked; N·L = 1, R·V = 1. The material has diffuse 0.5, specular 0.25, shininess 3. Which of its two terms, diffuse and specular, are 0?",
        [
            "neither",
            "The diffuse term is above 0, with N·L = 1. The specular term is above 0, with R·V = 1.",
        ],
        &[
            ("the diffuse term alone", None),
            ("the specular term alone", None),
            ("both", Some("L from light to point")),
        ],
    );
}
