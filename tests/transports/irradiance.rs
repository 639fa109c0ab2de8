//! A point light over a plane: photons that are counted, photons that are gathered, and the closed form
//! E = Φ·cos θ / (4π·r²).

use std::f64::consts::PI;

use glam::{DVec2, DVec3};
use raystep::strategy::Exhaustive;
use raystep::trace::{Gathered, LightOptions};
use raystep::tracer::{LightPass, trace_pixel};
use raystep::{Event, Off, Recorder, Scene, Settings, Through, Tracer, Transport};

use super::{DEVIATIONS, Estimate, built, light_pass, settings};

/// Φ, in watts.
const POWER: f64 = 100.0;

/// The lamp stands at (0, 1, 0) over a floor in y = 0. The window lies in the floor, so that each pixel is a
/// rectangle of it.
fn over_floor(vertices: &str, window: &str, pixels: [u32; 2]) -> Scene {
    built(&format!(
        r#"{{ "name": "lamp over a floor",
          "camera": {{ "window": {{ "cop": [1, 4, 0.5], {window} }}, "pixels": {pixels:?} }},
          "lights": [ {{ "name": "lamp", "position": [0, 1, 0], "power": {POWER} }} ],
          "materials": {{ "grey": {{ "colour": [1, 1, 1], "diffuse": 0.5 }} }},
          "objects": [ {{ "name": "floor", "material": "grey",
                          "shape": {{ "polygon": {{ "vertices": {vertices} }} }} }} ] }}"#
    ))
}

const FLOOR: &str = "[[-9, 0, -9], [-9, 0, 9], [9, 0, 9], [9, 0, -9]]";

/// Five pixels around x = 0, ½, 1, 1½, 2 on the floor: from 45° over the places and 1 away to 27° and √5.
const ROW: &str = r#""corner": [-0.25, 0, 0.25], "right": [2.5, 0, 0], "up": [0, 0, -0.5]"#;

/// The places, and around each a disc so large that at least one path in 30 ends in it.
const PLACES: [(f64, f64); 5] = [(0.0, 0.5), (0.5, 0.6), (1.0, 0.7), (1.5, 0.9), (2.0, 1.3)];

/// 2¹⁹ paths for each of 16 seeds.
const PATHS: u64 = 1 << 19;
const SEEDS: u64 = 16;

/// What three estimates of one irradiance may be apart.
const APART: f64 = 0.01;

/// How large the standard error of each may be.
const SIGMA: f64 = 0.002;

/// The closed form at a place on the floor: cos θ = 1/r, so E = Φ/(4π·r³).
fn irradiance(x: f64, z: f64) -> f64 {
    let squared = x * x + z * z + 1.0;
    POWER / (4.0 * PI * squared * squared.sqrt())
}

/// Its mean over a disc around (x, 0): ring by ring by Simpson's rule, and on a ring by equal steps, which for a
/// periodic function is as good as exact.
fn mean_over_disc(x: f64, radius: f64) -> f64 {
    const RINGS: u32 = 64;
    const STEPS: u32 = 64;
    let on_ring = |s: f64| {
        let at = |step: u32| {
            let (sin, cos) = (2.0 * PI * f64::from(step) / f64::from(STEPS)).sin_cos();
            irradiance(x + s * cos, s * sin)
        };
        (0..STEPS).map(at).sum::<f64>() / f64::from(STEPS)
    };
    // ∫ E·2πs ds / (π·radius²)
    let width = radius / f64::from(RINGS);
    let weighted = |i: u32| {
        let weight = match i {
            0 | RINGS => 1.0,
            _ if i % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let s = width * f64::from(i);
        weight * s * on_ring(s)
    };
    let integral = (0..=RINGS).map(weighted).sum::<f64>() * width / 3.0;
    2.0 * integral / (radius * radius)
}

#[test]
fn the_mean_over_a_disc_below_the_lamp_is_that_of_its_cone() {
    // the cone of half angle α takes (1 − cos α)/2 of the light, with cos α = 1/√(1 + radius²)
    for radius in [0.5_f64, 1.3] {
        let share = 0.5 * (1.0 - 1.0 / (1.0 + radius * radius).sqrt());
        let expected = POWER * share / (PI * radius * radius);
        let found = mean_over_disc(0.0, radius);
        assert!((found / expected - 1.0).abs() <= 1e-6, "{found} {expected}");
    }
}

/// Keeps what was gathered last.
#[derive(Default)]
struct Gathers(Gathered);

impl Recorder for Gathers {
    const ENABLED: bool = true;

    fn note(&mut self, event: impl FnOnce() -> Event) {
        if let Event::Gathered(gathered) = event() {
            self.0 = gathered;
        }
    }
}

fn gathered(scene: &Scene, light: &LightPass, pixel: [u32; 2]) -> Gathered {
    let strategy = Exhaustive::new(scene);
    let tracer = Tracer::new(scene, &strategy, Transport::HybridStored).with_light(Some(light));
    let mut gathers = Gathers::default();
    trace_pixel(&tracer, pixel, Through::Centres, &mut gathers).unwrap();
    gathers.0
}

fn stored(options: LightOptions) -> Settings {
    settings(Transport::HybridStored, options)
}

#[test]
fn counted_photons_gathered_photons_and_the_closed_form_agree_at_five_places() {
    // 16 times as many have σ = 1/√320 000
    const NEAREST: u32 = 20_000;
    let scene = over_floor(FLOOR, ROW, [5, 1]);
    let mut counts = [0_u64; 5];
    let mut ratios = [const { Vec::new() }; 5];
    for seed in 1..=SEEDS {
        let options = LightOptions {
            seed,
            paths: PATHS,
            nearest: NEAREST,
            ..LightOptions::default()
        };
        let (light, _) = light_pass::<Off>(&scene, &stored(options));
        for (i, (x, radius)) in PLACES.into_iter().enumerate() {
            let place = DVec3::new(x, 0.0, 0.0);
            let inside = |point: DVec3| point.distance_squared(place) <= radius * radius;
            let photons = light.stored().photons();
            counts[i] += photons.filter(|photon| inside(photon.point)).count() as u64;

            let found = gathered(&scene, &light, [i as u32, 0]);
            let radius = found.radius.unwrap();
            // (k − 1)/(π·r²) photons of Φ/N each
            let by_hand = f64::from(NEAREST - 1) / (PI * radius * radius) * POWER / PATHS as f64;
            assert!((found.irradiance / by_hand - 1.0).abs().max_element() <= 1e-9);
            ratios[i].push(found.irradiance / mean_over_disc(x, radius));
        }
    }
    let paths = (PATHS * SEEDS) as f64;
    for (i, (x, radius)) in PLACES.into_iter().enumerate() {
        // of N paths n end in the disc: σ(n)/n = √((1 − n/N)/n)
        let count = counts[i] as f64;
        let counted = count * POWER / paths / (PI * radius * radius);
        let sigma = ((1.0 - count / paths) / count).sqrt();
        let closed = mean_over_disc(x, radius);
        let off = counted / closed - 1.0;
        assert!(sigma <= SIGMA, "at x = {x}: σ is {sigma}");
        assert!(
            off.abs() <= APART && off.abs() <= DEVIATIONS * sigma,
            "at x = {x}: counted {counted}, closed form {closed}, σ {sigma}"
        );

        let gathered = Estimate::of(&ratios[i]).is_within(SIGMA, "gathered over closed form");
        let off = gathered.mean.x - 1.0;
        assert!(
            off.abs() <= APART && off.abs() <= DEVIATIONS * gathered.error.x,
            "at x = {x}: {gathered:?}"
        );
        assert!((counted / closed - gathered.mean.x).abs() <= APART);
    }
}

#[test]
fn of_few_photons_one_less_counts_or_the_mean_would_be_too_bright() {
    // 64 × 64 pixels on [−1, 1]², of which even the darkest has 1 000 000/(4π·√27)/1024 = 15 photons: discs around the
    // pixels' centres with 3 to 5 of them do not overlap, and the estimates are independent
    const SIDE: u32 = 64;
    const LIMIT: f64 = 0.017;
    let window = r#""corner": [-1, 0, 1], "right": [2, 0, 0], "up": [0, 0, -2]"#;
    let scene = over_floor(FLOOR, window, [SIDE, SIDE]);
    // with k = 2 the mean is right as well, but its variance has no bound: σ²/mean² = 1/(k − 2)
    for nearest in [3, 4, 5] {
        let options = LightOptions {
            seed: 20 + u64::from(nearest),
            paths: 1_000_000,
            nearest,
            ..LightOptions::default()
        };
        let (light, _) = light_pass::<Off>(&scene, &stored(options));
        let ratio = |number: u32| {
            let pixel = [number % SIDE, number / SIDE];
            let [x, z] = pixel.map(|i| (f64::from(i) + 0.5) * 2.0 / f64::from(SIDE) - 1.0);
            let found = gathered(&scene, &light, pixel);
            assert_eq!(found.count, nearest - 1);
            found.irradiance / irradiance(x, z)
        };
        let ratios: Vec<DVec3> = (0..SIDE * SIDE).map(ratio).collect();
        let found = Estimate::of(&ratios).is_within(LIMIT, "the mean over all pixels");
        let (mean, sigma) = (found.mean.x, found.error.x);
        let off = (mean - 1.0).abs();
        assert!(off <= DEVIATIONS * sigma, "k = {nearest}: {mean} ± {sigma}");
        // all k of them: k/(k − 1) times as bright
        let all = f64::from(nearest) / f64::from(nearest - 1);
        assert!(DEVIATIONS * sigma < (all * mean - 1.0).abs());
    }
}

/// The share of the light that falls on the rectangle from one corner on the floor to another: its solid angle over 4π.
fn share_of_rectangle(low: DVec2, high: DVec2) -> f64 {
    let from_foot = |x: f64, z: f64| (x * z / (x * x + z * z + 1.0).sqrt()).atan() / (4.0 * PI);
    from_foot(high.x, high.y) - from_foot(low.x, high.y) - from_foot(high.x, low.y)
        + from_foot(low.x, low.y)
}

/// The cell of a map that a pixel looks at: is as much on it as falls there, and its area right?
#[track_caller]
fn check_cell(scene: &Scene, light: &LightPass, pixel: u32, paths: u64, share: f64, area: f64) {
    const LIMIT: f64 = 0.004;
    let found = gathered(scene, light, [pixel, 0]);
    assert_eq!(found.radius, None);
    assert!((found.area / area - 1.0).abs() <= 1e-12, "{found:?}");
    let count = f64::from(found.count);
    let sigma = ((1.0 - count / paths as f64) / count).sqrt();
    assert!(sigma <= LIMIT, "σ is {sigma}");
    let expected = POWER * share / area;
    let off = (found.irradiance / expected - 1.0).abs().max_element();
    assert!(
        off <= DEVIATIONS * sigma,
        "{} {expected} {sigma}",
        found.irradiance
    );
}

#[test]
fn a_cell_of_a_map_has_the_closed_form_averaged_over_it() {
    // cells of 18/9 = 2: one is [−1, 1]², the next [1, 3] × [−1, 1]
    let scene = over_floor(FLOOR, ROW, [5, 1]);
    let paths = 2_000_000;
    let options = LightOptions {
        seed: 31,
        paths,
        map: Some(9),
        ..LightOptions::default()
    };
    let (light, _) = light_pass::<Off>(&scene, &stored(options));
    // the first is a face of the cube around the lamp
    let first = share_of_rectangle(DVec2::splat(-1.0), DVec2::ONE);
    assert!((first - 1.0 / 6.0).abs() <= 1e-15);
    let next = share_of_rectangle(DVec2::new(1.0, -1.0), DVec2::new(3.0, 1.0));
    for (pixel, share) in [(0, first), (1, first), (3, next), (4, next)] {
        check_cell(&scene, &light, pixel, paths, share, 4.0);
    }
    assert_eq!(light.stored().photons().count(), 0);
}

#[test]
fn a_cell_that_the_edge_of_a_triangle_cuts_has_the_light_of_what_is_left_of_it() {
    // cells of 8/4 = 2: the edge halves [0, 2] × [−2, 0]. The lamp stands over the edge, and sees both halves alike
    let triangle = "[[-4, 0, -4], [-4, 0, 4], [4, 0, -4]]";
    let window = r#""corner": [0.2, 0, -1], "right": [0.2, 0, 0], "up": [0, 0, -0.2]"#;
    let scene = over_floor(triangle, window, [1, 1]);
    let paths = 2_000_000;
    let options = LightOptions {
        seed: 32,
        paths,
        map: Some(4),
        ..LightOptions::default()
    };
    let (light, _) = light_pass::<Off>(&scene, &stored(options));
    let share = 0.5 * share_of_rectangle(DVec2::new(0.0, -2.0), DVec2::new(2.0, 0.0));
    check_cell(&scene, &light, 0, paths, share, 2.0);
}
