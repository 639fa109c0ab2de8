//! The stages of the argument that a volume wastes space and tests.

use crate::explain::Part;
use crate::figure::kinds::volumes::panel::{Panel, Verdict, name, percent};
use crate::figure::sheet::Sheet;
use crate::figure::sheet::stage::StageId;

/// The stages, in their order.
pub(super) struct Argument {
    pub(super) object: StageId,
    pub(super) volumes: StageId,
    /// The others are there only where rays are shown.
    pub(super) rays: Option<Rays>,
}

/// The stages of the rays.
pub(super) struct Rays {
    pub(super) all: StageId,
    /// One for each ray, but for the last of many.
    each: Vec<StageId>,
    pub(super) wasted: StageId,
}

impl Argument {
    pub(super) fn new(sheet: &mut Sheet, of: &str, panels: &[Panel], with_rays: bool) -> Self {
        let object = sheet.stage(
            "object",
            None,
            format!("{of} gets a volume around it: only rays that hit the volume are tested against {of}."),
        );
        let empty = panels
            .iter()
            .map(|panel| format!("{} of the {}", percent(panel.wasted), name(panel.kind)));
        let empty: Vec<String> = empty.collect();
        let volumes = sheet.stage(
            Part::Bound,
            None,
            format!("Seen from here, {} is empty.", listed(&empty)),
        );
        Self {
            object,
            volumes,
            rays: with_rays.then(|| Rays::new(sheet, of, panels)),
        }
    }
}

impl Rays {
    /// Up to this number of rays each has a stage of its own: a figure has a dozen stages at most.
    const EACH: usize = 7;

    fn new(sheet: &mut Sheet, of: &str, panels: &[Panel]) -> Self {
        let count = panels.first().map_or(0, |panel| panel.rays.len());
        let steps = |number: usize| {
            let rays = panels
                .iter()
                .filter_map(move |panel| panel.rays.get(number));
            rays.map(|ray| (ray.starts, ray.step))
        };
        let mut last = (0..count)
            .filter_map(|ray| steps(ray).filter_map(|of| of.0).max())
            .max();
        let all = sheet.stage(
            Part::Ray,
            last,
            format!("The same {count} rays are tested against each volume."),
        );
        let mut each = Vec::new();
        for number in 0..count.min(Self::EACH) {
            let is_rest = number + 1 == Self::EACH && number + 1 < count;
            let numbers = if is_rest {
                number..count
            } else {
                number..number + 1
            };
            // each pixel counts its steps from 0
            let step = numbers
                .clone()
                .filter_map(|ray| steps(ray).map(|of| of.1).max());
            last = step.chain(last).max();
            let sentence = if is_rest {
                format!(
                    "The other {} rays are tested in the same way.",
                    count - number
                )
            } else {
                of_ray(number, of, panels)
            };
            each.push(sheet.stage(Part::Bound, last, sentence));
        }
        let wasted = panels
            .iter()
            .map(|panel| format!("{} with the {}", panel.wasted_tests(), name(panel.kind)));
        let wasted: Vec<String> = wasted.collect();
        let wasted = sheet.stage(
            "wasted tests",
            last,
            format!("Wasted tests of {of}: {}.", listed(&wasted)),
        );
        Self { all, each, wasted }
    }

    /// The stage of a ray, numbered from 0.
    pub(super) fn of(&self, ray: usize) -> StageId {
        let own = self.each.get(ray).or(self.each.last());
        own.copied().unwrap_or(self.wasted)
    }
}

/// What became of a ray at each volume.
fn of_ray(number: usize, of: &str, panels: &[Panel]) -> String {
    let with = |verdict: Verdict| {
        let is_it = |panel: &&Panel| {
            let ray = panel.rays.get(number);
            ray.is_some_and(|ray| ray.verdict == verdict)
        };
        let names = panels.iter().filter(is_it);
        names
            .map(|panel| format!("the {}", name(panel.kind)))
            .collect::<Vec<String>>()
    };
    let ray = format!("Ray {}", number + 1);
    let [hit, wasted, missed] = Verdict::ALL.map(with);
    if !hit.is_empty() {
        return format!("{ray} hits the volumes and {of}.");
    }
    match (wasted.is_empty(), missed.is_empty()) {
        (false, false) => format!(
            "{ray} misses {of}: it hits {}, so its test of {of} is wasted there, and misses {}.",
            listed(&wasted),
            listed(&missed)
        ),
        (false, true) => {
            format!("{ray} misses {of} but hits every volume: each test of {of} is wasted.")
        }
        _ => format!("{ray} misses every volume, so {of} is not tested."),
    }
}

/// a, b and c.
fn listed(words: &[String]) -> String {
    match words {
        [] => String::new(),
        [only] => only.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}
