//! Opening what is to be traced or read: a scene, or a log, recognised by its first line.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, Read};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use raystep::explain::CrowdedCell;
use raystep::scene::{Fault, LARGEST_FILE, LONGEST_LINE, Loaded, ReadEnd, read_up_to};
use raystep::trace::begins_log;
use raystep::tracer::MAX_RAYS;
use raystep::{Chosen, Counts, Folder, LoadError, LogReader, Scene, Settings, Stopped, load_bytes};

use crate::cli::Error;
use crate::cli::args::{Reading, Tracing};
use crate::cli::light_options::{self, LIGHT_OPTIONS};
use crate::cli::notes::note;
use crate::cli::stats::{Report, Times};
use crate::cli::structure_options::{STRUCTURE_OPTIONS, refuse_unused};
use crate::cli::usual::Usual;

/// How many bytes are read at once: with less, calls of the system add up.
const AT_ONCE: usize = 1 << 16;

/// A log that is read while it comes in.
pub(crate) type Log = LogReader<Box<dyn BufRead>>;

/// What a file holds.
pub(crate) enum Input {
    /// A scene that is not checked yet.
    Scene(Box<Loaded>),
    /// A log.
    Log(Box<Log>),
}

/// A scene that can be traced.
pub(crate) struct Ready {
    /// The scene.
    pub(crate) scene: Scene,
    /// How it is to be traced.
    pub(crate) settings: Settings,
    /// How many rays one pixel may take.
    pub(crate) max_rays: u64,
    /// The files that it names and that were read for it.
    pub(crate) files: Vec<PathBuf>,
    /// Did the verb choose the strategy, and no option?
    pub(crate) is_usual: bool,
    /// How long it took to read and check it.
    pub(crate) loading: Duration,
}

impl Ready {
    /// The grid that the strategy walks, if most objects lie in one of its cells.
    pub(crate) fn crowded(&self, strategy: &Chosen<'_>) -> Option<CrowdedCell> {
        CrowdedCell::of(strategy.grid()?, self.scene.primitives.len())
    }

    /// What `--stats` reports of a trace of this scene.
    pub(crate) fn report<'a>(
        &'a self,
        strategy: &Chosen<'_>,
        counts: &'a Counts,
        times: Times,
    ) -> Report<'a> {
        Report {
            scene: &self.scene,
            settings: &self.settings,
            is_usual: self.is_usual,
            crowded: self.crowded(strategy),
            counts,
            times,
        }
    }

    /// The strategy that the settings ask for, its structure built.
    pub(crate) fn strategy(&self) -> Result<Chosen<'_>, Error> {
        let Settings {
            strategy,
            structure,
            ..
        } = &self.settings;
        Chosen::new(&self.scene, *strategy, structure).map_err(|fault| Error::Structure { fault })
    }

    /// Why its trace was stopped before its end.
    pub(crate) fn stopped(&self, stopped: Stopped) -> Error {
        let transport = self.settings.transport;
        Error::Stopped { stopped, transport }
    }
}

/// The name of an input in messages.
pub(crate) fn name_of(path: &Path) -> String {
    if path == Path::new("-") {
        "standard input".into()
    } else {
        path.display().to_string()
    }
}

/// Opens a scene or a log. Notes about a scene go to standard error.
pub(crate) fn open(path: &Path, reading: &Reading) -> Result<Input, Error> {
    let file = name_of(path);
    let unreadable = |source| {
        Error::Load(LoadError::Read {
            file: file.clone(),
            source,
        })
    };
    let is_standard = path == Path::new("-");
    let mut length = 0;
    let mut input: Box<dyn BufRead> = if is_standard {
        Box::new(BufReader::with_capacity(AT_ONCE, io::stdin()))
    } else {
        let opened = File::open(path).map_err(unreadable)?;
        length = opened.metadata().map_or(0, |meta| meta.len());
        Box::new(BufReader::with_capacity(AT_ONCE, opened))
    };

    let mut start = Vec::new();
    let mut end = read_up_to(&mut input, b'\n', LONGEST_LINE, &mut start).map_err(unreadable)?;
    if end == ReadEnd::Limit {
        let what = "the first line";
        return Err(Error::TooLong {
            file,
            what,
            bytes: LONGEST_LINE,
        });
    }
    if is_standard && start.is_empty() {
        return Err(Error::EmptyInput);
    }
    if begins_log(&start) {
        let whole: Box<dyn BufRead> = Box::new(Cursor::new(start).chain(input));
        return Ok(Input::Log(Box::new(LogReader::open(&file, whole)?)));
    }

    let mut bytes = start;
    if end == ReadEnd::Stop {
        bytes.reserve((length.min(LARGEST_FILE) as usize).saturating_sub(bytes.len()));
        // text has no byte 0: what is read with it is refused as no text
        end = read_up_to(&mut input, 0, LARGEST_FILE, &mut bytes).map_err(unreadable)?;
    }
    if end == ReadEnd::Limit {
        let what = "the file";
        return Err(Error::TooLong {
            file,
            what,
            bytes: LARGEST_FILE,
        });
    }
    let folder = if is_standard {
        Folder::new("")
    } else {
        Folder::of(path)
    };
    let loaded = load_bytes(&file, &bytes, &folder.allow_outside(reading.allow_outside))?;
    for text in &loaded.notes {
        note(text);
    }
    Ok(Input::Scene(Box::new(loaded)))
}

/// A scene as the options want it, checked; `usual` is the strategy if none is chosen.
pub(crate) fn ready(
    loaded: Loaded,
    tracing: &Tracing,
    usual: Usual,
    started: Instant,
) -> Result<Ready, Error> {
    light_options::refuse_unused(&tracing.casting)?;
    ready_for_all(loaded, tracing, usual, started)
}

/// The same for several transports, of which each looks at some of the options.
pub(crate) fn ready_for_all(
    mut loaded: Loaded,
    tracing: &Tracing,
    usual: Usual,
    started: Instant,
) -> Result<Ready, Error> {
    if let Some(pixels) = tracing.casting.pixels {
        loaded.scene.camera.pixels = pixels;
    }
    if let Some(depth) = tracing.casting.max_depth {
        loaded.scene.max_depth = depth;
    }
    let files = std::mem::take(&mut loaded.files);
    let mut scene = loaded.build().map_err(|error| {
        // what an option has put there stands in no line of the file
        let option = match &error {
            LoadError::Fault { fault, .. } => match fault {
                Fault::Pixels { .. } if tracing.casting.pixels.is_some() => {
                    Some(("--pixels", fault))
                }
                Fault::Depth { .. } if tracing.casting.max_depth.is_some() => {
                    Some(("--max-depth", fault))
                }
                _ => None,
            },
            _ => None,
        };
        match option {
            Some((option, fault)) => Error::Option {
                option,
                fault: fault.clone(),
            },
            None => Error::Load(error),
        }
    })?;
    if tracing.casting.one_sided {
        scene = scene.one_sided();
    }
    let strategy = tracing.strategy.unwrap_or_else(|| usual.strategy(&scene));
    let structure = tracing.structure();
    refuse_unused(tracing, strategy, &structure)?;
    let settings = Settings {
        strategy,
        structure,
        building: tracing.building,
        transport: tracing.casting.transport.unwrap_or_default(),
        light: tracing.casting.light(),
        through: tracing.casting.through.unwrap_or_default(),
        one_sided: tracing.casting.one_sided,
        only: None,
        whole: Vec::new(),
        figure: None,
        region: None,
    };
    Ok(Ready {
        scene,
        settings,
        max_rays: tracing.casting.max_rays.unwrap_or(MAX_RAYS),
        files,
        is_usual: tracing.strategy.is_none(),
        loading: started.elapsed(),
    })
}

/// Refuses options that would trace anew what a log has traced already.
pub(crate) fn refuse_tracing(path: &Path, tracing: &Tracing) -> Result<(), Error> {
    let structure = STRUCTURE_OPTIONS
        .iter()
        .map(|option| (option.name, (option.is_given)(tracing)));
    let casting = [
        ("--transport", tracing.casting.transport.is_some()),
        ("--pixels", tracing.casting.pixels.is_some()),
        ("--one-sided", tracing.casting.one_sided),
    ];
    let light = LIGHT_OPTIONS
        .iter()
        .map(|option| (option.name, (option.is_given)(&tracing.casting)));
    let strategy = [("--strategy", tracing.strategy.is_some())];
    let given = strategy
        .into_iter()
        .chain(structure)
        .chain(casting)
        .chain(light);
    let given = given.filter(|(_, is_given)| *is_given);
    let names: Vec<&str> = given.map(|(name, _)| name).collect();
    let asks = if names.len() == 1 {
        "asks for"
    } else {
        "ask for"
    };
    match names.split_last() {
        None => Ok(()),
        Some((last, [])) => Err(needs_scene(path, &format!("{last} {asks}"))),
        Some((last, others)) => {
            let what = format!("{} and {last} {asks}", others.join(", "));
            Err(needs_scene(path, &what))
        }
    }
}

/// The error that says that a log is not enough; `what` goes before "new rays".
pub(crate) fn needs_scene(path: &Path, what: &str) -> Error {
    Error::NeedsScene {
        file: name_of(path),
        what: what.into(),
    }
}
