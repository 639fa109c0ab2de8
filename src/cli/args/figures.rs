//! The arguments of the verbs that draw figures, and of the preprocessor that puts them into a book.

use std::path::PathBuf;

use clap::{Args as ClapArgs, Subcommand, ValueEnum};
use raystep::FigureName;
use raystep::figure::FigureKind;

use crate::cli::args::values::pixel;
use crate::cli::word::one_of;

/// How a figure is drawn.
#[derive(Debug, ClapArgs)]
#[command(next_help_heading = "Drawing")]
#[expect(
    clippy::struct_excessive_bools,
    reason = "the flags of a command line do not depend on each other"
)]
pub(crate) struct Drawing {
    /// Folder of the lessons
    #[arg(long, value_name = "DIR", default_value = "lessons")]
    pub(crate) lessons: PathBuf,
    /// Allow scenes outside their lesson's folder
    #[arg(long)]
    pub(crate) allow_outside: bool,
    /// Size: for the column of a book, or for a slide of 16:9 with large letters
    #[arg(long, value_enum, value_name = "FOR", default_value = "book")]
    pub(crate) width: WidthName,
    /// Use shades of grey, for print
    #[arg(long)]
    pub(crate) grayscale: bool,
    /// Set the figure's title above it
    #[arg(long)]
    pub(crate) titled: bool,
    /// Use fixed colours, which every program can read, instead of the colours of the web page
    #[arg(long)]
    pub(crate) standalone: bool,
}

/// For what a figure is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum WidthName {
    /// A column of a book.
    Book,
    /// A slide.
    Slide,
}

/// One figure.
#[derive(Debug, ClapArgs)]
#[command(after_help = "Examples:
  raystep figure 12-grid/walk -o walk.svg
  raystep figure 12-grid/walk --width slide --standalone -o walk.svg
  raystep figure 12-grid/walk --stages
  raystep figure --scene my.json 80,60 --kind grid -o grid.svg
  raystep figure 12-grid/walk --steps -o walk.svg
  raystep figure 12-grid/walk --write-log walk.jsonl -o walk.svg
  raystep figure 12-grid/walk --log walk.jsonl -o walk.svg")]
#[expect(
    clippy::struct_excessive_bools,
    reason = "the flags of a command line do not depend on each other"
)]
pub(crate) struct FigureArgs {
    /// Lesson and figure, such as 12-grid/walk; with --scene the pixel, such as 80,60
    #[arg(value_name = "LESSON/NAME", value_parser = subject)]
    pub(crate) subject: Subject,
    /// Draw a figure of this scene, which no lesson knows
    #[arg(long, value_name = "SCENE", requires = "kind", conflicts_with_all = ["log", "write_log"])]
    pub(crate) scene: Option<PathBuf>,
    /// What is drawn of the scene
    #[arg(long, requires = "scene", value_parser = one_of::<FigureKind>(), hide_possible_values = true)]
    pub(crate) kind: Option<FigureKind>,
    /// File of the figure: .svg, or .png and .pdf if this program was built with the feature raster; - is standard
    /// output
    #[arg(short, long, value_name = "F.svg", default_value = "-")]
    pub(crate) output: PathBuf,
    /// Write PNG
    #[arg(long, conflicts_with = "pdf")]
    pub(crate) png: bool,
    /// Write PDF
    #[arg(long)]
    pub(crate) pdf: bool,
    /// Draw the trace only up to this step of the log
    #[arg(long, help_heading = "Stages", value_name = "N", conflicts_with_all = ["stage", "steps", "stages"])]
    pub(crate) step: Option<u32>,
    /// Draw the figure only up to this stage of its argument
    #[arg(long, help_heading = "Stages", value_name = "N", conflicts_with_all = ["steps", "stages"])]
    pub(crate) stage: Option<u32>,
    /// Write a file for each stage of the figure's argument: F-1.svg, F-2.svg, …; or a PDF with a page for each
    #[arg(long, help_heading = "Stages")]
    pub(crate) steps: bool,
    /// Write no figure; print its stages, with what each says
    #[arg(long, help_heading = "Stages", conflicts_with_all = ["steps", "output", "png", "pdf"])]
    pub(crate) stages: bool,
    /// Draw from this log of the figure, without its scene
    #[arg(long, value_name = "F.jsonl")]
    pub(crate) log: Option<PathBuf>,
    /// Write the log that the figure is drawn from
    #[arg(long, value_name = "F.jsonl", conflicts_with = "log")]
    pub(crate) write_log: Option<PathBuf>,
    /// How it is drawn.
    #[command(flatten)]
    pub(crate) drawing: Drawing,
}

/// What a figure is of.
#[derive(Clone, Debug)]
pub(crate) enum Subject {
    /// A figure of a lesson.
    Figure(FigureName),
    /// A pixel of a scene.
    Pixel([u64; 2]),
}

fn subject(text: &str) -> Result<Subject, String> {
    match pixel(text) {
        Ok(pixel) => Ok(Subject::Pixel(pixel)),
        Err(_) => text.parse().map(Subject::Figure),
    }
}

/// All figures.
#[derive(Debug, ClapArgs)]
#[command(after_help = "Examples:
  raystep figures --list
  raystep figures --out figures
  raystep figures --out figures --check")]
pub(crate) struct FiguresArgs {
    /// Folder for the figures; each lesson gets a folder in it
    #[arg(long, value_name = "DIR", default_value = "figures")]
    pub(crate) out: PathBuf,
    /// Write nothing; print which figures there differ from what is drawn now
    #[arg(long)]
    pub(crate) check: bool,
    /// Write nothing; print the name of each figure and its caption
    #[arg(long, conflicts_with_all = ["check", "out", "width", "grayscale", "titled", "standalone"])]
    pub(crate) list: bool,
    /// How they are drawn.
    #[command(flatten)]
    pub(crate) drawing: Drawing,
}

/// The preprocessor of mdBook.
#[derive(Debug, ClapArgs)]
#[command(after_help = "In book.toml:
  [preprocessor.raystep]
  lessons = \"lessons\"
  before = [\"links\"]

In a chapter:
  {{#raystep 12-grid/walk}}                      the figure
  {{#raystep-log 12-grid/walk only=cell}}        its worked solution
  {{#raystep-value 12-grid/walk cell.count}}     a number, in running prose
  {{#raystep-compare 12-grid/walk}}              what each strategy costs
  {{#raystep-code PATH:ITEM}}                    source, by the name of an item
  {{#raystep-run pixel SCENE X,Y}}               a command that only reads, and what it prints
  $a t^2$ and $$a t^2$$                          a formula")]
pub(crate) struct MdbookArgs {
    /// The question of mdBook before it runs; without it a book is read from standard input.
    #[command(subcommand)]
    pub(crate) verb: Option<MdbookVerb>,
}

/// What mdBook asks before.
#[derive(Debug, Subcommand)]
pub(crate) enum MdbookVerb {
    /// Does this preprocessor support a renderer? Exit code 0 means yes.
    Supports {
        /// Name of the renderer
        renderer: String,
    },
}
