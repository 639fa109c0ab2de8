//! Reading a scene file: raystep against the crate `tobj`, and NFF beside OBJ.
//!
//! A mesh of a million triangles is written as OBJ, in memory, with all digits of each number. In each round raystep and
//! `tobj` read it, one after the other; a ratio is taken within its round, and the medians are printed. A machine's
//! speed drifts: in turns both meet the same. On Linux the time on the processor is taken. Both must find the same number of vertices and faces.
//!
//! `tobj` reads numbers and indices, as f64 here. raystep also checks what a scene needs (each number is finite and no
//! larger than a scene allows, each index exists, each face has a plane and an area), keeps the line of each mistake,
//! and copies the vertices of each face. Apart from that: `build`, which makes polygons of the faces, and a million
//! spheres in NFF, which shares the reader of numbers.
//!
//! ```text
//! cargo bench -p bench --bench loading               # a million triangles, 11 rounds
//! cargo bench -p bench --bench loading -- --quick    # ten thousand
//! ```
//!
//! The goal is a ratio of at most 1.1.

#[path = "peers/scenes.rs"]
#[allow(dead_code, reason = "the rays of the other bench are not needed here")]
mod scenes;

use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use raystep::scene::Loaded;
use raystep::{NoFiles, load_bytes};

use crate::scenes::{mesh, spheres, text_of};

fn main() {
    let (mut count, mut rounds) = (1_000_000, 11);
    // cargo adds an argument of its own
    for word in std::env::args().skip(1).filter(|word| word != "--bench") {
        match word.as_str() {
            "--quick" => (count, rounds) = (10_000, 5),
            other => {
                eprintln!("{other:?} is not known: give --quick or nothing");
                std::process::exit(2);
            }
        }
    }
    obj(count, rounds);
    nff(count, rounds);
}

/// How long the work takes, in milliseconds.
fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let wall = Instant::now();
    let started = on_processor();
    let done = black_box(work());
    let milliseconds = match (started, on_processor()) {
        (Some(started), Some(ended)) => (ended - started) / 1e6,
        _ => wall.elapsed().as_secs_f64() * 1e3,
    };
    (milliseconds, done)
}

/// How long this thread has been on a processor, in nanoseconds: the time of others does not count. Linux alone says so.
fn on_processor() -> Option<f64> {
    let numbers = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    numbers.split_whitespace().next()?.parse().ok()
}

fn read(name: &str, text: &str) -> Loaded {
    load_bytes(name, black_box(text.as_bytes()), &NoFiles).expect("a valid file")
}

/// The faces and the vertices that `tobj` finds.
fn read_by_tobj(text: &str) -> (usize, usize) {
    let mut bytes = black_box(text.as_bytes());
    let no_materials = |_: &Path| Ok(Default::default());
    let options = tobj::LoadOptions::default();
    let (models, _) = tobj::load_obj_buf(&mut bytes, &options, no_materials).expect("a valid file");
    // kept to the end, as the scene is
    let models = black_box(models);
    let faces = models.iter().map(|model| model.mesh.indices.len() / 3);
    let vertices = models.iter().map(|model| model.mesh.positions.len() / 3);
    (faces.sum(), vertices.sum())
}

fn obj(count: usize, rounds: usize) {
    let (name, text) = text_of(&mesh(count));
    let vertices = text.lines().filter(|line| line.starts_with("v ")).count();
    let (mut ours, mut theirs, mut ratios, mut builds) = (vec![], vec![], vec![], vec![]);
    let mut faces = 0;
    for _ in 0..rounds {
        let (our_time, loaded) = timed(|| read(name, &text));
        let (their_time, found) = timed(|| read_by_tobj(&text));
        let (build, scene) = timed(|| loaded.build().expect("a valid scene"));
        faces = scene.primitives.len();
        assert_eq!((faces, vertices), found, "both read the same mesh");
        ours.push(our_time);
        theirs.push(their_time);
        ratios.push(our_time / their_time);
        builds.push(build);
    }
    let megabytes = text.len() as f64 / 1e6;
    println!(
        "OBJ: {faces} triangles, {vertices} vertices, {megabytes:.0} MB, medians of {rounds} rounds"
    );
    println!("  raystep {:>8.1} ms", median(ours));
    println!("  tobj    {:>8.1} ms", median(theirs));
    println!("  ratio   {:>8.3}", median(ratios));
    println!("  build   {:>8.1} ms, raystep's polygons", median(builds));
}

fn nff(count: usize, rounds: usize) {
    let (name, text) = text_of(&spheres(count));
    let (mut reads, mut builds) = (vec![], vec![]);
    for _ in 0..rounds {
        let (time, loaded) = timed(|| read(name, &text));
        reads.push(time);
        let (time, scene) = timed(|| loaded.build().expect("a valid scene"));
        builds.push(time);
        assert_eq!(scene.primitives.len(), count, "each sphere is read");
    }
    let megabytes = text.len() as f64 / 1e6;
    println!("NFF: {count} spheres, {megabytes:.0} MB, medians of {rounds} rounds");
    println!("  raystep {:>8.1} ms", median(reads));
    println!("  build   {:>8.1} ms", median(builds));
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
