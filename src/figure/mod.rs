//! From events to drawings: the figures of a lecture, each from a trace alone.
//!
//! A [`FigureSpec`] says what is drawn; [`draw`] makes it from [`Traced`], which is a log in memory. A kind of figure
//! draws marks and words on a sheet; labels are placed at the end, and `canvas` writes the SVG.

mod angle;
mod axes;
mod bound;
mod buckets;
mod canvas;
mod cost_chart;
mod disc;
mod drawing;
mod error;
mod font;
mod frame;
mod gathering;
mod hatch;
mod heat_map;
mod kinds;
mod labels;
mod light_path;
mod look;
mod outline;
mod parabola;
mod picture;
mod scale_bar;
mod scenery;
mod sheet;
mod slab_rows;
mod spec;
mod traced;
mod tree;
mod turn;
mod view;
mod visits;
mod volume_outline;

pub use canvas::Rendition;
pub use cost_chart::cost_chart;
pub use drawing::{Drawn, draw};
pub use error::FigureError;
pub use font::text_width;
pub use heat_map::{Raster, heat_map};
pub use sheet::Width;
pub use spec::{DroppedAxis, FigureKind, FigureSpec, Layer};
pub use traced::{OF_EVERY_PIXEL, Traced};
pub use view::View;
