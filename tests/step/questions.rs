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
use raystep::{Event, Record};

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
