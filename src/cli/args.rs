//! What can be said on the command line.

mod figures;

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Args as ClapArgs, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use raystep::scene::nearest_name;
use raystep::structure::{Build, GridOptions, Lists, SlabChoice, VolumeKind};
use raystep::trace::{Kind, LightOptions, Region};
use raystep::tracer::HeatOf;
use raystep::{StrategyName, StructureOptions, Through, Transport};

use crate::cli::Error;
use crate::cli::word::one_of;
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

/// When the output has colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Colours {
    /// In a terminal, unless the environment says otherwise (`NO_COLOR`, `CLICOLOR`, `CLICOLOR_FORCE`).
    #[default]
    Auto,
    /// Everywhere.
    Always,
    /// Nowhere.
    Never,
}

impl From<Colours> for anstream::ColorChoice {
    fn from(colours: Colours) -> Self {
        match colours {
            Colours::Auto => Self::Auto,
            Colours::Always => Self::Always,
            Colours::Never => Self::Never,
        }
    }
}

impl From<Colours> for clap::ColorChoice {
    fn from(colours: Colours) -> Self {
        match colours {
            Colours::Auto => Self::Auto,
            Colours::Always => Self::Always,
            Colours::Never => Self::Never,
        }
    }
}

impl Colours {
    /// What the arguments say before they are parsed: help and usage errors have colours too. The last word counts;
    /// `Auto` if there is none, or if it is wrong: the error is reported later.
    pub(crate) fn of(arguments: &[OsString]) -> Self {
        let words = arguments.iter().map(|word| word.to_string_lossy());
        let options: Vec<_> = words.take_while(|word| word != "--").collect();
        let places = options.iter().enumerate();
        let mut values = places.filter_map(|(i, word)| match word.split_once('=') {
            Some(("--color", value)) => Some(value),
            None if word == "--color" => options.get(i + 1).map(|next| &**next),
            _ => None,
        });
        let known = values
            .next_back()
            .and_then(|value| Self::from_str(value, false).ok());
        known.unwrap_or_default()
    }
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
    /// Compare the cost of the strategies on the same rays, or the five kinds of ray tracing.
    Compare(CompareArgs),
    /// Draw a figure of a lesson as SVG.
    Figure(FigureArgs),
    /// Draw all figures of the lessons, or check that existing ones are up to date.
    Figures(FiguresArgs),
    /// Write a scene in NFF, OBJ or JSON, or the scene of a log, as JSON.
    Convert(ConvertArgs),
    /// Print the JSON Schema of scenes, lessons or logs.
    Schema(SchemaArgs),
    /// Print completions for a shell.
    Completions(CompletionsArgs),
    /// Expand the directives in an mdBook; mdBook calls this.
    Mdbook(MdbookArgs),
}

/// What may be read.
#[derive(Debug, Default, ClapArgs)]
pub(crate) struct Reading {
    /// Allow mesh files outside the scene's folder
    #[arg(long)]
    pub(crate) allow_outside: bool,
}

/// How a scene is traced. A saved log has been traced, so none of these go with one, except the
/// statistics.
#[derive(Debug, Default, ClapArgs)]
#[command(next_help_heading = "Strategy")]
pub(crate) struct Tracing {
    /// Which objects each ray is tested against [default: to render hierarchy, or exhaustive for a heat map; for a
    /// pixel or a log exhaustive, or hierarchy with more than 1000 objects]
    #[arg(long, value_parser = one_of::<StrategyName>(), value_name = "NAME")]
    pub(crate) strategy: Option<StrategyName>,
    /// How the tree is built, for hierarchy and heap [default: bottom-up]
    #[arg(long, value_parser = one_of::<Build>(), value_name = "NAME")]
    pub(crate) build: Option<Build>,
    /// Volume around each object, for bounds [default: box]
    #[arg(long, value_parser = one_of::<VolumeKind>(), value_name = "NAME")]
    pub(crate) volume: Option<VolumeKind>,
    /// Directions of slabs, for hierarchy, heap, and bounds with the volume slabs [default: axes]
    #[arg(long, value_parser = one_of::<SlabChoice>(), value_name = "NAME")]
    pub(crate) slabs: Option<SlabChoice>,
    /// Cells along x, y and z, for grid [default: by the density]
    #[arg(long, value_name = "NX,NY,NZ", value_parser = cells)]
    pub(crate) grid: Option<[u32; 3]>,
    /// Cells for each object, for grid [default: 3]
    #[arg(long, value_name = "D", value_parser = density, conflicts_with = "grid")]
    #[arg(allow_hyphen_values = true)]
    pub(crate) density: Option<f64>,
    /// How objects are assigned to cells, for grid: by their shape or by their box [default: objects]
    #[arg(long, value_parser = one_of::<Lists>(), value_name = "NAME")]
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
    #[arg(help_heading = None::<&str>)]
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
#[command(next_help_heading = "Rays")]
pub(crate) struct Casting {
    /// Which rays are cast [default: hybrid-light]
    #[arg(long, value_parser = one_of::<Transport>(), value_name = "NAME")]
    pub(crate) transport: Option<Transport>,
    /// Size of the picture; replaces the scene's
    #[arg(long, value_name = "W,H", value_parser = pixels)]
    pub(crate) pixels: Option<[u32; 2]>,
    /// Largest depth of a ray; replaces the scene's; eye rays have depth 1
    #[arg(long, value_name = "N")]
    pub(crate) max_depth: Option<u32>,
    /// The most rays of one pixel; with more the command ends with an error [default: 1000000]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub(crate) max_rays: Option<u64>,
    /// Opaque objects are visible only from the front
    #[arg(long)]
    pub(crate) one_sided: bool,
    /// Where the eye rays pass a pixel [default: centres]
    #[arg(long, value_parser = one_of::<Through>(), value_name = "WHERE")]
    pub(crate) through: Option<Through>,
    /// Seed of the random numbers, for forward, hybrid-stored and hybrid-connected [default: 1]
    #[arg(help_heading = "Light")]
    #[arg(long, value_name = "N")]
    pub(crate) seed: Option<u64>,
    /// Paths of light, for forward and hybrid-stored [default: 200000]
    #[arg(help_heading = "Light")]
    #[arg(long, value_name = "N")]
    pub(crate) paths: Option<u64>,
    /// Paths from the eye for each pixel, and the same number from the lights, for hybrid-connected [default: 4]
    #[arg(help_heading = "Light")]
    #[arg(long, value_name = "N")]
    pub(crate) samples: Option<u32>,
    /// The most surfaces that a path may hit, for forward, hybrid-stored and hybrid-connected [default: unlimited,
    /// Russian roulette ends a path]
    #[arg(help_heading = "Light")]
    #[arg(long, value_name = "N")]
    pub(crate) bounces: Option<u32>,
    /// Radius of the eye's aperture, for forward [default: 1/20 of the distance to the window]
    #[arg(help_heading = "Light")]
    #[arg(long, value_name = "R", value_parser = radius, allow_hyphen_values = true)]
    pub(crate) aperture: Option<f64>,
    /// How many of the nearest photons are gathered around a point, for hybrid-stored [default: 50]
    #[arg(help_heading = "Light")]
    #[arg(long, value_name = "K")]
    pub(crate) nearest: Option<u32>,
    /// Store light on flat faces in maps with this number of cells along the longer side, for hybrid-stored
    #[arg(help_heading = "Light")]
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

    #[test]
    fn the_last_choice_of_colours_counts_before_the_arguments_are_parsed() {
        let colours = |words: &[&str]| {
            let words: Vec<OsString> = words.iter().map(OsString::from).collect();
            Colours::of(&words)
        };
        assert_eq!(colours(&["raystep", "pixel"]), Colours::Auto);
        assert_eq!(colours(&["--color", "never"]), Colours::Never);
        assert_eq!(colours(&["--color=always"]), Colours::Always);
        assert_eq!(
            colours(&["--color=always", "--color", "never"]),
            Colours::Never
        );
        assert_eq!(colours(&["--color", "blue"]), Colours::Auto);
        assert_eq!(colours(&["--color"]), Colours::Auto);
        assert_eq!(colours(&["--", "--color=always"]), Colours::Auto);
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
