//! Light on its way, computed again: chance, arrivals, gathered photons, connections.

use raystep::{Scene, Transport, WorkedOptions};

use crate::worked_solution::worked_text;

use super::{check_line, check_text};
use crate::worked_solution::light::{GLASS, SCENE, built, records, settings};

/// The working of every pixel in full; of every fifth one where each has something to tell.
fn solutions(scene: &Scene, transport: Transport) -> Vec<String> {
    let settings = settings(transport);
    let [width, height] = scene.camera.pixels;
    let options = WorkedOptions {
        all: true,
        ..WorkedOptions::default()
    };
    // few photons come to the eye
    let step = if transport == Transport::Forward {
        1
    } else {
        5
    };
    (0..width * height)
        .step_by(step)
        .map(|number| {
            let records = records(scene, &settings, [number % width, number / width]);
            worked_text(scene, &settings, &records, &options)
        })
        .collect()
}

/// Every line of the solutions comes out, and each of these beginnings has a line with as many equations.
#[track_caller]
fn check(transport: Transport, lines: &[(&str, usize)]) {
    for text in [SCENE, GLASS] {
        let scene = built(text);
        let told = solutions(&scene, transport).concat();
        check_text(&told, [10, 5]);
        for (begins, at_least) in lines {
            let line = told
                .lines()
                .find(|line| line.trim_start().starts_with(begins));
            let line = line.unwrap_or_else(|| panic!("no {begins} in {}", scene.name));
            let [numbers, vectors] = check_line(line);
            assert!(
                *at_least <= numbers + vectors,
                "{numbers} + {vectors} of {line}"
            );
        }
    }
}

#[test]
fn what_comes_to_the_eye_can_be_computed_again() {
    check(
        Transport::Forward,
        &[
            ("d² = |window − aperture|²", 1),
            ("cos θ = N·(window − aperture)/d", 1),
            ("G = cos²θ/d²", 1),
            ("L = power/(G·π·R²·A)", 1),
        ],
    );
}

#[test]
fn what_is_gathered_can_be_computed_again() {
    check(
        Transport::HybridStored,
        &[
            ("area = π·r²", 1),
            ("irradiance: Σ power", 1),
            ("irradiance: E = Σ power/area", 1),
            ("diffuse: colour·diffuse/π·E", 1),
        ],
    );
}

#[test]
fn what_a_line_brings_can_be_computed_again() {
    check(
        Transport::HybridConnected,
        &[
            ("x′ − x", 1),
            ("d² = |x′ − x|²", 1),
            ("cos θ′ = N′·(x − x′)/d", 1),
            ("G = cos θ·cos θ′/d²", 1),
            ("φ₀", 1),
            ("φ₁", 1),
            ("φ₂ = d²/(A·cos θ)", 1),
            ("edge 0–1", 1),
            ("w = share/Σ shares", 1),
            ("sent:", 1),
            ("received: ρ′/π·β", 1),
            ("L = sent·G·V·received·w", 1),
            ("→ the line adds", 1),
            ("together:", 1),
        ],
    );
}
