//! The stepper in a terminal: what its keys ask for beyond a log.

use std::io::{self, IsTerminal, Write};

use anstream::{AutoStream, ColorChoice};
use clap::ArgMatches;
use raystep::explain::strategy_title;
use raystep::lesson::thumbnail;
use raystep::step::{Cursor, StepLog, same_place};
use raystep::tui::{App, Colours, Effect, Kept, Look, Screen, Titles, restore};

use crate::cli::Error;
use crate::cli::args::StepArgs;
use crate::cli::input::name_of;
use crate::cli::pixel::Traced;
use crate::cli::signals::before_the_end;
use crate::cli::step::next::Next;
use crate::cli::step::save::save;
use crate::cli::step::session::{Another, Session};

/// The small picture is no larger: half as many rows of letters.
const PICTURE: [u32; 2] = [32, 24];

/// What a shell makes of Ctrl-C.
const INTERRUPTED: i32 = 130;

/// Is there a terminal that can show more than lines, at both ends?
pub(crate) fn is_there() -> bool {
    let is_dumb = std::env::var_os("TERM").is_none_or(|term| term.is_empty() || term == "dumb");
    // on Windows there is no such variable, and the console is asked itself
    let is_dumb = is_dumb && !cfg!(windows);
    !is_dumb && io::stdin().is_terminal() && io::stdout().is_terminal()
}

/// What the terminal can show.
fn look(args: &StepArgs) -> Look {
    let has = |name: &str, words: &[&str]| {
        let value = std::env::var(name).unwrap_or_default();
        words.iter().any(|word| value.contains(word))
    };
    let colours = match AutoStream::choice(&io::stdout()) {
        ColorChoice::Never => Colours::None,
        _ if has("COLORTERM", &["truecolor", "24bit"]) => Colours::All,
        _ if has("TERM", &["256"]) => Colours::Many,
        _ => Colours::Sixteen,
    };
    Look {
        colours,
        is_ascii: args.ascii,
    }
}

/// Steps through a pixel until the reader has enough. Commands and names of files that were asked for are printed at the end, when
/// the terminal shows again what was there before.
pub(crate) fn run(args: &StepArgs, matches: &ArgMatches) -> Result<(), Error> {
    let (mut session, traced) = Session::open(args, matches)?;
    traced.tell_stats(&args.scene, args.tracing.stats)?;
    let at = session.start(args, &traced)?;
    let failed = |source| Error::Write {
        file: "the terminal".into(),
        source,
    };
    before_the_end(restore);
    let mut screen = Screen::open(look(args)).map_err(failed)?;
    let mut told = Vec::new();
    let ended = show(args, &mut session, (traced, at), &mut screen, &mut told);
    drop(screen);
    let end = ended.map_err(failed)?;
    let mut out = io::stdout().lock();
    for text in &told {
        writeln!(out, "{text}").map_err(failed)?;
    }
    out.flush().map_err(failed)?;
    if end == Effect::Interrupt {
        std::process::exit(INTERRUPTED);
    }
    Ok(())
}

/// Shows log after log, each from a step on.
fn show(
    args: &StepArgs,
    session: &mut Session,
    (mut traced, mut at): (Traced, Option<usize>),
    screen: &mut Screen,
    told: &mut Vec<String>,
) -> io::Result<Effect> {
    let mut kept = Kept::new(args.predict);
    let mut said = String::new();
    loop {
        let log = StepLog::new(&traced.scene, &traced.settings, &traced.records);
        let Some(cursor) = Cursor::at_start(&log) else {
            return Ok(Effect::Quit);
        };
        let cursor = at.map_or(cursor, |step| Cursor::at(&log, step));
        let titles = Titles {
            scene: name_of(&args.scene),
            pixel: session.pixel,
            strategy: strategy_title(&traced.settings),
        };
        let mut app = App::new(&log, cursor, kept, titles);
        app.say(&said);
        let next = loop {
            // the frame comes before the picture, which may take a while
            screen.show(&mut app)?;
            if app.needs_picture() {
                app.set_picture(thumbnail(&traced.scene, PICTURE));
            }
            let effect = screen.next(&mut app)?;
            let next = match effect {
                Effect::Save => {
                    match save(&log, app.here(), &session.words) {
                        Ok(text) => {
                            app.say(&text);
                            told.push(text);
                        }
                        // another step may be drawn, or another folder be free
                        Err(error) => app.say(&error.to_string()),
                    }
                    continue;
                }
                Effect::Address => {
                    let text = session.words.command(&log.address(app.here()).to_string());
                    app.say(&text);
                    told.push(text);
                    continue;
                }
                Effect::Strategy => Next::Strategy,
                Effect::Pixel(shift) => Next::Pixel(shift),
                Effect::Quit | Effect::Interrupt => return Ok(effect),
            };
            match session.another(next, &traced) {
                Another::Traced(next, text) => {
                    said = text;
                    break next;
                }
                Another::None(text) => app.say(&text),
            }
        };
        let other = StepLog::new(&next.scene, &next.settings, &next.records);
        at = same_place(&log, app.here(), &other);
        kept = app.keep();
        traced = *next;
    }
}
