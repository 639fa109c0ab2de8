//! Commands that a book shows: they only read, they read the course alone, and what they print comes into the book.
//!
//! A command runs in a process of its own, this same program without a shell, in the project's root: so its line is what a
//! reader can copy, and what it prints is what a reader sees.

use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use clap::{CommandFactory, FromArgMatches};
use raystep::book::{Commands, Project, Ran};

use crate::cli::args::{Args, LessonVerb, Reading, Verb};
use crate::cli::output::is_standard;

/// Runs the commands that a book shows.
pub(crate) struct Shown;

impl Commands for Shown {
    fn run(&self, words: &[String], project: &Project) -> Result<Ran, String> {
        refuse(words, project)?;
        let program = env::current_exe().map_err(|error| cannot_run(&error.to_string()))?;
        let done = Command::new(program)
            .args(["--quiet", "--color", "never"])
            .args(words)
            .current_dir(&project.root)
            .stdin(Stdio::null())
            .output();
        let done = done.map_err(|error| cannot_run(&error.to_string()))?;
        let code = done.status.code().and_then(|code| u8::try_from(code).ok());
        let code = code.ok_or_else(|| cannot_run("it was ended by a signal"))?;
        let mut out = String::from_utf8_lossy(&done.stdout).into_owned();
        if code != 0 {
            out.push_str(&String::from_utf8_lossy(&done.stderr));
        }
        Ok(Ran { out, code })
    }
}

fn cannot_run(why: &str) -> String {
    format!("the command cannot be run: {why}")
}

/// Refuses a command that writes, asks, or reads what is not the course's.
fn refuse(words: &[String], project: &Project) -> Result<(), String> {
    let arguments = std::iter::once("raystep".into()).chain(words.iter().map(OsString::from));
    let parsed = Args::command().try_get_matches_from(arguments);
    let Ok(Args { verb, .. }) = parsed.and_then(|matches| Args::from_arg_matches(&matches)) else {
        // help, or a mistake: nothing is read or written
        return Ok(());
    };
    for path in
        reads(&verb).map_err(|why| format!("{why}\n  a book shows commands that only read"))?
    {
        if is_standard(path) || !project.is_of_course(path) {
            return Err(format!(
                "{} is no file of the lessons or of the book\n  paths count from {}",
                path.display(),
                project.root.display()
            ));
        }
    }
    Ok(())
}

/// The files and folders that a command reads, if it writes none.
fn reads(verb: &Verb) -> Result<Vec<&Path>, String> {
    let inside = |reading: &Reading| {
        if reading.allow_outside {
            return Err("--allow-outside reads files outside of the course".to_owned());
        }
        Ok(())
    };
    let printed = |option: &str, path: &Path| {
        if is_standard(path) {
            return Ok(());
        }
        Err(format!("{option} {} writes a file", path.display()))
    };
    let no_file = |option: &str, path: &Option<PathBuf>| match path {
        Some(path) => Err(format!("{option} {} writes a file", path.display())),
        None => Ok(()),
    };
    Ok(match verb {
        Verb::Pixel(args) => {
            inside(&args.reading)?;
            vec![&args.scene]
        }
        Verb::Step(args) => {
            inside(&args.reading)?;
            if args.script.is_none() && !args.plain {
                return Err("step without --plain or --script draws in the terminal".into());
            }
            vec![&args.scene]
        }
        Verb::Trace(args) => {
            inside(&args.reading)?;
            printed("--output", &args.output)?;
            vec![&args.scene]
        }
        Verb::Compare(args) => {
            inside(&args.reading)?;
            no_file("--chart", &args.chart)?;
            if args.wide {
                return Err("--wide prints times, which differ from build to build".into());
            }
            vec![&args.scene]
        }
        Verb::Figure(args) => {
            printed("--output", &args.output)?;
            no_file("--write-log", &args.write_log)?;
            if args.steps {
                return Err("--steps writes files".into());
            }
            if args.png || args.pdf {
                return Err("--png and --pdf print no text".into());
            }
            if args.drawing.allow_outside {
                return Err("--allow-outside reads files outside of the course".into());
            }
            let mut read = vec![&*args.drawing.lessons];
            read.extend(args.scene.as_deref());
            read.extend(args.log.as_deref());
            read
        }
        Verb::Figures(args) if args.list => vec![&args.drawing.lessons],
        Verb::Figures(_) => return Err("figures without --list writes files".into()),
        Verb::Lesson(args) => match &args.verb {
            LessonVerb::List | LessonVerb::Show { .. } | LessonVerb::Hint { .. } => Vec::new(),
            LessonVerb::Quiz {
                script: Some(_),
                lessons,
                ..
            } => lessons.iter().map(|path| &**path).collect(),
            LessonVerb::Quiz { .. } => {
                return Err("lesson quiz without --script waits for answers".into());
            }
            LessonVerb::Worksheet { out, lessons, .. } => {
                printed("lesson worksheet to", out)?;
                lessons.iter().map(|path| &**path).collect()
            }
            LessonVerb::Start { .. } | LessonVerb::Export { .. } => {
                return Err("lesson start and lesson export write files".into());
            }
            LessonVerb::Check { .. } => return Err("lesson check compiles the exercises".into()),
        },
        Verb::Check(args) => {
            inside(&args.reading)?;
            if !args.no_picture {
                return Err("check without --no-picture writes a picture".into());
            }
            vec![&args.scene, &args.log]
        }
        Verb::Convert(args) => {
            inside(&args.reading)?;
            printed("convert to", &args.output)?;
            vec![&args.scene]
        }
        Verb::Schema(_) | Verb::Completions(_) => Vec::new(),
        Verb::Inspect(_) => return Err("inspect writes a page".into()),
        Verb::Render(_) => return Err("render writes a picture".into()),
        Verb::Book(_) => return Err("book builds a book".into()),
        Verb::Init(_) => return Err("init writes files".into()),
        Verb::Mdbook(_) => return Err("mdbook waits for a book".into()),
    })
}
