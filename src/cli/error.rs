//! What can go wrong with a command: what, where, what to do next.

use std::fmt;
use std::io;

use clap::error::{ContextKind, ContextValue};
use raystep::book::BookError;
use raystep::lesson::LessonError;
use raystep::lesson::check::CheckError;
use raystep::scene::{Fault, printable};
use raystep::step::{AddressError, CommandError};
use raystep::structure::{GridError, StructureError};
use raystep::trace::{LogError, Region};
use raystep::tracer::{LightError, LightSetting};
use raystep::{LoadError, Stopped, Transport};

/// Why a command did not do what it was asked to.
#[derive(Debug)]
pub(crate) enum Error {
    /// The arguments make no sense, or ask for help. It prints itself.
    Usage(clap::Error),
    /// A negative number among the arguments.
    Negative {
        /// The argument.
        argument: String,
    },
    /// The scene could not be loaded.
    Load(LoadError),
    /// There is nothing on standard input.
    EmptyInput,
    /// An input, or a line of it, is too long.
    TooLong {
        /// The input.
        file: String,
        /// What of it.
        what: &'static str,
        /// How many bytes it may have.
        bytes: u64,
    },
    /// A figure's subject and its options do not go together.
    Subject {
        /// What is wrong.
        what: String,
        /// What to do about it.
        fix: &'static str,
    },
    /// An exercise, or the folder of the exercises.
    Exercise {
        /// What is wrong.
        what: String,
        /// What to do about it.
        fix: String,
    },
    /// A course or its book, which cannot be built or begun.
    Course {
        /// What is wrong.
        what: String,
        /// What to do about it.
        fix: String,
    },
    /// The log could not be read.
    Log(LogError),
    /// A foreign log that cannot be checked.
    Check(CheckError),
    /// A lesson, or a figure of it.
    Lesson(Box<LessonError>),
    /// A book whose directives cannot be followed.
    Book(Box<BookError>),
    /// Figures that are not what would be drawn: a check that failed.
    Stale {
        /// Each with what is the matter with it.
        stale: Vec<String>,
        /// How many figures there are.
        of: usize,
        /// Their folder.
        out: String,
    },
    /// A drawing cannot become pixels or a page.
    Raster {
        /// Why.
        what: String,
        /// What to do about it.
        fix: &'static str,
    },
    /// An option has a value that makes no sense in a scene.
    Option {
        /// The option.
        option: &'static str,
        /// What is wrong with its value.
        fault: Fault,
    },
    /// The strategy does not look at an option.
    Unused {
        /// The option.
        option: &'static str,
        /// What was chosen instead, by an option or as its default.
        chosen: String,
        /// The options that choose each strategy that looks at it.
        users: Vec<String>,
    },
    /// The structure of the strategy cannot be built.
    Structure {
        /// Why.
        fault: StructureError,
    },
    /// Light cannot be followed through the scene.
    Light {
        /// The scene.
        file: String,
        /// Why.
        fault: LightError,
    },
    /// There is no such pixel.
    PixelOutside {
        /// The pixel.
        pixel: [u64; 2],
        /// The size of the picture.
        pixels: [u32; 2],
    },
    /// The region reaches out of the picture.
    RegionOutside {
        /// The region.
        region: Region,
        /// The size of the picture.
        pixels: [u32; 2],
    },
    /// New rays are needed, and there is only a log.
    NeedsScene {
        /// The log.
        file: String,
        /// What would trace anew.
        what: String,
    },
    /// The log does not hold what is asked for.
    NotInLog {
        /// The log.
        file: String,
        /// What is not there, and what is.
        what: String,
        /// What to do about it.
        fix: &'static str,
    },
    /// There is no ray of this number in the pixel.
    NoSuchRay {
        /// The number.
        ray: u32,
        /// The largest number; `None` if there is no ray at all.
        last: Option<u32>,
    },
    /// A step by its number leads nowhere.
    Address {
        /// Why.
        error: AddressError,
    },
    /// The script of a stepper is none.
    Script {
        /// Why.
        error: CommandError,
    },
    /// There are more events than the budget allows.
    Budget {
        /// The budget.
        budget: u64,
    },
    /// A page would be larger than it may be.
    PageTooLarge {
        /// How large it would be, or already is after some of its pixels.
        what: String,
        /// The most megabytes.
        most: u32,
        /// What to do about it.
        fix: &'static str,
    },
    /// A trace was stopped before its end.
    Stopped {
        /// Why.
        stopped: Stopped,
        /// Which rays were cast.
        transport: Transport,
    },
    /// Two things would go to standard output.
    StandardOutputTwice {
        /// What to do about it.
        fix: &'static str,
    },
    /// Two inputs that both are standard input.
    StandardInputTwice,
    /// Nothing can be written there.
    Target {
        /// The target, as it was given.
        file: String,
        /// What is wrong with it.
        what: String,
        /// What to do about it.
        fix: String,
    },
    /// Writing failed.
    Write {
        /// The target, as it was given.
        file: String,
        /// What the system said.
        source: io::Error,
    },
    /// The threads could not be started.
    Threads {
        /// What the system said.
        source: rayon::ThreadPoolBuildError,
    },
}

impl Error {
    /// Did a reader close the pipe that was written to?
    pub(crate) fn is_closed_pipe(&self) -> bool {
        matches!(self, Self::Write { source, .. } if source.kind() == io::ErrorKind::BrokenPipe)
    }

    /// What the command returns to the shell: 2 for usage and bad input, 1 for a check that failed, 0 for help.
    pub(crate) fn exit_code(&self) -> u8 {
        match self {
            Self::Usage(usage) => usage.exit_code() as u8,
            Self::Stale { .. } => 1,
            _ => 2,
        }
    }
}

impl fmt::Display for Error {
    #[expect(clippy::too_many_lines, reason = "an arm for each error")]
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Usage(usage) => usage.fmt(f),
            Self::Negative { argument } if argument.starts_with("--") => write!(
                f,
                "{}: no number of this command is negative\n  give a number of 0 or more",
                printable(argument)
            ),
            Self::Negative { argument } => write!(
                f,
                "{0}: no number of this command is negative; pixels count from 0,0 at the \
                 top left\n  if it is a file, write ./{0}",
                printable(argument)
            ),
            Self::Load(error @ LoadError::Outside { .. }) => {
                write!(f, "{error} with --allow-outside")
            }
            Self::Load(error @ LoadError::Form { schema: Some(schema), .. }) => {
                write!(f, "{error}: 'raystep schema {}' prints it", schema.name())
            }
            Self::Load(error) => error.fmt(f),
            Self::EmptyInput => f.write_str(
                "standard input is empty\n  give it a scene or a log, as in: raystep trace scene.json | raystep pixel - 80,60",
            ),
            Self::TooLong { file, what, bytes } => write!(
                f,
                "{}: {what} has more than {} GiB\n  give a smaller scene",
                printable(file),
                bytes >> 30
            ),
            Self::Log(error @ (LogError::Line { .. } | LogError::NoLog { .. })) => write!(f, "{error} with 'raystep trace'"),
            Self::Log(error) => error.fmt(f),
            Self::Check(error) => error.fmt(f),
            Self::StandardInputTwice => f.write_str(
                "the scene and the log cannot both come from standard input\n  name a file for one of them",
            ),
            Self::Lesson(error) => {
                error.fmt(f)?;
                match &**error {
                    LessonError::Folder { .. } => f.write_str(" with --lessons"),
                    LessonError::Figure { error, .. } if error.is_of_log => {
                        f.write_str(", with raystep figure NAME --write-log F.jsonl")
                    }
                    _ => Ok(()),
                }
            }
            Self::Book(error) => error.fmt(f),
            Self::Stale { stale, of, out } => write!(
                f,
                "{}\n{} of the {of} figures are not what is drawn today\n  draw them again: raystep figures --out {}",
                stale
                    .iter()
                    .map(|stale| printable(stale))
                    .collect::<Vec<_>>()
                    .join("\n"),
                stale.len(),
                printable(out)
            ),
            Self::Raster { what, fix } | Self::Subject { what, fix } => {
                write!(f, "{}\n  {fix}", printable(what))
            }
            Self::Exercise { what, fix } | Self::Course { what, fix } => write!(f, "{}\n  {}", printable(what), printable(fix)),
            Self::Option { option, fault } => write!(f, "{option}: {fault}\n  {}", fault.fix()),
            Self::Unused {
                option,
                chosen,
                users,
            } => write!(
                f,
                "{option} has no effect with {chosen}\n  omit it, or use {}",
                users.join(" or ")
            ),
            Self::Structure { fault } => match option_of(fault) {
                Some(option) => write!(f, "{option}: {fault}"),
                None => fault.fmt(f),
            },
            Self::Light { file, fault } => {
                let option = |setting: LightSetting| format!("--{}", setting.name());
                let (what, fix) = (fault.what(option), fault.fix_with(option));
                write!(f, "{}: {what}\n  {fix}", printable(file))
            }
            Self::PixelOutside {
                pixel: [x, y],
                pixels,
            } => {
                write!(f, "the picture has no pixel {x},{y}\n  {}", Inside(*pixels))
            }
            Self::RegionOutside { region, pixels } => {
                write!(
                    f,
                    "the picture does not contain the region {region}\n  {}",
                    Inside(*pixels)
                )
            }
            Self::NeedsScene { file, what } => write!(
                f,
                "{}: this is a log, and {what} new rays, which need the scene\n  \
                 give the scene; 'raystep convert' extracts it from the log",
                printable(file)
            ),
            Self::NotInLog { file, what, fix } => {
                write!(f, "{}: {}\n  {fix}", printable(file), printable(what))
            }
            Self::NoSuchRay {
                ray,
                last: Some(last),
            } => write!(
                f,
                "the pixel has no ray {ray}\n  choose one from 0 to {last}"
            ),
            Self::NoSuchRay { ray, last: None } => write!(
                f,
                "the pixel has no ray {ray}: no ray was traced for it, or the log has none\n  omit --ray"
            ),
            Self::Address { error } => write!(f, "--at: {error}"),
            Self::Script { error } => write!(f, "--script: {error}"),
            Self::Budget { budget } => write!(
                f,
                "the budget of {budget} events is used up\n  \
                 narrow the trace with --region or --only, lower --max-depth, or raise --budget"
            ),
            Self::PageTooLarge { what, most, fix } => write!(
                f,
                "{what}, and it may have {most} MB\n  {fix}, or raise --megabytes"
            ),
            Self::Stopped { stopped, transport } => {
                let fewer = option_for_fewer_rays(*transport);
                write!(f, "{stopped}\n  lower {fewer}, or raise --max-rays")
            }
            Self::StandardOutputTwice { fix } => write!(
                f,
                "--stats=json and the command itself cannot both write to standard output\n  {fix}"
            ),
            Self::Target { file, what, fix } => {
                write!(f, "{}: {}\n  {fix}", printable(file), printable(what))
            }
            Self::Write { file, source } => {
                let fix = match source.kind() {
                    io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => {
                        "free some space there, or choose another folder"
                    }
                    io::ErrorKind::FileTooLarge => {
                        "raise the limit ('ulimit -f' shows it), or narrow what is written"
                    }
                    _ => "check the folder, or choose another one",
                };
                write!(f, "{}: cannot be written: {source}\n  {fix}", printable(file))
            }
            Self::Threads { source } => {
                write!(
                    f,
                    "the threads cannot be started: {source}\n  give a smaller --threads"
                )
            }
        }
    }
}

impl std::error::Error for Error {}

/// The option that lowers the number of rays of a pixel.
fn option_for_fewer_rays(transport: Transport) -> &'static str {
    match transport {
        // its paths end by chance, and branch nowhere
        Transport::HybridConnected => "--samples or --bounces",
        _ => "--max-depth",
    }
}

/// The option that a structure cannot be built with, if there is one alone.
fn option_of(fault: &StructureError) -> Option<&'static str> {
    match fault {
        StructureError::NoSlabs | StructureError::Slabs(_) => Some("--slabs scene"),
        StructureError::Grid(GridError::Density { .. }) => Some("--density"),
        StructureError::Grid(
            GridError::NoCells { .. } | GridError::TooManyAlong { .. } | GridError::TooThin { .. },
        ) => Some("--grid"),
        StructureError::Grid(GridError::TooManyCells { .. } | GridError::TooManyEntries { .. }) => {
            None
        }
    }
}

/// The numbers that columns and rows have.
struct Inside([u32; 2]);

impl fmt::Display for Inside {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [right, bottom] = self.0.map(|side| side.saturating_sub(1));
        write!(
            f,
            "columns go from 0 to {right} and rows from 0 to {bottom}"
        )
    }
}

impl From<clap::Error> for Error {
    fn from(mut error: clap::Error) -> Self {
        // what was typed is repeated in the message, and may come from a file's name
        let typed = [
            ContextKind::InvalidArg,
            ContextKind::InvalidSubcommand,
            ContextKind::InvalidValue,
        ];
        for kind in typed {
            if let Some(ContextValue::String(text)) = error.get(kind) {
                let text = printable(text);
                error.insert(kind, ContextValue::String(text));
            }
        }
        Self::Usage(error)
    }
}

impl From<LoadError> for Error {
    fn from(error: LoadError) -> Self {
        Self::Load(error)
    }
}

impl From<LogError> for Error {
    fn from(error: LogError) -> Self {
        Self::Log(error)
    }
}

impl From<CheckError> for Error {
    fn from(error: CheckError) -> Self {
        Self::Check(error)
    }
}

impl From<LessonError> for Error {
    fn from(error: LessonError) -> Self {
        match error {
            LessonError::Load(error) => Self::Load(error),
            LessonError::Log(error) => Self::Log(error),
            other => Self::Lesson(Box::new(other)),
        }
    }
}

impl From<BookError> for Error {
    fn from(error: BookError) -> Self {
        Self::Book(Box::new(error))
    }
}
