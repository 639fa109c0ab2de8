//! The eye or the lamp inside glass: a radiance is n² times as much there, a power is not.
//!
//! A block of glass hangs over a floor. The closed forms follow the one ray that Snell's law allows, angle by angle.
//! Nothing else reaches the floor or the eye:
//! - the block reflects nothing, and is wider than the floor. What passes its lower face passes its upper face too,
//!   where the angle is the same, and is gone;
//! - what leaves by a side goes away from the block, and so past the floor;
//! - the floor is flat and does not light itself.

use std::f64::consts::PI;

use glam::{DVec2, DVec3};
use raystep::trace::LightOptions;
use raystep::{Scene, Transport};

use super::{Block, Estimate, built, check_same, pictures};

/// Φ, in watts.
const POWER: f64 = 100.0;

/// n of the glass.
const INDEX: f64 = 1.25;

/// colour·diffuse of the floor.
const ALBEDO: DVec3 = DVec3::new(0.9, 0.8, 0.7);

/// The height of the lower face over the floor.
const FACE: f64 = 1.0;

/// How large the standard error of each mean may be. Without n² = 1.5625 a mean would be off by a third.
const SIGMA: f64 = 0.01;

/// The same where photons are counted, of which few reach the eye.
const SIGMA_OF_FORWARD: f64 = 0.02;

/// The window has 12 × 4 pixels, looked at in three blocks of 4 × 4.
const BLOCKS: [(&str, Block); 3] = [
    ("left", block([0, 4])),
    ("middle", block([4, 8])),
    ("right", block([8, 12])),
];

const fn block(columns: [u32; 2]) -> Block {
    let rows = [0, 4];
    Block { columns, rows }
}

/// The floor lies in y = 0; the eye looks straight down, through a window that is centred below it.
struct Setting {
    lamp: DVec3,
    eye: DVec3,
    /// The height of the window.
    window: f64,
    /// Its width and its depth.
    size: DVec2,
    /// The radius of the eye where photons are counted.
    aperture: f64,
}

impl Setting {
    fn scene(&self) -> Scene {
        let (DVec2 { x: width, y: depth }, height) = (self.size, self.window);
        let (x, z) = (self.eye.x - 0.5 * width, self.eye.z + 0.5 * depth);
        built(&format!(
            r#"{{ "name": "a block of glass over a floor",
              "camera": {{ "window": {{ "cop": {:?}, "corner": [{x}, {height}, {z}], "right": [{width}, 0, 0],
                                        "up": [0, 0, {}] }}, "pixels": [12, 4] }},
              "lights": [ {{ "name": "lamp", "position": {:?}, "power": {POWER} }} ],
              "materials": {{
                "grey": {{ "colour": {:?}, "diffuse": 1 }},
                "glass": {{ "colour": [1, 1, 1], "transmission": 1, "index": {INDEX} }} }},
              "objects": [
                {{ "name": "floor", "material": "grey",
                   "shape": {{ "polygon": {{
                     "vertices": [[-2.5, 0, -2.5], [-2.5, 0, 2.5], [2.5, 0, 2.5], [2.5, 0, -2.5]] }} }} }},
                {{ "name": "block", "material": "glass",
                   "shape": {{ "box": {{ "min": [-3, {FACE}, -3], "max": [3, 3, 3] }} }} }} ] }}"#,
            self.eye.to_array(),
            -depth,
            self.lamp.to_array(),
            ALBEDO.to_array(),
        ))
    }

    /// The mean of a radiance, by the place on the floor that is seen, over some columns of the window and a disc of a
    /// radius around the eye: midpoint by midpoint, so many along each side of the block.
    fn mean(&self, block: Block, radius: f64, steps: u32, radiance: impl Fn(DVec2) -> f64) -> f64 {
        // over the disc a coarse grid is enough, since few photons are counted; a pinhole needs one point
        let on_disc = if radius == 0.0 { 1 } else { 8 };
        let middle = |step: u32, steps: u32| (f64::from(step) + 0.5) / f64::from(steps);
        let mut sum = 0.0;
        for (i, j) in pairs(steps) {
            let [left, right] = block.columns.map(f64::from);
            let column = left + (right - left) * middle(i, steps);
            let on_window = self.size * DVec2::new(column / 12.0 - 0.5, middle(j, steps) - 0.5);
            for (k, l) in pairs(on_disc) {
                // rings of the same area
                let ring = radius * middle(k, on_disc).sqrt();
                let on_disc = ring * DVec2::from_angle(2.0 * PI * middle(l, on_disc));
                let place = self.seen(on_disc, on_window);
                sum += radiance(DVec2::new(self.eye.x, self.eye.z) + place);
            }
        }
        sum / f64::from(steps * steps * on_disc * on_disc)
    }

    /// Where on the floor the eye sees along a line from one point of its disc to one of the window, all measured from
    /// the foot of the eye.
    fn seen(&self, on_disc: DVec2, on_window: DVec2) -> DVec2 {
        let slope = (on_window - on_disc) / (self.eye.y - self.window);
        if self.eye.y <= FACE {
            return on_disc + slope * self.eye.y;
        }
        // down to the face with tan θ₁ = slope, and on with sin θ₂ = n·sin θ₁
        let tan = slope.length();
        let sin_below = INDEX * tan / (1.0 + tan * tan).sqrt();
        assert!(sin_below < 1.0, "the line is reflected");
        let tan_below = sin_below / (1.0 - sin_below * sin_below).sqrt();
        on_disc + slope * (self.eye.y - FACE) + slope.normalize_or_zero() * tan_below * FACE
    }

    /// Do the three transports that follow light find this radiance, for an albedo of 1?
    #[track_caller]
    fn check(&self, radiance: impl Fn(DVec2) -> f64) {
        let scene = self.scene();
        let usual = LightOptions {
            // lamp, two faces, floor, two faces: what goes on from there is between the faces of the block for ever
            bounces: Some(6),
            ..LightOptions::default()
        };
        let forward = LightOptions {
            paths: 500_000,
            aperture: Some(self.aperture),
            ..usual
        };
        let stored = LightOptions {
            paths: 200_000,
            nearest: 100,
            ..usual
        };
        let connected = LightOptions {
            samples: 1_600,
            ..usual
        };
        // stored light is seen through the centres of the pixels, 4 × 4 to a block; the others see all of it, for which
        // 32 midpoints a side are right within 2·10⁻⁴
        let ways = [
            (Transport::Forward, 14, forward, self.aperture, 32),
            (Transport::HybridStored, 16, stored, 0.0, 4),
            (Transport::HybridConnected, 12, connected, 0.0, 32),
        ];
        // by the closed form, so that ways whose eyes have another radius can be compared
        let ratios = ways.map(|(transport, seeds, options, radius, steps)| {
            let pictures = pictures(&scene, transport, seeds, options);
            BLOCKS.map(|(name, block)| {
                let what = format!("{transport:?}, {name}");
                let closed = ALBEDO * self.mean(block, radius, steps, &radiance);
                let Estimate { mean, error } = block.estimate(&pictures);
                let (mean, error) = (mean / closed, error / closed);
                let limit = match transport {
                    Transport::Forward => SIGMA_OF_FORWARD,
                    _ => SIGMA,
                };
                let found = Estimate { mean, error }.is_within(limit, &what);
                check_same(&what, found, Estimate::exact(DVec3::ONE));
                found
            })
        });
        for (i, one) in ratios.iter().enumerate() {
            for (j, other) in ratios[..i].iter().enumerate() {
                for (patch, (name, _)) in BLOCKS.iter().enumerate() {
                    let what = format!("{:?} and {:?}, {name}", ways[i].0, ways[j].0);
                    check_same(&what, one[patch], other[patch]);
                }
            }
        }
    }
}

fn pairs(steps: u32) -> impl Iterator<Item = (u32, u32)> {
    (0..steps * steps).map(move |i| (i / steps, i % steps))
}

#[test]
fn an_eye_in_glass_sees_n_squared_times_the_radiance_outside() {
    // the lamp stands under the block
    let setting = Setting {
        lamp: DVec3::new(0.3, 0.8, 0.1),
        eye: DVec3::new(0.0, 2.0, 0.0),
        window: 1.2,
        size: DVec2::new(0.8, 0.44),
        aperture: 0.3,
    };
    // L = n²·E/π for an albedo of 1, with E = Φ·cos θ/(4π·r²)
    let lamp = setting.lamp;
    let radiance = |place: DVec2| {
        let offset = lamp - DVec3::new(place.x, 0.0, place.y);
        let cos = offset.y / offset.length();
        INDEX * INDEX / PI * POWER * cos / (4.0 * PI * offset.length_squared())
    };
    // straight below the eye: r² = 0.3² + 0.8² + 0.1² = 0.74, so that L = 1.5625/π · 100·0.8/(4π·0.74^1.5) = 4.9740
    assert!((radiance(DVec2::ZERO) - 4.974_0).abs() <= 5e-5);
    setting.check(radiance);
}

#[test]
fn a_lamp_in_glass_lights_what_is_outside_with_its_power() {
    let setting = Setting {
        lamp: DVec3::new(0.2, 1.5, 0.1),
        eye: DVec3::new(-0.2, 0.9, 0.0),
        window: 0.0,
        size: DVec2::new(2.4, 1.6),
        aperture: 0.5,
    };
    let lamp = setting.lamp;
    let radiance = |place: DVec2| {
        let away = place.distance(DVec2::new(lamp.x, lamp.z));
        irradiance_below(lamp.y - FACE, away) / PI
    };
    setting.check(radiance);
}

/// E on the floor, so far beside a lamp that stands in the glass, so high over its lower face.
///
/// Between θ₁ and θ₁ + dθ₁ there is the power Φ/2·sin θ₁ dθ₁. It falls on a ring of radius x = h·tan θ₁ + f·tan θ₂ and of
/// area 2π·x dx, with sin θ₂ = n·sin θ₁ and f the height of the face over the floor:
///
/// E = Φ·sin θ₁ / (4π·x·x′),  x′ = h/cos²θ₁ + f·n·cos θ₁/cos³θ₂
///
/// On the axis sin θ₁/x is 1/(h + f·n) and x′ is h + f·n: as from a lamp at that distance, n times the air away.
fn irradiance_below(height: f64, away: f64) -> f64 {
    let below = |theta: f64| {
        let sin = INDEX * theta.sin();
        (sin, (1.0 - sin * sin).sqrt())
    };
    let lands = |theta: f64| {
        let (sin, cos) = below(theta);
        height * theta.tan() + FACE * sin / cos
    };
    // x grows with θ₁, up to the critical angle: halve the interval
    let (mut low, mut high) = (0.0, (1.0 / INDEX).asin());
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if lands(middle) < away {
            low = middle;
        } else {
            high = middle;
        }
    }
    let theta = 0.5 * (low + high);
    let (_, cos) = below(theta);
    let slope = height / theta.cos().powi(2) + FACE * INDEX * theta.cos() / cos.powi(3);
    POWER * theta.sin() / (4.0 * PI * lands(theta) * slope)
}

#[test]
fn the_irradiance_below_a_lamp_in_glass_is_all_that_leaves_by_the_face() {
    // on the axis, at 0.5 + 1.25·1 = 1.75
    let axis = POWER / (4.0 * PI * 1.75 * 1.75);
    assert!((irradiance_below(0.5, 1e-6) / axis - 1.0).abs() <= 1e-9);
    // sin θ₁ = 0.6, sin θ₂ = 0.75: the disc that ends there has Φ/2·(1 − 0.8), ring by ring
    let cos = (1.0_f64 - 0.75 * 0.75).sqrt();
    let edge = 0.5 * 0.75 + 0.75 / cos;
    let rings = 20_000;
    let width = edge / f64::from(rings);
    let power: f64 = (0..rings)
        .map(|ring| width * (f64::from(ring) + 0.5))
        .map(|away| irradiance_below(0.5, away) * 2.0 * PI * away * width)
        .sum();
    assert!((power / (0.1 * POWER) - 1.0).abs() <= 1e-6, "{power}");
}
