//! `raystep step`: through one pixel step by step, in a terminal, or as text: commands in, one step after the other out.
//!
//! The text is the face for screen readers, scripts and tests, and where there is no terminal.

mod address;
mod commands;
mod next;
mod plain;
mod save;
mod session;
#[cfg(feature = "tui")]
mod terminal;

use clap::ArgMatches;
use raystep::step::{Address, Cursor, StepLog, commands, same_place};

use crate::cli::Error;
use crate::cli::args::{Format, StepArgs};
use crate::cli::output::Output;
use crate::cli::step::commands::Commands;
use crate::cli::step::next::Next;
use crate::cli::step::plain::Face;
use crate::cli::step::session::{Another, Session};

/// Steps through a pixel.
pub(crate) fn run(args: &StepArgs, matches: &ArgMatches) -> Result<(), Error> {
    if args.tracing.stats == Some(Format::Json) {
        return Err(Error::StandardOutputTwice {
            fix: "use --stats, which writes to standard error",
        });
    }
    let script = match &args.script {
        Some(script) => Some(commands(script).map_err(|error| Error::Script { error })?),
        None => None,
    };
    #[cfg(feature = "tui")]
    if script.is_none() && !args.plain && terminal::is_there() {
        return terminal::run(args, matches);
    }
    let (session, traced) = Session::open(args, matches)?;
    traced.tell_stats(&args.scene, args.tracing.stats)?;
    as_text(args, session, traced, Commands::new(script))
}

/// Does what commands say, and prints steps.
fn as_text(
    args: &StepArgs,
    mut session: Session,
    mut traced: super::pixel::Traced,
    mut input: Commands,
) -> Result<(), Error> {
    let mut out = Output::standard();
    let mut at = session.start(args, &traced)?;
    let (mut filter, mut predicts) = (None, args.predict);
    loop {
        let (next, place) = {
            let log = StepLog::new(&traced.scene, &traced.settings, &traced.records);
            let Some(cursor) = Cursor::at_start(&log) else {
                return Ok(());
            };
            let cursor = at.map_or(cursor, |step| Cursor::at(&log, step));
            let mut face = Face::new(&log, cursor, filter.take(), predicts);
            face.show(&mut out)?;
            let next = loop {
                let Some(command) = input.next(&mut out)? else {
                    return out.finish();
                };
                match face.obey(command, &session.words, &mut out)? {
                    Next::Here => {}
                    Next::Quit => return out.finish(),
                    next => match session.another(next, &traced) {
                        Another::Traced(traced, text) => {
                            plain::say(&text, &mut out)?;
                            break traced;
                        }
                        Another::None(text) => plain::say(&text, &mut out)?,
                    },
                }
            };
            filter = face.reader.filter().cloned();
            predicts = face.reader.predicts();
            let other = StepLog::new(&next.scene, &next.settings, &next.records);
            let place = same_place(&log, face.reader.here(), &other);
            (*next, place)
        };
        (traced, at) = (next, place);
    }
}

/// The address of a step as `--at` takes it.
fn address_of(log: &StepLog, event: usize) -> String {
    Address::of(log, event).to_string()
}
