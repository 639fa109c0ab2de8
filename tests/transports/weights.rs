//! The weights of connecting lines: each path as a whole, worked out once more from its points, normals and materials.

use std::f64::consts::PI;

use glam::DVec3;
use raystep::scene::Emission;
use raystep::strategy::Exhaustive;
use raystep::trace::{Alternative, Connection, LightOptions};
use raystep::tracer::trace_pixel;
use raystep::{Event, Off, Record, Recording, Scene, Settings, Through, Tracer, Transport};

use super::chain::{Chain, add_surfaces, by_window_area, end};
use super::{built, light_pass, settings};

/// Products of some dozen factors round off in their last digits.
const ROUNDING: f64 = 1e-9;

const PIXELS: [u32; 2] = [8, 6];
const SAMPLES: u32 = 6;
const POWER: [f64; 2] = [60.0, 30.0];

/// A room with two lamps, a mirror that is partly white, and a ball of glass that is partly so.
fn scene() -> Scene {
    built(&format!(
        r#"{{ "name": "all that can be connected",
          "camera": {{ "window": {{ "cop": [0.1, 0.2, 1.8], "corner": [-1, -0.6, 0.9], "right": [2, 0, 0.2],
                                    "up": [0, 1.4, 0.1] }}, "pixels": {PIXELS:?} }},
          "lights": [ {{ "position": [0.8, 0.8, 0.9], "power": {} }}, {{ "position": [-1.2, 0.5, 1.5], "power": {} }} ],
          "materials": {{
            "wall": {{ "colour": [0.9, 0.6, 0.4], "diffuse": 0.9 }},
            "mirror": {{ "colour": [1, 0.5, 1], "diffuse": 0.2, "reflection": 0.7 }},
            "glass": {{ "colour": [0.4, 1, 1], "diffuse": 0.1, "reflection": 0.2, "transmission": 0.7, "index": 1.5 }} }},
          "objects": [
            {{ "name": "room", "material": "wall",
               "shape": {{ "box": {{ "min": [-2, -1, -2], "max": [2, 1, 2] }} }} }},
            {{ "name": "mirror", "material": "mirror",
               "shape": {{ "polygon": {{ "vertices": [[-1.9, -0.9, -1], [-0.4, -0.9, -1.8], [-0.4, 0.9, -1.8], [-1.9, 0.9, -1]] }} }} }},
            {{ "name": "ball", "material": "glass",
               "shape": {{ "sphere": {{ "center": [0.5, -0.3, -0.6], "radius": 0.6 }} }} }} ] }}"#,
        POWER[0], POWER[1]
    ))
}

/// What was seen, so that no case is passed over.
#[derive(Debug, Default)]
struct Seen {
    connections: u32,
    to_eye: u32,
    from_light: u32,
    with_choice: u32,
    over_mirror_or_glass: u32,
}

/// Everything about one connection.
#[track_caller]
fn check_connection(
    scene: &Scene,
    chain: &Chain,
    alternatives: &[Alternative],
    connection: &Connection,
    seen: &mut Seen,
) {
    let [from, to] = [chain.vertices[chain.line - 1], chain.vertices[chain.line]];
    assert_eq!((connection.from, connection.to), (from.point, to.point));
    check_close(connection.geometry(), chain.geometry(chain.line));

    let weights = chain.weights(scene);
    let edges: Vec<usize> = alternatives.iter().map(|a| a.edge as usize).collect();
    let expected: Vec<usize> = weights.iter().map(|(edge, _)| *edge).collect();
    assert_eq!(edges, expected, "the edges that can be the line");
    let shares: f64 = alternatives.iter().map(|a| a.share).sum();
    for (alternative, (edge, weight)) in alternatives.iter().zip(&weights) {
        assert_eq!(alternative.chosen, *edge == chain.line);
        let [at_light, at_eye] = alternative.densities;
        check_close(alternative.geometry, chain.geometry(*edge));
        check_close(at_light, chain.density(scene, edge - 1));
        check_close(at_eye, chain.density(scene, *edge));
        check_close(
            alternative.share,
            1.0 / (alternative.geometry * at_light * at_eye),
        );
        check_close(alternative.share / shares, *weight);
        if alternative.chosen {
            check_close(connection.weight, *weight);
        }
    }
    // however the path comes about, it counts once
    check_close(weights.iter().map(|(_, weight)| weight).sum(), 1.0);

    // L = Φ'·ρ/π · G · ρ'/π·β · w, with 1/(4π) at the light and d²/(A·cos θ) of the pixel at the eye
    let sent = match connection.light_vertex {
        0 => from.carries / (4.0 * PI),
        _ => from.carries * from.albedo / PI,
    };
    let received = match connection.eye_vertex {
        0 => DVec3::splat(by_window_area(scene, (from.point - to.point).normalize())),
        _ => to.carries * to.albedo / PI,
    };
    let expected = sent * received * chain.geometry(chain.line) * connection.weight;
    for channel in 0..3 {
        check_close(connection.contribution[channel], expected[channel]);
    }

    seen.connections += 1;
    seen.to_eye += u32::from(connection.eye_vertex == 0);
    seen.from_light += u32::from(connection.light_vertex == 0);
    seen.with_choice += u32::from(2 <= edges.len());
    seen.over_mirror_or_glass += u32::from(chain.vertices.iter().any(|vertex| vertex.passes));
}

#[track_caller]
fn check_close(found: f64, expected: f64) {
    let off = (found - expected).abs();
    assert!(
        off <= ROUNDING * expected.abs(),
        "{found} instead of {expected}"
    );
}

/// Each connection in some records, with the alternatives that come before it; what cannot be seen has none.
fn connections(records: &[Record]) -> Vec<(Vec<Alternative>, Connection)> {
    let mut alternatives = Vec::new();
    let mut found = Vec::new();
    for record in records {
        match record.event {
            Event::Alternative(alternative) => alternatives.push(alternative),
            Event::Connection(connection) => {
                found.push((std::mem::take(&mut alternatives), connection));
            }
            _ => {}
        }
    }
    assert!(alternatives.is_empty(), "alternatives without a connection");
    found
}

fn connected() -> Settings {
    let options = LightOptions {
        seed: 9,
        samples: SAMPLES,
        bounces: Some(7),
        ..LightOptions::default()
    };
    settings(Transport::HybridConnected, options)
}

#[test]
fn every_weight_is_the_chance_of_its_line_among_all_lines_that_make_the_same_path() {
    let scene = scene();
    let settings = connected();
    let strategy = Exhaustive::new(&scene);
    let (light_pass, _) = light_pass::<Off>(&scene, &settings);
    let tracer = Tracer::new(&scene, &strategy, settings.transport).with_light(Some(&light_pass));
    let pixels = PIXELS[0] * PIXELS[1];
    let mut colours = vec![DVec3::ZERO; pixels as usize];
    let eye_alone = end(scene.camera.cop, DVec3::ONE);
    let mut seen = Seen::default();

    // the paths of light, with their lines to the eye
    let mut lit = Vec::new();
    for path in 0..pixels * SAMPLES {
        let mut recording = Recording::new(Vec::new());
        tracer.trace_path(path, &mut recording).unwrap();
        let records = recording.into_sink();
        let Event::Path(start) = records[0].event else {
            panic!("{:?} before the path", records[0]);
        };
        check_close(
            start.power.x * f64::from(pixels * SAMPLES),
            POWER[0] + POWER[1],
        );
        let light = &scene.lights[start.light as usize];
        assert_eq!(light.emission, Emission::Power(POWER[start.light as usize]));
        let mut vertices = vec![end(light.position, start.power)];
        add_surfaces(&scene, &records, &mut vertices);
        for (alternatives, connection) in connections(&records) {
            let pixel = connection.pixel.unwrap();
            if !connection.visible {
                assert_eq!((alternatives.len(), connection.weight), (0, 0.0));
                assert_eq!(connection.contribution, DVec3::ZERO);
                continue;
            }
            let chain = Chain::new(&vertices, &[eye_alone], &connection);
            check_connection(&scene, &chain, &alternatives, &connection, &mut seen);
            colours[(pixel[1] * PIXELS[0] + pixel[0]) as usize] += connection.contribution;
        }
        lit.push(vertices);
    }

    for place in 0..pixels {
        let pixel = [place % PIXELS[0], place / PIXELS[0]];
        let mut recording = Recording::new(Vec::new());
        let colour = trace_pixel(&tracer, pixel, Through::Centres, &mut recording).unwrap();
        let records = recording.into_sink();
        let is_start = |record: &Record| matches!(record.event, Event::Pixel(_));
        let starts: Vec<usize> = (0..records.len())
            .filter(|&i| is_start(&records[i]))
            .collect();
        assert_eq!(starts.len(), SAMPLES as usize);
        let mut sum = colours[place as usize];
        for (sample, &first) in starts.iter().enumerate() {
            let last = starts.get(sample + 1).copied().unwrap_or(records.len());
            let records = &records[first..last];
            let mut eye = vec![eye_alone];
            add_surfaces(&scene, records, &mut eye);
            for (alternatives, connection) in connections(records) {
                assert_eq!(connection.path, place * SAMPLES + sample as u32);
                if !connection.visible {
                    assert_eq!((alternatives.len(), connection.weight), (0, 0.0));
                    continue;
                }
                let chain = Chain::new(&lit[connection.path as usize], &eye, &connection);
                check_connection(&scene, &chain, &alternatives, &connection, &mut seen);
                // of all paths the pixel has those of its own samples
                sum += connection.contribution * f64::from(pixels);
            }
        }
        assert!((colour - sum).abs().max_element() <= ROUNDING * sum.max_element());
    }

    // enough of each case
    assert!(1000 <= seen.connections, "{seen:?}");
    assert!(50 <= seen.to_eye.min(seen.from_light), "{seen:?}");
    assert!(
        100 <= seen.over_mirror_or_glass.min(seen.with_choice),
        "{seen:?}"
    );
}

#[test]
fn a_line_is_drawn_wherever_two_surfaces_that_scatter_face_each_other_and_nowhere_else() {
    let scene = scene();
    let settings = connected();
    let strategy = Exhaustive::new(&scene);
    let (light_pass, _) = light_pass::<Off>(&scene, &settings);
    let tracer = Tracer::new(&scene, &strategy, settings.transport).with_light(Some(&light_pass));
    let eye = end(scene.camera.cop, DVec3::ONE);
    let mut drawn = 0;
    for path in 0..PIXELS[0] * PIXELS[1] * SAMPLES {
        let mut recording = Recording::new(Vec::new());
        tracer.trace_path(path, &mut recording).unwrap();
        let records = recording.into_sink();
        let Event::Path(start) = records[0].event else {
            panic!("{:?} before the path", records[0]);
        };
        let position = scene.lights[start.light as usize].position;
        let mut vertices = vec![end(position, start.power)];
        add_surfaces(&scene, &records, &mut vertices);
        let lines: Vec<u16> = connections(&records)
            .iter()
            .map(|(_, connection)| connection.light_vertex)
            .collect();
        // every surface here scatters in part; a line to the eye must pass the window from behind
        let expected: Vec<u16> = (1..vertices.len())
            .filter(|&i| {
                let to_eye = eye.point - vertices[i].point;
                let faces = vertices[i]
                    .normal
                    .is_some_and(|normal| 0.0 < normal.dot(to_eye));
                faces && through_window(&scene, -to_eye.normalize())
            })
            .map(|i| i as u16)
            .collect();
        assert_eq!(lines, expected);
        drawn += lines.len();
    }
    assert!(100 <= drawn, "{drawn}");
}

/// Does a ray from the eye pass the window? Solved for t·direction = corner + α·right + β·up by Cramer's rule.
fn through_window(scene: &Scene, direction: DVec3) -> bool {
    let camera = &scene.camera;
    let det = |a: DVec3, b: DVec3, c: DVec3| a.cross(b).dot(c);
    let [right, up, corner] = [camera.right, camera.up, camera.to_corner];
    // t·direction − α·right − β·up = corner
    let below = det(direction, -right, -up);
    let t = det(corner, -right, -up) / below;
    let alpha = det(direction, corner, -up) / below;
    let beta = det(direction, -right, corner) / below;
    0.0 < t && (0.0..1.0).contains(&alpha) && 0.0 < beta && beta <= 1.0
}
