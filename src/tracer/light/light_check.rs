//! What a scene and its settings must be for light to be followed.

use glam::DVec3;

use crate::geometry::{Ray, Sides, TRange};
use crate::scene::{Emission, LARGEST, Light, Object, PrimitiveId, Scene, Shape};
use crate::strategy::{Strategy, test_primitive};
use crate::trace::{Counts, Off, Purpose, Settings, Transport};
use crate::tracer::light::hybrid_stored::bytes_per_photon;
use crate::tracer::light::illumination_map::BYTES_PER_CELL;
use crate::tracer::light::lamps::Lamps;
use crate::tracer::light::lamps::MOST_SURFACES;
use crate::tracer::light::light_error::{LightError, LightSetting};
use crate::tracer::light::walk::NoWatcher;
use crate::tracer::tracer::Tracer;

/// The most paths of light: their numbers have 32 bits.
const MOST_PATHS: u64 = u32::MAX as u64;

/// The most memory that stored photons may take.
const MOST_BYTES: f64 = 8.0 * 1024.0 * 1024.0 * 1024.0;

/// The most cells along a side of an illumination map.
const MOST_CELLS: u32 = 4096;

/// The most memory that all illumination maps together may take.
const MOST_MAP_BYTES: f64 = 2.0 * 1024.0 * 1024.0 * 1024.0;

/// How many paths are followed to find out whether they end, and how much memory all of them would take.
const PROBE: u32 = 64;

/// Rounding of coefficients that are meant to add up to 1.
const ROUNDING: f64 = 1e-12;

/// Asks whether light can be followed as the settings say; a transport that follows none asks for nothing. The
/// notes say what of the scene such a transport does not look at.
///
/// # Errors
/// The first thing that stands against it.
pub fn check_light<S: Strategy>(
    scene: &Scene,
    strategy: &S,
    settings: &Settings,
) -> Result<Vec<String>, LightError> {
    if !settings.transport.follows_light() {
        return Ok(Vec::new());
    }
    check_numbers(scene, settings)?;
    if scene.lights.is_empty() {
        return Err(LightError::NoLights);
    }
    for (number, light) in scene.lights.iter().enumerate() {
        if let Emission::Colour(_) = light.emission {
            let light = light.name.clone();
            return Err(LightError::NoPower { number, light });
        }
    }
    for (name, material) in &scene.materials.0 {
        let brightest = DVec3::from(material.colour).max_element();
        let sum = brightest * material.diffuse + material.reflection + material.transmission;
        if 1.0 + ROUNDING < sum {
            let material = name.clone();
            return Err(LightError::Albedo { material, sum });
        }
    }
    let mut notes = Vec::new();
    for light in &scene.lights {
        for object in &scene.objects {
            notes.extend(check_inside(scene, light, object)?);
        }
    }
    check_amount(scene, strategy, settings)?;
    notes.extend(left_out(scene, settings));
    Ok(notes)
}

fn check_numbers(scene: &Scene, settings: &Settings) -> Result<(), LightError> {
    let options = &settings.light;
    if settings.light_paths(scene.camera.pixels) == 0 {
        let setting = setting_of_paths(settings);
        return Err(LightError::NoPaths { setting });
    }
    let within = |setting, must, holds: bool| {
        if holds {
            Ok(())
        } else {
            Err(LightError::OutOfRange { setting, must })
        }
    };
    // as large as any length of a scene: its square is still a number
    let holds = (0.0..=LARGEST).contains(&options.aperture.unwrap_or(0.0));
    within(
        LightSetting::Aperture,
        "a radius of 0 or more, at most 1e50",
        holds,
    )?;
    let holds = 1 <= options.bounces.unwrap_or(1);
    within(
        LightSetting::Bounces,
        "a number of surfaces of at least 1",
        holds,
    )?;
    let must = "at least 2, since k - 1 of k photons are summed";
    within(LightSetting::Nearest, must, 2 <= options.nearest)?;
    let holds = (1..=MOST_CELLS).contains(&options.map.unwrap_or(1));
    within(LightSetting::Map, "a number of cells from 1 to 4096", holds)?;
    options.map.map_or(Ok(()), |cells| check_maps(scene, cells))
}

/// Do the maps of all flat faces fit into memory? Light may fall on both sides of each.
fn check_maps(scene: &Scene, cells: u32) -> Result<(), LightError> {
    let faces = |object: &Object| match &scene.primitive(object.first).shape {
        Shape::Polygon(_) if !object.is_mesh => 1,
        Shape::Box(_) => 6,
        _ => 0,
    };
    let sides = 2 * scene.objects.iter().map(faces).sum::<u64>();
    let bytes_at = |along: f64| sides as f64 * along * along * BYTES_PER_CELL as f64;
    let bytes = bytes_at(f64::from(cells));
    if bytes <= MOST_MAP_BYTES {
        return Ok(());
    }
    let most = (MOST_MAP_BYTES / bytes_at(1.0)).sqrt() as u32;
    Err(LightError::TooManyCells {
        cells,
        sides,
        bytes,
        most,
    })
}

fn setting_of_paths(settings: &Settings) -> LightSetting {
    match settings.transport {
        Transport::HybridConnected => LightSetting::Samples,
        _ => LightSetting::Paths,
    }
}

/// A light in an opaque object whose inside nothing shows is a mistake; one that stays inside is worth a note.
fn check_inside(
    scene: &Scene,
    light: &Light,
    object: &Object,
) -> Result<Option<String>, LightError> {
    let material = &scene.materials.0[object.material as usize].1;
    if 0.0 < material.transmission || !is_inside(scene, light.position, object) {
        return Ok(None);
    }
    let (light, name) = (light.name.clone(), object.name.clone());
    match scene.primitive(object.first).sides {
        Sides::Front => Err(LightError::Inside {
            light,
            object: name.into(),
        }),
        Sides::Back => Ok(None),
        // a room that the eye is in as well
        Sides::Both if is_inside(scene, scene.camera.cop, object) => Ok(None),
        Sides::Both => Ok(Some(format!(
            "the light {light:?} is inside {name:?}, which is opaque: none of its light reaches the eye"
        ))),
    }
}

/// Is the point inside a solid? Cones are open, and a single polygon encloses nothing.
fn is_inside(scene: &Scene, point: DVec3, object: &Object) -> bool {
    if object.is_mesh {
        return is_inside_mesh(scene, point, object);
    }
    match &scene.primitive(object.first).shape {
        Shape::Sphere(sphere) => point.distance(sphere.center) < sphere.radius,
        Shape::Ellipsoid(egg) => ((point - egg.center) / egg.radii).length() < 1.0,
        Shape::Box(solid) => solid.min.cmplt(point).all() && point.cmplt(solid.max).all(),
        Shape::Cone(_) | Shape::Polygon(_) => false,
    }
}

/// A ray from a point inside meets an odd number of the faces, if they enclose anything.
fn is_inside_mesh(scene: &Scene, point: DVec3, object: &Object) -> bool {
    // along no axis and no diagonal, so that it passes between the vertices of what people model
    let ray = Ray::new(point, DVec3::new(0.4364, 0.5531, 0.7097).normalize());
    let first = object.first.0;
    let met = (first..first + object.count).filter(|&face| {
        let id = PrimitiveId(face);
        let mut face = scene.primitive(id).clone();
        face.sides = Sides::Both;
        test_primitive(id, &face, &ray, TRange::FORWARD, &mut Off).is_some()
    });
    met.count() % 2 == 1
}

/// Follows some paths to find out whether they end, and how much memory all of them would take.
fn check_amount<S: Strategy>(
    scene: &Scene,
    strategy: &S,
    settings: &Settings,
) -> Result<(), LightError> {
    let paths = settings.light_paths(scene.camera.pixels);
    let tracer = Tracer::new(scene, strategy, settings.transport);
    let lamps = Lamps::new(scene, settings);
    let mut counts = Counts::default();
    for path in 0..PROBE {
        let followed = tracer.follow_light(&lamps, path, &mut NoWatcher, &mut counts);
        if followed.is_break() {
            break;
        }
        if 0 < counts.light.cut_off && settings.light.bounces.is_none() {
            let surfaces = MOST_SURFACES;
            return Err(LightError::Endless { surfaces });
        }
    }
    let share = paths as f64 / f64::from(PROBE);
    let bytes = match settings.transport {
        Transport::HybridStored => {
            counts.of(Purpose::Light).hits as f64 * share * bytes_per_photon()
        }
        _ => 0.0,
    };
    if paths <= MOST_PATHS && bytes <= MOST_BYTES {
        return Ok(());
    }
    let by_memory = if bytes == 0.0 {
        f64::INFINITY
    } else {
        MOST_BYTES / bytes * paths as f64
    };
    let most = MOST_PATHS.min(by_memory as u64);
    let for_each = match settings.transport {
        Transport::HybridConnected => paths / u64::from(settings.light.samples),
        _ => 1,
    };
    Err(LightError::TooMany {
        paths,
        setting: setting_of_paths(settings),
        bytes,
        most: most / for_each,
    })
}

/// What of a scene a transport that follows light does not look at.
fn left_out(scene: &Scene, settings: &Settings) -> Vec<String> {
    let mut notes = Vec::new();
    if scene.ambient != DVec3::ZERO || scene.background != DVec3::ZERO {
        notes.push(
            "the ambient light and the background are ignored: only the light of the lights is traced"
                .into(),
        );
    }
    if settings.transport == Transport::Forward
        && settings.light.aperture_radius(&scene.camera).powi(2) == 0.0
    {
        notes.push(
            "the eye is a pinhole, with aperture 0: no photon passes through a point, so the \
             picture is black; an aperture gives the eye a radius"
                .into(),
        );
    }
    notes
}

#[cfg(test)]
mod tests {
    use std::slice::from_ref;

    use super::*;
    use crate::scene::small_scene::{object, one_pixel, polygon, scene_from, solid, sphere};
    use crate::strategy::Exhaustive;

    /// The faces of a cube from (0, 0, 0) to (2, 2, 2), as a mesh.
    fn cube_of_faces() -> String {
        let corner = |i: usize| [0, 1, 2].map(|axis| if i >> axis & 1 == 1 { 2.0 } else { 0.0 });
        // the corners of each face in a ring, outwards
        let faces = [
            [0, 4, 6, 2],
            [1, 3, 7, 5],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 2, 3, 1],
            [4, 5, 7, 6],
        ];
        let face = |ring: [usize; 4]| format!(r#"{{"vertices":{:?}}}"#, ring.map(corner));
        format!(r#"{{"mesh":{{"faces":[{}]}}}}"#, faces.map(face).join(","))
    }

    #[test]
    fn a_point_is_inside_a_solid_and_never_inside_what_is_open() {
        let inside = |shape: &str, point: [f64; 3]| {
            let scene = one_pixel(&format!(
                r#""materials":{{"m":{{"colour":[1,1,1]}}}},"objects":[{},{}]"#,
                object("other", "m", &sphere([50.0, 0.0, 0.0], 1.0)),
                object("object", "m", shape)
            ));
            is_inside(&scene, point.into(), &scene.objects[1])
        };
        let ball = sphere([1.0, 2.0, 3.0], 2.0);
        assert!(inside(&ball, [1.0, 2.0, 4.9]) && !inside(&ball, [1.0, 2.0, 5.0]));
        let egg = r#"{"ellipsoid":{"center":[1,2,3],"radii":[1,4,2]}}"#;
        assert!(inside(egg, [1.0, 5.9, 3.0]) && !inside(egg, [2.0, 2.0, 3.0]));
        // (0.6)² + (0.8)² is 1 just at 2.4 of 4 and 1.6 of 2
        assert!(inside(egg, [1.0, 4.3, 4.6]) && !inside(egg, [1.0, 4.5, 4.6]));
        let cuboid = solid([1.0, 2.0, 3.0], [3.0, 6.0, 7.0]);
        assert!(inside(&cuboid, [2.9, 2.1, 6.9]));
        for outside in [[3.0, 4.0, 5.0], [2.0, 2.0, 5.0], [2.0, 4.0, 7.1]] {
            assert!(!inside(&cuboid, outside));
        }
        let faces = cube_of_faces();
        assert!(inside(&faces, [0.5, 1.0, 1.5]) && inside(&faces, [1.9, 0.1, 0.1]));
        for outside in [[-1.0, 1.0, 1.0], [1.0, 1.0, 3.0], [-0.5, -0.5, -0.6]] {
            assert!(!inside(&faces, outside), "{outside:?}");
        }
        let cone = r#"{"cone":{"base":[0,0,0],"base_radius":5,"apex":[0,5,0],"apex_radius":5}}"#;
        assert!(!inside(cone, [0.0, 1.0, 0.0]));
        assert!(!inside(
            &polygon(&[[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]]),
            [1.0, 1.0, 0.0]
        ));
    }

    const WHITE: &str = r#"{"colour":[1,1,1],"diffuse":0.5}"#;

    /// What is said of a scene with this material, a lamp and an object.
    fn checked(
        material: &str,
        lamp: &str,
        shape: &str,
        change: impl FnOnce(&mut Settings),
    ) -> Result<Vec<String>, LightError> {
        let scene = one_pixel(&format!(
            r#""materials":{{"m":{material}}},"lights":[{lamp}],"objects":[{}]"#,
            object("object", "m", shape)
        ));
        let strategy = Exhaustive::new(&scene);
        let mut settings = Settings {
            transport: Transport::HybridStored,
            ..Settings::default()
        };
        change(&mut settings);
        check_light(&scene, &strategy, &settings)
    }

    const LAMP: &str = r#"{"name":"lamp","position":[0,0,-3],"power":12}"#;

    fn ball() -> String {
        sphere([0.0, 0.0, -9.0], 2.0)
    }

    fn usual(material: &str) -> Result<Vec<String>, LightError> {
        checked(material, LAMP, &ball(), |_| {})
    }

    #[test]
    fn a_scene_whose_lamps_have_powers_and_whose_surfaces_add_no_light_is_followed() {
        assert_eq!(usual(WHITE), Ok(vec![]));
        assert_eq!(
            checked(WHITE, "", &ball(), |_| {}),
            Err(LightError::NoLights)
        );
        let coloured = r#"{"name":"lamp","position":[0,0,-3],"colour":[1,1,1]}"#;
        let no_power = LightError::NoPower {
            number: 0,
            light: "lamp".into(),
        };
        assert_eq!(checked(WHITE, coloured, &ball(), |_| {}), Err(no_power));
        // a transport that follows none asks for nothing
        let by_eye = |settings: &mut Settings| settings.transport = Transport::HybridLight;
        assert_eq!(checked(WHITE, "", &ball(), by_eye), Ok(vec![]));
    }

    #[test]
    fn the_brightest_channel_with_reflection_and_transmission_is_at_most_1() {
        let material = |diffuse: f64| {
            format!(
                r#"{{"colour":[0.5,0.8,0],"diffuse":{diffuse},"reflection":0.25,"transmission":0.25}}"#
            )
        };
        // 0.8·0.625 + 0.25 + 0.25 = 1
        assert_eq!(usual(&material(0.625)), Ok(vec![]));
        match usual(&material(0.75)) {
            Err(LightError::Albedo { material, sum }) => {
                assert_eq!(material, "m");
                assert!((sum - 1.1).abs() <= 1e-15, "{sum}");
            }
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_lamp_in_an_opaque_solid_is_a_mistake_if_that_shows_its_front_alone() {
        let around = |sides: &str| {
            let scene = one_pixel(&format!(
                r#""materials":{{"m":{WHITE}}},"lights":[{LAMP}],
                "objects":[{{"name":"ball","material":"m","sides":"{sides}","shape":{}}}]"#,
                sphere([0.0, 0.0, -3.0], 1.0)
            ));
            check_inside(&scene, &scene.lights[0], &scene.objects[0])
        };
        let inside = LightError::Inside {
            light: "lamp".into(),
            object: "ball".into(),
        };
        assert_eq!(around("front"), Err(inside));
        assert_eq!(around("back"), Ok(None));
        assert!(around("both").unwrap().unwrap().contains("is inside"));
        // a room that the eye is in as well; glass; and a lamp outside
        let room = sphere([0.0, 0.0, -3.0], 4.0);
        assert_eq!(
            checked(WHITE, LAMP, &room, |settings| settings.light.bounces =
                Some(3)),
            Ok(vec![])
        );
        let glass = r#"{"colour":[0,0,0],"transmission":0.5}"#;
        assert_eq!(
            checked(glass, LAMP, &sphere([0.0, 0.0, -3.0], 1.0), |_| {}),
            Ok(vec![])
        );
    }

    #[test]
    fn numbers_out_of_their_range_are_refused_and_those_at_its_ends_are_not() {
        let refused = |change: fn(&mut Settings)| match checked(WHITE, LAMP, &ball(), change) {
            Ok(_) => "",
            Err(LightError::OutOfRange { setting, .. } | LightError::NoPaths { setting }) => {
                setting.name()
            }
            Err(other) => panic!("{other:?}"),
        };
        assert_eq!(refused(|of| of.light.paths = 0), "paths");
        assert_eq!(refused(|of| of.light.paths = 1), "");
        assert_eq!(refused(|of| of.light.aperture = Some(-0.1)), "aperture");
        assert_eq!(refused(|of| of.light.aperture = Some(0.0)), "");
        assert_eq!(refused(|of| of.light.bounces = Some(0)), "bounces");
        assert_eq!(refused(|of| of.light.bounces = Some(1)), "");
        assert_eq!(refused(|of| of.light.nearest = 1), "nearest");
        assert_eq!(refused(|of| of.light.nearest = 2), "");
        assert_eq!(refused(|of| of.light.map = Some(0)), "map");
        assert_eq!(refused(|of| of.light.map = Some(4097)), "map");
        assert_eq!(refused(|of| of.light.map = Some(4096)), "");
        let no_samples = |of: &mut Settings| {
            of.transport = Transport::HybridConnected;
            of.light.samples = 0;
        };
        assert_eq!(refused(no_samples), "samples");
    }

    #[test]
    fn maps_on_both_sides_of_all_flat_faces_fit_into_2_gigabytes() {
        let of = |shapes: &[String], cells: u32| {
            let objects: Vec<_> = shapes
                .iter()
                .enumerate()
                .map(|(i, shape)| object(&i.to_string(), "m", shape))
                .collect();
            let scene = one_pixel(&format!(
                r#""materials":{{"m":{WHITE}}},"objects":[{}]"#,
                objects.join(",")
            ));
            check_maps(&scene, cells)
        };
        // a cell takes 32 bytes, so 2³¹ bytes hold 2²⁶ cells: of 2 sides 5792² each
        assert_eq!(BYTES_PER_CELL, 32);
        let triangle = polygon(&[[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]]);
        assert_eq!(of(from_ref(&triangle), 5792), Ok(()));
        let too_many = |cells: u32, sides: u64, most: u32| {
            let bytes = sides as f64 * f64::from(cells) * f64::from(cells) * 32.0;
            Err(LightError::TooManyCells {
                cells,
                sides,
                bytes,
                most,
            })
        };
        assert_eq!(of(from_ref(&triangle), 5793), too_many(5793, 2, 5792));
        // a box has six faces, a ball and a mesh none that are flat
        let shapes = [triangle, solid([0.0; 3], [1.0; 3]), ball(), cube_of_faces()];
        assert_eq!(of(&shapes, 4096), too_many(4096, 14, 2189));
        assert_eq!(of(&shapes[2..], 1 << 20), Ok(()));
    }

    #[test]
    fn paths_beyond_32_bits_or_8_gigabytes_are_too_many() {
        let beside = sphere([0.0, 500.0, 0.0], 1.0);
        let of = |paths| checked(WHITE, LAMP, &beside, |of| of.light.paths = paths);
        // hardly a photon hits the ball: the numbers' 32 bits are the limit
        assert_eq!(of(u64::from(u32::MAX)), Ok(vec![]));
        match of(1 << 32) {
            Err(LightError::TooMany {
                paths,
                setting,
                most,
                bytes,
                ..
            }) => {
                assert_eq!(
                    (paths, setting, most),
                    (1 << 32, LightSetting::Paths, u64::from(u32::MAX))
                );
                assert_eq!(bytes, 0.0);
            }
            other => panic!("{other:?}"),
        }
        // in a black room each path stores one photon
        let black = r#"{"colour":[0.001,0,0],"diffuse":1}"#;
        let room = sphere([0.0; 3], 9.0);
        let of = |paths| checked(black, LAMP, &room, |of| of.light.paths = paths);
        let most = match of(u64::from(u32::MAX)) {
            Err(LightError::TooMany { most, bytes, .. }) => {
                let each = bytes / f64::from(u32::MAX);
                assert!(
                    (bytes_per_photon()..1.1 * bytes_per_photon()).contains(&each),
                    "{each}"
                );
                most
            }
            other => panic!("{other:?}"),
        };
        assert!(of(most).is_ok() && of(most + most / 1000).is_err());
    }

    #[test]
    fn samples_are_limited_by_the_paths_of_all_pixels() {
        // four pixels: a fourth of 2³² − 1 for each
        let scene = scene_from(
            r#"{"camera":{"window":{"cop":[0,0,0],"corner":[-1,-1,-1],"right":[2,0,0],"up":[0,2,0]},
            "pixels":[2,2]},"lights":[{"position":[0,0,-3],"power":12}],"objects":[]}"#,
        );
        let strategy = Exhaustive::new(&scene);
        let check = |samples: u32| {
            let mut settings = Settings {
                transport: Transport::HybridConnected,
                ..Settings::default()
            };
            settings.light.samples = samples;
            check_light(&scene, &strategy, &settings)
        };
        assert_eq!(check(u32::MAX / 4), Ok(vec![]));
        match check(u32::MAX / 4 + 1) {
            Err(LightError::TooMany { setting, most, .. }) => {
                assert_eq!(
                    (setting, most),
                    (LightSetting::Samples, u64::from(u32::MAX / 4))
                );
            }
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn light_between_surfaces_that_absorb_nothing_is_endless_unless_bounces_end_it() {
        let mirrors = r#"{"colour":[1,1,1],"reflection":1}"#;
        let room = sphere([0.0; 3], 9.0);
        let endless = LightError::Endless {
            surfaces: MOST_SURFACES,
        };
        assert_eq!(checked(mirrors, LAMP, &room, |_| {}), Err(endless));
        assert_eq!(
            checked(mirrors, LAMP, &room, |of| of.light.bounces = Some(20)),
            Ok(vec![])
        );
    }

    #[test]
    fn notes_say_what_of_the_scene_is_left_out() {
        let notes = |keys: &str, transport, aperture| {
            let scene = one_pixel(&format!(r#"{keys}"objects":[]"#));
            let mut settings = Settings {
                transport,
                ..Settings::default()
            };
            settings.light.aperture = aperture;
            left_out(&scene, &settings).len()
        };
        assert_eq!(notes("", Transport::HybridStored, None), 0);
        assert_eq!(
            notes(r#""ambient":[0,0.1,0],"#, Transport::HybridStored, None),
            1
        );
        assert_eq!(
            notes(r#""background":[0,0.1,0],"#, Transport::HybridStored, None),
            1
        );
        assert_eq!(notes("", Transport::Forward, Some(0.0)), 1);
        assert_eq!(notes("", Transport::Forward, Some(0.1)), 0);
        assert_eq!(notes("", Transport::HybridStored, Some(0.0)), 0);
        assert_eq!(
            notes(r#""ambient":[1,1,1],"#, Transport::Forward, Some(0.0)),
            2
        );
    }
}
