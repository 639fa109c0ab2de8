//! The steps of a pixel for a page that holds many: packed, and unpacked where a reader comes to them.

use std::collections::BTreeSet;
use std::io::Write;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use flate2::Compression;
use flate2::write::GzEncoder;
use serde::Serialize;

use crate::explain::Section;
use crate::figure::DrawnUpTo;
use crate::page::filter::FilterFace;
use crate::page::forms::{Forms, distances};
use crate::page::steps::{Grains, StepFace};
use crate::parallel;
use crate::step::{Asked, Change, Level, Quantity, StepLog, StepWords, Value};

/// So many steps are packed together: they are unpacked within some milliseconds, and a neighbour is most often among them.
const TOGETHER: usize = 250;

/// A view of a pixel: a drawing whose groups name the steps that make them.
#[derive(Clone, Debug)]
pub struct View {
    /// What it shows.
    pub title: String,
    /// The drawing.
    pub svg: String,
    /// Up to which step it is drawn after an event.
    pub drawn: DrawnUpTo,
}

/// A pixel with its steps, packed: each part is gzip in base64.
#[derive(Clone, Debug)]
pub struct PackedPixel {
    /// Column and row.
    pub pixel: [u32; 2],
    /// The number of its events.
    pub events: usize,
    /// The head, and then the steps, [`PackedPixel::TOGETHER`] in each part, by forms and numbers.
    pub parts: Vec<String>,
}

/// What a page knows of a pixel before it unpacks any step.
#[derive(Debug, Serialize)]
struct Head<'a> {
    pixel: [u32; 2],
    /// How many steps each part has.
    together: usize,
    /// The number of steps.
    count: usize,
    /// The sections, with the `step` in the log of each of their events.
    sections: Vec<SectionFace>,
    /// The first section and the one behind the last, among the steps.
    tops: [usize; 2],
    /// The leaf of each event: the distance from that of the event before.
    leaves: Vec<isize>,
    /// Of each grain its steps, in the order of the log, each as the distance from the one before.
    walks: Vec<Vec<isize>>,
    /// What each event changed.
    changes: Vec<Vec<ChangeFace>>,
    /// The words by which a reader asks who set a value, each with the names of its quantities in `changes`.
    asked: Vec<(&'static str, Vec<String>)>,
    /// What a filter looks at.
    filter: FilterFace,
    views: Vec<ViewFace<'a>>,
}

#[derive(Debug, Serialize)]
struct SectionFace {
    /// What stands before the step in an address: empty, `#path17:` or `#building:`.
    address: String,
    /// The place of its first event.
    first: usize,
    /// The steps of its events, each as the distance from the one before.
    steps: Vec<isize>,
}

/// A quantity with its new value.
#[derive(Debug, Serialize)]
struct ChangeFace {
    #[serde(skip_serializing_if = "Option::is_none")]
    ray: Option<u32>,
    name: String,
    /// Absent if it has none any more.
    #[serde(skip_serializing_if = "Option::is_none")]
    value: Option<String>,
    /// The rays that are open, where these have changed: what is known of others is forgotten.
    #[serde(skip_serializing_if = "Option::is_none")]
    open: Option<Vec<u32>>,
}

#[derive(Debug, Serialize)]
struct ViewFace<'a> {
    title: &'a str,
    svg: &'a str,
}

impl PackedPixel {
    /// How many steps are packed together.
    pub const TOGETHER: usize = TOGETHER;

    /// Packs the steps of a pixel.
    pub fn new(log: &StepLog, pixel: [u32; 2], views: &[View]) -> Self {
        let moves = log.moves();
        let leaves = (0..log.records.len()).map(|event| log.leaf(event));
        let change = |change: &Change| ChangeFace {
            ray: change.ray,
            name: change.quantity.name(log.scene),
            value: change.new.as_ref().map(|value| value.text(log.scene)),
            open: match &change.new {
                Some(Value::Rays(open)) => Some(open.clone()),
                _ => None,
            },
        };
        let changes = log.changes_by_event();
        let asked = asked_of(log, &changes);
        let changes = changes
            .iter()
            .map(|changes| changes.iter().map(change).collect());
        let sections = log.sections();
        let head = Head {
            pixel,
            together: TOGETHER,
            count: log.steps().len(),
            sections: sections
                .clone()
                .map(|section| section_of(log, section))
                .collect(),
            tops: [sections.start, sections.end],
            leaves: distances(leaves),
            walks: moves
                .walks
                .iter()
                .map(|walk| distances(walk.iter().copied()))
                .collect(),
            changes: changes.collect(),
            asked,
            filter: FilterFace::of(log),
            views: views
                .iter()
                .map(|view| ViewFace {
                    title: &view.title,
                    svg: &view.svg,
                })
                .collect(),
        };
        let drawn: Vec<&DrawnUpTo> = views.iter().map(|view| &view.drawn).collect();
        let grains = Grains::new(log, &moves);
        let count = log.steps().len();
        let mut parts = vec![packed(&head)];
        let words = StepWords::of_all(log);
        parts.extend(parallel::map(count.div_ceil(TOGETHER), |part| {
            let steps = part * TOGETHER..count.min((part + 1) * TOGETHER);
            packed(&Forms::of(steps.map(|step| {
                json(&StepFace::with_moves(log, &words, step, &drawn, &grains))
            })))
        }));
        Self {
            pixel,
            events: log.records.len(),
            parts,
        }
    }

    /// How many bytes it has in a page.
    pub fn size(&self) -> usize {
        self.parts.iter().map(|part| part.len() + 1).sum()
    }
}

fn section_of(log: &StepLog, number: usize) -> SectionFace {
    let step = log.step(number);
    debug_assert_eq!(step.level, Level::Section);
    let records = &log.records[step.events.clone()];
    let address = match records.first().map(Section::of) {
        Some(Section::Path(path)) => format!("#path{path}:"),
        Some(Section::Building) => "#building:".into(),
        Some(Section::Pixel) | None => String::new(),
    };
    SectionFace {
        address,
        first: step.events.start,
        steps: distances(records.iter().map(|record| record.step as usize)),
    }
}

/// The words of which something is known in a log, each with the names of its quantities.
fn asked_of(log: &StepLog, changes: &[Vec<Change>]) -> Vec<(&'static str, Vec<String>)> {
    let known: BTreeSet<Quantity> = changes.iter().flatten().map(|of| of.quantity).collect();
    let asked = Asked::words().filter_map(|word| {
        let asked = Asked::named(word)?;
        let held = known.iter().filter(|quantity| asked.holds(**quantity));
        let names: Vec<String> = held.map(|quantity| quantity.name(log.scene)).collect();
        (!names.is_empty()).then_some((word, names))
    });
    asked.collect()
}

fn json(data: &impl Serialize) -> String {
    // no key of the data is anything but a text
    let json = serde_json::to_string(data);
    debug_assert!(json.is_ok(), "{:?}", json.as_ref().err());
    json.unwrap_or_default()
}

/// Data as JSON, in gzip, in base64.
fn packed(data: &impl Serialize) -> String {
    let mut gzip = GzEncoder::new(Vec::new(), Compression::best());
    let written = gzip.write_all(json(data).as_bytes());
    // writing into memory does not fail
    debug_assert!(written.is_ok(), "{written:?}");
    BASE64.encode(gzip.finish().unwrap_or_default())
}
