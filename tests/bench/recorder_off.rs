//! The claim: a recorder that is off costs nothing.
//!
//! Two functions find the nearest hit of the same rays in the same scene. One is the crate's, with
//! [`Off`]; the other is written out here and knows of no recorder. They call the same tests of the same
//! shapes, so every instruction that the first needs more is the recorder's. Times on a busy machine
//! cannot show half a per cent; counted instructions can:
//!
//! ```text
//! cargo bench -p bench --bench recorder_off                      # both: times, and that the hits are the same
//! cargo bench -p bench --bench recorder_off --no-run             # prints the program's path: $BENCH below
//! valgrind --tool=callgrind --callgrind-out-file=/dev/null \
//!     --toggle-collect='*nearest_of_crate*' $BENCH --crate
//! valgrind --tool=callgrind --callgrind-out-file=/dev/null \
//!     --toggle-collect='*nearest_by_hand*' $BENCH --plain
//! ```
//!
//! Each prints `Collected : N` with the instructions executed inside that function. The crate's N may
//! exceed the other by half a per cent. Measured with rustc 1.95.0 on x86-64: 215 597 272 by the crate,
//! 216 846 002 by hand, a ratio of 0.9942. `Polygon::contains` takes the same instructions in both; the
//! rest is how the compiler lays out the loop around it.

use std::hint::black_box;
use std::path::Path;
use std::time::{Duration, Instant};

use raystep::geometry::{Ray, TRange};
use raystep::scene::{Loaded, Primitive, PrimitiveId, Shape};
use raystep::strategy::{Exhaustive, Hit, Strategy};
use raystep::{Off, Scene, load};

/// Eye rays in each direction.
const SIDE: u32 = 64;

/// The crate's search.
#[inline(never)]
fn nearest_of_crate(strategy: Exhaustive<'_>, ray: &Ray) -> Option<Hit> {
    strategy.nearest(ray, TRange::FORWARD, &mut Off)
}

/// One ray against one object, by hand.
#[inline]
fn tested_by_hand(primitive: &Primitive, ray: &Ray, range: TRange) -> Option<f64> {
    let sides = primitive.sides;
    match &primitive.shape {
        Shape::Sphere(sphere) => sphere.test(ray, range, sides).roots.chosen(),
        Shape::Ellipsoid(ellipsoid) => ellipsoid.test(ray, range, sides).roots.chosen(),
        Shape::Box(solid) => solid.test(ray, range, sides).roots.chosen(),
        Shape::Cone(cone) => cone.test(ray, range, sides).roots.chosen(),
        Shape::Polygon(polygon) => {
            let t = polygon.plane_test(ray, range, sides).chosen()?;
            polygon.contains(ray, t).inside.then_some(t)
        }
    }
}

/// The same search, by hand.
#[inline(never)]
fn nearest_by_hand(scene: &Scene, ray: &Ray) -> Option<Hit> {
    let mut range = TRange::FORWARD;
    let mut nearest: Option<Hit> = None;
    for (object, primitive) in (0..).map(PrimitiveId).zip(&scene.primitives) {
        if let Some(t) = tested_by_hand(primitive, ray, range) {
            let nearer = |known: Hit| t < known.t || (t == known.t && object < known.object);
            if nearest.is_none_or(nearer) {
                nearest = Some(Hit { object, t });
                range = range.up_to(t);
            }
        }
    }
    nearest
}

fn eye_rays(scene: &Scene) -> Vec<Ray> {
    let places = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| [x, y]));
    places
        .map(|[x, y]| {
            scene
                .camera
                .eye_ray(f64::from(x) + 0.5, f64::from(y) + 0.5)
                .0
        })
        .collect()
}

/// All hits, and how long they took.
fn timed(rays: &[Ray], nearest: impl Fn(&Ray) -> Option<Hit>) -> (Vec<Option<Hit>>, Duration) {
    let start = Instant::now();
    let hits = rays.iter().map(|ray| nearest(black_box(ray))).collect();
    (hits, start.elapsed())
}

fn main() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../data/nff/teapot-2.nff");
    let mut loaded = load(&path).expect("the scene is part of the project");
    loaded.scene.camera.pixels = [SIDE, SIDE];
    let scene = Loaded::build(loaded).expect("the scene is part of the project");
    let strategy = Exhaustive::new(&scene);
    let rays = eye_rays(&scene);
    let of_crate = || timed(&rays, |ray| nearest_of_crate(strategy, ray));
    let by_hand = || timed(&rays, |ray| nearest_by_hand(&scene, ray));

    // cargo adds an argument of its own
    let mut choice = std::env::args().skip(1).filter(|word| word != "--bench");
    match choice.next().as_deref() {
        Some("--crate") => drop(black_box(of_crate())),
        Some("--plain") => drop(black_box(by_hand())),
        None | Some("--both") => compare(&of_crate, &by_hand),
        Some(other) => {
            eprintln!("{other:?} is not known: give --crate, --plain or --both");
            std::process::exit(2);
        }
    }
}

/// The shortest time of each, in turns, and that both hit the same.
fn compare(
    of_crate: &impl Fn() -> (Vec<Option<Hit>>, Duration),
    by_hand: &impl Fn() -> (Vec<Option<Hit>>, Duration),
) {
    let mut shortest = [Duration::MAX; 2];
    for _ in 0..20 {
        let ((hits, crate_time), (expected, hand_time)) = (of_crate(), by_hand());
        assert_eq!(hits, expected, "the crate and the search by hand differ");
        shortest = [shortest[0].min(crate_time), shortest[1].min(hand_time)];
    }
    let [crate_time, hand_time] = shortest;
    println!(
        "{} rays, the same hits: crate {crate_time:?}, by hand {hand_time:?}",
        SIDE * SIDE
    );
}
