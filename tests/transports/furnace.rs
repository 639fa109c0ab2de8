//! Furnaces: closed rooms whose walls throw back the share ρ of all light. Of the power Φ the walls get Φ at first hand,
//! ρΦ at second, ρ²Φ at third: Φ/(1 − ρ) in all.

use std::f64::consts::PI;

use glam::DVec3;
use raystep::trace::LightOptions;
use raystep::{Event, Recorder, Scene, Transport};

use super::{
    Block, DEVIATIONS, Estimate, built, check_same, light_pass, picture, pictures, settings,
};

/// Φ, in watts.
const POWER: f64 = 40.0;

/// ρ, three at once.
const RHO: DVec3 = DVec3::new(0.5, 0.6, 0.7);

/// How large the standard error may be.
const SIGMA: f64 = 0.005;

/// The same for the forward transport, whose pixels see one path in 100.
const SIGMA_OF_FORWARD: f64 = 0.01;

/// R, in a scene of three pixels that look in different directions. The disc of the widest eye below, of radius 1.1
/// around (0, 0, 0.3), lies inside: 1.1² + 0.3² = 1.3 < 1.5².
const RADIUS: f64 = 1.5;

/// n of the glass.
const INDEX: f64 = 1.5;

fn sphere(colour: [f64; 3]) -> Scene {
    sphere_around("", colour)
}

/// The same with more objects inside.
fn sphere_around(objects: &str, colour: [f64; 3]) -> Scene {
    built(&format!(
        r#"{{ "name": "a furnace",
          "camera": {{ "window": {{ "cop": [0, 0, 0.3], "corner": [-0.75, -0.5, -0.4], "right": [1.5, 0, 0],
                                    "up": [0, 1, 0] }}, "pixels": [3, 1] }},
          "lights": [ {{ "name": "lamp", "position": [0, 0, 0], "power": {POWER} }} ],
          "materials": {{ "wall": {{ "colour": {colour:?}, "diffuse": 1 }},
                          "glass": {{ "colour": [1, 1, 1], "transmission": 1, "index": {INDEX} }} }},
          "objects": [ {objects} {{ "name": "furnace", "material": "wall", "sides": "back",
                          "shape": {{ "sphere": {{ "center": [0, 0, 0], "radius": {RADIUS} }} }} }} ] }}"#
    ))
}

/// E = Φ/(1 − ρ) over the sphere's area 4πR², alike everywhere, and L = ρ/π·E = ρΦ/(4π²R²(1 − ρ)).
fn radiance() -> DVec3 {
    RHO * POWER / (4.0 * PI * PI * RADIUS * RADIUS * (DVec3::ONE - RHO))
}

/// Every pixel has that radiance.
#[track_caller]
fn check_furnace(transport: Transport, sigma: f64, seeds: u64, options: LightOptions) {
    let scene = sphere(RHO.into());
    check_radiance(&scene, transport, sigma, seeds, options, radiance());
}

/// Every pixel of a scene has this radiance.
#[track_caller]
fn check_radiance(
    scene: &Scene,
    transport: Transport,
    sigma: f64,
    seeds: u64,
    options: LightOptions,
    radiance: DVec3,
) {
    let pictures = pictures(scene, transport, seeds, options);
    for pixel in 0..3 {
        let what = format!("{transport:?}, pixel {pixel}");
        let block = Block {
            columns: [pixel, pixel + 1],
            rows: [0, 1],
        };
        let found = block.estimate(&pictures).is_within(sigma, &what);
        check_same(&what, found, Estimate::exact(radiance));
    }
}

#[test]
fn a_sphere_is_as_bright_everywhere_seen_by_photons_that_reach_the_eye() {
    let options = LightOptions {
        paths: 200_000,
        aperture: Some(1.1),
        ..LightOptions::default()
    };
    check_furnace(Transport::Forward, SIGMA_OF_FORWARD, 18, options);
}

#[test]
fn a_sphere_is_as_bright_everywhere_seen_by_photons_that_were_stored() {
    // a tenth of what is stored lies within r of a point, measured straight through: r² = 4R²/10, exactly as much of
    // the sphere as a disc of that radius (Archimedes)
    let options = LightOptions {
        paths: 20_000,
        nearest: 5_000,
        ..LightOptions::default()
    };
    check_furnace(Transport::HybridStored, SIGMA, 20, options);
}

#[test]
fn a_sphere_is_as_bright_everywhere_seen_by_connecting_lines() {
    let options = LightOptions {
        samples: 2_000,
        ..LightOptions::default()
    };
    check_furnace(Transport::HybridConnected, SIGMA, 20, options);
}

/// A ball of glass around the lamp and the eye.
///
/// It changes nothing on the walls. The lamp is at its center, and light along a radius is not bent. A wall point
/// sees another wall point in every direction, through the ball or beside it, at the same radiance: radiance is n²
/// times as much inside the ball, and as much as before behind it. A ray within r/n = 0.8 of the center leaves the ball
/// (n·sin θ < 1), and the disc of the eye is closer: 0.7² + 0.3² = 0.58 < 0.8². So the eye sees n²·L everywhere.
const BALL: &str = r#"{ "name": "ball", "material": "glass",
                        "shape": { "sphere": { "center": [0, 0, 0], "radius": 1.2 } } },"#;

#[test]
fn an_eye_in_a_ball_of_glass_counts_n_squared_times_the_photons() {
    let options = LightOptions {
        paths: 200_000,
        aperture: Some(0.7),
        ..LightOptions::default()
    };
    let scene = sphere_around(BALL, RHO.into());
    let radiance = INDEX * INDEX * radiance();
    check_radiance(
        &scene,
        Transport::Forward,
        SIGMA_OF_FORWARD,
        20,
        options,
        radiance,
    );
}

#[test]
fn an_eye_in_a_ball_of_glass_sees_n_squared_times_what_is_stored_outside() {
    let options = LightOptions {
        paths: 20_000,
        nearest: 5_000,
        ..LightOptions::default()
    };
    let scene = sphere_around(BALL, RHO.into());
    let radiance = INDEX * INDEX * radiance();
    check_radiance(
        &scene,
        Transport::HybridStored,
        SIGMA,
        20,
        options,
        radiance,
    );
}

/// Sums the power that arrives at surfaces, and what leaves the room.
#[derive(Default)]
struct Incident {
    power: DVec3,
    lost: u32,
}

impl Recorder for Incident {
    const ENABLED: bool = true;

    fn note(&mut self, event: impl FnOnce() -> Event) {
        match event() {
            Event::Photon(photon) => self.power += photon.power,
            Event::RayEnd(end) => self.lost += u32::from(end.object.is_none()),
            _ => {}
        }
    }
}

/// The walls of a closed room get Φ/(1 − ρ).
///
/// A path meets k surfaces with chance ρᵏ⁻¹·(1 − ρ): 1/(1 − ρ) in the mean, with variance ρ/(1 − ρ)². Of N paths
/// of Φ/N each the sum has σ = Φ/(1 − ρ)·√(ρ/N).
#[track_caller]
fn check_closed_room(objects: &str, seed: u64) {
    const PATHS: u64 = 250_000;
    let scene = built(&format!(
        r#"{{ "name": "a closed room",
          "camera": {{ "look_at": {{ "cop": [0.1, 0.2, 0.3], "target": [0, 0, 0], "up": [0, 1, 0], "fov_degrees": 60 }},
                       "pixels": [1, 1] }},
          "lights": [ {{ "name": "lamp", "position": [0.7, -0.2, 0.1], "power": {POWER} }} ],
          "materials": {{ "wall": {{ "colour": [0.5, 0.6, 0.7], "diffuse": 1 }} }},
          "objects": [ {objects} ] }}"#
    ));
    let options = LightOptions {
        seed,
        paths: PATHS,
        ..LightOptions::default()
    };
    // nothing is seen through an eye without a radius: what is followed is the light alone
    let options = LightOptions {
        aperture: Some(0.0),
        ..options
    };
    let (_, heard) = light_pass::<Incident>(&scene, &settings(Transport::Forward, options));
    let incident: DVec3 = heard.iter().map(|heard| heard.power).sum();
    let lost: u32 = heard.iter().map(|heard| heard.lost).sum();
    assert_eq!(lost, 0, "rays that left the closed room");

    let expected = POWER / (DVec3::ONE - RHO);
    let sigma = expected * (RHO / PATHS as f64).map(f64::sqrt);
    assert!((sigma / expected).max_element() <= SIGMA);
    let off = (incident - expected).abs() / sigma;
    assert!(
        off.max_element() <= DEVIATIONS,
        "{incident} instead of {expected}: {off} standard errors"
    );

    // it is also that of the pieces of 1024 paths, the shorter last one left aside. Of n pieces σ is known to
    // 1/√(2n) of itself: 4.5 % for 244 pieces, of which three are 14 %
    let full = &heard[..heard.len() - 1];
    let share = full.len() as f64 * 1024.0 / PATHS as f64;
    let pieces: Vec<DVec3> = full.iter().map(|heard| heard.power).collect();
    let by_pieces = Estimate::of(&pieces).error * full.len() as f64 / share.sqrt();
    let ratio = by_pieces / sigma;
    assert!((ratio - 1.0).abs().max_element() <= 0.15, "{ratio}");
}

#[test]
fn the_walls_of_a_closed_box_get_all_light_again_and_again() {
    let room = r#"{ "name": "room", "material": "wall",
                    "shape": { "box": { "min": [-1, -1.5, -0.5], "max": [2, 1, 1.5] } } }"#;
    check_closed_room(room, 1);
}

#[test]
fn six_polygons_hold_the_light_as_a_box_does() {
    let (low, high) = ([-1.0, -1.5, -0.5], [2.0, 1.0, 1.5]);
    let mut walls = Vec::new();
    for axis in 0..3 {
        for (side, end) in [("low", low), ("high", high)] {
            let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
            let corner = |at_u: [f64; 3], at_v: [f64; 3]| {
                let mut corner = end;
                corner[u] = at_u[u];
                corner[v] = at_v[v];
                corner
            };
            let corners = [
                corner(low, low),
                corner(high, low),
                corner(high, high),
                corner(low, high),
            ];
            walls.push(format!(
                r#"{{ "name": "{side} {axis}", "material": "wall",
                      "shape": {{ "polygon": {{ "vertices": {corners:?} }} }} }}"#
            ));
        }
    }
    check_closed_room(&walls.join(","), 2);
}

#[test]
fn no_light_is_kept_in_a_room_that_absorbs_it_all() {
    // black: every path meets one surface, and what arrives is what was sent
    let scene = sphere([0.0; 3]);
    let options = LightOptions {
        paths: 2_000,
        ..LightOptions::default()
    };
    for transport in [
        Transport::Forward,
        Transport::HybridStored,
        Transport::HybridConnected,
    ] {
        let picture = picture(&scene, &settings(transport, options));
        assert!(picture.colours.iter().all(|&colour| colour == DVec3::ZERO));
    }
    let (_, heard) = light_pass::<Incident>(&scene, &settings(Transport::Forward, options));
    let incident: DVec3 = heard.iter().map(|heard| heard.power).sum();
    assert!(
        (incident / POWER - 1.0).abs().max_element() <= 1e-12,
        "{incident}"
    );
}
