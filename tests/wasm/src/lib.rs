//! What the core makes of every scene and figure of the lessons, as hashes: a line for each case. The same lines must come
//! out of WebAssembly and of this machine.
//!
//! Two functions of plain C are exported: [`cases`] says how many there are, [`run`] works one out and says where its line
//! is.

mod files;

use std::fmt::Write as _;
use std::io::{self, Write};
use std::sync::{Mutex, OnceLock};

use raystep::explain::render;
use raystep::trace::{Kinds, Region};
use raystep::tracer::{LogOptions, LoggedPaths, check_light_of, follow_light};
use raystep::{
    Chosen, FigureName, Library, Rendition, Settings, StrategyName, Through, Tracer, Transport,
    Width, WorkedOptions, load_bytes, record_log, record_pixel, worked_solution,
};

use files::{Embedded, FILES};

const STRATEGIES: [StrategyName; 6] = [
    StrategyName::Exhaustive,
    StrategyName::Bounds,
    StrategyName::Hierarchy,
    StrategyName::Heap,
    StrategyName::Grid,
    StrategyName::ZAligned,
];

/// The largest picture that is traced.
const PIXELS: [u32; 2] = [24, 18];

/// Paths of light, of which each leaves several rays in a log.
const PATHS: u64 = 50;

/// A case: a scene with a strategy and a transport, or a figure.
enum Case {
    Scene(&'static str, StrategyName, Transport),
    Figure(FigureName),
}

/// The lessons, and all cases, always in the same order.
fn all() -> &'static (Library, Vec<Case>) {
    static ALL: OnceLock<(Library, Vec<Case>)> = OnceLock::new();
    ALL.get_or_init(read_all)
}

fn read_all() -> (Library, Vec<Case>) {
    let library = Library::open(&Embedded::default()).expect("the lessons are in order");
    let mut cases: Vec<Case> = library.figures().into_iter().map(Case::Figure).collect();
    let is_scene = |name: &str| name.ends_with(".json") && !name.ends_with("lesson.json");
    for (name, _) in FILES.iter().filter(|(name, _)| is_scene(name)) {
        for transport in Transport::ALL {
            cases.extend(STRATEGIES.map(|strategy| Case::Scene(name, strategy, transport)));
        }
    }
    (library, cases)
}

/// What a case comes to.
fn line(library: &Library, case: &Case) -> String {
    match case {
        Case::Scene(name, strategy, transport) => {
            let made = scene(name, *strategy, *transport);
            format!(
                "{name} {strategy:?} {transport:?}: {}",
                made.unwrap_or_else(|refused| refused)
            )
        }
        Case::Figure(name) => {
            let drawn = library.find(name).and_then(|(lesson, spec)| {
                let traced = lesson.trace(&name.figure, spec)?;
                lesson.draw(
                    &name.figure,
                    spec,
                    &traced,
                    "id",
                    (Width::Book, Rendition::default()),
                )
            });
            let svg = drawn.expect("the lessons are in order").svg;
            format!("{name}: figure {:016x}", hash(svg.as_bytes()))
        }
    }
}

/// The log of a small picture, and the words of the pixel in its middle; or why there are none.
fn scene(name: &str, strategy: StrategyName, transport: Transport) -> Result<String, String> {
    let files = Embedded::default();
    let (_, bytes) = FILES
        .iter()
        .find(|(known, _)| *known == name)
        .ok_or("no such file")?;
    let mut loaded =
        load_bytes(name, bytes, &*files.around_name(name)).map_err(|error| error.to_string())?;
    let camera = &mut loaded.scene.camera;
    camera.pixels = [0, 1].map(|i| camera.pixels[i].min(PIXELS[i]));
    let [width, height] = camera.pixels;
    let scene = loaded.build().map_err(|error| error.to_string())?;
    let mut settings = Settings {
        strategy,
        transport,
        ..Settings::default()
    };
    settings.light.paths = PATHS;
    settings.light.samples = 1;
    let chosen =
        Chosen::new(&scene, strategy, &settings.structure).map_err(|error| error.to_string())?;
    check_light_of(&scene, &chosen, &settings).map_err(|error| error.to_string())?;
    let pixel = [width / 2, height / 2];
    let region = Some(Region::pixel(pixel));
    let light = follow_light(&scene, &chosen, &settings, region, None, &|_| {});
    let light = light.map_err(|stopped| stopped.to_string())?;
    let tracer = Tracer::new(&scene, &chosen, transport).with_light(light.as_ref());
    let options = LogOptions {
        region: Region {
            from: [0, 0],
            to: [width - 1, height - 1],
        },
        kinds: Kinds::ALL,
        budget: u64::MAX,
        paths: LoggedPaths::All(settings.light_paths([width, height]).min(PATHS)),
    };
    let mut log = Hash::default();
    let written = record_log(&tracer, &settings, &options, &mut log, None, &|_| {});
    written.map_err(|stopped| format!("{stopped:?}"))?;
    let records = record_pixel(&tracer, pixel, Through::Centres, true, u64::MAX);
    let records = records.map_err(|stopped| stopped.to_string())?;
    let page = worked_solution(
        &scene,
        &settings,
        &records,
        &WorkedOptions {
            all: true,
            ..Default::default()
        },
    );
    let text = render::plain(&page, render::no_hint);
    Ok(format!(
        "log {:016x} of {} bytes, words {:016x} of {}",
        log.hash,
        log.bytes,
        hash(text.as_bytes()),
        text.len()
    ))
}

/// FNV-1a, 64 bits.
struct Hash {
    hash: u64,
    bytes: u64,
}

impl Default for Hash {
    fn default() -> Self {
        Self {
            hash: 0xcbf2_9ce4_8422_2325,
            bytes: 0,
        }
    }
}

impl Write for Hash {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        for &byte in bytes {
            self.hash = (self.hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
        self.bytes += bytes.len() as u64;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn hash(bytes: &[u8]) -> u64 {
    let mut hash = Hash::default();
    let _ = hash.write(bytes);
    hash.hash
}

/// All lines, one for each case.
pub fn lines() -> String {
    let (library, cases) = all();
    let mut text = String::new();
    for case in cases {
        let _ = writeln!(text, "{}", line(library, case));
    }
    text
}

static LINE: Mutex<String> = Mutex::new(String::new());

/// How many cases there are.
#[unsafe(no_mangle)]
pub extern "C" fn cases() -> u32 {
    all().1.len() as u32
}

/// Works a case out; gives back where its line is, which stands there until the next call. [`length`] says how long it is.
#[unsafe(no_mangle)]
pub extern "C" fn run(number: u32) -> *const u8 {
    let (library, cases) = all();
    let made = line(library, &cases[number as usize]);
    let mut kept = LINE.lock().unwrap();
    *kept = made;
    kept.as_ptr()
}

/// The length of the last line, in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn length() -> usize {
    LINE.lock().unwrap().len()
}
