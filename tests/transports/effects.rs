//! Which kind sees which effect: the table of `raystep::tracer`, row by row.
//!
//! Each effect is alone in its scene: the picture is black if the kind does not see it. Those that see it see
//! comparable amounts of it, so that one stray photon does not pass for an effect. How well they agree is asked elsewhere.

use raystep::strategy::Exhaustive;
use raystep::tracer::{LightPass, check_light, render};
use raystep::{NoFiles, Off, Scene, Settings, Through, Tracer, Transport, load_bytes};

/// A lamp beside a table, which is lit from above, over a floor. The table's underside faces away from the lamp:
/// light comes to it from the floor alone.
fn scene(floor: &str, sight: &str, lamp: &str) -> Scene {
    let json = format!(
        r#"{{
        "camera": {{ "look_at": {{ {sight}, "up": [0, 1, 0.01], "fov_degrees": 20 }}, "pixels": [3, 3] }},
        "background": [0, 0, 0], "ambient": [0, 0, 0],
        "lights": [ {{ "position": {lamp}, "power": 100 }} ],
        "materials": {{ "white": {{ "colour": [1, 1, 1], "diffuse": 0.9 }},
                        "mirror": {{ "colour": [1, 1, 1], "reflection": 0.9, "diffuse": 0 }},
                        "black": {{ "colour": [0, 0, 0], "diffuse": 0 }} }},
        "objects": [
            {{ "name": "table", "material": "white",
               "shape": {{ "box": {{ "min": [-0.5, 1, -0.5], "max": [0.5, 1.1, 0.5] }} }} }},
            {{ "name": "floor", "material": "{floor}",
               "shape": {{ "polygon": {{ "vertices": [[-4, 0, -4], [-4, 0, 4], [4, 0, 4], [4, 0, -4]] }} }} }}
        ] }}"#
    );
    let loaded = load_bytes("scene.json", json.as_bytes(), &NoFiles).unwrap();
    loaded.build().unwrap()
}

const BESIDE: &str = "[3, 2, 0]";

/// The mean over the picture and its channels.
fn brightness(scene: &Scene, transport: Transport) -> f64 {
    let mut settings = Settings {
        transport,
        ..Settings::default()
    };
    // an eye wide enough that some photons arrive, and photons close enough to tell light from shadow
    settings.light.paths = 200_000;
    settings.light.aperture = Some(0.3);
    settings.light.nearest = 8;
    settings.light.samples = 4000;
    let strategy = Exhaustive::new(scene);
    check_light(scene, &strategy, &settings).unwrap();
    let pass = LightPass::new(scene, &strategy, &settings, None, |_: Off| {}, |_| {}).unwrap();
    let tracer = Tracer::new(scene, &strategy, transport).with_light(pass.as_ref());
    let (picture, _) = render::<_, Off>(&tracer, Through::Centres, |_| {}).unwrap();
    let sum: f64 = picture
        .colours
        .iter()
        .map(|colour| colour.element_sum())
        .sum();
    sum / (3.0 * picture.colours.len() as f64)
}

/// How much less one kind may see than another. Forward and hybrid-stored blur, and lose some of the light at the edge of
/// what is lit; over a mirror some kinds also see the light that came by the mirror to the surface in it.
const LEAST: f64 = 0.25;

/// In the order of the table: backward, hybrid-light, forward, hybrid-stored, hybrid-connected.
#[track_caller]
fn check(scene: &Scene, expected: [bool; 5]) {
    let kinds = [
        Transport::Backward,
        Transport::HybridLight,
        Transport::Forward,
        Transport::HybridStored,
        Transport::HybridConnected,
    ];
    let found = kinds.map(|kind| brightness(scene, kind));
    let most = found.into_iter().fold(0.0, f64::max);
    for ((kind, found), sees) in kinds.iter().zip(found).zip(expected) {
        if sees {
            assert!(LEAST * most <= found, "{kind:?}: {found} of {most}");
        } else {
            assert_eq!(found, 0.0, "{kind:?}");
        }
    }
    assert_eq!(0.0 < most, expected.contains(&true));
}

#[test]
fn direct_light_is_seen_by_all() {
    let from_above = r#""cop": [0, 4, 0], "target": [0, 1, 0]"#;
    check(&scene("black", from_above, BESIDE), [true; 5]);
}

#[test]
fn only_backward_sees_no_shadow() {
    // straight below the table, lit by a lamp straight above it; the table keeps its light to itself
    let from_the_side = r#""cop": [2, 0.5, 0], "target": [0, 0, 0]"#;
    let below = scene("white", from_the_side, "[0, 2, 0]");
    let direct_only = |transport| {
        // with one surface on each path, what the floor around sends there is left out
        let mut settings = Settings {
            transport,
            ..Settings::default()
        };
        settings.light.bounces = Some(1);
        settings.light.nearest = 8;
        settings.light.aperture = Some(0.15);
        let strategy = Exhaustive::new(&below);
        let pass = LightPass::new(&below, &strategy, &settings, None, |_: Off| {}, |_| {}).unwrap();
        let tracer = Tracer::new(&below, &strategy, transport).with_light(pass.as_ref());
        let (picture, _) = render::<_, Off>(&tracer, Through::Centres, |_| {}).unwrap();
        picture.colours[4].element_sum()
    };
    assert!(0.0 < direct_only(Transport::Backward));
    for transport in [
        Transport::HybridLight,
        Transport::Forward,
        Transport::HybridConnected,
    ] {
        assert_eq!(direct_only(transport), 0.0, "{transport:?}");
    }
    // the nearest photons lie around the shadow: a little light comes in with them, by far not what is outside
    let lit = scene(
        "white",
        r#""cop": [3.5, 0.5, 0], "target": [1.6, 0, 0]"#,
        "[0, 2, 0]",
    );
    assert!(0.0 < brightness(&lit, Transport::HybridStored));
    assert!(direct_only(Transport::HybridStored) < 0.5 * direct_only(Transport::Backward));
}

#[test]
fn the_mirror_image_of_a_lit_surface_is_seen_by_all() {
    // a lamp below the table: its underside is lit, and seen in the floor
    let down = r#""cop": [0, 0.5, 2], "target": [0, 0, 1.33]"#;
    check(&scene("mirror", down, "[2, 0.5, 0]"), [true; 5]);
}

#[test]
fn indirect_diffuse_light_is_seen_by_those_that_follow_light() {
    let up = r#""cop": [0, 0.4, 1.2], "target": [0, 1, 0.2]"#;
    check(
        &scene("white", up, BESIDE),
        [false, false, true, true, true],
    );
}

#[test]
fn a_caustic_is_seen_by_those_that_follow_light() {
    let up = r#""cop": [0, 0.4, 1.2], "target": [0, 1, 0.2]"#;
    check(
        &scene("mirror", up, BESIDE),
        [false, false, true, true, true],
    );
}

#[test]
fn the_mirror_image_of_a_caustic_is_beyond_connecting_lines() {
    let down = r#""cop": [0, 0.5, 2], "target": [0, 0, 1.33]"#;
    check(
        &scene("mirror", down, BESIDE),
        [false, false, true, true, false],
    );
}

#[test]
fn the_lamp_itself_is_seen_by_none() {
    let at_the_lamp = r#""cop": [0, 2, 6], "target": [3, 2, 0]"#;
    check(&scene("black", at_the_lamp, BESIDE), [false; 5]);
    let in_the_mirror = r#""cop": [0, 2, 3], "target": [1.5, 0, 1.5]"#;
    check(&scene("mirror", in_the_mirror, BESIDE), [false; 5]);
}
