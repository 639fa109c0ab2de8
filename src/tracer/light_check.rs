//! What a scene and its settings must be for light to be followed.

use std::time::{Duration, Instant};

use glam::DVec3;

use crate::geometry::{Ray, Sides, TRange};
use crate::scene::{Emission, LARGEST, Light, Object, PrimitiveId, Scene, Shape};
use crate::strategy::{Strategy, test_primitive};
use crate::trace::{Counts, Off, Purpose, Settings, Transport};
use crate::tracer::hybrid_stored::bytes_per_photon;
use crate::tracer::illumination_map::BYTES_PER_CELL;
use crate::tracer::light_path::Lamps;
use crate::tracer::walk::{MOST_SURFACES, NoWatcher};
use crate::tracer::{LightError, Tracer};

/// The most paths of light: their numbers have 32 bits.
const MOST_PATHS: u64 = u32::MAX as u64;

/// The most memory that stored photons may take.
const MOST_BYTES: f64 = 8.0 * 1024.0 * 1024.0 * 1024.0;

/// The most cells along a side of an illumination map.
const MOST_CELLS: u32 = 4096;

/// The most memory that all illumination maps together may take.
const MOST_MAP_BYTES: f64 = 2.0 * 1024.0 * 1024.0 * 1024.0;

/// How many paths are followed to find out whether they end, and what all of them would take.
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
        let option = option_of_paths(settings);
        return Err(LightError::NoPaths { option });
    }
    let within = |option, must, holds: bool| {
        if holds {
            Ok(())
        } else {
            Err(LightError::OutOfRange { option, must })
        }
    };
    // as large as any length of a scene: its square is still a number
    let holds = (0.0..=LARGEST).contains(&options.aperture.unwrap_or(0.0));
    within("--aperture", "a radius of 0 or more, at most 1e50", holds)?;
    let holds = 1 <= options.bounces.unwrap_or(1);
    within("--bounces", "a number of surfaces from 1 on", holds)?;
    let must = "at least 2: of k photons k - 1 count";
    within("--nearest", must, 2 <= options.nearest)?;
    let holds = (1..=MOST_CELLS).contains(&options.map.unwrap_or(1));
    within("--map", "a number of cells from 1 to 4096", holds)?;
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

fn option_of_paths(settings: &Settings) -> &'static str {
    match settings.transport {
        Transport::HybridConnected => "--samples",
        _ => "--paths",
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
            "the light {light:?} stands inside {name:?}, which is opaque: its light stays there, away from the eye"
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

/// Follows some paths to find out whether they end, and what all of them would take.
fn check_amount<S: Strategy>(
    scene: &Scene,
    strategy: &S,
    settings: &Settings,
) -> Result<(), LightError> {
    let paths = settings.light_paths(scene.camera.pixels);
    let tracer = Tracer::new(scene, strategy, settings.transport);
    let lamps = Lamps::new(scene, settings);
    let mut counts = Counts::default();
    let started = Instant::now();
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
    let threads = rayon::current_num_threads() as f64;
    let seconds = started.elapsed().as_secs_f64() * share / threads;
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
        option: option_of_paths(settings),
        // more than a duration can hold is as good as the most it can
        time: Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX),
        bytes,
        most: most / for_each,
    })
}

/// What of a scene a transport that follows light does not look at.
fn left_out(scene: &Scene, settings: &Settings) -> Vec<String> {
    let mut notes = Vec::new();
    if scene.ambient != DVec3::ZERO || scene.background != DVec3::ZERO {
        notes.push(
            "the ambient light and the background are left out: the light of the lamps is followed, and nothing else"
                .into(),
        );
    }
    if settings.transport == Transport::Forward
        && settings.light.aperture_radius(&scene.camera).powi(2) == 0.0
    {
        notes.push(
            "the eye is a pinhole, of aperture 0: no photon can pass through a point, so none arrives and the \
             picture is black; --aperture gives the eye a radius"
                .into(),
        );
    }
    notes
}
