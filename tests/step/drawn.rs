//! The figure of a step: which kind it is, and that it ends with the step.

use std::collections::BTreeSet;

use raystep::figure::FigureKind;
use raystep::lesson::StepFigures;
use raystep::step::{Level, StepLog};
use raystep::{Event, Rendition, StrategyName, Transport, Width};

use super::each_of_few;

/// The kind that shows a test, a place or a term, by the event that leads it.
fn expected(log: &StepLog, step: usize) -> Option<FigureKind> {
    let of = log.step(step);
    let record = &log.records[of.lead];
    if record.pixel.is_none() || of.is_fold() || log.settings.strategy == StrategyName::ZAligned {
        return None;
    }
    match (of.level, &record.event) {
        (Level::Section | Level::Ray, _) => Some(FigureKind::Rays),
        (_, Event::Pixel(_)) => Some(FigureKind::Window),
        (_, Event::SphereTest { .. }) => Some(FigureKind::Sphere),
        (_, Event::Cell(_) | Event::GridEnter(_)) => Some(FigureKind::Grid),
        (_, Event::Queue(_)) => Some(FigureKind::Heap),
        (_, Event::Node(_)) if log.settings.strategy == StrategyName::Hierarchy => {
            Some(FigureKind::Hierarchy)
        }
        (_, Event::LightTerm(_)) => Some(FigureKind::Shading),
        _ => None,
    }
}

#[test]
fn a_step_is_drawn_by_the_kind_that_shows_it_and_nothing_later_is_in_it() {
    let mut kinds: BTreeSet<FigureKind> = BTreeSet::new();
    let (mut drawings, mut as_expected, mut none) = (0, 0, 0);
    each_of_few(|name, log| {
        let figures = StepFigures::new(log);
        let steps = log.steps().len();
        for step in (0..steps).step_by(1 + steps / 7) {
            let how = (Width::Book, Rendition::default());
            let figure = match figures.draw(log, step, "raystep-test", how) {
                Ok(figure) => figure,
                Err(error) => {
                    assert!(!error.what.is_empty() && !error.fix.is_empty());
                    none += 1;
                    continue;
                }
            };
            let place = format!("{name}, step {step}");
            let svg = roxmltree::Document::parse(&figure.drawn.svg).unwrap();
            let desc = svg.descendants().find(|of| of.has_tag_name("desc"));
            let desc = desc.and_then(|of| of.text()).unwrap_or_default();
            assert!(!desc.is_empty(), "{place}");
            if let Some(expected) = expected(log, step)
                && figure.spec.kind == expected
            {
                as_expected += 1;
            }
            kinds.insert(figure.spec.kind);
            drawings += 1;
            // steps of the pixel are numbered alone where no path of light is drawn
            let last = &log.records[log.step(step).events.end - 1];
            if log.settings.transport == Transport::HybridLight && last.pixel.is_some() {
                let drawn = svg.descendants().filter_map(|of| of.attribute("data-step"));
                let drawn: Vec<u32> = drawn.map(|of| of.parse().unwrap()).collect();
                assert!(
                    drawn.iter().all(|&of| of <= last.step),
                    "{place}: {drawn:?}"
                );
            }
        }
    });
    assert!(
        400 < drawings && none * 10 < drawings,
        "{drawings} drawn, {none} not"
    );
    assert!(200 < as_expected, "{as_expected}");
    for kind in [
        FigureKind::Rays,
        FigureKind::Sphere,
        FigureKind::Polygon,
        FigureKind::Grid,
        FigureKind::Hierarchy,
        FigureKind::Heap,
        FigureKind::Alignment,
        FigureKind::Volumes,
        FigureKind::Shading,
        FigureKind::Window,
        FigureKind::Paths,
    ] {
        assert!(kinds.contains(&kind), "{kind:?} among {kinds:?}");
    }
}
