//! The paths of light that a transport needs before its pixels.

use std::path::Path;

use raystep::trace::Region;
use raystep::tracer::{LightError, LightPass, check_light_of, follow_light};
use raystep::{Chosen, Counts};

use crate::cli::Error;
use crate::cli::input::{self, Ready};
use crate::cli::notes::note;
use crate::cli::progress::{bar_of, on_threads};

/// Tells the notes about how light is followed through a scene, on standard error, or why it cannot be.
pub(crate) fn tell_notes(
    file: &Path,
    checked: Result<Vec<String>, LightError>,
) -> Result<(), Error> {
    let notes = checked.map_err(|fault| Error::Light {
        file: input::name_of(file),
        fault,
    })?;
    for text in &notes {
        note(text);
    }
    Ok(())
}

/// Follows all paths of light, if the transport follows any; `counts` get what was traced for it.
pub(crate) fn light_pass(
    file: &Path,
    ready: &Ready,
    strategy: &Chosen<'_>,
    region: Option<Region>,
    threads: Option<u16>,
    counts: Option<&mut Counts>,
) -> Result<Option<LightPass>, Error> {
    let (scene, settings) = (&ready.scene, &ready.settings);
    if !settings.transport.follows_light() {
        return Ok(None);
    }
    let checked = on_threads(threads, || check_light_of(scene, strategy, settings))?;
    tell_notes(file, checked)?;
    let bar = bar_of(settings.light_paths(scene.camera.pixels), "paths of light");
    let done = |paths: u64| bar.set_position(paths);
    let light = on_threads(threads, || {
        follow_light(scene, strategy, settings, region, counts, &done)
    });
    bar.finish_and_clear();
    light?.map_err(|stopped| ready.stopped(stopped))
}
