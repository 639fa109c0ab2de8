//! What is constant for all rays, or for one ray, is computed once in advance: how much that saves.
//!
//! Slides, on the polygon and on Fig. 15.58: A, B, C and D of a plane do not change from ray to ray, nor
//! does the outline without its dropped coordinate; of a slab test (S + D)·T (erratum 2), S and T belong to
//! the ray and a direction, and only D to the bound.

use std::fmt::Write as _;

use serde_json::{Value, json};

use crate::explain::counts::tests_of;
use crate::explain::number::grouped;
use crate::scene::{Scene, Shape};
use crate::structure::{SlabChoice, VolumeKind};
use crate::trace::{Counts, Kind, Settings, StrategyName};

/// Something that was computed in advance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InAdvance {
    /// What was computed in advance, in plural words: `plane equations`.
    pub what: &'static str,
    /// Its key in JSON.
    pub key: &'static str,
    /// How often it was computed.
    pub computed: u64,
    /// How often it was used: as often it would have been computed otherwise.
    pub used: u64,
}

impl InAdvance {
    /// How many computations were saved; 0 if fewer were needed than were made.
    pub fn saved(&self) -> u64 {
        self.used.saturating_sub(self.computed)
    }
}

/// What was computed in advance for a trace, and how often each was used.
///
/// Plane equations (iv) and projected outlines: once for each polygon of the scene, used by each test of a
/// plane and of an outline. S and T: once for each ray and direction, used by each test of a slab. What
/// the scene or the strategy does not have is left out; z-aligned rays project each outline anew.
pub fn in_advance(scene: &Scene, settings: &Settings, counts: &Counts) -> Vec<InAdvance> {
    let mut list = Vec::new();
    let is_polygon = |shape: &Shape| matches!(shape, Shape::Polygon(_));
    let primitives = scene.primitives.iter();
    let polygons = primitives.filter(|p| is_polygon(&p.shape)).count() as u64;
    if 0 < polygons {
        list.push(InAdvance {
            what: "plane equations",
            key: "plane_equations",
            computed: polygons,
            used: tests_of(counts, Kind::PlaneTest),
        });
        if settings.strategy != StrategyName::ZAligned {
            list.push(InAdvance {
                what: "projected outlines",
                key: "projected_outlines",
                computed: polygons,
                used: tests_of(counts, Kind::PolygonTest),
            });
        }
    }
    let directions = directions(scene, settings);
    if 0 < directions {
        list.push(InAdvance {
            what: "S and T of slabs",
            key: "s_and_t",
            computed: counts.traced() * directions,
            used: counts.search.slabs,
        });
    }
    list
}

/// How many directions of slabs does each ray hit? 0 if its strategy tests none.
fn directions(scene: &Scene, settings: &Settings) -> u64 {
    let structure = &settings.structure;
    let has_slabs = match settings.strategy {
        StrategyName::Hierarchy | StrategyName::Heap => true,
        StrategyName::Bounds => structure.volume == VolumeKind::Slabs,
        StrategyName::Exhaustive | StrategyName::Grid | StrategyName::ZAligned => false,
    };
    match structure.slabs {
        _ if !has_slabs => 0,
        SlabChoice::Axes => 3,
        SlabChoice::Seven => 7,
        SlabChoice::Scene => scene.slabs.as_ref().map_or(0, Vec::len) as u64,
    }
}

/// One line for each that was used: `plane equations: computed 21 times instead of 403 200: 403 179 saved`.
pub fn in_advance_text(list: &[InAdvance]) -> String {
    let mut text = String::new();
    for item in list.iter().filter(|item| 0 < item.used) {
        let computed = times(item.computed);
        let line = match item.saved() {
            0 => format!("computed {computed}, used {}", times(item.used)),
            saved => format!(
                "computed {computed} instead of {}: {} saved",
                grouped(item.used),
                grouped(saved)
            ),
        };
        // writing to a String cannot fail
        let _ = writeln!(text, "{}: {line}", item.what);
    }
    text
}

/// `computed`, `used` and `saved` of each.
pub fn in_advance_json(list: &[InAdvance]) -> Value {
    let entries = list.iter().map(|item| {
        let value = json!({
            "computed": item.computed,
            "used": item.used,
            "saved": item.saved(),
        });
        (item.key.into(), value)
    });
    Value::Object(entries.collect())
}

fn times(count: u64) -> String {
    match count {
        1 => "once".into(),
        _ => format!("{} times", grouped(count)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_saving_is_told_with_its_numbers() {
        let item = |computed, used| InAdvance {
            what: "plane equations",
            key: "plane_equations",
            computed,
            used,
        };
        assert_eq!(
            in_advance_text(&[item(21, 403_200), item(1, 1), item(3, 0), item(3, 2)]),
            "plane equations: computed 21 times instead of 403 200: 403 179 saved\n\
             plane equations: computed once, used once\n\
             plane equations: computed 3 times, used 2 times\n"
        );
    }
}
