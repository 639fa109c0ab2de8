//! The printed tables: a race in rounds, and how time and tests grow with the number of objects.

use std::hint::black_box;
use std::time::Instant;

use raystep::geometry::Ray;

use crate::contenders::{Contender, Found};

/// Contenders that test every object get a part of the rays: so many objects times rays at most.
const PATIENCE: usize = 1 << 24;

/// What a contender needs for a ray.
#[derive(Clone, Copy)]
pub(crate) struct Cost {
    /// The median of the rounds.
    pub(crate) nanoseconds: f64,
    /// The tests of objects.
    pub(crate) tests: f64,
}

/// One line of the growth table: a contender's cost among so many objects.
pub(crate) struct Grown {
    pub(crate) scene: String,
    pub(crate) name: &'static str,
    pub(crate) cost: Cost,
}

/// Lets all take turns for some rounds, prints the medians, and gives each one's cost.
///
/// A machine's speed drifts, and others use it: in turns all meet the same, and a ratio is taken within each
/// round, before its median. All must hit with the same number of rays.
pub(crate) fn race(
    kind: &str,
    rays: &[Ray],
    contenders: &[Contender<'_>],
    objects: usize,
    rounds: usize,
) -> Vec<Cost> {
    let part = |contender: &Contender<'_>| {
        if contender.is_linear() {
            (PATIENCE / objects).clamp(1, rays.len())
        } else {
            rays.len()
        }
    };
    let mut times = vec![Vec::new(); contenders.len()];
    let mut found = vec![Found::default(); contenders.len()];
    for _ in 0..rounds {
        for (at, contender) in contenders.iter().enumerate() {
            let rays = &rays[..part(contender)];
            let started = Instant::now();
            found[at] = (contender.nearest)(black_box(rays));
            let seconds = started.elapsed().as_secs_f64();
            times[at].push(seconds * 1e9 / rays.len() as f64);
        }
    }
    println!("  {kind}: {} rays, {} hit", rays.len(), found[0].hits);
    let all = contenders.iter().enumerate();
    all.map(|(at, contender)| {
        let rays = &rays[..part(contender)];
        let expected = (contenders[0].nearest)(rays).hits;
        assert_eq!(
            found[at].hits, expected,
            "{} and {} hit differently among {objects} objects",
            contender.name, contenders[0].name
        );
        let ratios = times[at].iter().zip(&times[0]);
        let cost = Cost {
            nanoseconds: median(times[at].clone()),
            tests: (contender.tests)(rays) as f64 / rays.len() as f64,
        };
        println!(
            "    {:<16} {:>10.1} ns a ray, {:>7.2} times the hierarchy's, {:>9.2} tests a ray",
            contender.name,
            cost.nanoseconds,
            median(ratios.map(|(time, ours)| time / ours).collect()),
            cost.tests,
        );
        cost
    })
    .collect()
}

/// How long each took to build, in the median of some times.
pub(crate) fn builds(contenders: &[Contender<'_>]) {
    println!("  built in");
    for contender in contenders {
        println!(
            "    {:<16} {:>10.2} ms",
            contender.name,
            contender.build * 1e3
        );
    }
}

/// Time and tests a ray by number of objects, for everyone who raced.
pub(crate) fn growth(lines: &[Grown], sizes: &[usize]) {
    println!("\nGrowth: nanoseconds and tests a ray among so many objects");
    print!("  {:<46}", "");
    for size in sizes {
        print!(" {size:>20}");
    }
    println!();
    let mut told: Vec<(&str, &str)> = Vec::new();
    for Grown { scene, name, .. } in lines {
        if told.contains(&(scene, name)) {
            continue;
        }
        told.push((scene, name));
        print!("  {:<46}", format!("{scene}, {}", name.trim_start()));
        let of_this = lines
            .iter()
            .filter(|of| of.scene == *scene && of.name == *name);
        for Grown { cost, .. } in of_this {
            print!(" {:>10.1} {:>9.2}", cost.nanoseconds, cost.tests);
        }
        println!();
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
