//! Tables of counts: what a trace cost.

use std::fmt::Write as _;

use serde_json::{Value, json};

use crate::explain::number::shown;
use crate::trace::{Counts, Kind, LightCount, Purpose, RayCount};

/// The counts as tables: rays by purpose, tests by kind, what the search cost, and where light was followed what
/// became of it. What did not occur is left out.
pub fn counts_text(counts: &Counts) -> String {
    let mut text = String::new();
    // writing to a String cannot fail
    let mut row = |cells: [String; 4]| {
        let [name, a, b, c] = cells;
        // the longest name of a search count has 21 letters: all numbers end in the same columns
        let line = format!("{name:<22}{a:>14}{b:>14}{c:>14}");
        let _ = writeln!(text, "{}", line.trim_end());
    };
    row(["rays", "traced", "hit", "beyond depth"].map(Into::into));
    for (purpose, count) in rays_told(counts) {
        let numbers = [count.traced, count.hits, count.beyond_depth].map(|n| n.to_string());
        let [traced, hits, beyond] = numbers;
        row([purpose_name(purpose).into(), traced, hits, beyond]);
    }
    row([
        "all".into(),
        counts.traced().to_string(),
        String::new(),
        String::new(),
    ]);
    row(["tests", "made", "hit", "missed"].map(Into::into));
    for (kind, count) in Counts::TESTS.into_iter().zip(counts.tests) {
        if 0 < count.tests {
            let [tests, hits, misses] =
                [count.tests, count.hits, count.misses].map(|n| n.to_string());
            row([kind.name().into(), tests, hits, misses]);
        }
    }
    let searched: Vec<_> = counts
        .search
        .named()
        .into_iter()
        .filter(|(_, number)| 0 < *number)
        .collect();
    if !searched.is_empty() {
        row([
            "search".into(),
            "number".into(),
            String::new(),
            String::new(),
        ]);
    }
    for (name, number) in searched {
        row([
            name.into(),
            number.to_string(),
            String::new(),
            String::new(),
        ]);
    }
    if 0 < counts.light.paths {
        light_rows(&counts.light, &mut row);
    }
    text
}

/// What became of the light: how many paths, and where their power went.
fn light_rows(light: &LightCount, row: &mut impl FnMut([String; 4])) {
    row(["light", "number", "", ""].map(Into::into));
    for (name, number) in light.named() {
        let is_way_to_eye = name == "reached the eye" && light.stored == 0;
        let is_fate = FATES.contains(&name) || is_way_to_eye;
        if number == 0 && !is_fate {
            continue;
        }
        row([
            name.into(),
            number.to_string(),
            String::new(),
            String::new(),
        ]);
    }
    if let Some(wasted) = wasted(light) {
        let percent = format!("{} %", shown(100.0 * wasted, 6));
        row([
            "never reached the eye".into(),
            percent,
            String::new(),
            String::new(),
        ]);
    }
    row(["power in watts", "red", "green", "blue"].map(Into::into));
    for (name, power) in light.ledger() {
        let [red, green, blue] = power.to_array().map(|watts| shown(watts, 9));
        row([name.into(), red, green, blue]);
    }
}

/// The counts of paths that are shown even if they are 0.
const FATES: [&str; 5] = [
    "paths emitted",
    "hit something",
    "left the scene",
    "absorbed",
    "cut off",
];

/// The share of the paths that never reached the eye; `None` where light is stored, which reaches it by the rays of
/// the pixels.
fn wasted(light: &LightCount) -> Option<f64> {
    light.wasted().filter(|_| light.stored == 0)
}

/// The rays of each purpose; those of random paths are omitted where there were none.
fn rays_told(counts: &Counts) -> impl Iterator<Item = (Purpose, RayCount)> {
    let all = Counts::PURPOSES.into_iter().zip(counts.rays);
    all.filter(|(purpose, count)| {
        let of_chance = matches!(
            purpose,
            Purpose::Scattered | Purpose::Light | Purpose::Connection
        );
        !of_chance || *count != RayCount::default()
    })
}

/// The counts as JSON: `rays` by purpose, `tests` by kind, what the `search` cost, and where light was followed what
/// became of the `light`.
pub fn counts_json(counts: &Counts) -> Value {
    let rays: serde_json::Map<String, Value> = rays_told(counts)
        .map(|(purpose, count)| {
            let value = json!({
                "traced": count.traced,
                "hits": count.hits,
                "beyond_depth": count.beyond_depth,
            });
            (purpose_name(purpose).into(), value)
        })
        .collect();
    let tests: serde_json::Map<String, Value> = Counts::TESTS
        .into_iter()
        .zip(counts.tests)
        .map(|(kind, count)| {
            let value = json!({
                "tests": count.tests,
                "hits": count.hits,
                "misses": count.misses,
            });
            (kind.name().into(), value)
        })
        .collect();
    let search: serde_json::Map<String, Value> = counts
        .search
        .named()
        .into_iter()
        .map(|(name, number)| (name.replace(' ', "_"), number.into()))
        .collect();
    let mut report = json!({ "rays": rays, "tests": tests, "search": search });
    if 0 < counts.light.paths {
        report["light"] = light_json(&counts.light);
    }
    report
}

/// The numbers by their names, the powers in watts for each channel, and the share of paths that never reached
/// the eye.
fn light_json(light: &LightCount) -> Value {
    let key = |name: &str| name.replace(' ', "_");
    let mut object: serde_json::Map<String, Value> = light
        .named()
        .into_iter()
        .map(|(name, number)| (key(name), number.into()))
        .collect();
    let power: serde_json::Map<String, Value> = light
        .ledger()
        .into_iter()
        .map(|(name, power)| (key(name), json!(power.to_array())))
        .collect();
    object.insert("power".into(), power.into());
    if let Some(wasted) = wasted(light) {
        object.insert("wasted".into(), wasted.into());
    }
    Value::Object(object)
}

/// How many tests of one kind were made.
pub(super) fn tests_of(counts: &Counts, wanted: Kind) -> u64 {
    let tests = Counts::TESTS.into_iter().zip(counts.tests);
    tests
        .filter(|(kind, _)| *kind == wanted)
        .map(|(_, count)| count.tests)
        .sum()
}

fn purpose_name(purpose: Purpose) -> &'static str {
    match purpose {
        Purpose::Eye => "eye",
        Purpose::Shadow => "shadow",
        Purpose::Reflected => "reflected",
        Purpose::Refracted => "refracted",
        Purpose::Scattered => "scattered",
        Purpose::Light => "light",
        Purpose::Connection => "connection",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Ray;
    use crate::trace::{
        Arrival, Event, PathStart, Photon, PhotonVerdict, RayEnd, RayStart, RayVerdict, Recorder,
    };
    use glam::DVec3;

    /// Two photons of 2 W. The first loses its blue at a surface, comes to the eye and leaves the scene; the second is
    /// absorbed.
    fn two_photons() -> Counts {
        let leg = RayStart {
            ray: Ray::new(DVec3::ZERO, DVec3::X),
            purpose: Purpose::Light,
            ..RayStart::default()
        };
        let start = |path| {
            Event::Path(PathStart {
                path,
                paths: 2,
                power: DVec3::splat(2.0),
                ..PathStart::default()
            })
        };
        let photon = |chance, verdict| {
            Event::Photon(Photon {
                power: DVec3::splat(2.0),
                chance,
                diffuse: DVec3::new(0.5, 0.5, 0.25),
                verdict,
                ..Photon::default()
            })
        };
        let end = |verdict| {
            Event::RayEnd(RayEnd {
                verdict,
                ..RayEnd::default()
            })
        };
        let mut counts = Counts::default();
        for event in [
            start(0),
            Event::Ray(leg),
            photon(0.375, PhotonVerdict::Diffused),
            end(RayVerdict::Hit),
            Event::Ray(leg),
            Event::Arrival(Arrival::default()),
            end(RayVerdict::Miss),
            start(1),
            Event::Ray(leg),
            photon(0.75, PhotonVerdict::Absorbed),
            end(RayVerdict::Absorbed),
        ] {
            counts.note(|| event);
        }
        counts
    }

    #[test]
    fn the_table_of_light_tells_where_each_watt_went() {
        let text = counts_text(&two_photons());
        let rows: Vec<Vec<&str>> = text
            .lines()
            .skip_while(|line| !line.starts_with("light  "))
            .filter(|line| !line.starts_with("light  "))
            .map(|line| {
                let (name, numbers) = line.split_at(22);
                std::iter::once(name.trim())
                    .chain(numbers.split_whitespace())
                    .collect()
            })
            .collect();
        for row in [
            vec!["paths emitted", "2"],
            vec!["hit something", "2"],
            vec!["left the scene", "1"],
            vec!["absorbed", "1"],
            vec!["reached the eye", "1"],
            vec!["never reached the eye", "50", "%"],
            vec!["emitted", "4", "4", "4"],
            vec!["absorbed", "2", "2", "4"],
            vec!["left the scene", "2", "2", "0"],
            vec!["cut off", "0", "0", "0"],
        ] {
            assert!(rows.contains(&row), "{row:?} in\n{text}");
        }
    }

    #[test]
    fn light_is_in_the_json_only_where_it_was_followed() {
        let json = counts_json(&two_photons());
        assert_eq!(json["light"]["wasted"], 0.5);
        assert_eq!(json["light"]["power"]["absorbed"], json!([2.0, 2.0, 4.0]));
        assert_eq!(json["light"]["paths_emitted"], 2);
        assert_eq!(json["rays"]["light"]["traced"], 3);
        let without = counts_json(&Counts::default());
        assert!(without.get("light").is_none());
        assert!(without["rays"].get("scattered").is_none());
        assert!(!counts_text(&Counts::default()).contains("connection"));
    }
}
