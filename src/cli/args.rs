//! What can be said on the command line.

mod book;
mod check;
mod colours;
mod figures;
mod inspect;
mod lesson;
mod step;
mod tracing;
mod values;

use std::path::PathBuf;

use clap::{Args as ClapArgs, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use raystep::trace::{Kind, Region};
use raystep::tracer::HeatOf;

use crate::cli::word::one_of;
pub(crate) use book::{BookArgs, BookVerb, InitArgs};
pub(crate) use check::{CheckArgs, CheckFormat};
pub(crate) use colours::Colours;
pub(crate) use figures::{
    Drawing, FigureArgs, FiguresArgs, MdbookArgs, MdbookVerb, Subject, WidthName,
};
pub(crate) use inspect::InspectArgs;
pub(crate) use lesson::{LessonArgs, LessonVerb, ReportFormat};
pub(crate) use step::StepArgs;
pub(crate) use tracing::{Casting, Reading, Tracing};
pub(crate) use values::refuse_negative;
use values::{kind, pixel};

/// The most threads that one may ask for: no machine has more cores, and to start many more takes longer than to trace.
const MOST_THREADS: i64 = 1024;

/// A ray tracer that shows its working.
#[derive(Debug, Parser)]
#[command(name = "raystep", version, arg_required_else_help = true)]
#[command(after_help = "Start with:\n  raystep pixel lessons/04-sphere/scene.json 80,60")]
pub(crate) struct Args {
    /// What is to be done.
    #[command(subcommand)]
    pub(crate) verb: Verb,
    /// Print no notes and no progress; errors are still printed
    #[arg(long, global = true, help_heading = "Messages")]
    pub(crate) quiet: bool,
    /// When to use colours: in a terminal unless NO_COLOR is set (auto), always, or never
    #[arg(long, global = true, help_heading = "Messages")]
    #[arg(value_enum, default_value = "auto")]
    #[arg(
        hide_possible_values = true,
        hide_default_value = true,
        value_name = "auto|always|never"
    )]
    pub(crate) color: Colours,
}

/// What can be done.
#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Print the worked solution of one pixel.
    Pixel(PixelArgs),
    /// Step through one pixel, forwards and backwards.
    Step(StepArgs),
    /// Write a page on which one steps through the pixels of a picture, in one file.
    Inspect(InspectArgs),
    /// Write every step as a log in JSON Lines.
    Trace(TraceArgs),
    /// Write the picture as PNG.
    Render(RenderArgs),
    /// Compare the cost of the strategies on the same rays, or the five kinds of ray tracing.
    Compare(CompareArgs),
    /// Draw a figure of a lesson as SVG.
    Figure(FigureArgs),
    /// Draw all figures of the lessons, or check that existing ones are up to date.
    Figures(FiguresArgs),
    /// Write out the course's exercises, list and check them, and give hints.
    Lesson(LessonArgs),
    /// Check the log of a ray tracer in any language against a scene.
    Check(CheckArgs),
    /// Write a scene in NFF, OBJ or JSON, or the scene of a log, as JSON.
    Convert(ConvertArgs),
    /// Print the JSON Schema of scenes, lessons or logs.
    Schema(SchemaArgs),
    /// Print completions for a shell.
    Completions(CompletionsArgs),
    /// Build a book whose figures, numbers and questions come from its lessons.
    Book(BookArgs),
    /// Begin a course of your own: a book, a lesson, and a workflow that publishes it.
    Init(InitArgs),
    /// Expand the directives in an mdBook; mdBook calls this.
    Mdbook(MdbookArgs),
}

/// Text or JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For reading.
    Text,
    /// For programs.
    Json,
}

/// How a worked solution is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PixelFormat {
    /// Lines, in colour on a terminal.
    Text,
    /// The tree of rays with their events, for programs.
    Json,
    /// Nested lists in Markdown.
    Markdown,
    /// A document in HTML.
    Html,
}

/// The worked solution of one pixel.
#[derive(Debug, ClapArgs)]
#[command(after_help = "Examples:
  raystep pixel scene.json 80,60
  raystep pixel scene.json 80,60 --only sphere_test,plane_test
  raystep trace scene.json --region 80,60 | raystep pixel - 80,60")]
pub(crate) struct PixelArgs {
    /// Scene (.json, .nff, .obj) or log; - is standard input
    pub(crate) scene: PathBuf,
    /// Column and row, counted from 0,0 at the top left
    #[arg(value_name = "X,Y", value_parser = pixel)]
    pub(crate) pixel: [u64; 2],
    /// Kinds of event to show, such as sphere_test,plane_test
    #[arg(long, value_name = "KINDS", value_delimiter = ',', value_parser = kind)]
    pub(crate) only: Vec<Kind>,
    /// Show one ray only, by its number
    #[arg(long, value_name = "N")]
    pub(crate) ray: Option<u32>,
    /// Show every test in full, also where many tests miss
    #[arg(long)]
    pub(crate) all: bool,
    /// The most events of the pixel: all are kept in memory, 168 bytes each
    #[arg(long, value_name = "N", default_value_t = 2_000_000)]
    pub(crate) budget: u64,
    /// Text, JSON with the tree of rays, a list in Markdown, or a page in HTML
    #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
    #[arg(value_name = "text|json|markdown|html")]
    pub(crate) format: PixelFormat,
    /// What may be read.
    #[command(flatten)]
    pub(crate) reading: Reading,
    /// How it is traced.
    #[command(flatten)]
    pub(crate) tracing: Tracing,
}

/// The log of a picture.
#[derive(Debug, ClapArgs)]
#[command(after_help = "Examples:
  raystep trace scene.json --region 70,50-90,70 -o part.jsonl
  raystep trace part.jsonl --only sphere_test | jq .discriminant")]
pub(crate) struct TraceArgs {
    /// Scene (.json, .nff, .obj), or a log to filter again; - is standard input
    pub(crate) scene: PathBuf,
    /// File of the log; - is standard output
    #[arg(short, long, value_name = "F.jsonl", default_value = "-")]
    pub(crate) output: PathBuf,
    /// Pixels to keep: X,Y, or a rectangle by its top left and its bottom right pixel
    #[arg(long, value_name = "X0,Y0-X1,Y1")]
    pub(crate) region: Option<Region>,
    /// Kinds of event to keep
    #[arg(long, value_name = "KINDS", value_delimiter = ',', value_parser = kind)]
    pub(crate) only: Vec<Kind>,
    /// The most events to write; with more the command ends with an error
    #[arg(long, value_name = "N", default_value_t = 10_000_000)]
    pub(crate) budget: u64,
    /// Number of threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=MOST_THREADS))]
    pub(crate) threads: Option<u16>,
    /// What may be read.
    #[command(flatten)]
    pub(crate) reading: Reading,
    /// How it is traced.
    #[command(flatten)]
    pub(crate) tracing: Tracing,
}

/// The picture.
#[derive(Debug, ClapArgs)]
#[command(after_help = "Examples:
  raystep render scene.json -o picture.png --stats
  raystep render scene.json -o cost.png --heatmap tests --strategy hierarchy")]
pub(crate) struct RenderArgs {
    /// Scene (.json, .nff, .obj); - is standard input
    pub(crate) scene: PathBuf,
    /// File of the picture; - is standard output
    #[arg(short, long, value_name = "F.png")]
    pub(crate) output: PathBuf,
    /// Show the cost of each pixel, from dark blue (low) to yellow (high), with a legend below; a small picture is
    /// enlarged to the width of the legend
    #[arg(long, value_parser = one_of::<HeatOf>(), value_name = "WHAT")]
    pub(crate) heatmap: Option<HeatOf>,
    /// Number of threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=MOST_THREADS))]
    pub(crate) threads: Option<u16>,
    /// What may be read.
    #[command(flatten)]
    pub(crate) reading: Reading,
    /// How it is traced.
    #[command(flatten)]
    pub(crate) tracing: Tracing,
}

/// The strategies side by side, or the kinds of ray tracing.
#[derive(Debug, ClapArgs)]
#[command(after_help = "Examples:
  raystep compare scene.json --chart cost.svg
  raystep compare scene.json 80,60 --format json
  raystep compare scene.json --transports --paths 1000000")]
pub(crate) struct CompareArgs {
    /// Scene (.json, .nff, .obj); - is standard input
    pub(crate) scene: PathBuf,
    /// Compare the rays of one pixel only: column and row, counted from 0,0 at the top left
    #[arg(value_name = "X,Y", value_parser = pixel)]
    pub(crate) pixel: Option<[u64; 2]>,
    /// Compare the five kinds of ray tracing: how many rays each casts, how many of them contribute light, and the
    /// error of the light
    #[arg(long, conflicts_with_all = ["pixel", "chart", "transport", "through"])]
    pub(crate) transports: bool,
    /// Text, JSON with all counts, or CSV
    #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
    #[arg(value_name = "text|json|csv")]
    pub(crate) format: TableFormat,
    /// In text: show all columns, also each kind of test, times and memory; wider than 80 characters
    #[arg(long)]
    pub(crate) wide: bool,
    /// Draw the numbers of tests as bars on a logarithmic axis
    #[arg(long, value_name = "F.svg")]
    pub(crate) chart: Option<PathBuf>,
    /// Number of threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=MOST_THREADS))]
    pub(crate) threads: Option<u16>,
    /// What may be read.
    #[command(flatten)]
    pub(crate) reading: Reading,
    /// Which rays there are.
    #[command(flatten)]
    pub(crate) casting: Casting,
}

/// Text, JSON or CSV.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum TableFormat {
    /// For reading.
    Text,
    /// For programs.
    Json,
    /// For tables.
    Csv,
}

impl TableFormat {
    /// Its word.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Json => "json",
            Self::Csv => "csv",
        }
    }
}

/// A scene in JSON.
#[derive(Debug, ClapArgs)]
#[command(after_help = "Example:\n  raystep convert teapot.nff teapot.json")]
pub(crate) struct ConvertArgs {
    /// Scene (.json, .nff, .obj) or log; - is standard input
    #[arg(value_name = "IN")]
    pub(crate) scene: PathBuf,
    /// The scene in JSON; - is standard output
    #[arg(value_name = "OUT.json")]
    pub(crate) output: PathBuf,
    /// What may be read.
    #[command(flatten)]
    pub(crate) reading: Reading,
}

/// A JSON Schema.
#[derive(Debug, ClapArgs)]
#[command(after_help = "Example:\n  raystep schema scene > scene.schema.json")]
pub(crate) struct SchemaArgs {
    /// Of what
    #[arg(value_enum)]
    pub(crate) of: SchemaOf,
}

/// What has a schema.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum SchemaOf {
    /// A scene file
    Scene,
    /// A lesson file
    Lesson,
    /// One line of a log
    Trace,
}

/// Completions.
#[derive(Debug, ClapArgs)]
#[command(after_help = "Example:
  raystep completions bash > ~/.local/share/bash-completion/completions/raystep")]
pub(crate) struct CompletionsArgs {
    /// Which shell
    #[arg(value_enum)]
    pub(crate) shell: Shell,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn clap_finds_no_contradiction_in_the_arguments() {
        Args::command().debug_assert();
    }

    #[test]
    fn at_most_ten_options_stand_under_a_heading_of_any_help() {
        /// More is no list that one reads.
        const MOST: usize = 10;
        let mut command = Args::command();
        command.build();
        let mut verbs = 0;
        for verb in command.get_subcommands().chain([&command]) {
            let options = verb
                .get_arguments()
                .filter(|arg| !arg.is_positional() && !arg.is_hide_set());
            let mut headings = std::collections::BTreeMap::<&str, Vec<&str>>::new();
            for option in options {
                let heading = option.get_help_heading().unwrap_or("Options");
                headings
                    .entry(heading)
                    .or_default()
                    .push(option.get_id().as_str());
            }
            // the test sees what the help shows: --help stands everywhere, but in the help of help
            let has_help = headings
                .get("Options")
                .is_some_and(|all| all.contains(&"help"));
            assert!(has_help || verb.get_name() == "help", "{}", verb.get_name());
            for (heading, options) in headings {
                assert!(
                    options.len() <= MOST,
                    "{} {heading}: {options:?}",
                    verb.get_name()
                );
            }
            verbs += 1;
        }
        // ten verbs, help and the command itself
        assert!(11 <= verbs, "{verbs}");
    }
}
