//! The paths of light that a transport needs before its pixels.

use std::path::Path;

use raystep::{LightError, LightPass, Recorder, Region, Strategy, check_light};

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

/// Follows all paths of light, if the transport follows any, and gives back with them what the recorders heard.
pub(crate) fn light_pass<S: Strategy, R: Recorder + Default + Send>(
    file: &Path,
    ready: &Ready,
    strategy: &S,
    region: Option<Region>,
    threads: Option<u16>,
) -> Result<(Option<LightPass>, Vec<R>), Error> {
    let (scene, settings) = (&ready.scene, &ready.settings);
    if !settings.transport.follows_light() {
        return Ok((None, Vec::new()));
    }
    let checked = on_threads(threads, || check_light(scene, strategy, settings))?;
    tell_notes(file, checked)?;
    let bar = bar_of(settings.light_paths(scene.camera.pixels), "paths of light");
    let mut heard = Vec::new();
    let light = on_threads(threads, || {
        let hear = |recorder| heard.push(recorder);
        LightPass::new(scene, strategy, settings, region, hear, |paths| {
            bar.set_position(paths);
        })
    });
    bar.finish_and_clear();
    let light = light?.map_err(|stopped| ready.stopped(stopped))?;
    Ok((light, heard))
}
