//! S, T and the room of a ray and a slab: once in a log, before the tests of that slab.

use std::collections::BTreeMap;

use raystep::geometry::SlabInterval;
use raystep::structure::{SlabChoice, VolumeKind};
use raystep::trace::{Kind, RaySlab};
use raystep::{Event, Settings, StrategyName, StructureOptions};
use serde_json::{Value, json};

use super::{all_of, built, log, pixels_of, records, strategies, verdicts};
use crate::cli::run::Folder;

/// The ray of [`verdicts::SCENE`] runs from 0 along (0.6, 0, −0.8): S = 0, T = −1/0.6 and 1/0.8, and none across y.
#[test]
fn each_slab_has_its_s_and_t_and_no_t_if_the_ray_is_parallel() {
    let structure = StructureOptions {
        volume: VolumeKind::Slabs,
        ..StructureOptions::default()
    };
    let settings = Settings {
        strategy: StrategyName::Bounds,
        structure,
        ..Settings::default()
    };
    let scene = built(verdicts::SCENE);
    let log = log(&scene, &settings, &all_of("0,0".parse().unwrap()));
    let lines = std::str::from_utf8(&log).unwrap().lines();
    let lines = lines.map(|line| serde_json::from_str::<Value>(line).unwrap());
    let of_eye_ray = |line: &Value| line["kind"] == "slab_ray" && line["ray"] == 0;
    let found: Vec<Value> = lines.filter(of_eye_ray).collect();
    let t = found.iter().map(|line| line["t_scale"].as_f64());
    // 1/0.6 and 1/0.8
    let expected = [Some(-1.666_666_666_667), None, Some(1.25)];
    for ((t, expected), line) in t.zip(expected).zip(&found) {
        let is_near = |(t, expected): (f64, f64)| (t - expected).abs() <= 1e-9;
        assert!(t.zip(expected).is_none_or(is_near), "{line}");
        assert_eq!(t.is_some(), expected.is_some(), "{line}");
        assert_eq!(line["s"], 0.0, "{line}");
        // the same for all slabs of the ray, and in its bounds
        assert_eq!(line["room"], found[0]["room"], "{line}");
    }
    let normals: Vec<&Value> = found.iter().map(|line| &line["normal"]).collect();
    let axes = [
        json!([1.0, 0.0, 0.0]),
        json!([0.0, 1.0, 0.0]),
        json!([0.0, 0.0, 1.0]),
    ];
    assert_eq!(normals, axes.iter().collect::<Vec<_>>());
}

#[test]
fn near_and_far_of_each_slab_follow_from_its_s_t_and_room_which_each_ray_has_once() {
    let mut tests = 0;
    for (scene, settings, region) in strategies::cases() {
        let own = scene.slabs.as_ref().map_or(0, Vec::len);
        let directions = match (settings.strategy, settings.structure.slabs) {
            (StrategyName::Bounds, _) if settings.structure.volume != VolumeKind::Slabs => 0,
            (StrategyName::Exhaustive | StrategyName::Grid | StrategyName::ZAligned, _) => 0,
            (_, SlabChoice::Axes) => 3,
            (_, SlabChoice::Seven) => 7,
            (_, SlabChoice::Scene) => own,
        };
        for pixel in pixels_of(region) {
            let mut of_ray: BTreeMap<Option<u32>, Vec<RaySlab>> = BTreeMap::new();
            let records = records(&scene, &settings, pixel);
            for record in &records {
                match record.event {
                    Event::SlabRay(line) => of_ray.entry(record.ray).or_default().push(line),
                    Event::SlabTest(test) => {
                        tests += 1;
                        let line = of_ray[&record.ray][test.step.slab as usize];
                        check_interval(
                            &line,
                            [test.step.d_min, test.step.d_max],
                            test.step.interval,
                        );
                    }
                    _ => {}
                }
            }
            let rays = records
                .iter()
                .filter(|record| record.event.kind() == Kind::Ray);
            let traced = rays.filter(|ray| {
                let mut ends = records.iter().filter(|record| record.ray == ray.ray);
                !ends.any(|record| matches!(record.event, Event::RayEnd(end) if end.verdict == raystep::trace::RayVerdict::DepthLimit))
            });
            let counts: Vec<usize> = of_ray.values().map(Vec::len).collect();
            let expected = if directions == 0 { 0 } else { traced.count() };
            assert_eq!(
                counts,
                vec![directions; expected],
                "{} {settings:?}",
                scene.name
            );
        }
    }
    assert!(500 < tests, "{tests}");
}

#[track_caller]
fn check_interval(line: &RaySlab, planes: [f64; 2], interval: SlabInterval) {
    let SlabInterval::Between { near, far } = interval else {
        assert_eq!(line.t_scale, f64::INFINITY, "{line:?}");
        return;
    };
    // 2·10⁻¹⁰ of the coordinates and more; no scene here reaches further than some 100
    assert!(0.0 < line.room && line.room < 1e-7, "{line:?}");
    let [d_min, d_max] = planes;
    let at_min = (line.s - line.room + d_min) * line.t_scale;
    let at_max = (line.s + line.room + d_max) * line.t_scale;
    assert_eq!(
        [near, far],
        [at_min.min(at_max), at_min.max(at_max)],
        "{line:?}"
    );
}

#[test]
fn a_log_of_slab_tests_alone_has_their_slab_rays_too_and_its_text_has_s_and_t() {
    let folder = Folder::with_scene();
    let options = "--strategy hierarchy --region 80,60";
    let only = format!("trace scene.json {options} --only slab_test -o only.jsonl");
    folder.run(&only).well();
    folder
        .run(&format!("trace scene.json {options} -o all.jsonl"))
        .well();
    let text = std::fs::read_to_string(folder.path("only.jsonl")).unwrap();
    let head: Value = serde_json::from_str(text.lines().next().unwrap()).unwrap();
    assert_eq!(head["settings"]["only"], json!(["slab_ray", "slab_test"]));
    let count = |kind: &str| {
        let start = format!("{{\"kind\":\"{kind}\"");
        text.lines().filter(|line| line.starts_with(&start)).count()
    };
    assert!(0 < count("slab_ray") && 0 < count("slab_test"));
    assert_eq!(count("bound_test"), 0);
    let told = |log: &str| {
        let told = folder
            .run(&format!("pixel {log} 80,60 --only slab_test --all"))
            .well();
        String::from_utf8(told).unwrap()
    };
    // where the ray starts is in the whole log alone
    assert!(told("only.jsonl").contains(": S = "));
    assert!(told("only.jsonl").contains(", T = "));
    assert!(told("all.jsonl").contains(", T = −1/["));
}
