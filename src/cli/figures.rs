//! `raystep figures`: all figures of the lessons, written or checked against those that are there.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use raystep::scene::printable;
use raystep::{FigureName, Library};

use crate::cli::Error;
use crate::cli::args::FiguresArgs;
use crate::cli::figure::drawn;
use crate::cli::output::Output;
use crate::cli::same_file::Taken;

/// Draws all figures; writes those that changed, or lists them.
pub(crate) fn run(args: &FiguresArgs) -> Result<(), Error> {
    let library = args.drawing.library()?;
    if args.list {
        return Output::standard().write_whole(list(&library)?.as_bytes());
    }
    let how = args.drawing.rendition();
    let draw = |name: FigureName| {
        let (lesson, spec) = library.find(&name)?;
        let loaded = lesson.load(&name.figure, spec)?;
        let read = loaded.files.clone();
        let traced = lesson.trace_loaded(&name.figure, spec, loaded)?;
        let drawn = drawn(lesson, spec, &name, &traced, how)?;
        let file = args
            .out
            .join(&name.lesson)
            .join(format!("{}.svg", name.figure));
        Ok((file, drawn.svg, read))
    };
    let drawn: Result<Vec<(PathBuf, String, Vec<PathBuf>)>, Error> =
        library.figures().into_par_iter().map(draw).collect();
    let mut taken = Taken::nothing();
    for lesson in &library.lessons {
        taken.read(lesson.path());
    }
    let mut figures = Vec::new();
    for (file, svg, read) in drawn? {
        figures.push((file, svg));
        for file in read {
            taken.read(&file);
        }
    }
    let drawn = figures;
    if args.check {
        return check(args, &drawn);
    }
    for (file, svg) in &drawn {
        // a figure that is up to date keeps its time, for programs that watch it
        if fs::read(file).is_ok_and(|there| there == svg.as_bytes()) {
            continue;
        }
        if let Some(folder) = file.parent() {
            fs::create_dir_all(folder).map_err(|source| Error::Write {
                file: folder.display().to_string(),
                source,
            })?;
        }
        Output::create(file, &taken)?.write_whole(svg.as_bytes())?;
    }
    Ok(())
}

/// A line for each figure: its name, and as much of its caption as the line holds.
fn list(library: &Library) -> Result<String, Error> {
    /// Columns of a terminal.
    const WIDTH: usize = 80;
    let names = library.figures();
    let widest = names.iter().map(|name| name.to_string().chars().count());
    let widest = widest.max().unwrap_or(0);
    let mut text = String::new();
    for name in &names {
        let (_, spec) = library.find(name)?;
        let room = WIDTH.saturating_sub(widest + 2);
        let caption = shortened(&printable(&spec.caption), room);
        let line = format!("{:<widest$}  {caption}", name.to_string());
        text.push_str(line.trim_end());
        text.push('\n');
    }
    Ok(text)
}

/// The whole text if it has room, or whole words of it and an ellipsis.
fn shortened(text: &str, room: usize) -> String {
    if text.chars().count() <= room {
        return text.into();
    }
    let mut short = String::new();
    for word in text.split_whitespace() {
        // a blank and the ellipsis
        if room < short.chars().count() + word.chars().count() + 2 {
            break;
        }
        if !short.is_empty() {
            short.push(' ');
        }
        short.push_str(word);
    }
    short + "…"
}

/// Tells which files are not what would be drawn.
fn check(args: &FiguresArgs, drawn: &[(PathBuf, String)]) -> Result<(), Error> {
    let mut stale = Vec::new();
    for (file, svg) in drawn {
        match fs::read(file) {
            Ok(there) if there == svg.as_bytes() => {}
            Ok(_) => stale.push(format!("{}: differs", file.display())),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                stale.push(format!("{}: is missing", file.display()));
            }
            Err(error) => stale.push(format!("{}: {error}", file.display())),
        }
    }
    let known: BTreeSet<&Path> = drawn.iter().map(|(file, _)| file.as_path()).collect();
    for lesson in folders(&args.out) {
        for file in files(&lesson) {
            if !known.contains(file.as_path()) {
                stale.push(format!("{}: no lesson has this figure", file.display()));
            }
        }
    }
    if stale.is_empty() {
        return Ok(());
    }
    Err(Error::Stale {
        stale,
        of: drawn.len(),
        out: args.out.display().to_string(),
    })
}

/// The folders in a folder; none if it cannot be read, which shows by its figures missing.
fn folders(folder: &Path) -> Vec<PathBuf> {
    entries(folder).filter(|path| path.is_dir()).collect()
}

/// The drawings in a folder.
fn files(folder: &Path) -> Vec<PathBuf> {
    let is_svg = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "svg");
    let mut files: Vec<PathBuf> = entries(folder).filter(is_svg).collect();
    files.sort();
    files
}

fn entries(folder: &Path) -> impl Iterator<Item = PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    entries.filter_map(|entry| Some(entry.ok()?.path()))
}
