//! Tables of counts: what a trace cost.

use std::fmt::Write as _;

use serde_json::{Value, json};

use crate::trace::{Counts, Kind, Purpose};

/// The counts as tables: rays by purpose, tests by kind, what the search cost. What did not occur is left
/// out.
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
    for (purpose, count) in Counts::PURPOSES.into_iter().zip(counts.rays) {
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
    text
}

/// The counts as JSON: `rays` by purpose, `tests` by kind, and what the `search` cost.
pub fn counts_json(counts: &Counts) -> Value {
    let rays: serde_json::Map<String, Value> = Counts::PURPOSES
        .into_iter()
        .zip(counts.rays)
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
    json!({ "rays": rays, "tests": tests, "search": search })
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
