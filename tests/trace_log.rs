//! The log: what is written reads back bit for bit, whoever writes it and however much is left out.

mod damaged;
mod impossible;
mod light;
mod slab_rays;
pub(crate) mod strategies;
mod verdicts;

use std::io::{self, Write};
use std::path::Path;
use std::sync::OnceLock;

use raystep::scene::Loaded;
use raystep::strategy::Strategy;
use raystep::trace::{Kind, Kinds, Region};
use raystep::tracer::{LogOptions, LogStopped, LoggedPaths, trace_pixel, write_log};
use raystep::{
    Chosen, LogReader, NoFiles, Off, Record, Recording, Scene, Settings, Through, Tracer,
    WorkedOptions, load, load_bytes,
};

use crate::worked_solution::worked_text;
use serde_json::Value;

/// The example of the scene file's description.
pub(crate) const EXAMPLE: &str = include_str!("../lessons/04-sphere/scene.json");

/// What the example lacks: a tilted window, an eye at x = −0, a mesh with normals, cones, glass,
/// one side alone, a light with a power, and names that JSON must escape.
pub(crate) const MIXED: &str = r#"{
  "name": "mixed",
  "camera": {
    "window": { "cop": [-0.0, 0.5, 6], "corner": [-2, -1, 2], "right": [4, 0, 0.5], "up": [0, 3, 0.25] },
    "pixels": [9, 7]
  },
  "background": [0.2, 0.3, 0.4],
  "ambient": [0.1, 0.1, 0.1],
  "lights": [
    { "name": "the \"big\" lämp\n", "position": [4, 6, 5], "power": 900 },
    { "position": [-3, 5, 4], "colour": [0.5, 0.4, 0.3] }
  ],
  "materials": {
    "red": { "colour": [0.8, 0.2, 0.1], "diffuse": 0.7, "specular": 0.3, "shininess": 20 },
    "mirror": { "colour": [1, 1, 1], "diffuse": 0.1, "reflection": 0.8 },
    "glass": { "colour": [1, 1, 1], "diffuse": 0.1, "reflection": 0.1, "transmission": 0.8, "index": 1.5 }
  },
  "objects": [
    { "name": "roof", "material": "red", "shape": { "mesh": { "faces": [
      { "vertices": [[-3, -1, 3], [3, -1, 3], [3, -1.5, -4]],
        "normals": [[0.1, 1, 0.3], [-0.2, 1, 0.1], [0.3, 0.9, -0.1]] },
      { "vertices": [[-3, -1, 3], [3, -1.5, -4], [-3, -1.5, -4]] } ] } } },
    { "name": "a \\ tube", "material": "red", "sides": "back",
      "shape": { "cone": { "base": [-2, -1, 0], "base_radius": 0.7, "apex": [-1.5, 1, 0], "apex_radius": 0.7 } } },
    { "name": "tip", "material": "mirror",
      "shape": { "cone": { "base": [2, -1, 0], "base_radius": 1, "apex": [2, 1.5, 0], "apex_radius": 0 } } },
    { "name": "brick", "material": "glass", "shape": { "box": { "min": [-0.8, -1, 1], "max": [-0.0, 0.7, 1.8] } } },
    { "name": "ball", "material": "mirror", "shape": { "sphere": { "center": [0.3, 0.2, -1], "radius": 0.9 } } },
    { "name": "lens", "material": "glass",
      "shape": { "ellipsoid": { "center": [0.9, 0.4, 2], "radii": [0.6, 0.8, 0.3] } } }
  ],
  "max_depth": 6
}"#;

/// The scene of a JSON text.
#[track_caller]
pub(crate) fn built(text: &str) -> Scene {
    let loaded = load_bytes("scene.json", text.as_bytes(), &NoFiles);
    loaded.and_then(Loaded::build).unwrap()
}

/// One of the scenes in NFF, before its check.
#[track_caller]
pub(crate) fn loaded_nff(name: &str) -> Loaded {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/nff");
    load(&folder.join(name).with_extension("nff")).unwrap()
}

/// One of the scenes in NFF, as a picture of this size.
#[track_caller]
pub(crate) fn nff(name: &str, pixels: [u32; 2]) -> Scene {
    let mut loaded = loaded_nff(name);
    loaded.scene.camera.pixels = pixels;
    loaded.build().unwrap()
}

/// The strategy that the settings ask for.
#[track_caller]
pub(crate) fn strategy<'a>(scene: &'a Scene, settings: &Settings) -> Chosen<'a> {
    Chosen::new(scene, settings.strategy, &settings.structure).unwrap()
}

pub(crate) fn tracer<'a>(
    scene: &'a Scene,
    strategy: &'a Chosen<'a>,
    settings: &Settings,
) -> Tracer<'a, Chosen<'a>> {
    Tracer::new(scene, strategy, settings.transport)
}

/// Everything in a region.
pub(crate) fn all_of(region: Region) -> LogOptions {
    LogOptions {
        region,
        kinds: Kinds::ALL,
        budget: u64::MAX,
        paths: LoggedPaths::None,
    }
}

/// The whole log.
pub(crate) fn log(scene: &Scene, settings: &Settings, options: &LogOptions) -> Vec<u8> {
    let mut bytes = Vec::new();
    let strategy = strategy(scene, settings);
    let tracer = tracer(scene, &strategy, settings);
    write_log::<_, Off>(&tracer, settings, options, &mut bytes, |_| {}).unwrap();
    bytes
}

/// The records of one pixel, and if they are wanted those of the building before it.
pub(crate) fn records(scene: &Scene, settings: &Settings, pixel: [u32; 2]) -> Vec<Record> {
    let strategy = strategy(scene, settings);
    let tracer = tracer(scene, &strategy, settings);
    let mut recording = Recording::new(Vec::new());
    if settings.building {
        strategy.note_building(&mut recording);
    }
    trace_pixel(&tracer, pixel, settings.through, &mut recording).unwrap();
    recording.into_sink()
}

pub(crate) fn pixels_of(region: Region) -> impl Iterator<Item = [u32; 2]> {
    let ([left, top], [right, bottom]) = (region.from, region.to);
    (top..=bottom).flat_map(move |y| (left..=right).map(move |x| [x, y]))
}

/// Scenes, each with a way of tracing it and a region.
pub(crate) fn cases() -> Vec<(Scene, Settings, Region)> {
    let example = built(EXAMPLE);
    let corners = Settings {
        through: Through::Corners,
        ..Settings::default()
    };
    let one_sided = Settings {
        one_sided: true,
        ..Settings::default()
    };
    let mixed = built(MIXED);
    let whole = Region::whole(mixed.camera.pixels);
    let region = |text: &str| text.parse::<Region>().unwrap();
    let mut cases = vec![
        (example.clone(), Settings::default(), region("76,55-84,62")),
        (example, corners.clone(), region("100,40-102,80")),
        (mixed.clone(), corners, whole),
        (mixed.one_sided(), one_sided, whole),
        (
            nff("gears-1", [32, 32]),
            Settings::default(),
            region("14,15-16,16"),
        ),
        (
            nff("teapot-2", [32, 32]),
            Settings::default(),
            region("15,15-18,16"),
        ),
    ];
    cases.extend(strategies::cases());
    cases
}

/// A case with its whole log, and the records of its pixels as they are traced one by one.
pub(crate) struct Traced {
    pub(crate) scene: Scene,
    pub(crate) settings: Settings,
    pub(crate) region: Region,
    pub(crate) log: Vec<u8>,
    pub(crate) pixels: Vec<([u32; 2], Vec<Record>)>,
}

impl Traced {
    pub(crate) fn lines(&self) -> impl Iterator<Item = &str> {
        std::str::from_utf8(&self.log).unwrap().lines()
    }
}

/// All [`cases`], traced once for all tests.
pub(crate) fn traced() -> &'static [Traced] {
    static TRACED: OnceLock<Vec<Traced>> = OnceLock::new();
    TRACED.get_or_init(|| {
        let trace = |(scene, settings, region): (Scene, Settings, Region)| Traced {
            log: log(&scene, &settings, &all_of(region)),
            pixels: pixels_of(region)
                .map(|pixel| (pixel, records(&scene, &settings, pixel)))
                .collect(),
            scene,
            settings,
            region,
        };
        cases().into_iter().map(trace).collect()
    })
}

/// `Debug` prints a number's shortest digits and the sign of a zero: equal texts are equal bits.
#[track_caller]
fn check_same(what: &str, written: &impl std::fmt::Debug, read: &impl std::fmt::Debug) {
    let (written, read) = (format!("{written:?}"), format!("{read:?}"));
    assert!(
        written == read,
        "{what}\nwritten {written:.2000}\nread    {read:.2000}"
    );
}

#[test]
fn a_log_reads_back_as_the_same_scene_and_the_same_records() {
    for case in traced() {
        let mut reader = LogReader::open("a.jsonl", &*case.log).unwrap();
        let name = &case.scene.name;
        check_same(name, &case.scene, reader.scene());
        check_same(name, &case.settings, reader.settings());
        for record in case.pixels.iter().flat_map(|(_, records)| records) {
            let read = reader.next_record().unwrap();
            check_same(name, &Some(record), &read);
        }
        assert_eq!(reader.next_record().unwrap(), None, "{name}");
    }
}

#[test]
fn an_eye_at_minus_zero_keeps_its_sign_and_no_line_has_an_unbounded_t() {
    let scene = built(MIXED);
    let bytes = log(&scene, &Settings::default(), &all_of(Region::pixel([4, 3])));
    let text = String::from_utf8(bytes).unwrap();
    let eye = text
        .lines()
        .find(|line| line.contains("\"purpose\":\"eye\""));
    let eye = eye.unwrap();
    assert!(eye.contains("\"origin\":[-0.0,0.5,6.0]"), "{eye}");
    assert!(!eye.contains("t_max"), "{eye}");
    let (_, _, records) = LogReader::open("a.jsonl", text.as_bytes())
        .and_then(|reader| reader.pixel([4, 3]))
        .unwrap();
    let start = records.iter().find_map(|record| match record.event {
        raystep::Event::Ray(start) => Some(start),
        _ => None,
    });
    let start = start.unwrap();
    assert_eq!(start.ray.origin.x.to_bits(), (-0.0f64).to_bits());
    assert_eq!(start.range.max, f64::INFINITY);
}

#[test]
fn the_worked_solution_from_a_log_is_the_one_from_memory() {
    for case in traced() {
        let Traced {
            scene, settings, ..
        } = case;
        let reader = LogReader::open("a.jsonl", &*case.log).unwrap();
        let (read_scene, read_settings) = (reader.scene().clone(), reader.settings().clone());
        let all: Vec<Record> = reader.map(Result::unwrap).collect();
        let mut by_pixel = all.chunk_by(|a, b| a.pixel == b.pixel);
        for (pixel, traced) in &case.pixels {
            let read = by_pixel.next().unwrap();
            for all in [false, true] {
                let options = WorkedOptions {
                    all,
                    ..WorkedOptions::default()
                };
                let memory = worked_text(scene, settings, traced, &options);
                let file = worked_text(&read_scene, &read_settings, read, &options);
                assert!(!memory.is_empty());
                assert!(memory == file, "{} {pixel:?}", scene.name);
            }
        }
    }
}

#[test]
fn runs_on_one_two_and_five_threads_write_the_same_bytes() {
    for case in traced() {
        for threads in [1, 2, 5] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            let pool = pool.build().unwrap();
            let all = all_of(case.region);
            let again = pool.install(|| log(&case.scene, &case.settings, &all));
            let name = &case.scene.name;
            assert!(case.log == again, "{name} on {threads} threads");
        }
    }
}

#[test]
fn a_filter_keeps_the_lines_that_a_filter_of_the_whole_log_keeps() {
    for case in traced() {
        let Traced {
            scene,
            settings,
            region,
            ..
        } = case;
        let lines: Vec<Placed> = case.lines().map(Placed::of).collect();
        let inner = Region {
            from: [0, 1].map(|i| (region.from[i] + 1).min(region.to[i])),
            to: region.to,
        };
        let sets: [&[Kind]; 4] = [
            &[],
            &[Kind::Ray, Kind::RayEnd],
            &[Kind::Shade, Kind::PixelColour, Kind::Edge],
            &Kind::ALL,
        ];
        for (kinds, region) in sets.into_iter().zip([*region, *region, inner, inner]) {
            let options = LogOptions {
                region,
                kinds: Kinds::of(kinds),
                budget: u64::MAX,
                paths: LoggedPaths::None,
            };
            let kept = String::from_utf8(log(scene, settings, &options)).unwrap();
            let expected: String = lines
                .iter()
                .filter(|line| line.is_kept(kinds, region))
                .flat_map(|line| [line.text, "\n"])
                .collect();
            assert!(kept == expected, "{} {kinds:?} {region}", scene.name);
        }
    }
}

/// A line of a log, and what it says of itself.
struct Placed<'a> {
    text: &'a str,
    kind: String,
    /// Absent: the line is the head's.
    pixel: Option<[u32; 2]>,
}

impl<'a> Placed<'a> {
    fn of(text: &'a str) -> Self {
        let line: Value = serde_json::from_str(text).unwrap();
        let kind = line["kind"].as_str().unwrap().to_owned();
        let pixel = (kind != "trace" && kind != "object")
            .then(|| [0, 1].map(|i| line["pixel"][i].as_u64().unwrap() as u32));
        Self { text, kind, pixel }
    }

    /// Is it the head's, or an event of these kinds in the region?
    fn is_kept(&self, kinds: &[Kind], region: Region) -> bool {
        let Some([x, y]) = self.pixel else {
            return true;
        };
        let ([left, top], [right, bottom]) = (region.from, region.to);
        let inside = left <= x && x <= right && top <= y && y <= bottom;
        inside && kinds.iter().any(|known| known.name() == self.kind)
    }
}

/// Takes a number of writes, remembers the longest, and can fail.
struct Watched {
    longest: usize,
    total: usize,
    fails_after: usize,
}

impl Write for Watched {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.longest = self.longest.max(bytes.len());
        self.total += bytes.len();
        if self.fails_after < self.total {
            return Err(io::Error::other("the disk is full"));
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Writes three scan lines of 128 pixels, and what came of it.
fn watched(budget: u64, fails_after: usize) -> (Watched, Result<(), LogStopped>) {
    let scene = nff("balls-2", [128, 128]);
    let settings = Settings::default();
    let strategy = strategy(&scene, &settings);
    let mut out = Watched {
        longest: 0,
        total: 0,
        fails_after,
    };
    let options = LogOptions {
        budget,
        ..all_of("0,63-127,65".parse().unwrap())
    };
    let tracer = tracer(&scene, &strategy, &settings);
    let written = write_log::<_, Off>(&tracer, &settings, &options, &mut out, |_| {});
    (out, written.map(|_| ()))
}

#[test]
fn a_log_of_many_megabytes_is_written_in_pieces_of_one() {
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let (out, written) = pool
            .build()
            .unwrap()
            .install(|| watched(u64::MAX, usize::MAX));
        assert!(written.is_ok());
        // one scan line alone is longer than what may be kept of it
        assert!(3 * (4 << 20) < out.total, "{}", out.total);
        assert!(out.longest < 2 << 20, "{}", out.longest);
    }
}

#[test]
fn a_spent_budget_and_a_full_disk_stop_the_log() {
    let (_, written) = watched(1000, usize::MAX);
    assert!(matches!(written, Err(LogStopped::Budget)));
    let (_, written) = watched(u64::MAX, 5 << 20);
    let Err(LogStopped::Output(error)) = written else {
        panic!("{written:?}");
    };
    assert_eq!(error.to_string(), "the disk is full");
}

#[test]
fn a_log_that_another_program_has_spaced_or_sorted_is_read_all_the_same() {
    let scene = built(EXAMPLE);
    let options = all_of("80,60".parse().unwrap());
    let text = String::from_utf8(log(&scene, &Settings::default(), &options)).unwrap();
    let again: String = text
        .lines()
        .map(|line| {
            // a map of serde_json has its keys in the order of the alphabet
            let value: Value = serde_json::from_str(line).unwrap();
            value.to_string().replace("\":", "\" : ") + "\n"
        })
        .collect();
    assert_ne!(text, again);
    let read = |text: &str| {
        let log = LogReader::open("log", text.as_bytes()).unwrap();
        log.pixel([80, 60]).unwrap().2
    };
    assert_eq!(read(&text), read(&again));
}
