//! `raystep check`: a log of a ray tracer in any language, against what this one computes.

use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use raystep::lesson::check::{CheckError, CheckOptions, Named, check_log, picture};
use raystep::trace::Kinds;
use raystep::{Chosen, Settings, StrategyName};

use crate::cli::Error;
use crate::cli::args::{CheckArgs, CheckFormat};
use crate::cli::input::{self, Input};
use crate::cli::notes::note;
use crate::cli::output::{self, Output};
use crate::cli::same_file::Taken;
use crate::cli::usual::Usual;
use crate::cli::word::word;

/// Prints what differs, and draws it.
pub(crate) fn run(args: &CheckArgs) -> Result<ExitCode, Error> {
    if args.scene == Path::new("-") && args.log == Path::new("-") {
        return Err(Error::StandardInputTwice);
    }
    let loaded = match input::open(&args.scene, &args.reading)? {
        Input::Scene(loaded) => *loaded,
        Input::Log(_) => {
            return Err(input::needs_scene(
                &args.scene,
                "a check traces it, which asks for",
            ));
        }
    };
    let ready = input::ready(
        loaded.clone(),
        &args.tracing,
        Usual::Exhaustive,
        Instant::now(),
    )?;
    output::refuse_ending(&args.picture, "a picture", &["svg"])?;

    // every object is tested; and cells, nodes and bounds come from the strategy, or from the grid
    let exhaustive = Settings {
        strategy: StrategyName::Exhaustive,
        ..ready.settings.clone()
    };
    let other = Settings {
        strategy: match ready.settings.strategy {
            StrategyName::Exhaustive => StrategyName::Grid,
            chosen => chosen,
        },
        ..ready.settings.clone()
    };
    let build = |settings: &Settings| {
        Chosen::new(&ready.scene, settings.strategy, &settings.structure)
            .map_err(|fault| Error::Structure { fault })
    };
    let chosen = [build(&exhaustive)?, build(&other)?];
    let chosen = [(&exhaustive, &chosen[0]), (&other, &chosen[1])];
    let options = CheckOptions {
        only: (!args.only.is_empty()).then(|| Kinds::of(&args.only)),
        tolerance: args.tolerance,
    };
    let log = input::name_of(&args.log);
    let checked = check_log(
        &ready.scene,
        &chosen,
        &log,
        open(&args.log, &log)?,
        &options,
    )?;

    let mut named = Named {
        scene: input::name_of(&args.scene),
        log,
        see: String::new(),
        picture: None,
    };
    if let Some(divergence) = &checked.divergence {
        let [x, y] = divergence.pixel;
        let strategy = divergence.strategy().map_or(String::new(), |strategy| {
            format!(" --strategy {}", word(strategy))
        });
        let (scene, step) = (&named.scene, divergence.step);
        named.see = format!("raystep step {scene} {x},{y}{strategy} --at {step}");
    }
    if let Some(divergence) = checked.divergence.as_ref().filter(|_| !args.no_picture) {
        let taken = Taken::by_reading(&args.scene, &ready.files);
        taken.refuse(&args.picture)?;
        match picture(loaded, &named.scene, divergence) {
            Ok(svg) => {
                Output::create(&args.picture, &taken)?.write_whole(svg.as_bytes())?;
                named.picture = Some(args.picture.display().to_string());
            }
            // the answer does not depend on it
            Err(error) => {
                let error = error.to_string();
                let what = error.lines().next().unwrap_or_default();
                note(&format!("there is no picture of this step: {what}"));
            }
        }
    }
    let text = match args.format {
        CheckFormat::Text => checked.text(&named),
        CheckFormat::Json => format!("{:#}\n", checked.json(&named)),
        CheckFormat::Junit => checked.junit(&named),
    };
    Output::standard().write_whole(text.as_bytes())?;
    Ok(ExitCode::from(u8::from(!checked.is_right())))
}

/// The log that is checked.
fn open(path: &Path, name: &str) -> Result<Box<dyn BufRead>, Error> {
    if path == Path::new("-") {
        return Ok(Box::new(BufReader::new(io::stdin())));
    }
    let file = File::open(path).map_err(|source| {
        Error::Check(CheckError::Read {
            file: name.into(),
            source,
        })
    })?;
    Ok(Box::new(BufReader::new(file)))
}
