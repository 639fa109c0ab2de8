//! raystep's strategies against the crates `bvh` and `parry3d-f64`.
//!
//! Over uniform spheres and triangle meshes of 100, 10 000 and 1 000 000 objects each contender finds the nearest
//! hits of 1024 × 1024 coherent rays (an eye's) and of 10⁶ incoherent ones (from anywhere, in any direction),
//! with the recorder off and on one thread. All must find the same number of hits. First come tables: times and
//! tests of objects a ray, how long each took to build, and how all that grows. Then criterion measures the
//! same and leaves its reports in `target/criterion`.
//!
//! ```text
//! cargo bench -p bench --bench peers                        # all of it: half an hour
//! cargo bench -p bench --bench peers -- --table             # the tables alone
//! cargo bench -p bench --bench peers -- --table --quick     # with fewer rays and up to 10 000 objects
//! ```

#[path = "peers/contenders.rs"]
mod contenders;
#[path = "peers/scenes.rs"]
mod scenes;
#[path = "peers/tables.rs"]
mod tables;

use criterion::{Criterion, SamplingMode, Throughput};
use raystep::geometry::Ray;

use crate::contenders::{Contender, contenders};
use crate::scenes::{Objects, coherent, incoherent, mesh, scene, spheres};
use crate::tables::{Grown, builds, growth, race};

/// How much is measured.
struct Amount {
    sizes: &'static [usize],
    /// A side of the coherent rays' square.
    side: usize,
    incoherent: usize,
    rounds: usize,
}

const FULL: Amount = Amount {
    sizes: &[100, 10_000, 1_000_000],
    side: 1024,
    incoherent: 1_000_000,
    rounds: 5,
};

const QUICK: Amount = Amount {
    sizes: &[100, 10_000],
    side: 200,
    incoherent: 40_000,
    rounds: 5,
};

fn main() {
    let mut table_alone = false;
    let mut amount = FULL;
    // cargo adds an argument of its own
    for word in std::env::args().skip(1).filter(|word| word != "--bench") {
        match word.as_str() {
            "--table" => table_alone = true,
            "--quick" => amount = QUICK,
            other => {
                eprintln!("{other:?} is not known: give --table, --quick, both or none");
                std::process::exit(2);
            }
        }
    }
    tables(&amount);
    if !table_alone {
        reports(&amount);
    }
}

/// Calls `work` with the name of each scene, its contenders and how many objects there are.
fn for_each_scene(amount: &Amount, mut work: impl FnMut(&str, usize, &[Contender<'_>])) {
    let kinds = [
        ("spheres", spheres as fn(usize) -> Objects),
        ("triangles", mesh),
    ];
    for (name, make) in kinds {
        for &size in amount.sizes {
            let objects = make(size);
            let scene = scene(&objects);
            work(name, scene.primitives.len(), &contenders(&objects, &scene));
        }
    }
}

fn both_kinds(amount: &Amount) -> [(&'static str, Vec<Ray>); 2] {
    [
        ("coherent", coherent(amount.side)),
        ("incoherent", incoherent(amount.incoherent)),
    ]
}

fn tables(amount: &Amount) {
    let rays = both_kinds(amount);
    let mut lines = Vec::new();
    for_each_scene(amount, |name, size, contenders| {
        println!("\n{size} {name}");
        builds(contenders);
        for (kind, rays) in &rays {
            let costs = race(kind, rays, contenders, size, amount.rounds);
            lines.extend(contenders.iter().zip(costs).map(|(contender, cost)| Grown {
                scene: format!("{name}, {kind}"),
                name: contender.name,
                cost,
            }));
        }
    });
    growth(&lines, amount.sizes);
}

/// Criterion's reports, for all who do not test every object.
fn reports(amount: &Amount) {
    let rays = both_kinds(amount);
    let mut criterion = Criterion::default().sample_size(10);
    for_each_scene(amount, |name, size, contenders| {
        for (kind, rays) in &rays {
            let mut group = criterion.benchmark_group(format!("{size} {name}, {kind}"));
            group.throughput(Throughput::Elements(rays.len() as u64));
            group.sampling_mode(SamplingMode::Flat);
            let swift = contenders.iter().filter(|of| !of.is_linear());
            for contender in swift {
                group.bench_function(contender.name.trim_start(), |bencher| {
                    bencher.iter(|| (contender.nearest)(rays));
                });
            }
            group.finish();
        }
    });
}
