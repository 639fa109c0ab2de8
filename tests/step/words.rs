//! The words of a step are the lines of the worked solution that tell it.

use std::collections::BTreeMap;

use raystep::explain::{Line, StepAddress, Tone};
use raystep::step::{Level, StepLog, StepWords, headline};
use raystep::trace::Kind;
use raystep::{Page, WorkedOptions, worked_solution};

use super::each_of_few;

/// The whole solution, and for each line the places of its steps among the records.
fn solution(log: &StepLog) -> (Page, Vec<Option<[usize; 2]>>) {
    let options = WorkedOptions {
        all: true,
        ..WorkedOptions::default()
    };
    let page = worked_solution(log.scene, log.settings, log.records, &options);
    let records = log.records.iter().enumerate();
    let places: BTreeMap<StepAddress, usize> = records
        .map(|(place, record)| (StepAddress::of(record), place))
        .collect();
    let of_line = |line: &Line| {
        let steps = line.steps?;
        Some([places[&steps.first], places[&steps.last]])
    };
    let of_lines = page.lines.iter().map(of_line).collect();
    (page, of_lines)
}

/// What the page says of the step: the lines whose range lies within it, or without any those of the range around it. S and T of
/// all slabs were computed before the first bound, and its lines begin with them: they are of the bound's test all the same. An
/// aside that is said once on a page may stand again.
fn expected<'a>(
    log: &StepLog,
    number: usize,
    (page, places): &'a (Page, Vec<Option<[usize; 2]>>),
) -> Vec<&'a Line> {
    let events = &log.step(number).events;
    let lines = || {
        page.lines
            .iter()
            .zip(places)
            .filter_map(|(line, place)| Some((line, (*place)?)))
    };
    let lines = || lines().filter(|(line, _)| line.tone != Tone::Aside);
    let is_slab_ray = |at: &usize| log.records[*at].event.kind() == Kind::SlabRay;
    let begins = |[first, last]: [usize; 2]| (first..=last).find(|at| !is_slab_ray(at));
    let within = lines().filter(|(_, [first, last])| {
        events.start <= begins([*first, *last]).unwrap_or(*first) && *last < events.end
    });
    let within: Vec<&Line> = within.map(|(line, _)| line).collect();
    if !within.is_empty() {
        return within;
    }
    let around = lines().filter(|(_, [first, last])| *first < events.end && events.start <= *last);
    around.map(|(line, _)| line).collect()
}

#[test]
fn the_words_of_a_test_or_an_event_are_the_lines_whose_steps_lie_within_it() {
    let (mut compared, mut lines) = (0, 0);
    each_of_few(|name, log| {
        let whole = solution(log);
        let words = StepWords::new(log);
        let told = |step: usize| {
            let step = log.step(step);
            step.is_leaf() || step.level == Level::Test && !step.is_fold()
        };
        let steps: Vec<usize> = (0..log.steps().len()).filter(|&step| told(step)).collect();
        for &step in steps.iter().step_by((steps.len() / 40).max(1)) {
            let found = words.of(log, step);
            let is_told = |line: &Line| line.tone != Tone::Heading && line.tone != Tone::Aside;
            let found_lines = found.iter().filter(|line| is_told(line));
            let texts = |line: &Line| {
                (
                    line.text.clone(),
                    line.tone,
                    line.steps,
                    line.ray,
                    line.part,
                )
            };
            let found_texts: Vec<_> = found_lines.map(texts).collect();
            let wanted = expected(log, step, &whole);
            let wanted: Vec<_> = wanted.into_iter().map(texts).collect();
            let what = || format!("{name}: {} {:?}", headline(log, step), log.step(step));
            assert_eq!(found_texts, wanted, "{}", what());
            // a heading stands above its first line, as on the page
            let first_below = |lines: &[Line], at: usize| {
                let mut below = lines[at + 1..].iter();
                below
                    .find(|line| is_told(line))
                    .map(|line| line.text.clone())
            };
            for (at, heading) in found.iter().enumerate() {
                if heading.tone == Tone::Heading {
                    let next = first_below(&found, at);
                    let on_page = whole.0.lines.iter().enumerate();
                    let above = on_page
                        .filter(|(_, line)| line.text == heading.text)
                        .any(|(at, _)| first_below(&whole.0.lines, at) == next);
                    assert!(next.is_some() && above, "{}: {heading:?}", what());
                }
            }
            compared += 1;
            lines += found.len();
        }
    });
    assert!(
        3000 < compared && 10_000 < lines,
        "{compared} steps, {lines} lines"
    );
}

#[test]
fn a_step_that_holds_others_is_told_by_its_own_events() {
    let mut compared = 0;
    each_of_few(|name, log| {
        let words = StepWords::new(log);
        let holds = |step: &usize| {
            let step = log.step(*step);
            !step.is_leaf() && step.level < Level::Test
        };
        for step in (0..log.steps().len()).filter(holds).take(12) {
            let found = words.of(log, step);
            if log.step(step).is_fold() {
                assert!(found.is_empty(), "{name}: {found:?}");
                continue;
            }
            let own: Vec<usize> = log
                .step(step)
                .children
                .clone()
                .filter(|&child| log.step(child).is_leaf() && log.step(child).level == Level::Term)
                .collect();
            for line in found.iter().filter(|line| line.steps.is_some()) {
                let of_own = own
                    .iter()
                    .any(|&child| words.of(log, child).iter().any(|own| own.text == line.text));
                assert!(of_own, "{name}: {} {line:?}", headline(log, step));
            }
            compared += 1;
        }
    });
    assert!(500 < compared, "{compared} steps");
}

#[test]
fn every_step_has_a_title_of_one_line() {
    each_of_few(|name, log| {
        for step in 0..log.steps().len() {
            let title = headline(log, step);
            assert!(
                !title.is_empty() && !title.contains('\n'),
                "{name}: {title:?}"
            );
        }
    });
}

#[test]
fn words_that_are_written_in_advance_are_those_that_are_found_step_by_step() {
    let mut compared = 0;
    each_of_few(|name, log| {
        let [found, in_advance] = [StepWords::new(log), StepWords::of_all(log)];
        for step in (0..log.steps().len()).step_by((log.steps().len() / 40).max(1)) {
            let title = headline(log, step);
            let [found, in_advance] = [&found, &in_advance].map(|words| words.of(log, step));
            assert_eq!(in_advance, found, "{name}: {title}");
            compared += found.len();
        }
    });
    assert!(10_000 < compared, "{compared} lines");
}
