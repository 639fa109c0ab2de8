//! The stages of a figure of rays: each ray leaves, and ends somewhere; what a surface does to it; the pixel's colour.

use std::collections::BTreeMap;

use crate::explain::Part;
use crate::figure::kinds::rays::drawn::Drawn;
use crate::figure::kinds::rays::words;
use crate::figure::parts::scenery;
use crate::figure::parts::surface;
use crate::figure::sheet::Sheet;
use crate::figure::sheet::stage::{StageId, StageName};
use crate::figure::subject::Figure;
use crate::trace::{Event, Item, Purpose, RayNode, RayVerdict, Record};

/// What belongs to a stage: of a ray by its place among those that are drawn, of a pixel by its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Of {
    /// A ray leaves.
    Starts(usize),
    /// It ends.
    Ends(usize),
    /// What the surface where it ends does to it.
    Surface(usize),
    /// The colour of a pixel.
    Colour(usize),
}

/// What may become a stage of its own.
struct Unit {
    of: Vec<Of>,
    /// The place of its pixel, or path of light.
    tree: usize,
    step: u32,
    name: StageName,
    sentence: String,
}

/// When everything is drawn.
pub(super) struct Argument(BTreeMap<Of, StageId>);

impl Argument {
    /// With more rays than that each has one stage.
    const TWO_EACH: usize = 3;
    /// The most stages of a figure.
    const MOST: usize = 12;

    pub(super) fn new(figure: &Figure, sheet: &mut Sheet, drawn: &Drawn) -> Self {
        let mut units = units(figure, drawn);
        // pixel after pixel, of which each counts its steps from the same one; in each of them a child's events come between
        // those of its ray
        units.sort_by_key(|unit| (unit.tree, unit.step));
        let mut last = 0;
        for unit in &mut units {
            last = unit.step.max(last);
            unit.step = last;
        }
        let mut stages = BTreeMap::new();
        let each = units.len().div_ceil(Self::MOST).max(1);
        while !units.is_empty() {
            let rest = units.split_off(each.min(units.len()));
            let together = std::mem::replace(&mut units, rest);
            let step = together.iter().map(|unit| unit.step).max();
            let of: Vec<Of> = together.iter().flat_map(|unit| unit.of.clone()).collect();
            let count = together.len();
            let one = together.into_iter().next().filter(|_| count == 1);
            let stage = match one {
                Some(unit) => sheet.stage(unit.name, step, unit.sentence),
                None => sheet.stage("rays", step, format!("The next {count} rays are followed.")),
            };
            stages.extend(of.into_iter().map(|of| (of, stage)));
        }
        Self(stages)
    }

    /// The stage of something; of what has none, the first.
    pub(super) fn of(&self, of: Of) -> StageId {
        self.0.get(&of).copied().unwrap_or(StageId(0))
    }
}

fn units(figure: &Figure, drawn: &Drawn) -> Vec<Unit> {
    let mut units = Vec::new();
    let two_each = drawn.rays.len() <= Argument::TWO_EACH;
    for (place, &(number, node)) in drawn.rays.iter().enumerate() {
        let (section, tree) = &drawn.trees[number];
        let node = &tree.rays[node];
        let records = section.records;
        let step = |at: usize| section.step(&records[at]);
        let [Some(start), Some(end)] = node.ends_at else {
            continue;
        };
        let ends = match hit_at(records, node) {
            Some(at) => step(at),
            None => step(end),
        };
        let told = words::of_end(figure, node).unwrap_or_default();
        if two_each {
            units.push(Unit {
                of: vec![Of::Starts(place)],
                tree: number,
                step: step(start),
                name: words::name(node).into(),
                sentence: words::of_start(figure, node, records),
            });
        }
        units.push(Unit {
            of: if two_each {
                vec![Of::Ends(place)]
            } else {
                vec![Of::Starts(place), Of::Ends(place)]
            },
            tree: number,
            step: ends,
            name: if two_each {
                match node.start.map(|start| start.purpose) {
                    Some(Purpose::Shadow) => Part::Visibility.into(),
                    _ => Part::Nearest.into(),
                }
            } else {
                words::name(node).into()
            },
            sentence: told,
        });
        if let Some(met) = surface::Met::shown(figure, records, node) {
            units.push(Unit {
                of: vec![Of::Surface(place)],
                tree: number,
                step: section.step(met.record),
                name: met.stage_name(),
                sentence: met.stage_sentence(),
            });
        }
    }
    for (place, (section, tree)) in drawn.trees.iter().enumerate() {
        let colour = section
            .records
            .iter()
            .find(|record| matches!(record.event, Event::PixelColour(_)));
        let eye = tree.rays.first();
        let (Some(record), Some(eye), true) = (colour, eye, drawn.shows_colour) else {
            continue;
        };
        let seen = eye.end.and_then(|end| end.object);
        let what = match seen {
            Some(id) => format!("{} at the hit", scenery::name_of(figure.scene, id)),
            None => "the background".into(),
        };
        units.push(Unit {
            of: vec![Of::Colour(place)],
            tree: place,
            step: section.step(record),
            name: Part::PixelColour.into(),
            sentence: format!("The pixel has the colour of {what}."),
        });
    }
    units
}

/// The place of the event that makes a ray's nearest hit known, before the rays that it spawns.
fn hit_at(records: &[Record], node: &RayNode) -> Option<usize> {
    if node.end?.verdict != RayVerdict::Hit {
        return None;
    }
    let nearest = |item: &Item| match item {
        Item::Event(at) if matches!(records[*at].event, Event::Nearest { .. }) => Some(*at),
        _ => None,
    };
    node.items.iter().filter_map(nearest).next_back()
}
