//! What can be said on the command line.

mod figures;

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Args as ClapArgs, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use raystep::{
    Build, GridOptions, HeatOf, Kind, LightOptions, Lists, Region, SlabChoice, StrategyName,
    StructureOptions, Through, Transport, VolumeKind, nearest_name,
};

use crate::cli::Error;
pub(crate) use figures::{Drawing, FigureArgs, FiguresArgs, MdbookArgs, MdbookVerb, WidthName};

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
}

/// What can be done.
#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Print the worked solution of one pixel.
    Pixel(PixelArgs),
    /// Write every step as a log in JSON Lines.
    Trace(TraceArgs),
    /// Write the picture as PNG.
    Render(RenderArgs),
    /// Compare what the strategies cost on the same rays, or what the kinds of ray tracing bring.
    Compare(CompareArgs),
    /// Draw a figure of a lesson as SVG.
    Figure(FigureArgs),
    /// Draw all figures of the lessons, or check that those that are there are up to date.
    Figures(FiguresArgs),
    /// Rewrite a scene in NFF, OBJ or JSON, or the scene of a log, as JSON.
    Convert(ConvertArgs),
    /// Print the JSON Schema of scenes, lessons or logs.
    Schema(SchemaArgs),
    /// Print completions for a shell.
    Completions(CompletionsArgs),
    /// Follow the directives of an mdBook; mdBook calls this.
    Mdbook(MdbookArgs),
}

/// What may be read.
#[derive(Debug, Default, ClapArgs)]
pub(crate) struct Reading {
    /// Read mesh files that lie outside of the scene's folder
    #[arg(long)]
    pub(crate) allow_outside: bool,
}

/// How a scene is traced. A saved log has been traced, so none of these go with one, except the
/// statistics.
#[derive(Debug, Default, ClapArgs)]
#[command(next_help_heading = "Tracing")]
pub(crate) struct Tracing {
    /// Which objects each ray is tested against [default: exhaustive]
    #[arg(long, value_enum, value_name = "NAME")]
    pub(crate) strategy: Option<StrategyName>,
    /// Volume around each object, for bounds [default: box]
    #[arg(long, value_enum, value_name = "NAME")]
    pub(crate) volume: Option<VolumeKind>,
    /// Directions of slabs, for hierarchy, heap, and bounds with the volume slabs [default: axes]
    #[arg(long, value_enum, value_name = "NAME")]
    pub(crate) slabs: Option<SlabChoice>,
    /// How the tree is built, for hierarchy and heap [default: bottom-up]
    #[arg(long, value_enum, value_name = "NAME")]
    pub(crate) build: Option<Build>,
    /// Cells along x, y and z, for grid [default: by the density]
    #[arg(long, value_name = "NX,NY,NZ", value_parser = cells)]
    pub(crate) grid: Option<[u32; 3]>,
    /// Cells for each object, for grid [default: 3]
    #[arg(long, value_name = "D", value_parser = density, conflicts_with = "grid")]
    #[arg(allow_hyphen_values = true)]
    pub(crate) density: Option<f64>,
    /// By what objects are put into cells, for grid [default: objects]
    #[arg(long, value_enum, value_name = "NAME")]
    pub(crate) lists: Option<Lists>,
    /// Test an object in every cell that lists it, for grid
    #[arg(long)]
    pub(crate) no_mailboxes: bool,
    /// Record how the structure is built, for hierarchy, heap and grid
    #[arg(long)]
    pub(crate) building: bool,
    /// Which rays there are.
    #[command(flatten)]
    pub(crate) casting: Casting,
    /// Count rays and tests: as text on standard error, or as JSON on standard output
    #[arg(long, value_enum, value_name = "FORMAT", num_args = 0..=1, require_equals = true)]
    #[arg(default_missing_value = "text")]
    pub(crate) stats: Option<Format>,
}

impl Tracing {
    /// What was chosen about the structure.
    pub(crate) fn structure(&self) -> StructureOptions {
        let usual = StructureOptions::default();
        StructureOptions {
            volume: self.volume.unwrap_or(usual.volume),
            slabs: self.slabs.unwrap_or(usual.slabs),
            build: self.build.unwrap_or(usual.build),
            grid: GridOptions {
                resolution: self.grid,
                density: self.density.unwrap_or(usual.grid.density),
                lists: self.lists.unwrap_or(usual.grid.lists),
                mailboxes: !self.no_mailboxes,
            },
        }
    }
}

/// Which rays are cast.
#[derive(Clone, Debug, Default, ClapArgs)]
#[command(next_help_heading = "Tracing")]
pub(crate) struct Casting {
    /// Which rays are cast [default: hybrid-light]
    #[arg(long, value_enum, value_name = "NAME")]
    pub(crate) transport: Option<Transport>,
    /// Size of the picture, in place of the scene's
    #[arg(long, value_name = "W,H", value_parser = pixels)]
    pub(crate) pixels: Option<[u32; 2]>,
    /// Largest depth of a ray, in place of the scene's; eye rays have depth 1
    #[arg(long, value_name = "N")]
    pub(crate) max_depth: Option<u32>,
    /// Rays that one pixel may take; beyond it the command ends with an error [default: 1000000]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub(crate) max_rays: Option<u64>,
    /// Opaque objects show only their front
    #[arg(long)]
    pub(crate) one_sided: bool,
    /// Where the eye rays pass a pixel [default: centres]
    #[arg(long, value_enum, value_name = "WHERE")]
    pub(crate) through: Option<Through>,
    /// Where chance begins, for forward, hybrid-stored and hybrid-connected [default: 1]
    #[arg(long, value_name = "N")]
    pub(crate) seed: Option<u64>,
    /// Paths of light, for forward and hybrid-stored [default: 200000]
    #[arg(long, value_name = "N")]
    pub(crate) paths: Option<u64>,
    /// Paths from the eye for each pixel, and of light as many, for hybrid-connected [default: 4]
    #[arg(long, value_name = "N")]
    pub(crate) samples: Option<u32>,
    /// Surfaces that a path may meet, for forward, hybrid-stored and hybrid-connected [default: as many as
    /// chance leaves it]
    #[arg(long, value_name = "N")]
    pub(crate) bounces: Option<u32>,
    /// Radius of the eye's aperture, for forward [default: a twentieth of the way to the window]
    #[arg(long, value_name = "R", value_parser = radius, allow_hyphen_values = true)]
    pub(crate) aperture: Option<f64>,
    /// Photons that are gathered around a point, for hybrid-stored [default: 50]
    #[arg(long, value_name = "K")]
    pub(crate) nearest: Option<u32>,
    /// Store light on flat faces in maps with so many cells along the longer side, for hybrid-stored
    #[arg(long, value_name = "N")]
    pub(crate) map: Option<u32>,
}

impl Casting {
    /// What was chosen about how light is followed.
    pub(crate) fn light(&self) -> LightOptions {
        let usual = LightOptions::default();
        LightOptions {
            seed: self.seed.unwrap_or(usual.seed),
            paths: self.paths.unwrap_or(usual.paths),
            samples: self.samples.unwrap_or(usual.samples),
            bounces: self.bounces,
            aperture: self.aperture,
            nearest: self.nearest.unwrap_or(usual.nearest),
            map: self.map,
        }
    }
}

/// Text or JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For reading.
    Text,
    /// For programs.
    Json,
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
    /// Kinds of event to show
    #[arg(long, value_name = "KINDS", value_delimiter = ',', value_parser = kind)]
    pub(crate) only: Vec<Kind>,
    /// One ray alone, by its number
    #[arg(long, value_name = "N")]
    pub(crate) ray: Option<u32>,
    /// Every test, also where many in a row miss
    #[arg(long)]
    pub(crate) all: bool,
    /// How many events the pixel may have: all are kept in memory, 168 bytes each
    #[arg(long, value_name = "N", default_value_t = 2_000_000)]
    pub(crate) budget: u64,
    /// Text, or JSON with the tree of rays
    #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
    #[arg(value_name = "text|json")]
    pub(crate) format: Format,
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
    /// The log; - is standard output
    #[arg(short, long, value_name = "F.jsonl", default_value = "-")]
    pub(crate) output: PathBuf,
    /// Pixels to keep: X,Y or a rectangle with both its corners
    #[arg(long, value_name = "X0,Y0-X1,Y1")]
    pub(crate) region: Option<Region>,
    /// Kinds of event to keep
    #[arg(long, value_name = "KINDS", value_delimiter = ',', value_parser = kind)]
    pub(crate) only: Vec<Kind>,
    /// How many events may be written
    #[arg(long, value_name = "N", default_value_t = 10_000_000)]
    pub(crate) budget: u64,
    /// How many threads trace [default: all cores]
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
    /// The picture; - is standard output
    #[arg(short, long, value_name = "F.png")]
    pub(crate) output: PathBuf,
    /// Show what each pixel cost, from dark blue to yellow; a legend stands below, and a small picture is
    /// enlarged to its width
    #[arg(long, value_enum, value_name = "WHAT")]
    pub(crate) heatmap: Option<HeatOf>,
    /// How many threads trace [default: all cores]
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
    /// The rays of one pixel alone: column and row, counted from 0,0 at the top left
    #[arg(value_name = "X,Y", value_parser = pixel)]
    pub(crate) pixel: Option<[u64; 2]>,
    /// Compare the five kinds of ray tracing instead: rays cast, rays that contributed, and the error of the
    /// light
    #[arg(long, conflicts_with_all = ["pixel", "chart", "transport", "through"])]
    pub(crate) transports: bool,
    /// Text, JSON with all counts, or CSV
    #[arg(long, value_enum, default_value = "text", hide_possible_values = true)]
    #[arg(value_name = "text|json|csv")]
    pub(crate) format: TableFormat,
    /// Draw the tests as bars on a logarithmic axis
    #[arg(long, value_name = "F.svg")]
    pub(crate) chart: Option<PathBuf>,
    /// How many threads trace [default: all cores]
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

/// No number of this command is negative, and `-1,2` would look like an option: it is refused before
/// the options are read.
pub(crate) fn refuse_negative(arguments: &[OsString]) -> Result<(), Error> {
    let words = arguments.iter().map(|word| word.to_string_lossy());
    let pairs = words.clone().zip(words.skip(1));
    for (before, word) in pairs.take_while(|(_, word)| word != "--") {
        // also as --ray=-1
        let (option, value) = match word.split_once('=') {
            Some((option, value)) if option.starts_with("--") => (option, value),
            _ => (&*before, &*word),
        };
        let digits = value.strip_prefix('-').unwrap_or_default();
        let is_negative = digits.starts_with(|c: char| c.is_ascii_digit() || c == '.');
        // these have a message of their own for all that is none
        if is_negative && !["--density", "--aperture"].contains(&option) {
            let argument = word.into_owned();
            return Err(Error::Negative { argument });
        }
    }
    Ok(())
}

/// `X,Y`; whether the picture has such a pixel is asked later.
fn pixel(text: &str) -> Result<[u64; 2], String> {
    pair(text).ok_or_else(|| "give column and row, as in 80,60".into())
}

/// `W,H`.
fn pixels(text: &str) -> Result<[u32; 2], String> {
    pair(text).ok_or_else(|| "give width and height, as in 160,120".into())
}

/// `NX,NY,NZ`.
fn cells(text: &str) -> Result<[u32; 3], String> {
    let numbers: Vec<u32> = text
        .split(',')
        .map_while(|number| number.trim().parse().ok())
        .collect();
    match (numbers.try_into(), text.matches(',').count()) {
        (Ok(cells), 2) => Ok(cells),
        _ => Err("give the cells along x, y and z, as in 46,46,3".into()),
    }
}

/// Cells for each object.
fn density(text: &str) -> Result<f64, String> {
    match text.trim().parse() {
        Ok(density) if 0.0 < density && density < f64::INFINITY => Ok(density),
        _ => Err("give a number of cells for each object above 0, such as 3".into()),
    }
}

/// A radius that may be 0.
fn radius(text: &str) -> Result<f64, String> {
    match text.trim().parse() {
        Ok(radius) if (0.0..f64::INFINITY).contains(&radius) => Ok(radius),
        _ => Err("give a radius of 0 or more, such as 0.05".into()),
    }
}

fn pair<T: std::str::FromStr>(text: &str) -> Option<[T; 2]> {
    let (first, second) = text.split_once(',')?;
    Some([first.trim().parse().ok()?, second.trim().parse().ok()?])
}

/// A kind of event, by its name in the log.
fn kind(name: &str) -> Result<Kind, String> {
    Kind::named(name).ok_or_else(|| {
        let names = Kind::ALL.map(Kind::name);
        match nearest_name(name, names.into_iter()) {
            Some(near) => format!("there is no such kind; did you mean {near}?"),
            None => format!("there is no such kind; the kinds are {}", names.join(", ")),
        }
    })
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
    fn negative_numbers_are_told_from_options_and_files() {
        let refused = |words: &[&str]| {
            let words: Vec<OsString> = words.iter().map(OsString::from).collect();
            refuse_negative(&words).is_err()
        };
        for words in [
            ["raystep", "-1,2"],
            ["raystep", "--ray=-1"],
            ["raystep", "-.5"],
            ["--ray", "-1"],
        ] {
            assert!(refused(&words), "{words:?}");
        }
        for words in [
            ["raystep", "-"],
            ["raystep", "--ray=1"],
            ["raystep", "-o"],
            ["raystep", "--density=-1"],
            ["--density", "-1"],
        ] {
            assert!(!refused(&words), "{words:?}");
        }
        assert!(!refused(&["raystep", "--", "-1.json"]));
    }
}
