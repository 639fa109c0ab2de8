//! A caustic below a ball of glass, and its image in a mirror: who sees it, and how bright?

use std::f64::consts::PI;

use glam::{DVec2, DVec3};
use raystep::trace::LightOptions;
use raystep::{Off, Transport};

use super::{
    Block, DEVIATIONS, Estimate, Scene, built, check_same, light_pass, pictures, settings,
};

/// The lamp's height over the floor, and that of the ball's center; the lamp stands right over it.
const LAMP: f64 = 1.9;
const BALL: f64 = 1.3;
const RADIUS: f64 = 0.5;
/// The ball's index of refraction.
const INDEX: f64 = 1.15;
/// Φ, in watts.
const POWER: f64 = 100.0;

/// The floor lies in y = 0, wholly in the shadow of the ball: the cone that touches it is, on the floor,
/// LAMP · tan(asin(0.5/0.6)) = 2.86 wide, and the farthest corner √(2² + 2²) = 2.83 away. A low mirror stands on its
/// edge x = 0.8. The eye hangs at 0.6, under the ball, and looks down on a window in the plane of the floor: pixels
/// up to x = 0.8 are squares of it, 0.05 wide, and those beyond are such squares seen in the mirror.
fn scene() -> Scene {
    built(&format!(
        r#"{{ "name": "a caustic and a mirror",
          "camera": {{ "window": {{ "cop": [0.1, 0.6, 0], "corner": [-0.6, 0, 0.5], "right": [2.8, 0, 0],
                                    "up": [0, 0, -1] }}, "pixels": [56, 20] }},
          "lights": [ {{ "position": [0, {LAMP}, 0], "power": {POWER} }} ],
          "materials": {{
            "white": {{ "colour": [0.9, 0.8, 0.7], "diffuse": 1 }},
            "silver": {{ "colour": [1, 1, 1], "reflection": 1 }},
            "glass": {{ "colour": [1, 1, 1], "transmission": 1, "index": {INDEX} }} }},
          "objects": [
            {{ "name": "ball", "material": "glass",
               "shape": {{ "sphere": {{ "center": [0, {BALL}, 0], "radius": {RADIUS} }} }} }},
            {{ "name": "floor", "material": "white",
               "shape": {{ "polygon": {{ "vertices": [[-2, 0, -2], [-2, 0, 2], [0.8, 0, 2], [0.8, 0, -2]] }} }} }},
            {{ "name": "mirror", "material": "silver",
               "shape": {{ "polygon": {{
                 "vertices": [[0.8, 0, -2], [0.8, 0, 2], [0.8, 0.55, 2], [0.8, 0.55, -2]] }} }} }} ] }}"#
    ))
}

/// Where a ray that leaves the lamp at an angle θ from the vertical comes to the floor behind the ball: its distance
/// from the axis.
fn on_floor(theta: f64) -> f64 {
    // in the plane of the ray, seen from the ball's center
    let lamp = DVec2::new(0.0, LAMP - BALL);
    let along = DVec2::new(theta.sin(), -theta.cos());
    let to_middle = -lamp.dot(along);
    let half_chord = |point: DVec2, along: DVec2| {
        let beside = point.perp_dot(along);
        (RADIUS * RADIUS - beside * beside).sqrt()
    };
    let enters = lamp + (to_middle - half_chord(lamp, along)) * along;
    // inside a ball both angles with the surface are the same, so the ray is turned twice by θ₁ − θ₂
    let sine = lamp.y * theta.sin() / RADIUS;
    let turn = sine.asin() - (sine / INDEX).asin();
    let inside = DVec2::from_angle(-turn).rotate(along);
    let leaves = enters + 2.0 * half_chord(enters, inside) * inside;
    let out = DVec2::from_angle(-turn).rotate(inside);
    let t = -(BALL + leaves.y) / out.y;
    leaves.x + t * out.x
}

#[test]
fn photons_below_the_ball_are_as_many_as_glass_sends_there() {
    const CONE: f64 = 0.35;
    const STEPS: u32 = 10_000;
    let radius = on_floor(CONE);
    // those within this angle, and of those that graze the ball and are bent most the ones that come back to the axis:
    // ½·∫ sin θ dθ, step by step
    let step = (RADIUS / (LAMP - BALL)).asin() / f64::from(STEPS);
    let share: f64 = (0..STEPS)
        .map(|i| step * (f64::from(i) + 0.5))
        .filter(|&theta| on_floor(theta).abs() <= radius)
        .map(|theta| 0.5 * step * theta.sin())
        .sum();
    assert!(0.5 * (1.0 - CONE.cos()) <= share * (1.0 + 1e-3));
    let paths = 400_000;
    let options = LightOptions {
        paths,
        // in and out of the glass, and down: nothing that comes a second time
        bounces: Some(3),
        ..LightOptions::default()
    };
    let (light, _) = light_pass::<Off>(&scene(), &settings(Transport::HybridStored, options));
    let is_inside = |point: DVec3| point.length() <= radius;
    let photons = light.stored().photons();
    let count = photons.filter(|photon| is_inside(photon.point)).count() as f64;
    let sigma = (share * (1.0 - share) / paths as f64).sqrt();
    assert!(sigma <= 0.01 * share);
    let found = count / paths as f64;
    assert!(
        (found - share).abs() <= DEVIATIONS * sigma,
        "{found} instead of {share}"
    );
    // brighter than without the ball
    assert!(1.0 / (4.0 * PI * LAMP * LAMP) < share / (PI * radius * radius));
}

/// Of the floor x and z in −0.5..0.5, inside the rim: in itself, and in the mirror, where it is at 1.1..2.1.
const CAUSTIC: Block = Block {
    columns: [2, 22],
    rows: [0, 20],
};
const IMAGE: Block = Block {
    columns: [34, 54],
    rows: [0, 20],
};

/// How large the standard errors may be: in the mirror few photons are on their way into the eye.
const SIGMA: f64 = 0.01;
const SIGMA_OF_IMAGE: f64 = 0.03;

/// The caustic and its image, in pictures of one transport.
fn both(transport: Transport, seeds: u64, options: LightOptions) -> [Estimate; 2] {
    let pictures = pictures(&scene(), transport, seeds, options);
    [CAUSTIC, IMAGE].map(|block| block.estimate(&pictures))
}

#[test]
fn all_see_a_caustic_but_connecting_lines_do_not_see_its_image_in_a_mirror() {
    let usual = LightOptions::default();
    let forward = LightOptions {
        paths: 200_000,
        aperture: Some(0.5),
        ..usual
    };
    let stored = LightOptions {
        paths: 100_000,
        ..usual
    };
    let connected = LightOptions {
        samples: 64,
        ..usual
    };
    let [by_photons, image_by_photons] = both(Transport::Forward, 26, forward);
    let [by_storage, image_by_storage] = both(Transport::HybridStored, 10, stored);
    let [by_lines, image_by_lines] = both(Transport::HybridConnected, 10, connected);
    for (name, found) in [
        ("forward", by_photons),
        ("stored", by_storage),
        ("connected", by_lines),
    ] {
        found.is_within(SIGMA, name);
    }
    check_same("forward and stored", by_photons, by_storage);
    check_same("forward and connected", by_photons, by_lines);
    check_same("stored and connected", by_storage, by_lines);

    image_by_photons.is_within(SIGMA_OF_IMAGE, "forward, image");
    image_by_storage.is_within(SIGMA, "stored, image");
    check_same(
        "forward and stored, image",
        image_by_photons,
        image_by_storage,
    );
    // a perfect mirror takes nothing away
    check_same("stored, caustic and image", by_storage, image_by_storage);
    // light, glass, glass, floor, mirror, eye: of all edges none is without glass or mirror
    assert_eq!(image_by_lines.mean, DVec3::ZERO);
}
