//! The arguments of `raystep lesson`.

use std::path::PathBuf;

use clap::{Args as ClapArgs, Subcommand, ValueEnum};

/// The exercises of the course.
#[derive(Debug, ClapArgs)]
#[command(after_help = "Examples:
  raystep lesson start my-tracer
  raystep lesson export handout --raystep https://example.org/raystep.git
  raystep lesson export grading --secret ygrjvchqmtzwfkaelbnu
  raystep lesson show 04
  raystep lesson quiz 04
  raystep lesson hint 04 roots
  raystep lesson check 04 roots
  raystep lesson worksheet 12 --seed 7 -o sheet.md
  raystep lesson worksheet 12 --seed 7 --answers -o key.md")]
pub(crate) struct LessonArgs {
    /// What is to be done.
    #[command(subcommand)]
    pub(crate) verb: LessonVerb,
}

/// What can be done with exercises.
#[derive(Debug, Subcommand)]
pub(crate) enum LessonVerb {
    /// Write out the course with its exercises, ready to run.
    Start {
        /// A new or an empty folder
        #[arg(value_name = "DIR")]
        dir: PathBuf,
        /// Where the exercises get raystep from: a folder with its source, a Git repository, or a version [default: this version]
        #[arg(long, value_name = "PATH|URL|VERSION")]
        raystep: Option<String>,
    },
    /// Write what a lecturer hands out: the exercises without solutions, and a workflow that checks each.
    ///
    /// With --secret, write the folder in which the lecturer checks the hand-in instead: its cases are made from the secret alone. The
    /// solutions of the public course are public.
    Export {
        /// A new or an empty folder
        #[arg(value_name = "DIR")]
        dir: PathBuf,
        /// Write the folder that checks the hand-in, with cases made from this text
        #[arg(long, value_name = "SEED")]
        secret: Option<String>,
        /// Where the exercises get raystep from: a folder with its source, a Git repository, or a version [default: this version]
        #[arg(long, value_name = "PATH|URL|VERSION")]
        raystep: Option<String>,
    },
    /// List all exercises with what their last check said: ○ not written, ◐ not right, ● right.
    List,
    /// Show the exercises of a lesson: functions, parts and where to write them.
    Show {
        /// Number of the lesson, such as 04
        lesson: u8,
    },
    /// Give a hint: a nudge, then the formula, then the line.
    Hint {
        /// Number of the lesson, such as 04
        lesson: u8,
        /// Name of the exercise, such as roots
        exercise: String,
        /// How far to go: 1 is a nudge, 2 the formula, 3 the line
        #[arg(long, value_name = "1|2|3", default_value_t = 1)]
        #[arg(value_parser = clap::value_parser!(u8).range(1..=3))]
        depth: u8,
    },
    /// Ask the questions of a lesson. After each answer every choice is shown with its reason.
    Quiz {
        /// Number of the lesson, such as 04
        lesson: u8,
        /// Ask this question alone; may be given several times
        #[arg(long, value_name = "NAME")]
        only: Vec<String>,
        /// Answers with semicolons between them, such as 'b; a c; 2.5; skip'
        #[arg(long, value_name = "ANSWERS")]
        #[arg(allow_hyphen_values = true)]
        script: Option<String>,
        /// Folder of the lessons [default: this folder, or lessons in it, or the course as it came]
        #[arg(long, value_name = "DIR")]
        lessons: Option<PathBuf>,
    },
    /// Write a worksheet: a lesson's questions with numbers of their own for each seed, as Markdown that prints.
    Worksheet {
        /// Number of the lesson, such as 12
        lesson: u8,
        /// What the numbers are drawn with: the same seed gives the same sheet
        #[arg(long, value_name = "S")]
        seed: u64,
        /// Write the key: each answer with why the others are wrong, and the worked solution
        #[arg(long)]
        answers: bool,
        /// The file
        #[arg(short, long, value_name = "FILE", default_value = "-")]
        out: PathBuf,
        /// The folder of the lessons [default: lessons here, else those of the program]
        #[arg(long, value_name = "DIR")]
        lessons: Option<PathBuf>,
    },
    /// Check the exercises: all, those of a lesson, or one.
    Check {
        /// Number of the lesson, such as 04
        lesson: Option<u8>,
        /// Name of the exercise, such as roots
        exercise: Option<String>,
        /// Text, JSON, or the XML of JUnit
        #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
        #[arg(value_name = "text|json|junit")]
        format: ReportFormat,
        /// The most CPU time of one exercise, in seconds
        #[arg(long, value_name = "SECONDS", default_value_t = 10)]
        #[arg(value_parser = clap::value_parser!(u16).range(1..=3600))]
        limit: u16,
    },
}

/// How the results of a check are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ReportFormat {
    /// For reading.
    Text,
    /// For programs.
    Json,
    /// For systems that collect the results of tests.
    Junit,
}

impl ReportFormat {
    /// Its word.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Json => "json",
            Self::Junit => "junit",
        }
    }
}
