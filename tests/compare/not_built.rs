//! A structure that cannot be built: its strategy says so, and the others are compared.

use std::time::Duration;

use glam::DVec3;
use raystep::explain::{Compared, Comparison, Cost, strategies_to_compare};
use raystep::figure::cost_chart;
use raystep::strategy::Strategy;
use raystep::structure::StructureError;
use raystep::tracer::trace_pixel;
use raystep::{Chosen, Counts, Scene, Settings, Tracer};

use super::{TWO_BALLS, cells, entry};
use crate::trace_log::built;

#[test]
fn a_structure_that_cannot_be_built_is_told_and_the_others_go_on() {
    let mut scene = built(TWO_BALLS);
    // a scene file with these is refused, and a scene can still be given them
    scene.slabs = Some(vec![DVec3::X, 2.0 * DVec3::X, DVec3::Z]);
    let why = "slabs[0] and slabs[1] are parallel; omit one of them";
    let compared = strategies_to_compare(&scene, &Settings::default())
        .into_iter()
        .map(|settings| Compared {
            cost: cost_of_the_first_pixel(&scene, &settings),
            settings,
        })
        .collect();
    let comparison = Comparison {
        scene: &scene,
        pixel: None,
        compared,
    };
    let text = comparison.wide_text();
    assert!(
        text.contains(&format!("own slabs  not built: {why}\n")),
        "{text}"
    );
    // in 80 columns the reason stands below, and the strategy last
    let text = comparison.text();
    let told = "\nhierarchy, bottom-up, own slabs  not built\n\
                hierarchy, bottom-up, own slabs: not built: slabs[0] and slabs[1] are parallel;\n  \
                omit one of them\n";
    assert!(text.contains(told), "{text}");
    let json = comparison.json();
    let own = entry(&json, "hierarchy, bottom-up, own slabs");
    assert_eq!(own["error"], why);
    assert!(own["rays"].is_null());
    assert_eq!(json["strategies"].as_array().unwrap().len(), 14);
    assert_eq!(entry(&json, "heap, bottom-up")["object_tests"], 1);
    let csv = comparison.csv();
    let row = csv
        .lines()
        .map(cells)
        .find(|row| row[0].contains("own"))
        .unwrap();
    assert_eq!(row.last().unwrap(), why);
    assert!(
        row[1..row.len() - 1].iter().all(String::is_empty),
        "{row:?}"
    );
    let chart = cost_chart("chart", &comparison);
    assert!(chart.contains(">not built</text>"), "{chart}");
}

fn cost_of_the_first_pixel(scene: &Scene, settings: &Settings) -> Result<Cost, StructureError> {
    let strategy = Chosen::new(scene, settings.strategy, &settings.structure)?;
    let tracer = Tracer::new(scene, &strategy, settings.transport);
    let mut counts = Counts::default();
    trace_pixel(&tracer, [0, 0], settings.through, &mut counts).unwrap();
    Ok(Cost {
        counts,
        bytes: strategy.bytes(),
        crowded: None,
        building: Duration::ZERO,
        tracing: Duration::ZERO,
    })
}
