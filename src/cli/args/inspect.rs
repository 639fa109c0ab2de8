//! The options of the page of a picture.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use raystep::step::Address;
use raystep::trace::Region;

use crate::cli::args::values::pixel;
use crate::cli::args::{Reading, Tracing};

/// A page of a picture and its pixels.
#[derive(Debug, ClapArgs)]
#[command(after_help = "Examples:
  raystep inspect scene.json 80,60 -o page.html
  raystep inspect scene.json --region 78,58-82,62 -o page.html --strategy grid --predict
  raystep inspect part.jsonl 80,60 -o page.html --at 37

The page is one file and asks for nothing else: open it in a browser, or mail it. Its key ? lists all keys.")]
pub(crate) struct InspectArgs {
    /// Scene (.json, .nff, .obj) or log; - is standard input
    pub(crate) scene: PathBuf,
    /// The pixel whose steps the page holds: column and row, counted from 0,0 at the top left [default: all pixels]
    #[arg(value_name = "X,Y", value_parser = pixel)]
    pub(crate) pixel: Option<[u64; 2]>,
    /// File of the page; - is standard output
    #[arg(short, long, value_name = "F.html")]
    pub(crate) output: PathBuf,
    /// The pixels whose steps the page holds: a rectangle by its top left and its bottom right pixel
    #[arg(long, value_name = "X0,Y0-X1,Y1", conflicts_with = "pixel")]
    pub(crate) region: Option<Region>,
    /// Begin at a step by its number in the log: 37, or #path17:37 on a path of light
    #[arg(long, value_name = "STEP")]
    pub(crate) at: Option<Address>,
    /// Ask a question before a verdict is shown
    #[arg(long)]
    pub(crate) predict: bool,
    /// Omit the picture and the heat map: every pixel is traced for them
    #[arg(long)]
    pub(crate) no_picture: bool,
    /// The most events of a pixel: all are kept in memory, 168 bytes each
    #[arg(long, value_name = "N", default_value_t = 2_000_000)]
    pub(crate) budget: u64,
    /// The most megabytes of the page
    #[arg(long, value_name = "N", default_value_t = 8, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub(crate) megabytes: u32,
    /// What may be read.
    #[command(flatten)]
    pub(crate) reading: Reading,
    /// How it is traced.
    #[command(flatten)]
    pub(crate) tracing: Tracing,
}
